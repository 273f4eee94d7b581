"""Seabed of a model: its surface and its friction."""

from __future__ import annotations

import numpy as np

from moorage.model import Environment, Model
from moorage.physics import friction as law
from moorage.physics.bathymetry import Bathymetry, flat_bed, grid_bed

LAWS = {
    "saturated-damping": law.SATURATED,
    "velocity-dependent": law.VELOCITY,
    "elastic-slip": law.ELASTIC,
    "stick-slip": law.STICK_SLIP,
}


def build_bed(env: Environment) -> Bathymetry:
    """Return the surface of the seabed."""
    grid = env.bathymetry
    return grid_bed(grid.x, grid.y, grid.depth, grid.smooth) if grid else flat_bed(-env.water_depth)


def build_friction(model: Model, area) -> law.Friction:
    """Return the friction of the seabed; `area` is d l of the nodes, m2."""
    env, f = model.environment, model.environment.friction
    zero = np.zeros_like(area)
    if f is None or max(f.axial, f.transverse) <= 0.0:
        return law.Friction(law.NONE, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, zero, zero.copy(), False)
    spring = (env.seabed_stiffness if f.shear_stiffness is None else f.shear_stiffness) * area
    # equations (11) and (12) have the static coefficient in the slope of the ramp, the programs the kinetic one
    slope = f.damping * (f.static_ratio if model.flavour == "native" else 1.0)
    damper = env.seabed_damping * area if f.model == "stick-slip" else zero
    return law.Friction(
        LAWS[f.model], f.axial, f.transverse, f.static_ratio, slope * f.axial, slope * f.transverse, f.velocity,
        spring, damper, f.laid,
    )  # fmt: skip
