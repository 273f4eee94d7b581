"""Loads on a point by itself: weight, buoyancy, a constant force, isotropic added mass and drag.

Buoyancy and hydrodynamics act on the wet fraction of a sphere of the point's volume, (1 - s)^2 (2 + s) / 4 at the
centre's height s in radii above the surface; MoorDyn keeps them in air too, so that a float would leave the sea.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, kernel
from moorage._vec3 import add, dot, isotropic_plus, scale, sub


class PointLoads(NamedTuple):
    """Parameters of the points."""

    mass: np.ndarray  # (points,) kg
    added_mass: np.ndarray  # (points,) wet, kg
    weight: np.ndarray  # (points,) upwards, -g m, N
    displaced: np.ndarray  # (points,) mass of water, wet, kg
    buoyancy: np.ndarray  # (points,) its weight, N
    drag: np.ndarray  # (points,) wet, 0.5 rho CdA, N s2/m2
    radius: np.ndarray  # (points,) of the sphere of equal volume, m
    given: np.ndarray  # (points, 3, 3) constant force, N; linear, N s/m, and quadratic damping, N s2/m2

    @property
    def force(self) -> np.ndarray:
        """Constant forces, (points, 3), N."""
        return self.given[:, 0]


@inlined
def wet_fraction(radius, z):
    """Wet fraction of a sphere whose centre is z above the surface, and its slope (1/m)."""
    if z <= -radius:
        return 1.0, 0.0
    if z >= radius:
        return 0.0, 0.0
    s = z / radius
    return 0.25 * (1.0 - s) * (1.0 - s) * (2.0 + s), -0.75 * (1.0 - s * s) / radius


@inlined
def point_terms(p, k, water, r, v, a, c):
    """Force on point k and its block; water: elevation of the surface, velocity and acceleration of the water there."""
    eta, flow, swell = water
    wet, slope = wet_fraction(p.radius[k], r[2] - eta)
    u = sub(v, flow)
    speed = math.sqrt(dot(u, u))
    mass, drag = p.mass[k] + wet * p.added_mass[k], wet * p.drag[k]
    force = add(scale(-mass, a), scale(-drag * speed, u))
    force = add(force, scale(wet * (p.displaced[k] + p.added_mass[k]), swell))
    lift = p.weight[k] + wet * p.buoyancy[k]
    block = isotropic_plus(c.mass * mass + c.damping * drag * speed, c.damping * drag / (speed + 1e-9), u)
    linear = p.given[k, 1, 0], p.given[k, 1, 1], p.given[k, 1, 2]
    quadratic = p.given[k, 2, 0], p.given[k, 2, 1], p.given[k, 2, 2]
    damping, d = damping_terms(linear, quadratic, v, c)
    force = add(force, damping)
    total = force[0] + p.given[k, 0, 0], force[1] + p.given[k, 0, 1], force[2] + p.given[k, 0, 2] + lift
    rising = block[5] - c.stiffness * slope * p.buoyancy[k]
    return total, (block[0] + d[0], block[1], block[2], block[3] + d[1], block[4], rising + d[2])


@inlined
def damping_terms(linear, quadratic, v, c):
    """Force of linear and quadratic damping of a velocity axis by axis, and its diagonal block."""
    return (
        -(linear[0] + quadratic[0] * abs(v[0])) * v[0],
        -(linear[1] + quadratic[1] * abs(v[1])) * v[1],
        -(linear[2] + quadratic[2] * abs(v[2])) * v[2],
    ), (
        c.damping * (linear[0] + 2.0 * quadratic[0] * abs(v[0])),
        c.damping * (linear[1] + 2.0 * quadratic[1] * abs(v[1])),
        c.damping * (linear[2] + 2.0 * quadratic[2] * abs(v[2])),
    )


@kernel
def sample_loads(p, k, water, position, velocity, c, force):
    """Fill (n, 3) with the force on point k by itself, without its inertia, at (n, 3) positions and velocities.

    water: (n, 7) elevation of the surface, velocity and acceleration of the water.
    """
    for row in range(len(force)):
        r = position[row, 0], position[row, 1], position[row, 2]
        v = velocity[row, 0], velocity[row, 1], velocity[row, 2]
        w = water[row]
        around = w[0], (w[1], w[2], w[3]), (w[4], w[5], w[6])
        f = point_terms(p, k, around, r, v, (0.0, 0.0, 0.0), c)[0]
        force[row, 0], force[row, 1], force[row, 2] = f
