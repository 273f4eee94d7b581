"""Static equilibrium of an island with the same tangent: Newton with line search, continuation in pseudo time, descent.

Continuation is fast and fails for a line in some forty, mostly long slack ones in the surface or under a heavy clump.
Descent takes two to three times the iterations and does not: without bending and current the potential energy is
convex (a rope's grows with its length, the surface and the bed push back), so that it cannot go astray. A current is
raised afterwards, see `whole_jacobian`.
"""

from __future__ import annotations

from moorage._jit import kernel, part
from moorage._vec3 import dot, get, put
from moorage.layout import CARRIER, FLEXIBLE, Weights, line_nodes, point_row, put_memory
from moorage.physics.soil import FRESH
from moorage.solve.newton import assemble_island, largest_imbalance, shift, solve_island
from moorage.system.attach import attach
from moorage.system.ride import begin_turning


@part
def stop_island(lines, islands, state, island):
    """Set velocities and accelerations of an island to zero."""
    zero = (0.0, 0.0, 0.0)
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            put(state.velocity, i, zero)
            put(state.acceleration, i, zero)
            put(state.auxiliary, i, zero)
    for p in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        row = point_row(lines, islands.points[p])
        put(state.velocity, row, zero)
        put(state.acceleration, row, zero)
        put(state.auxiliary, row, zero)
    for k in range(2 * islands.object_ptr[island], 2 * islands.object_ptr[island + 1]):
        row = islands.objects[k // 2, 1] + k % 2
        put(state.velocity, row, zero)
        put(state.acceleration, row, zero)
        put(state.auxiliary, row, zero)


@part
def forget_soil(lines, islands, state, island):
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            put_memory(state, i, FRESH)


@kernel
def place_at_rest(system, state, work, island):
    """Attach an island's line ends at time 0, at rest, on soil that was never touched."""
    forget_soil(system.lines, system.islands, state, island)
    stop_island(system.lines, system.islands, state, island)
    attach(system, state, work, island, 0.0)
    stop_island(system.lines, system.islands, state, island)


@kernel
def stick_where_it_is(lines, islands, state, island):
    """Let friction hold the nodes of an island where they are, without force."""
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            put(state.stuck, i, get(state.position, i))


@kernel
def relax_island(system, state, work, island, reach, tolerance, iterations):
    """Find equilibrium. Returns (largest imbalance in N, its row, iterations, iterations damped by pseudo time).

    Plain Newton increments are tried first, shortened by a line search on the norm of the imbalance. Where they do not
    make it fall, S = M / tau^2 + K: a pseudo time tau that starts small, so that increments are damped, and grows while
    the imbalance falls. Increments never exceed `reach` (m), for then the tangent may be indefinite (bending, contact);
    tau shrinks whenever that happens.
    """
    place_at_rest(system, state, work, island)
    tau, before, damped = 1e3, 1e300, 0
    force, row = 1e300, -1
    for iteration in range(iterations):
        begin_turning(system.islands, state, island)
        c = Weights(1.0 / (tau * tau), 0.0, 1.0)
        assemble_island(system, state, state, work, island, c, 0.0)
        force, row, total = largest_imbalance(system, state, work, island, c)
        if force < tolerance or not force < 1e299:
            return force, row, iteration, damped
        assemble_island(system, state, state, work, island, c, 0.0)
        solve_island(system, state, work, island, c)
        longest, _ = shift(system, state, work, island, 0.0, 0.0, 0.0)
        if not longest < 1e100:
            tau = max(1e-3, 0.1 * tau)
            damped += 1
            continue
        step = min(1.0, reach / (longest + 1e-300))
        shift(system, state, work, island, step, 0.0, 0.0)
        if tau >= 1e3:
            # line search: a Newton increment of full length must make the imbalance fall, or pseudo time takes over
            taken, halvings = step, 0
            while halvings < 4:
                assemble_island(system, state, state, work, island, c, 0.0)
                _, _, trial = largest_imbalance(system, state, work, island, c)
                if trial < total:
                    break
                shift(system, state, work, island, -0.5 * taken, 0.0, 0.0)
                taken *= 0.5
                halvings += 1
            if halvings == 4:
                tau = 0.5
        else:
            growth = 0.5 if step < 1.0 else min(3.0, max(0.3, 1.3 * before / force))
            tau = min(1e3, max(1e-3, tau * growth))
            damped += 1
        before = force
    return force, row, iterations, damped


@kernel
def descend_island(system, state, work, island, reach, tolerance, iterations):
    """Find equilibrium by descent in potential energy; returns the same as `relax_island`, all iterations as damped.

    S = M / tau^2 + K is positive definite wherever K is not indefinite, so that its increments go downhill. A step is
    halved until it makes the imbalance fall, or does not end far up the other side of the valley: the work of the
    forces on the increment must not become less than minus half of what it was. tau shrinks where that takes much.
    """
    place_at_rest(system, state, work, island)
    tau, force, row = 1e3, 1e300, -1
    for iteration in range(iterations):
        begin_turning(system.islands, state, island)
        c = Weights(1.0 / (tau * tau), 0.0, 1.0)
        assemble_island(system, state, state, work, island, c, 0.0)
        force, row, total = largest_imbalance(system, state, work, island, c)
        if force < tolerance or not force < 1e299:
            return force, row, iteration, iteration
        solve_island(system, state, work, island, c)
        longest, _ = shift(system, state, work, island, 0.0, 0.0, 0.0)
        if not longest < 1e100:
            tau = max(1e-4, 0.1 * tau)
            continue
        assemble_island(system, state, state, work, island, c, 0.0)
        largest_imbalance(system, state, work, island, c)
        begin = work_done(system, work, island)
        taken, halvings = min(1.0, reach / (longest + 1e-300)), 0
        whole = taken == 1.0
        shift(system, state, work, island, taken, 0.0, 0.0)
        while halvings < 10:
            assemble_island(system, state, state, work, island, c, 0.0)
            _, _, trial = largest_imbalance(system, state, work, island, c)
            if trial < total or work_done(system, work, island) > -0.5 * begin:
                break
            taken *= 0.5
            shift(system, state, work, island, -taken, 0.0, 0.0)
            halvings += 1
        if halvings == 0 and whole:
            tau = min(1e3, 3.0 * tau)
        elif halvings >= 2:
            tau = max(1e-4, 0.5 * min(tau, 1.0))
    return force, row, iterations, iterations


@part
def work_done(system, work, island):
    """Work of the out-of-balance forces on the increment, J."""
    lines, islands, force, increment = system.lines, system.islands, work.force, work.increment
    total = 0.0
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        first, last = line_nodes(lines, line)
        if system.riders.lines[line, CARRIER] == FLEXIBLE:
            for i in range(first + 1, last):
                total += dot(get(force, i), get(increment, i))
    for p in range(islands.point_ptr[island] + islands.rides[island, 0], islands.point_ptr[island + 1]):
        row = point_row(lines, islands.points[p])
        total += dot(get(force, row), get(increment, row))
    for k in range(2 * islands.object_ptr[island], 2 * islands.object_ptr[island + 1]):
        row = islands.objects[k // 2, 1] + k % 2
        total += dot(get(force, row), get(increment, row))
    return total
