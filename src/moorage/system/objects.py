"""Rods and bodies that forces move: what they are, where they start, and what they weigh.

A rod's first axis points from its end A to end B, its reference point is end A; a body has the axes of the file. A
joint that cables turn (see `system.joints`) is a rod without nodes.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.model import Body, Environment, Model, Rod
from moorage.model.cables import clamped_ends, turns
from moorage.model.inertia import lent_inertia
from moorage.model.motion import rotation_matrices
from moorage.physics import rigid

MOVING = ("free", "pinned", "coupled-pinned")


class Objects(NamedTuple):
    """Objects of a model: rods, then bodies, so that a rod pinned to a body comes before it."""

    names: list[tuple[str, int]]  # "rod" or "body", id
    things: list[Rod | Body]
    number: dict[tuple[str, int | None], int]
    position: np.ndarray  # (objects, 3) of the reference points at the start, m
    rotation: np.ndarray  # (objects, 3, 3) from their axes to global ones


def moves(thing: Rod | Body) -> bool:
    """Return whether forces move a rod with a length, or a body."""
    if isinstance(thing, Body):
        return thing.kind in MOVING
    return bool(thing.segments) and thing.kind in MOVING and not (thing.kind == "free" and thing.body is not None)


def objects_of(model: Model) -> Objects:
    """List the objects of a model."""
    every: tuple[Rod | Body, ...] = (*model.rods, *model.bodies)
    things = [thing for thing in every if moves(thing) or (isinstance(thing, Rod) and turns(model, thing))]
    names = [("rod" if isinstance(thing, Rod) else "body", thing.id) for thing in things]
    frames = [_frame(model, thing) for thing in things]
    return Objects(
        names,
        things,
        {name: k for k, name in enumerate(names)},
        np.array([x for x, _ in frames], dtype=float).reshape(-1, 3),
        np.array([R for _, R in frames], dtype=float).reshape(-1, 3, 3),
    )


def _frame(model: Model, thing: Rod | Body) -> tuple[np.ndarray, np.ndarray]:
    """Return where an object starts and how it is turned."""
    if isinstance(thing, Body):
        return np.array(thing.position), rotation_matrices(np.array([thing.rotation]))[0]
    place, axis = np.array(thing.end_a), np.array(thing.direction)
    if thing.body is not None:
        body = next(body for body in model.bodies if body.id == thing.body)
        turn = rotation_matrices(np.array([body.rotation]))[0]
        place, axis = np.array(body.position) + turn @ place, turn @ axis
    return place, frame_along(axis)


def frame_along(axis: np.ndarray) -> np.ndarray:
    """Return a rotation (3, 3) whose first column is a unit vector.

    MoorDyn's axes of a rod, the vertical turned to it by roll and pitch, with the last one put first.
    """
    return rotation_matrices(angles_of(axis)[None])[0][:, [2, 0, 1]]


def angles_of(axis: np.ndarray) -> np.ndarray:
    """Return roll and pitch (and no yaw), rad, that turn the vertical into a unit vector; zeros for none."""
    if not axis.any():
        return np.zeros(3)
    pitch = np.arcsin(np.clip(axis[0], -1.0, 1.0))
    return np.array([np.arctan2(-axis[1], axis[2]), pitch, 0.0])


def rigid_rods(model: Model) -> list[Rod]:
    """Return the rods that have nodes, in the order of the file."""
    return [rod for rod in model.rods if rod.segments]


def rod_length(rod: Rod) -> float:
    """Return the length of a rod, m."""
    return float(np.linalg.norm(np.subtract(rod.end_b, rod.end_a)))


def beyond_nodes(model: Model, rod: Rod, axis: np.ndarray) -> np.ndarray:
    """Return what a rod's inertia has more than that of its lumped nodes, (3, 3), kg m2, with its axis (3,) given.

    Across the axis m L^2 / 12 + m d^2 / 16 less m L^2 (1 / 12 + 1 / (6 N^2)), about the axis m d^2 / 8.
    """
    kind = next(t for t in model.rod_types if t.name.lower() == rod.rod_type.lower())
    L, d = rod_length(rod), kind.diameter
    mass = kind.mass_per_length * L
    along = np.outer(axis, axis)
    across = mass * (d**2 / 16.0 - L**2 / (6.0 * rod.segments**2))
    return across * (np.eye(3) - along) + mass * d**2 / 8.0 * along


def joint_inertia(model: Model, rod: Rod) -> tuple[float, float]:
    """Return the inertia of a joint across its direction, kg m2, and the length that makes a distance of an angle, m.

    A joint has no mass. What turns with it are the halves of the segments that it clamps, whose mass is lumped in their
    end nodes: m (l / 2)^3 / 3 each, with the water that they take along. So a joint is as quick as the shortest waves
    in its cables, and the inertia vanishes with the segments.
    """
    inertia, lengths = 0.0, []
    for line, end in clamped_ends(model, rod.id):
        section = line.sections[0 if end == "A" else -1]
        kind, length = model.line_type(section.line_type), section.segment_lengths[0 if end == "A" else -1]
        water = model.environment.water_density * np.pi / 4.0 * kind.diameter**2 * kind.transverse_added_mass
        inertia += (kind.mass_per_length + water) * length**3 / 24.0
        lengths.append(length)
    return inertia, float(min(lengths))


def build_rigid(model: Model, things: list[Rod | Body], reach: np.ndarray) -> rigid.RigidLoads:
    """Return the loads of rods and bodies by themselves; reach: the longest arms (m) on them, which give their size."""
    env, n = model.environment, len(things)
    p = np.zeros((n, rigid.COLUMNS))
    p[:, rigid.RADIUS] = 1e-3
    for o, thing in enumerate(things):
        if isinstance(thing, Rod) and not thing.segments:
            p[o, rigid.SLENDER], turn, p[o, rigid.SIZE] = 1.0, *joint_inertia(model, thing)
            p[o, rigid.INERTIA : rigid.INERTIA + 9] = np.diag([0.0, turn, turn]).ravel()
            continue
        inertia = lent_inertia(model, thing)
        if isinstance(thing, Rod):
            p[o, rigid.SLENDER] = 1.0
            inertia += beyond_nodes(model, thing, np.array([1.0, 0.0, 0.0]))
        else:
            fill_body(p[o], thing, env, model.flavour)
            inertia += np.diag(thing.inertia) + env.water_density * thing.volume * np.diag(thing.added_mass[3:])
            for rod in model.rods:
                if rod.body == thing.id and rod.segments and rod.kind != "pinned":
                    inertia += beyond_nodes(model, rod, np.array(rod.direction))
        p[o, rigid.INERTIA : rigid.INERTIA + 9] = inertia.ravel()
        turns = max(np.trace(inertia), 0.0)  # of a rod's nodes there is more beside
        gyration = np.sqrt(turns / (2.0 * thing.mass)) if isinstance(thing, Body) and thing.mass else 0.0
        p[o, rigid.SIZE] = max(reach[o], gyration, 1e-2)
        for load in model.external_loads:
            if load.target == ("rod" if isinstance(thing, Rod) else "body") and load.target_id == thing.id:
                slender = isinstance(thing, Rod)
                # only damping of a rod is in its own axes: they begin with that along it, the last one in the file
                order = [2, 0, 1] if slender and load.local else [0, 1, 2]
                force = rigid.OWN_FORCE if load.local and not slender else rigid.FORCE
                linear = rigid.OWN_LINEAR if load.local else rigid.LINEAR
                quadratic = rigid.OWN_QUADRATIC if load.local else rigid.QUADRATIC
                p[o, force : force + 3] += load.force
                p[o, linear : linear + 3] += three(load.linear_damping)[order]
                p[o, quadratic : quadratic + 3] += three(load.quadratic_damping)[order]
    return rigid.RigidLoads(p)


def three(values) -> np.ndarray:
    """Spread one or two (transverse, axial) values over three axes."""
    values = np.atleast_1d(np.array(values, dtype=float))
    return np.array([values[0], values[0], values[1]]) if len(values) == 2 else (np.tile(values, 3))[:3]


def fill_body(p: np.ndarray, body: Body, env: Environment, flavour: str) -> None:
    """Set the loads of a body in its row of the table."""
    rho, g = env.water_density, env.gravity
    p[rigid.MASS], p[rigid.WEIGHT] = body.mass, -g * body.mass
    p[rigid.CENTRE : rigid.CENTRE + 3] = body.centre_of_gravity
    # MoorDyn lets buoyancy act at the centre of gravity
    p[rigid.BUOYANT : rigid.BUOYANT + 3] = body.centre_of_gravity if flavour.startswith("MoorDyn") else 0.0
    p[rigid.DISPLACED], p[rigid.BUOYANCY] = rho * body.volume, rho * g * body.volume
    p[rigid.RADIUS] = max((0.75 * body.volume / np.pi) ** (1.0 / 3.0), 1e-3)
    p[rigid.ADDED : rigid.ADDED + 3] = rho * body.volume * np.array(body.added_mass[:3])
    p[rigid.DRAG : rigid.DRAG + 6] = 0.5 * rho * np.array(body.drag_area)


def waterplanes(model: Model) -> np.ndarray:
    """Return rho g pi d^4 / 64 of every line (0) and rod, N m."""
    env, diameter = model.environment, {t.name.lower(): t.diameter for t in model.rod_types}
    rods = [np.pi / 64.0 * diameter[rod.rod_type.lower()] ** 4 for rod in rigid_rods(model)]
    return env.water_density * env.gravity * np.array([0.0] * len(model.lines) + rods)
