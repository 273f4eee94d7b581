"""A heavy cantilever in a plane by equations of its own: nodes that swing, and the elastica at rest.

Nothing of Moorage is used. A bend turns by an angle a between two segments (or a segment and the clamp, where it counts
twice). Its moment EI a / h is that of a curvature, and there are two lengths h to divide by. MoorDyn-C takes the length
that the segments have now, `stretched`; ours is the one that they have unstretched, whose forces are an energy's. The
couple of a moment on a segment is a pair of forces at its ends, over its length now, in both.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from integration import runge_kutta
from scipy.integrate import solve_bvp

G = 9.80665


class Beam(NamedTuple):
    """A uniform beam, clamped along x at its first end."""

    bending: float  # EI, N m2
    axial: float  # EA, N
    mass: float  # kg/m
    weight: float  # N/m
    ratio: float  # of the critical damping of a segment
    stretched: bool  # which length bends are divided by
    pushes: bool = False  # whether segments have compression
    length: float = 10.0  # m


def forces(beam: Beam, r: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Return the forces on nodes (n + 1, 2) at places r (m) with velocities v (m/s), N."""
    l = beam.length / (len(r) - 1)
    e, de = np.diff(r, axis=0), np.diff(v, axis=0)
    L = np.linalg.norm(e, axis=1)
    q = e / L[:, None]
    damping = beam.ratio * np.sqrt(beam.axial * beam.mass) * (q * de).sum(axis=1)
    elastic = beam.axial * (L - l) / l
    tension = (elastic if beam.pushes else np.maximum(elastic, 0.0)) + damping

    before, after = np.vstack([[1.0, 0.0], q[:-1]]), q
    cosine = (before * after).sum(axis=1)
    angle = np.arctan2(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], cosine)
    h = np.full(len(q), l)
    if beam.stretched:
        h = np.concatenate([L[:1], 0.5 * (L[:-1] + L[1:])])
    h[0] *= 0.5  # the clamp holds half a segment
    moment = beam.bending * 2.0 * np.sin(0.5 * angle) / h
    couple = np.append(moment[1:], 0.0) - moment
    shear = (couple / L)[:, None] * np.stack([-q[:, 1], q[:, 0]], axis=1)

    f = np.zeros_like(r)
    f[:, 1] -= beam.weight * shares(beam, len(r))
    pull = tension[:, None] * q - shear
    f[:-1] += pull
    f[1:] -= pull
    return f


def shares(beam: Beam, nodes: int) -> np.ndarray:
    """Return the length that belongs to each node, m."""
    share = np.full(nodes, beam.length / (nodes - 1))
    share[[0, -1]] *= 0.5
    return share


def swing(beam: Beam, start: np.ndarray, interval: float, count: int, step: float) -> np.ndarray:
    """Let go at places (n + 1, 2), m; return them every interval (s), (count, n + 1, 2), by Runge and Kutta."""
    free = np.append(0.0, 1.0 / (beam.mass * shares(beam, len(start))[1:]))[:, None]

    def rate(y):
        return np.stack([y[1], free * forces(beam, *y)])

    every = round(interval / step)
    _, states = runge_kutta(rate, np.stack([start, np.zeros_like(start)]), count * interval, step)
    return states[every::every, 0]


def elastica(beam: Beam) -> np.ndarray:
    """Return the tip (2,) of the beam at rest in the limit of many segments, from its clamp, m.

    With s unstretched, g = 1 + T / EA the stretch, and T = -w (L - s) sin(theta) the pull of what hangs below s:
    x' = g cos(theta), z' = g sin(theta), M' = g w (L - s) cos(theta), M(L) = 0, and theta' = M / EI, or g M / EI where
    curvature is by the stretched length. The weight is put on little by little.
    """
    s = np.linspace(0.0, beam.length, 101)
    y = np.stack([s, 0.0 * s, 0.0 * s, 0.0 * s])
    for part in (0.1, 0.3, 0.6, 1.0):

        def rate(s, y, w=part * beam.weight):
            below = w * (beam.length - s)
            g = 1.0 - below * np.sin(y[2]) / beam.axial
            turn = y[3] / beam.bending * (g if beam.stretched else 1.0)
            return np.stack([g * np.cos(y[2]), g * np.sin(y[2]), turn, g * below * np.cos(y[2])])

        found = solve_bvp(rate, lambda a, b: np.array([a[0], a[1], a[2], b[3]]), s, y, tol=1e-8, max_nodes=20000)
        assert found.success, found.message
        s, y = found.x, found.y
    return y[:2, -1]
