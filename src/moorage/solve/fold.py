"""Objects in the junction system: their own loads, the nodes of rods, clamps, and the folding of what rides on them.

With G = [I, -R [rho0]] from the increments of an object (translation global, rotation in its own axes) to that of a
rider at rho0, the rider's row and column add G^T S G, and its force f turns with its arm, which adds
-[rho0] [R^T f] c.stiffness. Left out: how velocities and accelerations of riders turn, of order h |Omega|; and T(Psi)
between the rotation vector of a step and its last increment.
"""

from __future__ import annotations

import math

from moorage._jit import inlined, kernel, part
from moorage._vec3 import (
    add,
    cross,
    dot,
    get,
    isotropic_plus,
    mat_get,
    mat_mat,
    mat_scale,
    mat_t_times,
    mat_times,
    mat_transpose,
    put,
    scale,
    sub,
    sym_add,
    sym_get,
    sym_mat,
    sym_scale,
    sym_to_general,
)
from moorage.layout import (
    ATTITUDE,
    CARRIER,
    CLAMP,
    PIN,
    ROTATION,
    ROW,
    SPAN,
    TOWARD,
    TRANSLATION,
    WATERPLANE,
    line_nodes,
    point_row,
    water_of,
)
from moorage.physics.bending import end_hinge
from moorage.physics.rigid import (
    BUOYANCY,
    BUOYANT,
    MASS,
    SLENDER,
    given_load,
    inertia_of,
    lever,
    mass_load,
    own_damping,
    skew,
    spin_terms,
    triple,
    turning_drag,
    upright_moment,
    water_terms,
    wet_body,
)
from moorage.physics.weight import section_fraction
from moorage.system.ride import rider_arm, surface_band, vector

UP = (0.0, 0.0, 1.0)
ZERO6 = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@part
def add_objects(system, state, work, A, b, size, island, c):
    """Add the objects of an island to its junction system, and fold the riders into them."""
    islands, riders = system.islands, system.riders
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o = islands.objects[k, 0]
        add_own_loads(system, state, A, b, size, o, c)
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[k]
        o = riders.lines[line, CARRIER]
        if o >= 0:
            add_rod(system, state, work, A, b, size, line, o, c)
        for end in range(2):
            if riders.lines[line, CLAMP + end] >= 0:
                add_clamp(system, state, work, A, b, size, line, end, c.stiffness)
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o = islands.objects[k, 0]
        R = mat_get(state.frames[ATTITUDE], o)
        t, r = riders.objects[o, TRANSLATION], riders.objects[o, ROTATION]
        p0 = islands.point_ptr[island]
        for u in range(islands.rides[island, 0]):
            point = islands.points[p0 + u]
            if riders.points[point] == o:
                fold(A, b, size, u, t, r, R, get(riders.arm, point), c.stiffness)
        if system.rigid.table[o, SLENDER] > 0.0:
            hold(A, b, size, 3 * r)


@part
def load_objects(system, state, work, island, c):
    """Set the force and moment on the objects of an island in `work.force`, with those of all that rides on them.

    The forces on riding points are there already.
    """
    islands, riders = system.islands, system.riders
    size = 3 * (islands.unknown_ptr[island + 1] - islands.unknown_ptr[island])
    base, begin = islands.matrix_ptr[island], 3 * islands.unknown_ptr[island]
    A, b = work.junction_matrix[base : base + size * size], work.junction_force[begin : begin + size]
    for k in range(size * size):
        A[k] = 0.0
    for k in range(size):
        b[k] = 0.0
    p0 = islands.point_ptr[island]
    for u in range(islands.rides[island, 0]):
        add_at(b, u, get(work.force, point_row(system.lines, islands.points[p0 + u])))
    add_objects(system, state, work, A, b, size, island, c)
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o = islands.objects[k, 0]
        row, t, r = riders.objects[o, ROW], 3 * riders.objects[o, TRANSLATION], 3 * riders.objects[o, ROTATION]
        moves = riders.objects[o, PIN] < 0
        put(work.force, row, (b[t], b[t + 1], b[t + 2]) if moves else (0.0, 0.0, 0.0))
        put(work.force, row + 1, (b[r], b[r + 1], b[r + 2]))


@inlined
def add_own_loads(system, state, A, b, size, o, c):
    """Add inertia, weight, buoyancy, water and external loads of an object by itself."""
    riders, p = system.riders, system.rigid
    t, r, row = riders.objects[o, TRANSLATION], riders.objects[o, ROTATION], riders.objects[o, ROW]
    R = mat_get(state.frames[ATTITUDE], o)
    V, acc = get(state.velocity, row), get(state.acceleration, row)
    omega, alpha = get(state.velocity, row + 1), get(state.acceleration, row + 1)
    moment, block = spin_terms(inertia_of(p, o), omega, alpha, c)
    add_moment(A, b, size, r, moment, block)
    water = water_of(state, row)
    height = state.position[row, 2] - water[0]
    wet, slope = wet_body(p, o, height)
    force, centre = mass_load(p, o, R, acc, omega, alpha)
    m = c.mass * p.table[o, MASS]
    add_rider(A, b, size, t, r, R, centre, force, (m, 0.0, 0.0, m, 0.0, m), c.stiffness)
    lift = wet * p.table[o, BUOYANCY]
    block = (0.0, 0.0, 0.0, 0.0, 0.0, -c.stiffness * slope * p.table[o, BUOYANCY])
    add_rider(A, b, size, t, r, R, triple(p, o, BUOYANT), (0.0, 0.0, lift), block, c.stiffness)
    force, turn, block = water_terms(p, o, wet, R, V, acc, omega, water, c)
    given, D = given_load(p, o, R, V, c)
    if t >= 0:
        add_at(b, t, add(force, given))
        add_block(A, size, t, t, sym_to_general(block))
        add_block(A, size, t, t, sym_to_general(D))
    add_at(b, r, turn)
    moment, block = turning_drag(p, o, wet, omega, c)
    add_moment(A, b, size, r, moment, sym_to_general(block))


@inlined
def add_rod(system, state, work, A, b, size, line, o, c):
    """Add the nodes of a rod to its object, and what its ends feel of the waterplane."""
    riders = system.riders
    t, r = riders.objects[o, TRANSLATION], riders.objects[o, ROTATION]
    first, last = line_nodes(system.lines, line)
    R = mat_get(state.frames[ATTITUDE], o)
    for i in range(first, last + 1):
        arm, force, own = rider_arm(riders, line, first, last, i), get(work.force, i), sym_get(work.blocks.own, i)
        if system.rigid.table[o, SLENDER] == 1.0:  # the rod by itself: given damping along its axes is shared out
            share = (1.0 if first < i < last else 0.5) / (last - first)
            damping, block = own_damping(system.rigid, o, R, get(state.velocity, i), c)
            force, own = add(force, scale(share, damping)), sym_add(own, sym_scale(share, block))
        add_rider(A, b, size, t, r, R, arm, force, own, c.stiffness)
        if i < last:
            next_arm = rider_arm(riders, line, first, last, i + 1)
            S = mat_get(work.blocks.next, i)
            couple_riders(A, size, t, r, R, next_arm, arm, S)
            couple_riders(A, size, t, r, R, arm, next_arm, mat_transpose(S))
    moment, block = rod_upright(system, state, line, o, c)
    add_moment(A, b, size, r, moment, block)


@inlined
def rod_upright(system, state, line, o, c):
    """Moment of a rod's waterplane (body axes) and its block."""
    R = mat_get(state.frames[ATTITUDE], o)
    span = sub(vector(system.riders.places, line, SPAN + 1), vector(system.riders.places, line, SPAN + 0))
    q0 = scale(1.0 / math.sqrt(dot(span, span)), span)
    strength = waterplane(system, state, line, mat_times(R, q0))
    return upright_moment(strength, q0, mat_t_times(R, UP), c)


@inlined
def waterplane(system, state, line, q):
    """Strength of the moment of a rod's waterplane, N m: all of it while end A is wet and end B is dry.

    q: the rod's direction.
    """
    first, last = line_nodes(system.lines, line)
    band = surface_band(system, line, first - line, q)
    low = section_fraction(band, state.position[first, 2] - state.water[first, 0])
    high = section_fraction(band, state.position[last, 2] - state.water[last, 0])
    return system.riders.places[line, WATERPLANE, 0] * (low - high)


@inlined
def clamp_moment(system, state, direction, line, end):
    """What a clamp on an object needs: the two rows, length, direction of the segment and the hinge's derivatives."""
    first, last = line_nodes(system.lines, line)
    node, beside = (first, first + 1) if end == 0 else (last, last - 1)
    e = sub(get(state.position, beside), get(state.position, node))
    inverse = 1.0 / math.sqrt(dot(e, e))
    q, d = scale(inverse, e), vector(direction, line, end)
    cosine = dot(q, d)
    G, U = end_hinge(system.bending, node, system.bending.rule[line, end], cosine)
    return inverse, q, d, cosine, G, U


@inlined
def add_clamp(system, state, work, A, b, size, line, end, k):
    """Add the moment of a clamped line end on its object, and how it couples both to the first segment."""
    o = system.riders.lines[line, CLAMP + end]
    r = system.riders.objects[o, ROTATION]
    inverse, q, d, cosine, G, U = clamp_moment(system, state, work.direction, line, end)
    R = mat_get(state.frames[ATTITUDE], o)
    q0, d0 = mat_t_times(R, q), vector(system.riders.places, line, TOWARD + end)
    t0 = cross(d0, q0)
    moment = scale(G, t0)
    # U t t^T + G (c I - q d^T) in body axes
    s, g, x, y, w = k * G * cosine, k * G, q0, d0, scale(k * U, t0)
    block = (
        s - g * x[0] * y[0] + w[0] * t0[0], -g * x[0] * y[1] + w[0] * t0[1], -g * x[0] * y[2] + w[0] * t0[2],
        -g * x[1] * y[0] + w[1] * t0[0], s - g * x[1] * y[1] + w[1] * t0[1], -g * x[1] * y[2] + w[1] * t0[2],
        -g * x[2] * y[0] + w[2] * t0[0], -g * x[2] * y[1] + w[2] * t0[1], s - g * x[2] * y[2] + w[2] * t0[2],
    )  # fmt: skip
    add_moment(A, b, size, r, moment, block)
    # d2E / (de dtheta) = U p t^T + G P [d] / L, then to body axes
    p = scale(inverse, sub(d, scale(cosine, q)))
    turned = mat_mat(sym_to_general(isotropic_plus(1.0, -1.0, q)), mat_mat(skew(d), R))
    H = add_outer(mat_scale(k * G * inverse, turned), scale(k * U, p), t0)
    u0, u1 = system.lines.end_unknown[line, end], system.lines.inner_unknown[line, end]
    minus = mat_scale(-1.0, H)
    add_block(A, size, u1, r, H)
    add_block(A, size, r, u1, mat_transpose(H))
    if u0 >= 0:
        add_block(A, size, u0, r, minus)
        add_block(A, size, r, u0, mat_transpose(minus))


@inlined
def add_outer(m, u, v):
    """M + u v^T."""
    return (
        m[0] + u[0] * v[0], m[1] + u[0] * v[1], m[2] + u[0] * v[2],
        m[3] + u[1] * v[0], m[4] + u[1] * v[1], m[5] + u[1] * v[2],
        m[6] + u[2] * v[0], m[7] + u[2] * v[1], m[8] + u[2] * v[2],
    )  # fmt: skip


@inlined
def add_at(b, unknown, f):
    """Add a vector to a right-hand side."""
    b[3 * unknown] += f[0]
    b[3 * unknown + 1] += f[1]
    b[3 * unknown + 2] += f[2]


@inlined
def add_block(A, size, row, column, m):
    """Add a general 3x3 block."""
    for i in range(3):
        for j in range(3):
            A[(3 * row + i) * size + 3 * column + j] += m[3 * i + j]


@inlined
def add_moment(A, b, size, r, moment, block):
    """Add a moment on an object in its own axes, and the block by its rotation."""
    add_at(b, r, moment)
    add_block(A, size, r, r, block)


@inlined
def rider_map(R, arm):
    """Minus the increment of a rider at `arm` for one of its object's rotation: R [arm]."""
    return mat_mat(R, skew(arm))


@inlined
def add_rider(A, b, size, t, r, R, arm, force, S, k):
    """Add a force on a rider (N) and its symmetric block to its object."""
    W = rider_map(R, arm)
    SW = sym_mat(S, W)
    if t >= 0:
        add_at(b, t, force)
        add_block(A, size, t, t, sym_to_general(S))
        minus = mat_scale(-1.0, SW)
        add_block(A, size, t, r, minus)
        add_block(A, size, r, t, mat_transpose(minus))
    pull = mat_t_times(R, force)
    add_at(b, r, cross(arm, pull))
    add_block(A, size, r, r, mat_mat(mat_transpose(W), SW))
    add_block(A, size, r, r, mat_scale(k, lever(arm, pull)))


@inlined
def couple_riders(A, size, t, r, R, arm1, arm2, S):
    """Add the block S of the force on the first rider by the motion of the second."""
    W1, W2 = rider_map(R, arm1), rider_map(R, arm2)
    SW = mat_mat(S, W2)
    if t >= 0:
        add_block(A, size, t, t, S)
        add_block(A, size, t, r, mat_scale(-1.0, SW))
        add_block(A, size, r, t, mat_scale(-1.0, mat_mat(mat_transpose(W1), S)))
    add_block(A, size, r, r, mat_mat(mat_transpose(W1), SW))


@inlined
def fold(A, b, size, u, t, r, R, arm, k):
    """Fold the row and column of a rider, unknown u, into those of its object."""
    W = rider_map(R, arm)
    force = b[3 * u], b[3 * u + 1], b[3 * u + 2]
    pull = mat_t_times(R, force)
    for i in range(size):
        x = A[i * size + 3 * u], A[i * size + 3 * u + 1], A[i * size + 3 * u + 2]
        y = mat_t_times(W, x)
        for j in range(3):
            if t >= 0:
                A[i * size + 3 * t + j] += x[j]
            A[i * size + 3 * r + j] -= y[j]
    for j in range(size):
        x = A[3 * u * size + j], A[(3 * u + 1) * size + j], A[(3 * u + 2) * size + j]
        y = mat_t_times(W, x)
        for i in range(3):
            if t >= 0:
                A[(3 * t + i) * size + j] += x[i]
            A[(3 * r + i) * size + j] -= y[i]
    if t >= 0:
        add_at(b, t, force)
    add_at(b, r, cross(arm, pull))
    add_block(A, size, r, r, mat_scale(k, lever(arm, pull)))


@inlined
def hold(A, b, size, i):
    """Keep one unknown at zero."""
    for j in range(size):
        A[i * size + j] = 0.0
        A[j * size + i] = 0.0
    A[i * size + i] = 1.0
    b[i] = 0.0


@kernel
def move_riders(lines, islands, riders, state, increment, island):
    """Set the increments of what rides on the objects of an island, from those of the objects."""
    for k in range(islands.object_ptr[island + 1] - 1, islands.object_ptr[island] - 1, -1):
        o = islands.objects[k, 0]
        row = riders.objects[o, ROW]
        if riders.objects[o, PIN] >= 0:
            pin = riders.objects[o, PIN]
            put(increment, row, get(increment, point_row(lines, pin)) if riders.points[pin] >= 0 else (0.0, 0.0, 0.0))
        R, x, turn = mat_get(state.frames[ATTITUDE], o), get(increment, row), get(increment, row + 1)
        for p in range(islands.point_ptr[island], islands.point_ptr[island] + islands.rides[island, 0]):
            point = islands.points[p]
            if riders.points[point] == o:
                moved = mat_times(R, cross(turn, get(riders.arm, point)))
                put(increment, point_row(lines, point), add(x, moved))
    for k in range(islands.line_ptr[island], islands.line_ptr[island + 1]):
        line = islands.lines[k]
        o = riders.lines[line, CARRIER]
        if o >= 0:
            row = riders.objects[o, ROW]
            R, x, turn = mat_get(state.frames[ATTITUDE], o), get(increment, row), get(increment, row + 1)
            first, last = line_nodes(lines, line)
            for i in range(first, last + 1):
                moved = mat_times(R, cross(turn, rider_arm(riders, line, first, last, i)))
                put(increment, i, add(x, moved))
