"""What the rows of a result are called: ids, lengths and ends, as coordinates of the dataset."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from moorage.model import Attachment, Model
from moorage.system.build import Names
from moorage.system.segments import segment_table

XYZ = ("x", "y", "z")
DOF = ("surge", "sway", "heave", "roll", "pitch", "yaw")


@dataclass(frozen=True)
class Index:
    """Labels of lines, points, nodes and segments, in the order of the file.

    Attributes
    ----------
    line, point : (lines,), (points,) int
        Ids.
    line_name, point_name : (lines,), (points,) str
        Names, empty where there are none.
    end_a, end_b : (lines,) int
        Id of the point or rod at each end of a line.
    end_a_kind, end_b_kind : (lines,) str
        What that is: "fixed point", "coupled rod", ...
    point_kind : (points,) str
        "fixed", "coupled" or "free"; of a point on a body, that of the body.
    node_line, arc_length, allowed_bend_radius : (nodes,)
        Line id, unstretched length from end A, m, and the largest of the radii that the line types beside allow, m.
    segment_line, segment_arc_length, unstretched_length : (segments,)
        Line id, unstretched length from end A to the middle, and of the segment, m.
    outer_diameter, bending_stiffness : (segments,)
        With modules and stiffeners, m and N m2.
    breaking_load : (segments,)
        Of the line type, N; 0 where it does not say.
    """

    line: np.ndarray
    point: np.ndarray
    line_name: np.ndarray
    point_name: np.ndarray
    end_a: np.ndarray
    end_b: np.ndarray
    end_a_kind: np.ndarray
    end_b_kind: np.ndarray
    point_kind: np.ndarray
    node_line: np.ndarray
    arc_length: np.ndarray
    allowed_bend_radius: np.ndarray
    segment_line: np.ndarray
    segment_arc_length: np.ndarray
    unstretched_length: np.ndarray
    outer_diameter: np.ndarray
    bending_stiffness: np.ndarray
    breaking_load: np.ndarray

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
        """Return the values of every coordinate but time, by name; breaking loads only where a type gives one."""
        known = {**vars(self), "xyz": np.array(XYZ, dtype=object)}
        return known if self.breaking_load.any() else {n: v for n, v in known.items() if n != "breaking_load"}


def make_index(model: Model, names: Names) -> Index:
    """Label the arrays of a built model."""
    starts = np.delete(names.arc_length, names.node_ptr[1:] - 1)  # a segment begins at every node but the last
    holders, segments = _holders(model), segment_table(model)[: names.segment_ptr[-1]]
    sections = [section for line in model.lines for section in line.sections]
    allowed = [model.line_type(section.line_type).minimum_bend_radius or 0.0 for section in sections]
    strength = [model.line_type(section.line_type).minimum_breaking_load or 0.0 for section in sections]
    return Index(
        line=names.lines,
        point=names.points,
        line_name=np.array([line.name for line in model.lines], dtype=object),
        point_name=np.array([point.name for point in model.points], dtype=object),
        end_a=np.array([line.end_a.id for line in model.lines], dtype=np.int64),
        end_b=np.array([line.end_b.id for line in model.lines], dtype=np.int64),
        end_a_kind=np.array([_holder(line.end_a, holders) for line in model.lines], dtype=object),
        end_b_kind=np.array([_holder(line.end_b, holders) for line in model.lines], dtype=object),
        point_kind=np.array([holders["point", point.id] for point in model.points], dtype=object),
        node_line=np.repeat(names.lines, np.diff(names.node_ptr)),
        arc_length=names.arc_length,
        allowed_bend_radius=_at_nodes(np.repeat(allowed, [section.segments for section in sections]), names),
        segment_line=np.repeat(names.lines, np.diff(names.segment_ptr)),
        segment_arc_length=starts + 0.5 * names.segment_length,
        unstretched_length=names.segment_length,
        outer_diameter=np.ascontiguousarray(segments["diameter"]),
        bending_stiffness=np.ascontiguousarray(segments["bending_stiffness"]),
        breaking_load=np.repeat(strength, [section.segments for section in sections]),
    )


def _holders(model: Model) -> dict[tuple[str, int], str]:
    """Return the kind of every point and rod, by what it is and its id; on a body, that of the body."""
    bodies = {body.id: body.kind for body in model.bodies}
    things = [("point", point) for point in model.points] + [("rod", rod) for rod in model.rods]  # type: ignore[misc]
    return {(what, thing.id): thing.kind if thing.body is None else bodies[thing.body] for what, thing in things}


def _holder(tie: Attachment, holders: dict[tuple[str, int], str]) -> str:
    return f"{holders[tie.kind, tie.id]} {tie.kind}"


def _at_nodes(values: np.ndarray, names: Names) -> np.ndarray:
    """Return the larger of the values (segments,) beside every node, (nodes,)."""
    out = np.zeros(len(names.arc_length))
    after = np.delete(np.arange(len(out)), names.node_ptr[1:] - 1)
    np.maximum.at(out, after, values)
    np.maximum.at(out, after + 1, values)
    return out
