"""The functions of Point.h."""

from __future__ import annotations

import numpy as np

from moorage.layout import Weights
from moorage.moordyn.codes import POINT_TYPE_FIXED, POINT_TYPES
from moorage.moordyn.handles import Line, Point, Vector, of, raising, to_tuple
from moorage.solve.stiffness import condense_point


def GetPointID(instance: Point) -> int:
    """Return the id of a point."""
    return _point(instance).id


def GetPointType(instance: Point) -> int:
    """Return POINT_TYPE_COUPLED, POINT_TYPE_FREE or POINT_TYPE_FIXED (also on a body)."""
    point = _point(instance)
    return POINT_TYPE_FIXED if point.body is not None else POINT_TYPES[point.kind]


def GetPointPos(instance: Point) -> Vector:
    """Return the position, m."""
    return to_tuple(_motion(instance)[0])


def GetPointVel(instance: Point) -> Vector:
    """Return the velocity, m/s."""
    return to_tuple(_motion(instance)[1])


@raising
def GetPointForce(instance: Point) -> Vector:
    """Return the force of its lines on a point, with its weight, buoyancy and drag; without inertia, N."""
    load = of(Point, instance).block["end_load"]
    lines = sum((load[line, end] for line, end in _attached(instance)), np.zeros(3))
    return to_tuple(lines + instance.system.own_load(instance.place))


def GetPointM(instance: Point) -> tuple[Vector, Vector, Vector]:
    """Return the mass matrix with added mass and those of the ends of its lines, kg."""
    system, built = of(Point, instance), instance.system.built
    row = int(built.system.lines.node_ptr[-1]) + instance.place
    a, b, c, d, e, f = condense_point(built.system, built.state, row, instance.place, Weights(1.0, 0.0, 0.0))
    M = np.array([[a, b, c], [b, d, e], [c, e, f]])
    for line, end in _attached(instance):
        M = M + system.masses[built.names.node_ptr[line + end] - end]
    return to_tuple(M)  # type: ignore[return-value]


def GetPointNAttached(instance: Point) -> int:
    """Return the number of line ends on a point."""
    return len(_attached(instance))


@raising
def GetPointAttached(instance: Point, i: int) -> tuple[Line, int]:
    """Return a line on a point, and which end of it (ENDPOINT_A or ENDPOINT_B)."""
    ends = _attached(instance)
    if not 0 <= i < len(ends):
        raise RuntimeError(f"point {GetPointID(instance)} has {len(ends)} lines, no number {i}")
    return Line(instance.system, ends[i][0]), ends[i][1]


def _point(instance: Point):
    return of(Point, instance).model.points[instance.place]


def _motion(instance: Point) -> tuple[np.ndarray, np.ndarray]:
    return of(Point, instance).point_motion(instance.place)


def _attached(instance: Point) -> list[tuple[int, int]]:
    lines = of(Point, instance).built.system.lines
    return [(int(k), int(end)) for k, end in np.argwhere(lines.end_point == instance.place)]
