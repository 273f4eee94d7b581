"""Seabed of a model: its surface and its friction."""

from __future__ import annotations

import numpy as np

from moorage.model import Environment, Model
from moorage.physics import friction as law
from moorage.physics.bathymetry import Bathymetry, flat_bed, grid_bed
from moorage.physics.contact import Contact
from moorage.physics.grid import build_grid, no_grid
from moorage.physics.soil import Law, Soil, no_soil, soil_under
from moorage.physics.table import build_tables

LAWS = {
    "saturated-damping": law.SATURATED,
    "velocity-dependent": law.VELOCITY,
    "elastic-slip": law.ELASTIC,
    "stick-slip": law.STICK_SLIP,
    "soil-curves": law.SOIL,
}


def build_bed(env: Environment) -> Bathymetry:
    """Return the surface of the seabed."""
    grid = env.bathymetry
    return grid_bed(grid.x, grid.y, grid.depth, grid.smooth) if grid else flat_bed(-env.water_depth)


def build_contact(env: Environment, area, length) -> Contact:
    """Return the contact with the seabed; `area` is d l of the nodes, m2, `length` the line that they stand for, m."""
    kb = env.seabed_stiffness_map
    return Contact(
        area * (1.0 if kb else env.seabed_stiffness),
        area * env.seabed_damping,
        build_bed(env),
        build_grid(kb.x, kb.y, kb.stiffness, kb.stiffness) if kb else no_grid(),
        build_soil(env, area, length),
    )


def build_soil(env: Environment, area, length) -> Soil:
    """Return the soil that remembers; `area` is d l of the nodes, m2, `length` the line that they stand for, m."""
    s = env.soil
    if s is None:
        return no_soil()
    lift = 0.0 if s.density is None else s.buoyancy_factor * (s.density - env.water_density) * env.gravity
    law = Law(
        s.bearing_factor, s.bearing_exponent, s.shear_strength, s.strength_gradient, s.maximum_stiffness,
        s.suction_ratio, s.suction_decay, s.repenetration_offset, lift,
    )  # fmt: skip
    return soil_under(length, area / length, law)


def build_friction(model: Model, area, mass) -> law.Friction:
    """Return the friction of the seabed; `area` is d l of the nodes, m2, `mass` theirs, kg."""
    env, f = model.environment, model.environment.friction
    zero = np.zeros_like(area)
    if f is None or f.largest <= 0.0:
        return law.Friction(law.NONE, 0.0, 0.0, 1.0, 0.0, 1.0, zero, zero.copy(), False, no_grid(), build_tables([]))
    spring = (env.seabed_stiffness if f.shear_stiffness is None else f.shear_stiffness) * area
    # equations (11) and (12) have the static coefficient in the slope of the ramp, the programs the kinetic one
    slope = f.damping * (f.static_ratio if model.flavour == "native" else 1.0)
    damper = {"stick-slip": env.seabed_damping * area, "elastic-slip": 2.0 * f.shear_damping * np.sqrt(spring * mass)}
    mu = f.map
    axial, transverse, grid = (
        (1.0, 1.0, build_grid(mu.x, mu.y, mu.axial, mu.transverse)) if mu else (f.axial, f.transverse, no_grid())
    )
    curves = build_tables([f.axial_curve, f.transverse_curve] if f.model == "soil-curves" else [])
    return law.Friction(
        LAWS[f.model], axial, transverse, f.static_ratio, slope, f.velocity, spring, damper.get(f.model, zero), f.laid,
        grid, curves,
    )  # fmt: skip
