"""Implicit time stepping: generalised-alpha in the collocated form of Arnold & Bruls (2007).

The equations of motion hold exactly at the end of each step; the auxiliary acceleration a carries the averaging:

    (1 - am) a1 + am a0 = (1 - af) acc1 + af acc0
    v1 = v0 + h ((1 - gamma) a0 + gamma a1),   r1 = r0 + h v0 + h^2 ((1/2 - beta) a0 + beta a1)
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, kernel, part
from moorage._vec3 import add, dot, get, mat_get, mat_put, put, scale, sub
from moorage.layout import BASE, Weights, line_nodes, memory_of, point_row, put_memory
from moorage.physics.contact import near_bed, penetration
from moorage.physics.friction import (
    ELASTIC,
    NONE,
    SOIL,
    STICK_SLIP,
    friction_terms,
    remembers,
    stuck_after,
    taken_by_damper,
)
from moorage.physics.rigid import SIZE
from moorage.physics.soil import remember
from moorage.solve.newton import assemble_island, newton_island, shift, solve_island
from moorage.system.attach import attach
from moorage.system.reel import reel
from moorage.system.ride import begin_turning


class Scheme(NamedTuple):
    """Coefficients of one step of length h."""

    h: float
    rr0: float  # r1 = r0 + h v0 + rr0 a0 + rr1 a1
    rr1: float
    vv0: float  # v1 = v0 + vv0 a0 + vv1 a1
    vv1: float
    new: float  # a1 = new acc1 + old acc0 + keep a0
    old: float
    keep: float
    per_rr1: float  # 1 / rr1: divisions are slow
    per_new: float


@inlined
def generalised_alpha(rho, h):
    """Coefficients for a spectral radius rho at infinite frequency."""
    am, af = (2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0)
    gamma, beta = 0.5 - am + af, 0.25 * (1.0 - am + af) ** 2
    f = 1.0 / (1.0 - am)
    rr1, new = beta * h * h, (1.0 - af) * f
    return Scheme(
        h, (0.5 - beta) * h * h, rr1, (1.0 - gamma) * h, gamma * h, new, af * f, -am * f, 1.0 / rr1, 1.0 / new
    )


@inlined
def predict_row(now, trial, i, k):
    """Set a row of the trial state as if the acceleration stayed what it is.

    Continuing its last change instead was measured and saves nothing.
    """
    acc, a0, v0 = get(now.acceleration, i), get(now.auxiliary, i), get(now.velocity, i)
    a1 = add(scale(k.new + k.old, acc), scale(k.keep, a0))
    r1 = add(add(get(now.position, i), scale(k.h, v0)), add(scale(k.rr0, a0), scale(k.rr1, a1)))
    put(trial.position, i, r1)
    put(trial.velocity, i, add(v0, add(scale(k.vv0, a0), scale(k.vv1, a1))))
    put(trial.acceleration, i, acc)


@part
def predict_objects(islands, now, trial, island, k):
    """Set the rows of the objects of an island in the trial state; their rotations count from now on."""
    begin_turning(islands, now, island)
    for m in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o, row = islands.objects[m, 0], islands.objects[m, 1]
        mat_put(trial.frames[BASE], o, mat_get(now.frames[BASE], o))
        predict_row(now, trial, row, k)
        predict_row(now, trial, row + 1, k)


@inlined
def stay_row(now, trial, i, k):
    """Set a row of the trial state where it is now: the guess for a node that friction holds.

    From outside the elastic range Newton's method may jump from slip one way to slip the other way, again and again.
    """
    a0, v0, r0 = get(now.auxiliary, i), get(now.velocity, i), get(now.position, i)
    a1 = scale(-k.per_rr1, add(scale(k.h, v0), scale(k.rr0, a0)))
    acc = sub(a1, add(scale(k.old, get(now.acceleration, i)), scale(k.keep, a0)))
    put(trial.position, i, r0)
    put(trial.velocity, i, add(v0, add(scale(k.vv0, a0), scale(k.vv1, a1))))
    put(trial.acceleration, i, scale(k.per_new, acc))


@inlined
def stayed(now, trial, i):
    """Whether friction held a node throughout the step between two states."""
    s, s0 = get(now.stuck, i), get(trial.stuck, i)
    return s[0] == s0[0] and s[1] == s0[1] and s[2] == s0[2]


@inlined
def finish_row(now, trial, i, k):
    """Set the auxiliary acceleration of a row; returns its change squared."""
    a0 = get(now.auxiliary, i)
    a1 = add(scale(k.new, get(trial.acceleration, i)), scale(k.old, get(now.acceleration, i)))
    a1 = add(a1, scale(k.keep, a0))
    put(trial.auxiliary, i, a1)
    return dot(sub(a1, a0), sub(a1, a0))


@inlined
def implicit_step(system, now, trial, work, island, t, h, control):
    """Try one step of an island from t to t + h.

    Returns (converged, iterations, change, row): rms change of the auxiliary acceleration (m/s2) over the island, and
    the row of the last largest increment. Nodes that friction holds throughout count as at rest: however they shake,
    springs keep them within millimetres.
    """
    lines, islands = system.lines, system.islands
    k = generalised_alpha(control.rho, h)
    c = Weights(1.0, k.vv1 * k.new, k.rr1 * k.new)
    soil = system.contact.soil.on
    rubs, fastest = system.friction.law != NONE or soil, 0.0
    springs = system.friction.law == ELASTIC or system.friction.law == SOIL
    l0, l1 = islands.line_ptr[island], islands.line_ptr[island + 1]
    p0, p1 = islands.point_ptr[island], islands.point_ptr[island + 1]
    for m in range(l0, l1):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            if rubs:
                fastest = max(fastest, dot(get(now.velocity, i), get(now.velocity, i)))
            if springs and stayed(now, trial, i):  # `trial` still has the start of the last step
                stay_row(now, trial, i, k)
            else:
                predict_row(now, trial, i, k)
    for p in range(p0, p1):
        predict_row(now, trial, point_row(lines, islands.points[p]), k)
    predict_objects(islands, now, trial, island, k)
    if len(system.winches.place) > 0:
        reel(system, island, t + h)
    attach(system, trial, work, island, t + h)
    enough = newton_stop(control.newton, system.friction.law, system.contact.soil.on, fastest)
    converged, iterations, row, largest, part = False, 0, -1, 1e300, 1.0
    while iterations < control.iterations:
        newton_island(system, trial, now, work, island, c, t + h)
        before = largest
        largest, row = shift(system, trial, work, island, c.stiffness, c.damping, 1.0)
        iterations += 1
        if not largest < 1e100:
            break
        if (
            c.damping * largest < enough
            and tension_left(control, island, c, largest) <= control.leftover[island]  # both 0 without lines
        ):
            converged = True
            break
        if (remembers(system.friction) or soil) and largest > 0.7 * before:
            # a node jumps from slip one way to slip the other way and back: where it sticks lies between
            part *= 0.5
            back = part - 1.0
            shift(system, trial, work, island, back * c.stiffness, back * c.damping, back)
    stick_island(system, now, trial, work.load, island, h)
    total, rows, sticks = 0.0, p1 - p0, remembers(system.friction)
    for m in range(l0, l1):
        first, last = line_nodes(lines, islands.lines[m])
        rows += last + 1 - first
        for i in range(first, last + 1):
            changed = finish_row(now, trial, i, k)
            if not (sticks and work.load[i, 0] < 0.0):
                total += changed
    for p in range(p0, p1):
        total += finish_row(now, trial, point_row(lines, islands.points[p]), k)
    for m in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        row = islands.objects[m, 1]
        size = system.rigid.table[islands.objects[m, 0], SIZE]
        total += finish_row(now, trial, row, k) + size * size * finish_row(now, trial, row + 1, k)
        rows += 1
    return converged, iterations, math.sqrt(total / rows), row


@kernel
def stick_island(system, now, trial, load, island, h):
    """Set where friction holds the nodes of an island, what it took, and what the soil remembers, after a step of
    length h from `now` to `trial`.

    load: (rows, 4) N, under which the nodes rub, -1 where they surely stay, and is set to that where they do; and the
    normal of the bed, of the last iteration: looking it up again takes 3 % of a run. Friction of that iteration would
    not do for the energy: with saturated damping it is up to a fifth off.
    """
    rubs, sticks, soil = system.friction.law != NONE, remembers(system.friction), system.contact.soil
    if not (rubs or soil.on):
        return
    lines, islands, c = system.lines, system.islands, Weights(0.0, 0.0, 0.0)
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        first, last = line_nodes(lines, line)
        heat, power = 0.0, 0.0
        for i in range(first, last + 1):
            r, N = get(trial.position, i), load[i, 0]
            if N == 0.0 or not rubs:
                put(trial.stuck, i, r)
            else:
                n, node = (load[i, 1], load[i, 2], load[i, 3]), np.uintp(i)
                s, v = get(now.stuck, i), get(trial.velocity, i)
                place, lost = s, 0.0
                q = sub(get(trial.position, min(i + 1, last)), get(trial.position, max(i - 1, first)))
                if N < 0.0:
                    lost = taken_by_damper(system.friction, node, sub(v, scale(dot(v, n), n)), h)
                elif sticks:
                    place, lost = stuck_after(system.friction, node, N, n, q, r, v, s, h, c)
                    load[i, 0] = -1.0 if place == s else N
                else:
                    power -= dot(friction_terms(system.friction, node, N, n, q, r, v, r, c)[0], v)
                heat += lost
                put(trial.stuck, i, place)
            if soil.on:
                z = penetration(system.contact, r) if near_bed(system.contact, r, r) else 0.0
                put_memory(trial, i, remember(soil, np.uintp(i), memory_of(soil, now, i), z))
        trial.heat[line, 0] = now.heat[line, 0] + heat + 0.5 * h * (now.heat[line, 1] + power)
        trial.heat[line, 1] = power


@inlined
def newton_stop(newton, law, soil, fastest):
    """Velocity increment at which Newton's method stops, m/s; fastest: square of the largest speed in the island.

    With friction, or soil that remembers, what a stop leaves behind must be small beside the motion, or nodes at rest
    creep; where friction falls with the speed it must be small in any case, or the next steps find no solution.
    """
    if law == NONE and not soil:
        return newton
    return 0.04 * newton if law == STICK_SLIP else min(newton, max(0.04 * newton, 0.05 * math.sqrt(fastest)))


@inlined
def tension_left(control, island, c, largest):
    """Estimate the tension (N) that a Newton increment leaves behind: a segment of length l that it turns by p / l is
    stretched by p^2 / (2 l), which the tangent does not see."""
    stiff = c.stiffness * (c.stiffness * control.stretch[island, 0] + c.damping * control.stretch[island, 1])
    return stiff * largest * largest


@part
def set_accelerations(system, state, work, island, t):
    """Set the accelerations that balance the forces at time t: M a = f."""
    lines, islands = system.lines, system.islands
    c = Weights(1.0, 0.0, 0.0)
    l0, l1 = islands.line_ptr[island], islands.line_ptr[island + 1]
    p0, p1 = islands.point_ptr[island], islands.point_ptr[island + 1]
    for m in range(l0, l1):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            put(state.acceleration, i, (0.0, 0.0, 0.0))
    for p in range(p0, p1):
        put(state.acceleration, point_row(lines, islands.points[p]), (0.0, 0.0, 0.0))
    for m in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        put(state.acceleration, islands.objects[m, 1], (0.0, 0.0, 0.0))
        put(state.acceleration, islands.objects[m, 1] + 1, (0.0, 0.0, 0.0))
    if len(system.winches.place) > 0:
        reel(system, island, t)
    attach(system, state, work, island, t)
    assemble_island(system, state, state, work, island, c, t)
    solve_island(system, state, work, island, c)
    shift(system, state, work, island, 0.0, 0.0, 1.0)


@part
def start_island(system, state, work, island, t):
    """Set consistent accelerations, true and auxiliary, and what the soil remembers, at the start of a run."""
    lines, islands, soil = system.lines, system.islands, system.contact.soil
    set_accelerations(system, state, work, island, t)
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            put(state.auxiliary, i, get(state.acceleration, i))
            if soil.on:
                z = penetration(system.contact, get(state.position, i))
                put_memory(state, i, remember(soil, np.uintp(i), memory_of(soil, state, i), z))
    for p in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        row = point_row(lines, islands.points[p])
        put(state.auxiliary, row, get(state.acceleration, row))
    for m in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        row = islands.objects[m, 1]
        put(state.auxiliary, row, get(state.acceleration, row))
        put(state.auxiliary, row + 1, get(state.acceleration, row + 1))
