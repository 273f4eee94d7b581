"""Elimination of the interior of a line, S x = f, in O(N) with 3x3 blocks.

The matrix couples a node to the next one (and with bending to the one after). Nodes begin .. end-1 are eliminated
upwards; each pivot is replaced by its inverse, and what remains is the small dense system of the boundary:

    nodes first (and first+1 beside a joint) with the fill-in columns `start` (and `inner`), if end A is free,
    nodes last (and last-1 beside a joint).
"""

from __future__ import annotations

from moorage._jit import inlined, part
from moorage._vec3 import (
    get,
    mat_get,
    mat_mat,
    mat_mat_t,
    mat_mat_t_sym,
    mat_put,
    mat_sub,
    mat_sym,
    mat_sym_sym,
    mat_t_mat,
    mat_t_mat_sym,
    mat_t_times,
    mat_times,
    put,
    sub,
    sym_get,
    sym_inverse,
    sym_mat,
    sym_put,
    sym_sub,
    sym_sym,
    sym_times,
    sym_to_general,
)
from moorage.layout import line_nodes
from moorage.system.assemble import begin_walk, walk

ZERO9 = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@inlined
def interior(lines, line):
    """First node of a line to eliminate, and the one after the last."""
    first, last = line_nodes(lines, line)
    begin = first + 2 if lines.inner_unknown[line, 0] >= 0 else first + 1
    end = last - 1 if lines.inner_unknown[line, 1] >= 0 else last
    return begin, end


@part
def reduce_line(lines, work, line, start_is_free):
    """Eliminate the interior of a line; leave the condensed blocks and forces at its boundary."""
    first, last = line_nodes(lines, line)
    begin, end = interior(lines, line)
    if lines.bends[line]:
        eliminate_pentadiagonal(work.blocks, work.force, begin, end, last)
    else:
        eliminate_tridiagonal(work.blocks, work.force, begin, end)
    if start_is_free:
        condense_start(work.blocks, work.force, first, begin, end, last)


@inlined
def eliminate_tridiagonal(S, force, begin, end):
    D, f = sym_get(S.own, begin), get(force, begin)
    for i in range(begin, end):
        inverse = sym_inverse(D)
        E = mat_get(S.next, i)
        P = mat_sym(E, inverse)
        sym_put(S.own, i, inverse)
        put(force, i, f)
        D = sym_sub(sym_get(S.own, i + 1), mat_mat_t_sym(P, E))
        f = sub(get(force, i + 1), mat_times(P, f))
    sym_put(S.own, end, D)
    put(force, end, f)


@inlined
def eliminate_pentadiagonal(S, force, begin, end, last):
    """D, E, f of node i and D1, f1 of node i+1 are carried along, already reduced by the nodes before.

    Beyond the last node the couplings are zero, so that what is read there has no part in the result.
    """
    D, E, f = sym_get(S.own, begin), mat_get(S.next, begin), get(force, begin)
    D1, f1 = sym_get(S.own, begin + 1), get(force, begin + 1)
    for i in range(begin, end):
        inverse = sym_inverse(D)
        F = mat_get(S.skip, i)
        P, Q = mat_sym(E, inverse), mat_sym(F, inverse)
        sym_put(S.own, i, inverse)
        mat_put(S.next, i, E)
        put(force, i, f)
        D = sym_sub(D1, mat_mat_t_sym(P, E))
        E = mat_sub(mat_get(S.next, i + 1), mat_mat_t(Q, E))
        D1 = sym_sub(sym_get(S.own, i + 2), mat_mat_t_sym(Q, F))
        f, f1 = sub(f1, mat_times(P, f)), sub(get(force, i + 2), mat_times(Q, f))
    sym_put(S.own, end, D)
    put(force, end, f)
    if end < last:
        mat_put(S.next, end, E)
        sym_put(S.own, end + 1, D1)
        put(force, end + 1, f1)


@part
def condense_start(S, force, first, begin, end, last):
    """Carry the columns of the boundary nodes at end A through the elimination, as more right-hand sides."""
    for i in range(begin, last + 1):
        mat_put(S.start, i, ZERO9)
        mat_put(S.inner, i, ZERO9)
    beside = begin == first + 2
    if beside:
        mat_put(S.start, begin, mat_get(S.skip, first))
        mat_put(S.inner, begin, mat_get(S.next, first + 1))
        if begin < last:
            mat_put(S.inner, begin + 1, mat_get(S.skip, first + 1))
    else:
        mat_put(S.start, begin, mat_get(S.next, first))
        if begin < last:
            mat_put(S.start, begin + 1, mat_get(S.skip, first))
    for i in range(begin, end):
        inverse, E, F = sym_get(S.own, i), mat_get(S.next, i), mat_get(S.skip, i)
        f, G = get(force, i), mat_get(S.start, i)
        W = sym_mat(inverse, G)
        sym_put(S.own, first, sym_sub(sym_get(S.own, first), mat_t_mat_sym(G, W)))
        put(force, first, sub(get(force, first), mat_t_times(W, f)))
        carry_column(S.start, i, E, F, W, last)
        if beside:
            H = mat_get(S.inner, i)
            V = sym_mat(inverse, H)
            sym_put(S.own, first + 1, sym_sub(sym_get(S.own, first + 1), mat_t_mat_sym(H, V)))
            put(force, first + 1, sub(get(force, first + 1), mat_t_times(V, f)))
            mat_put(S.next, first, mat_sub(mat_get(S.next, first), mat_t_mat(H, W)))
            carry_column(S.inner, i, E, F, V, last)


@inlined
def carry_column(column, i, E, F, W, last):
    """Take node i, eliminated, out of the rows of the two nodes after it."""
    mat_put(column, i + 1, mat_sub(mat_get(column, i + 1), mat_mat(E, W)))
    if i + 2 <= last:
        mat_put(column, i + 2, mat_sub(mat_get(column, i + 2), mat_mat(F, W)))


@part
def back_substitute(lines, work, line, start_is_free):
    """Fill the increments of the interior; those of the boundary are known."""
    first, last = line_nodes(lines, line)
    begin, end = interior(lines, line)
    S, force, x = work.blocks, work.force, work.increment
    bends, beside = lines.bends[line], begin == first + 2
    x0, x1, x2 = get(x, first), get(x, end), get(x, end + 1) if end < last else (0.0, 0.0, 0.0)
    for i in range(end - 1, begin - 1, -1):
        f = sub(get(force, i), mat_t_times(mat_get(S.next, i), x1))
        if bends:
            f = sub(f, mat_t_times(mat_get(S.skip, i), x2))
        if start_is_free:
            f = sub(f, mat_times(mat_get(S.start, i), x0))
            if beside:
                f = sub(f, mat_times(mat_get(S.inner, i), get(x, first + 1)))
        x1, x2 = sym_times(sym_get(S.own, i), f), x1
        put(x, i, x1)


@inlined
def assemble_and_reduce(system, state, start, work, line, c):
    """Do the work of `assemble_line` and `eliminate_tridiagonal` in one walk, for a line that does not bend.

    Elimination waits for the result of the node before, assembly does not: side by side the processor does both at
    once. Leaves inverse times force in `force` and P = S[i+1, i] inverse in `next`, all that `substitute` needs.
    """
    first, last = line_nodes(system.lines, line)
    own, next = work.blocks.own, work.blocks.next
    carried = begin_walk(system.lines, state.position, line)
    f, D, E = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for i in range(first, last + 1):  # one call of `walk`, because it is inlined and long
        f1, D1, E1, carried = walk(system, state, start, work.load, line, i, last, carried, c)
        if i > first + 1:
            inverse = sym_inverse(D)
            P = sym_sym(E, inverse)
            put(work.force, i - 1, sym_times(inverse, f))
            mat_put(next, i - 1, P)
            D1 = sym_sub(D1, mat_sym_sym(P, E))
            f1 = sub(f1, mat_times(P, f))
        elif i == first:
            put(work.force, first, f1)
            sym_put(own, first, D1)
            mat_put(next, first, sym_to_general(E1))
        f, D, E = f1, D1, E1
    sym_put(own, last, D)
    put(work.force, last, f)


@inlined
def substitute(lines, work, line):
    """Fill the increments of the interior after `assemble_and_reduce`; that of the last node is known."""
    first, last = line_nodes(lines, line)
    x = get(work.increment, last)
    for i in range(last - 1, first, -1):
        x = sub(get(work.force, i), mat_t_times(mat_get(work.blocks.next, i), x))
        put(work.increment, i, x)
