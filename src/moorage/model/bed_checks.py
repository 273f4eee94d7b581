"""What a seabed must fulfil: a depth grid that is one, anchors on it, and possible coefficients of friction."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import isfinite

from moorage.errors import Problem
from moorage.model.bed_doubts import extent, is_inside
from moorage.model.components import Curve
from moorage.model.environment import Bathymetry, Friction, FrictionMap, Soil, StiffnessMap
from moorage.model.model import Model
from moorage.model.seabed import is_anchor


def depths_are_positive(model: Model) -> Iterator[Problem]:
    """A depth grid is a grid without holes, and all of it is under water."""
    grid = model.environment.bathymetry
    if grid is None:
        return
    for name, axis in (("x", grid.x), ("y", grid.y)):
        if not axis or not all(b > a for a, b in pairwise(axis)) or not all(map(isfinite, axis)):
            yield Problem(f"{name} of the depth grid does not increase", "sort the grid", grid.source)
    if len(grid.depth) != len(grid.x) or any(len(row) != len(grid.y) for row in grid.depth):
        yield Problem("depth grid is not rectangular", "give a depth for each x and y", grid.source)
        return
    yield from _holes(grid)
    shallowest = min((depth for row in grid.depth for depth in row if isfinite(depth)), default=0.0)
    if shallowest <= 0.0:
        remedy = "give positive depths (z negative)"
        yield Problem("seabed reaches the water's surface", remedy, grid.source, -shallowest)


def _holes(grid: Bathymetry) -> Iterator[Problem]:
    holes = [(i, j) for i, row in enumerate(grid.depth) for j, depth in enumerate(row) if not isfinite(depth)]
    if holes:
        i, j = holes[0]
        message = f"depth grid has {len(holes)} cells without depth, the first at x {grid.x[i]:g} m, y {grid.y[j]:g} m"
        yield Problem(message, "give their depths, or read a raster with a fill", grid.source)


def anchors_are_on_the_grid(model: Model) -> Iterator[Problem]:
    """Anchors stand where their depth is known."""
    grid = model.environment.bathymetry
    if grid is None or any(depths_are_positive(model)):
        return
    for point in model.points:
        if is_anchor(point, model.environment) and not is_inside(grid, *point.position[:2]):
            message = f"anchor (fixed point {point.id}) is outside the depth grid ({extent(grid)})"
            yield Problem(message, "give a grid that covers it", point.source, point.position[:2])


def friction_is_possible(model: Model) -> Iterator[Problem]:
    """Coefficients are not negative, static friction is not below kinetic, and what it needs is positive."""
    friction = model.environment.friction
    if friction is None:
        return
    for name in ("transverse", "axial", "shear_damping"):
        if getattr(friction, name) < 0.0:
            message = f"{name.replace('_', ' ')} of seabed friction must not be negative"
            yield Problem(message, "correct the value", friction.source, getattr(friction, name))
    for name in ("damping", "shear_stiffness", "velocity"):
        value = getattr(friction, name)
        if value is not None and value <= 0.0:
            message = f"{name.replace('_', ' ')} of seabed friction must be positive"
            yield Problem(message, "correct the value", friction.source, value)
    if friction.static_ratio < 1.0:
        remedy = "give a ratio of static to kinetic friction of at least 1"
        yield Problem("static friction is below kinetic friction", remedy, friction.source, friction.static_ratio)
    if friction.map is not None and max(abs(friction.axial), abs(friction.transverse)) > 0.0:
        message = "seabed friction has coefficients and a map of them"
        yield Problem(message, "give either axial and transverse, or map", friction.source)
    yield from _curve_problems(friction)


def _curve_problems(friction: Friction) -> Iterator[Problem]:
    """Curves go with soil-curves and nothing else; each rises from 0, 0 to its end."""
    curves = {"axial_curve": friction.axial_curve, "transverse_curve": friction.transverse_curve}
    if friction.model != "soil-curves":
        if any(curve is not None for curve in curves.values()):
            yield Problem(
                "curves of friction go with the model soil-curves", "write it", friction.source, friction.model
            )
        return
    if friction.map is not None or max(abs(friction.axial), abs(friction.transverse)) > 0.0:
        message = "soil-curves take no coefficients"
        yield Problem(message, "give axial_curve and transverse_curve only", friction.source)
    for name, curve in curves.items():
        if not isinstance(curve, Curve) or len(curve.x) < 2 or len(curve.x) != len(curve.y):
            remedy = f"give {name}: {{x: [0, ...], y: [0, ...]}}"
            yield Problem(f"soil-curves need a table as {name}", remedy, friction.source)
            continue
        if curve.x[0] != 0.0 or curve.y[0] != 0.0:
            yield Problem(f"{name} of friction does not start at 0, 0", "add that row", friction.source)
        if any(b <= a for a, b in pairwise(curve.x)):
            yield Problem(f"displacements of {name} do not increase", "sort the rows", friction.source)
        if any(b < a for a, b in pairwise(curve.y)):
            remedy = "give its residual: a peak that is lost by slipping is not simulated"
            yield Problem(f"{name} of friction falls", remedy, friction.source)


def soil_is_possible(model: Model) -> Iterator[Problem]:
    """A soil bears something, its numbers have the signs that they must, and nothing else gives the normal force."""
    env, soil = model.environment, model.environment.soil
    if soil is None:
        return
    yield from _soil_signs(soil)
    if soil.shear_strength == 0.0 and soil.strength_gradient == 0.0:
        message = "soil has no strength"
        yield Problem(message, "give shear_strength or strength_gradient", soil.source)
    if soil.density is not None and not soil.density > env.water_density:
        message = f"density of the soil is not above that of the water, {env.water_density:g} kg/m3"
        yield Problem(message, "give that of the saturated soil, or leave it out", soil.source, soil.density)
    if env.seabed_stiffness_map is not None:
        message = "seabed has a soil and a map of the stiffness"
        yield Problem(message, "give one of soil and seabed_stiffness_map", soil.source)


def _soil_signs(soil: Soil) -> Iterator[Problem]:
    for name in ("bearing_factor", "maximum_stiffness", "suction_decay"):
        if not getattr(soil, name) > 0.0:
            message = f"{name.replace('_', ' ')} of the soil must be positive"
            yield Problem(message, "correct the value", soil.source, getattr(soil, name))
    for name in (
        "shear_strength", "strength_gradient", "bearing_exponent", "suction_ratio", "repenetration_offset",
        "buoyancy_factor",
    ):  # fmt: skip
        if getattr(soil, name) < 0.0:
            message = f"{name.replace('_', ' ')} of the soil must not be negative"
            yield Problem(message, "correct the value", soil.source, getattr(soil, name))


def maps_are_grids(model: Model) -> Iterator[Problem]:
    """Maps of the seabed's properties have a value, not negative, for each x and y, which increase."""
    env = model.environment
    if env.friction is not None and env.friction.map is not None:
        grid = env.friction.map
        yield from _map_problems("friction map", grid, {"axial": grid.axial, "transverse": grid.transverse})
    if env.seabed_stiffness_map is not None:
        kb = env.seabed_stiffness_map
        yield from _map_problems("stiffness map", kb, {"stiffness": kb.stiffness})


def _map_problems(
    name: str, grid: FrictionMap | StiffnessMap, tables: dict[str, tuple[tuple[float, ...], ...]]
) -> Iterator[Problem]:
    for word, axis in (("x", grid.x), ("y", grid.y)):
        if not axis or not all(b > a for a, b in pairwise(axis)) or not all(map(isfinite, axis)):
            yield Problem(f"{word} of the {name} does not increase", "sort the grid", grid.source)
    for word, table in tables.items():
        if len(table) != len(grid.x) or any(len(row) != len(grid.y) for row in table):
            message = f"{word} of the {name} is not {len(grid.x)} rows of {len(grid.y)} values"
            yield Problem(message, "give a row for each x with a value for each y", grid.source)
        bad = [value for row in table for value in row if not (isfinite(value) and value >= 0.0)]
        if bad:
            yield Problem(f"{word} of the {name} must not be negative", "correct the values", grid.source, bad[0])
