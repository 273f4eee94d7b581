"""Stiffness of a mooring at its points, from the same elimination that Newton's method uses.

With the tangent weights (0, 0, 1) elimination leaves each line's stiffness at its two ends; what is left to do is to
eliminate the free points, and to move the coupled points as one rigid platform.
"""

from __future__ import annotations

import numpy as np

from moorage._jit import kernel
from moorage.layout import Weights, line_nodes
from moorage.physics.point import point_terms
from moorage.solve.line_solve import reduce_line
from moorage.system.assemble import assemble_line
from moorage.system.build import Built


@kernel
def condense_lines(system, state, work, c, out):
    """Fill out (lines, 2, 2, 9): the condensed blocks of every line between its ends A and B, row by row."""
    for line in range(len(system.lines.bends)):
        first, last = line_nodes(system.lines, line)
        assemble_line(system, state, state.position, work, line, c)
        reduce_line(system.lines, work, line, True)
        full = ((0, 1, 2), (1, 3, 4), (2, 4, 5))
        for i in range(3):
            for j in range(3):
                out[line, 0, 0, 3 * i + j] = work.blocks.own[first, full[i][j]]
                out[line, 1, 1, 3 * i + j] = work.blocks.own[last, full[i][j]]
                out[line, 1, 0, 3 * i + j] = work.blocks.start[last, 3 * i + j]
                out[line, 0, 1, 3 * i + j] = work.blocks.start[last, 3 * j + i]


@kernel
def condense_point(system, state, row, point, c):
    """Block of the loads on a point by itself."""
    r = state.position[row, 0], state.position[row, 1], state.position[row, 2]
    v = state.velocity[row, 0], state.velocity[row, 1], state.velocity[row, 2]
    a = state.acceleration[row, 0], state.acceleration[row, 1], state.acceleration[row, 2]
    return point_terms(system.points, system.current, point, r, v, a, c)[1]


def line_blocks(built: Built) -> np.ndarray:
    """Return the condensed stiffness of every line at its ends, (lines, 2, 2, 3, 3), N/m."""
    out = np.zeros((len(built.names.lines), 2, 2, 9))
    condense_lines(built.system, built.state, built.work, Weights(0.0, 0.0, 1.0), out)
    return out.reshape(-1, 2, 2, 3, 3)


def point_stiffness(built: Built) -> np.ndarray:
    """Return the stiffness -dF/dr of all points together, (points, 3, points, 3), N/m, with the lines condensed."""
    n, first_row = len(built.names.points), int(built.names.node_ptr[-1])
    K = np.zeros((n, 3, n, 3))
    for ends, blocks in zip(built.system.lines.end_point, line_blocks(built), strict=True):
        for i in range(2):
            for j in range(2):
                K[ends[i], :, ends[j], :] += blocks[i, j]
    for k in built.system.islands.points:
        a, b, c, d, e, f = condense_point(built.system, built.state, first_row + k, k, Weights(0.0, 0.0, 1.0))
        K[k, :, k, :] += [[a, b, c], [b, d, e], [c, e, f]]
    return K


def coupled_stiffness(built: Built, moved) -> np.ndarray:
    """Return the stiffness of the points `moved` (indices) with the free points eliminated, (m, 3, m, 3), N/m.

    Fixed points, and coupled ones that are not in `moved`, are held.
    """
    K, free, m = point_stiffness(built), built.system.islands.points, len(moved)

    def pick(rows, columns):
        return K[rows][:, :, columns].reshape(3 * len(rows), 3 * len(columns))

    Kmm = pick(moved, moved)
    if len(free):
        Kmf, Kff = pick(moved, free), pick(free, free)
        Kmm = Kmm - Kmf @ np.linalg.solve(Kff, Kmf.T)
    return Kmm.reshape(m, 3, m, 3)


def platform_stiffness(built: Built, forces=None, moved=None) -> np.ndarray:
    """Return the 6x6 stiffness of the coupled points moved as one rigid platform about the origin.

    Parameters
    ----------
    built : Built
        At static equilibrium.
    forces : (m, 3) array
        Force of the lines on each moved point, N; they give the part that comes from turning their lever arms.
    moved : (m,) array of int, optional
        Indices of the points that the platform carries; by default `built.coupled`.

    Returns
    -------
    (6, 6) array
        -d(force, moment)/d(translation, rotation) in surge, sway, heave, roll, pitch, yaw; N/m, N/rad, N m/rad.
    """
    moved = built.coupled if moved is None else np.asarray(moved, dtype=int)
    if not len(moved):
        return np.zeros((6, 6))
    K = coupled_stiffness(built, moved)
    arms = built.state.position[built.names.node_ptr[-1] + moved]
    T = np.concatenate([np.tile(np.eye(3), (len(moved), 1, 1)), -np.array([cross_matrix(r) for r in arms])], axis=2)
    total = np.einsum("mia,minj,njb->ab", T, K, T)
    if forces is not None:
        # the moment r x f changes by (theta x r) x f = [f][r] theta when the arm turns
        total[3:, 3:] -= sum(cross_matrix(f) @ cross_matrix(r) for f, r in zip(forces, arms, strict=True))
    return total


def cross_matrix(u) -> np.ndarray:
    """Return the matrix of a x."""
    x, y, z = u
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
