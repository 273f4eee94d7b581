"""Line ends: they copy the free point that they hold on to, or follow the prescribed motion of their point."""

from __future__ import annotations

from moorage._jit import inlined, part
from moorage._vec3 import get, put, unit
from moorage.layout import line_nodes, point_row
from moorage.physics.motion import follow
from moorage.system.ride import place_pins, place_riders


@inlined
def place_prescribed_ends(system, state, work, island, t):
    """Put the line ends on prescribed points where these are at time t, and turn the clamps."""
    lines, islands = system.lines, system.islands
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[k]
        first, last = line_nodes(lines, line)
        for end in range(2):
            if lines.end_unknown[line, end] < 0:
                row = first if end == 0 else last
                r, v, a = follow(system.tracks, lines.end_point[line, end], t)
                put(state.position, row, r)
                put(state.velocity, row, v)
                put(state.acceleration, row, a)
            if system.bending.direction[line, end] >= 0:
                d = unit(follow(system.tracks, system.bending.direction[line, end], t)[0])
                put(work.direction[line], end, d)


@part
def copy_free_ends(lines, islands, island, values):
    """Copy rows of free points into the line ends on them."""
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[k]
        first, last = line_nodes(lines, line)
        if lines.end_unknown[line, 0] >= 0:
            put(values, first, get(values, point_row(lines, lines.end_point[line, 0])))
        if lines.end_unknown[line, 1] >= 0:
            put(values, last, get(values, point_row(lines, lines.end_point[line, 1])))


@inlined
def settle(system, state, work, island):
    """Give what rides on objects, and line ends on free points and riders, the motion of these."""
    lines, islands = system.lines, system.islands
    if islands.rides[island, 1]:
        place_riders(lines, islands, system.riders, state, work.direction, island)
    if islands.point_ptr[island + 1] > islands.point_ptr[island]:
        copy_free_ends(lines, islands, island, state.position)
        copy_free_ends(lines, islands, island, state.velocity)
        copy_free_ends(lines, islands, island, state.acceleration)


@inlined
def attach(system, state, work, island, t):
    """Give all line ends of an island the motion of their points at time t, and riders that of their objects."""
    place_prescribed_ends(system, state, work, island, t)
    if system.islands.rides[island, 1]:
        place_pins(system.islands, system.riders, system.tracks, state, island, t)
    settle(system, state, work, island)
