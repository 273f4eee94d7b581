"""K and M of islands with rods and bodies: those of the lines, carried to the objects by what rides on them.

Unknowns y are interior nodes, free points, and of each object translation (unless it is pinned) and rotation, in its
own axes. Rows of lines and points follow by x = T y. Objects' own blocks, those of the nodes of rods, clamps, and how
forces turn with their arms are what the junction system of Newton's method holds before lines are condensed into it.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import csc_array, csr_array

from moorage.layout import CARRIER, FLEXIBLE, PIN, ROW, Weights
from moorage.physics.rigid import SLENDER
from moorage.solve.fold import move_riders
from moorage.solve.newton import largest_imbalance
from moorage.solve.statics import static_system
from moorage.system.build import Built


def without_rods(built: Built) -> Built:
    """Return a system whose islands leave out the rigid lines."""
    islands, carrier = built.system.islands, built.system.riders.lines[:, CARRIER]
    flexible = carrier[islands.lines] == FLEXIBLE
    ptr = np.concatenate([[0], np.cumsum(flexible)])[islands.line_ptr]
    kept = islands._replace(line_ptr=ptr.astype(np.int64), lines=islands.lines[flexible])
    return built._replace(system=built.system._replace(islands=kept))


def own_unknowns(built: Built, island: int, rows: np.ndarray) -> np.ndarray:
    """Return row and axis (m, 2) of the unknowns y, for the unknown rows (n,) of lines and points."""
    system = built.system
    pairs = [(row, axis) for row in rows[~riding(built, rows)] for axis in range(3)]
    for o, row in system.islands.objects[slice(*system.islands.object_ptr[island : island + 2])]:
        if system.riders.objects[o, PIN] < 0:
            pairs += [(row, axis) for axis in range(3)]
        # a rod does not turn about its axis
        pairs += [(row + 1, axis) for axis in range(1 if system.rigid.table[o, SLENDER] else 0, 3)]
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)


def basis_of(built: Built, island: int, rows: np.ndarray, own: np.ndarray) -> csr_array:
    """Return T (3 n, m): how the rows of lines and points follow the unknowns y."""
    system, places = built.system, {int(row): k for k, row in enumerate(rows)}
    objects = {int(row) for o in system.riders.objects[:, ROW] for row in (o, o + 1)}
    follows = rows[riding(built, rows)]
    T = np.zeros((3 * len(rows), len(own)))
    increment = np.zeros(built.state.position.shape)
    for column, (row, axis) in enumerate(own.tolist()):
        if row in objects:
            increment[...] = 0.0
            increment[row, axis] = 1.0
            move_riders(system.lines, system.islands, system.riders, built.state, increment, island)
            for follower in follows.tolist():
                T[3 * places[follower] : 3 * places[follower] + 3, column] = increment[follower]
        else:
            T[3 * places[row] + axis, column] = 1.0
    return csr_array(T)


def riding(built: Built, rows: np.ndarray) -> np.ndarray:
    """Return whether rows ride on objects, (n,) bool."""
    number = rows - int(built.system.lines.node_ptr[-1])
    return (number >= 0) & (built.system.riders.points[np.maximum(number, 0)] >= 0)


def own_blocks(built: Built, island: int, own: np.ndarray, c: Weights) -> csc_array:
    """Return what objects, rods and clamps add to the tangent with the weights c, (m, m); the island is assembled."""
    system, work, islands = static_system(built.system), built.work, built.system.islands
    largest_imbalance(system, built.state, work, island, c)
    begin, end = islands.unknown_ptr[island : island + 2]
    size, base = 3 * int(end - begin), int(islands.matrix_ptr[island])
    A = work.junction_matrix[base : base + size * size].reshape(size, size)
    number = {int(row): k for k, row in enumerate(islands.unknown_row[begin:end])}
    known = [(k, 3 * number[row] + axis) for k, (row, axis) in enumerate(own.tolist()) if row in number]
    at, junction = (np.array(part, dtype=int) for part in zip(*known, strict=True))
    out = np.zeros((len(own), len(own)))
    part = A[np.ix_(junction, junction)]
    out[np.ix_(at, at)] = 0.5 * (part + part.T)  # not symmetric by what is out of balance only
    return csc_array(out)
