"""Where objects are, and what rides on them: points, ends of rods, nodes of rods, clamps."""

from __future__ import annotations

import math

from moorage._jit import inlined, part
from moorage._vec3 import add, dot, get, mat_get, mat_mat, mat_put, mat_times, put, scale, sub
from moorage.layout import ATTITUDE, BASE, CARRIER, CLAMP, FLEXIBLE, HELD, PIN, ROW, SPAN, TOWARD, line_nodes, point_row
from moorage.physics.motion import follow
from moorage.physics.rigid import arm_motion, rotation

ZERO3 = (0.0, 0.0, 0.0)
UPRIGHT = 0.02  # sine of the least lean of a rod in the surface: below it dries as if it leaned that much


@inlined
def vector(a, i, j):
    """Row a[i, j] of an array (n, m, 3)."""
    return a[i, j, 0], a[i, j, 1], a[i, j, 2]


@inlined
def surface_band(system, line, j, e):
    """Half height of the band in which sections of segment j, along e, become dry, m.

    It is the radius of a line, which is thin; a rod's sections reach as high as it leans.
    """
    radius = system.weight.radius[j]
    if system.riders.lines[line, CARRIER] == FLEXIBLE:
        return radius
    return radius * max(UPRIGHT, math.sqrt((e[0] * e[0] + e[1] * e[1]) / dot(e, e)))


@part
def place_pins(islands, riders, tracks, state, island, t):
    """Give the objects of an island that are pinned to the ground, or to prescribed motion, their place at time t."""
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o = islands.objects[k, 0]
        pin = riders.objects[o, PIN]
        if pin >= 0 and riders.points[pin] < 0:
            r, v, a = follow(tracks, pin, t)
            put(state.position, riders.objects[o, ROW], r)
            put(state.velocity, riders.objects[o, ROW], v)
            put(state.acceleration, riders.objects[o, ROW], a)


@part
def place_riders(lines, islands, riders, state, direction, island):
    """Set the motion of all that rides on the objects of an island, from that of the objects.

    Bodies come before the rods that are pinned to them. direction (lines, 2, 3): of the clamps.
    """
    for k in range(islands.object_ptr[island + 1] - 1, islands.object_ptr[island] - 1, -1):
        o = islands.objects[k, 0]
        row, pin = riders.objects[o, ROW], riders.objects[o, PIN]
        if pin >= 0 and riders.points[pin] >= 0:
            i = point_row(lines, pin)
            put(state.position, row, get(state.position, i))
            put(state.velocity, row, get(state.velocity, i))
            put(state.acceleration, row, get(state.acceleration, i))
        mat_put(
            state.frames[ATTITUDE], o, mat_mat(mat_get(state.frames[BASE], o), rotation(get(state.position, row + 1)))
        )
        for p in range(islands.point_ptr[island], islands.point_ptr[island] + islands.rides[island, 0]):
            point = islands.points[p]
            if riders.points[point] == o:
                ride(riders, state, o, point_row(lines, point), get(riders.arm, point))
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[k]
        o = riders.lines[line, CARRIER]
        first, last = line_nodes(lines, line)
        if o >= 0:
            for i in range(first, last + 1):
                ride(riders, state, o, i, rider_arm(riders, line, first, last, i))
        elif o == HELD:
            span_between(state.position, first, last)
            span_between(state.velocity, first, last)
            span_between(state.acceleration, first, last)
        for end in range(2):
            if riders.lines[line, CLAMP + end] >= 0:
                R = mat_get(state.frames[ATTITUDE], riders.lines[line, CLAMP + end])
                put(direction[line], end, mat_times(R, vector(riders.places, line, TOWARD + end)))


@inlined
def ride(riders, state, o, i, arm):
    """Set the motion of a row that rides on an object."""
    row = riders.objects[o, ROW]
    R = mat_get(state.frames[ATTITUDE], o)
    put(state.position, i, add(get(state.position, row), mat_times(R, arm)))
    omega, alpha = get(state.velocity, row + 1), get(state.acceleration, row + 1)
    v, a = arm_motion(R, get(state.velocity, row), get(state.acceleration, row), omega, alpha, arm)
    put(state.velocity, i, v)
    put(state.acceleration, i, a)


@inlined
def rider_arm(riders, line, first, last, i):
    """Arm of node i of a rigid line on its object, m."""
    a, b = vector(riders.places, line, SPAN + 0), vector(riders.places, line, SPAN + 1)
    return add(a, scale((i - first) / (last - first), sub(b, a)))


@inlined
def span_between(values, first, last):
    """Put the rows between two ends evenly between their values."""
    a, b = get(values, first), get(values, last)
    for i in range(first + 1, last):
        put(values, i, add(a, scale((i - first) / (last - first), sub(b, a))))


@part
def begin_turning(islands, state, island):
    """Count the rotations of the objects of an island from where they are now."""
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o = islands.objects[k, 0]
        mat_put(state.frames[BASE], o, mat_get(state.frames[ATTITUDE], o))
        put(state.position, islands.objects[k, 1] + 1, ZERO3)
