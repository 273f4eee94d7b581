"""The columns that a model with cables has beside the others: bending, inclination and touchdown.

The *curvature* of a line with bending stiffness is the engine's: 2 sin(a / 2) over the mean length of the two segments
that meet with the angle a; at a clamped end, the moment over EI of the segment there. Lines without bending stiffness
have the same from their shape, and 0 at their ends.

The *declination* is the angle between the upward vertical and the tangent that points from end A to end B: 0 for a line
that goes up, pi / 2 for a level one, pi for one that goes down. The tangent at a node lies between those of its
segments, of second order on uneven ones too; at the ends it goes on as between the two segments there.

Verified by tests/unit/test_cable_results.py.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from moorage.model import Model
from moorage.solve.blocks import Block
from moorage.system.build import Built

MOMENTS = ("fairlead_moment", "anchor_moment")
HISTORIES = (
    "curvature",
    "bending_moment",
    "node_declination",
    "minimum_bend_radius",
    "seabed_gap",
    "touchdown_position",
    "touchdown_arc_length",
)
COORDINATES = ("outer_diameter", "bending_stiffness", "allowed_bend_radius")
UTILISATION, ALLOWED = "bend_utilisation", "allowed_bend_radius"  # only where a line type has an allowed radius
TOUCH = 1e-6  # m; a node that just touches counts as on the bed, as for the grounded length


@dataclass(frozen=True)
class Bending:
    """What the columns need beside the records.

    Attributes
    ----------
    node_ptr : (lines + 1,) int
    length, arc_length : (segments,), (nodes,)
        Unstretched, m.
    allowed : (nodes,)
        Allowed bend radius, m.
    stiff : (lines,) bool
        Whether a line has bending stiffness.
    """

    node_ptr: np.ndarray
    length: np.ndarray
    arc_length: np.ndarray
    allowed: np.ndarray
    stiff: np.ndarray

    @property
    def histories(self) -> tuple[str, ...]:
        """Names of the columns that go with histories of nodes."""
        return HISTORIES + ((UTILISATION,) if self.allowed.any() else ())

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of the coordinates that go with them."""
        return tuple(name for name in COORDINATES if name != ALLOWED or self.allowed.any())

    def columns(self, block: Block) -> dict[str, np.ndarray]:
        """Return the columns of a block, by name."""
        moments = {"fairlead_moment": block["end_moment"][:, :, 1], "anchor_moment": block["end_moment"][:, :, 0]}
        return moments | (self._histories(block) if "curvature" in block else {})

    def _histories(self, block: Block) -> dict[str, np.ndarray]:
        position, gap, curvature = block["node_position"], block["seabed_gap"], block["curvature"].copy()
        declination = np.empty_like(curvature)
        spot, arc = np.empty((len(position), len(self.stiff), 3)), np.empty((len(position), len(self.stiff)))
        for k, stiff in enumerate(self.stiff):
            nodes = slice(self.node_ptr[k], self.node_ptr[k + 1])
            length = self.length[nodes.start - k : nodes.stop - k - 1]
            tangents = segment_tangents(position[:, nodes])
            declination[:, nodes] = declinations(tangents, length)
            spot[:, k], arc[:, k] = touchdown(position[:, nodes], gap[:, nodes], self.arc_length[nodes])
            if not stiff:
                curvature[:, nodes.start + 1 : nodes.stop - 1] = curvatures(tangents, length)
        with np.errstate(divide="ignore"):
            radius = 1.0 / np.maximum.reduceat(curvature, self.node_ptr[:-1], axis=1)
        return {
            "curvature": curvature,
            "node_declination": declination,
            "minimum_bend_radius": radius,
            "touchdown_position": spot,
            "touchdown_arc_length": arc,
            UTILISATION: np.maximum.reduceat(curvature * self.allowed, self.node_ptr[:-1], axis=1),
        }


def bending_of(model: Model, built: Built, allowed: np.ndarray) -> Bending | None:
    """Return what the columns of cables need; None for a model without, unless it asks for MoorDyn's letter K."""
    stiff = built.system.lines.bends[: len(built.names.lines)]
    if not stiff.any() and not any("K" in line.outputs for line in model.lines):
        return None
    names = built.names
    return Bending(names.node_ptr, names.segment_length, names.arc_length, allowed, stiff)


def segment_tangents(position: np.ndarray) -> np.ndarray:
    """Return unit vectors (m, n - 1, 3) along the segments between nodes (m, n, 3).

    Nodes that are still in a winch stand at one end of the line; segments there go on as the last one that is out.
    """
    e = np.diff(position, axis=1)
    size = np.sqrt((e**2).sum(axis=-1, keepdims=True))
    if not size.all():
        out, place = size[..., 0] > 0.0, np.arange(e.shape[1])
        nearest = np.clip(place, out.argmax(axis=1)[:, None], e.shape[1] - 1 - out[:, ::-1].argmax(axis=1)[:, None])
        e, size = (np.take_along_axis(values, nearest[..., None], axis=1) for values in (e, size))
    return e / np.maximum(size, 1e-300)


def curvatures(tangents: np.ndarray, length: np.ndarray) -> np.ndarray:
    """Return 2 sin(a / 2) over the mean length at inner nodes, (m, n - 2), 1/m."""
    return np.sqrt((np.diff(tangents, axis=1) ** 2).sum(axis=-1)) / (0.5 * (length[1:] + length[:-1]))


def declinations(tangents: np.ndarray, length: np.ndarray) -> np.ndarray:
    """Return the angles (m, n), rad, of the line with the upward vertical at its nodes, from those of its segments."""
    before, after = tangents[:, [0, *range(len(length))]], tangents[:, [*range(len(length)), -1]]
    if len(length) > 1:  # at the ends: beyond the middle of the last segment by half its length
        first, last = length[0] / (length[0] + length[1]), length[-1] / (length[-1] + length[-2])
        before[:, 0] = tangents[:, 0] + 2.0 * first * (tangents[:, 0] - tangents[:, 1])
        after[:, -1] = tangents[:, -1] + 2.0 * last * (tangents[:, -1] - tangents[:, -2])
    l0, l1 = length[[0, *range(len(length))]], length[[*range(len(length)), -1]]
    x, y, z = np.moveaxis(before * l1[:, None] + after * l0[:, None], -1, 0)
    return np.arctan2(np.hypot(x, y), z)


def touchdown(position: np.ndarray, gap: np.ndarray, arc: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return where a line first meets the bed on the way from the end that is higher over it: (m, 3), (m,), m.

    Between the node on the bed and the one above it the line is taken as straight. NaN when it does not reach the bed,
    or when that end lies on it.

    Parameters
    ----------
    position, gap : (m, n, 3), (m, n)
        Of the nodes, and their height over the bed, m.
    arc : (n,)
        Arc length of the nodes, m.
    """
    last = len(arc) - 1
    from_b = gap[:, -1] >= gap[:, 0]  # on a slope the anchor may stand higher than what hangs
    on_bed = gap <= TOUCH
    steps = np.where(from_b[:, None], on_bed[:, ::-1], on_bed).argmax(axis=1)  # to the first node on the bed
    found = steps > 0
    node = np.where(from_b, last - steps, steps)
    above = np.where(found, node + np.where(from_b, 1, -1), node)
    row = np.arange(len(gap))
    rise = np.where(found, gap[row, above] - gap[row, node], 1.0)
    s = np.clip(-gap[row, node] / rise, 0.0, 1.0)
    spot = position[row, node] + s[:, None] * (position[row, above] - position[row, node])
    along = arc[node] + s * (arc[above] - arc[node])
    return np.where(found[:, None], spot, np.nan), np.where(found, along, np.nan)
