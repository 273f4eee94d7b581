"""From a model to flat arrays: the only bridge."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from moorage.layout import (
    CARRIER,
    FLEXIBLE,
    HELD,
    PIN,
    ROW,
    SPAN,
    TOWARD,
    WATERPLANE,
    Breaks,
    Riders,
    State,
    System,
    Work,
    new_state,
    new_work,
    rows_of,
)
from moorage.model import Attachment, Curve, Model, Motion
from moorage.model.payout import paid_out
from moorage.physics.morison import Morison
from moorage.physics.motion import Tracks, no_tracks, spline_tracks, with_cubics
from moorage.physics.rigid import RigidLoads
from moorage.physics.table import build_tables
from moorage.physics.tension import Tension, damping_from_ratio
from moorage.physics.weight import Weight
from moorage.system.bed import build_contact, build_friction
from moorage.system.bends import build_bending
from moorage.system.guess import hang_chains, place_guess
from moorage.system.holders import Holders, holders_of, release
from moorage.system.joints import turn_joints
from moorage.system.objects import Objects, build_rigid, rigid_rods, waterplanes
from moorage.system.points import build_points
from moorage.system.sea import build_current, build_sea
from moorage.system.segments import NodeSum, segment_table
from moorage.system.topology import islands_of
from moorage.system.winches import Reeled, Winch, as_cut, at_start, build_winches, longest_cut, no_winches, winches_of


class Names(NamedTuple):
    """What the rows of the arrays are called; everything in the order of the file.

    Nodes and segments are those of lines; those of rods stand behind them in the system.
    """

    lines: np.ndarray  # (lines,) ids
    points: np.ndarray  # (points,) ids
    node_ptr: np.ndarray  # (lines + 1,) nodes of each line; the first is at end A
    segment_ptr: np.ndarray  # (lines + 1,)
    segment_length: np.ndarray  # (segments,) unstretched, m
    arc_length: np.ndarray  # (nodes,) unstretched, from end A, m
    rods: list[int]  # ids of the rods that have nodes
    objects: list[tuple[str, int]]  # "rod" or "body", id


class Rods(NamedTuple):
    """Where the rods of a model are in the arrays, in the order of the file."""

    ends: np.ndarray  # (rods, 2) holders of end A and end B
    line: np.ndarray  # (rods,) the rigid line with its nodes, -1 for rods of no length


class Bodies(NamedTuple):
    """Where the bodies of a model are in the arrays, in the order of the file."""

    object: np.ndarray  # (bodies,) number among the objects, -1: held
    place: np.ndarray  # (bodies,) of held ones, the holder at the reference point
    axes: np.ndarray  # (bodies,) and the first of two tracks, of its first and second axis
    holders: tuple[np.ndarray, ...]  # of each, the points and ends of rods that it carries
    rods: tuple[np.ndarray, ...]  # and the places of the rods fixed to it, and of those pinned to it
    pinned: tuple[np.ndarray, ...]


class Releases(NamedTuple):
    """What happens in a run: lines that come off where they are tied, segments that winches make and remove."""

    times: dict[int, float]  # failure: the time (s) at which it comes, of those that do
    ends: dict[int, set[tuple[int, int]]]  # failure: line ends (line; 0: A, 1: B) that come off
    rebuild: Callable[[tuple[int, ...], Reeled | None], Built]  # the system with failures behind it, and lines as cut
    most: Reeled | None = None  # how lines are cut in results, which have rows of one number


class Built(NamedTuple):
    """A system ready to be solved, with its state, scratch space and names."""

    system: System
    state: State
    work: Work
    names: Names
    island_of_line: np.ndarray  # (lines,)
    hung: np.ndarray  # (rows, 3) where statics start: as the state does, but chains of joined lines hang as one, m
    coupled: np.ndarray  # (m,) rows of points and rod ends, counted from the first point, that a motion moves
    rods: Rods
    bodies: Bodies
    body_loads: RigidLoads  # of all bodies by themselves
    rod_loads: RigidLoads  # of all rods that have nodes, beside those of their nodes
    winches: tuple[Winch, ...]
    reeled: Reeled | None  # how their lines are cut; None without any
    paid: np.ndarray  # (controls,) rows of the tracks that hold what winches have paid out


def build(
    model: Model,
    motion: Motion | None = None,
    duration: float | None = None,
    released: tuple[int, ...] = (),
    reeled: Reeled | None = None,
) -> Built:
    """Turn a checked model into arrays, with lines on their first catenary.

    `released` holds the failures that have come (places in `model.failures`, in the order in which they came), `reeled`
    how the lines on winches are cut; by default as at time 0.

    Raises
    ------
    MotionError
        The motion does not fit the model, or is shorter than `duration` (s).
    """
    env = model.environment
    winches, paid = winches_of(model), [paid_out(control) for control in model.controls]
    if winches:
        reeled = at_start(winches, paid) if reeled is None else reeled
        model = as_cut(model, winches, reeled)
    holders = holders_of(model, motion, duration, released)
    rigid = build_rigid(model, holders.objects.things, _reach(holders))  # joints keep the inertia of what comes off
    model = release(model, released)
    segments = segment_table(model)
    rods = rigid_rods(model)
    count = np.array([x.segments for x in model.lines] + [rod.segments for rod in rods], dtype=np.int64)
    node_ptr = np.concatenate([[0], np.cumsum(count + 1)]).astype(np.int64)
    to_nodes = NodeSum(node_ptr)
    ends = [(holders.number[line.end_a], holders.number[line.end_b]) for line in model.lines]
    ends += [tuple(holders.number[Attachment("rod", rod.id, end)] for end in ("A", "B")) for rod in rods]  # type: ignore[misc]
    bending, joints, clamps, of_clamp, toward = build_bending(model, holders, segments, node_ptr, len(holders.rest))
    bodies, axes = _bodies(model, holders, len(holders.rest) + len(clamps))
    riders = _riders(model, holders, node_ptr, of_clamp, toward)
    stiffness = np.concatenate([[0.0], np.cumsum(segments["bending_stiffness"])])
    segment_ptr = node_ptr - np.arange(len(node_ptr))
    bends = stiffness[segment_ptr[1:]] > stiffness[segment_ptr[:-1]]
    lines, islands, joints, island_of_line = islands_of(
        node_ptr, np.array(ends, dtype=np.int64).reshape(-1, 2), holders.free, bends, joints, riders
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
    wet_nodes = np.stack([to_nodes(h) for h in hydro.T], axis=1)
    _add_ends(model, wet_nodes, node_ptr)
    mass = to_nodes(m * l)
    system = System(
        lines=lines,
        islands=islands,
        joints=joints,
        riders=riders,
        breaks=_breaks(model, released),
        winches=no_winches(),
        tension=_tension(l, segments),
        bending=bending,
        weight=Weight(-env.gravity * mass, env.gravity * displaced, 0.5 * d),
        morison=Morison(mass, wet_nodes, hydro),
        contact=build_contact(env, to_nodes(d * l), to_nodes(l)),
        friction=build_friction(model, to_nodes(d * l), mass),
        points=build_points(model, holders),
        rigid=rigid,
        current=build_current(env.current),
        sea=build_sea(env.waves),
        tracks=with_cubics(_tracks(motion, holders, clamps + axes), [p.knots for p in paid], [p.pieces for p in paid]),
    )
    first_track = len(system.tracks.rest) - len(paid)
    if winches and reeled is not None:
        ratio = ~np.isnan(segments["damping_ratio"])
        system = system._replace(winches=build_winches(system, winches, reeled, first_track, island_of_line, ratio))
    state = new_state(rows_of(system), len(riders.objects), len(system.lines.bends))
    place_objects(holders.objects, riders, state)
    weight = env.gravity * (m - env.water_density * segments["area"])
    place_guess(model, system, state, l, weight)
    turn_joints(system, state)
    arcs = [np.concatenate([[0.0], np.cumsum(part)]) for part in np.split(l, np.cumsum(count)[:-1])] if len(l) else []
    arc = np.concatenate([*arcs, np.zeros(0)])
    n = len(model.lines)
    names = Names(
        np.array([line.id for line in model.lines], dtype=np.int64),
        np.array([p.id for p in model.points], dtype=np.int64),
        node_ptr[: n + 1],
        segment_ptr[: n + 1],
        l[: segment_ptr[n]].copy(),  # those of the system change at winches
        arc[: node_ptr[n]],
        [rod.id for rod in rods],
        holders.objects.names,
    )
    return Built(
        system,
        state,
        new_work(system),
        names,
        island_of_line,
        hang_chains(model, system, state, l, weight),
        np.flatnonzero(holders.coupled),
        _rods(model, holders),
        bodies,
        build_rigid(model, list(model.bodies), np.ones(len(model.bodies))),
        build_rigid(model, list(rods), np.ones(len(rods))),
        winches,
        reeled,
        first_track + np.arange(len(paid)),
    )


def _rods(model: Model, holders: Holders) -> Rods:
    ends = [[holders.number[Attachment("rod", rod.id, end)] for end in ("A", "B")] for rod in model.rods]  # type: ignore[arg-type]
    nodes = np.array([bool(rod.segments) for rod in model.rods], dtype=bool)
    line = np.where(nodes, len(model.lines) + np.cumsum(nodes) - 1, -1)
    return Rods(np.array(ends, dtype=np.int64).reshape(-1, 2), line.astype(np.int64))


def _bodies(model: Model, holders: Holders, first: int) -> tuple[Bodies, list[np.ndarray]]:
    """Return where the bodies are, and the tracks of the axes of those that are held, which begin at `first`."""
    axes: list[np.ndarray] = []
    rows = []
    for body in model.bodies:
        rows.append(
            (holders.objects.number.get(("body", body.id), -1), holders.place.get(body.id, -1), first + len(axes))
        )
        if body.id in holders.axes:
            axes += [holders.axes[body.id][..., 0], holders.axes[body.id][..., 1]]
    at = holders.number
    ends = [[at[Attachment("rod", r.id, "A")], at[Attachment("rod", r.id, "B")]] for r in model.rods]  # type: ignore[arg-type]
    held = [[p for p in model.points if p.body == body.id] for body in model.bodies]
    rods = [[k for k, r in enumerate(model.rods) if r.body == body.id and r.kind != "pinned"] for body in model.bodies]
    carried = tuple(
        np.unique([at[Attachment("point", p.id)] for p in points] + [h for k in own for h in ends[k]]).astype(np.int64)
        for points, own in zip(held, rods, strict=True)
    )
    with_nodes = tuple(np.array([k for k in own if model.rods[k].segments], dtype=np.int64) for own in rods)
    pinned = tuple(
        np.array([k for k, r in enumerate(model.rods) if r.body == body.id and r.kind == "pinned"], dtype=np.int64)
        for body in model.bodies
    )
    objects, places, tracks = np.array(rows, dtype=np.int64).reshape(-1, 3).T
    return Bodies(objects, places, tracks, carried, with_nodes, pinned), axes


def _reach(holders: Holders) -> np.ndarray:
    """Return the longest arm on each object, m."""
    reach = np.zeros(len(holders.objects.names))
    rides = holders.of_point >= 0
    np.maximum.at(reach, holders.of_point[rides], np.linalg.norm(holders.arm[rides], axis=1))
    return reach


def _riders(model: Model, holders: Holders, node_ptr, of_clamp, toward) -> Riders:
    """Return what rides on the objects; the unknowns are numbered later."""
    objects, lines, rods = holders.objects, len(model.lines), rigid_rods(model)
    n = len(objects.names)
    first = int(node_ptr[-1]) + len(holders.rest)
    links = np.column_stack([np.full(lines + len(rods), FLEXIBLE), of_clamp]).astype(np.int64)
    places = np.zeros((lines + len(rods), 5, 3))
    places[:, TOWARD : TOWARD + 2], places[:, WATERPLANE, 0] = toward, waterplanes(model)
    for k, rod in enumerate(rods):
        ends = [holders.number[Attachment("rod", rod.id, end)] for end in ("A", "B")]  # type: ignore[arg-type]
        on = holders.of_point[ends[0]]
        links[lines + k, CARRIER] = HELD if on < 0 else on
        places[lines + k, SPAN : SPAN + 2] = holders.arm[ends]
    own = np.full((n, 4), -1, dtype=np.int64)
    own[:, ROW], own[:, PIN] = first + 2 * np.arange(n), holders.pin
    return Riders(own, holders.of_point, holders.arm, links, places)


def _add_ends(model: Model, nodes, node_ptr) -> None:
    """Add the water at the ends of rods to their end nodes (nodes, 5): a half sphere's added mass, drag on the face."""
    rho, types = model.environment.water_density, {t.name.lower(): t for t in model.rod_types}
    for k, rod in enumerate(rigid_rods(model)):
        kind, line = types[rod.rod_type.lower()], len(model.lines) + k
        for i in (node_ptr[line], node_ptr[line + 1] - 1):
            nodes[i, 1] += rho * kind.end_added_mass * np.pi * kind.diameter**3 / 12.0
            nodes[i, 3] += 0.5 * rho * kind.end_drag * np.pi * kind.diameter**2 / 4.0


def place_objects(objects: Objects, riders: Riders, state: State) -> None:
    """Put the objects where they start."""
    state.position[riders.row] = objects.position
    state.frames[...] = objects.rotation.reshape(-1, 9)


def releases_of(model: Model, motion: Motion | None = None, duration: float | None = None) -> Releases:
    """Return what comes off in a run, and when, and what winches do."""
    times = {k: failure.time for k, failure in enumerate(model.failures) if failure.time > 0.0}
    ends = {
        k: {
            (i, end)
            for i, line in enumerate(model.lines)
            for end, tie in enumerate((line.end_a, line.end_b))
            if line.id in failure.lines and tie == failure.attachment
        }
        for k, failure in enumerate(model.failures)
    }
    winches, paid = winches_of(model), [paid_out(control) for control in model.controls]
    most = longest_cut(winches, paid, duration or 0.0) if winches else None
    return Releases(times, ends, lambda released, reeled: build(model, motion, duration, released, reeled), most)


def _breaks(model: Model, released: tuple[int, ...]) -> Breaks:
    """Return the line ends that come off at a force."""
    rows = []
    for k, failure in enumerate(model.failures):
        if failure.tension > 0.0 and k not in released:
            for j, line in enumerate(model.lines):
                if line.id in failure.lines:
                    held = [end for end, at in enumerate((line.end_a, line.end_b)) if at == failure.attachment]
                    rows += [(j, end, failure.tension, k) for end in held]
    columns = np.array(rows, dtype=float).reshape(-1, 4).T
    return Breaks(np.ascontiguousarray(columns[[0, 1, 3]].T.astype(np.int64)), columns[2].copy())


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
        np.zeros(len(l)),
        np.array(springs, dtype=np.int64),
        np.array(dampers, dtype=np.int64),
        build_tables(curves),
    )
