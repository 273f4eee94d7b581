"""A mooring inside another program, step by step."""

from __future__ import annotations

from typing import Literal

import numpy as np

from moorage.accept import accept, check_settings
from moorage.errors import Problem, SimulationError, UnsupportedError
from moorage.model import Model
from moorage.model.payout import paid_out
from moorage.solve.blocks import Block
from moorage.solve.coupling import Coupling, described
from moorage.solve.host import HostMarch
from moorage.solve.march import Settings
from moorage.system.build import build


class Simulation:
    """A mooring inside another program, which moves the coupled objects and receives the forces on them.

    Where only points are coupled, positions, velocities and forces are arrays (m, 3). Turbines, coupled bodies and rods
    make them vectors: all turbines, then bodies, rods and points, in the order of the file, with the numbers that
    `degrees_of_freedom` says: six for a turbine, body or rod (position, and intrinsic XYZ Euler angles in rad, and the
    rates of both), three for a point and for what is pinned (coupled-pinned). What is on a turbine goes with it. Forces
    come back in the same order, moments about the origin of each object in global axes, N and N m. Weight, buoyancy,
    drag and inertia of the objects are in them, and of all that they carry.

    Parameters
    ----------
    model : Model
    tolerance, time_step, method
        As for `simulate`.
    host_waves : bool
        The host says what the water does (`set_water`); so it is without asking when the model says so.

    Attributes
    ----------
    points : (m,) int
        Ids of the coupled points, in the order of all arrays here.
    degrees_of_freedom : tuple of (kind, id, width)
        All coupled objects, in the order of the vectors: "turbine", "body", "rod" or "point", id, how many numbers.

    Examples
    --------
    >>> sim = moorage.Simulation(model)                      # doctest: +SKIP
    >>> forces = sim.initialize()                            # doctest: +SKIP
    >>> state = sim.save()                                   # doctest: +SKIP
    >>> forces = sim.step(0.1, position, velocity)           # doctest: +SKIP
    >>> sim.restore(state)  # to try the step again          # doctest: +SKIP
    """

    def __init__(
        self,
        model: Model,
        *,
        tolerance: float | None = None,
        time_step: float | None = None,
        method: Literal["implicit", "rk2", "rk4"] = "implicit",
        host_waves: bool = False,
    ):
        chosen = {"tolerance": tolerance, "time_step": time_step}
        check_settings({**chosen, "method": method}, False, None)
        inside = accept(model)
        self._hosts_water = model.environment.host_waves or host_waves
        if self._hosts_water and model.environment.waves is not None:
            remedy = "remove them from the model, or leave host_waves out"
            raise UnsupportedError(Problem("the model has waves of its own", remedy, model.environment.waves.source))
        if model.failures:
            raise UnsupportedError(Problem("failures come in simulate() only", "remove them", model.failures[0].source))
        self.model = model
        built = build(inside)
        cut = (lambda reeled: build(inside, reeled=reeled)) if model.controls else None
        self._host = HostMarch(built, Settings(method=method, **chosen), self._hosts_water, cut)  # type: ignore[arg-type]
        self._paid = {c.channel: paid_out(c) for c in model.controls if c.length is not None or c.rate is not None}
        self._coupling = Coupling(inside, built, self._host.driven)
        self.degrees_of_freedom = self._coupling.owners
        self.points = np.array([id for kind, id, _ in self.degrees_of_freedom if kind == "point"], dtype=np.int64)
        self._flat = len(self.points) < len(self.degrees_of_freedom)
        self._pose = self._described = described(inside)

    @property
    def time(self) -> float:
        """Time of the state, s."""
        return self._host.time

    @property
    def position(self) -> np.ndarray:
        """Positions of the coupled points, (m, 3), m; or the vector of all coupled objects, m and rad."""
        return self._pose.copy() if self._flat else self._host.position.copy()

    def initialize(self, position=None, velocity=None) -> np.ndarray:
        """Start at time 0 and return the forces of the mooring on the coupled points, (m, 3), N, or objects.

        Parameters
        ----------
        position, velocity : (m, 3) array or vector, optional
            Of the coupled points, m and m/s, or objects; by default as described, at rest.
        """
        static = self.model.start == "static"
        if not self._flat:
            return self._host.initialize(position, velocity, static)
        pose = self._described if position is None else self._vector("position", position)
        rate = np.zeros_like(pose) if velocity is None else self._vector("velocity", velocity)
        pulls = self._host.initialize(*self._coupling.at(pose, rate), static)
        self._pose = pose
        return self._coupling.forces(self._host, pulls, pose)

    def step(self, time: float, position, velocity) -> np.ndarray:
        """Advance to `time` (s), where the coupled points are at `position` with `velocity`; return the forces.

        Parameters
        ----------
        position, velocity : (m, 3) array or vector
            m and m/s, of objects also rad and rad/s (rates of the angles); on the way each coupled point, and each
            point of a coupled object, follows the cubic between the two ends. So does the length that a winch has paid
            out; a winch without a table, and without `set_payout` before the step, stands still at its end.
        """
        self._follow_tables(time)
        if not self._flat:
            return self._host.step(time, position, velocity)
        pose, rate = self._vector("position", position), self._vector("velocity", velocity)
        pulls = self._host.step(time, *self._coupling.at(pose, rate))
        self._pose = pose
        return self._coupling.forces(self._host, pulls, pose)

    def set_payout(self, channel: int, length: float, rate: float = 0.0) -> None:
        """Say what the winches of a control channel have paid out at the end of the next step.

        Parameters
        ----------
        channel : int
        length : float
            Since the start, m; negative: hauled in.
        rate : float
            Of that length, m/s.
        """
        channels = [control.channel for control in self.model.controls]
        if channel not in channels:
            listed = f"its channels are {', '.join(map(str, channels))}" if channels else "it has none"
            raise SimulationError(f"set_payout(): the model has no control channel {channel}: {listed}", self.time)
        if channel in self._paid:
            raise SimulationError(f"set_payout(): channel {channel} follows the table of the model", self.time)
        if not np.isfinite([length, rate]).all():
            what = f"set_payout(): length {length} m and rate {rate} m/s of channel {channel} must be finite numbers"
            raise SimulationError(what, self.time)
        self._host.paid_next[channels.index(channel)] = length, rate

    def _follow_tables(self, time: float) -> None:
        for k, control in enumerate(self.model.controls):
            if control.channel in self._paid and np.isfinite(time):
                self._host.paid_next[k] = self._paid[control.channel].at(float(time))

    @property
    def line_lengths(self) -> np.ndarray:
        """Unstretched lengths of the lines now, (lines,), m, in the order of the file."""
        return self._host.line_lengths()

    def _vector(self, name: str, values) -> np.ndarray:
        vector = np.array(values, dtype=float)
        if vector.shape != self._pose.shape or not np.isfinite(vector).all():
            wanted = ", ".join(f"{width} of {kind} {id}" for kind, id, width in self.degrees_of_freedom)
            raise SimulationError(
                f"{name}: expected {len(self._pose)} finite numbers ({wanted}), got an array of shape {vector.shape}"
                + ("" if np.isfinite(vector).all() else " with NaN or inf in it"),
                self.time,
            )
        return vector

    def water_nodes(self) -> np.ndarray:
        """Return where the water acts, (n, 3), m: nodes of lines, then of rods, points, ends of rods.

        The nodes of a line go from end A to end B and include both. Rods and bodies that forces move have two more rows
        each at the end; the water of the second has no effect.
        """
        return self._host.water_nodes()

    def set_water(self, elevation, velocity, acceleration=None, time: float | None = None) -> None:
        """Say what the waves do at the nodes; the current of the model is added.

        Parameters
        ----------
        elevation : (n,) array or None
            Of the surface above each node, m; None: still.
        velocity : (n, 3) array
            m/s.
        acceleration : (n, 3) array or None
            m/s2, local; None: zero.
        time : float, optional
            At which they are so, s: the water goes there linearly from what it is now, and then stays. By default it is
            so at once, and stays so until it is set again.
        """
        if not self._hosts_water:
            remedy = "make it with host_waves=True, or let the model say host_waves: true"
            raise UnsupportedError(Problem("this simulation takes no water from its host", remedy))
        self._host.set_water(elevation, velocity, acceleration, time)

    def save(self) -> Block:
        """Return the whole state as arrays."""
        return self._host.save() | {"host_pose": self._pose.copy()}

    def restore(self, saved: Block) -> None:
        """Go back to a saved state, bit for bit."""
        self._host.restore(saved)
        self._pose = saved["host_pose"].copy()
