"""Flat seabed: linear spring and damper upwards, F_n = [(z_b - z) k_b - c_b v_z] d l (Housner et al. 2022, equation 3).

As written the damper switches on with a jump when a node touches the bed, and then some implicit steps have no solution
at all. Here the damper acts for the fraction of the step that the node spends in contact. That is continuous in the
unknown position, needs no regularising depth, and tends to the law above as the step goes to zero.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined

ZERO3 = (0.0, 0.0, 0.0)
ZERO6 = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Seabed(NamedTuple):
    """Parameters of the nodes."""

    spring: np.ndarray  # (nodes,) kb d l, N/m
    damper: np.ndarray  # (nodes,) cb d l, N s/m
    level: float  # z of the bed, m


@inlined
def contact_fraction(depth_before, depth):
    """Fraction of a step spent in contact, from the penetrations at its two ends (m), and its slope (1/m)."""
    if depth > 0.0:
        if depth_before >= 0.0:
            return 1.0, 0.0
        span = depth - depth_before
        return depth / span, -depth_before / (span * span)
    if depth_before <= 0.0:
        return 0.0, 0.0
    span = depth_before - depth
    return depth_before / span, depth_before / (span * span)


@inlined
def seabed_terms(p, i, z_before, z, vz, c):
    """Upward force of the bed on node i (N) and the zz entry of its block; z_before: level at the start of the step."""
    depth, depth_before = p.level - z, p.level - z_before
    if depth <= 0.0 and depth_before <= 0.0:
        return 0.0, 0.0
    fraction, ramp = contact_fraction(depth_before, depth)
    damper = p.damper[i]
    touching = 1.0 if depth > 0.0 else 0.0
    force = touching * p.spring[i] * depth - fraction * damper * vz
    return force, c.stiffness * (touching * p.spring[i] - ramp * damper * vz) + c.damping * fraction * damper


@inlined
def seabed_energy(p, i, z):
    """Elastic energy of the bed under node i, J."""
    depth = max(p.level - z, 0.0)
    return 0.5 * p.spring[i] * depth * depth
