"""Contact with the seabed along its normal n (Housner et al. 2022, equation 4):

    F_n = [(z_b - z) n_z k_b n - c_b v_n] d l,   v_n = (v . n) n

On a curved bed this force is no energy's gradient. As written the damper switches on with a jump when a node touches
the bed, and then some implicit steps have no solution at all. Here the damper acts for the fraction of the step that
the node spends in contact. That is continuous in the unknown position, needs no regularising depth, and tends to the
law above as the step goes to zero.

A soil that remembers (soil.py) takes the place of spring and damper where it is asked for.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage._vec3 import dot, isotropic_plus, sym_add, sym_outer
from moorage.physics.bathymetry import Bathymetry, bed_at, normal_of
from moorage.physics.grid import Grid, values_at
from moorage.physics.soil import Soil, resistance


class Contact(NamedTuple):
    """Parameters of the nodes."""

    spring: np.ndarray  # (nodes,) kb d l, N/m; with a map of kb d l, m2
    damper: np.ndarray  # (nodes,) cb d l, N s/m
    bed: Bathymetry
    stiffness: Grid  # map of kb, Pa/m (its second value is not used); no points: the same everywhere
    soil: Soil


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
def near_bed(p, before, r):
    """Whether a node may touch the bed in a step from `before` to r."""
    return min(before[2], r[2]) <= p.bed.highest


@inlined
def contact_terms(p, i, before, r, v, memory, c):
    """Normal force on node i (N, along n), n, and the block.

    before, memory: its position, and what the soil remembers, at the start of the step.
    """
    return contact_on(p, i, bed_at(p.bed, r[0], r[1]), before, r, v, memory, c)


@inlined
def contact_on(p, i, bed, before, r, v, memory, c):
    """Same where the level and slopes of the bed under the node are known.

    The block leaves out how a map's stiffness changes. At rest it keeps the symmetric part of how n turns on a curved
    bed, and leaves it out where there is inertia, beside which it is nothing.
    """
    level, zx, zy, zxx, zxy, zyy = bed
    depth = level - r[2]
    # the bed under the place before, continued from here: exact within a cell of a bilinear bed
    x, y = before[0] - r[0], before[1] - r[1]
    depth_before = level + zx * x + zy * y + zxy * x * y - before[2]
    if depth <= 0.0 and depth_before <= 0.0:
        return 0.0, (0.0, 0.0, 1.0), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    n = normal_of(zx, zy)
    # d depth / dr = -n / n_z
    if p.soil.on:
        elastic, rise = resistance(p.soil, i, memory, depth * n[2])
        drag, stiff = 0.0, c.stiffness * rise
    else:
        fraction, ramp = contact_fraction(depth_before, depth)
        spring = spring_at(p, i, r)
        elastic = spring * max(depth, 0.0) * n[2]
        speed = dot(v, n)
        damper = fraction * p.damper[i]
        drag = damper * speed
        touching = 1.0 if depth > 0.0 else 0.0
        stiff = c.stiffness * touching * spring + c.damping * damper
        if ramp != 0.0:
            stiff -= c.stiffness * ramp * p.damper[i] * speed / n[2]
    block = isotropic_plus(0.0, stiff, n)
    if c.mass == 0.0 and (zxx != 0.0 or zxy != 0.0 or zyy != 0.0):
        block = sym_add(block, curvature_block(c.stiffness * elastic, n, zxx, zxy, zyy))
    return elastic - drag, n, block


@inlined
def penetration(p, r):
    """How far below the bed a place is, along its normal, m; negative above it."""
    level, zx, zy, _, _, _ = bed_at(p.bed, r[0], r[1])
    return (level - r[2]) * normal_of(zx, zy)[2]


@inlined
def spring_at(p, i, r):
    """Stiffness of the bed under node i at r, N/m."""
    if len(p.stiffness.x.at) == 0:
        return p.spring[i]
    return p.spring[i] * values_at(p.stiffness, r[0], r[1])[0]


@inlined
def curvature_block(force, n, zxx, zxy, zyy):
    """Minus the symmetric part of d(force n)/dr, with the elastic force also growing with n_z.

    n_i = -z_i n_z, so that dn_i = -n_z dz_i + n_i dn_z / n_z and dn_z = n_z^2 (n . dz) for i = x, y.
    """
    gx, gy = n[0] * zxx + n[1] * zxy, n[0] * zxy + n[1] * zyy
    w = n[2] * n[2]
    dnz = w * gx, w * gy, 0.0  # d n_z / dr
    turn = force * n[2]
    across = turn * zxx, turn * zxy, 0.0, turn * zyy, 0.0, 0.0  # from -n_z dz
    # n dn_z / n_z twice: once in n, once in the depth along n
    along = sym_outer((-force / n[2] * n[0], -force / n[2] * n[1], -force / n[2] * n[2]), dnz)
    return sym_add(across, along)


@inlined
def contact_energy(p, i, r):
    """Elastic energy of a flat or sloping plane bed under node i, J."""
    level, zx, zy, _, _, _ = bed_at(p.bed, r[0], r[1])
    depth = max(level - r[2], 0.0) * normal_of(zx, zy)[2]
    return 0.5 * spring_at(p, i, r) * depth * depth
