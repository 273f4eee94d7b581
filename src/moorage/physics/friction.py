"""Friction of the seabed on a node: force along the bed, axial and transverse to the line.

With N the size of the normal force, w the part of the velocity along the bed, split along and across the line:

* saturated damping (Housner et al. 2022, equations 5-13): each part is -slope w while that is below mu_s N, and mu_k N
  above it. The drop from mu_s to mu_k is spread over a tenth of the velocity at which it comes.
* velocity-dependent (after Lee et al. 2018): the coefficient rises smoothly to mu_s at the stick velocity, and falls
  smoothly to mu_k at ten times that.
* elastic slip (OrcaFlex's kind) and stick-slip (after Choi & Yoo 2012): a node remembers where it stuck; a spring k_s
  holds it there up to the ellipse (F_a / mu_a N)^2 + (F_t / mu_t N)^2 = 1, where it slips and takes the place along. A
  step is a return mapping: the spring's trial force is scaled back onto the ellipse, so that in steady sliding friction
  opposes the velocity with mu = 1 / sqrt(cos^2 / mu_a^2 + sin^2 / mu_t^2). A damper beside the spring keeps nodes that
  stick from ringing. Stick-slip lets the coefficients fall from static to kinetic with the speed,
  mu = mu_k + (mu_s - mu_k) / (1 + (w / v_s)^2).

* soil curves: the same memory, with curves of the force in place of the spring and the ellipse (soil_curves.py).

Coefficients may come from a map over x and y, at the place of the node.

The blocks leave out how friction changes with the normal force, and along a map.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage._vec3 import add, dot, isotropic_plus, scale, sub, sym_add, sym_scale
from moorage.physics.grid import Grid, values_at
from moorage.physics.soil_curves import soil_terms
from moorage.physics.table import Tables

NONE, SATURATED, VELOCITY, ELASTIC, STICK_SLIP, SOIL = 0, 1, 2, 3, 4, 5
ZERO3 = (0.0, 0.0, 0.0)
FAR = 4.0  # share that means: the load is far inside the ellipse


class Friction(NamedTuple):
    """Parameters."""

    law: int
    axial: float  # kinetic coefficient along the line; 1 with a map
    transverse: float  # and across it
    ratio: float  # static over kinetic
    slope: float  # of saturated damping, N s/m a node and unit of the coefficient
    velocity: float  # v_s of the laws that fall with speed, m/s
    spring: np.ndarray  # (nodes,) k_s, N/m
    damper: np.ndarray  # (nodes,) beside the spring, N s/m
    laid: bool  # statics know friction
    map: Grid  # kinetic coefficients along and across the line; no points: the same everywhere
    curves: Tables  # mobilised coefficients along and across the line over displacement, m; of soil curves only


@inlined
def remembers(p):
    """Whether the law needs the place where a node stuck."""
    return p.law >= ELASTIC


@inlined
def direction_along(q, n):
    """Part of q in the plane of the bed and its square, or zero and one where the line stands on the bed."""
    t = sub(q, scale(dot(q, n), n))
    size = dot(t, t)
    return (t, size) if size > 1e-6 * dot(q, q) else (ZERO3, 1.0)


@inlined
def split_directions(q, n):
    """Unit vector along the line in the plane of the bed; zero where the line stands on the bed."""
    t, size = direction_along(q, n)
    return scale(1.0 / math.sqrt(size), t)


@inlined
def friction_terms(p, i, N, n, q, r, v, stuck, c):
    """Friction on node i with normal force N (N), its block, and whether it is held far inside the ellipse.

    stuck: where it stuck before the step, m.
    """
    mu = coefficients(p, r)
    w = sub(v, scale(dot(v, n), n))
    if p.law == SATURATED and p.slope * p.slope * dot(w, w) <= p.ratio * p.ratio * N * N:
        force, block = damped(p, mu, n, q, w, c)
        return force, block, False
    if p.law <= VELOCITY:
        force, block = sliding(p, mu, N, n, split_directions(q, n), w, c)
        return force, block, False
    if p.law == SOIL:
        force, block, _ = soil_terms(p.curves, N, n, split_directions(q, n), way_along(n, r, stuck), c)
        return force, block, False
    trial = trial_force(p, i, n, v, r, stuck)
    share = share_given(p, mu, N, n, q, w, trial)
    spring = c.stiffness * p.spring[i] + c.damping * p.damper[i]
    if share >= 1.0:
        return trial, plane_block(spring, n), share == FAR
    slips = math.sqrt(share)
    # the derivative is k / o (1 - F g), g the gradient of the load; this has its diagonal along and across the line
    t, size = direction_along(q, n)
    along = scale(dot(trial, t) / size, t)
    e = add(scale(1.0 / (mu[0] + 1e-300), along), scale(1.0 / (mu[1] + 1e-300), sub(trial, along)))
    block = sym_add(plane_block(spring * slips, n), isotropic_plus(0.0, -spring * slips / dot(e, e), e))
    return scale(slips, trial), block, False


@inlined
def trial_force(p, i, n, v, r, stuck):
    """Force along the bed of the spring, and damper, that hold node i at the place where it stuck."""
    f = add(scale(p.spring[i], sub(r, stuck)), scale(p.damper[i], v))
    return sub(scale(dot(f, n), n), f)


@inlined
def way_along(n, r, stuck):
    """Way along the bed from where a node stuck, m."""
    d = sub(r, stuck)
    return sub(d, scale(dot(d, n), n))


@inlined
def stuck_after(p, i, N, n, q, r, v, stuck, h, c):
    """Where a node sticks after a step of length h: where it did, or after slipping where its spring gives the
    friction; and the energy that slip and damper took, J: the work of friction less what the spring stores of it.

    q: along the line, of any length.
    """
    if p.law == SOIL:
        d = way_along(n, r, stuck)
        force, _, held = soil_terms(p.curves, N, n, split_directions(q, n), d, c)
        lost = sub(d, held)
        return (stuck, 0.0) if dot(lost, lost) < 1e-24 else (sub(r, held), -dot(force, lost))
    w = sub(v, scale(dot(v, n), n))
    trial = trial_force(p, i, n, v, r, stuck)
    share = share_given(p, coefficients(p, r), N, n, q, w, trial)
    damped = taken_by_damper(p, i, w, h)
    if share >= 1.0:
        return stuck, damped
    # the spring keeps its share of the force, not what the damper gave: it would drive the node on when that slows down
    slips, way = math.sqrt(share), way_along(n, r, stuck)
    return sub(r, scale(slips, way)), slips * ((1.0 - slips) * p.spring[i] * dot(way, way) + damped)


@inlined
def taken_by_damper(p, i, w, h):
    """Energy (J) that the damper beside the spring takes in a step of length h, with the velocity w along the bed."""
    return h * p.damper[i] * dot(w, w)


@inlined
def coefficients(p, r):
    """Kinetic coefficients along and across a line at r."""
    if len(p.map.x.at) == 0:
        return p.axial, p.transverse
    axial, transverse = values_at(p.map, r[0], r[1])
    return p.axial * axial, p.transverse * transverse


@inlined
def share_given(p, mu, N, n, q, w, force):
    """Square of the part of a force that the ellipse of friction gives; one and more sticks.

    q: along the line, of any length. Far inside the ellipse, where most nodes are, a bound will do. Otherwise one
    division must do, because nodes that slip wait for it.
    """
    size, least = dot(force, force), N * min(mu[0], mu[1])
    if size <= 0.5 * least * least:
        return FAR
    if p.law == STICK_SLIP:
        fall = dot(w, w) / (p.velocity * p.velocity)
        N *= 1.0 + (p.ratio - 1.0) / (1.0 + fall)
    t, tt = direction_along(q, n)
    along = dot(force, t)
    across = max(size * tt - along * along, 0.0)  # both times |t|^2
    a, b = N * N * mu[0] * mu[0] + 1e-200, N * N * mu[1] * mu[1] + 1e-200
    return tt * a * b / (along * along * b + across * a + 1e-300)


@inlined
def plane_block(stiffness, n):
    """Stiffness in the plane of the bed."""
    return isotropic_plus(stiffness, -stiffness, n)


@inlined
def damped(p, mu, n, q, w, c):
    """Saturated damping of what is slower than its limit along and across the line, as nearly all nodes are."""
    t, size = direction_along(q, n)
    more = (mu[0] - mu[1]) / size
    force = scale(-p.slope, add(scale(mu[1], w), scale(more * dot(w, t), t)))
    k = c.damping * p.slope
    return force, sym_add(plane_block(k * mu[1], n), isotropic_plus(0.0, k * more, t))


@inlined
def sliding(p, mu, N, n, s, w, c):
    """Laws of the velocity alone: axial and transverse parts apart."""
    wa = dot(w, s)
    wt = sub(w, scale(wa, s))
    speed = math.sqrt(dot(wt, wt))
    fa, da = resistance(p, N, mu[0], p.slope * mu[0], abs(wa))
    ft, dt = resistance(p, N, mu[1], p.slope * mu[1], speed)
    over_a, over_t = fa / (abs(wa) + 1e-12), ft / (speed + 1e-12)
    force = add(scale(-over_a * wa, s), scale(-over_t, wt))
    across = sub_plane(n, s)
    block = add_parts(c.damping * max(da, 0.0), s, c.damping * over_t, across)
    fall = c.damping * (max(dt, 0.0) - over_t) / (speed * speed + 1e-24)
    return force, sym_add(block, isotropic_plus(0.0, fall, wt))


@inlined
def sub_plane(n, s):
    """Projector onto the direction across the line in the plane of the bed."""
    plane = isotropic_plus(1.0, -1.0, n)
    return sym_add(plane, isotropic_plus(0.0, -1.0, s))


@inlined
def add_parts(a, s, b, across):
    """a s s^T + b P."""
    return sym_add(isotropic_plus(0.0, a, s), sym_scale(b, across))


@inlined
def resistance(p, N, mu, slope, speed):
    """Friction (N) at a speed (m/s) and its derivative."""
    kinetic, static = mu * N, p.ratio * mu * N
    if p.law == SATURATED:
        if slope * speed <= static:
            return slope * speed, slope
        edge = static / (slope + 1e-300)
        part = (speed - edge) / (0.1 * edge + 1e-300)
        if part < 1.0:
            return static + part * (kinetic - static), (kinetic - static) / (0.1 * edge + 1e-300)
        return kinetic, 0.0
    x = speed / p.velocity
    if x < 1.0:
        return static * x * (1.5 - 0.5 * x * x), static / p.velocity * 1.5 * (1.0 - x * x)
    y = (x - 1.0) / 9.0
    if y < 1.0:
        fall = y * y * (3.0 - 2.0 * y)
        return static + (kinetic - static) * fall, (kinetic - static) * 6.0 * y * (1.0 - y) / (9.0 * p.velocity)
    return kinetic, 0.0
