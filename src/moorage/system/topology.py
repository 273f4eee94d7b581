"""Which lines and free points belong together: islands, and the unknowns of their junction systems."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from moorage.layout import CARRIER, CLAMP, FLEXIBLE, ROTATION, TRANSLATION, Islands, Joints, Lines, Riders


def islands_of(node_ptr, ends, free, bends, joints: Joints, riders: Riders):
    """Group lines that share free points or objects.

    Parameters
    ----------
    node_ptr : (lines + 1,) array
    ends : (lines, 2) array
        Holders at end A and B.
    free : (holders,) array of bool
    bends : (lines,) array of bool
    joints : Joints
        In any order.
    riders : Riders
        Without the numbers of the unknowns, which are filled in.

    Returns
    -------
    Lines, Islands, Joints (in the order of the islands), island of each line
    """
    n, points = len(ends), len(free)
    flexible, rides = riders.lines[:, CARRIER] == FLEXIBLE, riders.points >= 0
    moving = free | rides
    label = _components(ends, moving, flexible, riders)
    unknown_points = np.flatnonzero(moving)
    unknown_points = unknown_points[np.argsort(~rides[unknown_points], kind="stable")]  # riders come first
    parts = [label[:n], label[n + unknown_points], label[n + points :]]
    names, island = np.unique(np.concatenate(parts), return_inverse=True)
    of_line, of_point, of_object = np.split(island, np.cumsum([n, len(unknown_points)]))
    of_joint = of_line[joints.line[:, 0]]
    count = len(names)

    line_order, line_ptr = _grouped(of_line, count)
    point_order, point_ptr = _grouped(of_point, count)
    joint_order, joint_ptr = _grouped(of_joint, count)
    object_order, object_ptr = _grouped(of_object, count)
    points_in_order = unknown_points[point_order]
    joints = Joints(*(values[joint_order] for values in joints))

    # unknowns of an island: its points, then the nodes beside its joints and clamps on objects, then its objects
    inner, beyond = np.full((n, 2), -1, dtype=np.int64), np.full((n, 2), -1, dtype=np.int64)
    number = np.full(points, -1, dtype=np.int64)
    number[points_in_order] = np.arange(len(points_in_order)) - point_ptr[of_point[point_order]]
    unknown_rows: list[list[int]] = []
    for i in range(count):
        rows = list(node_ptr[-1] + points_in_order[point_ptr[i] : point_ptr[i + 1]])
        for m in range(joint_ptr[i], joint_ptr[i + 1]):
            (line, other), (end, other_end) = joints.line[m], joints.end[m]
            beyond[line, end] = _beside(node_ptr, other, other_end)
            beyond[other, other_end] = _beside(node_ptr, line, end)
            for side in range(2):
                inner[joints.line[m, side], joints.end[m, side]] = len(rows)
                rows.append(_beside(node_ptr, joints.line[m, side], joints.end[m, side]))
        for line in line_order[line_ptr[i] : line_ptr[i + 1]]:
            for end in np.flatnonzero(riders.lines[line, CLAMP:] >= 0):
                inner[line, end] = len(rows)
                rows.append(_beside(node_ptr, line, end))
        for o in object_order[object_ptr[i] : object_ptr[i + 1]]:
            if riders.pin[o] < 0:
                riders.objects[o, TRANSLATION] = len(rows)
                rows.append(int(riders.row[o]))
            else:
                riders.objects[o, TRANSLATION] = number[riders.pin[o]] if rides[riders.pin[o]] else -1
            riders.objects[o, ROTATION] = len(rows)
            rows.append(int(riders.row[o]) + 1)
        unknown_rows.append(rows)
    unknowns = np.array([len(rows) for rows in unknown_rows], dtype=np.int64)
    lines = Lines(node_ptr, ends, np.where(flexible[:, None], number[ends], -1), inner, bends, beyond)
    riding = np.bincount(of_point[rides[unknown_points]], minlength=count)
    has_objects = np.bincount(of_line[~flexible], minlength=count) + np.diff(object_ptr) > 0
    islands = Islands(
        line_ptr,
        line_order,
        point_ptr,
        points_in_order,
        joint_ptr,
        object_ptr,
        np.stack([object_order, riders.row[object_order]], axis=1),
        np.stack([riding, has_objects.astype(np.int64)], axis=1),
        np.concatenate([[0], np.cumsum(unknowns)]).astype(np.int64),
        np.array([row for rows in unknown_rows for row in rows], dtype=np.int64),
        np.concatenate([[0], np.cumsum((3 * unknowns) ** 2)]).astype(np.int64),
    )
    return lines, islands, joints, of_line


def _components(ends, moving, flexible, riders: Riders):
    """Label lines, points and objects (in this order) by what belongs together."""
    n, points, objects = len(ends), len(moving), len(riders.objects)
    pairs = [(k, n + holder) for k, both in enumerate(ends) for holder in both if moving[holder] and flexible[k]]
    pairs += [(n + point, n + points + o) for point, o in enumerate(riders.points) if o >= 0]
    pairs += [(k, n + points + o) for k, o in enumerate(riders.lines[:, CARRIER]) if o >= 0]
    pairs += [(n + pin, n + points + o) for o, pin in enumerate(riders.pin) if pin >= 0 and riders.points[pin] >= 0]
    rows, columns = np.array(pairs, dtype=np.int64).reshape(-1, 2).T
    size = n + points + objects
    return connected_components(coo_array((np.ones(len(rows)), (rows, columns)), shape=(size, size)), directed=False)[1]


def _beside(node_ptr, line, end):
    """Row of the node beside an end of a line."""
    return int(node_ptr[line] + 1 if end == 0 else node_ptr[line + 1] - 2)


def _grouped(group, count):
    """Order that brings members of the same group together, and where each group starts."""
    order = np.argsort(group, kind="stable").astype(np.int64)
    return order, np.searchsorted(group[order], np.arange(count + 1)).astype(np.int64)
