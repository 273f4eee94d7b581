"""The first shape of every line: an elastic catenary between its ends, or a straight line where there is none."""

from __future__ import annotations

import numpy as np

from moorage.layout import State, System
from moorage.model import Model
from moorage.physics.catenary import catenary
from moorage.physics.motion import sample_track

TOUCHES = 1e-5  # relative depth at which an end counts as on the seabed


def place_guess(model: Model, system: System, state: State, length, weight) -> None:
    """Set positions of all rows: points at time 0, lines on catenaries; everything at rest.

    A line of several sections takes the mean of its weight; Newton's method does the rest. `length` (m) and `weight`
    (N/m) are those of the segments.
    """
    rows = system.lines.node_ptr
    now = np.zeros((1, 9))
    for k in range(len(system.points.mass)):
        sample_track(system.tracks, k, np.zeros(1), now[:, 0:3], now[:, 3:6], now[:, 6:9])
        state.position[rows[-1] + k] = now[0, :3]
    for k in range(len(model.lines)):
        a, b = (state.position[rows[-1] + end] for end in system.lines.end_point[k])
        part = slice(rows[k] - k, rows[k + 1] - k - 1)
        nodes = line_guess(
            a, b, length[part], float(np.mean(system.tension.spring[part] * length[part])),
            float(np.sum(weight[part] * length[part]) / np.sum(length[part])), model,
        )  # fmt: skip
        if model.environment.bathymetry:
            nodes[1:-1, 2] = np.maximum(nodes[1:-1, 2], [-model.environment.depth_at(x, y) for x, y, _ in nodes[1:-1]])
        state.position[rows[k] : rows[k + 1]] = nodes
        state.stuck[rows[k] : rows[k + 1]] = laid_slack(nodes, length[part])


def laid_slack(nodes, length) -> np.ndarray:
    """Positions (nodes, 3) along the same way from end A, but with every segment at its unstretched length."""
    e = np.diff(nodes, axis=0)
    e *= (length / np.maximum(np.linalg.norm(e, axis=1), 1e-300))[:, None]
    return np.concatenate([nodes[:1], nodes[0] + np.cumsum(e, axis=0)])


def line_guess(a, b, length, stiffness, weight, model: Model) -> np.ndarray:
    """Positions (nodes, 3) of a line from a to b (m)."""
    arc = np.concatenate([[0.0], np.cumsum(length)])
    chord = b - a
    span = float(np.hypot(chord[0], chord[1]))
    touches = any(end[2] <= -model.environment.depth_at(end[0], end[1]) * (1.0 - TOUCHES) for end in (a, b))
    # MoorDyn-F lets every line lie on a bed at the level of its lower end, MoorDyn-C only one that touches the bed
    grounded = model.flavour == "MoorDyn-F" or touches
    shape = catenary(span, float(chord[2]), float(arc[-1]), stiffness, weight, arc, grounded)
    if shape is None:
        return a + np.outer(arc / arc[-1], chord)
    x, z = shape
    return np.column_stack([a[0] + x * chord[0] / span, a[1] + x * chord[1] / span, a[2] + z])
