"""The first shape of every line: limp, elastic, between its ends; a straight line where there is none."""

from __future__ import annotations

import numpy as np

from moorage.layout import State, System
from moorage.model import Model
from moorage.physics.catenary import catenary
from moorage.physics.hanging import hanging
from moorage.physics.motion import sample_track

TOUCHES = 1e-5  # relative depth at which an end counts as on the seabed
HALVINGS = 40  # to place a node within a billionth of a segment


def place_guess(model: Model, system: System, state: State, length, weight) -> None:
    """Set positions of all rows: points at time 0, lines on catenaries; everything at rest.

    Bending is left out; Newton's method does the rest. `length` (m) and `weight` (N/m) are those of the segments.
    """
    rows = system.lines.node_ptr
    now = np.zeros((1, 9))
    for k in range(len(system.points.mass)):
        sample_track(system.tracks, k, np.zeros(1), now[:, 0:3], now[:, 3:6], now[:, 6:9])
        state.position[rows[-1] + k] = now[0, :3]
    for k in range(len(model.lines)):
        a, b = (state.position[rows[-1] + end] for end in system.lines.end_point[k])
        part = slice(rows[k] - k, rows[k + 1] - k - 1)
        nodes = line_guess(a, b, length[part], system.tension.spring[part] * length[part], weight[part], model)
        state.position[rows[k] : rows[k + 1]] = nodes
        laid = model.environment.friction is not None and model.environment.friction.laid
        state.stuck[rows[k] : rows[k + 1]] = laid_slack(nodes, length[part], model) if laid else nodes


def hang_chains(model: Model, system: System, state: State, length, weight) -> np.ndarray:
    """Return positions (rows, 3), m, in which lines that are joined end to end hang as the one line that they are.

    The joints lie where they hang then, not where they are described, which may be far from any equilibrium. All other
    rows are those of the state.
    """
    position, rows = state.position.copy(), system.lines.node_ptr
    stiffness = system.tension.spring * length
    for chain in joined_chains(system):
        parts = [np.arange(rows[k] - k, rows[k + 1] - k - 1)[:: 1 if end == 0 else -1] for k, end in chain]
        segments = np.concatenate(parts)
        (first, begin), (last, before) = chain[0], chain[-1]
        a = state.position[rows[-1] + system.lines.end_point[first, begin]]
        b = state.position[rows[-1] + system.lines.end_point[last, 1 - before]]
        nodes = line_guess(a, b, length[segments], stiffness[segments], weight[segments], model)
        at = 0
        for (k, end), part in zip(chain, parts, strict=True):
            own = nodes[at : at + len(part) + 1]
            position[rows[k] : rows[k + 1]] = own if end == 0 else own[::-1]
            at += len(part)
            position[rows[-1] + system.lines.end_point[k, 1 - end]] = own[-1]
    return position


def joined_chains(system: System) -> list[list[tuple[int, int]]]:
    """Return chains of joined lines: each line with the end at which the chain enters it (0: A, 1: B)."""
    joints = system.joints
    beyond = {}
    for (line1, line2), (end1, end2) in zip(joints.line.tolist(), joints.end.tolist(), strict=True):
        beyond[line1, end1], beyond[line2, end2] = (line2, end2), (line1, end1)
    chains, seen = [], set()
    for line in dict.fromkeys(joints.line.ravel().tolist()):
        for end in (0, 1):
            if line in seen or (line, end) in beyond:
                continue
            chain = [(line, end)]
            while (following := beyond.get((chain[-1][0], 1 - chain[-1][1]))) is not None:
                chain.append(following)
            seen |= {k for k, _ in chain}
            chains.append(chain)
    return chains


def laid_slack(nodes, length, model: Model) -> np.ndarray:
    """Positions (nodes, 3) of a line that lies slack, every segment at its unstretched length (m).

    It is laid along the bed, straight from the end that stands on it towards the other one: from end A when both do.
    Between ends in the water it keeps to the way of `nodes` from end A.
    """
    on_bed = [stands_on_bed(end, model) for end in (nodes[0], nodes[-1])]
    span = nodes[-1, :2] - nodes[0, :2]
    way = float(np.hypot(*span))
    if way > 0.0 and on_bed[0]:
        return laid_along_bed(nodes[0], span / way, length, model)
    if way > 0.0 and on_bed[1]:
        return laid_along_bed(nodes[-1], -span / way, length[::-1], model)[::-1]
    e = np.diff(nodes, axis=0)
    e *= (length / np.maximum(np.linalg.norm(e, axis=1), 1e-300))[:, None]
    return np.concatenate([nodes[:1], nodes[0] + np.cumsum(e, axis=0)])


def laid_along_bed(start, heading, length, model: Model) -> np.ndarray:
    """Positions (nodes, 3) on the bed at these distances (m) from one to the next, from a start along a heading."""
    at, depth_at = np.array(start), model.environment.depth_at
    placed = [at]

    def next_node(run: float) -> np.ndarray:
        x, y = at[:2] + run * heading
        return np.array([x, y, -depth_at(x, y)])

    for l in length.tolist():
        short, long = 0.0, l  # of the way ahead, m: the node is between
        for _ in range(HALVINGS):
            middle = 0.5 * (short + long)
            if float(np.linalg.norm(next_node(middle) - at)) < l:
                short = middle
            else:
                long = middle
        at = next_node(0.5 * (short + long))
        placed.append(at)
    return np.array(placed)


def line_guess(a, b, length, stiffness, weight, model: Model) -> np.ndarray:
    """Positions (nodes, 3) of a line from a to b (m); of its segments the lengths (m), EA (N) and weights (N/m)."""
    arc = np.concatenate([[0.0], np.cumsum(length)])
    chord = b - a
    span, rise = float(np.hypot(chord[0], chord[1])), float(chord[2])
    environment = model.environment
    touches = [stands_on_bed(end, model) for end in (a, b)]
    if np.ptp(weight) > 1e-9 * np.abs(weight).max():
        shape = hanging(span, rise, length, stiffness, weight * length, touches[0 if rise >= 0.0 else 1])
    else:
        # MoorDyn-F lets every line lie on a bed at the level of its lower end, MoorDyn-C only one that touches the bed
        grounded = model.flavour == "MoorDyn-F" or any(touches)
        shape = catenary(span, rise, float(arc[-1]), float(stiffness.mean()), float(weight[0]), arc, grounded)
    if shape is None:
        return lifted(a + np.outer(arc / arc[-1], chord), model)
    x, z = shape
    heading = chord[:2] / max(span, 1e-300)
    nodes = np.column_stack([a[0] + x * heading[0], a[1] + x * heading[1], a[2] + z])
    if not environment.bathymetry:  # a sag, or a wave's foot, may be lower
        nodes[1:-1, 2] = np.maximum(nodes[1:-1, 2], min(-environment.water_depth, a[2], b[2]))
    return lifted(nodes, model)


def stands_on_bed(end, model: Model) -> bool:
    """Return whether an end of a line stands on the seabed."""
    return bool(end[2] <= -model.environment.depth_at(end[0], end[1]) * (1.0 - TOUCHES))


def lifted(nodes, model: Model) -> np.ndarray:
    """Nodes (n, 3) with those inside a line lifted onto an uneven bed."""
    if model.environment.bathymetry:
        nodes[1:-1, 2] = np.maximum(nodes[1:-1, 2], [-model.environment.depth_at(x, y) for x, y, _ in nodes[1:-1]])
    return nodes
