"""Elimination of the interior of a line, S x = f, in O(N) with 3x3 blocks.

The matrix couples a node to the next one (and with bending to the one after). Nodes first+1 .. last-1 are eliminated
upwards; each pivot is replaced by its inverse, and what remains is the small dense system of the two end nodes:

    [ own[first]   start[last]^T ] [x_first]   [f_first]
    [ start[last]  own[last]     ] [x_last ] = [f_last ]      (first row only if end A is free)
"""

from moorage._jit import inlined, kernel
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
    mat_t_times,
    mat_times,
    put,
    sub,
    sym_get,
    sym_inverse,
    sym_put,
    sym_sub,
    sym_sym,
    sym_times,
    sym_to_general,
)  # fmt: skip
from moorage.layout import line_nodes
from moorage.system.assemble import begin_walk, walk


@kernel
def reduce_line(lines, work, line, start_is_free):
    """Eliminate the interior of a line; leave the condensed blocks and forces at its ends."""
    first, last = line_nodes(lines, line)
    bends = lines.bends[line] and last - first > 1
    if bends:
        eliminate_pentadiagonal(work.blocks, work.force, first, last)
    else:
        eliminate_tridiagonal(work.blocks, work.force, first, last)
    if start_is_free:
        condense_start(work.blocks, work.force, first, last, bends)


@kernel
def eliminate_tridiagonal(S, force, first, last):
    D, f = sym_get(S.own, first + 1), get(force, first + 1)
    for i in range(first + 1, last):
        inverse = sym_inverse(D)
        E = mat_get(S.next, i)
        P = mat_sym(E, inverse)
        sym_put(S.own, i, inverse)
        put(force, i, f)
        D = sym_sub(sym_get(S.own, i + 1), mat_mat_t_sym(P, E))
        f = sub(get(force, i + 1), mat_times(P, f))
    sym_put(S.own, last, D)
    put(force, last, f)


@kernel
def eliminate_pentadiagonal(S, force, first, last):
    """D, E, f of node i and D1, f1 of node i+1 are carried along, already reduced by the nodes before."""
    D, E, f = sym_get(S.own, first + 1), mat_get(S.next, first + 1), get(force, first + 1)
    D1, f1 = sym_get(S.own, first + 2), get(force, first + 2)
    for i in range(first + 1, last - 1):
        inverse = sym_inverse(D)
        F = mat_get(S.skip, i)
        P, Q = mat_sym(E, inverse), mat_sym(F, inverse)
        sym_put(S.own, i, inverse)
        mat_put(S.next, i, E)
        put(force, i, f)
        D = sym_sub(D1, mat_mat_t_sym(P, E))
        D1 = sym_sub(sym_get(S.own, i + 2), mat_mat_t_sym(Q, F))
        E = mat_sub(mat_get(S.next, i + 1), mat_mat_t(Q, E))
        f, f1 = sub(f1, mat_times(P, f)), sub(get(force, i + 2), mat_times(Q, f))
    inverse = sym_inverse(D)
    P = mat_sym(E, inverse)
    sym_put(S.own, last - 1, inverse)
    mat_put(S.next, last - 1, E)
    put(force, last - 1, f)
    sym_put(S.own, last, sym_sub(D1, mat_mat_t_sym(P, E)))
    put(force, last, sub(f1, mat_times(P, f)))


@kernel
def condense_start(S, force, first, last, bends):
    """Carry the column of node `first` through the elimination, as three more right-hand sides."""
    for i in range(first + 1, last + 1):
        for k in range(9):
            S.start[i, k] = 0.0
    mat_put(S.start, first + 1, mat_get(S.next, first))
    if bends:
        mat_put(S.start, first + 2, mat_get(S.skip, first))
    D, f = sym_get(S.own, first), get(force, first)
    for i in range(first + 1, last):
        G, inverse = mat_get(S.start, i), sym_get(S.own, i)
        W = mat_mat(sym_to_general(inverse), G)
        d = mat_t_mat(G, W)
        D = sym_sub(D, (d[0], d[1], d[2], d[4], d[5], d[8]))
        f = sub(f, mat_t_times(W, get(force, i)))
        mat_put(S.start, i + 1, mat_sub(mat_get(S.start, i + 1), mat_mat(mat_get(S.next, i), W)))
        if bends and i + 2 <= last:
            mat_put(S.start, i + 2, mat_sub(mat_get(S.start, i + 2), mat_mat(mat_get(S.skip, i), W)))
    sym_put(S.own, first, D)
    put(force, first, f)


@kernel
def back_substitute(lines, work, line, start_is_free):
    """Fill the increments of the interior; those of the two end nodes are known."""
    first, last = line_nodes(lines, line)
    S, force, x = work.blocks, work.force, work.increment
    bends = lines.bends[line]
    x0, x1, x2 = get(x, first), get(x, last), (0.0, 0.0, 0.0)
    for i in range(last - 1, first, -1):
        f = sub(get(force, i), mat_t_times(mat_get(S.next, i), x1))
        if bends:
            f = sub(f, mat_t_times(mat_get(S.skip, i), x2))
        if start_is_free:
            f = sub(f, mat_times(mat_get(S.start, i), x0))
        x1, x2 = sym_times(sym_get(S.own, i), f), x1
        put(x, i, x1)


@inlined
def assemble_and_reduce(system, state, before, work, line, c):
    """Do the work of `assemble_line` and `eliminate_tridiagonal` in one walk, for a line that does not bend.

    Elimination waits for the result of the node before, assembly does not: side by side the processor does both at
    once. Leaves inverse times force in `force` and P = S[i+1, i] inverse in `next`, all that `substitute` needs.
    """
    first, last = line_nodes(system.lines, line)
    own, next = work.blocks.own, work.blocks.next
    force, D, E, carried = walk(system, state, before, line, first, last, begin_walk(first - line), c)
    put(work.force, first, force)
    sym_put(own, first, D)
    mat_put(next, first, sym_to_general(E))
    f, D, E, carried = walk(system, state, before, line, first + 1, last, carried, c)
    for i in range(first + 1, last):
        f1, D1, E1, carried = walk(system, state, before, line, i + 1, last, carried, c)
        inverse = sym_inverse(D)
        P = sym_sym(E, inverse)
        put(work.force, i, sym_times(inverse, f))
        mat_put(next, i, P)
        D = sym_sub(D1, mat_sym_sym(P, E))
        f = sub(f1, mat_times(P, f))
        E = E1
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
