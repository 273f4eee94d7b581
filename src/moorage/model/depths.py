"""Depth between the points of a grid, for what is no kernel: the surface of `physics.bathymetry`, one place at a time.

Verified by tests/verification/test_bathymetry.py.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence

Levels = Sequence[float]
Rows = Sequence[Sequence[float]]


def bilinear(xs: Levels, ys: Levels, depth: Rows, x: float, y: float) -> float:
    """Return the depth (m) at a place: bilinear between the grid's points, the nearest edge outside."""
    i, i1, u = bracket(xs, x)
    j, j1, v = bracket(ys, y)
    low = depth[i][j] + u * (depth[i1][j] - depth[i][j])
    high = depth[i][j1] + u * (depth[i1][j1] - depth[i][j1])
    return low + v * (high - low)


def bicubic(xs: Levels, ys: Levels, depth: Rows, x: float, y: float) -> float:
    """Return the depth (m) at a place of the smooth surface, with slopes from central differences at its points."""
    i, i1, u = bracket(xs, x)
    j, j1, v = bracket(ys, y)

    def along_x(b: int) -> tuple[float, float]:
        """Depth and its slope to y on the line y = ys[b]."""
        values = [depth[a][b] for a in (i, i1)]
        slopes = [_slope(xs, lambda k: depth[k][b], a) for a in (i, i1)]
        turns = [_slope(ys, lambda k, a=a: depth[a][k], b) for a in (i, i1)]  # type: ignore[misc]
        twists = [_slope(ys, lambda m, a=a: _slope(xs, lambda k: depth[k][m], a), b) for a in (i, i1)]  # type: ignore[misc]
        step = xs[i1] - xs[i]
        return _hermite(u, step, values, slopes), _hermite(u, step, turns, twists)

    (low, low_slope), (high, high_slope) = along_x(j), along_x(j1)
    return _hermite(v, ys[j1] - ys[j], [low, high], [low_slope, high_slope])


def bracket(levels: Levels, value: float) -> tuple[int, int, float]:
    """Return the ends of the interval of increasing levels that holds a value, and the place in it (0 to 1)."""
    if len(levels) == 1:
        return 0, 0, 0.0
    k = max(0, min(bisect_right(levels, value) - 1, len(levels) - 2))
    return k, k + 1, min(1.0, max(0.0, (value - levels[k]) / (levels[k + 1] - levels[k])))


def _slope(axis: Levels, f: Callable[[int], float], k: int) -> float:
    """Return the slope of values f at point k of an axis, to second order inside and to first at its ends."""
    if len(axis) == 1:
        return 0.0
    below, above = max(k - 1, 0), min(k + 1, len(axis) - 1)
    if below == k or above == k:
        return (f(above) - f(below)) / (axis[above] - axis[below])
    h, g = axis[k] - axis[below], axis[above] - axis[k]
    return (h * (f(above) - f(k)) / g + g * (f(k) - f(below)) / h) / (h + g)


def _hermite(s: float, step: float, values: Sequence[float], slopes: Sequence[float]) -> float:
    """Return the cubic through two values with two slopes at the fraction s of a step."""
    t = 1.0 - s
    ends = (1.0 + 2.0 * s) * t * t * values[0] + s * s * (3.0 - 2.0 * s) * values[1]
    return ends + step * (s * t * t * slopes[0] - s * s * t * slopes[1])
