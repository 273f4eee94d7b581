"""Which lines and free points belong together: islands, and the unknowns of their junction systems."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from moorage.layout import Islands, Joints, Lines


def islands_of(node_ptr, ends, free, bends, joints: Joints):
    """Group lines that share free points.

    Parameters
    ----------
    node_ptr : (lines + 1,) array
    ends : (lines, 2) array
        Holders at end A and B.
    free : (holders,) array of bool
    bends : (lines,) array of bool
    joints : Joints
        In any order.

    Returns
    -------
    Lines, Islands, Joints (in the order of the islands), island of each line
    """
    n = len(ends)
    pairs = [(k, holder) for k, both in enumerate(ends) for holder in both if free[holder]]
    rows, columns = np.array(pairs, dtype=np.int64).reshape(-1, 2).T
    graph = coo_array((np.ones(len(rows)), (rows, n + columns)), shape=(n + len(free), n + len(free)))
    _, label = connected_components(graph, directed=False)
    free_points = np.flatnonzero(free)
    names, island = np.unique(np.concatenate([label[:n], label[n + free_points]]), return_inverse=True)
    of_line, of_point = island[:n], island[n:]
    of_joint = of_line[joints.line[:, 0]]
    count = len(names)

    line_order, line_ptr = _grouped(of_line, count)
    point_order, point_ptr = _grouped(of_point, count)
    joint_order, joint_ptr = _grouped(of_joint, count)
    points = free_points[point_order]
    joints = Joints(*(values[joint_order] for values in joints))

    # unknowns of an island: its free points, then the two nodes beside each of its joints
    unknown_ptr = point_ptr + 2 * joint_ptr
    rows_of_unknowns = np.zeros(int(unknown_ptr[-1]), dtype=np.int64)
    number = np.full(len(free), -1, dtype=np.int64)
    number[points] = np.arange(len(points)) - point_ptr[of_point[point_order]]
    inner, beyond = np.full((n, 2), -1, dtype=np.int64), np.full((n, 2), -1, dtype=np.int64)
    for i in range(count):
        here = points[point_ptr[i] : point_ptr[i + 1]]
        rows_of_unknowns[unknown_ptr[i] : unknown_ptr[i] + len(here)] = node_ptr[-1] + here
        u = len(here)
        for m in range(joint_ptr[i], joint_ptr[i + 1]):
            (line, other), (end, other_end) = joints.line[m], joints.end[m]
            beyond[line, end], beyond[other, other_end] = (
                _beside(node_ptr, other, other_end),
                _beside(node_ptr, line, end),
            )
            for k in range(2):
                inner[joints.line[m, k], joints.end[m, k]] = u + k
                rows_of_unknowns[unknown_ptr[i] + u + k] = _beside(node_ptr, joints.line[m, k], joints.end[m, k])
            u += 2
    matrix_ptr = np.concatenate([[0], np.cumsum((3 * np.diff(unknown_ptr)) ** 2)]).astype(np.int64)
    lines = Lines(node_ptr, ends, number[ends], inner, bends, beyond)
    islands = Islands(line_ptr, line_order, point_ptr, points, joint_ptr, unknown_ptr, rows_of_unknowns, matrix_ptr)
    return lines, islands, joints, of_line


def _beside(node_ptr, line, end):
    """Row of the node beside an end of a line."""
    return node_ptr[line] + 1 if end == 0 else node_ptr[line + 1] - 2


def _grouped(group, count):
    """Order that brings members of the same group together, and where each group starts."""
    order = np.argsort(group, kind="stable").astype(np.int64)
    return order, np.searchsorted(group[order], np.arange(count + 1)).astype(np.int64)
