"""Line ends that come off when the force on them grows too large."""

from __future__ import annotations

from moorage._jit import part
from moorage._vec3 import add, dot
from moorage.layout import line_nodes
from moorage.solve.bends import end_bending
from moorage.solve.record import node_force


@part
def broken(system, state, island_of_line, island, t):
    """Return the first break of an island whose line end bears more than it can at time t, -1: none."""
    breaks = system.breaks
    for k in range(len(breaks.rows)):
        line, end = breaks.rows[k, 0], breaks.rows[k, 1]
        if island_of_line[line] != island:
            continue
        first, last = line_nodes(system.lines, line)
        load = node_force(system, state, line, first if end == 0 else last)[0]
        if system.lines.bends[line]:
            load = add(load, end_bending(system, state, line, end, t)[0])
        if dot(load, load) > breaks.limit[k] * breaks.limit[k]:
            return k
    return -1
