"""Stiffness of a mooring at its points, from the same elimination that Newton's method uses.

With the tangent weights (0, 0, 1) elimination leaves each line's stiffness at its two ends; what is left to do is to
eliminate the free points, and to move the coupled points as one rigid platform.
"""

from __future__ import annotations

import numpy as np

from moorage._jit import inlined, kernel
from moorage._vec3 import mat_get, mat_put, mat_transpose, sym_get, sym_to_general
from moorage.layout import CARRIER, FLEXIBLE, Weights, copy_of, line_nodes, water_of
from moorage.model.motion import rotation_matrices
from moorage.physics.bending import PINNED
from moorage.physics.point import point_terms
from moorage.solve.line_solve import reduce_line
from moorage.solve.newton import assemble_island
from moorage.solve.record import COLUMNS, FORCE_A, MOMENT_A, sample_system
from moorage.solve.statics import natural_tolerance, solve, static_system
from moorage.system.build import Built


@kernel
def condense_island(system, state, work, island, c, blocks, across):
    """Reduce all lines of an island to their boundaries with the weights c.

    Fills blocks (lines, 4, 4, 9), rows and columns first, first + 1, last - 1, last of each line (zero where a node is
    not part of the boundary), and across (joints, 9).
    """
    lines, islands = system.lines, system.islands
    assemble_island(system, state, state, work, island, c, 0.0)
    S = work.blocks
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        first, last = line_nodes(lines, line)
        if system.riders.lines[line, CARRIER] != FLEXIBLE:
            continue
        reduce_line(lines, work, line, True)
        near, far = lines.inner_unknown[line, 0] >= 0, lines.inner_unknown[line, 1] >= 0
        out = blocks[line]
        mat_put(out[0], 0, sym_to_general(sym_get(S.own, first)))
        mat_put(out[3], 3, sym_to_general(sym_get(S.own, last)))
        couple(out, 3, 0, mat_get(S.start, last))
        if near:
            mat_put(out[1], 1, sym_to_general(sym_get(S.own, first + 1)))
            couple(out, 1, 0, mat_get(S.next, first))
            couple(out, 3, 1, mat_get(S.inner, last))
        if far:
            mat_put(out[2], 2, sym_to_general(sym_get(S.own, last - 1)))
            couple(out, 3, 2, mat_get(S.next, last - 1))
            couple(out, 2, 0, mat_get(S.start, last - 1))
            if near:
                couple(out, 2, 1, mat_get(S.inner, last - 1))
    for m in range(islands.joint_ptr[island], islands.joint_ptr[island + 1]):
        mat_put(across, m, mat_get(S.joint, m))


@inlined
def couple(out, i, j, m):
    """Write a block and its transpose."""
    mat_put(out[i], j, m)
    mat_put(out[j], i, mat_transpose(m))


@kernel
def condense_point(system, state, row, point, c):
    """Block of the loads on a point by itself."""
    r = state.position[row, 0], state.position[row, 1], state.position[row, 2]
    v = state.velocity[row, 0], state.velocity[row, 1], state.velocity[row, 2]
    a = state.acceleration[row, 0], state.acceleration[row, 1], state.acceleration[row, 2]
    return point_terms(system.points, point, water_of(state, row), r, v, a, c)[1]


def point_stiffness(built: Built) -> np.ndarray:
    """Return the stiffness -dF/dr of all points and rod ends together, (n, 3, n, 3), N/m, with the lines condensed.

    Rows count the points in the order of the file and then the ends of rods.
    """
    system, lines = static_system(built.system), built.system.lines
    n, first_row = len(system.points.mass), int(built.system.lines.node_ptr[-1])
    blocks, across = np.zeros((len(lines.bends), 4, 4, 9)), np.zeros((len(system.joints.rule), 9))
    # slack nodes yield without resistance: their mass, as in statics, keeps the pivots from zero
    c = Weights(1e-8, 0.0, 1.0)
    for island in range(len(system.islands.line_ptr) - 1):
        condense_island(system, built.state, built.work, island, c, blocks, across)
    inner = -np.ones((len(lines.bends), 2), dtype=int)
    held = lines.inner_unknown >= 0
    inner[held] = n + np.arange(int(held.sum()))
    size = n + int(held.sum())
    K = np.zeros((size, 3, size, 3))
    for line, block in enumerate(blocks.reshape(-1, 4, 4, 3, 3)):
        rows = [lines.end_point[line, 0], inner[line, 0], inner[line, 1], lines.end_point[line, 1]]
        for i, row in enumerate(rows):
            for j, column in enumerate(rows):
                if row >= 0 and column >= 0:
                    K[row, :, column, :] += block[i, j]
    for (line1, line2), (end1, end2), block in zip(
        system.joints.line, system.joints.end, across.reshape(-1, 3, 3), strict=True
    ):
        K[inner[line2, end2], :, inner[line1, end1], :] += block
        K[inner[line1, end1], :, inner[line2, end2], :] += block.T
    for k in system.islands.points:
        a, b, e, d, f, g = condense_point(system, built.state, first_row + k, k, c)
        K[k, :, k, :] += [[a, b, e], [b, d, f], [e, f, g]]
    return eliminate(K, np.arange(n, size)) if size > n else K


def eliminate(K, gone) -> np.ndarray:
    """Return a stiffness (n, 3, n, 3) with some of its 3-vectors eliminated."""
    kept = np.setdiff1d(np.arange(len(K)), gone)

    def pick(rows, columns):
        return K[rows][:, :, columns].reshape(3 * len(rows), 3 * len(columns))

    reduced = pick(kept, kept) - pick(kept, gone) @ np.linalg.solve(pick(gone, gone), pick(gone, kept))
    return reduced.reshape(len(kept), 3, len(kept), 3)


def coupled_stiffness(built: Built, moved) -> np.ndarray:
    """Return the stiffness of the points `moved` (indices) with the free points eliminated, (m, 3, m, 3), N/m.

    Fixed points, and coupled ones that are not in `moved`, are held.
    """
    K, free = point_stiffness(built), built.system.islands.points
    live = np.concatenate([np.asarray(moved, dtype=int), free])
    K = K[live][:, :, live]
    return eliminate(K, np.arange(len(moved), len(live))) if len(free) else K


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
    if (built.system.bending.rule[np.isin(built.system.lines.end_point, moved)] != PINNED).any():
        return measured_stiffness(built, moved)
    K = coupled_stiffness(built, moved)
    arms = built.state.position[built.system.lines.node_ptr[-1] + moved]
    T = np.concatenate([np.tile(np.eye(3), (len(moved), 1, 1)), -np.array([cross_matrix(r) for r in arms])], axis=2)
    total = np.einsum("mia,minj,njb->ab", T, K, T)
    if forces is not None:
        # the moment r x f changes by (theta x r) x f = [f][r] theta when the arm turns
        total[3:, 3:] -= sum(cross_matrix(f) @ cross_matrix(r) for f, r in zip(forces, arms, strict=True))
    return total


def measured_stiffness(built: Built, moved, step: float = 2e-3) -> np.ndarray:
    """Return the same by central differences of equilibria, for platforms that turn the clamps of cables.

    step: m and rad; large enough that the imbalance that statics accept does not matter.
    """
    tolerance = 0.1 * natural_tolerance(built)
    rest, coefficients = built.system.tracks.rest.copy(), built.system.tracks.coefficients.copy()
    begin = copy_of(built.state)
    K = np.zeros((6, 6))
    for k in range(6):
        loads = []
        for target, source in zip(built.state, begin, strict=True):
            target[...] = source
        for sign in (1.0, -1.0):
            move = np.zeros(6)
            move[k] = sign * step
            _move_platform(built, moved, move, rest)
            solve(built, tolerance)
            loads.append(_platform_load(built, moved, move[:3]))
        K[:, k] = (loads[1] - loads[0]) / (2.0 * step)
    built.system.tracks.rest[...], built.system.tracks.coefficients[...] = rest, coefficients
    for target, source in zip(built.state, begin, strict=True):
        target[...] = source
    return K


def _move_platform(built: Built, moved, move, rest) -> None:
    """Shift and turn the moved holders and the clamps on them by a small motion (m, rad) from where they rest."""
    system = built.system
    turn = rotation_matrices(move[None, 3:])[0]
    turned = system.bending.direction[np.isin(system.lines.end_point, moved)]
    turned = turned[turned >= 0]
    system.tracks.rest[moved] = rest[moved] @ turn.T + move[:3]
    system.tracks.rest[turned] = rest[turned] @ turn.T
    for k in (*moved, *turned):
        if system.tracks.track[k] >= 0:  # statics look at time 0: the first coefficient's constant
            system.tracks.coefficients[system.tracks.track[k], 0, :, 3] = system.tracks.rest[k]


def _platform_load(built: Built, moved, origin) -> np.ndarray:
    """Force (N) and moment (N m) of the lines on the moved holders, at rest; about the platform's origin, m."""
    sample = np.zeros((len(built.system.lines.bends), COLUMNS))
    sample_system(built.system, built.state, 0.0, sample)
    load = np.zeros(6)
    for line, ends in enumerate(built.system.lines.end_point):
        for end, holder in enumerate(ends):
            if holder in moved:
                force = sample[line, FORCE_A + 3 * end : FORCE_A + 3 * end + 3]
                arm = built.state.position[built.system.lines.node_ptr[line + end] - end] - origin
                load[:3] += force
                load[3:] += np.cross(arm, force) + sample[line, MOMENT_A + 3 * end : MOMENT_A + 3 * end + 3]
    return load


def cross_matrix(u) -> np.ndarray:
    """Return the matrix of a x."""
    x, y, z = u
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
