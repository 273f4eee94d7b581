"""Rectangular grids over x and y: where a place lies on one, and values between its points, bilinear.

Outside a grid the nearest edge goes on.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage.physics.table import bisect


class Axis(NamedTuple):
    """Points of a grid in one direction."""

    at: np.ndarray  # (n,) m, increasing
    inverse: np.ndarray  # (n,) 1 / distance to the next point, 1/m; 0 for the last: divisions are slow
    rate: float  # points per metre of an even spacing, which is the first guess, 1/m


class Grid(NamedTuple):
    """Two values at each point of a grid."""

    x: Axis
    y: Axis
    value: np.ndarray  # (nx, ny, 2)


def build_axis(at) -> Axis:
    """Return an axis through points (n,)."""
    at = np.array(at, float)
    inverse = np.append(1.0 / np.diff(at), 0.0) if len(at) else np.zeros(0)
    return Axis(at, inverse, float((len(at) - 1) / (at[-1] - at[0])) if len(at) > 1 else 0.0)


def no_grid() -> Grid:
    """Return a grid without points."""
    return Grid(build_axis(()), build_axis(()), np.zeros((0, 0, 2)))


def build_grid(x, y, first, second) -> Grid:
    """Return a grid of two values, each (nx, ny)."""
    return Grid(build_axis(x), build_axis(y), np.ascontiguousarray(np.stack([first, second], axis=2), dtype=float))


@inlined
def locate(axis, place):
    """Interval that holds a place: its two points, the fraction of it, and 1 / length (0 outside the grid)."""
    n = len(axis.at)
    if n == 1:
        return np.uintp(0), np.uintp(0), 0.0, 0.0
    low, high = axis.at[0], axis.at[n - 1]
    held = min(max(place, low), high)
    k = np.uintp(min(max(int((held - low) * axis.rate), 0), n - 2))
    if not axis.at[k] <= held <= axis.at[k + np.uintp(1)]:
        k = np.uintp(bisect(axis.at, 0, n - 1, held))
    inverse = axis.inverse[k]
    return k, k + np.uintp(1), (held - axis.at[k]) * inverse, inverse if held == place else 0.0


@inlined
def values_at(grid, x, y):
    """Both values at a place."""
    i, i1, u, _ = locate(grid.x, x)
    j, j1, v, _ = locate(grid.y, y)
    return bilinear(grid.value, i, i1, j, j1, u, v, 0), bilinear(grid.value, i, i1, j, j1, u, v, 1)


@inlined
def bilinear(value, i, i1, j, j1, u, v, k):
    low = value[i, j, k] + u * (value[i1, j, k] - value[i, j, k])
    high = value[i, j1, k] + u * (value[i1, j1, k] - value[i, j1, k])
    return low + v * (high - low)
