"""The dense system of the free points of an island, from the condensed ends of its lines."""

from __future__ import annotations

from moorage._jit import inlined, kernel
from moorage._vec3 import get, sym_get
from moorage.layout import line_nodes, point_row
from moorage.physics.point import point_terms


@kernel
def solve_junctions(system, state, work, island, c):
    """Solve for the increments of the free points of an island."""
    lines, islands = system.lines, system.islands
    p0, p1 = islands.point_ptr[island], islands.point_ptr[island + 1]
    size = 3 * (p1 - p0)
    base = islands.matrix_ptr[island]
    A, b = work.junction_matrix[base : base + size * size], work.junction_force[3 * p0 : 3 * p1]
    for k in range(size * size):
        A[k] = 0.0
    for p in range(p0, p1):
        point = islands.points[p]
        row = point_row(lines, point)
        r, v, a = get(state.position, row), get(state.velocity, row), get(state.acceleration, row)
        force, block = point_terms(system.points, system.current, point, r, v, a, c)
        at = 3 * (p - p0)
        b[at], b[at + 1], b[at + 2] = force
        add_symmetric(A, size, at, block)
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        add_line(lines, work, A, b, size, islands.lines[k])
    solve_dense(A, b, size)
    for p in range(p0, p1):
        row = point_row(lines, islands.points[p])
        for x in range(3):
            work.increment[row, x] = b[3 * (p - p0) + x]


@inlined
def add_symmetric(A, size, at, s):
    """Add a symmetric block on the diagonal."""
    index = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
    for i in range(3):
        for j in range(3):
            A[(at + i) * size + at + j] += s[index[i][j]]


@kernel
def add_line(lines, work, A, b, size, line):
    """Add the condensed blocks and forces of a line at those of its ends that are free."""
    first, last = line_nodes(lines, line)
    at_a, at_b = 3 * lines.end_unknown[line, 0], 3 * lines.end_unknown[line, 1]
    if at_a >= 0:
        add_symmetric(A, size, at_a, sym_get(work.blocks.own, first))
        for x in range(3):
            b[at_a + x] += work.force[first, x]
    if at_b >= 0:
        add_symmetric(A, size, at_b, sym_get(work.blocks.own, last))
        for x in range(3):
            b[at_b + x] += work.force[last, x]
    if at_a >= 0 and at_b >= 0:
        for i in range(3):
            for j in range(3):
                coupling = work.blocks.start[last, 3 * i + j]
                A[(at_b + i) * size + at_a + j] += coupling
                A[(at_a + j) * size + at_b + i] += coupling


@kernel
def solve_dense(A, b, n):
    """Gauss elimination with row pivoting, in place, of an n x n matrix stored row by row; b becomes the solution."""
    for k in range(n):
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
    for k in range(n - 1, -1, -1):
        for j in range(k + 1, n):
            b[k] -= A[k * n + j] * b[j]
        b[k] /= A[k * n + k]
