"""Which nodes the seabed holds: friction is below its limit there."""

from __future__ import annotations

import math

import numpy as np

from moorage._jit import inlined, kernel
from moorage._vec3 import dot, get, scale, sub
from moorage.layout import line_nodes
from moorage.physics.bathymetry import bed_at, normal_of
from moorage.physics.friction import SATURATED, SOIL, VELOCITY, coefficients, share_given, split_directions
from moorage.physics.soil_curves import on_a_plateau
from moorage.system.assemble import unit_or_zero

BELOW = 0.998  # of the square of the limit: records lie between the ends of steps


@kernel
def find_sticking(system, position, velocity, normal_force, friction_force, sticks):
    """Write 1 for nodes that the seabed holds, 0 for those that slide or are off it, into `sticks` (nodes,)."""
    for line in range(len(system.lines.node_ptr) - 1):
        first, last = line_nodes(system.lines, line)
        for i in range(first, last + 1):
            sticks[i] = 0
            if normal_force[i] == 0.0:
                continue
            _, zx, zy, _, _, _ = bed_at(system.contact.bed, position[i, 0], position[i, 1])
            n = normal_of(zx, zy)
            q = unit_or_zero(sub(get(position, min(i + 1, last)), get(position, max(i - 1, first))))
            r, v, N = get(position, i), get(velocity, i), abs(normal_force[i])
            w, mu = sub(v, scale(dot(v, n), n)), coefficients(system.friction, r)
            if system.friction.law <= VELOCITY:
                sticks[i] = 1 if ramps(system.friction, N, split_directions(q, n), w) else 0
            elif system.friction.law == SOIL:
                s, f = split_directions(q, n), get(friction_force, i)
                sticks[i] = 0 if on_a_plateau(system.friction.curves, N, s, f, BELOW) else 1
            else:
                sticks[i] = (
                    1 if share_given(system.friction, mu, N, n, q, w, get(friction_force, i)) > 1.0 / BELOW else 0
                )


@inlined
def ramps(p, N, s, w):
    """Whether a law of the velocity is below its peak, along the line and across it."""
    along = abs(dot(w, s))
    across = math.sqrt(max(dot(w, w) - along * along, 0.0))
    if p.law == SATURATED:
        return p.slope * max(along, across) <= p.ratio * N
    return max(along, across) < p.velocity


def sticking(system, position, velocity, normal_force, friction_force) -> np.ndarray:
    """Return for rows of node histories whether the seabed holds a node, (m, nodes), 1 or 0."""
    sticks = np.zeros(normal_force.shape, dtype=np.int8)
    for row, out in enumerate(sticks):
        find_sticking(system, position[row], velocity[row], normal_force[row], friction_force[row], out)
    return sticks
