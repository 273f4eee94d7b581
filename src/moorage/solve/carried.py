"""Motion of rods and bodies, and the loads on them, from the records of a run."""

from __future__ import annotations

import numpy as np

from moorage.layout import Weights
from moorage.physics.motion import Tracks, sample_track
from moorage.physics.rigid import sample_rigid
from moorage.solve.water_at import row_of_body, row_of_holder, water_at
from moorage.system.build import Built

Block = dict[str, np.ndarray]


def carried(built: Built, points: np.ndarray, objects: Block, loads: Block, time: np.ndarray) -> Block:
    """Return the motion of all rods and bodies and the forces on them, without inertia.

    Parameters
    ----------
    points : (n, holders, 9)
        Position, velocity and acceleration of points and ends of rods.
    objects : Block
        Motion of the objects.
    loads : Block
        `end_load`, `end_moment` of lines; `rod_load` and `rod_load_moment` of the nodes of rods.
    time : (n,)
    """
    block: Block = {}
    if len(built.rods.line):
        block |= _rods(built, points[:, built.rods.ends], time)
    if len(built.bodies.object):
        block |= _bodies(built, points, objects, time)
        block["body_rotation"] = euler_angles(block["body_axes"])
    force, moment = _line_loads(built, loads)
    if len(built.rods.line):
        block["rod_force"] = _rod_force(built, block, force, moment, loads)
    if len(built.bodies.object):
        block["body_force"] = _body_force(built, block, points, force, moment, loads, time)
    return block


def euler_angles(R: np.ndarray) -> np.ndarray:
    """Return roll, pitch and yaw (..., 3), intrinsic XYZ, of rotations (..., 3, 3)."""
    pitch = np.arcsin(np.clip(R[..., 0, 2], -1.0, 1.0))
    return np.stack([np.arctan2(-R[..., 1, 2], R[..., 2, 2]), pitch, np.arctan2(-R[..., 0, 1], R[..., 0, 0])], axis=-1)


def _rods(built: Built, ends: np.ndarray, time: np.ndarray) -> Block:
    """Return the motion of the rods from that of their ends (n, rods, 2, 9), and which share of them is wet.

    Velocity and acceleration are those of end A with those of rotation across the axis, (n, rods, 6).
    """
    a, b = ends[:, :, 0], ends[:, :, 1]
    along = b[..., :3] - a[..., :3]
    square = np.maximum((along**2).sum(axis=-1), 1e-300)[..., None]
    spin, twist = (np.cross(along, b[..., k : k + 3] - a[..., k : k + 3]) / square for k in (3, 6))
    level = np.stack([_elevation(built, k, ends[:, k], time) for k in range(ends.shape[1])], axis=1)
    below = level - ends[..., 2]  # (n, rods, 2) depths of the ends
    low, high = below.max(axis=-1), below.min(axis=-1)
    wet = np.clip(low / np.maximum(low - high, 1e-12), 0.0, 1.0)
    return {
        "rod_position": ends[..., :3],
        "rod_velocity": np.concatenate([a[..., 3:6], spin], axis=-1),
        "rod_acceleration": np.concatenate([a[..., 6:], twist], axis=-1),
        "rod_submergence": np.where(high >= 0.0, 1.0, np.where(low <= 0.0, 0.0, wet)),
    }


def _elevation(built: Built, k: int, ends: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Return the elevation of the surface over the two ends of rod k, (n, 2), m; ends (n, 2, 9)."""
    rows = np.tile([row_of_holder(built, holder) for holder in built.rods.ends[k]], len(time))
    return water_at(built, np.repeat(time, 2), ends.reshape(-1, 9)[:, :3], rows)[:, 0].reshape(-1, 2)


def _bodies(built: Built, points: np.ndarray, objects: Block, time: np.ndarray) -> Block:
    """Return position, axes, and velocity and acceleration (with those of rotation, global) of the bodies."""
    n, bodies = len(points), built.bodies
    place, axes = np.zeros((n, len(bodies.object), 3)), np.zeros((n, len(bodies.object), 3, 3))
    rates, changes = np.zeros((n, len(bodies.object), 6)), np.zeros((n, len(bodies.object), 6))
    for k, (o, holder, first) in enumerate(zip(*bodies[:3], strict=True)):
        if o >= 0:
            place[:, k], axes[:, k] = objects["object_position"][:, o], objects["object_rotation"][:, o]
            rates[:, k] = np.concatenate([objects["object_velocity"][:, o], objects["object_spin"][:, o]], axis=1)
            changes[:, k] = np.concatenate(
                [objects["object_acceleration"][:, o], objects["object_twist"][:, o]], axis=1
            )
            continue
        place[:, k], rates[:, k, :3], changes[:, k, :3] = np.split(points[:, holder], 3, axis=1)
        axes[:, k], rates[:, k, 3:], changes[:, k, 3:] = _turning(built.system.tracks, first, time)
    return {"body_position": place, "body_axes": axes, "body_velocity": rates, "body_acceleration": changes}


def _turning(tracks: Tracks, first: int, time: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return rotation, angular velocity and acceleration (global) from the tracks of two axes."""
    e, v, a = (np.zeros((2, len(time), 3)) for _ in range(3))
    for j in range(2):
        sample_track(tracks, first + j, time, e[j], v[j], a[j])
    third = np.cross(e[0], e[1])
    rate = np.cross(v[0], e[1]) + np.cross(e[0], v[1])
    change = np.cross(a[0], e[1]) + 2.0 * np.cross(v[0], v[1]) + np.cross(e[0], a[1])
    # e_j' = w x e_j, so that w = sum e_j x e_j' / 2; and sum e_j' x e_j' = 0
    spin = 0.5 * (np.cross(e, v).sum(axis=0) + np.cross(third, rate))
    twist = 0.5 * (np.cross(e, a).sum(axis=0) + np.cross(third, change))
    return np.stack([e[0], e[1], third], axis=-1), spin, twist


def _line_loads(built: Built, loads: Block) -> tuple[np.ndarray, np.ndarray]:
    """Return force and moment (n, holders, 3) of all lines on the points and ends of rods."""
    ends = built.system.lines.end_point[: len(built.names.lines)].ravel()
    n, holders = len(loads["end_load"]), len(built.system.points.mass)
    out = np.zeros((2, holders, n, 3))
    for k, name in enumerate(("end_load", "end_moment")):
        np.add.at(out[k], ends, loads[name].reshape(n, len(ends), 3).swapaxes(0, 1))
    return out[0].swapaxes(0, 1), out[1].swapaxes(0, 1)


def _rod_force(built: Built, block: Block, force, moment, loads: Block) -> np.ndarray:
    """Return force and moment about end A (n, rods, 6) of lines, weight, water and seabed on the rods."""
    n, rods = len(force), built.rods
    out = np.zeros((n, len(rods.line), 6))
    for k, (a, b) in enumerate(rods.ends):
        arm = block["rod_position"][:, k, 1] - block["rod_position"][:, k, 0]
        for holder in {int(a), int(b)}:
            out[:, k, :3] += force[:, holder]
            out[:, k, 3:] += moment[:, holder]
        if a != b:
            out[:, k, 3:] += np.cross(arm, force[:, b])
        if rods.line[k] >= 0:
            j = rods.line[k] - len(built.names.lines)
            out[:, k, :3] += loads["rod_load"][:, j]
            out[:, k, 3:] += loads["rod_load_moment"][:, j]
    return out


def _body_force(built: Built, block: Block, points, force, moment, loads: Block, time) -> np.ndarray:
    """Return force and moment about the reference points (n, bodies, 6) of what bodies carry, and of themselves."""
    bodies, out = built.bodies, np.zeros((len(points), len(built.bodies.object), 6))
    still = np.zeros((len(points), 6))
    for k in range(len(bodies.object)):
        origin = block["body_position"][:, k]
        out[:, k] = own_load(built, block, k, still, time)
        for holder in bodies.holders[k]:
            out[:, k, :3] += force[:, holder]
            out[:, k, 3:] += moment[:, holder] + np.cross(points[:, holder, :3] - origin, force[:, holder])
        for rod in bodies.rods[k]:
            j = built.rods.line[rod] - len(built.names.lines)
            arm = block["rod_position"][:, rod, 0] - origin
            out[:, k, :3] += loads["rod_load"][:, j]
            out[:, k, 3:] += loads["rod_load_moment"][:, j] + np.cross(arm, loads["rod_load"][:, j])
        for rod in bodies.pinned[k]:
            pull = block["rod_force"][:, rod, :3]
            out[:, k, :3] += pull
            out[:, k, 3:] += np.cross(block["rod_position"][:, rod, 0] - origin, pull)
    return out


def own_load(built: Built, block: Block, k: int, acceleration: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Return force and moment (n, 6) on body k by itself: weight, water, given loads, inertia."""
    place, n = np.ascontiguousarray(block["body_position"][:, k]), len(time)
    water, out = water_at(built, time, place, np.full(n, row_of_body(built, k))), np.empty((n, 6))
    sample_rigid(
        built.body_loads, k, water, place, np.ascontiguousarray(block["body_axes"][:, k].reshape(n, 9)),
        np.ascontiguousarray(block["body_velocity"][:, k]), np.ascontiguousarray(acceleration),
        Weights(0.0, 0.0, 0.0), out,
    )  # fmt: skip
    return out
