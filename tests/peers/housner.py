"""The cases of Housner et al. 2022 as MoorDyn-F and MoorDyn-C ran them: read them, run them, or follow them."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np
from beside import read, rms

from moorage.io import read_motion
from moorage.model import Model, Motion
from moorage.solve.march import Block, March, Settings
from moorage.solve.statics import rest, solve
from moorage.system.build import Built, build

FIRST = 1.0  # s, of the shapes that they recorded
ENDS = {"LINE2TENB": (2, 1), "LINE4TENB": (4, 1), "LINE6TENB": (6, 1)}
ANCHORS = {"LINE1TENA": (1, 0), "LINE3TENA": (3, 0), "LINE5TENA": (5, 0)}


class Case(NamedTuple):
    """A case: the model and motion, the channels and the shapes of lines (times, (n, nodes, 3)) of a program."""

    model: Model
    motion: Motion
    channels: np.ndarray
    shapes: dict[int, tuple[np.ndarray, np.ndarray]]


def case(reference, name: str, program: str = "F") -> Case:
    folder = reference / "bathymetry_friction" / name
    model = read(folder / "moordyn_F.dat")
    shapes = {}
    for line in model.lines:
        path = folder / f"line{line.id}_{program}.csv"
        if path.exists():
            shapes[line.id] = shape(path, line.sections[0].segments + 1)
    motion = read_motion(folder / "motion.txt", model)
    return Case(model, motion, table(folder / f"main_{program}.csv"), shapes)


def table(path) -> np.ndarray:
    return np.genfromtxt(path, delimiter=",", names=True)


def shape(path, nodes: int) -> tuple[np.ndarray, np.ndarray]:
    rows = table(path)
    places = np.stack([[rows[f"Node{i}p{axis}"] for axis in "xyz"] for i in range(nodes)])
    return rows["Time"], np.moveaxis(places, 2, 0)


def with_friction(model: Model, friction) -> Model:
    return dataclasses.replace(model, environment=dataclasses.replace(model.environment, friction=friction))


def from_statics(given: Case, duration: float, **settings) -> tuple[Built, Block]:
    """Run a case from our own statics."""
    built = build(given.model, given.motion, duration)
    solve(built)
    return built, March(built, Settings(dt_out=0.25, dt_nodes=1.0, **settings), duration).advance(duration)


def from_theirs(given: Case, duration: float, **settings) -> tuple[Built, Block]:
    """Run a case from the places and velocities (by differences) that the other program had at 1 s.

    Ropes that were not recorded hang in equilibrium from the recorded end of their chain.
    """
    late = given.motion.time >= FIRST - 1e-9
    tracks = {id: track[late] for id, track in given.motion.resolve(given.model, given.motion.duration).items()}
    motion = Motion.from_points(given.motion.time[late] - FIRST, tracks)
    joints = {line.end_b.id: given.shapes[line.id][1][:3, -1] for line in given.model.lines if line.id in given.shapes}
    held = [
        dataclasses.replace(point, kind="fixed", position=tuple(joints[point.id][0]))
        if point.kind == "free"
        else dataclasses.replace(point, position=tuple(tracks[point.id][0]))
        if point.kind == "coupled"
        else point
        for point in given.model.points
    ]
    hung = build(with_friction(dataclasses.replace(given.model, points=tuple(held)), None))
    solve(hung)
    built = build(given.model, motion, duration)
    rest(built)
    state, names = built.state, built.names
    state.position[:] = hung.state.position
    for k, line in enumerate(given.model.lines):
        rows = slice(*names.node_ptr[k : k + 2])
        if line.id in given.shapes:
            put(state, rows, given.shapes[line.id][1][:3])
        elif line.end_a.id in joints:
            put(state, slice(rows.start, rows.start + 1), joints[line.end_a.id][:, None])
    for k, point in enumerate(given.model.points):
        if point.kind == "free":
            put(state, slice(names.node_ptr[-1] + k, names.node_ptr[-1] + k + 1), joints[point.id][:, None])
    state.stuck[:] = state.position
    return built, March(built, Settings(dt_out=0.25, dt_nodes=1.0, **settings), duration).advance(duration)


def put(state, rows: slice, places: np.ndarray) -> None:
    """Put rows where the first of three shapes (3, rows, 3), a second apart, has them, with its velocity."""
    state.position[rows] = places[0]
    state.velocity[rows] = 0.5 * (-3.0 * places[0] + 4.0 * places[1] - places[2])


def tension_errors(given: Case, block: Block, channels, start: float = 0.0, after: float = 2.0) -> dict[str, float]:
    """Return the rms error of end tensions over the rms of theirs; their last 0.5 s are smoothed."""
    time = block["time"] + start
    seen = (time > after) & (time < given.channels["Time"][-1] - 0.5)
    errors = {}
    for name, (line, end) in channels.items():
        if name in given.channels.dtype.names:
            k = [one.id for one in given.model.lines].index(line)
            ours = np.linalg.norm(block["end_load"][seen, k, end], axis=1)
            errors[name] = float(rms(ours, np.interp(time[seen], given.channels["Time"], given.channels[name])))
    return errors


def distances(given: Case, built: Built, block: Block, line: int, start: float = 0.0) -> np.ndarray:
    """Return how far the nodes of a line are from theirs, (times, nodes), m."""
    k = [one.id for one in given.model.lines].index(line)
    rows = slice(*built.names.node_ptr[k : k + 2])
    time, places = given.shapes[line]
    common = np.isin(np.round(time, 6), np.round(block["node_time"] + start, 6)) & (
        time < given.channels["Time"][-1] - 0.5
    )
    ours = np.isin(np.round(block["node_time"] + start, 6), np.round(time[common], 6))
    return np.linalg.norm(block["node_position"][ours, rows] - places[common], axis=-1)
