"""Bending parameters of a model: hinges at nodes, clamps and springs at line ends, joints between lines."""

from __future__ import annotations

import numpy as np

from moorage.layout import Joints
from moorage.model import Curve, Model
from moorage.physics.bending import EXACT, PAPER, PINNED, RIGID, Bending
from moorage.physics.table import build_tables
from moorage.system.holders import Holders


def build_bending(model: Model, holders: Holders, segments, node_ptr, first_direction: int):
    """Return `Bending`, `Joints`, the clamps' directions, (3,) or (n, 3) each, as tracks from `first_direction` on.

    And of the clamps on objects: the objects (lines, 2), and the directions (lines, 2, 3) in their axes.
    segments: the table of `segment_table`.
    """
    n_nodes, n_lines = int(node_ptr[-1]), len(node_ptr) - 1
    of_clamp, toward = np.full((n_lines, 2), -1, dtype=np.int64), np.zeros((n_lines, 2, 3))
    stiffness = 2.0 * segments["bending_stiffness"] / segments["length"]
    before, after = np.zeros(n_nodes), np.zeros(n_nodes)
    table = np.full(n_nodes, -1, dtype=np.int64)
    rule = np.full((n_lines, 2), PINNED, dtype=np.int64)
    direction = np.full((n_lines, 2), -1, dtype=np.int64)
    law = EXACT if model.flavour == "native" else PAPER
    curves: list[Curve] = []
    clamps: list[np.ndarray] = []
    meeting: dict[int, list[tuple[int, int]]] = {}

    def tabulate(j0, j1):
        """Number of the table of moment against 2 sin(a / 2) of two half segments, -1 if both are constant."""
        curve = series(segments[j0], segments[j1])
        if curve is None:
            return -1
        curves.append(curve)
        return len(curves) - 1

    for k, line in enumerate(model.lines):
        first, last = int(node_ptr[k]), int(node_ptr[k + 1]) - 1
        j = first - k
        before[first + 1 : last] = stiffness[j : j + last - first - 1]
        after[first + 1 : last] = stiffness[j + 1 : j + last - first]
        for i in range(first + 1, last):
            table[i] = tabulate(i - 1 - k, i - k)
        for end, (node, jj, hold) in enumerate(((first, first - k, line.end_a), (last, last - 1 - k, line.end_b))):
            if stiffness[jj] <= 0.0 or hold.kind != "rod":
                continue
            holder = holders.number[hold]
            spring = line.end_a_stiffness if end == 0 else line.end_b_stiffness
            if spring == 0.0:
                continue
            if holder in holders.joints:
                meeting.setdefault(holder, []).append((k, end))
                continue
            if not (hold in holders.directions or hold in holders.turning):
                continue
            rule[k, end] = law
            before[node], after[node] = stiffness[jj], RIGID if spring is None else spring
            table[node] = tabulate(jj, jj) if spring is None else -1
            if hold in holders.turning:
                of_clamp[k, end], toward[k, end] = holders.turning[hold]
                continue
            direction[k, end] = first_direction + len(clamps)
            clamps.append(holders.directions[hold])
    pairs = [both for both in meeting.values() if len(both) == 2]
    ends = np.array(pairs, dtype=np.int64).reshape(-1, 2, 2)
    segment_of = np.where(ends[:, :, 1] == 0, node_ptr[ends[:, :, 0]], node_ptr[ends[:, :, 0] + 1] - 2) - ends[:, :, 0]
    joints = Joints(
        ends[:, :, 0],
        ends[:, :, 1],
        stiffness[segment_of].reshape(-1, 2),
        np.full(len(pairs), law, dtype=np.int64),
        np.array([tabulate(a, b) for a, b in segment_of], dtype=np.int64),
    )
    return Bending(before, after, table, rule, direction, build_tables(curves)), joints, clamps, of_clamp, toward


def series(one, two) -> Curve | None:
    """Moment against 2 sin(a / 2) of two half segments in series: their angles at each moment add up."""
    kinds = one["bending_curve"], two["bending_curve"]
    if not any(isinstance(kind, Curve) for kind in kinds):
        return None
    moments = np.unique(np.concatenate([np.abs(kind.y) for kind in kinds if isinstance(kind, Curve)]))
    angle = np.zeros(len(moments))
    for segment, kind in zip((one, two), kinds, strict=True):
        if isinstance(kind, Curve):
            curvature = np.interp(moments, kind.y, kind.x)
            over = moments > kind.y[-1]  # beyond its last row a table goes on with its last slope
            slope = (kind.x[-1] - kind.x[-2]) / (kind.y[-1] - kind.y[-2])
            curvature[over] = kind.x[-1] + slope * (moments[over] - kind.y[-1])
        elif segment["bending_stiffness"] > 0.0:
            curvature = moments / segment["bending_stiffness"]
        else:
            return None
        angle += 0.5 * segment["length"] * curvature
    return Curve(tuple(angle), tuple(moments))
