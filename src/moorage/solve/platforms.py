"""Stiffness of a mooring to platforms that move at once: turbines, coupled bodies, and the coupled points as one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.layout import copy_of
from moorage.model import Attachment, Model, Turbine
from moorage.model.motion import MOVED, rotation_matrices
from moorage.physics.bending import PINNED
from moorage.solve.record import COLUMNS, FORCE_A, MOMENT_A, sample_system
from moorage.solve.statics import natural_tolerance, solve
from moorage.solve.stiffness import coupled_stiffness, cross_matrix
from moorage.system.build import Built
from moorage.system.holders import holders_of

STEP = 2e-3  # m and rad, of measured stiffness: large enough that the imbalance that statics accept does not matter


class Platform(NamedTuple):
    """Points and rod ends that move as one rigid body."""

    name: str
    moved: np.ndarray  # numbers among points and rod ends
    origin: np.ndarray  # (3,) about which it turns and moments are taken, m


def platforms_of(model: Model) -> tuple[Platform, ...]:
    """Return turbines and coupled bodies, each about its own origin, and the other coupled things about the origin.

    What is on turbines has to be in global coordinates.
    """
    number = holders_of(model, None, None).number
    turbines: dict[int, list[int]] = {turbine.id: [] for turbine in model.turbines}
    on_turbine = {body.id: turbines[body.turbine] for body in model.bodies if body.turbine is not None}
    bodies = {body.id: on_turbine.get(body.id, []) for body in model.bodies if body.kind in MOVED}
    loose: list[int] = []
    things = [(Attachment("point", p.id), p) for p in model.points]
    things += [(Attachment("rod", r.id, end), r) for r in model.rods for end in ("A", "B")]  # type: ignore[arg-type, misc]
    for attachment, thing in things:
        if thing.body in bodies:
            bodies[thing.body].append(number[attachment])
        elif thing.body is None and thing.kind in MOVED:
            (loose if thing.turbine is None else turbines[thing.turbine]).append(number[attachment])
    found = [
        Platform(_name(turbine), np.unique(turbines[turbine.id]), np.array(turbine.position, float))
        for turbine in model.turbines
        if turbines[turbine.id]
    ]
    found += [
        Platform(f"body {body.id}", np.unique(bodies[body.id]), np.array(body.position, float))
        for body in model.bodies
        if bodies.get(body.id) and body.turbine is None
    ]
    if loose:
        found.append(Platform("coupled points", np.unique(loose), np.zeros(3)))
    return tuple(found)


def _name(turbine: Turbine) -> str:
    return f"turbine {turbine.id}" + (f" ({turbine.name})" if turbine.name else "")


def stiffness_of(built: Built, platforms: tuple[Platform, ...]) -> np.ndarray:
    """Return -d(force, moment)/d(translation, rotation) of all platforms, (p, 6, p, 6), N/m, N/rad, N m/rad.

    A row is the load on a platform, a column the motion of one while all others are held.
    """
    if not platforms:
        return np.zeros((0, 6, 0, 6))
    every = np.concatenate([p.moved for p in platforms])
    clamped = built.system.bending.rule[np.isin(built.system.lines.end_point, every)] != PINNED
    if clamped.any() or len(built.system.riders.row):
        return measured(built, platforms)
    return condensed(built, platforms, every)


def condensed(built: Built, platforms: tuple[Platform, ...], every: np.ndarray) -> np.ndarray:
    """Return the stiffness by elimination, exact; for platforms with pinned lines only."""
    K = coupled_stiffness(built, every)
    nodes = int(built.system.lines.node_ptr[-1])
    T, turning = np.zeros((len(every), 3, len(platforms), 6)), np.zeros((len(platforms), 6, len(platforms), 6))
    forces, row = holder_forces(built), 0
    for p, platform in enumerate(platforms):
        for holder in platform.moved:
            arm = built.state.position[nodes + holder] - platform.origin
            T[row, :, p, :3], T[row, :, p, 3:] = np.eye(3), -cross_matrix(arm)
            # the moment r x f changes by (theta x r) x f = [f][r] theta when the arm turns
            turning[p, 3:, p, 3:] -= cross_matrix(forces[holder]) @ cross_matrix(arm)
            row += 1
    flat = T.reshape(3 * len(every), -1)
    total = flat.T @ K.reshape(3 * len(every), -1) @ flat
    return total.reshape(turning.shape) + turning


def measured(built: Built, platforms: tuple[Platform, ...]) -> np.ndarray:
    """Return the same by central differences of equilibria, with clamps that turn, or free objects."""
    tolerance = 0.1 * natural_tolerance(built)
    tracks, begin = built.system.tracks, copy_of(built.state)
    rest, coefficients = tracks.rest.copy(), tracks.coefficients.copy()
    K = np.zeros((len(platforms), 6, len(platforms), 6))
    for p, platform in enumerate(platforms):
        for k in range(6):
            loads = []
            for sign in (1.0, -1.0):
                _put(built.state, begin)
                move = np.zeros(6)
                move[k] = sign * STEP
                move_platform(built, platform, move, rest)
                solve(built, tolerance)
                loads.append(platform_loads(built, platforms, p, move[:3]))
            K[:, :, p, k] = (loads[1] - loads[0]) / (2.0 * STEP)
            tracks.rest[...], tracks.coefficients[...] = rest, coefficients
    _put(built.state, begin)
    return K


def move_platform(built: Built, platform: Platform, move: np.ndarray, rest: np.ndarray) -> None:
    """Shift and turn the holders of a platform, and the clamps on them, by a small motion from where they rest."""
    system = built.system
    turn = rotation_matrices(move[None, 3:])[0]
    turned = system.bending.direction[np.isin(system.lines.end_point, platform.moved)]
    turned = np.unique(turned[turned >= 0])
    arms = rest[platform.moved] - platform.origin
    system.tracks.rest[platform.moved] = arms @ turn.T + platform.origin + move[:3]
    system.tracks.rest[turned] = rest[turned] @ turn.T
    for k in (*platform.moved, *turned):
        if system.tracks.track[k] >= 0:  # statics look at time 0: the first coefficient's constant
            system.tracks.coefficients[system.tracks.track[k], 0, :, 3] = system.tracks.rest[k]


def platform_loads(built: Built, platforms: tuple[Platform, ...], moving: int, shift: np.ndarray) -> np.ndarray:
    """Return forces and moments of the lines on all platforms, (p, 6), of which one has been shifted, m."""
    sample, nodes = sampled(built), int(built.system.lines.node_ptr[-1])
    loads = np.zeros((len(platforms), 6))
    for line, ends in enumerate(built.system.lines.end_point[: len(sample)]):
        for end, holder in enumerate(ends):
            for p, platform in enumerate(platforms):
                if holder in platform.moved:
                    force = sample[line, FORCE_A + 3 * end : FORCE_A + 3 * end + 3]
                    origin = platform.origin + (shift if p == moving else 0.0)
                    row = nodes + holder if holder in built.system.islands.points else None
                    place = built.state.position[row] if row is not None else built.system.tracks.rest[holder]
                    moment = sample[line, MOMENT_A + 3 * end : MOMENT_A + 3 * end + 3]
                    loads[p] += [*force, *(np.cross(place - origin, force) + moment)]
    return loads


def holder_forces(built: Built) -> np.ndarray:
    """Return the forces of the lines on points and rod ends at rest, (n, 3), N."""
    sample, out = sampled(built), np.zeros((len(built.system.points.mass), 3))
    ends = built.system.lines.end_point[: len(sample)]
    for end in range(2):
        np.add.at(out, ends[:, end], sample[:, FORCE_A + 3 * end : FORCE_A + 3 * end + 3])
    return out


def sampled(built: Built) -> np.ndarray:
    """Return the columns of the records of all lines at rest."""
    sample = np.zeros((len(built.system.lines.bends), COLUMNS))
    sample_system(built.system, built.state, 0.0, sample)
    return sample[: len(built.names.lines)]


def _put(target, source) -> None:
    for a, b in zip(target, source, strict=True):
        a[...] = b
