"""From a model to flat arrays: the only bridge."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from moorage.layout import Islands, Lines, State, System, Work, new_state, new_work
from moorage.model import Curve, Model, Motion
from moorage.physics.bending import Bending
from moorage.physics.current import Current
from moorage.physics.morison import Morison
from moorage.physics.motion import Tracks, no_tracks, spline_tracks
from moorage.physics.point import PointLoads
from moorage.physics.seabed import Seabed
from moorage.physics.table import build_tables
from moorage.physics.tension import Tension, damping_from_ratio
from moorage.physics.weight import Weight
from moorage.system.guess import place_guess
from moorage.system.segments import NodeSum, segment_table


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
    coupled: np.ndarray  # (m,) indices of the points that prescribed motion moves


def build(model: Model, motion: Motion | None = None, duration: float | None = None) -> Built:
    """Turn a checked model into arrays, with lines on their first catenary.

    Raises
    ------
    MotionError
        The motion does not fit the model, or is shorter than `duration` (s).
    """
    env = model.environment
    rest = [p.position for p in model.points]
    tracks = _tracks(model, motion, duration, rest)
    segments = segment_table(model)
    count = np.array([line.segments for line in model.lines], dtype=np.int64)
    node_ptr = np.concatenate([[0], np.cumsum(count + 1)]).astype(np.int64)
    to_nodes = NodeSum(node_ptr)
    lines, islands, island_of_line = _topology(model, node_ptr, segments)
    # copied out of the table: a strided array would be another type to the compiler, unless it has one element only
    l, d, m = (np.ascontiguousarray(segments[name]) for name in ("length", "diameter", "mass"))
    displaced = env.water_density * np.pi / 4.0 * d**2 * l
    hydro = np.stack(
        [
            displaced * segments["added_normal"],
            displaced * segments["added_axial"],
            0.5 * env.water_density * d * l * segments["drag_normal"],
            0.5 * env.water_density * np.pi * d * l * segments["drag_axial"],
        ],
        axis=1,
    )
    mass = to_nodes(m * l)
    inner = to_nodes.inner_mean(l)
    system = System(
        lines=lines,
        islands=islands,
        tension=_tension(l, segments),
        bending=Bending(to_nodes.inner_mean(segments["bending_stiffness"]) / np.where(inner > 0.0, inner, 1.0)),
        weight=Weight(-env.gravity * mass, env.gravity * displaced, 0.5 * d),
        morison=Morison(mass, np.stack([to_nodes(h) for h in hydro.T], axis=1), hydro),
        seabed=Seabed(
            to_nodes(env.seabed_stiffness * d * l), to_nodes(env.seabed_damping * d * l), -float(env.water_depth)
        ),
        points=_points(model),
        current=Current(np.array(env.current.z, float), np.array(env.current.velocity, float).reshape(-1, 3)),
        tracks=tracks,
    )
    state = new_state(int(node_ptr[-1]) + len(model.points))
    place_guess(model, system, state, l, segments["weight"])
    arc = np.concatenate([np.concatenate([[0.0], np.cumsum(part)]) for part in np.split(l, np.cumsum(count)[:-1])])
    names = Names(
        np.array([line.id for line in model.lines], dtype=np.int64),
        np.array([p.id for p in model.points], dtype=np.int64),
        node_ptr,
        np.concatenate([[0], np.cumsum(count)]).astype(np.int64),
        l,
        arc,
    )
    coupled = np.array([k for k, p in enumerate(model.points) if p.kind == "coupled"], dtype=np.int64)
    return Built(system, state, new_work(system), names, island_of_line, coupled)


def with_motion(built: Built, tracks: Tracks) -> Built:
    """Return the same system with other prescribed motion."""
    return built._replace(system=built.system._replace(tracks=tracks))


def _tracks(model: Model, motion: Motion | None, duration: float | None, rest) -> Tracks:
    if motion is None:
        return no_tracks(rest)
    index = {p.id: k for k, p in enumerate(model.points)}
    moved = motion.resolve(model, duration)
    return spline_tracks(rest, motion.time, {index[id]: positions for id, positions in moved.items()})


def _topology(model: Model, node_ptr, segments):
    """Group lines that share free points into islands."""
    index = {p.id: k for k, p in enumerate(model.points)}
    free = np.array([p.kind == "free" for p in model.points], dtype=bool)
    ends = np.array([(index[line.end_a.id], index[line.end_b.id]) for line in model.lines], dtype=np.int64)
    n = len(model.lines)
    pairs = [(k, point) for k, both in enumerate(ends) for point in both if free[point]]
    rows, columns = np.array(pairs, dtype=np.int64).reshape(-1, 2).T
    graph = coo_array((np.ones(len(rows)), (rows, n + columns)), shape=(n + len(free), n + len(free)))
    _, label = connected_components(graph, directed=False)
    free_points = np.flatnonzero(free)
    names, island = np.unique(np.concatenate([label[:n], label[n + free_points]]), return_inverse=True)
    island_of_line, island_of_point = island[:n], island[n:]
    order = np.argsort(island_of_line, kind="stable")
    point_order = np.argsort(island_of_point, kind="stable")
    line_ptr = np.searchsorted(island_of_line[order], np.arange(len(names) + 1)).astype(np.int64)
    point_ptr = np.searchsorted(island_of_point[point_order], np.arange(len(names) + 1)).astype(np.int64)
    listed = free_points[point_order]
    unknown = np.full(len(free), -1, dtype=np.int64)
    unknown[listed] = np.arange(len(listed)) - point_ptr[island_of_point[point_order]]
    matrix_ptr = np.concatenate([[0], np.cumsum((3 * np.diff(point_ptr)) ** 2)]).astype(np.int64)
    stiff = np.add.reduceat(segments["bending_stiffness"], node_ptr[:-1] - np.arange(n)) > 0.0
    lines = Lines(node_ptr, ends, unknown[ends], stiff)
    return lines, Islands(line_ptr, order.astype(np.int64), point_ptr, listed, matrix_ptr), island_of_line


def _tension(l, segments) -> Tension:
    curves: list[Curve] = []

    def tables(values, scalars):
        """Table numbers and linear values: a curve's own slope at zero stands for it where one number is wanted."""
        numbers = np.full(len(l), -1, dtype=np.int64)
        for k, value in enumerate(values):
            if isinstance(value, Curve):
                if value not in curves:
                    curves.append(value)
                numbers[k] = curves.index(value)
        return numbers, scalars

    spring_table, stiffness = tables(segments["axial_curve"], segments["axial_stiffness"])
    damper_table, _ = tables(segments["damping_curve"], None)
    ratio = segments["damping_ratio"]
    damping = np.where(
        np.isnan(ratio),
        segments["axial_damping"],
        damping_from_ratio(np.nan_to_num(ratio), l, stiffness, segments["mass"]),
    )
    return Tension(l, stiffness / l, damping / l, np.zeros(len(l)), spring_table, damper_table, build_tables(curves))


def _points(model: Model) -> PointLoads:
    env = model.environment
    mass = np.array([p.mass for p in model.points], dtype=float)
    volume = np.array([p.volume for p in model.points], dtype=float)
    displaced = env.water_density * volume
    return PointLoads(
        mass,
        displaced * np.array([p.added_mass for p in model.points], dtype=float),
        -env.gravity * mass,
        env.gravity * displaced,
        0.5 * env.water_density * np.array([p.drag_area for p in model.points], dtype=float),
        np.maximum((0.75 * volume / np.pi) ** (1.0 / 3.0), 1e-3),
        np.array([p.external_force for p in model.points], dtype=float).reshape(-1, 3),
    )
