"""Natural frequencies and shapes of small oscillations about a static state: K x = w^2 M x.

K and M are those of Newton's method, assembled with the weights (0, 0, 1) and (1, 0, 0): K with contact, bending and
buoyancy in the surface, M with added mass. Drag, damping and the sea have no part in them, nor has friction (unless the
statics have it). Coupled points, rods and bodies are held.

Unknowns are 3-vectors of state rows. A basis takes fewer unknowns to those rows, K -> T^T K T: what moves several rows
at once, a rigid body, needs no more than that and its own 6x6 blocks.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import csc_array, csr_array
from scipy.sparse.linalg import eigsh

from moorage.layout import Weights
from moorage.solve.newton import assemble_island
from moorage.solve.object_modes import basis_of, own_blocks, own_unknowns, without_rods
from moorage.solve.statics import static_system
from moorage.solve.statics_kernel import place_at_rest
from moorage.solve.stiffness import condense_point
from moorage.solve.whole_jacobian import Unknowns, unknowns_of, whole_matrix
from moorage.system.build import Built

STIFFNESS, MASS = Weights(0.0, 0.0, 1.0), Weights(1.0, 0.0, 0.0)
DENSE = 400  # unknowns up to which a full matrix is as quick
SHIFT = 1e-9  # below zero, in units of the largest K_ii / M_ii: what has no stiffness must not divide by zero


class Pencil(NamedTuple):
    """K and M of an island: n unknown 3-vectors, or what a basis made of them."""

    stiffness: csc_array  # (m, m)
    mass: csc_array  # (m, m)
    rows: np.ndarray  # (n,) state rows
    basis: csr_array | None = None  # (3 n, m), none: m = 3 n
    lines: csc_array | None = None  # (3 n, 3 n) mass of the rows by themselves, with a basis
    own: csc_array | None = None  # (m, m) mass of objects beside it
    unknown: np.ndarray | None = None  # (m, 2) state row and axis of each unknown, with a basis


class Modes(NamedTuple):
    """Modes in the order of their frequencies."""

    squares: np.ndarray  # (k,) w^2, rad2/s2; negative: the state is not stable
    shapes: np.ndarray  # (k, rows, 3) of all state rows in global axes, largest displacement 1 (rotation, if none)
    energy: np.ndarray  # (k, rows) share of the kinetic energy; of ends of lines it is at what they hold on to


def modes_at_rest(built: Built, number: int, pencils: Sequence[Pencil] | None = None) -> Modes:
    """Return the lowest modes of a system in static equilibrium.

    Parameters
    ----------
    built : Built
        Its state is the equilibrium.
    number : int
        Of modes; fewer when the system has fewer.
    pencils : sequence of Pencil, optional
        One for each independent part; by default the islands.
    """
    parts = (
        [island_pencil(built, k) for k in range(len(built.system.islands.line_ptr) - 1)] if pencils is None else pencils
    )
    found = [(part, *lowest(part, number)) for part in parts if part.stiffness.shape[0]]
    squares = np.concatenate([values for _, values, _ in found]) if found else np.zeros(0)
    order = np.argsort(squares)[:number]
    every = [(part, vectors[:, k]) for part, _, vectors in found for k in range(vectors.shape[1])]
    shapes = np.zeros((len(order), len(built.state.position), 3))
    energy = np.zeros(shapes.shape[:2])
    for out, k in enumerate(order):
        part, vector = every[k]
        full = vector if part.basis is None else part.basis @ vector
        shapes[out, part.rows] = full.reshape(-1, 3)
        lines = part.mass if part.basis is None else part.lines
        if lines is not None:
            energy[out, part.rows] = (full * (lines @ full)).reshape(-1, 3).sum(axis=1)
        if part.own is not None and part.unknown is not None:
            rows, axes = part.unknown.T
            np.add.at(energy[out], rows, vector * (part.own @ vector))
            shapes[out, rows, axes] = vector
    _turn_objects(built, shapes)
    _follow_holders(built, shapes)
    largest = _largest(built, shapes)
    total = energy.sum(axis=1)
    return Modes(
        squares[order],
        shapes / np.maximum(largest, 1e-300)[:, None, None],
        energy / np.where(total > 0.0, total, 1.0)[:, None],
    )


def island_pencil(built: Built, island: int) -> Pencil:
    """Return K and M of the interior nodes, free points and objects of an island."""
    lines, islands = without_rods(built), built.system.islands
    unknowns = unknowns_of(lines, island) if _has_lines(lines, island) else _points_only(built, island)
    if islands.object_ptr[island] == islands.object_ptr[island + 1]:
        K, M = (assembled(built, island, unknowns, c) for c in (STIFFNESS, MASS))
        return Pencil(K, M, unknowns.rows)
    own = own_unknowns(built, island, unknowns.rows)
    parts = []
    for c in (STIFFNESS, MASS):
        parts.append((assembled(built, island, unknowns, c), own_blocks(built, island, own, c)))
    (K, k), (M, m) = parts
    basis = basis_of(built, island, unknowns.rows, own)
    return with_basis(Pencil(K, M, unknowns.rows), basis, k, m)._replace(lines=M, own=m, unknown=own)


def _has_lines(built: Built, island: int) -> bool:
    return bool(built.system.islands.line_ptr[island] < built.system.islands.line_ptr[island + 1])


def _points_only(built: Built, island: int) -> Unknowns:
    """Return the unknowns of an island without lines."""
    islands, none = built.system.islands, np.zeros(0, dtype=np.int64)
    rows = built.system.lines.node_ptr[-1] + islands.points[slice(*islands.point_ptr[island : island + 2])]
    number = np.full(len(built.state.position), -1)
    number[rows] = np.arange(len(rows))
    return Unknowns(rows, none, none.astype(bool), none.astype(bool), none, none, number)


def assembled(built: Built, island: int, unknowns: Unknowns, c: Weights) -> csc_array:
    """Return the tangent of an island with the weights c, as a symmetric sparse matrix of its unknowns."""
    system, work = static_system(built.system), built.work
    place_at_rest(system, built.state, work, island)
    assemble_island(system, built.state, built.state, work, island, c, 0.0)
    nodes = int(built.system.lines.node_ptr[-1])
    for point in system.islands.points[slice(*system.islands.point_ptr[island : island + 2])]:
        work.blocks.own[nodes + point] = condense_point(system, built.state, nodes + point, point, c)
    return whole_matrix(without_rods(built), island, unknowns, np.zeros((len(built.state.position), 9)))


def with_basis(pencil: Pencil, basis: csr_array, stiffness=0.0, mass=0.0) -> Pencil:
    """Return a pencil of fewer unknowns y, x = basis y, with what their own K and M have beside that of the rows."""
    K, M = (csc_array(basis.T @ S @ basis) for S in (pencil.stiffness, pencil.mass))
    return Pencil(csc_array(K + stiffness), csc_array(M + mass), pencil.rows, basis)


def lowest(pencil: Pencil, number: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the lowest w^2 (k,) and vectors (m, k) of a pencil."""
    K, M = pencil.stiffness, pencil.mass
    size = K.shape[0]
    if size <= DENSE or number >= size - 1:
        return eigh(K.toarray(), M.toarray(), subset_by_index=(0, min(number, size) - 1))
    shift = -SHIFT * float((K.diagonal() / M.diagonal()).max())
    start = np.random.default_rng(1).standard_normal(size)  # the same numbers in every run
    squares, vectors = eigsh(K, number, M, sigma=shift, which="LM", v0=start)
    order = np.argsort(squares)
    return squares[order], vectors[:, order]


def _turn_objects(built: Built, shapes: np.ndarray) -> None:
    """Take the rotations of objects to global axes, and let what is pinned move with its pin."""
    riders, first = built.system.riders, built.system.lines.node_ptr[-1]
    for o, row in enumerate(riders.row):
        shapes[:, row + 1] = shapes[:, row + 1] @ built.state.attitude[o].reshape(3, 3).T
        if riders.pin[o] >= 0:
            shapes[:, row] = shapes[:, first + riders.pin[o]]


def _largest(built: Built, shapes: np.ndarray) -> np.ndarray:
    """Return the largest displacement of each mode (k,); where nothing is displaced, the largest rotation."""
    sizes = np.linalg.norm(shapes, axis=2)
    turns = np.zeros(shapes.shape[1], dtype=bool)
    turns[built.system.riders.row + 1] = True
    moved, turned = (sizes[:, rows].max(axis=1, initial=0.0) for rows in (~turns, turns))
    return np.where(moved > 1e-9 * turned, moved, turned)


def _follow_holders(built: Built, shapes: np.ndarray) -> None:
    """Let the end nodes of lines move with what they hold on to."""
    ptr, first = built.names.node_ptr, built.system.lines.node_ptr[-1]
    for line, holders in enumerate(built.system.lines.end_point[: len(built.names.lines)]):
        for end, row in enumerate((ptr[line], ptr[line + 1] - 1)):
            shapes[:, row] = shapes[:, first + holders[end]]
