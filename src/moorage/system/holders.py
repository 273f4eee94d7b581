"""What line ends hold on to: points, and the ends of rods, on the ground, on bodies, or free.

Each holder is one 3-vector: prescribed (where it stays, or how it moves) or unknown. A clamp adds a direction. Bodies
that are fixed or coupled only carry; they need no rows of their own.
"""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from moorage.model import Attachment, Body, Failure, Model, Motion, Point, Rod
from moorage.model.motion import rotation_matrices


class Holders(NamedTuple):
    """Holders of a model: its points in the order of the file, then the rods' ends."""

    number: dict[Attachment, int]
    rest: np.ndarray  # (holders, 3) where they are described, m
    free: np.ndarray  # (holders,) bool
    coupled: np.ndarray  # (holders,) bool: moved by a motion
    moved: dict[int, np.ndarray]  # holder: (n, 3) positions at the times of the motion
    directions: dict[Attachment, np.ndarray]  # clamps: (3,) or (n, 3), the direction into the line
    joints: tuple[int, ...]  # holders that are free rods of no length


def timed_failures(model: Model) -> list[Failure]:
    """Return the failures that come at a time, in that order."""
    return sorted((f for f in model.failures if f.time > 0.0), key=lambda f: f.time)


def released_end(k: int) -> Attachment:
    """Return what stands for the free point of the k-th timed failure."""
    return Attachment("point", -1 - k)


def release(model: Model, released: frozenset[int]) -> Model:
    """Return the model with the lines of some timed failures (by their places) tied to points of their own."""
    lines = list(model.lines)
    for k, failure in enumerate(timed_failures(model)):
        if k not in released:
            continue
        for i, line in enumerate(lines):
            if line.id in failure.lines:
                ends = {
                    name: released_end(k) for name in ("end_a", "end_b") if getattr(line, name) == failure.attachment
                }
                lines[i] = dataclasses.replace(line, **ends)  # type: ignore[arg-type]
    return dataclasses.replace(model, lines=tuple(lines))


def holders_of(
    model: Model, motion: Motion | None, duration: float | None, released: frozenset[int] = frozenset()
) -> Holders:
    """List the holders of a model, with their motion."""
    bodies = motion.resolve_bodies(model) if motion else {}
    points = motion.resolve(model, duration) if motion else {}
    rods = motion.resolve_rods(model) if motion else {}
    number, rest, free, coupled, moved, directions = {}, [], [], [], {}, {}
    joints: list[int] = []
    failing = timed_failures(model)

    def add(position, is_free, is_coupled, track):
        rest.append(position if track is None else track[0])
        free.append(is_free)
        coupled.append(is_coupled)
        if track is not None:
            moved[len(rest) - 1] = track
        return len(rest) - 1

    for p in model.points:
        position, track = carried(model, p, bodies, points.get(p.id), np.array(p.position))
        on_moved = p.body is not None and _body(model, p.body).kind != "fixed"
        at = add(position, p.kind == "free" and p.body is None, p.kind == "coupled" or on_moved, track)
        number[Attachment("point", p.id)] = at
    for k, failure in enumerate(failing):
        # a free point that the lines of a failure take along; until then it stays where they are tied
        at = number.get(failure.attachment, 0)
        number[released_end(k)] = add(np.array(rest[at]), k in released, False, None)
    for rod in model.rods:
        at_a, direction = rods.get(rod.id, (None, None))
        on_moved = rod.body is not None and _body(model, rod.body).kind != "fixed"
        is_free, is_coupled = rod.kind == "free" and rod.body is None, rod.kind == "coupled" or on_moved
        a, track_a = carried(model, rod, bodies, at_a, np.array(rod.end_a))
        axis, axis_track = carried_axis(model, rod, bodies, direction)
        first = add(a, is_free, is_coupled, track_a)
        number[Attachment("rod", rod.id, "A")] = first
        if rod.segments == 0:
            number[Attachment("rod", rod.id, "B")] = first
            if is_free:
                joints.append(first)
        else:
            length = float(np.linalg.norm(np.subtract(rod.end_b, rod.end_a)))
            track_b = None if track_a is None else track_a + length * axis_track
            number[Attachment("rod", rod.id, "B")] = add(a + length * axis, is_free, is_coupled, track_b)
        if not is_free:
            toward = axis if axis_track is None else axis_track
            directions[Attachment("rod", rod.id, "A")] = -toward
            directions[Attachment("rod", rod.id, "B")] = toward
    return Holders(
        number,
        np.array(rest, dtype=float).reshape(-1, 3),
        np.array(free, dtype=bool),
        np.array(coupled, dtype=bool),
        moved,
        directions,
        tuple(joints),
    )


def carried(model: Model, thing: Point | Rod, bodies, own_track, position):
    """Position at rest (3,) and track (n, 3) or None of a point that may ride on a body."""
    if thing.body is None:
        return position, own_track
    body = _body(model, thing.body)
    rest = np.array(body.position) + _turn(body) @ position
    if body.id not in bodies:
        return rest, None
    x, R = bodies[body.id]
    return rest, x + R @ position


def carried_axis(model: Model, rod: Rod, bodies, own_track):
    """Direction of a rod at rest (3,) and its track (n, 3) or None."""
    axis = np.array(rod.direction)
    if rod.body is None:
        return axis, own_track
    body = _body(model, rod.body)
    return _turn(body) @ axis, (bodies[body.id][1] @ axis if body.id in bodies else None)


def _body(model: Model, id: int) -> Body:
    return next(body for body in model.bodies if body.id == id)


def _turn(body: Body) -> np.ndarray:
    return rotation_matrices(np.array([body.rotation]))[0]
