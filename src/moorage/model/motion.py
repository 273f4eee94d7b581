"""Prescribed motion of the coupled objects: samples in time, whatever they were made from.

One rigid platform carries all coupled points, or each point has its own track. Between samples the motion is a
C2 cubic spline (see `moorage.physics.motion`), so that the imposed velocity never jumps.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from moorage.errors import MotionError, Problem, Source
from moorage.model.model import Model

MOVED = ("coupled", "coupled-pinned")  # kinds of bodies and rods that a motion moves


@dataclass(frozen=True)
class Motion:
    """Samples of prescribed motion.

    Parameters
    ----------
    time : (n,) array
        s, increasing.
    platform : (n, 6) array or None
        Surge, sway, heave (m), roll, pitch, yaw (rad; intrinsic XYZ) of one rigid platform about the origin: added to
        the positions of the coupled points as described.
    points : mapping of point id to (n, 3) array
        Absolute positions x, y, z of single coupled points, m.
    coupled : (n, k) array or None
        MoorDyn-F's columns: the coordinates of every coupled body and rod (6 each), then point (3 each), in the
        file's order, m and rad. Resolved against the model with `resolve`.
    """

    time: np.ndarray
    platform: np.ndarray | None = None
    points: Mapping[int, np.ndarray] = field(default_factory=dict)
    coupled: np.ndarray | None = None
    source: Source | None = field(default=None, compare=False)

    reader: ClassVar[Callable[..., Motion] | None] = None  # moorage.io puts its reader here: the model knows no files

    def __post_init__(self):
        time = np.array(self.time, dtype=float)
        object.__setattr__(self, "time", time)
        for name, values in self._tables():
            if values.ndim != 2 or len(values) != len(time):
                raise MotionError(
                    Problem(
                        f"motion of {name} has shape {values.shape} for {len(time)} times",
                        "give one row of coordinates for each time",
                        self.source,
                    )
                )
            bad = np.flatnonzero(~np.isfinite(values).all(axis=1))
            if len(bad):
                raise MotionError(
                    Problem(
                        f"motion of {name} is not a number at {time[bad[0]]:g} s", "give finite values", self.source
                    )
                )
        if time.ndim != 1 or len(time) < 2 or not np.isfinite(time).all():
            raise MotionError(Problem("motion needs at least two finite times", "add samples", self.source))
        back = np.flatnonzero(np.diff(time) <= 0.0)
        if len(back):
            k = int(back[0]) + 1
            raise MotionError(
                Problem(
                    f"time does not increase at sample {k + 1}",
                    f"the time after {time[k - 1]:g} s must be larger",
                    self.source,
                    float(time[k]),
                )
            )

    def _tables(self):
        if self.platform is not None:
            object.__setattr__(self, "platform", np.array(self.platform, dtype=float))
            yield "the platform", self.platform
        if self.coupled is not None:
            object.__setattr__(self, "coupled", np.array(self.coupled, dtype=float))
            yield "the coupled objects", self.coupled
        points = {int(k): np.array(v, dtype=float) for k, v in self.points.items()}
        object.__setattr__(self, "points", points)
        for k, values in points.items():
            yield f"point {k}", values

    @property
    def duration(self) -> float:
        """Last time, s."""
        return float(self.time[-1])

    @classmethod
    def read(cls, path: str | Path, model: Model | None = None) -> Motion:
        """Read a motion file, MoorDyn-F's or a CSV with named columns; see `moorage.io.read_motion`."""
        if cls.reader is None:
            raise RuntimeError("import moorage.io before reading motion files")
        return cls.reader(path, model)

    @classmethod
    def from_platform(cls, time: ArrayLike, displacement: ArrayLike) -> Motion:
        """Build from samples of one rigid platform: (n, 6), m and rad, about the origin."""
        return cls(np.asarray(time, float), platform=np.asarray(displacement, float))

    @classmethod
    def from_points(cls, time: ArrayLike, positions: Mapping[int, ArrayLike]) -> Motion:
        """Build from absolute positions (n, 3), m, of coupled points by id."""
        return cls(np.asarray(time, float), points={k: np.asarray(v, float) for k, v in positions.items()})

    @classmethod
    def from_function(
        cls, displacement: Callable[[float], ArrayLike], duration: float, interval: float = 0.05
    ) -> Motion:
        """Sample a function of time (s) that returns the platform's six displacements (m, rad)."""
        time = np.linspace(0.0, duration, max(2, int(np.ceil(duration / interval)) + 1))
        return cls(time, platform=np.array([np.asarray(displacement(float(t)), float) for t in time]))

    @classmethod
    def from_harmonics(
        cls,
        duration: float,
        *,
        ramp: float = 0.0,
        interval: float | None = None,
        **modes: tuple[float, float] | tuple[float, float, float],
    ) -> Motion:
        """Build a platform motion amplitude sin(2 pi t / period + phase) in each named mode.

        Parameters
        ----------
        duration, ramp : float
            s; the motion comes in over `ramp` with (1 - cos(pi t / ramp)) / 2.
        interval : float
            Sampling interval, s; by default a fortieth of the shortest period (spline error below 1e-6 of the
            amplitude).
        surge, sway, heave, roll, pitch, yaw : (amplitude, period[, phase])
            m or rad, s, rad.
        """
        names = ("surge", "sway", "heave", "roll", "pitch", "yaw")
        for name in modes:
            if name not in names:
                raise MotionError(Problem(f"there is no mode {name!r}", f"use one of {', '.join(names)}"))
        if not modes or any(mode[1] <= 0.0 for mode in modes.values()):
            raise MotionError(
                Problem("harmonics need a mode with a positive period", "write surge=(amplitude, period)")
            )
        step = interval or min(mode[1] for mode in modes.values()) / 40.0
        time = np.linspace(0.0, duration, max(2, int(np.ceil(duration / step)) + 1))
        envelope = np.where(time < ramp, 0.5 * (1.0 - np.cos(np.pi * time / ramp)), 1.0) if ramp > 0 else 1.0
        table = np.zeros((len(time), 6))
        for name, (amplitude, period, *phase) in modes.items():
            angle = 2.0 * np.pi * time / period + (phase[0] if phase else 0.0)
            table[:, names.index(name)] = envelope * amplitude * np.sin(angle)
        return cls(time, platform=table)

    def resolve(self, model: Model, duration: float | None = None) -> dict[int, np.ndarray]:
        """Return the absolute positions (n, 3), m, of every coupled point of the model, by id.

        A platform motion (x, y, z, roll, pitch, yaw) takes a point described at p to
        (x, y, z) + Rx(roll) Ry(pitch) Rz(yaw) p (intrinsic XYZ angles, as MoorDyn); a track of a single point is taken
        as it is and wins over the platform.

        Parameters
        ----------
        duration : float, optional
            s; the motion must reach from time 0 to this time.
        """
        self._must_cover(duration)
        described = {point.id: np.array(point.position) for point in model.coupled_points}
        tracks = self._columns_by_point(model)
        tracks.update(self.points)
        problems = [
            Problem(f"motion is given for point {id}, which is not coupled", _coupled_ids(described), self.source)
            for id in tracks
            if id not in described
        ]
        if self.platform is not None:
            rotation = rotation_matrices(self.platform[:, 3:])
            for id, position in described.items():
                tracks.setdefault(id, self.platform[:, :3] + rotation @ position)
        problems += [
            Problem(f"coupled point {id} has no motion", "add its track, or give a platform motion", self.source)
            for id in described
            if id not in tracks
        ]
        if problems:
            raise MotionError(problems)
        return {id: tracks[id] for id in described}

    def _must_cover(self, duration: float | None) -> None:
        if self.time[0] > 0.0:
            raise MotionError(
                Problem("motion starts after time 0", "add samples from time 0 s", self.source, float(self.time[0]))
            )
        if duration is not None and self.duration < duration * (1.0 - 1e-9):
            raise MotionError(
                Problem(
                    f"motion ends at {self.duration:g} s, the run at {duration:g} s",
                    f"run for {self.duration:g} s, or add samples",
                    self.source,
                )
            )

    def resolve_bodies(self, model: Model) -> dict[int, tuple[np.ndarray, np.ndarray]]:
        """Return position (n, 3), m, and rotation (n, 3, 3) of every coupled body, by id.

        A rotation takes body axes to global ones. A platform motion carries a body rigidly from where it is described.
        """
        columns, found = self._columns(model), {}
        for body in model.bodies:
            if body.kind not in MOVED:
                continue
            if ("body", body.id) in columns:
                part = columns["body", body.id]
                found[body.id] = part[:, :3], rotation_matrices(part[:, 3:])
            elif self.platform is not None:
                turn = rotation_matrices(self.platform[:, 3:])
                own = rotation_matrices(np.array([body.rotation]))[0]
                found[body.id] = self.platform[:, :3] + turn @ np.array(body.position), turn @ own
        self._must_have("body", [body.id for body in model.bodies if body.kind in MOVED], found)
        return found

    def resolve_rods(self, model: Model) -> dict[int, tuple[np.ndarray, np.ndarray]]:
        """Return position of end A (n, 3), m, and unit direction from A to B (n, 3) of every coupled rod, by id.

        MoorDyn's three angles of a rod turn the vertical (0, 0, 1) into its direction.
        """
        columns, found = self._columns(model), {}
        for rod in model.rods:
            if rod.kind not in MOVED or rod.body is not None:
                continue
            if ("rod", rod.id) in columns:
                part = columns["rod", rod.id]
                found[rod.id] = part[:, :3], rotation_matrices(part[:, 3:])[:, :, 2]
            elif self.platform is not None:
                turn = rotation_matrices(self.platform[:, 3:])
                found[rod.id] = self.platform[:, :3] + turn @ np.array(rod.end_a), turn @ np.array(rod.direction)
        self._must_have("rod", [r.id for r in model.rods if r.kind in MOVED and r.body is None], found)
        return found

    def _must_have(self, kind: str, ids, found) -> None:
        problems = [
            Problem(f"coupled {kind} {id} has no motion", "give a platform motion, or MoorDyn's columns", self.source)
            for id in ids
            if id not in found
        ]
        if problems:
            raise MotionError(problems)

    def _columns_by_point(self, model: Model) -> dict[int, np.ndarray]:
        """Cut MoorDyn-F's columns into the tracks of the coupled points."""
        return {id: part for (kind, id), part in self._columns(model).items() if kind == "point"}

    def _columns(self, model: Model) -> dict[tuple[str, int], np.ndarray]:
        """Cut MoorDyn-F's columns into those of each coupled object."""
        if self.coupled is None:
            return {}
        owners = coupled_columns(model)
        expected = sum(width for _, _, width in owners)
        if self.coupled.shape[1] != expected:
            listed = ", ".join(f"{kind} {id} ({width})" for kind, id, width in owners) or "no coupled objects"
            raise MotionError(
                Problem(
                    f"motion has {self.coupled.shape[1]} columns after time, the coupled objects need {expected}",
                    f"give, in this order: {listed}",
                    self.source,
                )
            )
        starts = np.cumsum([0, *(width for _, _, width in owners)])
        return {
            (kind, id): self.coupled[:, start : start + width]
            for (kind, id, width), start in zip(owners, starts, strict=False)
        }


def coupled_columns(model: Model) -> list[tuple[str, int, int]]:
    """Return (kind, id, number of columns) of the coupled objects in the order of MoorDyn's input vector.

    MoorDyn-F's driver wants a column for every control channel too, which it reads and does not use.
    """
    bodies = [("body", body.id, 6) for body in model.bodies if body.kind in MOVED]
    rods = [("rod", rod.id, 6) for rod in model.rods if rod.kind in MOVED and rod.body is None]
    points = [("point", point.id, 3) for point in model.coupled_points]
    channels = range(1, max((control.channel for control in model.controls), default=0) + 1)
    return bodies + rods + points + [("control channel", channel, 1) for channel in channels]


def rotation_matrices(angles: np.ndarray) -> np.ndarray:
    """Return R = Rx(roll) Ry(pitch) Rz(yaw), (n, 3, 3), of intrinsic XYZ angles (n, 3), rad."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(angles).T, np.sin(angles).T
    rows = (
        (cy * cz, -cy * sz, sy),
        (cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy),
        (sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy),
    )
    return np.moveaxis(np.array(rows), -1, 0)


def _coupled_ids(described: Mapping[int, np.ndarray]) -> str:
    ids = ", ".join(map(str, described))
    return f"the coupled points are {ids}" if ids else "the model has no coupled points"
