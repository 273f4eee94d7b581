"""Current: velocity of the water on a grid over time and place, linear between its points, constant outside.

Most currents are one profile, at all times and places: those look up a level and nothing else. A grid has no
acceleration: a current changes in minutes, and a velocity that is linear in time would make the forces jump.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, part
from moorage.physics.table import interval


class Current(NamedTuple):
    """Points of the grid and velocities."""

    points: np.ndarray  # (nz + nt + nx + ny,) increasing levels, m; times, s; x and y, m, along the grid's own axes
    velocity: np.ndarray  # (nt nx ny nz, 3) m/s in the model's axes, z changes fastest
    nz: int
    nt: int
    nx: int
    ny: int
    cosine: float  # of the angle of the grid's axes against the model's
    sine: float
    flows: bool  # whether any of it is not zero


def current_of(t, x, y, z, velocity, turn: float = 0.0) -> Current:
    """Return the current of a grid (nt,), (nx,), (ny,), (nz,) with velocities (nt, nx, ny, nz, 3)."""
    points = np.concatenate([np.asarray(axis, float) for axis in (z, t, x, y)])
    velocity = np.array(velocity, float).reshape(-1, 3)
    turned = float(np.cos(turn)), float(np.sin(turn))
    return Current(points, velocity, len(z), len(t), len(x), len(y), *turned, bool(velocity.any()))


@inlined
def current_at(p, r, t):
    """Velocity of the water at a place and time, m/s."""
    k, s = place_on(p.points, 0, p.nz, r[2])
    if p.nt + p.nx + p.ny == 3:  # one profile for all
        return at_level(p, 0, k, s)
    a, f = place_on(p.points, p.nz, p.nt, t)
    i, g = place_on(p.points, p.nz + p.nt, p.nx, p.cosine * r[0] + p.sine * r[1])
    j, h = place_on(p.points, p.nz + p.nt + p.nx, p.ny, p.cosine * r[1] - p.sine * r[0])
    u, v, w = 0.0, 0.0, 0.0
    for corner in range(8 if p.nt > 0 else 0):  # a count that the compiler does not know, so that it stays a loop
        da, di, dj = corner & 1, (corner >> 1) & 1, corner >> 2
        share = (f if da else 1.0 - f) * (g if di else 1.0 - g) * (h if dj else 1.0 - h)
        if share > 0.0:
            flow = at_level(p, (((a + da) * p.nx + i + di) * p.ny + j + dj) * p.nz, k, s)
            u, v, w = u + share * flow[0], v + share * flow[1], w + share * flow[2]
    return u, v, w


@part
def place_on(points, begin, n, value):
    """Interval of an axis that holds a value and the fraction of it, 0 outside the axis and on its last point."""
    if n < 2 or value <= points[begin]:
        return 0, 0.0
    if value >= points[begin + n - 1]:
        return n - 1, 0.0
    k = interval(points, begin, begin + n, value)
    return k - begin, (value - points[k]) / (points[k + 1] - points[k])


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
