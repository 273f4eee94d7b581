"""The equations of a whole system as full matrices, to check elimination and to find natural frequencies.

Unknowns are the interior nodes of all lines, then the free points; T takes them to all rows of the state.
"""

from __future__ import annotations

import numpy as np

from moorage._vec3 import get
from moorage.layout import State, Weights, copy_of, water_of
from moorage.model import Model
from moorage.physics.point import point_terms
from moorage.solve.newton import assemble_island, solve_island
from moorage.solve.statics_kernel import place_at_rest
from moorage.system.build import Built, build

MASS, DAMPING, STIFFNESS = Weights(1.0, 0.0, 0.0), Weights(0.0, 1.0, 0.0), Weights(0.0, 0.0, 1.0)


def full(s) -> np.ndarray:
    """Return a symmetric block (xx, xy, xz, yy, yz, zz) as a 3x3 array."""
    a, b, c, d, e, f = s
    return np.array([[a, b, c], [b, d, e], [c, e, f]])


def assembled(built: Built, c: Weights, state: State | None = None, before=None) -> tuple[np.ndarray, np.ndarray]:
    """Return the matrix (3 nodes, 3 nodes) and the force (nodes, 3) of all lines, with joints, ends not merged."""
    system, work = built.system, built.work
    state = built.state if state is None else state
    start = state if before is None else state._replace(position=before)
    ptr, joints = built.names.node_ptr, system.joints
    n = int(ptr[-1])
    S = np.zeros((n, 3, n, 3))
    for island in range(len(system.islands.line_ptr) - 1):
        assemble_island(system, state, start, work, island, c, 0.0)
    for k in range(len(ptr) - 1):
        first, last = ptr[k], ptr[k + 1] - 1
        for i in range(first, last + 1):
            S[i, :, i] = full(work.blocks.own[i])
        reaches = ((1, work.blocks.next), (2, work.blocks.skip)) if system.lines.bends[k] else ((1, work.blocks.next),)
        for reach, blocks in reaches:
            for i in range(first, last + 1 - reach):
                S[i + reach, :, i] = blocks[i].reshape(3, 3)
                S[i, :, i + reach] = blocks[i].reshape(3, 3).T
    for line, end, block in zip(joints.line, joints.end, work.blocks.joint, strict=True):
        i, j = np.where(end == 0, ptr[line] + 1, ptr[line + 1] - 2)  # the nodes beside the joint
        S[j, :, i] += block.reshape(3, 3)
        S[i, :, j] += block.reshape(3, 3).T
    return S.reshape(3 * n, 3 * n), work.force[:n].copy()


def unknowns(built: Built) -> np.ndarray:
    """Return T (3 rows, 3 unknowns) from the unknowns of all islands to the rows of the state."""
    ptr, system = built.names.node_ptr, built.system
    n, free = int(ptr[-1]), np.sort(system.islands.points)
    ends = np.concatenate([ptr[:-1], ptr[1:] - 1])
    interior = np.setdiff1d(np.arange(n), ends)
    T = np.zeros((len(built.state.position), len(interior) + len(free)))
    T[interior, np.arange(len(interior))] = 1.0
    for k, point in enumerate(free):
        T[n + point, len(interior) + k] = 1.0
        for row, holder in zip(ends, system.lines.end_point.T.ravel(), strict=True):
            T[row, len(interior) + k] += float(holder == point)
    return np.kron(T, np.eye(3))


def reduced(built: Built, c: Weights) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the matrix and the force of the unknowns, and T."""
    system, state = built.system, built.state
    n, T = int(built.names.node_ptr[-1]), unknowns(built)
    S = np.zeros((len(T), len(T)))
    f = np.zeros((len(T) // 3, 3))
    S[: 3 * n, : 3 * n], f[:n] = assembled(built, c)
    for point in system.islands.points:
        row = int(n + point)
        r, v, a = get(state.position, row), get(state.velocity, row), get(state.acceleration, row)
        force, block = point_terms(system.points, int(point), water_of(state, row), r, v, a, c)
        S[3 * row : 3 * row + 3, 3 * row : 3 * row + 3] = full(block)
        f[row] = force
    return T.T @ S @ T, T.T @ f.ravel(), T


def modes(built: Built) -> tuple[np.ndarray, np.ndarray]:
    """Return natural frequencies (n,), rad/s, increasing, and shapes (rows, 3, n) of a system at rest."""
    K, _, T = reduced(built, STIFFNESS)
    M, _, _ = reduced(built, MASS)
    half = np.linalg.inv(np.linalg.cholesky(M))
    squares, vectors = np.linalg.eigh(half @ K @ half.T)
    shapes = T @ half.T @ vectors
    return np.sqrt(np.maximum(squares, 0.0)), shapes.reshape(-1, 3, len(squares))


def shaken(model: Model, by: float = 0.2) -> Built:
    """Return a built model with all free rows moved at random, and line ends where their holders are."""
    built = build(model)
    random = np.random.default_rng(3)
    n = built.names.node_ptr[-1]
    for rows in built.state[:3]:
        rows += random.normal(0.0, by, rows.shape)
    islands = built.system.islands
    for island in range(len(islands.line_ptr) - 1):
        moved = copy_of(built.state)
        place_at_rest(built.system, moved, built.work, island)
        for line in islands.lines[islands.line_ptr[island] : islands.line_ptr[island + 1]]:
            first, last = built.names.node_ptr[line], built.names.node_ptr[line + 1] - 1
            built.state.position[[first, last]] = moved.position[[first, last]]
            for row, holder in zip((first, last), built.system.lines.end_point[line], strict=True):
                for rows in built.state[1:3]:
                    rows[row] = rows[n + holder]
    return built


def increments(built: Built, c: Weights) -> np.ndarray:
    """Return the Newton increments (rows, 3) of all islands, by elimination."""
    for island in range(len(built.system.islands.line_ptr) - 1):
        assemble_island(built.system, built.state, built.state, built.work, island, c, 0.0)
        solve_island(built.system, built.state, built.work, island, c)
    return built.work.increment.copy()


def dense_increments(built: Built, c: Weights) -> np.ndarray:
    """Return the same from the full matrix."""
    A, b, T = reduced(built, c)
    return (T @ np.linalg.solve(A, b)).reshape(-1, 3) if len(b) else np.zeros_like(built.state.position)
