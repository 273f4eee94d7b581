"""Steady current: velocity of the water by level, linear between levels, constant above and below them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage.physics.table import interval


class Current(NamedTuple):
    """Levels and velocities."""

    z: np.ndarray  # (levels,) increasing, m
    velocity: np.ndarray  # (levels, 3) m/s
    flows: bool  # whether any of it is not zero


@inlined
def current_at(p, z):
    """Velocity of the water at level z, m/s."""
    n = len(p.z)
    if n < 2 or z <= p.z[0]:
        return p.velocity[0, 0], p.velocity[0, 1], p.velocity[0, 2]
    if z >= p.z[n - 1]:
        return p.velocity[n - 1, 0], p.velocity[n - 1, 1], p.velocity[n - 1, 2]
    k = interval(p.z, 0, n, z)
    s = (z - p.z[k]) / (p.z[k + 1] - p.z[k])
    return (
        p.velocity[k, 0] + s * (p.velocity[k + 1, 0] - p.velocity[k, 0]),
        p.velocity[k, 1] + s * (p.velocity[k + 1, 1] - p.velocity[k, 1]),
        p.velocity[k, 2] + s * (p.velocity[k + 1, 2] - p.velocity[k, 2]),
    )
