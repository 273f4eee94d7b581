"""What the rows of a result are called: ids, lengths and ends, as coordinates of the dataset."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from moorage.model import Model
from moorage.system.build import Names

XYZ = ("x", "y", "z")
DOF = ("surge", "sway", "heave", "roll", "pitch", "yaw")


@dataclass(frozen=True)
class Index:
    """Labels of lines, points, nodes and segments, in the order of the file.

    Attributes
    ----------
    line, point : (lines,), (points,) int
        Ids.
    end_a, end_b : (lines,) int
        Id of the point at each end of a line.
    point_kind : (points,) str
        "fixed", "coupled" or "free".
    node_line, arc_length : (nodes,)
        Line id, and unstretched length from end A, m.
    segment_line, segment_arc_length, unstretched_length : (segments,)
        Line id, unstretched length from end A to the middle, and of the segment, m.
    """

    line: np.ndarray
    point: np.ndarray
    end_a: np.ndarray
    end_b: np.ndarray
    point_kind: np.ndarray
    node_line: np.ndarray
    arc_length: np.ndarray
    segment_line: np.ndarray
    segment_arc_length: np.ndarray
    unstretched_length: np.ndarray

    @property
    def sizes(self) -> dict[str, int]:
        """Length of every dimension but time."""
        return {
            "line": len(self.line),
            "point": len(self.point),
            "node": len(self.node_line),
            "segment": len(self.segment_line),
            "xyz": len(XYZ),
        }

    def coordinates(self) -> dict[str, np.ndarray]:
        """Return the values of every coordinate but time, by name."""
        return {**vars(self), "xyz": np.array(XYZ, dtype=object)}


def make_index(model: Model, names: Names) -> Index:
    """Label the arrays of a built model."""
    starts = np.delete(names.arc_length, names.node_ptr[1:] - 1)  # a segment begins at every node but the last
    return Index(
        line=names.lines,
        point=names.points,
        end_a=np.array([line.end_a.id for line in model.lines], dtype=np.int64),
        end_b=np.array([line.end_b.id for line in model.lines], dtype=np.int64),
        point_kind=np.array([point.kind for point in model.points], dtype=object),
        node_line=np.repeat(names.lines, np.diff(names.node_ptr)),
        arc_length=names.arc_length,
        segment_line=np.repeat(names.lines, np.diff(names.segment_ptr)),
        segment_arc_length=starts + 0.5 * names.segment_length,
        unstretched_length=names.segment_length,
    )
