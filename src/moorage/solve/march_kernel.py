"""The compiled time loop of islands: steps of their own size, control of that size, output on the way."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._held import held_values
from moorage._jit import inlined, kernel, part
from moorage._vec3 import get, put
from moorage.layout import State, System, Work, line_nodes, point_row
from moorage.solve.breaks import broken
from moorage.solve.explicit import explicit_step
from moorage.solve.implicit import implicit_step, start_island
from moorage.solve.record import Record, record_lines, record_nodes, record_objects, record_watched, sample_island
from moorage.system.reel import reel
from moorage.system.water import next_interval, start_table, table_end

OK, NO_SOLUTION, UNSTABLE, BROKEN = 0, 1, 2, 3


class Control(NamedTuple):
    """Settings of the time loop."""

    order: int  # 0: implicit, 2 or 4: explicit Runge-Kutta of that order
    adaptive: int  # 1: step from the error estimate, 0: constant step
    step: float  # constant step, or the first one, s
    step_min: float  # s: below this a run fails
    step_max: float  # s
    error: float  # accepted h^2 |a1 - a0|, m
    rho: float  # spectral radius at infinite frequency
    newton: float  # Newton stops at velocity increments below this, m/s,
    leftover: np.ndarray  # (islands,) that leave no more than this tension behind, N, as estimated from
    stretch: np.ndarray  # (islands, 2) the largest EA / (2 l^2), N/m2, and BA / l^2, N s/m2
    iterations: int  # at most so many, then the step is halved
    breaks: int  # 1: stop when a line end bears more than it can


class Clocks(NamedTuple):
    """Where each island is in time."""

    begin: np.ndarray  # (islands,) start of the last step, s
    time: np.ndarray  # (islands,) end of the last step, s
    step: np.ndarray  # (islands,) size to try next, s
    counts: np.ndarray  # (islands, 3) steps, rejected steps, node iterations
    status: np.ndarray  # (islands,) OK or why it stopped
    row: np.ndarray  # (islands,) state row where it stopped


@kernel
def start_islands(system, state, work, t):
    """Set consistent accelerations of all islands at time t."""
    for island in range(len(system.islands.line_ptr) - 1):
        start_table(system.lines, system.islands, system.sea, work.table, state.position, state.velocity, island, t)
        start_island(system, state, work, island, t)


class Marching(NamedTuple):
    """All that a march works on."""

    system: System
    old: State  # at the start of the last step
    now: State
    work: Work
    clocks: Clocks
    control: Control
    island_of_line: np.ndarray
    record: Record


@kernel
def march_islands(held, begin, end, until, stop):
    """Advance islands begin..end-1 to `until` and write the outputs up to there; no step goes beyond `stop`.

    held: `Held` of `Marching`. One function, because a kernel inside another is compiled twice.
    """
    system, old, now, work, clocks, control, island_of_line, record = held_values(held)
    for island in range(begin, end):
        if clocks.status[island] != OK:
            continue
        a, b = old, now  # the step goes from a to b; both swap with each step and are put back in place at the end
        swapped = False
        before, after = record.samples[0], record.samples[1]
        known_before, known_after = False, False
        row, node_row = np.int64(0), np.int64(0)  # not literals: for those all is compiled again
        t0, t, h = clocks.begin[island], clocks.time[island], clocks.step[island]
        eps = 1e-9 * max(1.0, abs(until))
        while True:
            while row < len(record.time) and record.time[row] <= t + eps:
                for side in range(2):  # one call in a loop, because it is inlined and long
                    if not (known_before if side == 0 else known_after):
                        if len(system.winches.place) > 0:
                            reel(system, island, t0 if side == 0 else t)
                        sample_island(
                            system,
                            a if side == 0 else b,
                            t0 if side == 0 else t,
                            island,
                            before if side == 0 else after,
                        )
                known_before, known_after = True, True
                s = fraction(record.time[row], t0, t)
                record_lines(system, a, b, island, before, after, t - t0, s, record, row)
                if system.islands.object_ptr[island + 1] > system.islands.object_ptr[island]:
                    record_objects(system, a, b, island, t - t0, s, record, row)
                if len(record.watched) > 0:
                    record_watched(system, a, b, island_of_line, island, t - t0, s, record, row)
                row += 1
            while node_row < len(record.node_time) and record.node_time[node_row] <= t + eps:
                s = fraction(record.node_time[node_row], t0, t)
                record_nodes(system, a, b, island, t - t0, s, record, node_row)
                node_row += 1
            if t >= until - eps:
                break
            size = step_to_try(control, t, h, min(stop, table_end(system.sea, work.table, island)))
            # from b to the space of a, which is not needed any more
            if control.order == 0:
                good, iterations, change, where = implicit_step(system, b, a, work, island, t, size, control)
                error = size * size * change / control.error
            else:
                good, where = explicit_step(system, b, a, work, island, t, size, control.order)
                iterations, error = control.order, 0.0
            clocks.counts[island, 2] += iterations
            if not good or not error < 2.0:
                clocks.counts[island, 1] += 1
                h = size * (max(0.25, 0.85 / math.sqrt(error)) if good else 0.5)
                known_before, known_after = False, False
                if control.order > 0 or not h > control.step_min:
                    clocks.status[island] = NO_SOLUTION if control.order == 0 else UNSTABLE
                    clocks.row[island] = where
                    break
                continue
            a, b = b, a
            swapped = not swapped
            before, after = after, before
            known_before, known_after = known_after, False
            t0, t = t, t + size
            clocks.counts[island, 0] += 1
            if t >= table_end(system.sea, work.table, island) - eps:
                next_interval(system.lines, system.islands, system.sea, work.table, b.position, b.velocity, island, t)
            h = next_step(control, size, h, error)
            if control.breaks == 1 and len(system.breaks.rows) > 0:
                where = broken(system, b, island_of_line, island, t)
                if where >= 0:
                    clocks.status[island], clocks.row[island] = BROKEN, where
                    break
        if len(system.winches.place) > 0:
            reel(system, island, t)
        if swapped:
            swap_island(system.lines, system.islands, old, now, island)
        clocks.begin[island], clocks.time[island], clocks.step[island] = t0, t, h


@inlined
def fraction(time, t0, t):
    """Where a time lies in the step from t0 to t."""
    return min(max((time - t0) / (t - t0), 0.0), 1.0) if t > t0 else 1.0


@inlined
def step_to_try(control, t, h, stop):
    """Size of the next step: lands on multiples of a constant step, and on the end of the run without a sliver."""
    if control.adaptive == 0:
        target = control.step * (math.floor(t / control.step + 1e-6) + 1.0)
        return min(min(h, target - t), stop - t) if target - t < 1.999 * h else min(h, 0.5 * (target - t))
    left = stop - t
    if left <= h:
        return left
    return 0.5 * left if left < 2.0 * h else h


@inlined
def next_step(control, size, h, error):
    """Size to try after an accepted step."""
    if control.adaptive == 0:
        return min(control.step, 2.0 * max(size, h))
    return min(control.step_max, size * min(1.6, max(0.4, 0.85 / math.sqrt(error + 1e-12))))


@part
def swap_island(lines, islands, old, now, island):
    """Exchange the rows of an island between two states."""
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        first, last = line_nodes(lines, line)
        for i in range(first, last + 1):
            swap_row(old, now, i)
        for c in range(2):
            old.heat[line, c], now.heat[line, c] = now.heat[line, c], old.heat[line, c]
    for p in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        swap_row(old, now, point_row(lines, islands.points[p]))
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o = islands.objects[k, 0]
        swap_row(old, now, islands.objects[k, 1])
        swap_row(old, now, islands.objects[k, 1] + 1)
        for c in range(9):
            for k in range(2):
                old.frames[k, o, c], now.frames[k, o, c] = now.frames[k, o, c], old.frames[k, o, c]


@inlined
def swap_row(x, y, i):
    r, v, a, b, s = get(x.position, i), get(x.velocity, i), get(x.acceleration, i), get(x.auxiliary, i), get(x.stuck, i)
    put(x.position, i, get(y.position, i))
    put(x.velocity, i, get(y.velocity, i))
    put(x.acceleration, i, get(y.acceleration, i))
    put(x.auxiliary, i, get(y.auxiliary, i))
    put(x.stuck, i, get(y.stuck, i))
    for c in range(x.water.shape[1]):
        x.water[i, c], y.water[i, c] = y.water[i, c], x.water[i, c]
    for c in range(x.soil.shape[1]):
        x.soil[i, c], y.soil[i, c] = y.soil[i, c], x.soil[i, c]
    put(y.position, i, r)
    put(y.velocity, i, v)
    put(y.acceleration, i, a)
    put(y.auxiliary, i, b)
    put(y.stuck, i, s)
