"""Static equilibrium by implicit steps down the potential energy, for islands where it is not convex.

Bending, clamps and floats make the tangent indefinite, so that single Newton increments may go anywhere. A step here is
solved to its end: M (x - x0) / tau^2 = f(x) is where V + M (x - x0)^2 / (2 tau^2) is least near x0, so that the energy
falls from step to step, whatever K is, while tau is short enough for M / tau^2 + K to be positive. It is the equation
of motion with accelerations (x - x0) / tau^2, for which the engine has forces and matrix. tau grows while Newton's
method finds the end of the step easily; a long step is Newton's method for the equilibrium itself.

Where even the shortest step has no end, slack segments of a stiff line have shrunk to nothing: bending does not mind
their length, and nothing else holds them.
"""

from __future__ import annotations

from moorage._jit import kernel, part
from moorage._vec3 import get, put, sym_get
from moorage.layout import CARRIER, FLEXIBLE, Weights, line_nodes, point_row
from moorage.solve.line_solve import interior
from moorage.solve.newton import assemble_island, largest_imbalance, shift, solve_island
from moorage.solve.statics_kernel import place_at_rest, stop_island, work_done
from moorage.system.attach import attach
from moorage.system.ride import begin_turning

SHORTEST, LONGEST = 1e-5, 1e3  # of tau, s
FARTHEST = 30.0  # an increment that is longer, in units of `reach`, ends a step
INNER = 12  # Newton iterations of a step
LEFT = 0.01  # of the imbalance at the start of a step, that its end may leave


@part
def copy_positions(lines, islands, island, source, target):
    """Copy the positions of an island."""
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            put(target, i, get(source, i))
    for p in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        row = point_row(lines, islands.points[p])
        put(target, row, get(source, row))
    for k in range(2 * islands.object_ptr[island], 2 * islands.object_ptr[island + 1]):
        row = islands.objects[k // 2, 1] + k % 2
        put(target, row, get(source, row))


@part
def is_positive(system, own, island):
    """Whether the matrix of an island is positive in the nodes that were eliminated; own: inverses of their pivots."""
    lines, islands = system.lines, system.islands
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        if system.riders.lines[line, CARRIER] != FLEXIBLE:
            continue
        begin, end = interior(lines, line)
        for i in range(begin, end):
            a, b, c, d, e, f = sym_get(own, i)
            minor = a * d - b * b
            if not (a > 0.0 and minor > 0.0 and f * minor + c * (b * e - c * d) - e * (a * e - b * c) > 0.0):
                return False
    return True


@part
def step_down(system, state, work, island, tau, reach, tolerance):
    """Take one implicit step from a state at rest; returns (whether its end was found, Newton iterations).

    Where it was not, the positions are somewhere else.
    """
    c = Weights(1.0 / (tau * tau), 0.0, 1.0)
    begin = 1e300
    for iteration in range(INNER + 1):
        assemble_island(system, state, state, work, island, c, 0.0)
        force, _, _ = largest_imbalance(system, state, work, island, c)
        if iteration == 0:
            begin = force
        elif force < max(0.05 * tolerance, LEFT * begin):
            return True, iteration
        if iteration == INNER or not force < 1e299:
            break
        solve_island(system, state, work, island, c)
        longest, _ = shift(system, state, work, island, 0.0, 0.0, 0.0)
        if not longest < FARTHEST * reach or not is_positive(system, work.blocks.own, island):
            return False, iteration + 1
        if iteration == 0:
            assemble_island(system, state, state, work, island, c, 0.0)
            largest_imbalance(system, state, work, island, c)
            if not work_done(system, work, island) > 0.0:  # uphill
                return False, 1
        shift(system, state, work, island, 1.0, 0.0, c.mass)
    return False, INNER


@kernel
def imbalance(system, state, work, island):
    """Largest out-of-balance force of an island (N), its row, and the sum of the squared forces."""
    c = Weights(0.0, 0.0, 1.0)
    assemble_island(system, state, state, work, island, c, 0.0)
    return largest_imbalance(system, state, work, island, c)


@kernel
def flow_island(system, state, work, island, reach, tolerance, iterations):
    """Find equilibrium by implicit steps; returns the same as `relax_island`, all iterations as damped."""
    lines, islands, start = system.lines, system.islands, work.trial.position
    place_at_rest(system, state, work, island)
    tau, used = 0.1, 0
    while True:
        stop_island(lines, islands, state, island)
        begin_turning(islands, state, island)
        force, row, _ = imbalance(system, state, work, island)
        if force < tolerance or not force < 1e299 or used >= iterations:
            return force, row, used, used
        copy_positions(lines, islands, island, state.position, start)
        found, n = step_down(system, state, work, island, tau, reach, tolerance)
        used += n
        if found:
            tau = min(LONGEST, tau * (2.0 if n <= 4 else 1.2))
            continue
        copy_positions(lines, islands, island, start, state.position)
        stop_island(lines, islands, state, island)
        attach(system, state, work, island, 0.0)
        tau *= 0.35
        if tau < SHORTEST:
            return force, row, used, used
