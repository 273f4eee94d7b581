"""A slack rope of no weight in water, from a point in the surface to a weight, in its plane, by equations of its own.

Nothing of Moorage is used. How much of a segment is wet, and which of its nodes gets the lift, is by either of two rules.

* MoorDyn-C's (2.7.2): a segment is wet as a whole where its first end is in the surface or below and its second below. Of
  one that crosses the surface, the wet length is told by the heights of the rims of its ends. Each node gets half. Where
  the first end is exactly in the surface and the second rises out of it, their roles are exchanged: the higher it is, the
  more is wet.
* Ours: a section is wet by a fraction that falls from 1 to 0 over the height of a diameter about the surface; each node
  gets the integral of it times its linear shape along the segment.
"""

from __future__ import annotations

import numpy as np
from integration import runge_kutta

G, RHO, DIAMETER, AXIAL, RATIO, LENGTH, WEIGHT = 9.80665, 1000.0, 0.1, 1e9, 0.01, 32.0, 10.0
MASS = 7.85398  # kg/m, that of its water; nothing resists across
ALONG = (np.arange(200) + 0.5) / 200.0


def wet_by_rims(z: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the wet shares (n, 2) of segments between heights z (n + 1,), with directions q (n, 2)."""
    first, second = z[:-1], z[1:]
    low, high = np.where(
        first < 0.0, [first, second], [second, first]
    )  # the first in the surface is taken for the upper
    rim = 0.5 * DIAMETER * np.abs(q[:, 0])
    crossing = np.abs(low - rim) / (np.abs(low - rim) + high + rim)
    whole, none = (first <= 0.0) & (second < 0.0), (first > 0.0) & (second > 0.0)
    wet = np.where(whole, 1.0, np.where(none, 0.0, crossing))
    return 0.5 * np.stack([wet, wet], axis=1)


def wet_by_sections(z: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Return the same by our rule, as a sum along the segments that are near the surface."""
    shares = np.full((len(q), 2), 0.5)
    near = np.maximum(z[:-1], z[1:]) > -0.5 * DIAMETER
    height = z[:-1][near, None] * (1.0 - ALONG) + z[1:][near, None] * ALONG
    wet = np.clip(0.5 - height / DIAMETER, 0.0, 1.0)
    shares[near] = np.stack([(wet * (1.0 - ALONG)).mean(axis=1), (wet * ALONG).mean(axis=1)], axis=1)
    return shares


def fall(wetness, start: np.ndarray, interval: float, count: int, step: float) -> np.ndarray:
    """Let go at places (n + 1, 2), m; return them every interval (s), (count, n + 1, 2), by Runge and Kutta."""
    n = len(start) - 1
    l = LENGTH / n
    mass = np.full(n + 1, MASS * l)
    mass[[0, -1]] *= 0.5
    mass[-1] += WEIGHT
    lift, damping = RHO * G * 0.25 * np.pi * DIAMETER**2 * l, RATIO * np.sqrt(AXIAL * MASS)
    free = np.append(0.0, 1.0 / mass[1:])[:, None]

    def rate(y):
        r, v = y
        e, de = np.diff(r, axis=0), np.diff(v, axis=0)
        L = np.linalg.norm(e, axis=1)
        q = e / L[:, None]
        pull = (np.maximum(AXIAL * (L - l) / l, 0.0) + damping * (q * de).sum(axis=1))[:, None] * q
        f = np.zeros_like(r)
        f[:, 1] = -G * mass
        f[:-1] += pull
        f[1:] -= pull
        wet = wetness(r[:, 1], q)
        f[:-1, 1] += lift * wet[:, 0]
        f[1:, 1] += lift * wet[:, 1]
        return np.stack([v, free * f])

    every = round(interval / step)
    _, states = runge_kutta(rate, np.stack([start, np.zeros_like(start)]), count * interval, step)
    return states[every::every, 0]
