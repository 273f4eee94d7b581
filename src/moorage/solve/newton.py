"""One exact Newton increment of an island: assemble its lines, condense, solve the junctions, substitute back."""

from __future__ import annotations

import math

from moorage._jit import inlined, kernel, part
from moorage._vec3 import accumulate, add, dot, get, put, scale
from moorage.layout import CARRIER, FLEXIBLE, line_nodes, point_row, water_of
from moorage.physics.point import point_terms
from moorage.physics.rigid import SIZE
from moorage.solve.fold import load_objects
from moorage.solve.junction import solve_junctions
from moorage.solve.line_solve import assemble_and_reduce, back_substitute, reduce_line, substitute
from moorage.system.assemble import add_joints, assemble_line
from moorage.system.attach import settle
from moorage.system.reel import add_winches
from moorage.system.water import set_water


@kernel
def assemble_island(system, state, start, work, island, c, t):
    """Set the water at time t, the out-of-balance force and the blocks of all lines of an island."""
    set_water(system.lines, system.islands, system.sea, system.current, work.table, state, island, t)
    islands = system.islands
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        assemble_line(system, state, start, work, islands.lines[k], c)
    add_joints(system, state, work, island, c)
    if len(system.winches.place) > 0:
        add_winches(system, state, work.force, island)


@inlined
def newton_island(system, state, start, work, island, c, t):
    """Assemble and solve S x = force for an island at time t, in as few walks as its lines allow."""
    set_water(system.lines, system.islands, system.sea, system.current, work.table, state, island, t)
    lines, islands = system.lines, system.islands
    l0, l1 = islands.line_ptr[island], islands.line_ptr[island + 1]
    for k in range(l0, l1):
        line = islands.lines[k]
        first, last = line_nodes(lines, line)
        put(work.increment, first, (0.0, 0.0, 0.0))
        put(work.increment, last, (0.0, 0.0, 0.0))
        if walks_once(system, line):
            assemble_and_reduce(system, state, start, work, line, c)
        else:
            assemble_line(system, state, start, work, line, c)
    solve_boundary(system, state, work, island, c)
    for k in range(l0, l1):
        line = islands.lines[k]
        if walks_once(system, line):
            substitute(lines, work, line)
        elif system.riders.lines[line, CARRIER] == FLEXIBLE:
            back_substitute(lines, work, line, lines.end_unknown[line, 0] >= 0)


@inlined
def solve_boundary(system, state, work, island, c):
    """Add joints and winches, reduce the lines that are not yet, and solve the junction system."""
    lines, islands = system.lines, system.islands
    add_joints(system, state, work, island, c)
    if len(system.winches.place) > 0:
        add_winches(system, state, work.force, island)
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[k]
        if not walks_once(system, line) and system.riders.lines[line, CARRIER] == FLEXIBLE:
            reduce_line(lines, work, line, lines.end_unknown[line, 0] >= 0)
    solve_junctions(system, state, work, island, c)


@inlined
def walks_once(system, line):
    """Whether a line's matrix is block tridiagonal with a prescribed end A."""
    lines = system.lines
    return lines.end_unknown[line, 0] < 0 and not lines.bends[line] and system.riders.lines[line, CARRIER] == FLEXIBLE


@part
def solve_island(system, state, work, island, c):
    """Solve S x = force for an island; prescribed ends do not move. Overwrites force and blocks."""
    lines, islands = system.lines, system.islands
    l0, l1 = islands.line_ptr[island], islands.line_ptr[island + 1]
    for k in range(l0, l1):
        line = islands.lines[k]
        first, last = line_nodes(lines, line)
        put(work.increment, first, (0.0, 0.0, 0.0))
        put(work.increment, last, (0.0, 0.0, 0.0))
        if system.riders.lines[line, CARRIER] == FLEXIBLE:
            reduce_line(lines, work, line, lines.end_unknown[line, 0] >= 0)
    solve_junctions(system, state, work, island, c)
    for k in range(l0, l1):
        line = islands.lines[k]
        if system.riders.lines[line, CARRIER] == FLEXIBLE:
            back_substitute(lines, work, line, lines.end_unknown[line, 0] >= 0)


@kernel
def largest_imbalance(system, state, work, island, c):
    """Largest force on an interior node, a free point or an object of an assembled island, N, and its row.

    NaN counts as infinite. Also returns the sum of the squared forces. Leaves the forces on points and objects in
    `work.force`.
    """
    lines, islands = system.lines, system.islands
    p0, p1 = islands.point_ptr[island], islands.point_ptr[island + 1]
    for p in range(p0, p1):
        point = islands.points[p]
        row = point_row(lines, point)
        r, v, a = get(state.position, row), get(state.velocity, row), get(state.acceleration, row)
        put(work.force, row, point_terms(system.points, point, water_of(state, row), r, v, a, c)[0])
    worst, where, total = 0.0, -1, 0.0
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[k]
        first, last = line_nodes(lines, line)
        if system.riders.lines[line, CARRIER] != FLEXIBLE:
            continue
        for end in range(2):
            if lines.end_unknown[line, end] >= 0:
                row = point_row(lines, lines.end_point[line, end])
                accumulate(work.force, row, get(work.force, first if end == 0 else last))
        for i in range(first + 1, last):
            size = dot(get(work.force, i), get(work.force, i))
            total += size
            if not size <= worst:
                worst, where = size, i
    for p in range(p0 + islands.rides[island, 0], p1):
        row = point_row(lines, islands.points[p])
        size = dot(get(work.force, row), get(work.force, row))
        total += size
        if not size <= worst:
            worst, where = size, row
    if islands.object_ptr[island + 1] > islands.object_ptr[island]:
        load_objects(system, state, work, island, c)
        for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
            row = islands.objects[k, 1]
            turn = scale(1.0 / system.rigid.table[islands.objects[k, 0], SIZE], get(work.force, row + 1))
            size = dot(get(work.force, row), get(work.force, row)) + dot(turn, turn)
            total += size
            if not size <= worst:
                worst, where = size, row
    if not total < 1e300:
        worst = 1e300
    return math.sqrt(worst), where, total


@inlined
def shift(system, state, work, island, on_position, on_velocity, on_acceleration):
    """Add multiples of the increment to an island's state, and let riders follow.

    Returns the size of the largest increment and its row; infinity when one is not a number.
    """
    lines, islands = system.lines, system.islands
    largest, where, total = 0.0, -1, 0.0
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[k])
        for i in range(first, last + 1):
            size = shift_row(state, work.increment, i, on_position, on_velocity, on_acceleration)
            total += size
            if not size <= largest:
                largest, where = size, i
    for p in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        row = point_row(lines, islands.points[p])
        size = shift_row(state, work.increment, row, on_position, on_velocity, on_acceleration)
        total += size
        if not size <= largest:
            largest, where = size, row
    for k in range(2 * islands.object_ptr[island], 2 * islands.object_ptr[island + 1]):
        row = islands.objects[k // 2, 1] + k % 2
        size = shift_row(state, work.increment, row, on_position, on_velocity, on_acceleration)
        size *= system.rigid.table[islands.objects[k // 2, 0], SIZE] ** 2 if k % 2 else 1.0
        total += size
        if not size <= largest:
            largest, where = size, row
    if islands.rides[island, 1]:
        settle(system, state, work, island)
    if not total < 1e300:
        largest = 1e300
    return math.sqrt(largest), where


@inlined
def shift_row(state, increment, i, on_position, on_velocity, on_acceleration):
    """Shift one row; returns the squared size of its increment."""
    x = get(increment, i)
    put(state.position, i, add(get(state.position, i), scale(on_position, x)))
    put(state.velocity, i, add(get(state.velocity, i), scale(on_velocity, x)))
    put(state.acceleration, i, add(get(state.acceleration, i), scale(on_acceleration, x)))
    return dot(x, x)
