"""A mooring behind MoorDyn's handles: a model, its march, its log, and what a host has changed since it was read."""

from __future__ import annotations

import dataclasses
import warnings
from pathlib import Path

import numpy as np

from moorage.accept import accept
from moorage.errors import ModelWarning, MoorageError, SimulationError
from moorage.io import read
from moorage.layout import WITHOUT_ROWS, State, copy_of
from moorage.model import Attachment, Failure
from moorage.model.checks import check
from moorage.model.turbines import placed
from moorage.moordyn.changes import broken, option, with_line, without_host_parts, without_stiffness
from moorage.moordyn.codes import LEVEL_ERR, LEVEL_MSG, LEVEL_WRN
from moorage.moordyn.log import Log
from moorage.moordyn.text import Text
from moorage.solve.blocks import Block
from moorage.solve.control import Settings, control_of
from moorage.solve.coupling import Coupling, described
from moorage.solve.host import HostMarch
from moorage.solve.parts import node_force_part, node_masses
from moorage.solve.reactions import point_load
from moorage.solve.record import Record, new_record
from moorage.system.build import Built, build

SETTINGS = Settings(dt_nodes=1.0)  # so that records have node histories


class System:
    """A mooring system as MoorDyn's API knows it.

    Parameters
    ----------
    path : path
        MoorDyn's input file, or a native one.

    Attributes
    ----------
    time : float
        Of the mooring's own clock, s: 0 at `initialize`, then the sum of the steps.
    pose, rate : (dof,) array
        Coupled degrees of freedom at the end of the last step, m and rad, and their rates.
    mean : (dof,) array
        Rates over the last step.
    """

    def __init__(self, path: str | Path):
        self.path, self.log = Path(path), Log()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", ModelWarning)
            model = read(path)
            check(model)
            self.failures = list(model.failures)
            # options of MoorDyn are no surprise here
            accept(dataclasses.replace(without_host_parts(model), unused_options=()))
        self.model = placed(without_host_parts(model))
        for warning in caught:
            self.log.say(LEVEL_WRN, str(warning.message))
        if model.controls:
            channels = ", ".join(str(control.channel) for control in model.controls)
            what = f"control channels are not used here ({channels}): hosts set lengths with SetLineUnstretchedLength"
            self.log.say(LEVEL_WRN, f"{model.controls[0].source or path}: {what}")
        self.step_max: float | None = None
        self.scheme = option(self.model, "tScheme", "implicit")
        self.pay_out: dict[int, float] = {}  # line: rate of its unstretched length, m/s
        self.stiffness: dict[int, float] = {}  # line: axial stiffness that the host has given it, N
        self.closed = False
        self.text: Text | None = None
        self._build(build(self.model))
        self.pose, self.rate = described(self.model), np.zeros(self.coupling.size)
        self.means = np.stack([self.rate, self.rate])  # rates over the last step and the one before

    def _build(self, built: Built) -> None:
        self.host = HostMarch(built, SETTINGS)
        self.coupling = Coupling(self.model, built, self.host.driven)
        self._record: Record | None = None
        self._forget()

    def _forget(self) -> None:
        self._block: Block | None = None
        self._parts: dict[str, np.ndarray] = {}
        self._masses: np.ndarray | None = None

    @property
    def built(self) -> Built:
        """The system with its state."""
        return self.host.march.built if self.started else self.host.built

    @property
    def started(self) -> bool:
        """Whether `initialize` has been called."""
        return self.host._march is not None

    @property
    def time(self) -> float:
        """Time of the state, s."""
        return self.host.time

    @property
    def block(self) -> Block:
        """The records of the present time, with all nodes watched; before `initialize` those of the first guess."""
        if self._block is None:
            if not self.started:
                self.host.take_over(0.0, copy_of(self.host.built.state), *self.coupling.at(self.pose, self.rate))
                self._block = self._fill()
                self.host._march = None
            else:
                self._block = self._fill()
        return self._block

    def _fill(self) -> Block:
        if self._record is None:
            ptr = self.built.names.node_ptr
            nodes = [(k, i) for k in range(len(ptr) - 1) for i in range(ptr[k + 1] - ptr[k])]
            watched = np.array(nodes, dtype=np.int64).reshape(-1, 2)
            self._record = new_record(self.built.system, np.zeros(1), np.zeros(1), watched)
        return {name: values[0].copy() for name, values in self.host.fill(self._record).items()}

    def part(self, name: str) -> np.ndarray:
        """Return a part of the force on each node, see `moorage.solve.parts`, (nodes, 3), N."""
        if name not in self._parts:
            self._parts[name] = node_force_part(self.built, name)
        return self._parts[name]

    @property
    def masses(self) -> np.ndarray:
        """Mass matrices of the nodes, (nodes, 3, 3), kg."""
        if self._masses is None:
            self._masses = node_masses(self.built)
        return self._masses

    def initialize(self, pose: np.ndarray, rate: np.ndarray, static: bool) -> None:
        """Start at time 0 with the coupled objects at `pose`, moving at `rate`; statically, or as described."""
        position, velocity = self.coupling.at(pose, rate)
        self.host.initialize(position, velocity, static)
        self._keep_limit()
        self.pose, self.rate, self.means = pose, rate, np.stack([rate, rate])
        self._forget()
        if option(self.model, "disableOutput", "0").lower() not in ("1", "true"):
            self.text = Text(self.path, self.model, self.built)
            self.text.write(self.host, 0.0)
        self.log.say(LEVEL_MSG, f"{self.path}: initialized")

    def stop(self) -> None:
        """Go back to before `initialize`."""
        self.host._march = None
        self._forget()

    def step(self, pose: np.ndarray, rate: np.ndarray, dt: float) -> np.ndarray:
        """Go on by dt (s); the coupled objects go from where they are to pose + dt rate.

        Points go in straight lines, so that their velocity jumps from step to step as MoorDyn's does. Where bodies or
        rods are coupled, all velocities are continuous, for their mass feels each jump: that at the end of the step is
        extrapolated from the means of this step and the last two: exact where they are those of a parabola over time.

        Returns
        -------
        (dof,) array
            Forces and moments of the mooring on them, N and N m.
        """
        target = pose + dt * rate
        mean = (target - self.pose) / dt
        host, before = self.host, (self.host.velocity, [line.length for line in self.model.lines])
        self._pay_out({line: speed * dt for line, speed in self.pay_out.items()})
        if self.coupling.carries:
            rate = (11.0 * mean - 7.0 * self.means[0] + 2.0 * self.means[1]) / 6.0
        else:
            rate = mean
            host.velocity = self.coupling.at(self.pose, mean)[1]
        try:
            force = host.step(host.time + dt, *self.coupling.at(target, rate))
        except SimulationError:
            host.velocity = before[0]
            self._pay_out({line: before[1][line] - self.model.lines[line].length for line in self.pay_out})
            raise
        self.pose, self.rate, self.means = target, rate, np.stack([mean, self.means[0]])
        self._forget()
        broke = self._break_lines()
        if self.text is not None:
            self.text.write(self.host, dt)
        return self.coupled_forces() if broke else self.coupling.forces(host, force, target)

    def _pay_out(self, lengths: dict[int, float]) -> None:
        """Make lines longer, m."""
        for line, length in lengths.items():
            self.change_line(line, length=self.model.lines[line].length + length)

    def coupled_forces(self) -> np.ndarray:
        """Return the forces on the coupled degrees of freedom now, (dof,), N and N m."""
        return self.coupling.forces(self.host, self.host._forces(self.time), self.pose)

    def body_motion(self, place: int) -> tuple[np.ndarray, np.ndarray]:
        """Return position with angles (m, rad) of a body by its place, and velocity with spin, (6,) each."""
        block = self.block
        return np.concatenate([block["body_position"][place], block["body_rotation"][place]]), block["body_velocity"][
            place
        ]

    def rod_motion(self, place: int) -> tuple[np.ndarray, np.ndarray]:
        """Return where the ends of a rod are and how they move, (2, 3) each, m and m/s."""
        a, b = (self.point_motion(int(holder)) for holder in self.built.rods.ends[place])
        return np.array([a[0], b[0]]), np.array([a[1], b[1]])

    def close(self) -> None:
        """Close the files; the system cannot be used any more."""
        self.closed = True
        if self.text is not None:
            self.text.close()

    def own_load(self, point: int) -> np.ndarray:
        """Return weight, buoyancy, drag and constant force of a point by itself, (3,), N."""
        motion = np.concatenate([*self.point_motion(point), np.zeros(3)])[None]
        return point_load(self.built, point, motion, np.array([self.time]))[0]

    def point_motion(self, holder: int) -> tuple[np.ndarray, np.ndarray]:
        """Return position and velocity of a point or rod end, (3,) each."""
        driven = np.flatnonzero(self.host.driven == holder)
        if len(driven):
            position, velocity = self.coupling.at(self.pose, self.rate)
            return position[driven[0]], velocity[driven[0]]
        row = int(self.built.system.lines.node_ptr[-1]) + holder
        if holder in self.built.system.islands.points:
            return self.built.state.position[row].copy(), self.built.state.velocity[row].copy()
        return self.built.system.tracks.rest[holder].copy(), np.zeros(3)

    def change_line(self, line: int, *, length: float | None = None, stiffness: float | None = None) -> None:
        """Give a line (by its place) another unstretched length, m, or axial stiffness, N, from now on."""
        self.model = with_line(self.model, line, length, stiffness)
        if stiffness is not None:
            self.stiffness[line] = stiffness
        self._rebuild()

    def _give_back_stiffness(self, line: int) -> None:
        """Let a line have the axial stiffness that it is described with."""
        self.model = without_stiffness(self.model, line)
        del self.stiffness[line]
        self._rebuild()

    def _rebuild(self) -> None:
        """Go on with lines as the model has them now."""
        fresh = build(self.model)
        march, host = self.host.march if self.started else None, self.host
        for owner in (host, march):
            if owner is not None:
                old = owner.built.system
                system = fresh.system._replace(tracks=old.tracks, sea=old.sea)
                owner.built = owner.built._replace(system=system, names=fresh.names)
        if march is not None:
            march.control = control_of(march.settings, march.built)._replace(step_max=march.control.step_max)
        else:
            host.built.state.position[...] = fresh.state.position
        self._forget()

    def limit_step(self, dt: float) -> None:
        """Take no internal step longer than dt, s."""
        self.step_max = dt
        if self.started:
            march = self.host.march
            march.control = march.control._replace(step_max=dt)
            march.clocks.step[:] = np.minimum(march.clocks.step, dt)

    def _keep_limit(self) -> None:
        """Limit the steps of a new or restored march as the host has asked."""
        if self.step_max is not None:
            self.limit_step(self.step_max)

    def break_off(self, attachment: Attachment, lines: tuple[int, ...]) -> None:
        """Take lines (by their places) off a point; they hold on to a new free point that is like it."""
        old, before = self.model, self.built
        end = 0 if old.lines[lines[0]].end_a == attachment else 1
        place = before.state.position[before.names.node_ptr[lines[0] + end] - end]
        self.model = broken(old, attachment, lines, place)
        points = len(old.points)
        new = build(self.model)
        nodes = int(before.system.lines.node_ptr[-1])
        rows = np.insert(np.arange(len(before.state.position)), nodes + points, 0)
        rows[nodes + points] = before.names.node_ptr[lines[0] + end] - end
        state = State(*(v if name in WITHOUT_ROWS else v[rows] for name, v in before.state._asdict().items()))
        time, given = self.time, before.system.sea.given
        self._build(new)
        if given.shape[1] > 1:
            self.host.take_water(np.concatenate([given[:, rows], given[:, -1:]], axis=1))
        self.host.take_over(time, state, *self.coupling.at(self.pose, self.rate))
        self._keep_limit()
        self._reopen()
        self.log.say(LEVEL_MSG, f"{', '.join(f'line {old.lines[k].id}' for k in lines)} came off {attachment}")

    def _break_lines(self) -> bool:
        """Let lines come off whose failure has come: at a time, or at a tension of the line at that end."""
        before = len(self.failures)
        for failure in list(self.failures):
            lines = enumerate(self.model.lines)  # those that it finds there still
            places = tuple(k for k, x in lines if x.id in failure.lines and failure.attachment in (x.end_a, x.end_b))
            if places and self._fails(failure, places):
                self.failures.remove(failure)
                self.break_off(failure.attachment, places)
        return len(self.failures) < before

    def _fails(self, failure: Failure, places: tuple[int, ...]) -> bool:
        if 0.0 < failure.time <= self.time:
            return True
        if failure.tension <= 0.0:
            return False
        ends = [(k, 0 if self.model.lines[k].end_a == failure.attachment else 1) for k in places]
        load = self.host._record.lines[0, :, 0:6].reshape(-1, 2, 3)
        return any(np.linalg.norm(load[k, end]) > failure.tension for k, end in ends)

    def _take_water(self) -> None:
        """Let the host give the water; what needs it not, a step goes without."""
        self.host.take_water()
        self._reopen()

    def _reopen(self) -> None:
        """Go on in the files with another system."""
        if self.text is not None:
            self.text.close()
            self.text = Text(self.path, self.model, self.built, self.text.rows)

    def set_water(self, rows: np.ndarray, values: np.ndarray) -> None:
        """Set velocity and acceleration (n, 6) of the water at some rows of the state from now on, m/s and m/s2."""
        if self.built.system.sea.given.shape[1] == 1:
            self._take_water()
        water = self.built.system.sea.given[1, :-1].copy()
        water[rows, 1:] = values
        self.host.set_water(water[:, 0], water[:, 1:4], water[:, 4:])
        self._forget()

    def save(self) -> Block:
        """Return everything that `restore` needs, what the host has set included."""
        lines = range(len(self.model.lines))
        return self.host.save() | {
            "pose": self.pose,
            "rate": self.rate,
            "means": self.means,
            "length": np.array([line.length for line in self.model.lines]),
            "pay_out": np.array([self.pay_out.get(k, 0.0) for k in lines]),
            "stiffness": np.array([self.stiffness.get(k, np.nan) for k in lines]),
            "step_max": np.array([np.nan if self.step_max is None else self.step_max]),
        }

    def restore(self, saved: Block) -> None:
        """Go back to a saved state of the same system, bit for bit; a limit of the steps that is set here stays."""
        if not self.started:
            self.initialize(self.pose, self.rate, static=False)
        now = self.save()
        free = {"given"}  # water of the host: there may be none, now or then
        wrong = [n for n in now if n not in saved or (n not in free and saved[n].shape != now[n].shape)]
        if wrong:
            raise MoorageError(f"the saved state is of another system: {', '.join(wrong)} differ in shape")
        self._restore_lines(saved)
        given, present = saved["given"], self.built.system.sea.given
        if given.shape != present.shape:
            if present.shape[1] == 1:
                self._take_water()
            else:
                saved = saved | {"given": np.zeros_like(present)}  # still
        self.host.restore(saved)
        self.pose, self.rate, self.means = (saved[name].copy() for name in ("pose", "rate", "means"))
        if self.step_max is None and np.isfinite(saved["step_max"][0]):
            self.step_max = float(saved["step_max"][0])
        self._keep_limit()
        self._forget()

    def _restore_lines(self, saved: Block) -> None:
        """Give the lines the lengths, rates and stiffness that the host had given them."""
        for k, (length, stiffness) in enumerate(
            zip(saved["length"].tolist(), saved["stiffness"].tolist(), strict=True)
        ):
            if np.isnan(stiffness) and k in self.stiffness:
                self._give_back_stiffness(k)
            elif not np.isnan(stiffness) and stiffness != self.stiffness.get(k):
                self.change_line(k, stiffness=stiffness)
            if length != self.model.lines[k].length:
                self.change_line(k, length=length)
        self.pay_out = {k: rate for k, rate in enumerate(saved["pay_out"].tolist()) if rate}

    def set_state(self, state: State) -> None:
        """Go on from a state whose nodes and free points have been changed, at the present time."""
        self.host.take_over(self.time, state, *self.coupling.at(self.pose, self.rate))
        self._keep_limit()
        self._forget()

    def say_error(self, error: Exception) -> None:
        """Log an error."""
        self.log.say(LEVEL_ERR, str(error))
