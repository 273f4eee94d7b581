"""The dense system of the free points, joints and objects of an island, from the condensed boundaries of its lines."""

from __future__ import annotations

from moorage._jit import inlined, part
from moorage._vec3 import get, mat_get, put, sym_get
from moorage.layout import CARRIER, FLEXIBLE, line_nodes, point_row, water_of
from moorage.physics.point import point_terms
from moorage.solve.fold import add_objects, move_riders
from moorage.system.attach import copy_free_ends


@part
def solve_junctions(system, state, work, island, c):
    """Solve for the increments of the unknowns of an island: free points, nodes beside joints and clamps, objects."""
    lines, islands = system.lines, system.islands
    u0, u1 = islands.unknown_ptr[island], islands.unknown_ptr[island + 1]
    if u1 == u0:
        return
    p0, p1 = islands.point_ptr[island], islands.point_ptr[island + 1]
    size = 3 * (u1 - u0)
    base = islands.matrix_ptr[island]
    A, b = work.junction_matrix[base : base + size * size], work.junction_force[3 * u0 : 3 * u1]
    for k in range(size * size):
        A[k] = 0.0
    for k in range(size):
        b[k] = 0.0
    for p in range(p0, p1):
        point = islands.points[p]
        row = point_row(lines, point)
        r, v, a = get(state.position, row), get(state.velocity, row), get(state.acceleration, row)
        force, block = point_terms(system.points, point, water_of(state, row), r, v, a, c)
        add_own(A, b, size, p - p0, block, force)
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        if system.riders.lines[islands.lines[k], CARRIER] == FLEXIBLE:
            add_line(lines, work, A, b, size, islands.lines[k])
    for m in range(islands.joint_ptr[island], islands.joint_ptr[island + 1]):
        line, end = system.joints.line[m], system.joints.end[m]
        i, j = lines.inner_unknown[line[1], end[1]], lines.inner_unknown[line[0], end[0]]
        add_coupling(A, size, i, j, mat_get(work.blocks.joint, m))
    if islands.object_ptr[island + 1] > islands.object_ptr[island]:
        add_objects(system, state, work, A, b, size, island, c)
    riders = islands.rides[island, 0]
    solve_dense(A, b, size, 3 * riders)
    for u in range(u0 + riders, u1):
        k = 3 * (u - u0)
        put(work.increment, islands.unknown_row[u], (b[k], b[k + 1], b[k + 2]))
    if islands.object_ptr[island + 1] > islands.object_ptr[island]:
        move_riders(lines, islands, system.riders, state, work.increment, island)
    copy_free_ends(lines, islands, island, work.increment)


@inlined
def add_own(A, b, size, unknown, s, f):
    """Add a symmetric block on the diagonal and a force."""
    index = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
    at = 3 * unknown
    for i in range(3):
        b[at + i] += f[i]
        for j in range(3):
            A[(at + i) * size + at + j] += s[index[i][j]]


@inlined
def add_coupling(A, size, row, column, m):
    """Add a general block and its transpose off the diagonal."""
    for i in range(3):
        for j in range(3):
            A[(3 * row + i) * size + 3 * column + j] += m[3 * i + j]
            A[(3 * column + j) * size + 3 * row + i] += m[3 * i + j]


@part
def add_line(lines, work, A, b, size, line):
    """Add the condensed blocks and forces of a line at its boundary."""
    S = work.blocks
    first, last = line_nodes(lines, line)
    a0, a1 = lines.end_unknown[line, 0], lines.inner_unknown[line, 0]
    b1, b0 = lines.inner_unknown[line, 1], lines.end_unknown[line, 1]
    if a0 >= 0:
        add_own(A, b, size, a0, sym_get(S.own, first), get(work.force, first))
        if b0 >= 0:
            add_coupling(A, size, b0, a0, mat_get(S.start, last))
        if b1 >= 0:
            add_coupling(A, size, b1, a0, mat_get(S.start, last - 1))
    if a1 >= 0:
        add_own(A, b, size, a1, sym_get(S.own, first + 1), get(work.force, first + 1))
        add_coupling(A, size, a1, a0, mat_get(S.next, first))
        if b0 >= 0:
            add_coupling(A, size, b0, a1, mat_get(S.inner, last))
        if b1 >= 0:
            add_coupling(A, size, b1, a1, mat_get(S.inner, last - 1))
    if b0 >= 0:
        add_own(A, b, size, b0, sym_get(S.own, last), get(work.force, last))
    if b1 >= 0:
        add_own(A, b, size, b1, sym_get(S.own, last - 1), get(work.force, last - 1))
        add_coupling(A, size, b0, b1, mat_get(S.next, last - 1))


@part
def solve_dense(A, b, n, begin):
    """Gauss elimination with row pivoting, in place, of an n x n matrix stored row by row; b becomes the solution.

    The unknowns before `begin` are left out.
    """
    for k in range(begin, n):
        best = k
        for i in range(k + 1, n):
            if abs(A[i * n + k]) > abs(A[best * n + k]):
                best = i
        if best != k:
            for j in range(k, n):
                A[k * n + j], A[best * n + j] = A[best * n + j], A[k * n + j]
            b[k], b[best] = b[best], b[k]
        for i in range(k + 1, n):
            m = A[i * n + k] / A[k * n + k]
            if m != 0.0:
                for j in range(k + 1, n):
                    A[i * n + j] -= m * A[k * n + j]
                b[i] -= m * b[k]
    for k in range(n - 1, begin - 1, -1):
        for j in range(k + 1, n):
            b[k] -= A[k * n + j] * b[j]
        b[k] /= A[k * n + k]
