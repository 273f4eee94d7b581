"""What line ends hold on to: points, and the ends of rods, on the ground, on bodies, or free.

Each holder is one 3-vector: prescribed (where it stays, or how it moves), unknown, or riding on an object (a rod or
body that forces move, see `system.objects`). A clamp adds a direction. Bodies that are fixed or coupled only carry, and
need no rows of their own.
"""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from moorage.model import Attachment, Body, Model, Motion, Point, Rod
from moorage.model.motion import MOVED, rotation_matrices
from moorage.system.objects import Objects, objects_of


class Holders(NamedTuple):
    """Holders of a model: its points in the order of the file, the rods' ends, pins, bodies, released line ends."""

    number: dict[Attachment, int]
    rest: np.ndarray  # (holders, 3) where they are described, m
    free: np.ndarray  # (holders,) bool
    coupled: np.ndarray  # (holders,) bool: moved by a motion
    moved: dict[int, np.ndarray]  # holder: (n, 3) positions at the times of the motion
    directions: dict[Attachment, np.ndarray]  # clamps: (3,) or (n, 3), the direction into the line
    joints: tuple[int, ...]  # holders that are free rods of no length, without a rotation of their own
    objects: Objects
    of_point: np.ndarray  # (holders,) object that it rides on, -1
    arm: np.ndarray  # (holders, 3) in the object's axes, m
    turning: dict[Attachment, tuple[int, np.ndarray]]  # clamps on objects: the object, the direction in its axes
    pin: np.ndarray  # (objects,) holder that an object is pinned to, -1
    place: dict[int, int]  # bodies that are held: the holder at the reference point
    axes: dict[int, np.ndarray]  # and how they are turned, (3, 3) or (n, 3, 3)


def released_end(k: int) -> Attachment:
    """Return what stands for the free point of the k-th failure."""
    return Attachment("point", -1 - k)


def release(model: Model, released: tuple[int, ...]) -> Model:
    """Return the model with the lines of some failures (their places, as they came) tied to points of their own.

    What has come off already is left where it is.
    """
    lines = list(model.lines)
    for k in released:
        failure = model.failures[k]
        for i, line in enumerate(lines):
            if line.id in failure.lines:
                ends = {
                    name: released_end(k) for name in ("end_a", "end_b") if getattr(line, name) == failure.attachment
                }
                lines[i] = dataclasses.replace(line, **ends)  # type: ignore[arg-type]
    return dataclasses.replace(model, lines=tuple(lines))


def holders_of(model: Model, motion: Motion | None, duration: float | None, released: tuple[int, ...] = ()) -> Holders:
    """List the holders of a model, with their motion."""
    bodies = motion.resolve_bodies(model) if motion else {}
    points = motion.resolve(model, duration) if motion else {}
    rods = motion.resolve_rods(model) if motion else {}
    objects = objects_of(model)
    number, rest, free, coupled, moved, directions = {}, [], [], [], {}, {}
    joints: list[int] = []
    riding: dict[int, tuple[int, np.ndarray]] = {}
    turning: dict[Attachment, tuple[int, np.ndarray]] = {}

    def add(position, is_free, is_coupled, track):
        rest.append(position if track is None else track[0])
        free.append(is_free)
        coupled.append(is_coupled)
        if track is not None:
            moved[len(rest) - 1] = track
        return len(rest) - 1

    def ride(o: int, arm) -> int:
        """Add a holder at an arm on an object."""
        at = add(objects.position[o] + objects.rotation[o] @ arm, False, False, None)
        riding[at] = o, np.asarray(arm, dtype=float)
        return at

    for p in model.points:
        name, carrier = Attachment("point", p.id), objects.number.get(("body", p.body))
        if carrier is not None:
            number[name] = ride(carrier, np.array(p.position))
            continue
        position, track = carried(model, p, bodies, points.get(p.id), np.array(p.position))
        on_moved = p.body is not None and _body(model, p.body).kind != "fixed"
        at = add(position, p.kind == "free" and p.body is None, p.kind == "coupled" or on_moved, track)
        number[name] = at
    for rod in model.rods:
        end_a, end_b = Attachment("rod", rod.id, "A"), Attachment("rod", rod.id, "B")
        own, carrier = objects.number.get(("rod", rod.id)), objects.number.get(("body", rod.body))
        length = float(np.linalg.norm(np.subtract(rod.end_b, rod.end_a)))
        axis = np.array(rod.direction)
        if own is not None:
            number[end_a] = number[end_b] = ride(own, np.zeros(3))
            if rod.segments:
                number[end_b] = ride(own, np.array([length, 0.0, 0.0]))
            turning[end_a], turning[end_b] = (own, np.array([-1.0, 0.0, 0.0])), (own, np.array([1.0, 0.0, 0.0]))
            continue
        if carrier is not None:
            number[end_a] = ride(carrier, np.array(rod.end_a))
            number[end_b] = ride(carrier, np.array(rod.end_b)) if rod.segments else number[end_a]
            if rod.kind != "pinned":
                turning[end_a], turning[end_b] = (carrier, -axis), (carrier, axis)
            continue
        at_a, direction = rods.get(rod.id, (None, None))
        on_moved = rod.body is not None and _body(model, rod.body).kind != "fixed"
        is_free = rod.kind == "free" and rod.body is None
        is_coupled = rod.kind in MOVED or on_moved
        a, track_a = carried(model, rod, bodies, at_a, np.array(rod.end_a))
        axis, axis_track = carried_axis(model, rod, bodies, direction)
        number[end_a] = number[end_b] = first = add(a, is_free, is_coupled, track_a)
        if rod.segments:
            track_b = None if track_a is None else track_a + length * axis_track
            number[end_b] = add(a + length * axis, is_free, is_coupled, track_b)
        elif is_free:
            joints.append(first)
        if rod.kind not in ("free", "pinned", "coupled-pinned"):
            toward = axis if axis_track is None else axis_track
            directions[end_a], directions[end_b] = -toward, toward
    pin = np.full(len(objects.names), -1, dtype=np.int64)
    for o, (kind, id) in enumerate(objects.names):
        thing = objects.things[o]
        if thing.kind == "free":
            continue
        carrier = objects.number.get(("body", thing.body)) if isinstance(thing, Rod) else None
        if carrier is not None:
            pin[o] = ride(carrier, np.array(thing.end_a))  # type: ignore[union-attr]
            continue
        place = np.array(thing.end_a if isinstance(thing, Rod) else thing.position)
        track = (rods if kind == "rod" else bodies).get(id, (None, None))[0]
        if isinstance(thing, Rod) and thing.body is not None:
            place, track = carried(model, thing, bodies, None, place)
        on_moved = isinstance(thing, Rod) and thing.body is not None and _body(model, thing.body).kind != "fixed"
        pin[o] = add(place, False, thing.kind == "coupled-pinned" or on_moved, track)
    places: dict[int, int] = {}
    axes: dict[int, np.ndarray] = {}
    for body in model.bodies:
        if ("body", body.id) not in objects.number:
            x, R = bodies.get(body.id, (None, None))
            places[body.id] = add(np.array(body.position), False, body.kind == "coupled", x)
            axes[body.id] = _turn(body) if R is None else R
    taken = {tie for line in release(model, released).lines for tie in (line.end_a, line.end_b)}
    for k, failure in enumerate(model.failures):
        # a free point that the lines of a failure take along; until then it stays where they are tied
        at = number.get(failure.attachment, 0)
        number[released_end(k)] = add(np.array(rest[at]), released_end(k) in taken, False, None)
    count = len(rest)
    of_point, arm = np.full(count, -1, dtype=np.int64), np.zeros((count, 3))
    for holder, (o, at) in riding.items():
        of_point[holder], arm[holder] = o, at
    return Holders(
        number,
        np.array(rest, dtype=float).reshape(-1, 3),
        np.array(free, dtype=bool),
        np.array(coupled, dtype=bool),
        moved,
        directions,
        tuple(joints),
        objects,
        of_point,
        arm,
        turning,
        pin,
        places,
        axes,
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
