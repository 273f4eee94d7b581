"""Current: velocity of the water on a grid over time and place, linear between its points, constant outside.

Most currents are one profile, at all times and places: those look up a level and nothing else. A grid has no
acceleration: a current changes in minutes, and a velocity that is linear in time would make the forces jump.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, kernel
from moorage.physics.table import interval


class Current(NamedTuple):
    """Points of the grid and velocities."""

    t: np.ndarray  # (nt,) increasing, s
    x: np.ndarray  # (nx,) increasing, m, along the grid's own axes
    y: np.ndarray  # (ny,)
    z: np.ndarray  # (nz,) increasing, m
    velocity: np.ndarray  # (nt nx ny nz, 3) m/s in the model's axes, z changes fastest
    cosine: float  # of the angle of the grid's axes against the model's
    sine: float
    flows: bool  # whether any of it is not zero
    corners: int  # columns of levels around a place and time: 1 for a profile, or 8


@inlined
def current_at(p, r, t):
    """Velocity of the water at a place and time, m/s."""
    k, s = place_on(p.z, r[2])
    if p.corners == 1:
        return at_level(p, 0, k, s)
    a, f = place_on(p.t, t)
    i, g = place_on(p.x, p.cosine * r[0] + p.sine * r[1])
    j, h = place_on(p.y, p.cosine * r[1] - p.sine * r[0])
    u, v, w = 0.0, 0.0, 0.0
    for corner in range(p.corners):
        da, di, dj = corner & 1, (corner >> 1) & 1, corner >> 2
        share = (f if da else 1.0 - f) * (g if di else 1.0 - g) * (h if dj else 1.0 - h)
        if share > 0.0:
            flow = at_level(p, (((a + da) * len(p.x) + i + di) * len(p.y) + j + dj) * len(p.z), k, s)
            u, v, w = u + share * flow[0], v + share * flow[1], w + share * flow[2]
    return u, v, w


@kernel
def place_on(axis, value):
    """Interval of an axis that holds a value and the fraction of it, 0 outside the axis and on its last point."""
    n = len(axis)
    if n < 2 or value <= axis[0]:
        return 0, 0.0
    if value >= axis[n - 1]:
        return n - 1, 0.0
    k = interval(axis, 0, n, value)
    return k, (value - axis[k]) / (axis[k + 1] - axis[k])


@inlined
def at_level(p, column, k, s):
    """Velocity in a column of levels, at the fraction s of interval k, m/s."""
    a = column + k
    u, v, w = p.velocity[a, 0], p.velocity[a, 1], p.velocity[a, 2]
    if s > 0.0:
        u += s * (p.velocity[a + 1, 0] - u)
        v += s * (p.velocity[a + 1, 1] - v)
        w += s * (p.velocity[a + 1, 2] - w)
    return u, v, w
