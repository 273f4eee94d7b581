"""Bending moments and curvatures, and what bending does to the objects at the ends of a line, for the record."""

from __future__ import annotations

import math

import numpy as np

from moorage._jit import inlined, part
from moorage._vec3 import add, cross, dot, get, mat_get, mat_times, scale, sub, unit
from moorage.layout import ATTITUDE, CLAMP, TOWARD, line_nodes
from moorage.physics.bending import PINNED, bend, end_hinge, node_hinge
from moorage.physics.motion import follow
from moorage.system.assemble import joint_hinge, joint_nodes
from moorage.system.ride import vector

ZERO3 = (0.0, 0.0, 0.0)


@inlined
def clamp_direction(system, old, now, s, line, end, t):
    """Direction in which the object at a clamped end points into the line at time t, the fraction s of a step."""
    o = system.riders.lines[line, CLAMP + end]
    if o < 0:
        return unit(follow(system.tracks, system.bending.direction[line, end], t)[0])
    d = vector(system.riders.places, line, TOWARD + end)
    before, after = mat_times(mat_get(old.frames[ATTITUDE], o), d), mat_times(mat_get(now.frames[ATTITUDE], o), d)
    return unit(add(scale(1.0 - s, before), scale(s, after)))


@inlined
def end_bending(system, state, line, end, t):
    """Force (N) and moment (N m) of a line's bending on the object at its end."""
    position = state.position
    first, last = line_nodes(system.lines, line)
    node, beside, far = (first, first + 1, first + 2) if end == 0 else (last, last - 1, last - 2)
    force, moment = ZERO3, ZERO3
    e = sub(get(position, beside), get(position, node))
    if last - first > 1:  # the hinge at the node beside pushes on the end node
        bent = bend(e, sub(get(position, far), get(position, beside)))
        G = node_hinge(system.bending, np.uintp(beside), bent[4])[0]
        force = scale(-G * bent[0], bent[5])
    if system.bending.rule[line, end] != PINNED:
        d = clamp_direction(system, state, state, 1.0, line, end, t)
        u = 1.0 / math.sqrt(dot(e, e))
        q = scale(u, e)
        c = dot(q, d)
        G = end_hinge(system.bending, np.uintp(node), system.bending.rule[line, end], c)[0]
        force = add(force, scale(-G * u, sub(d, scale(c, q))))
        moment = scale(G, cross(d, q))
    return force, moment


@inlined
def node_bending(system, old, now, s, position, line, i, t):
    """Curvature (1/m) and bending moment (N m) at a node; zero at pinned ends."""
    first, last = line_nodes(system.lines, line)
    p, length = system.bending, system.tension.length
    if first < i < last:
        r = get(position, i)
        c = bend(sub(r, get(position, i - 1)), sub(get(position, i + 1), r))[4]
        G = node_hinge(p, np.uintp(i), c)[0]
        mean = 0.5 * (length[i - 1 - line] + length[i - line])
        return half_sine(c) / mean, G * math.sqrt(max(1.0 - c * c, 0.0))
    end = 0 if i == first else 1
    if p.rule[line, end] == PINNED:
        return 0.0, 0.0
    beside, j = (first + 1, first - line) if end == 0 else (last - 1, last - 1 - line)
    c = dot(unit(sub(get(position, beside), get(position, i))), clamp_direction(system, old, now, s, line, end, t))
    moment = end_hinge(p, np.uintp(i), p.rule[line, end], c)[0] * math.sqrt(max(1.0 - c * c, 0.0))
    return 2.0 * moment / (p.before[i] * length[j]), moment


@inlined
def half_sine(c):
    """Return 2 sin(a / 2) from c = cos a: the curvature times the length."""
    return math.sqrt(max(2.0 * (1.0 - c), 0.0))


@part
def record_joints(system, island, record, row):
    """Write curvature and moment at the line ends that a joint of an island holds."""
    joints, position = system.joints, record.node_position[row]
    for m in range(system.islands.joint_ptr[island], system.islands.joint_ptr[island + 1]):
        node1, beside1, _ = joint_nodes(system.lines, joints, m, 0)
        node2, beside2, _ = joint_nodes(system.lines, joints, m, 1)
        r = get(position, node1)
        c = bend(sub(r, get(position, beside1)), sub(get(position, beside2), r))[4]
        moment = joint_hinge(system.bending, joints, m, c)[0] * math.sqrt(max(1.0 - c * c, 0.0))
        for side in range(2):
            line = joints.line[m, side]
            node = node1 if side == 0 else node2
            first = system.lines.node_ptr[line]
            j = first - line if joints.end[m, side] == 0 else node - 1 - line
            record.moment[row, node] = moment
            record.curvature[row, node] = 2.0 * moment / (joints.stiffness[m, side] * system.tension.length[j])
