"""The water at the nodes of an island: waves by the table, on top of the current."""

from __future__ import annotations

import math

from moorage._jit import inlined, kernel, part
from moorage._vec3 import get
from moorage.layout import line_nodes, point_row
from moorage.physics.current import current_at
from moorage.physics.sea import ETA, A, U, count, given_water, grown, is_given, record_at
from moorage.physics.sea_table import FIELDS, look_up, set_row, step_path


@part
def set_water(lines, islands, sea, current, table, state, island, t):
    """Set elevation, velocity and acceleration of the water at all rows of an island at time t, if it moves."""
    if count(sea) == 0 and not is_given(sea) and not current.flows:
        return
    share = grown(sea, t)[0]
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            water_at_row(sea, current, table, state.position, state.water, island, i, t, share)
    for m in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        row = point_row(lines, islands.points[m])
        water_at_row(sea, current, table, state.position, state.water, island, row, t, share)
    for m in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        row = islands.objects[m, 1]
        water_at_row(sea, current, table, state.position, state.water, island, row, t, share)


@inlined
def water_at_row(sea, current, table, position, water, island, i, t, share):
    """Set the water of one row; share: of the sea that has grown."""
    r, out = get(position, i), water[i]
    if is_given(sea):
        given_water(sea, i, t, out)
    elif count(sea) == 0:
        for c in range(FIELDS):
            out[c] = 0.0
    elif sea.interval > 0.0:
        s = t / sea.interval - table.number[island]
        a, b = get(table.start, i), get(table.end, i)
        dx, dy, dz = r[0] - a[0] - s * (b[0] - a[0]), r[1] - a[1] - s * (b[1] - a[1]), r[2] - a[2] - s * (b[2] - a[2])
        for c in range(FIELDS):
            out[c] = share * look_up(table.terms[i], s, dx, dy, dz, c)
    else:
        sum_of_waves(sea, r, t, table.scratch[island], table.after[i], out)
    add_current(current, r, t, out)


@inlined
def sum_of_waves(sea, r, t, scratch, record, out):
    """Set elevation, velocity and acceleration of the waves at a place by the sum over the components."""
    share = grown(sea, t)[0]
    record_at(sea, r, t, share, scratch, record)
    out[0] = share * record[ETA]
    for c in range(3):
        out[1 + c], out[4 + c] = share * record[U + c], share * record[A + c]


@inlined
def add_current(current, r, t, out):
    """Add the current at a place and time to the velocity of the water."""
    flow = current_at(current, r, t)
    out[1] += flow[0]
    out[2] += flow[1]
    out[3] += flow[2]


@kernel
def sample_water(system, time, position, scratch, record, out):
    """Fill (n, 7) with elevation, velocity and acceleration of the water at times (n,) and places (n, 3).

    scratch, see `physics.sea.scratch_for`, and record: (RECORD,) are overwritten.
    """
    for row in range(len(time)):
        for c in range(FIELDS):
            out[row, c] = 0.0
        if count(system.sea) > 0:
            sum_of_waves(system.sea, get(position, row), time[row], scratch, record, out[row])
        add_current(system.current, get(position, row), time[row], out[row])


@part
def start_table(lines, islands, sea, table, position, velocity, island, t):
    """Fill the table of an island for the interval that begins at or before time t."""
    if count(sea) > 0 and sea.interval > 0.0:
        table.number[island] = math.floor(t / sea.interval + 1e-9) - 2
        for _ in range(2):  # first for the sums where the interval begins
            next_interval(lines, islands, sea, table, position, velocity, island, t)


@inlined
def table_end(sea, table, island):
    """Time at which the interval of an island ends, s; infinity without a table."""
    if count(sea) == 0 or sea.interval == 0.0:
        return math.inf
    return (table.number[island] + 1) * sea.interval


@part
def next_interval(lines, islands, sea, table, position, velocity, island, t):
    """Go on to the next interval of the table, from the motion (rows, 3) at time t."""
    table.number[island] += 1
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            next_row(sea, table, position, velocity, island, i, t)
    for m in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        next_row(sea, table, position, velocity, island, point_row(lines, islands.points[m]), t)
    for m in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        next_row(sea, table, position, velocity, island, islands.objects[m, 1], t)


@inlined
def next_row(p, table, position, velocity, island, i, t):
    """Sum the components where the row will be at the end of the interval, and fit the interval between."""
    begin = table.number[island] * p.interval
    end = begin + p.interval
    for c in range(len(table.after[i])):
        table.before[i, c] = table.after[i, c]
    step_path(table.start, table.end, i, position, velocity, end - t)
    grown0, grown1 = grown(p, begin), grown(p, end)
    record_at(p, get(table.end, i), end, grown1[0], table.scratch[island], table.after[i])
    set_row(
        p, table.terms[i], table.before[i], table.after[i], get(table.start, i), get(table.end, i), grown0, grown1,
        p.interval,
    )  # fmt: skip
