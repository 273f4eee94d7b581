"""A run in time: blocks of results out, checkpoints to go on from, other systems that take over on the way."""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from operator import is_

import numpy as np

from moorage._held import Held
from moorage.errors import SimulationError
from moorage.layout import WITHOUT_ROWS, new_state
from moorage.solve.blocks import Block, block_of
from moorage.solve.control import Settings, control_of, default_tolerance
from moorage.solve.given_water import WaterFeed, takes_water
from moorage.solve.march_kernel import BROKEN, OK, UNSTABLE, Clocks, Marching, march_islands, start_islands
from moorage.solve.places import place_name
from moorage.solve.record import Record, new_record
from moorage.solve.reeling import paid_by, result_rows, surge_at, watched_now
from moorage.system.build import Built, Releases
from moorage.system.recut import Made, carry_over, leaving, slide_into_balance
from moorage.system.sea import with_interval
from moorage.system.winches import Reeled, come_off, next_cut, paid_until

PROCESSORS = os.cpu_count() or 1
SETTLE = 5  # Newton steps that put a new node in its place
THREAD_NODES = 5000  # fewer nodes than this are not worth a second thread (docs/developer/measurements.md)


class Break(Exception):
    """A line end bears more than it can: which failure, and when (s)."""

    def __init__(self, failure: int, time: float):
        super().__init__(failure, time)
        self.failure, self.time = failure, time


class March:
    """A run of a built system from its present state, at time 0.

    Parameters
    ----------
    releases : Releases, optional
        The failures that come in the run. A system that takes over then has the same rows.
    water : WaterFeed, optional
        Gives the water, in place of the waves of the system.
    """

    def __init__(
        self,
        built: Built,
        settings: Settings,
        duration: float,
        releases: Releases | None = None,
        water: WaterFeed | None = None,
    ):
        _must_have_nodes(built, settings.watch)
        self.settings, self.duration, self._water = settings, float(duration), water
        self._releases = releases
        self._released: tuple[int, ...] = ()
        if built.reeled is not None and settings.tolerance is None:  # lines are cut anew, the tolerance stays
            self.settings = settings._replace(tolerance=default_tolerance(built))
        self._counted = np.zeros(3, dtype=np.int64)  # by the systems before
        self._rows = 0  # output times recorded so far, time 0 included
        self._node_rows = 0
        self._held: list[Held] = []
        self._begin(0.0, built)

    def _begin(self, time: float, built: Built, made: Sequence[Made] = ()) -> None:
        """Start from the state of a system at a time, in which winches have just made some nodes."""
        if self._water is not None:
            built = takes_water(built, self._water.given)
        sea = with_interval(built.system.sea, self.settings.time_step)
        self.time, self.built = time, built._replace(system=built.system._replace(sea=sea))
        self.control = control_of(self.settings, self.built)
        islands = len(self.built.system.islands.line_ptr) - 1
        self.clocks = Clocks(
            np.full(islands, time),
            np.full(islands, time),
            np.full(islands, self.control.step),
            np.zeros((islands, 3), dtype=np.int64),
            np.zeros(islands, dtype=np.int64),
            np.full(islands, -1, dtype=np.int64),
        )
        state = self.built.state
        self.old = new_state(len(state.position), len(state.attitude), len(state.heat))
        if self._water is not None:
            self._water.start(self.built, time)
        start_islands(self.built.system, self.built.state, self.built.work, time)
        for node in SETTLE * list(made):
            surge = surge_at(self.built, node.held)
            slide_into_balance(self.built.system, self.built.state, node, surge)
            start_islands(self.built.system, self.built.state, self.built.work, time)
        for target, source in zip(self.old, self.built.state, strict=True):
            target[...] = source
        self._result_rows = result_rows(self.built, self._releases.most if self._releases else None)
        self.look_ahead()

    def look_ahead(self, until: float = math.inf) -> None:
        """Find out when a winch makes or removes the next segment, up to a time (s) that is not after the run's end."""
        self.next_cut, self._as_cut = math.inf, self.built.reeled
        if self.built.reeled is not None and self._releases is not None:
            until = max(self.duration, self.time) if until == math.inf else until
            self.next_cut, self._as_cut = next_cut(
                self.built.winches, paid_by(self.built), self.built.reeled, self.time, until
            )

    def cut_lines(self) -> None:
        """Go on with the lines cut as `look_ahead` has found, at the time `next_cut`, where the march must stand."""
        self._take_over(set(), self._as_cut)

    def _take_over(self, failures: set[int], reeled: Reeled | None) -> None:
        """Go on with a system in which more line ends have come off, or lines are cut in another way."""
        assert self._releases is not None
        self._released += tuple(sorted(failures))
        if reeled is not None:
            off = set().union(*(self._releases.ends[k] for k in failures))
            reeled = paid_until(self.built.winches, paid_by(self.built), reeled, self.time)
            reeled = come_off(self.built.winches, reeled, off)
        before, after = self.built, self._releases.rebuild(self._released, reeled)
        rows, made = carry_over(before.system, before.state, after.system, after.state, before.winches)
        if self._water is not None:
            self._water.given = np.ascontiguousarray(self._water.given[:, [*rows, -1]])
        elif before.system.sea.given.shape[1] > 1:
            after = takes_water(after, np.ascontiguousarray(before.system.sea.given[:, [*rows, -1]]))
        ptr = after.system.lines.node_ptr
        for line, end in np.argwhere(after.system.lines.end_point != before.system.lines.end_point):
            row = ptr[line] if end == 0 else ptr[line + 1] - 1
            for name, values in zip(after.state._fields, after.state, strict=True):
                if name not in WITHOUT_ROWS:
                    values[ptr[-1] + after.system.lines.end_point[line, end]] = values[row]
            point = ptr[-1] + after.system.lines.end_point[line, end]
            after.state.velocity[point] += leaving(before.system, before.state, line, end)
        self._counted += self.clocks.counts.sum(axis=0)
        self._begin(self.time, after, made)

    def _due(self, until: float) -> tuple[float, set[int]]:
        """Return the next time before `until` at which failures come or a winch cuts a line, and which do."""
        times = self._releases.times if self._releases else {}
        later = {k: time for k, time in times.items() if k not in self._released and time < until}
        time = min([until, self.next_cut, *later.values()])
        if time >= until:
            return until, set()
        time = max(time, self.time)
        return time, {k for k, at in later.items() if at <= time}

    @property
    def _fed(self) -> float:
        """Time up to which the water is given, s."""
        return math.inf if self._water is None else self._water.end

    @property
    def counters(self) -> dict[str, int]:
        """Steps, rejected steps and Newton iterations of all islands so far."""
        steps, rejected, iterations = self._counted + self.clocks.counts.sum(axis=0)
        return {"steps": int(steps), "rejected": int(rejected), "iterations": int(iterations)}

    def first(self) -> Block:
        """Return the records at time 0."""
        return self.advance(0.0)

    def advance(self, until: float) -> Block:
        """Advance to `until` (s) and return the records of output times since the last call, up to there.

        Raises
        ------
        SimulationError
            An island could not go on; `.block` holds the records up to the failure.
        """
        until, parts = min(float(until), self.duration), []
        while True:
            time, failures = self._due(until)
            saved = self.checkpoint() if len(self.built.system.breaks.limit) else {}
            try:
                parts.append(self._advance(min(time, self._fed)))
            except Break as event:
                # islands have gone different ways: all go again, to where the line end came off
                self.restore(saved)
                self.control = self.control._replace(breaks=0)
                parts.append(self._advance(event.time))
                self._take_over({event.failure}, self.built.reeled)
                continue
            if self._water is not None and self._fed < time:
                self._water.go_on(self.built)
            elif failures or self.next_cut <= time < until:
                self._take_over(failures, self._as_cut if self.next_cut <= time else self.built.reeled)
            else:
                break
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]} if parts[1:] else parts[0]

    def _advance(self, until: float) -> Block:
        times, node_times = self._times_up_to(until)
        watched = watched_now(self.settings.watch, self.built)
        record = new_record(self.built.system, times, node_times, watched)
        self.run(until, min(self._due(self.duration)[0], self._fed), record)
        self.time = until
        self._rows += len(times)
        self._node_rows += len(node_times)
        return self.block(record, len(times), len(node_times))

    @property
    def changing(self) -> list[np.ndarray]:
        """The arrays that a step changes, where no failure comes and no line is cut anew."""
        built = self.built
        given, table = built.system.sea.given, built.work.table
        return [*built.state, *self.old, *self.clocks, *table, given, self.control.leftover]

    def checkpoint(self) -> Block:
        """Return everything that `restore` needs to go on, bit for bit, as arrays."""
        saved: Block = {f"now_{k}": v.copy() for k, v in zip(self.old._fields, self.built.state, strict=True)}
        saved |= {f"old_{k}": v.copy() for k, v in zip(self.old._fields, self.old, strict=True)}
        saved |= {f"clock_{k}": v.copy() for k, v in zip(self.clocks._fields, self.clocks, strict=True)}
        table = self.built.work.table
        saved |= {f"table_{k}": v.copy() for k, v in zip(table._fields, table, strict=True)}
        saved["given"] = self.built.system.sea.given.copy()
        saved["leftover"] = self.control.leftover.copy()  # made from the state at time 0
        saved["counted"] = self._counted.copy()
        saved["march"] = np.array([self.time, self._rows, self._node_rows])
        saved["released"] = np.array(self._released, dtype=np.int64)
        if self.built.reeled is not None:
            saved |= {f"reeled_{name}": np.array(values) for name, values in self.built.reeled._asdict().items()}
        return saved

    def restore(self, saved: Block) -> None:
        """Go back to a checkpoint."""
        released, reeled = tuple(saved["released"].tolist()), None
        if "reeled_segments" in saved:
            reeled = Reeled(*(tuple(saved[f"reeled_{name}"].tolist()) for name in Reeled._fields))
        if (released, reeled) != (self._released, self.built.reeled):
            assert self._releases is not None
            self._released, after = released, self._releases.rebuild(released, reeled)
            if self._water is not None:
                self._water.given = saved["given"].copy()
            elif self.built.system.sea.given.shape[1] > 1:
                after = takes_water(after, saved["given"].copy())
            self._begin(float(saved["march"][0]), after)
        self._counted[...] = saved["counted"]
        for prefix, target in (
            ("now", self.built.state), ("old", self.old), ("clock", self.clocks), ("table", self.built.work.table),
        ):  # fmt: skip
            for name, array in zip(target._fields, target, strict=True):
                array[...] = saved[f"{prefix}_{name}"]
        self.built.system.sea.given[...] = saved["given"]
        self.control.leftover[...] = saved["leftover"]
        self.time, self._rows, self._node_rows = (
            float(saved["march"][0]),
            int(saved["march"][1]),
            int(saved["march"][2]),
        )
        self.look_ahead()

    def _times_up_to(self, until: float):
        def grid(interval, done):
            last = int(np.floor(until / interval + 1e-6))
            return interval * np.arange(done, last + 1)

        dt_nodes = self.settings.dt_nodes
        node_times = grid(dt_nodes, self._node_rows) if dt_nodes else np.zeros(0)
        return grid(self.settings.dt_out, self._rows), node_times

    def run(self, until: float, stop: float, record: Record) -> None:
        """Advance all islands to `until`, no step going beyond `stop` (s), and fill the record; raise if one fails."""
        built = self.built
        islands = len(self.clocks.time)

        held = self.hold(record)

        def part(bounds):
            march_islands(held, bounds[0], bounds[1], until, stop)

        workers = min(PROCESSORS, max(islands, 1), int(built.system.lines.node_ptr[-1]) // THREAD_NODES + 1)
        if workers == 1:
            part((0, islands))
        else:
            cuts = np.linspace(0, islands, 4 * workers + 1).astype(int)
            with ThreadPoolExecutor(workers) as pool:
                list(pool.map(part, pairwise(cuts)))
        if self.clocks.status.any():
            self._raise_why(record)
        if not np.isfinite(record.lines).all():
            row, line, _ = np.argwhere(~np.isfinite(record.lines))[0].tolist()
            raise self._not_a_number(row, line, record)

    def _raise_why(self, record: Record) -> None:
        """Raise for the islands that stopped."""
        clocks = self.clocks
        failed = np.flatnonzero((clocks.status != OK) & (clocks.status != BROKEN))
        if len(failed):
            raise self._failure(int(failed[np.argmin(clocks.time[failed])]), record)
        came_off = np.flatnonzero(clocks.status == BROKEN)
        first = came_off[np.argmin(clocks.time[came_off])]
        raise Break(int(self.built.system.breaks.rows[clocks.row[first], 2]), float(clocks.time[first]))

    def hold(self, record: Record) -> Held:
        """Return what the march works on as kernels take it, made anew only where something else is meant.

        A host's records are few: one of forces, one of what it asks for.
        """
        built = self.built
        parts = Marching(
            built.system, self.old, built.state, built.work, self.clocks, self.control, built.island_of_line, record
        )
        for held in self._held:
            if all(map(is_, parts, held.values)):
                return held
        self._held = [Held(parts), *self._held[:3]]
        return self._held[0]

    def block(self, record: Record, rows: int, node_rows: int) -> Block:
        """Split the buffers into named arrays of the first `rows` times."""
        return block_of(self.built, record, rows, node_rows if self.settings.dt_nodes else None, self._result_rows)

    def _failure(self, island: int, record: Record) -> SimulationError:
        time = float(self.clocks.time[island])
        rows = int(np.searchsorted(record.time, self.clocks.time.min(), side="right"))
        node_rows = int(np.searchsorted(record.node_time, self.clocks.time.min(), side="right"))
        place = place_name(self.built, int(self.clocks.row[island]))
        if self.clocks.status[island] == UNSTABLE:
            cause = (
                f"the explicit step of {self.control.step:g} s is too long for the stiffest segment.\n    -> Use a "
                "smaller --time-step, or the implicit method, which needs none"
            )
        else:
            cause = (
                f"no step down to {self.control.step_min:g} s solves the equations of motion.\n    -> Look at what "
                "happens there: a line pulled beyond reason, a segment folded back on itself, a table that falls, "
                "or imposed motion that jumps"
            )
        return self._stopped(f"at {place}: {cause}", time, record, rows, node_rows)

    def _not_a_number(self, row: int, line: int, record: Record) -> SimulationError:
        """Report a force on the end of a line that its motion did not show, because that end is held."""
        time = float(record.time[row])
        names, lines = self.built.names, len(self.built.names.lines)
        what = f"line {names.lines[line]}" if line < lines else f"rod {names.rods[line - lines]}"
        cause = f"on {what}: the force on one of its ends is not a number"
        return self._stopped(cause, time, record, row, int(np.searchsorted(record.node_time, time)))

    def _stopped(self, why: str, time: float, record: Record, rows: int, node_rows: int) -> SimulationError:
        error = SimulationError(f"the run stopped at {time:.4f} s {why}", time)
        error.block = self.block(record, rows, node_rows)  # type: ignore[attr-defined]
        return error


def _must_have_nodes(built: Built, watch: tuple[tuple[int, int], ...]) -> None:
    """Refuse to watch nodes that are not there: kernels do not look whether they are."""
    nodes = np.diff(built.system.lines.node_ptr)  # those of rods follow
    for w, count in zip(built.winches, built.reeled.segments if built.reeled else (), strict=True):
        nodes[w.line] += len(w.lengths) - count  # as described
    for line, node in watch:
        if not 0 <= line < len(nodes) or not 0 <= node < nodes[line]:
            raise ValueError(f"there is no node {node} of the line at place {line} to watch")
