"""What a run writes down: end forces, tensions, grounded length, points, nodes, at output times between step ends.

Tensions and forces are evaluated at step ends, where the equations hold, and interpolated linearly: computed from
interpolated positions they would be wrong, because EA is huge. Positions are interpolated by cubic Hermite polynomials.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, kernel, part
from moorage._vec3 import add, cross, dot, get, mat_get, mat_mat, mat_times, put, scale, sub
from moorage.layout import BASE, CARRIER, FLEXIBLE, Weights, line_nodes, memory_of, point_row, water_of
from moorage.physics.bathymetry import bed_at
from moorage.physics.contact import contact_terms, near_bed
from moorage.physics.friction import NONE, friction_terms
from moorage.physics.morison import inertia_terms, wet_end, wet_node, wet_part
from moorage.physics.rigid import rotation, turning_rate
from moorage.physics.tension import segment_tension, tension_terms
from moorage.physics.weight import wet_shares
from moorage.solve.bends import end_bending, node_bending, record_joints
from moorage.solve.fold import UP, waterplane
from moorage.system.assemble import node_terms, rubbing_load, span_around, unit_or_zero
from moorage.system.reel import reel, sample_winches
from moorage.system.ride import surface_band

# columns of Record.lines
FORCE_A, FORCE_B, LOAD_A, LOAD_B, TENSION_A, TENSION_B, LOWEST, GROUNDED = 0, 3, 6, 9, 12, 13, 14, 15
MOMENT_A, MOMENT_B, HEAT, COLUMNS = 16, 19, 22, 23
# of a rod: FORCE_A is the sum of the forces on its nodes and LOAD_A that without inertia, MOMENT_A and MOMENT_B are
# their moments about its end A
# columns of Record.objects: position, velocity, acceleration; rotation (9); angular velocity and acceleration, global
PLACE, SPEED, RISE, TURN, SPIN, TWIST, OBJECT_COLUMNS = 0, 3, 6, 9, 18, 21, 24
# columns of Record.contact: gap to the bed, m; normal force, N; friction, N (3)
GAP, NORMAL, RUB, CONTACT_COLUMNS = 0, 1, 2, 5
# columns of Record.watch; LIFT: buoyancy, N, upwards; BED: contact and friction, N (3)
POSITION, VELOCITY, FORCE, TENSION, LIFT, BED, WATCH_COLUMNS = 0, 3, 6, 9, 10, 11, 14


class Record(NamedTuple):
    """Output buffers of one block of times."""

    time: np.ndarray  # (n,) s
    lines: np.ndarray  # (n, lines, COLUMNS)
    points: np.ndarray  # (n, points, 9) position, velocity, acceleration of free points, and riders on objects
    objects: np.ndarray  # (n, objects, OBJECT_COLUMNS)
    watched: np.ndarray  # (watched, 2) line, node; rods are counted behind the lines
    watch: np.ndarray  # (n, watched, WATCH_COLUMNS)
    node_time: np.ndarray  # (m,) s
    node_position: np.ndarray  # (m, nodes, 3)
    node_velocity: np.ndarray  # (m, nodes, 3)
    segment_tension: np.ndarray  # (m, segments)
    curvature: np.ndarray  # (m, nodes) 1/m
    moment: np.ndarray  # (m, nodes) N m
    contact: np.ndarray  # (m, nodes, CONTACT_COLUMNS)
    samples: np.ndarray  # (2, lines, COLUMNS) scratch: at the ends of a step


def new_record(system, time, node_time, watched) -> Record:
    """Return empty buffers for output times (n,) and times of node histories (m,)."""
    nodes, lines = int(system.lines.node_ptr[-1]), len(system.lines.bends)
    n, m, points = len(time), len(node_time), len(system.points.mass)
    return Record(
        time,
        np.zeros((n, lines, COLUMNS)),
        np.zeros((n, points, 9)),
        np.zeros((n, len(system.riders.row), OBJECT_COLUMNS)),
        watched,
        np.zeros((n, len(watched), WATCH_COLUMNS)),
        node_time,
        np.zeros((m, nodes, 3)),
        np.zeros((m, nodes, 3)),
        np.zeros((m, nodes - lines)),
        np.zeros((m, nodes)),
        np.zeros((m, nodes)),
        np.zeros((m, nodes, CONTACT_COLUMNS)),
        np.zeros((2, lines, COLUMNS)),
    )


@inlined
def spans(state, i):
    """Vector from row i to the next and its rate of change."""
    e = sub(get(state.position, i + 1), get(state.position, i))
    return e, sub(get(state.velocity, i + 1), get(state.velocity, i))


@inlined
def node_force(system, state, line, i):
    """Force of all terms but inertia and bending on node i of a line, its inertia force -M a, and its buoyancy, N."""
    first, last = line_nodes(system.lines, line)
    r, v = get(state.position, i), get(state.velocity, i)
    c = Weights(0.0, 0.0, 0.0)
    height = r[2] - state.water[i, 0]
    e0, e1, pull, lift, share0, share1 = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 0.5, 0.5
    j = np.uintp(max(i - 1 - line, first - line))
    j0, j1 = j, j
    if i > first:
        e0, de = spans(state, i - 1)
        pull = scale(-1.0, tension_terms(system.tension, j0, e0, de, c)[0])
        share0 = wet_shares(surface_band(system, line, j0, e0), r[2] - e0[2] - state.water[i - 1, 0], height)[1]
        lift += share0 * system.weight.buoyancy[j0]
    if i < last:
        j1 = np.uintp(i - line)
        e1, de = spans(state, i)
        pull = add(pull, tension_terms(system.tension, j1, e1, de, c)[0])
        share1 = wet_shares(surface_band(system, line, j1, e1), height, r[2] + e1[2] - state.water[i + 1, 0])[0]
        lift += share1 * system.weight.buoyancy[j1]
    n = np.uintp(i)
    if share0 + share1 == 1.0:
        hydro = wet_node(system.morison, n)
    elif not first < i < last:
        hydro = wet_end(system.morison, n, 2.0 * (share0 + share1) - 1.0)
    else:
        hydro = wet_part(system.morison, n, j0, share0, j1, share1)
    q = unit_or_zero(span_around(system.lines, state.position, line, i))
    rest = (0.0, 0.0, 0.0)
    force = add(pull, node_terms(system, n, hydro, q, water_of(state, i), r, v, rest, state, c)[0])
    mass = system.morison.mass[n]
    inertia = inertia_terms(mass + hydro[0], mass + hydro[1], q, get(state.acceleration, i), c)[0]
    return (force[0], force[1], force[2] + lift), inertia, lift


@inlined
def sample_island(system, state, t, island, sample):
    """Evaluate the columns of all lines of an island at the state of time t."""
    islands = system.islands
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        first, last = line_nodes(system.lines, line)
        if system.riders.lines[line, CARRIER] != FLEXIBLE:
            sample_rod(system, state, line, sample)
            continue
        for end in range(2):
            load, inertia, _ = node_force(system, state, line, first if end == 0 else last)
            put_row(sample, line, LOAD_A + 3 * end, load)
            put_row(sample, line, FORCE_A + 3 * end, add(load, inertia))
        if system.lines.bends[line]:
            for end in range(2):
                force, moment = end_bending(system, state, line, end, t)
                for x in range(3):
                    sample[line, LOAD_A + 3 * end + x] += force[x]
                    sample[line, FORCE_A + 3 * end + x] += force[x]
                    sample[line, MOMENT_A + 3 * end + x] = moment[x]
        lowest, grounded, tension = 1e300, 0.0, 0.0
        below = depth_at(system, state, first)
        for i in range(first, last):
            j = np.uintp(i - line)
            e, de = spans(state, i)
            tension = segment_tension(system.tension, j, e, de)
            if i == first:
                sample[line, TENSION_A] = tension
            lowest = min(lowest, tension)
            below_next = depth_at(system, state, i + 1)
            grounded += system.tension.length[j] * grounded_part(below, below_next)
            below = below_next
        sample[line, TENSION_B], sample[line, LOWEST], sample[line, GROUNDED] = tension, lowest, grounded
        sample[line, HEAT] = state.heat[line, 0]
    if len(system.winches.place) > 0:
        sample_winches(system, state, island, sample, FORCE_A)


@part
def sample_rod(system, state, line, sample):
    """Evaluate the columns of a rod: forces on its nodes, and moments about end A, with that of its waterplane."""
    first, last = line_nodes(system.lines, line)
    total, rest, turn, turn_rest = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    start = get(state.position, first)
    for i in range(first, last + 1):
        load, inertia, _ = node_force(system, state, line, i)
        arm = sub(get(state.position, i), start)
        rest, turn_rest = add(rest, load), add(turn_rest, cross(arm, load))
        whole = add(load, inertia)
        total, turn = add(total, whole), add(turn, cross(arm, whole))
    q = unit_or_zero(sub(get(state.position, last), start))
    upright = scale(waterplane(system, state, line, q), cross(q, UP))
    turn, turn_rest = add(turn, upright), add(turn_rest, upright)
    put_row(sample, line, FORCE_A, total)
    put_row(sample, line, LOAD_A, rest)
    put_row(sample, line, MOMENT_A, turn)
    put_row(sample, line, MOMENT_B, turn_rest)


@kernel
def sample_system(system, state, t, sample):
    """Evaluate the columns (lines, COLUMNS) of all lines at the state of time t."""
    for island in range(len(system.islands.line_ptr) - 1):
        sample_island(system, state, t, island, sample)


@inlined
def put_row(sample, line, column, u):
    sample[line, column], sample[line, column + 1], sample[line, column + 2] = u


@inlined
def depth_at(system, state, i):
    """Depth of a node below the bed, m; a node that just touches counts as on it."""
    if state.position[i, 2] > system.contact.bed.highest + 1.0:
        return -1.0
    return bed_at(system.contact.bed, state.position[i, 0], state.position[i, 1])[0] + 1e-6 - state.position[i, 2]


@inlined
def grounded_part(below0, below1):
    """Fraction of a segment on the bed, from the depths of its nodes below the bed."""
    if below0 >= 0.0 and below1 >= 0.0:
        return 1.0
    if below0 < 0.0 and below1 < 0.0:
        return 0.0
    # the line leaves the bed between the nodes: the contact of the node on the bed reaches half a segment
    return 0.5


@inlined
def hermite(r0, v0, r1, v1, h, s):
    """Position at the fraction s of a step of length h."""
    s2, s3 = s * s, s * s * s
    a, b = 2.0 * s3 - 3.0 * s2 + 1.0, h * (s3 - 2.0 * s2 + s)
    c, d = 3.0 * s2 - 2.0 * s3, h * (s3 - s2)
    return add(add(scale(a, r0), scale(b, v0)), add(scale(c, r1), scale(d, v1)))


@inlined
def mix(s, u, v):
    return add(scale(1.0 - s, u), scale(s, v))


@inlined
def record_lines(system, old, now, island, before, after, h, s, record, row):
    """Write the output of one time, at the fraction s of the step from `old` to `now` of length h."""
    lines, islands = system.lines, system.islands
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        for x in range(COLUMNS):
            record.lines[row, line, x] = before[line, x] + s * (after[line, x] - before[line, x])
    for p in range(islands.point_ptr[island], islands.point_ptr[island + 1]):
        point = islands.points[p]
        i = point_row(lines, point)
        v0, v1 = get(old.velocity, i), get(now.velocity, i)
        r = hermite(get(old.position, i), v0, get(now.position, i), v1, h, s)
        v, a = mix(s, v0, v1), mix(s, get(old.acceleration, i), get(now.acceleration, i))
        for x in range(3):
            record.points[row, point, x] = r[x]
            record.points[row, point, 3 + x] = v[x]
            record.points[row, point, 6 + x] = a[x]


@part
def record_objects(system, old, now, island, h, s, record, row):
    """Write the motion of the objects of an island at the fraction s of the step from `old` to `now` of length h."""
    islands = system.islands
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o, i = islands.objects[k, 0], islands.objects[k, 1]
        out = record.objects[row]
        v0, v1 = get(old.velocity, i), get(now.velocity, i)
        put_row(out, o, PLACE, hermite(get(old.position, i), v0, get(now.position, i), v1, h, s))
        put_row(out, o, SPEED, mix(s, v0, v1))
        put_row(out, o, RISE, mix(s, get(old.acceleration, i), get(now.acceleration, i)))
        turned, w0, w1 = get(now.position, i + 1), get(old.velocity, i + 1), get(now.velocity, i + 1)
        angle = hermite((0.0, 0.0, 0.0), w0, turned, turning_rate(turned, w1), h, s)
        R = mat_mat(mat_get(now.frames[BASE], o), rotation(angle))
        for x in range(9):
            out[o, TURN + x] = R[x]
        put_row(out, o, SPIN, mat_times(R, mix(s, w0, w1)))
        put_row(out, o, TWIST, mat_times(R, mix(s, get(old.acceleration, i + 1), get(now.acceleration, i + 1))))


@part
def record_watched(system, old, now, island_of_line, island, h, s, record, row):
    """Write the watched nodes of an island."""
    for w in range(len(record.watched)):
        line = record.watched[w, 0]
        if island_of_line[line] != island:
            continue
        first, last = line_nodes(system.lines, line)
        i, out = first + record.watched[w, 1], record.watch[row]
        v0, v1 = get(old.velocity, i), get(now.velocity, i)
        put_row(out, w, POSITION, hermite(get(old.position, i), v0, get(now.position, i), v1, h, s))
        put_row(out, w, VELOCITY, mix(s, v0, v1))
        for x in range(FORCE, WATCH_COLUMNS):
            out[w, x] = 0.0
        for side in range(2):  # one call in a loop, because it is inlined and long
            state, share = old if side == 0 else now, 1.0 - s if side == 0 else s
            if len(system.winches.place) > 0:
                reel(system, island, record.time[row] + (h * (1.0 - s) if side == 1 else -h * s))
            force, _, lift = node_force(system, state, line, i)
            N, n, rub = bed_force(system, state, first, last, i)
            out[w, TENSION] += share * node_tension(system, state, line, i)
            out[w, LIFT] += share * lift
            for x in range(3):
                out[w, FORCE + x] += share * force[x]
                out[w, BED + x] += share * (N * n[x] + rub[x])


@inlined
def bed_force(system, state, first, last, i):
    """Normal force of the seabed on a node, N, its direction, and friction, N."""
    r, v = get(state.position, i), get(state.velocity, i)
    c = Weights(0.0, 0.0, 0.0)
    soil, N, n, rub = system.contact.soil, 0.0, UP, (0.0, 0.0, 0.0)
    if near_bed(system.contact, r, r):
        N, n, _ = contact_terms(system.contact, np.uintp(i), r, r, v, memory_of(soil, state, i), c)
        load = rubbing_load(soil, N)
        if system.friction.law != NONE and load > 0.0:
            q = unit_or_zero(sub(get(state.position, min(i + 1, last)), get(state.position, max(i - 1, first))))
            rub = friction_terms(system.friction, np.uintp(i), load, n, q, r, v, get(state.stuck, i), c)[0]
    return N, n, rub


@inlined
def record_contact(system, state, first, last, i, share, out):
    """Add a share of the gap to the bed, the normal force and the friction of a node at one end of a step."""
    N, _, rub = bed_force(system, state, first, last, i)
    r = get(state.position, i)
    out[GAP] += share * (r[2] - bed_at(system.contact.bed, r[0], r[1])[0])
    out[NORMAL] += share * N
    for x in range(3):
        out[RUB + x] += share * rub[x]


@inlined
def node_tension(system, state, line, i):
    """Size of the mean of the pulls of the segments at a node, N, as MoorDyn has it."""
    first, last = line_nodes(system.lines, line)
    total, count = (0.0, 0.0, 0.0), 0
    for k in range(max(i - 1, first), min(i + 1, last)):
        e, de = spans(state, k)
        tension = segment_tension(system.tension, np.uintp(k - line), e, de)
        total = add(total, scale(tension, unit_or_zero(e)))
        count += 1
    return math.sqrt(dot(total, total)) / count


@part
def record_nodes(system, old, now, island, h, s, record, row):
    """Write the node histories of an island at one time, and the bending that goes with the interpolated shape."""
    islands, time = system.islands, record.node_time[row]
    for m in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[m]
        first, last = line_nodes(system.lines, line)
        for i in range(first, last + 1):
            v0, v1 = get(old.velocity, i), get(now.velocity, i)
            r = hermite(get(old.position, i), v0, get(now.position, i), v1, h, s)
            put(record.node_position[row], i, r)
            put(record.node_velocity[row], i, mix(s, v0, v1))
            if i < last:
                record.segment_tension[row, i - line] = 0.0
            for x in range(CONTACT_COLUMNS):
                record.contact[row, i, x] = 0.0
        for side in range(2):
            state, share = old if side == 0 else now, 1.0 - s if side == 0 else s
            if len(system.winches.place) > 0:
                reel(system, island, time + (h * (1.0 - s) if side == 1 else -h * s))
            for i in range(first, last + 1):
                if i < last:
                    e, de = spans(state, i)
                    record.segment_tension[row, i - line] += share * segment_tension(
                        system.tension, np.uintp(i - line), e, de
                    )
                record_contact(system, state, first, last, i, share, record.contact[row, i])
        if system.lines.bends[line]:
            if len(system.winches.place) > 0:
                reel(system, island, time)
            position = record.node_position[row]
            for i in range(first, last + 1):
                bend = node_bending(system, old, now, s, position, line, i, record.node_time[row])
                record.curvature[row, i], record.moment[row, i] = bend
    record_joints(system, island, record, row)
