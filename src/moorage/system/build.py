"""From a model to flat arrays: the only bridge."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.layout import State, System, Work, new_state, new_work
from moorage.model import Current as SteadyCurrent
from moorage.model import Curve, Model, Motion
from moorage.physics.current import Current
from moorage.physics.morison import Morison
from moorage.physics.motion import Tracks, no_tracks, spline_tracks
from moorage.physics.point import PointLoads
from moorage.physics.table import build_tables
from moorage.physics.tension import Tension, damping_from_ratio
from moorage.physics.weight import Weight
from moorage.system.bed import build_contact, build_friction
from moorage.system.bends import build_bending
from moorage.system.guess import hang_chains, place_guess
from moorage.system.holders import Holders, holders_of, release, timed_failures
from moorage.system.sea import build_sea
from moorage.system.segments import NodeSum, segment_table
from moorage.system.topology import islands_of


class Names(NamedTuple):
    """What the rows of the arrays are called; everything in the order of the file."""

    lines: np.ndarray  # (lines,) ids
    points: np.ndarray  # (points,) ids
    node_ptr: np.ndarray  # (lines + 1,) nodes of each line; the first is at end A
    segment_ptr: np.ndarray  # (lines + 1,)
    segment_length: np.ndarray  # (segments,) unstretched, m
    arc_length: np.ndarray  # (nodes,) unstretched, from end A, m


class Built(NamedTuple):
    """A system ready to be solved, with its state, scratch space and names."""

    system: System
    state: State
    work: Work
    names: Names
    island_of_line: np.ndarray  # (lines,)
    hung: np.ndarray  # (rows, 3) where statics start: as the state does, but chains of joined lines hang as one, m
    coupled: np.ndarray  # (m,) rows of points and rod ends, counted from the first point, that a motion moves


def build(
    model: Model,
    motion: Motion | None = None,
    duration: float | None = None,
    released: frozenset[int] = frozenset(),
) -> Built:
    """Turn a checked model into arrays, with lines on their first catenary.

    `released` holds the timed failures that have come (places in `timed_failures`).

    Raises
    ------
    MotionError
        The motion does not fit the model, or is shorter than `duration` (s).
    """
    env = model.environment
    model = release(model, released)
    holders = holders_of(model, motion, duration, released)
    segments = segment_table(model)
    count = np.array([line.segments for line in model.lines], dtype=np.int64)
    node_ptr = np.concatenate([[0], np.cumsum(count + 1)]).astype(np.int64)
    to_nodes = NodeSum(node_ptr)
    ends = [(holders.number[line.end_a], holders.number[line.end_b]) for line in model.lines]
    bending, joints, clamps = build_bending(model, holders, segments, node_ptr, len(holders.rest))
    bends = np.add.reduceat(segments["bending_stiffness"], node_ptr[:-1] - np.arange(len(count))) > 0.0
    lines, islands, joints, island_of_line = islands_of(
        node_ptr, np.array(ends, dtype=np.int64).reshape(-1, 2), holders.free, bends, joints
    )
    # copied out of the table: a strided array would be another type to the compiler, unless it has one element only
    l, d, m = (np.ascontiguousarray(segments[name]) for name in ("length", "diameter", "mass"))
    displaced = env.water_density * segments["area"] * l
    hydro = np.stack(
        [
            displaced * segments["added_normal"],
            displaced * segments["added_axial"],
            0.5 * env.water_density * segments["width"] * l * segments["drag_normal"],
            0.5 * env.water_density * np.pi * segments["girth"] * l * segments["drag_axial"],
            displaced,
        ],
        axis=1,
    )
    mass = to_nodes(m * l)
    system = System(
        lines=lines,
        islands=islands,
        joints=joints,
        tension=_tension(l, segments),
        bending=bending,
        weight=Weight(-env.gravity * mass, env.gravity * displaced, 0.5 * d),
        morison=Morison(mass, np.stack([to_nodes(h) for h in hydro.T], axis=1), hydro),
        contact=build_contact(env, to_nodes(d * l), to_nodes(l)),
        friction=build_friction(model, to_nodes(d * l)),
        points=_points(model, len(holders.rest)),
        current=_current(env.current),
        sea=build_sea(env.waves),
        tracks=_tracks(motion, holders, clamps),
    )
    state = new_state(int(node_ptr[-1]) + len(holders.rest))
    weight = env.gravity * (m - env.water_density * segments["area"])
    place_guess(model, system, state, l, weight)
    arc = np.concatenate([np.concatenate([[0.0], np.cumsum(part)]) for part in np.split(l, np.cumsum(count)[:-1])])
    names = Names(
        np.array([line.id for line in model.lines], dtype=np.int64),
        np.array([p.id for p in model.points], dtype=np.int64),
        node_ptr,
        np.concatenate([[0], np.cumsum(count)]).astype(np.int64),
        l,
        arc,
    )
    return Built(
        system,
        state,
        new_work(system),
        names,
        island_of_line,
        hang_chains(model, system, state, l, weight),
        np.flatnonzero(holders.coupled),
    )


def build_failures(model: Model, motion: Motion | None = None, duration: float | None = None):
    """Return (time, Built) for each timed failure of a model: the system from then on."""
    times = [failure.time for failure in timed_failures(model)]
    return [
        (time, build(model, motion, duration, frozenset(range(k + 1))))
        for k, time in enumerate(times)
        if duration is None or time < duration
    ]


def with_motion(built: Built, tracks: Tracks) -> Built:
    """Return the same system with other prescribed motion."""
    return built._replace(system=built.system._replace(tracks=tracks))


def _tracks(motion: Motion | None, holders: Holders, clamps: list[np.ndarray]) -> Tracks:
    """Tracks of the holders, then of the directions of the clamps."""
    rest = np.concatenate([holders.rest, np.array([c if c.ndim == 1 else c[0] for c in clamps]).reshape(-1, 3)])
    if motion is None:
        return no_tracks(rest)
    turning = {len(holders.rest) + k: c for k, c in enumerate(clamps) if c.ndim == 2}
    return spline_tracks(rest, motion.time, holders.moved | turning)


def _current(current: SteadyCurrent) -> Current:
    velocity = np.array(current.velocity, float).reshape(-1, 3)
    return Current(np.array(current.z, float), velocity, bool(velocity.any()))


def _tension(l, segments) -> Tension:
    curves: list[Curve] = []

    def table_of(value) -> int:
        if not isinstance(value, Curve):
            return -1
        if value not in curves:
            curves.append(value)
        return curves.index(value)

    springs, dampers = ([table_of(value) for value in segments[name]] for name in ("axial_curve", "damping_curve"))
    stiffness, ratio = segments["axial_stiffness"], segments["damping_ratio"]
    damping = np.where(
        np.isnan(ratio),
        segments["axial_damping"],
        damping_from_ratio(np.nan_to_num(ratio), l, stiffness, segments["mass"]),
    )
    return Tension(
        l,
        stiffness / l,
        damping / l,
        np.where(segments["pushes"] > 0.0, -1e300, 0.0),
        np.array(springs, dtype=np.int64),
        np.array(dampers, dtype=np.int64),
        build_tables(curves),
    )


def _points(model: Model, count: int) -> PointLoads:
    """Loads of the points by themselves; the holders after them, ends of rods, have none."""
    env = model.environment

    def column(values):
        out = np.zeros(count)
        out[: len(model.points)] = values
        return out

    mass = column([p.mass for p in model.points])
    volume = column([p.volume for p in model.points])
    force = np.zeros((count, 3))
    force[: len(model.points)] = np.array([p.external_force for p in model.points], dtype=float).reshape(-1, 3)
    return PointLoads(
        mass,
        env.water_density * volume * column([p.added_mass for p in model.points]),
        -env.gravity * mass,
        env.water_density * volume,
        env.gravity * env.water_density * volume,
        0.5 * env.water_density * column([p.drag_area for p in model.points]),
        np.maximum((0.75 * volume / np.pi) ** (1.0 / 3.0), 1e-3),
        force,
    )
