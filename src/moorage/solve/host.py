"""A run whose coupled points are moved by another program, one coupling step at a time.

Between the two ends of a coupling step the points follow the cubic that has the host's positions and velocities at
both, so that positions and velocities are continuous.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from moorage._held import Held, Snapshot
from moorage.errors import MoorageError, SimulationError
from moorage.layout import State
from moorage.physics.motion import Tracks, all_finite, sample_track, set_cubics
from moorage.physics.sea import given_at
from moorage.solve.blocks import Block, reactions_of
from moorage.solve.given_water import as_water, set_given, takes_water
from moorage.solve.march import March, Settings
from moorage.solve.march_kernel import start_islands
from moorage.solve.record import FORCE_A, Record, new_record
from moorage.solve.reeling import length_columns, paid_by
from moorage.solve.statics import rest, solve
from moorage.system.build import Built, Releases, with_motion
from moorage.system.winches import Reeled, refuse_haste


def turned_directions(built: Built) -> np.ndarray:
    """Return the tracks of the directions that coupled rods and bodies turn: of clamps, and two axes of each body."""
    directions = built.system.bending.direction[np.isin(built.system.lines.end_point, built.coupled)]
    axes = built.bodies.axes[np.isin(built.bodies.place, built.coupled)]
    return np.unique(np.concatenate([directions[directions >= 0], axes, axes + 1]))


class HostMarch:
    """The state of a coupled run.

    Parameters
    ----------
    built : Built
        System with its coupled points where the model describes them.
    settings : Settings
    hosts_water : bool
        Whether the host gives the water.
    cut : callable, optional
        Builds the system with lines on winches cut in another way.

    Attributes
    ----------
    driven : (m,) int
        Tracks that the host moves: the coupled points and rod ends, then the directions that they turn. Forces are
        those on the first `len(built.coupled)`.
    position, velocity : (m, 3) array
        Of them now, m and m/s.
    paid : (controls, 2) array
        Length that winches have paid out, m, and its rate, m/s.
    paid_next : (controls, 2) array
        The same at the end of the next step.
    """

    def __init__(
        self,
        built: Built,
        settings: Settings | None = None,
        hosts_water: bool = False,
        cut: Callable[[Reeled | None], Built] | None = None,
    ):
        built = takes_water(built) if hosts_water else built
        coupled = built.coupled
        self.driven = np.concatenate([coupled, turned_directions(built)]).astype(np.int64)
        rows = np.concatenate([self.driven, built.paid])
        track = np.full(len(built.system.tracks.rest), -1)  # of points, ends of rods, directions of clamps, and winches
        track[rows] = np.arange(len(rows))
        # one interval for each coupled point, rewritten in place at each coupling step
        cubics = np.zeros((len(rows), 1, 3, 4))
        self._tracks = Tracks(track, built.system.tracks.rest.copy(), np.array([0.0, 1.0]), cubics)
        self.paid = np.zeros((len(built.paid), 2))
        for k, paid in enumerate(paid_by(built)):
            self.paid[k, 0] = paid.at(0.0)[0]
        self.paid_next = self.paid.copy()
        self._lines = len(built.names.lines)
        row = np.full(len(track), len(coupled))  # all other holders share one row, which nobody looks at
        row[coupled] = np.arange(len(coupled))
        ends = built.system.lines.end_point[: self._lines].ravel()
        self._component = (3 * row[ends, None] + np.arange(3)).ravel()
        self._record = new_record(built.system, np.zeros(1), np.zeros(0), np.zeros((0, 2), dtype=np.int64))
        self.built = with_motion(built, self._tracks)
        self._releases: Releases | None = None
        if cut is not None:
            self._releases = Releases({}, {}, lambda _, reeled: with_motion(cut(reeled), self._tracks), None)
        holders = np.arange(len(built.system.points.mass))
        self._held = np.setdiff1d(holders, built.system.islands.points)  # whose rows of the state are not used
        self.settings = settings or Settings()
        self.position = self._tracks.rest[self.driven].copy()
        self.velocity = np.zeros_like(self.position)
        self.time = 0.0
        self._march: March | None = None
        self._snapshot: Snapshot | None = None
        self._snapshot_of: Held | None = None

    def initialize(self, position=None, velocity=None, static: bool = True) -> np.ndarray:
        """Start at time 0 with the coupled points at a position (m, 3), m; return the forces on them (m, 3), N."""
        if position is not None:
            self.position = self._checked("position", position)
        self.velocity = np.zeros_like(self.position) if velocity is None else self._checked("velocity", velocity)
        self._set_tracks(0.0, 1.0, self.position, np.zeros_like(self.position))
        if static:
            solve(self.built)
        else:
            rest(self.built)
        self._set_tracks(0.0, 1.0, self.position + self.velocity, self.velocity)
        self.time = 0.0
        self._march = March(self.built, self.settings, 0.0, self._releases)
        return self._forces(0.0)

    def take_over(self, time: float, state: State, position, velocity) -> np.ndarray:
        """Go on at a time (s) from the state of another system with the same rows; return the forces, (m, 3), N."""
        self.position, self.velocity = self._checked("position", position), self._checked("velocity", velocity)
        for target, source in zip(self.built.state, state, strict=True):
            target[...] = source
        self._set_tracks(time, time + 1.0, self.position + self.velocity, self.velocity)
        self._march = March(self.built, self.settings, 0.0)
        self._march._begin(time, self._march.built)
        self.time = float(time)
        return self._forces(time)

    def step(self, time: float, position, velocity) -> np.ndarray:
        """Advance to `time` (s) with the coupled points ending at (m, 3) m and m/s; return the forces on them, N.

        Raises
        ------
        SimulationError
            Bad numbers, a time that does not increase, or a step that cannot be solved: the state is left as it was.
        """
        if self._march is None:
            raise SimulationError("step() before initialize(): call initialize() first", self.time)
        if not np.isfinite(time) or time <= self.time:
            late = f"step() to {time} s, but the run is at {self.time:g} s: time must increase"
            raise SimulationError(late, self.time)
        position, velocity = self._checked("position", position), self._checked("velocity", velocity)
        go_back = self._way_back()
        self._set_tracks(self.time, time, position, velocity)
        try:
            if len(self.paid):
                rates = (self.paid_next[:, 0] - self.paid[:, 0]) / (time - self.time)
                refuse_haste(self.built.winches, rates.tolist(), self.time)
                self._cut_until(time)
            forces = self._forces(time)
        except MoorageError:
            go_back()
            raise
        self.time, self.position, self.velocity = float(time), position, velocity
        self.paid, self.paid_next = self.paid_next, self.paid_next * [1.0, 0.0]
        return forces

    def _way_back(self) -> Callable[[], None]:
        """Return what undoes a step that fails."""
        if len(self.paid):  # lines may be cut anew on the way
            saved = self.save()
            return lambda: self.restore(saved)
        march, time = self.march, self.march.time
        held = march.hold(self._record)
        if self._snapshot is None or held is not self._snapshot_of:
            self._snapshot, self._snapshot_of = Snapshot(march.changing), held
        snapshot = self._snapshot
        snapshot.keep()

        def go_back() -> None:
            snapshot.go_back()
            march.time = time

        return go_back

    def take_water(self, given: np.ndarray | None = None) -> None:
        """Let the host give the water from now on, still until it does; given: (2, rows + 1, 7) of another system."""
        given = given_at(len(self.built.state.position)) if given is None else given
        self.built = takes_water(self.built, given)
        if self._march is not None:
            self._march.built = takes_water(self._march.built, given)

    def _cut_until(self, time: float) -> None:
        """Advance as far as winches make and remove segments on the way to a time, s."""
        self.march.look_ahead(time)
        while self.march.next_cut <= time:
            self._forces(self.march.next_cut)
            self.march.cut_lines()
            self.built = self.march.built
            self.march.look_ahead(time)

    def line_lengths(self) -> np.ndarray:
        """Return the unstretched lengths of the lines now, (lines,), m."""
        built = self.built if self._march is None else self._march.built
        return length_columns(built, np.array([self.time]))["line_length"][0]

    def water_nodes(self) -> np.ndarray:
        """Return where the host has to say what the water does, (rows, 3), m: every row of the state."""
        places = self.built.state.position.copy()
        coupled, first = self.built.coupled, int(self.built.system.lines.node_ptr[-1])  # row of the first point
        places[first + self._held] = self._tracks.rest[self._held]
        places[first + coupled] = self.position[: len(coupled)]
        return places

    def set_water(self, elevation, velocity, acceleration, time: float | None = None) -> None:
        """Say what the water does at `water_nodes` now, or at a later time (s) to which it goes linearly."""
        if self._march is None:
            raise SimulationError("set_water() before initialize(): call initialize() first", self.time)
        given, time = self.built.system.sea.given, self.time if time is None else float(time)
        if not time >= self.time:
            raise SimulationError(f"set_water() at {time} s, but the run is at {self.time:g} s", self.time)
        values = as_water(self.time, given.shape[1] - 1, elevation, velocity, acceleration)
        set_given(given, self.time, values, time)
        if time == self.time:  # the forces jump, and with them the accelerations
            start_islands(self.built.system, self.built.state, self.built.work, self.time)

    def save(self) -> Block:
        """Return the whole state, so that a host can come back to it."""
        if self._march is None:
            raise SimulationError("save() before initialize(): call initialize() first", self.time)
        return self._march.checkpoint() | {
            "host": np.array([self.time]),
            "host_position": self.position.copy(),
            "host_velocity": self.velocity.copy(),
            "host_paid": np.stack([self.paid, self.paid_next]),
        }

    def restore(self, saved: Block) -> None:
        """Go back to a saved state."""
        if self._march is None:
            raise SimulationError("restore() before initialize(): call initialize() first", self.time)
        self._march.restore(saved)
        if self._releases is not None:
            self.built = self._march.built
        self.time = float(saved["host"][0])
        self.position, self.velocity = saved["host_position"].copy(), saved["host_velocity"].copy()
        self.paid, self.paid_next = saved["host_paid"].copy()

    @property
    def march(self) -> March:
        """The march below."""
        if self._march is None:
            raise SimulationError("nothing to look at before initialize(): call initialize() first", self.time)
        return self._march

    def fill(self, record: Record) -> Block:
        """Return the records of the present time, for a record of one time made with `new_record`."""
        record.time[:] = self.time
        record.node_time[:] = self.time
        self.march.run(self.time, self.time, record)
        return self.march.block(record, len(record.time), len(record.node_time))

    def reactions(self) -> Block:
        """Return `rod_force` and `body_force` (1, n, 6) now, see `moorage.solve.reactions`, N and N m."""
        return reactions_of(self.march.built, self._record)

    def motion_of(self, row: int) -> np.ndarray:
        """Return position, velocity and acceleration (1, 9) of a driven row now."""
        out = np.zeros((3, 1, 3))
        sample_track(self._tracks, int(self.driven[row]), np.array([self.time]), *out)
        return np.concatenate(out, axis=1)

    def _checked(self, name: str, values) -> np.ndarray:
        array = np.array(values, dtype=float)
        if array.size == self.position.size and all_finite(array.reshape(-1, 3)):
            return array.reshape(self.position.shape)
        raise SimulationError(
            f"{name}: expected {len(self.position)} x 3 finite numbers (coupled points in the order of the file), "
            f"got an array of shape {array.shape}" + ("" if np.isfinite(array).all() else " with NaN or inf in it"),
            self.time,
        )

    def _set_tracks(self, t0: float, t1: float, position, velocity) -> None:
        """Put the Hermite cubic from the present motion to the one at t1 into the tracks."""
        set_cubics(self._tracks, float(t0), float(t1), self.position, self.velocity, position, velocity)
        if len(self.paid):
            lengths = self._tracks._replace(coefficients=self._tracks.coefficients[len(self.driven) :])
            now, then = (np.pad(paid[:, None], ((0, 0), (0, 2), (0, 0))) for paid in (self.paid, self.paid_next))
            columns = [np.ascontiguousarray(x[..., k]) for x in (now, then) for k in (0, 1)]
            set_cubics(lengths, float(t0), float(t1), *columns)

    def _forces(self, time: float) -> np.ndarray:
        """Advance to a time and sum the forces of all line ends on each coupled point, (m, 3), N.

        `March.block` would do the same in 80 us, as long as MoorDyn-C takes for three such steps.
        """
        assert self._march is not None
        self._record.time[0] = time
        self._march.run(time, time, self._record)
        self._march.time = time
        ends = self._record.lines[0, : self._lines, FORCE_A : FORCE_A + 6].ravel()
        m = len(self.built.coupled)
        return np.bincount(self._component, ends, 3 * m + 3)[: 3 * m].reshape(m, 3)
