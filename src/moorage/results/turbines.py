"""The columns of turbines: where they are, and what the mooring does to them.

Verified by tests/verification/test_farm.py.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from moorage.model import Model, Motion
from moorage.model.turbines import on_turbines
from moorage.physics.motion import Tracks, no_tracks, sample_track, spline_tracks
from moorage.solve.blocks import Block
from moorage.solve.carried import euler_angles

NAMES = ("turbine_position", "turbine_rotation", "turbine_force", "turbine_moment")


class Aboard(NamedTuple):
    """Something on a turbine, whose load the turbine bears."""

    kind: str  # "point", "rod" or "body"
    place: int  # among those of the model
    turns: bool  # whether it hands on moments


@dataclass(frozen=True)
class Turbines:
    """Labels of the turbines of a model in the order of the file, what is on them, and how they move.

    Attributes
    ----------
    turbine : (turbines,) int
        Numbers.
    turbine_name : (turbines,) str
    point_turbine : (points,) int
        The turbine that each point is on, 0 for none; of a point on a body, that of the body.
    aboard : tuple of tuple of Aboard
        What is on each.
    tracks : Tracks
        Of the reference point, first and second axis of each.
    """

    turbine: np.ndarray
    turbine_name: np.ndarray
    point_turbine: np.ndarray
    aboard: tuple[tuple[Aboard, ...], ...]
    tracks: Tracks

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the variables over time."""
        return NAMES

    @property
    def sizes(self) -> dict[str, int]:
        """Lengths of the dimensions."""
        return {"turbine": len(self.turbine)}

    @property
    def coordinates(self) -> dict[str, np.ndarray]:
        """Values of the coordinates."""
        return {name: getattr(self, name) for name in ("turbine", "turbine_name", "point_turbine")}

    def columns(self, block: Block) -> dict[str, np.ndarray]:
        """Return the columns of a block, by name."""
        place, turn = self._poses(np.ascontiguousarray(block["time"]))
        force, moment = np.zeros_like(place), np.zeros_like(place)
        for k, parts in enumerate(self.aboard):
            for at, f, m in loads_of(parts, block):
                force[:, k] += f
                moment[:, k] += m + np.cross(at - place[:, k], f)
        return dict(zip(NAMES, (place, euler_angles(turn), force, moment), strict=True))

    def _poses(self, time: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return reference points (n, turbines, 3), m, and rotations (n, turbines, 3, 3) at times (n,), s."""
        n = len(self.turbine)
        rows, rate, change = (np.zeros((3 * n, len(time), 3)) for _ in range(3))
        for row in range(3 * n):
            sample_track(self.tracks, row, time, rows[row], rate[row], change[row])
        place, first, second = rows.reshape(n, 3, len(time), 3).transpose(1, 2, 0, 3)
        return place, np.stack([first, second, np.cross(first, second)], axis=-1)


def loads_of(parts: tuple[Aboard, ...], block: Block) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Yield where each part bears its load, (n, 3), m, and its force and moment there, (n, 3), N and N m."""
    for part in parts:
        if part.kind == "point":
            yield block["point_position"][:, part.place], block["point_force"][:, part.place], np.zeros(3)
            continue
        load = block[f"{part.kind}_force"][:, part.place]
        at = block[f"{part.kind}_position"][:, part.place]
        moment = load[:, 3:] if part.turns else np.zeros(3)
        yield (at[:, 0] if part.kind == "rod" else at), load[:, :3], moment


def turbines_of(model: Model, motion: Motion | None) -> Turbines | None:
    """Return what the columns of turbines need; None for a model without."""
    if not model.turbines:
        return None
    carried = {body.id: body.turbine for body in model.bodies}
    things = {"point": model.points, "rod": model.rods, "body": model.bodies}
    places = {(kind, t.id): k for kind, every in things.items() for k, t in enumerate(every)}  # type: ignore[attr-defined]
    aboard: dict[int | None, list[Aboard]] = {turbine.id: [] for turbine in model.turbines}
    for kind, thing in on_turbines(model):
        aboard[thing.turbine].append(Aboard(kind, places[kind, thing.id], thing.kind == "coupled"))
    return Turbines(
        np.array([turbine.id for turbine in model.turbines], dtype=np.int64),
        np.array([turbine.name for turbine in model.turbines], dtype=object),
        np.array([(p.turbine if p.body is None else carried[p.body]) or 0 for p in model.points], dtype=np.int64),
        tuple(tuple(aboard[turbine.id]) for turbine in model.turbines),
        _tracks(model, motion),
    )


def _tracks(model: Model, motion: Motion | None) -> Tracks:
    """Return the tracks of reference points and of two axes.

    At rest where a turbine has no motion of its own: MoorDyn's columns move what is on it one by one.
    """
    rest = np.concatenate([[turbine.position, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)] for turbine in model.turbines])
    poses = motion.poses(model) if motion else {}
    moved: dict[int, np.ndarray] = {}
    for k, turbine in enumerate(model.turbines):
        if turbine.id in poses:
            pose = poses[turbine.id]
            moved |= {3 * k: pose.place(turbine.position), 3 * k + 1: pose.turn[..., 0], 3 * k + 2: pose.turn[..., 1]}
    return spline_tracks(rest, motion.time, moved) if motion and moved else no_tracks(rest)
