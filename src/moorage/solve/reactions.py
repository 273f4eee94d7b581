"""What rods and bodies do to what holds them: the forces on all that they carry, with its inertia.

A host that moves an object has to move its mass too, and that of what rides on it: so it feels the sum of forces less
mass times acceleration, d'Alembert's. Where an object is pinned, the force is that on the pin.
"""

from __future__ import annotations

import numpy as np

from moorage.layout import Weights
from moorage.physics.point import sample_loads, wet_fraction
from moorage.physics.rigid import sample_rigid
from moorage.solve.carried import Block, own_load
from moorage.solve.water_at import row_of_holder, water_at
from moorage.system.build import Built
from moorage.system.objects import frame_along

FORCE = Weights(0.0, 0.0, 0.0)


def reactions(built: Built, block: Block, points: np.ndarray, time: np.ndarray) -> Block:
    """Return `rod_force` (n, rods, 6) and `body_force` (n, bodies, 6) about end A and the reference point, N and N m.

    Parameters
    ----------
    block : Block
        Of `moorage.solve.carried`, from loads of lines and of the nodes of rods with inertia.
    points : (n, holders, 9)
        Position, velocity and acceleration of points and ends of rods.
    time : (n,)
    """
    still = np.zeros((len(time), 6))
    rods = block.get("rod_force", np.zeros((len(time), 0, 6))).copy()
    for k in range(rods.shape[1]):
        rods[:, k] += rod_load(built, block, k, time)
    bodies = block.get("body_force", np.zeros((len(time), 0, 6))).copy()
    for k in range(bodies.shape[1]):
        origin = block["body_position"][:, k]
        moving = own_load(built, block, k, block["body_acceleration"][:, k], time)
        bodies[:, k] += moving - own_load(built, block, k, still, time)
        for holder in built.bodies.holders[k]:
            _add(bodies[:, k], point_load(built, holder, points[:, holder], time), points[:, holder, :3] - origin)
        for rod in built.bodies.pinned[k]:
            more = rods[:, rod, :3] - block["rod_force"][:, rod, :3]
            _add(bodies[:, k], more, block["rod_position"][:, rod, 0] - origin)
    return {"rod_force": rods, "body_force": bodies}


def _add(load: np.ndarray, force: np.ndarray, arm: np.ndarray) -> None:
    """Add a force (n, 3) at an arm to force and moment (n, 6)."""
    load[:, :3] += force
    load[:, 3:] += np.cross(arm, force)


def rod_load(built: Built, block: Block, k: int, time: np.ndarray) -> np.ndarray:
    """Return force and moment (n, 6) on rod k beside those of its nodes: given loads, inertia of its thickness."""
    ends, out = block["rod_position"][:, k], np.zeros((len(time), 6))
    number = int(built.rods.line[k]) - len(built.names.lines)
    if number < 0:  # without length or mass
        rates = (block[f"rod_{name}"][:, k, :3] for name in ("velocity", "acceleration"))
        out[:, :3] = point_load(built, built.rods.ends[k, 0], np.concatenate([ends[:, 0], *rates], axis=1), time)
        return out
    along = ends[:, 1] - ends[:, 0]
    axes = np.array([frame_along(e / np.linalg.norm(e)).ravel() for e in along])
    place = np.ascontiguousarray(ends[:, 0])
    motion = (np.ascontiguousarray(block[f"rod_{name}"][:, k]) for name in ("velocity", "acceleration"))
    water = water_at(built, time, place, np.full(len(time), row_of_holder(built, built.rods.ends[k, 0])))
    sample_rigid(built.rod_loads, number, water, place, axes, *motion, FORCE, out)
    return out


def point_load(built: Built, holder: int, motion: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Return weight, buoyancy, drag, given loads and inertia (n, 3) of a point by itself, N; motion (n, 9)."""
    p, out = built.system.points, np.zeros((len(time), 3))
    place, velocity = (np.ascontiguousarray(part) for part in (motion[:, :3], motion[:, 3:6]))
    water = water_at(built, time, place, np.full(len(time), row_of_holder(built, holder)))
    sample_loads(p, holder, water, place, velocity, FORCE, out)
    wet = np.array([wet_fraction(p.radius[holder], height)[0] for height in place[:, 2] - water[:, 0]])
    return out - (p.mass[holder] + wet * p.added_mass[holder])[:, None] * motion[:, 6:]
