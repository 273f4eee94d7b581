"""Prescribed motion of the coupled objects: samples in time, whatever they were made from.

One rigid platform carries all coupled points, each turbine of a farm carries its own, or each point has its own track.
Between samples the motion is a C2 cubic spline (see `moorage.physics.motion`), so that the imposed velocity never
jumps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from moorage.errors import MotionError, Problem, Source
from moorage.model.components import Body, Point, Rod
from moorage.model.model import Model
from moorage.model.samples import check_samples
from moorage.model.turbines import placed

MOVED = ("coupled", "coupled-pinned")  # kinds of bodies and rods that a motion moves


class Pose(NamedTuple):
    """Where a rigid platform is over time, and how it is turned."""

    origin: np.ndarray  # (3,) its reference point at rest, about which it turns, m
    shift: np.ndarray  # (n, 3) m
    turn: np.ndarray  # (n, 3, 3)

    def place(self, position) -> np.ndarray:
        """Return where a point (3,) of the platform goes, (n, 3), m."""
        return self.origin + self.shift + self.turn @ (np.array(position) - self.origin)


@dataclass(frozen=True)
class Motion:
    """Samples of prescribed motion.

    Parameters
    ----------
    time : (n,) array
        s, increasing.
    platform : (n, 6) array or None
        Surge, sway, heave (m), roll, pitch, yaw (rad; intrinsic XYZ) of one rigid platform about the origin: added to
        the positions of the coupled points as described. Points, rods and bodies on turbines are not on it.
    turbines : mapping of turbine number to (n, 6) array
        The same of each turbine of a farm, about its reference position.
    points : mapping of point id to (n, 3) array
        Absolute positions x, y, z of single coupled points, m.
    coupled : (n, k) array or None
        MoorDyn-F's columns: the coordinates of every coupled body and rod (6 each), then point (3 each), in the
        file's order, m and rad; of a farm first what is on no turbine, then turbine by turbine. Resolved against the
        model with `resolve`.
    """

    time: np.ndarray
    platform: np.ndarray | None = None
    turbines: Mapping[int, np.ndarray] = field(default_factory=dict)
    points: Mapping[int, np.ndarray] = field(default_factory=dict)
    coupled: np.ndarray | None = None
    source: Source | None = field(default=None, compare=False)

    reader: ClassVar[Callable[..., Motion] | None] = None  # moorage.io puts its reader here: the model knows no files

    def __post_init__(self):
        time = np.array(self.time, dtype=float)
        object.__setattr__(self, "time", time)
        check_samples(time, self._tables(), self.source)

    def _tables(self):
        if self.platform is not None:
            object.__setattr__(self, "platform", np.array(self.platform, dtype=float))
            yield "the platform", self.platform, 6
        if self.coupled is not None:
            object.__setattr__(self, "coupled", np.array(self.coupled, dtype=float))
            yield "the coupled objects", self.coupled, 0
        for field_name, what, width in (("turbines", "turbine", 6), ("points", "point", 3)):
            tables = {int(k): np.array(v, dtype=float) for k, v in getattr(self, field_name).items()}
            object.__setattr__(self, field_name, tables)
            for k, values in tables.items():
                yield f"{what} {k}", values, width

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
    def from_turbines(cls, motions: Mapping[int, Motion]) -> Motion:
        """Put the platform motions of the turbines of a farm together, by number.

        Where their times differ they are sampled at all of them, by cubic splines, up to the end of the shortest.
        """
        bad = [id for id, motion in motions.items() if motion.platform is None]
        if bad or not motions:
            what = f"motion of turbine {bad[0]} is not that of a platform" if bad else "there are no motions"
            raise MotionError(Problem(what, "give each turbine surge, sway, heave, roll, pitch and yaw"))
        every = [motion.time for motion in motions.values()]
        time = every[0]
        if any(not np.array_equal(time, other) for other in every[1:]):
            time = np.unique(np.concatenate(every))
            first, last = max(t[0] for t in every), min(t[-1] for t in every)
            time = time[(time >= first) & (time <= last)]
        return cls(time, turbines={id: motion._platform_at(time) for id, motion in motions.items()})

    def _platform_at(self, time: np.ndarray) -> np.ndarray:
        """Return the platform's displacements at other times (n,), (n, 6)."""
        assert self.platform is not None
        if np.array_equal(time, self.time):
            return self.platform
        from scipy.interpolate import CubicSpline  # noqa: PLC0415  0.15 s, which most runs need not pay

        return CubicSpline(self.time, self.platform)(time)

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

        A motion (x, y, z, roll, pitch, yaw) of the platform, or of a turbine with its reference at r, takes a point
        described at p from there to r + (x, y, z) + Rx(roll) Ry(pitch) Rz(yaw) p (intrinsic XYZ angles, as MoorDyn); a
        track of a single point is taken as it is and wins.

        Parameters
        ----------
        duration : float, optional
            s; the motion must reach from time 0 to this time.
        """
        self._must_cover(duration)
        model = placed(model)
        described = {point.id: point for point in model.coupled_points}
        tracks = self._columns_by_point(model)
        tracks.update(self.points)
        problems = [
            Problem(f"motion is given for point {id}, which is not coupled", _coupled_ids(described), self.source)
            for id in tracks
            if id not in described
        ]
        poses = self.poses(model)
        for id, point in described.items():
            if id not in tracks and point.turbine in poses:
                tracks[id] = poses[point.turbine].place(point.position)
        problems += self._lacking("point", described.values(), tracks)
        if problems:
            raise MotionError(problems)
        return {id: tracks[id] for id in described}

    def poses(self, model: Model) -> dict[int | None, Pose]:
        """Return where the turbines are that this moves, by number, and under None the platform of all else."""
        at = {turbine.id: np.array(turbine.position, float) for turbine in model.turbines}
        unknown = [id for id in self.turbines if id not in at]
        if unknown:
            known = f"the turbines are {', '.join(map(str, at))}" if at else "the model has no turbines"
            what = "motion is given for turbine {}, which is not there"
            raise MotionError([Problem(what.format(id), known, self.source) for id in unknown])
        tables: dict[int | None, tuple[np.ndarray, np.ndarray]] = {}
        if self.platform is not None:
            tables[None] = np.zeros(3), self.platform
        tables |= {id: (at[id], table) for id, table in self.turbines.items()}
        return {id: Pose(x, table[:, :3], rotation_matrices(table[:, 3:])) for id, (x, table) in tables.items()}

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
        model = placed(model)
        columns, poses, found = self._columns(model), self.poses(model), {}
        moved = [body for body in model.bodies if body.kind in MOVED]
        for body in moved:
            if ("body", body.id) in columns:
                part = columns["body", body.id]
                found[body.id] = part[:, :3], rotation_matrices(part[:, 3:])
            elif body.turbine in poses:
                pose, own = poses[body.turbine], rotation_matrices(np.array([body.rotation]))[0]
                found[body.id] = pose.place(body.position), pose.turn @ own
        if problems := self._lacking("body", moved, found):
            raise MotionError(problems)
        return found

    def resolve_rods(self, model: Model) -> dict[int, tuple[np.ndarray, np.ndarray]]:
        """Return position of end A (n, 3), m, and unit direction from A to B (n, 3) of every coupled rod, by id.

        MoorDyn's three angles of a rod turn the vertical (0, 0, 1) into its direction.
        """
        model = placed(model)
        columns, poses, found = self._columns(model), self.poses(model), {}
        moved = [rod for rod in model.rods if rod.kind in MOVED and rod.body is None]
        for rod in moved:
            if ("rod", rod.id) in columns:
                part = columns["rod", rod.id]
                found[rod.id] = part[:, :3], rotation_matrices(part[:, 3:])[:, :, 2]
            elif rod.turbine in poses:
                pose = poses[rod.turbine]
                found[rod.id] = pose.place(rod.end_a), pose.turn @ np.array(rod.direction)
        if problems := self._lacking("rod", moved, found):
            raise MotionError(problems)
        return found

    def _lacking(self, kind: str, things: Iterable[Point | Rod | Body], found) -> list[Problem]:
        """Return a problem for each coupled thing, or its turbine, that nothing moves."""
        problems: dict[object, tuple[str, str]] = {}
        for thing in things:
            if thing.id in found:
                continue
            message, remedy = f"coupled {kind} {thing.id} has no motion", "add its track, or give a platform motion"
            if kind != "point":
                remedy = "give a platform motion, or MoorDyn's columns"
            if thing.turbine is not None:
                message = f"turbine {thing.turbine}, with {kind} {thing.id} on it, has no motion"
                remedy = f"give columns turbine{thing.turbine}.surge[m] and so on (zeros where it rests)"
                if self.platform is not None:
                    remedy += "; those of a platform move what is on no turbine"
            problems.setdefault(
                ("turbine", thing.turbine) if thing.turbine is not None else thing.id, (message, remedy)
            )
        return [Problem(message, remedy, self.source) for message, remedy in problems.values()]

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

    In a farm what is on no turbine comes first, then turbine by turbine. MoorDyn-F's driver wants a column for every
    control channel too, which it reads and does not use.
    """
    moved = [("body", body, 6) for body in model.bodies if body.kind in MOVED]
    moved += [("rod", rod, 6) for rod in model.rods if rod.kind in MOVED and rod.body is None]  # type: ignore[misc]
    moved += [("point", point, 3) for point in model.coupled_points]  # type: ignore[misc]
    moved.sort(key=lambda entry: entry[1].turbine or 0)
    channels = range(1, max((control.channel for control in model.controls), default=0) + 1)
    return [(kind, thing.id, width) for kind, thing, width in moved] + [("control channel", k, 1) for k in channels]


def rotation_matrices(angles: np.ndarray) -> np.ndarray:
    """Return R = Rx(roll) Ry(pitch) Rz(yaw), (n, 3, 3), of intrinsic XYZ angles (n, 3), rad."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(angles).T, np.sin(angles).T
    rows = (
        (cy * cz, -cy * sz, sy),
        (cx * sz + sx * sy * cz, cx * cz - sx * sy * sz, -sx * cy),
        (sx * sz - cx * sy * cz, sx * cz + cx * sy * sz, cx * cy),
    )
    return np.moveaxis(np.array(rows), -1, 0)


def _coupled_ids(described: Iterable[int]) -> str:
    ids = ", ".join(map(str, described))
    return f"the coupled points are {ids}" if ids else "the model has no coupled points"
