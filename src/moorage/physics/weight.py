"""Weight, and buoyancy of the part of a segment that is under water.

The wetted share of a segment of diameter d that crosses the surface follows from the potential of its buoyancy, so that
the force is its gradient: node k of the segment gets

    B integral_0^1 N_k(t) phi(z(t)) dt,   N = (1 - t, t),   z(t) linear between the nodes,

with phi the wet fraction of the section, which falls linearly from 1 at d/2 below the surface to 0 at d/2 above it. The
sum of both is MoorDyn's force on the wet length; MoorDyn splits it in equal halves, which is no energy's gradient.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined


class Weight(NamedTuple):
    """Parameters of nodes and segments."""

    dry: np.ndarray  # (nodes,) weight in air, upwards, -g m, N
    buoyancy: np.ndarray  # (segments,) of a whole wet segment, N
    radius: np.ndarray  # (segments,) m


@inlined
def wet_shares(radius, z0, z1):
    """Wet shares of a segment's two nodes (0.5 each when under water), of nodes z0 and z1 above the surface.

    Returns (share0, share1, d00, d01, d11): the shares and their derivatives d share_i / d z_j (1/m).
    """
    if max(z0, z1) <= -radius:
        return 0.5, 0.5, 0.0, 0.0, 0.0
    if min(z0, z1) >= radius:
        return 0.0, 0.0, 0.0, 0.0, 0.0
    rise = z1 - z0
    if abs(rise) < 1e-9 * radius:
        rise = 1e-9 * radius
    # t at which the axis crosses the lower and the upper edge of the surface band, in the order of t
    low, high = (-radius - z0) / rise, (radius - z0) / rise
    a, b = min(max(min(low, high), 0.0), 1.0), min(max(max(low, high), 0.0), 1.0)
    # the wholly wet part lies before a when the segment rises, after b when it falls
    w0, w1 = (0.0, a) if rise > 0.0 else (b, 1.0)
    share1 = 0.5 * (w1 * w1 - w0 * w0)
    share0 = (w1 - w0) - share1
    # the band: a product of two linear functions, which Simpson's rule integrates exactly
    middle = 0.5 * (a + b)
    wide = (b - a) / 6.0
    pa = section_fraction(radius, z0 + a * rise)
    pm = section_fraction(radius, z0 + middle * rise)
    pb = section_fraction(radius, z0 + b * rise)
    share0 += wide * ((1.0 - a) * pa + 4.0 * (1.0 - middle) * pm + (1.0 - b) * pb)
    share1 += wide * (a * pa + 4.0 * middle * pm + b * pb)
    slope = -0.5 / radius
    b1, a1 = 1.0 - b, 1.0 - a
    d00 = slope * (a1 * a1 * a1 - b1 * b1 * b1) / 3.0
    d11 = slope * (b * b * b - a * a * a) / 3.0
    d01 = slope * (0.5 * (b * b - a * a) - (b * b * b - a * a * a) / 3.0)
    return share0, share1, d00, d01, d11


@inlined
def section_fraction(radius, z):
    """Wet fraction of a section whose centre is z above the surface."""
    return min(max(0.5 - 0.5 * z / radius, 0.0), 1.0)
