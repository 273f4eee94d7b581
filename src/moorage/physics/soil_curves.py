"""Friction by curves of a soil: mobilised coefficient over displacement, along and across the line apart.

    F_a = -N c_a(|d_a|) sgn(d_a),   F_t = -N c_t(|d_t|) d_t / |d_t|

d is the way along the bed from the place that a node remembers. A curve rises from 0 to a plateau. Up to the end of the
curve the node is held by a nonlinear spring, which gives back what it took: unloading follows the curve. Beyond it the
node slips and takes the place along, so that after a reversal the force falls along the same curve, seen from the
plateau, and then rises to the plateau on the other side. Axial and transverse parts do not limit each other.
"""

from __future__ import annotations

import math

from moorage._jit import inlined
from moorage._vec3 import add, dot, isotropic_plus, scale, sub, sym_add
from moorage.physics.table import look_up


@inlined
def mobilised(curves, table, way):
    """Coefficient at a displacement (m, not negative), its slope (1/m), and the displacement held at most (m)."""
    end = curves.ptr[table + 1] - 1
    if way >= curves.x[end]:
        return curves.y[end], 0.0, curves.x[end]
    value, slope = look_up(curves, table, way)
    return value, slope, way


@inlined
def soil_terms(curves, N, n, s, d, c):
    """Friction under the normal force N (N) at d along the bed from the place where it stuck, its block, and the part
    of d that stays held; s: direction of the line along the bed, or zero.

    Without regard to how N and s change the block is exact.
    """
    along = dot(d, s)
    side = sub(d, scale(along, s))
    across = math.sqrt(dot(side, side))
    t = scale(1.0 / across, side) if across > 1e-12 else (0.0, 0.0, 0.0)
    axial, axial_slope, axial_held = mobilised(curves, 0, abs(along))
    lateral, lateral_slope, lateral_held = mobilised(curves, 1, across)
    sign = 1.0 if along >= 0.0 else -1.0
    force = add(scale(-N * axial * sign, s), scale(-N * lateral, t))
    held = add(scale(axial_held * sign, s), scale(lateral_held, t))
    secant = lateral / across if across > 1e-12 else lateral_slope
    k = c.stiffness * N
    block = sym_add(isotropic_plus(k * secant, -k * secant, n), isotropic_plus(0.0, k * (axial_slope - secant), s))
    return force, sym_add(block, isotropic_plus(0.0, k * (lateral_slope - secant), t)), held


@inlined
def on_a_plateau(curves, N, s, force, part):
    """Whether a friction force is at least a part of what either curve ends at."""
    along = abs(dot(force, s))
    across = math.sqrt(max(dot(force, force) - along * along, 0.0))
    axial, lateral = curves.y[curves.ptr[1] - 1], curves.y[curves.ptr[2] - 1]
    return along >= part * N * axial or across >= part * N * lateral
