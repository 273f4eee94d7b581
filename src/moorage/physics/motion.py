"""Prescribed motion of points: cubic splines in time (C2), so that the imposed velocity never jumps.

A velocity that jumps by dv puts sqrt(EA m) dv of false tension on a line.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.linalg import solve_banded

from moorage._jit import inlined, kernel
from moorage.physics.table import interval


class Tracks(NamedTuple):
    """Splines of the moving points; a track holds position = sum of coefficient s^power, s from the last knot."""

    track: np.ndarray  # (points,) index of a point's track, -1: stays at `rest`
    rest: np.ndarray  # (points, 3) m
    knots: np.ndarray  # (knots,) s
    coefficients: np.ndarray  # (tracks, knots - 1, 3, 4) highest power first


def no_tracks(rest) -> Tracks:
    """Keep every point where it is."""
    return Tracks(np.full(len(rest), -1), np.array(rest, dtype=float), np.array([0.0, 1.0]), np.zeros((0, 1, 3, 4)))


def spline_tracks(rest, time, positions) -> Tracks:
    """Put not-a-knot cubic splines through positions {point index: (n, 3)} at times (n,)."""
    track = np.full(len(rest), -1)
    track[list(positions)] = np.arange(len(positions))
    knots = np.array(time, float)
    coefficients = np.zeros((len(positions), len(knots) - 1, 3, 4))
    for k, values in enumerate(positions.values()):
        coefficients[k] = spline(knots, np.asarray(values, float))
    return Tracks(track, np.array(rest, float), knots, coefficients)


def spline(t, y) -> np.ndarray:
    """Coefficients (n - 1, 3, 4), highest power first, of the C2 cubic spline through y (n, 3) at knots t (n,).

    Its slopes s at the knots solve a tridiagonal system; the third derivative is continuous at the second and the last
    but one knot (not-a-knot), or the second is zero at the ends of fewer than four knots. The same as SciPy's
    CubicSpline, whose module alone takes 0.15 s to import.
    """
    h = np.diff(t)
    d = np.diff(y, axis=0) / h[:, None]
    if len(t) == 2:
        s = np.stack([d[0], d[0]])
    else:
        diagonals, right = np.zeros((3, len(t))), np.zeros_like(y)  # upper, main and lower, as solve_banded wants them
        diagonals[0, 2:], diagonals[1, 1:-1], diagonals[2, :-2] = h[:-1], 2.0 * (h[:-1] + h[1:]), h[1:]
        right[1:-1] = 3.0 * (h[1:, None] * d[:-1] + h[:-1, None] * d[1:])
        for end, beyond, (h0, h1), (d0, d1) in ((0, (0, 1), h[:2], d[:2]), (-1, (2, -2), h[:-3:-1], d[:-3:-1])):
            both = h0 + h1
            if len(t) > 3:
                diagonals[1, end], diagonals[beyond] = h1, both
                right[end] = ((h0 + 2.0 * both) * h1 * d0 + h0 * h0 * d1) / both
            else:
                diagonals[1, end], diagonals[beyond], right[end] = 2.0, 1.0, 3.0 * d0
        s = solve_banded((1, 1), diagonals, right)
    bend = (s[:-1] + s[1:] - 2.0 * d) / h[:, None]
    return np.stack([bend / h[:, None], (d - s[:-1]) / h[:, None] - bend, s[:-1], y[:-1]], axis=-1)


@kernel
def all_finite(values):
    """Whether no number of (m, 3) is infinite or none: NumPy takes ten times as long for a few."""
    total = 0.0
    for k in range(len(values)):
        total += 0.0 * (values[k, 0] + values[k, 1] + values[k, 2])
    return total == 0.0


@kernel
def set_cubics(tracks, t0, t1, r0, v0, r1, v1):
    """Let the first tracks follow the cubics from places (m, 3) and velocities at t0 (s) to those at t1."""
    tracks.knots[0], tracks.knots[1] = t0, t1
    h = t1 - t0
    for k in range(len(r0)):
        for x in range(3):
            cubic, d = tracks.coefficients[k, 0, x], (r1[k, x] - r0[k, x]) / h
            cubic[0] = (v0[k, x] + v1[k, x] - 2.0 * d) / (h * h)
            cubic[1] = (3.0 * d - 2.0 * v0[k, x] - v1[k, x]) / h
            cubic[2], cubic[3] = v0[k, x], r0[k, x]


def with_cubics(tracks: Tracks, knots: list[np.ndarray], pieces: list[np.ndarray]) -> Tracks:
    """Add rows of which x follows piecewise cubics: pieces (n, 4), highest power first, between knots (n + 1,), s."""
    if not knots:
        return tracks
    moving = len(tracks.coefficients) > 0
    common = np.unique(np.concatenate([*knots, *([tracks.knots] if moving else [])]))
    old = _on_knots(tracks.knots, tracks.coefficients, common) if moving else np.zeros((0, len(common) - 1, 3, 4))
    new = np.zeros((len(knots), len(common) - 1, 3, 4))
    for k, (own, cubics) in enumerate(zip(knots, pieces, strict=True)):
        new[k, :, 0] = _on_knots(own, cubics[None, :, None], common)[0, :, 0]
    track = np.concatenate([tracks.track, len(old) + np.arange(len(new))])
    rest = np.concatenate([tracks.rest, np.zeros((len(new), 3))])
    return Tracks(track, rest, common, np.concatenate([old, new]))


def _on_knots(old, coefficients, new) -> np.ndarray:
    """Write cubics (tracks, n - 1, x, 4) between knots (n,) between other knots, among which these are."""
    k = np.clip(np.searchsorted(old, new[:-1], side="right") - 1, 0, len(old) - 2)
    s = (new[:-1] - old[k])[:, None]
    a, b, c, d = np.moveaxis(coefficients[:, k], -1, 0)
    return np.stack([a, b + 3.0 * a * s, c + (2.0 * b + 3.0 * a * s) * s, d + (c + (b + a * s) * s) * s], axis=-1)


@inlined
def follow(p, point, t):
    """Position (m), velocity (m/s) and acceleration (m/s2) of a prescribed point at time t."""
    zero = (0.0, 0.0, 0.0)
    track = p.track[point]
    if track < 0:
        return (p.rest[point, 0], p.rest[point, 1], p.rest[point, 2]), zero, zero
    k = interval(p.knots, 0, len(p.knots), t)
    s = t - p.knots[k]
    c = p.coefficients
    r0, v0, a0 = cubic(c[track, k, 0, 0], c[track, k, 0, 1], c[track, k, 0, 2], c[track, k, 0, 3], s)
    r1, v1, a1 = cubic(c[track, k, 1, 0], c[track, k, 1, 1], c[track, k, 1, 2], c[track, k, 1, 3], s)
    r2, v2, a2 = cubic(c[track, k, 2, 0], c[track, k, 2, 1], c[track, k, 2, 2], c[track, k, 2, 3], s)
    return (r0, r1, r2), (v0, v1, v2), (a0, a1, a2)


@inlined
def cubic(a, b, c, d, s):
    """Value, slope and curvature of a s^3 + b s^2 + c s + d."""
    return ((a * s + b) * s + c) * s + d, (3.0 * a * s + 2.0 * b) * s + c, 6.0 * a * s + 2.0 * b


@kernel
def sample_track(p, point, times, position, velocity, acceleration):
    """Fill (n, 3) arrays (any strides) with the motion of a prescribed point at times (n,)."""
    for k in range(len(times)):
        r, v, a = follow(p, point, times[k])
        for x in range(3):
            position[k, x], velocity[k, x], acceleration[k, x] = r[x], v[x], a[x]
