"""Check that everything that forces move has inertia in all the ways in which it can move."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from moorage.errors import Problem
from moorage.model.components import Attachment, Body, Rod
from moorage.model.model import Model

LEAST = 1e-10  # of the largest inertia: less is rounding
KINDS = ("free", "pinned", "coupled-pinned")
WAYS = ("along x", "along y", "along z", "about x", "about y", "about z")


def objects_have_inertia(model: Model) -> Iterator[Problem]:
    """Rods and bodies that move have mass, and inertia about every axis about which they can turn."""
    try:
        every: tuple[Rod | Body, ...] = (*model.rods, *model.bodies)
        moving = [thing for thing in every if thing.kind in KINDS and (isinstance(thing, Body) or _has_length(thing))]
        inertia = [_body(model, thing) if isinstance(thing, Body) else _rod(model, thing) for thing in moving]
    except (StopIteration, KeyError, ZeroDivisionError):
        return  # names or lengths are wrong, which others say
    for thing, M in zip(moving, inertia, strict=True):
        name = f"{'body' if isinstance(thing, Body) else 'rod'} {thing.id}"
        if not np.isfinite(M).all():
            continue
        free = np.arange(0 if thing.kind == "free" else 3, 6)
        if isinstance(thing, Rod):
            free = free[free != 3]  # a rod does not spin about its axis
        way = _without_inertia(M, free)
        if way is None:
            continue
        what = "move without mass" if way < 3 else "turn without inertia"
        own = "the body" if isinstance(thing, Body) else "the rod, whose x is along it"
        remedy = "give it inertia (I) there" if isinstance(thing, Body) and way >= 3 else "give it mass"
        yield Problem(
            f"{name} is {thing.kind}, and can {what} {WAYS[way]} of {own}",
            f"{remedy}, or let it carry what has mass off that axis, or hold it (fixed, coupled)",
            thing.source,
        )


def _without_inertia(M: np.ndarray, free: np.ndarray) -> int | None:
    """Return the main way of a motion without inertia (rotation, where it turns), None where there is none."""
    values, vectors = np.linalg.eigh(M[np.ix_(free, free)])
    if values[0] > LEAST * max(values[-1], 1e-300):
        return None
    motion = np.zeros(6)
    motion[free] = vectors[:, 0]
    turns = np.abs(motion[3:]).max() > 1e-6
    return int(3 + np.argmax(np.abs(motion[3:])) if turns else np.argmax(np.abs(motion)))


def _has_length(rod: Rod) -> bool:
    return rod.segments > 0 and rod.end_a != rod.end_b


def _at(mass: float, arm, J=0.0) -> np.ndarray:
    """Inertia (6, 6) of a mass at an arm with inertia J about its own centre, about the reference point."""
    x, y, z = arm
    G = np.hstack([np.eye(3), [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]])
    M = mass * G.T @ G
    M[3:, 3:] += J
    return M


def _lines(model: Model, end: Attachment, arm) -> np.ndarray:
    """Inertia of the halves of the first segments of all lines on something."""
    M = np.zeros((6, 6))
    for line in model.lines:
        for place, section, k in ((line.end_a, line.sections[0], 0), (line.end_b, line.sections[-1], -1)):
            if place == end:
                M += _at(0.5 * section.segment_lengths[k] * model.line_type(section.line_type).mass_per_length, arm)
    return M


def _cylinder(model: Model, rod: Rod, axis: np.ndarray, end: np.ndarray) -> np.ndarray:
    """Inertia of a rod from an end A along an axis, of the water that it takes along, and of the lines on it."""
    kind = next(t for t in model.rod_types if t.name.lower() == rod.rod_type.lower())
    L, d = float(np.linalg.norm(np.subtract(rod.end_b, rod.end_a))), kind.diameter
    m = kind.mass_per_length * L
    water = model.environment.water_density * np.pi / 4.0 * d**2 * L * kind.transverse_added_mass
    across = np.eye(3) - np.outer(axis, axis)
    J = (m + water) * L**2 / 12.0 * across + m * d**2 / 16.0 * (2.0 * np.eye(3) - across)
    M = _at(m, end + 0.5 * L * axis, J)
    M[:3, :3] += water * across
    M += _lines(model, Attachment("rod", rod.id, "A"), end)
    return M + _lines(model, Attachment("rod", rod.id, "B"), end + L * axis)


def _rod(model: Model, rod: Rod) -> np.ndarray:
    return _cylinder(model, rod, np.array([1.0, 0.0, 0.0]), np.zeros(3))


def _body(model: Model, body: Body) -> np.ndarray:
    """Inertia of a body with all that it carries, in its axes about its reference point."""
    displaced = model.environment.water_density * body.volume
    M = _at(body.mass, body.centre_of_gravity, np.diag(body.inertia))
    M += np.diag(displaced * np.array(body.added_mass))
    for point in model.points:
        if point.body == body.id:
            water = model.environment.water_density * point.volume * point.added_mass
            M += _at(point.mass + water, point.position) + _lines(model, Attachment("point", point.id), point.position)
    for rod in model.rods:
        if rod.body != body.id:
            continue
        if _has_length(rod) and rod.kind != "pinned":
            M += _cylinder(model, rod, np.array(rod.direction), np.array(rod.end_a))
        elif _has_length(rod):
            M += _at(float(_rod(model, rod)[1, 1]), rod.end_a)
        else:
            M += _lines(model, Attachment("rod", rod.id, "A"), rod.end_a)
            M += _lines(model, Attachment("rod", rod.id, "B"), rod.end_a)
    return M
