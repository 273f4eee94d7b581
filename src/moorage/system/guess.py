"""The first shape of every line: limp, elastic, between its ends; a straight line where there is none."""

from __future__ import annotations

import numpy as np

from moorage.layout import State, System
from moorage.model import Model
from moorage.physics.catenary import catenary
from moorage.physics.hanging import hanging
from moorage.physics.motion import sample_track

TOUCHES = 1e-5  # relative depth at which an end counts as on the seabed


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
        state.stuck[rows[k] : rows[k + 1]] = laid_slack(nodes, length[part])


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


def laid_slack(nodes, length) -> np.ndarray:
    """Positions (nodes, 3) along the same way from end A, but with every segment at its unstretched length."""
    e = np.diff(nodes, axis=0)
    e *= (length / np.maximum(np.linalg.norm(e, axis=1), 1e-300))[:, None]
    return np.concatenate([nodes[:1], nodes[0] + np.cumsum(e, axis=0)])


def line_guess(a, b, length, stiffness, weight, model: Model) -> np.ndarray:
    """Positions (nodes, 3) of a line from a to b (m); of its segments the lengths (m), EA (N) and weights (N/m)."""
    arc = np.concatenate([[0.0], np.cumsum(length)])
    chord = b - a
    span, rise = float(np.hypot(chord[0], chord[1])), float(chord[2])
    environment = model.environment
    touches = [end[2] <= -environment.depth_at(end[0], end[1]) * (1.0 - TOUCHES) for end in (a, b)]
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


def lifted(nodes, model: Model) -> np.ndarray:
    """Nodes (n, 3) with those inside a line lifted onto an uneven bed."""
    if model.environment.bathymetry:
        nodes[1:-1, 2] = np.maximum(nodes[1:-1, 2], [-model.environment.depth_at(x, y) for x, y, _ in nodes[1:-1]])
    return nodes
