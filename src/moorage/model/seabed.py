"""Points and the seabed: who stands below it, and putting them on it."""

from __future__ import annotations

import dataclasses

from moorage.model.components import Point
from moorage.model.environment import Environment
from moorage.model.model import Model

TOLERANCE = 1e-3  # m; coordinates in files are rounded
ABOVE, NEAR = 0.1, 0.1  # m over a depth grid that is no rounding, and part of the depth that is no anchor any more


def below_seabed(point: Point, environment: Environment) -> float:
    """Return how far (m) a fixed point stands below the seabed, 0 when it does not."""
    if point.kind != "fixed" or point.body is not None or point.on_seabed:
        return 0.0
    x, y, z = point.position
    depth = environment.depth_at(x, y)
    return -depth - z if z < -depth - TOLERANCE else 0.0


def above_seabed(point: Point, environment: Environment) -> float:
    """Return how far (m) a fixed point stands over a depth grid, 0 when it stands on it or too high to be put on it.

    Over a flat seabed its depth is in sight of the point's z, so that nothing is moved there.
    """
    if point.kind != "fixed" or point.body is not None or point.on_seabed or environment.bathymetry is None:
        return 0.0
    x, y, z = point.position
    depth = environment.depth_at(x, y)
    return z + depth if ABOVE < z + depth < NEAR * depth else 0.0


def is_anchor(point: Point, environment: Environment) -> bool:
    """Return whether a point is held at the seabed: fixed, and nearer to it than to the water's surface."""
    if point.kind != "fixed" or point.body is not None:
        return False
    return point.on_seabed or point.position[2] < -0.5 * environment.depth_at(*point.position[:2])


def raise_to_seabed(model: Model) -> Model:
    """Return the model with its fixed points that stand below the seabed, or a little above it, put on it."""
    env = model.environment
    return _with_points(model, lambda point: below_seabed(point, env) > 0.0 or above_seabed(point, env) > 0.0)


def place_on_seabed(model: Model) -> Model:
    """Return the model with z of the points described as lying on the seabed."""
    return _with_points(model, lambda point: point.on_seabed)


def _with_points(model: Model, moves) -> Model:
    points = tuple(_at_seabed(p, model.environment) if moves(p) else p for p in model.points)
    return dataclasses.replace(model, points=points)


def _at_seabed(point: Point, environment: Environment) -> Point:
    x, y, _ = point.position
    return dataclasses.replace(point, position=(x, y, -environment.depth_at(x, y)))
