"""Inertia of everything that forces move, in all the ways in which it can move.

A body may be a mass at a point, or be put together of points on one axis. It turns about such an axis without inertia,
and nothing turns it there. It is lent the inertia of a ball of water of the mass that moves with it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from moorage.errors import Problem
from moorage.model.components import Attachment, Body, Rod
from moorage.model.model import Model

LEAST = 1e-10  # of the largest inertia: less is rounding
WATER = 1000.0  # kg/m3, of the ball
KINDS = ("free", "pinned", "coupled-pinned")
REMEDY = "or let it carry what has mass off that axis, or hold it (fixed, coupled)"


def objects_have_inertia(model: Model) -> Iterator[Problem]:
    """Rods and bodies that move have mass."""
    for thing, M in _moving(model):
        still = _nothing_in(M[:3, :3]) if thing.kind == "free" else np.zeros((0, 3))
        axes = _axes(M, thing)
        what = ""
        if len(still):
            what = f"move without mass along {_way(still)}"
        elif len(axes) and not _mass(M):
            what = f"turn without inertia about {_way(axes)}"
        if what:
            yield Problem(f"{_can(thing)} {what} of {_own(thing)}", f"give it mass, {REMEDY}", thing.source)


def lendings(model: Model) -> Iterator[Problem]:
    """Say to which rods and bodies inertia is lent."""
    for thing, M in _moving(model):
        axes = _axes(M, thing)
        if len(axes):
            lent = f"it is lent {_ball(_mass(M)):.2g} kg m2 there, those of a ball of water of {_mass(M):.3g} kg"
            message = f"{_can(thing)} turn without inertia about {_way(axes)} of {_own(thing)}: {lent}"
            yield Problem(message, f"give it inertia (I) there, {REMEDY}", thing.source)


def lent_inertia(model: Model, thing: Rod | Body) -> np.ndarray:
    """Return the inertia (3, 3), kg m2, lent to a rod or body that moves, in its own axes; zeros for none."""
    M = _inertia(model, thing)
    axes = _axes(M, thing)
    return _ball(_mass(M)) * axes.T @ axes


def _ball(mass: float) -> float:
    """Return the inertia of a ball of water of a mass: 2/5 m r^2."""
    return float(0.4 * mass * (0.75 * mass / (np.pi * WATER)) ** (2.0 / 3.0))


def _mass(M: np.ndarray) -> float:
    """Return the mean over the directions of the mass that moves, kg."""
    return float(np.trace(M[:3, :3]) / 3.0)


def _axes(M: np.ndarray, thing: Rod | Body) -> np.ndarray:
    """Return orthogonal unit vectors (k, 3), the axes about which a thing turns without inertia."""
    ways = np.arange(0 if thing.kind == "free" else 3, 6)
    if isinstance(thing, Rod):
        ways = ways[ways != 3]  # a rod does not spin about its axis
    motions = np.zeros((6, 6))
    still = _nothing_in(M[np.ix_(ways, ways)])
    motions[: len(still), ways] = still
    _, size, axes = np.linalg.svd(motions[:, 3:])
    return axes[size > 1e-6]


def _nothing_in(M: np.ndarray) -> np.ndarray:
    """Return the directions (k, n) in which a symmetric matrix has nothing."""
    values, vectors = np.linalg.eigh(M)
    return vectors.T[values <= LEAST * max(values[-1], 1e-300)]


def _way(directions: np.ndarray) -> str:
    """Name the main axes of some directions (k, 3)."""
    if len(directions) == 3:
        return "x, y and z"
    return " and ".join(sorted({"xyz"[np.argmax(np.abs(direction))] for direction in directions}))


def _can(thing: Rod | Body) -> str:
    return f"{'body' if isinstance(thing, Body) else 'rod'} {thing.id} is {thing.kind}, and can"


def _own(thing: Rod | Body) -> str:
    return "the body" if isinstance(thing, Body) else "the rod, whose x is along it"


def _moving(model: Model) -> list[tuple[Rod | Body, np.ndarray]]:
    """Return the rods and bodies that forces move, with their inertia (6, 6); none while names or lengths are wrong."""
    every: tuple[Rod | Body, ...] = (*model.rods, *model.bodies)
    things = [thing for thing in every if thing.kind in KINDS and (isinstance(thing, Body) or _has_length(thing))]
    try:
        found = [(thing, _inertia(model, thing)) for thing in things]
    except (StopIteration, KeyError, ZeroDivisionError):
        return []  # which other checks say
    return [(thing, M) for thing, M in found if np.isfinite(M).all()]


def _inertia(model: Model, thing: Rod | Body) -> np.ndarray:
    """Return the inertia (6, 6) of a rod or body and what it carries, in its own axes about its reference point."""
    return _body(model, thing) if isinstance(thing, Body) else _rod(model, thing)


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
