"""Static equilibrium in a current with the whole Jacobian, where the symmetric tangent goes astray.

That tangent leaves out how drag turns with the line, which rules where a light rope is in a fast current. Here it is
added, in one sparse matrix that is not symmetric, and the current is raised from nothing in steps that Newton's method
can follow.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.sparse import coo_array, csc_array
from scipy.sparse.linalg import splu

from moorage._jit import kernel
from moorage._vec3 import get, sym_put
from moorage.layout import System, Weights, line_nodes, point_row, water_of
from moorage.physics.point import point_terms
from moorage.solve.newton import assemble_island, largest_imbalance
from moorage.solve.statics_kernel import place_at_rest
from moorage.system.assemble import turn_of_drag
from moorage.system.build import Built

FIRST, LEAST = 0.25, 1e-3  # steps of the current, as fractions of it
ITERATIONS = 20  # of Newton's method a step
FULL = np.array([[0, 1, 2], [1, 3, 4], [2, 4, 5]])  # entries of a symmetric block


class Unknowns(NamedTuple):
    """Rows of the nodes of an island's lines, and the unknown that each of them follows."""

    rows: np.ndarray  # (n,) state rows of the unknowns: interior nodes and free points
    nodes: np.ndarray  # (m,) all nodes of the lines, one line after the other
    next: np.ndarray  # (m,) bool: the node after it is of the same line
    skip: np.ndarray  # (m,) bool: so is the one after that
    before: np.ndarray  # (m,) rows on either side, from which the direction of the line follows
    after: np.ndarray  # (m,)
    number: np.ndarray  # (all rows,) unknown of a row, -1: prescribed


def raise_current(built: Built, system: System, island: int, reach: float, tolerance: float) -> tuple[float, int, int]:
    """Find equilibrium from that in still water, which the state holds, by raising the current.

    Returns the largest imbalance in N, its row, and the iterations. `system` is that of statics.
    """
    unknowns = unknowns_of(built, island)
    position, used, reached, step = built.state.position, 0, 0.0, FIRST
    while True:
        begin, fraction = position[unknowns.rows], min(1.0, reached + step)
        flow = system._replace(current=system.current._replace(velocity=fraction * system.current.velocity))
        worst, where, n = newton(built, flow, island, unknowns, reach, tolerance)
        used += n
        if worst < tolerance:
            if fraction == 1.0:
                return worst, where, used
            reached, step = fraction, 1.5 * step
        elif step < LEAST:
            return max(worst, tolerance), where, used
        else:
            position[unknowns.rows], step = begin, 0.5 * step


def newton(
    built: Built, system: System, island: int, unknowns: Unknowns, reach: float, tolerance: float
) -> tuple[float, int, int]:
    """Iterate with the whole Jacobian; returns the largest imbalance in N, its row, and the iterations."""
    position, turn = built.state.position, np.zeros((len(built.state.position), 9))
    for iteration in range(ITERATIONS):
        worst, where = assemble_all(system, built.state, built.work, island, turn)
        if worst < tolerance or not worst < 1e100:
            return worst, where, iteration
        try:
            factors = splu(whole_matrix(built, island, unknowns, turn))
        except RuntimeError:  # singular
            break
        x = factors.solve(built.work.force[unknowns.rows].ravel()).reshape(-1, 3)
        position[unknowns.rows] += min(1.0, reach / max(np.linalg.norm(x, axis=1).max(), 1e-300)) * x
    return worst, where, ITERATIONS


@kernel
def assemble_all(system, state, work, island, turn):
    """Set forces and blocks of an island at rest; returns the largest imbalance (N) and its row."""
    lines, islands = system.lines, system.islands
    c = Weights(0.0, 0.0, 1.0)
    place_at_rest(system, state, work, island)
    assemble_island(system, state, state, work, island, c, 0.0)
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        turn_of_drag(system, state, islands.lines[k], turn)
    worst, where, _ = largest_imbalance(system, state, work, island, c)
    for p in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        row = point_row(lines, islands.points[p])
        r, v, a = get(state.position, row), get(state.velocity, row), get(state.acceleration, row)
        block = point_terms(system.points, islands.points[p], water_of(state, row), r, v, a, c)[1]
        sym_put(work.blocks.own, row, block)
    return worst, where


def whole_matrix(built: Built, island: int, unknowns: Unknowns, turn: np.ndarray) -> csc_array:
    """Return minus the derivative (3n, 3n) of the forces to the positions, N/m."""
    system, blocks = built.system, built.work.blocks
    nodes, one, two = unknowns.nodes, unknowns.nodes[unknowns.next], unknowns.nodes[unknowns.skip]
    points = system.islands.points[slice(*system.islands.point_ptr[island : island + 2])] + system.lines.node_ptr[-1]
    joints = slice(*system.islands.joint_ptr[island : island + 2])
    full = np.concatenate([nodes, points])
    parts = [(full, full, blocks.own[full][:, FULL])]
    for row, column, values in (
        (one + 1, one, blocks.next[one]),
        (two + 2, two, blocks.skip[two]),
        (beside(system, 1)[joints], beside(system, 0)[joints], blocks.joint[joints]),
    ):
        block = values.reshape(-1, 3, 3)
        parts += [(row, column, block), (column, row, block.transpose(0, 2, 1))]
    turned = turn[nodes].reshape(-1, 3, 3)
    parts += [(nodes, unknowns.after, -turned), (nodes, unknowns.before, turned)]
    return in_place(parts, unknowns)


def beside(system: System, side: int) -> np.ndarray:
    """Return the nodes beside the ends of the first or second line at all joints."""
    lines, line, end = system.lines, system.joints.line[:, side], system.joints.end[:, side]
    return np.where(end == 0, lines.node_ptr[line] + 1, lines.node_ptr[line + 1] - 2)


def in_place(parts: list[tuple[np.ndarray, np.ndarray, np.ndarray]], unknowns: Unknowns) -> csc_array:
    """Return the sum of 3x3 blocks at rows and columns of the state, as a matrix of the unknowns."""
    i, j = (unknowns.number[np.concatenate([part[k] for part in parts])] for k in (0, 1))
    known = (i >= 0) & (j >= 0)
    values = np.concatenate([part[2] for part in parts])[known]
    axes = np.arange(3)
    rows, columns = 3 * i[known, None, None] + axes[:, None], 3 * j[known, None, None] + axes
    rows, columns = np.broadcast_arrays(rows, columns)
    size = 3 * len(unknowns.rows)
    return csc_array(coo_array((values.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size)))


def unknowns_of(built: Built, island: int) -> Unknowns:
    """Return the unknowns of an island."""
    lines, islands = built.system.lines, built.system.islands
    points = lines.node_ptr[-1] + islands.points[slice(*islands.point_ptr[island : island + 2])]
    number = np.full(len(built.state.position), -1)
    number[points] = np.arange(len(points))
    rows, nodes, left, before, after = [points], [], [], [], []
    for k in islands.lines[slice(*islands.line_ptr[island : island + 2])]:
        first, last = line_nodes(lines, k)
        inside = np.arange(first + 1, last)
        number[inside] = sum(map(len, rows)) + np.arange(len(inside))
        for end, node in enumerate((first, last)):
            if lines.end_unknown[k, end] >= 0:
                number[node] = number[lines.node_ptr[-1] + lines.end_point[k, end]]
        rows.append(inside)
        nodes.append(np.arange(first, last + 1))
        left.append(last - nodes[-1])
        ends = [node if beyond < 0 else beyond for node, beyond in zip((first, last), lines.beyond[k], strict=True)]
        before.append(np.append(ends[0], nodes[-1][:-1]))
        after.append(np.append(nodes[-1][1:], ends[1]))
    remaining, bends = np.concatenate(left), np.repeat(lines.bends, np.diff(lines.node_ptr))
    every = np.concatenate(nodes)
    skip = (remaining > 1) & bends[every]
    return Unknowns(
        np.concatenate(rows), every, remaining > 0, skip, np.concatenate(before), np.concatenate(after), number
    )
