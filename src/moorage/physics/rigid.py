"""Rigid bodies: rotations, inertia, weight and water on a body by itself, and the waterplane of a rod.

Translation in global axes, rotation in those of the body, where the inertia is constant. R takes body axes to global
ones, Omega is the angular velocity in body axes, w = R Omega. A force f at an arm rho0 (body axes) gives the moment
rho0 x R^T f. Added mass A per axis, velocity u against the water, in Kirchhoff's form:

    force  -(A u' + w x A u - A (w x u)),    moment  -(u x A u)

For the same A on all axes, MoorDyn's usual input, only A u' is left.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, kernel
from moorage._vec3 import (
    add,
    cross,
    dot,
    get,
    mat_get,
    mat_t_times,
    mat_times,
    scale,
    sub,
    sym_add,
    sym_times,
)
from moorage.physics.point import damping_terms, wet_fraction

MASS, WEIGHT, BUOYANCY, DISPLACED, RADIUS, SLENDER, SIZE = range(7)
CENTRE, BUOYANT, ADDED, DRAG, INERTIA, FORCE, LINEAR, QUADRATIC = 7, 10, 13, 16, 22, 31, 34, 37
OWN_FORCE, OWN_LINEAR, OWN_QUADRATIC, COLUMNS = 40, 43, 46, 49


class RigidLoads(NamedTuple):
    """Parameters of rods and bodies by themselves, in their own axes about their reference points.

    Columns: MASS, kg, without the nodes of rods, and its CENTRE of gravity (3), m; INERTIA about that (9), with added
    inertia, kg m2; WEIGHT, upwards, -g m, N; wet BUOYANCY, N, at BUOYANT (3), m; mass of DISPLACED water, kg; RADIUS of
    the sphere of equal volume, m; ADDED mass (3), kg; DRAG (6), 0.5 rho CdA, N s2/m2 and N m s2; SLENDER, 1: a rod
    along its first axis, which has no spin; SIZE, the length that makes a distance of an angle, m; given FORCE (3), N,
    and LINEAR (3), N s/m, and QUADRATIC (3), N s2/m2, damping in global axes, and the same in its OWN.
    """

    table: np.ndarray  # (objects, COLUMNS)


@inlined
def triple(p, o, column):
    """Three columns of an object."""
    t = p.table
    return t[o, column], t[o, column + 1], t[o, column + 2]


@inlined
def inertia_of(p, o):
    """Inertia of an object about its centre of gravity, row by row."""
    t, k = p.table, INERTIA
    return (
        t[o, k], t[o, k + 1], t[o, k + 2], t[o, k + 3], t[o, k + 4], t[o, k + 5], t[o, k + 6], t[o, k + 7], t[o, k + 8],
    )  # fmt: skip


@inlined
def rotation(p):
    """Return exp([p]) of a rotation vector, row by row."""
    a2 = dot(p, p)
    if a2 < 1e-8:
        s, c = 1.0 - a2 / 6.0, 0.5 - a2 / 24.0
    else:
        a = math.sqrt(a2)
        s, c = math.sin(a) / a, (1.0 - math.cos(a)) / a2
    x, y, z = p
    return (
        1.0 - c * (y * y + z * z), c * x * y - s * z, c * x * z + s * y,
        c * x * y + s * z, 1.0 - c * (x * x + z * z), c * y * z - s * x,
        c * x * z - s * y, c * y * z + s * x, 1.0 - c * (x * x + y * y),
    )  # fmt: skip


@inlined
def turning_rate(p, omega):
    """Return dp/dt of R = R0 exp([p]) that turns with omega (body axes): T(p)^-1 omega."""
    a2 = dot(p, p)
    if a2 < 1e-4:
        f = 1.0 / 12.0 + a2 / 720.0
    else:
        half = 0.5 * math.sqrt(a2)
        f = (1.0 - half / math.tan(half)) / a2
    turned = cross(p, omega)
    return add(add(omega, scale(0.5, turned)), scale(f, cross(p, turned)))


@inlined
def skew(u):
    """Matrix of u x."""
    x, y, z = u
    return 0.0, -z, y, z, 0.0, -x, -y, x, 0.0


@inlined
def arm_motion(R, V, A, omega, alpha, rho):
    """Velocity and acceleration of what rides at rho (body axes) on an object; V, A global, omega, alpha body axes."""
    turn = cross(omega, rho)
    return add(V, mat_times(R, turn)), add(A, mat_times(R, add(cross(alpha, rho), cross(omega, turn))))


@inlined
def diagonal_turned(R, d):
    """R diag(d) R^T, symmetric."""
    a, b, c = d
    r = R
    return (
        a * r[0] * r[0] + b * r[1] * r[1] + c * r[2] * r[2],
        a * r[0] * r[3] + b * r[1] * r[4] + c * r[2] * r[5],
        a * r[0] * r[6] + b * r[1] * r[7] + c * r[2] * r[8],
        a * r[3] * r[3] + b * r[4] * r[4] + c * r[5] * r[5],
        a * r[3] * r[6] + b * r[4] * r[7] + c * r[5] * r[8],
        a * r[6] * r[6] + b * r[7] * r[7] + c * r[8] * r[8],
    )


@inlined
def spin_terms(inertia, omega, alpha, c):
    """Moment -(J alpha + omega x J omega), body axes, and its block c.mass J + c.damping ([omega] J - [J omega])."""
    L = mat_times(inertia, omega)
    moment = scale(-1.0, add(mat_times(inertia, alpha), cross(omega, L)))
    J, k = inertia, c.damping
    x, y, z = omega
    l0, l1, l2 = L
    m = c.mass
    return moment, (
        m * J[0] + k * (y * J[6] - z * J[3]),
        m * J[1] + k * (y * J[7] - z * J[4] + l2),
        m * J[2] + k * (y * J[8] - z * J[5] - l1),
        m * J[3] + k * (z * J[0] - x * J[6] - l2),
        m * J[4] + k * (z * J[1] - x * J[7]),
        m * J[5] + k * (z * J[2] - x * J[8] + l0),
        m * J[6] + k * (x * J[3] - y * J[0] + l1),
        m * J[7] + k * (x * J[4] - y * J[1] - l0),
        m * J[8] + k * (x * J[5] - y * J[2]),
    )


@inlined
def wet_body(p, o, z):
    """Wet fraction of an object's own volume with its reference point z above the surface, and its slope (1/m)."""
    return wet_fraction(p.table[o, RADIUS], z)


@inlined
def water_terms(p, o, wet, R, V, A, omega, water, c):
    """Drag and added mass on the translation of an object, at its reference point.

    Returns force (N), moment (N m, body axes) and the force's symmetric block by the translation.
    """
    _, flow, swell = water
    u = sub(V, flow)
    speed = math.sqrt(dot(u, u))
    D = diagonal_turned(R, scale(wet, triple(p, o, DRAG)))
    M = diagonal_turned(R, scale(wet, triple(p, o, ADDED)))
    Du, w = sym_times(D, u), mat_times(R, omega)
    momentum = sym_times(M, u)
    force = scale(-speed, Du)
    force = sub(force, sym_times(M, sub(A, swell)))
    force = sub(force, sub(cross(w, momentum), sym_times(M, cross(w, u))))
    force = add(force, scale(wet * p.table[o, DISPLACED], swell))
    moment = scale(-1.0, mat_t_times(R, cross(u, momentum)))
    k = c.damping
    f = 0.5 * k / (speed + 1e-9)  # the exact derivative is not symmetric where D is not isotropic: half of both
    block = (
        c.mass * M[0] + k * speed * D[0] + 2.0 * f * Du[0] * u[0],
        c.mass * M[1] + k * speed * D[1] + f * (Du[0] * u[1] + Du[1] * u[0]),
        c.mass * M[2] + k * speed * D[2] + f * (Du[0] * u[2] + Du[2] * u[0]),
        c.mass * M[3] + k * speed * D[3] + 2.0 * f * Du[1] * u[1],
        c.mass * M[4] + k * speed * D[4] + f * (Du[1] * u[2] + Du[2] * u[1]),
        c.mass * M[5] + k * speed * D[5] + 2.0 * f * Du[2] * u[2],
    )
    return force, moment, block


@inlined
def turning_drag(p, o, wet, omega, c):
    """Moment of drag on the rotation of an object, body axes, and its symmetric block."""
    d = scale(wet, triple(p, o, DRAG + 3))
    rate = math.sqrt(dot(omega, omega))
    Dw = d[0] * omega[0], d[1] * omega[1], d[2] * omega[2]
    k = c.damping
    f = 0.5 * k / (rate + 1e-9)
    return scale(-rate, Dw), (
        k * rate * d[0] + 2.0 * f * Dw[0] * omega[0],
        f * (Dw[0] * omega[1] + Dw[1] * omega[0]),
        f * (Dw[0] * omega[2] + Dw[2] * omega[0]),
        k * rate * d[1] + 2.0 * f * Dw[1] * omega[1],
        f * (Dw[1] * omega[2] + Dw[2] * omega[1]),
        k * rate * d[2] + 2.0 * f * Dw[2] * omega[2],
    )


@inlined
def upright_moment(strength, q0, up, c):
    """Moment of a rod's waterplane, body axes, and its block, row by row.

    strength: rho g pi d^4 / 64 times the wet fraction of end A less that of end B, N m; q0: the rod's direction from A
    to B, up: the vertical, both in body axes. It turns the dry end up, with rho g I sin(tilt).
    """
    moment = scale(strength, cross(q0, up))
    # d up = [up] d theta, so that the block -d moment is -strength [q0] [up] = strength ((q0.up) I - up q0^T)
    k, s = c.stiffness * strength, dot(q0, up)
    a, b = up, q0
    return moment, (
        k * (s - a[0] * b[0]), -k * a[0] * b[1], -k * a[0] * b[2],
        -k * a[1] * b[0], k * (s - a[1] * b[1]), -k * a[1] * b[2],
        -k * a[2] * b[0], -k * a[2] * b[1], k * (s - a[2] * b[2]),
    )  # fmt: skip


@inlined
def lever(arm, pull):
    """Minus the derivative of the moment arm x (R^T f) to a right increment of the rotation, -[arm][pull].

    arm and pull = R^T f in body axes; [a][b] = b a^T - (a.b) I.
    """
    s = dot(arm, pull)
    a, b = arm, pull
    return (
        s - b[0] * a[0], -b[0] * a[1], -b[0] * a[2],
        -b[1] * a[0], s - b[1] * a[1], -b[1] * a[2],
        -b[2] * a[0], -b[2] * a[1], s - b[2] * a[2],
    )  # fmt: skip


@inlined
def mass_load(p, o, R, A, omega, alpha):
    """Inertia and weight of an object's own mass at its centre of gravity, N, and the acceleration there."""
    centre = triple(p, o, CENTRE)
    a = add(A, mat_times(R, add(cross(alpha, centre), cross(omega, cross(omega, centre)))))
    m = p.table[o, MASS]
    return (-m * a[0], -m * a[1], p.table[o, WEIGHT] - m * a[2]), centre


@inlined
def given_load(p, o, R, V, c):
    """Given forces and damping on an object (global axes), and the block; damping in a rod's axes is on its nodes."""
    fixed, d = damping_terms(triple(p, o, LINEAR), triple(p, o, QUADRATIC), V, c)
    force = add(add(triple(p, o, FORCE), fixed), mat_times(R, triple(p, o, OWN_FORCE)))
    block = d[0], 0.0, 0.0, d[1], 0.0, d[2]
    if p.table[o, SLENDER] == 0.0:
        own, turned = own_damping(p, o, R, V, c)
        force, block = add(force, own), sym_add(block, turned)
    return force, block


@inlined
def own_damping(p, o, R, V, c):
    """Damping along an object's own axes of a velocity, in global axes, and its block."""
    force, d = damping_terms(triple(p, o, OWN_LINEAR), triple(p, o, OWN_QUADRATIC), mat_t_times(R, V), c)
    return mat_times(R, force), diagonal_turned(R, d)


@inlined
def body_load(p, o, z, R, V, A, omega, alpha, water, c):
    """Force (global) and moment (its own axes) on an object by itself, with its reference point at level z."""
    wet = wet_body(p, o, z - water[0])[0]
    moment = spin_terms(inertia_of(p, o), omega, alpha, c)[0]
    force, centre = mass_load(p, o, R, A, omega, alpha)
    moment = add(moment, cross(centre, mat_t_times(R, force)))
    lift = (0.0, 0.0, wet * p.table[o, BUOYANCY])
    buoyant = triple(p, o, BUOYANT)
    moment = add(moment, cross(buoyant, mat_t_times(R, lift)))
    hydro, turn, _ = water_terms(p, o, wet, R, V, A, omega, water, c)
    moment = add(moment, add(turn, turning_drag(p, o, wet, omega, c)[0]))
    return add(add(force, lift), add(hydro, given_load(p, o, R, V, c)[0])), moment


@kernel
def sample_rigid(p, o, water, position, axes, velocity, acceleration, c, out):
    """Fill (n, 6) with force and moment on a body by itself, in global axes, from its motion."""
    for row in range(len(out)):
        R, V, A = mat_get(axes, row), get(velocity, row), get(acceleration, row)
        omega = mat_t_times(R, (velocity[row, 3], velocity[row, 4], velocity[row, 5]))
        alpha = mat_t_times(R, (acceleration[row, 3], acceleration[row, 4], acceleration[row, 5]))
        w = water[row]
        around = w[0], (w[1], w[2], w[3]), (w[4], w[5], w[6])
        force, moment = body_load(p, o, position[row, 2], R, V, A, omega, alpha, around, c)
        turn = mat_times(R, moment)
        for x in range(3):
            out[row, x], out[row, 3 + x] = force[x], turn[x]
