"""Bending: one hinge energy for interior nodes, clamped ends, rotational springs and joints of cables.

Two half segments of stiffness k1 and k2 (N m/rad, k = 2 EI / l each) meet at a hinge and turn by an angle a, c = cos a:

    E(c) = k1 + k2 - S,   S = sqrt(k1^2 + k2^2 + 2 k1 k2 c),   moment = k1 k2 sin(a) / S

It is what two springs in series store, at the direction between them that balances both. With equal halves it is
exactly the moment EI kappa of Hall, Sirnivas & Yu 2020, equation 7: (2 EI / l) sin(a / 2). A clamp is k2 = infinity, a
pin k2 = 0. Equation 10 of that paper, for an end clamped to a rod, is the same energy of *half* the angle, taken four
times: E = 4 K (1 - cos(a / 2)), kappa = (4 / l) sin(a / 2). It is 1 / cos(a / 2) stiffer than the law that leaves a
cable unchanged when a rod of no length is put into it, kappa = (2 / l) sin a. Files of MoorDyn take the paper's rule,
native ones the exact one.

Forces are the gradient of E, so that they add up to zero, and the tangent is its Hessian, so that it is symmetric.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage._vec3 import (
    add,
    dot,
    isotropic_plus,
    mat_sub,
    mat_transpose,
    scale,
    sub,
    sym_add,
    sym_outer,
    sym_sub,
    sym_to_general,
)
from moorage.physics.table import Tables, look_up

PINNED, EXACT, PAPER = 0, 1, 2  # rules of a line's end, and (EXACT or PAPER) of a joint
RIGID = -1.0  # stands for an infinite stiffness


class Bending(NamedTuple):
    """Parameters of nodes and line ends."""

    before: np.ndarray  # (nodes,) k1 = 2 EI / l of the segment before, N m/rad; 0: no bending there
    after: np.ndarray  # (nodes,) k2 of the segment after, or of the object that holds an end (RIGID: a clamp)
    table: np.ndarray  # (nodes,) table of moment against 2 sin(a / 2), -1: constant EI
    rule: np.ndarray  # (lines, 2) of the two ends: PINNED, EXACT or PAPER
    direction: np.ndarray  # (lines, 2) track of the direction in which the object points into the line, -1: none
    tables: Tables


@inlined
def hinge(k1, k2, c):
    """Return -dE/dc (N m) and d2E/dc2 of the hinge energy at c = cos a."""
    if k2 == RIGID:
        return k1, 0.0
    product = k1 * k2
    S = math.sqrt(max(k1 * k1 + k2 * k2 + 2.0 * product * c, 1e-12 * product + 1e-300))
    G = product / S
    return G, G * G / S


@inlined
def half_hinge(k1, k2, c):
    """Return the same of four times the energy at half the angle (the paper's equation 10)."""
    h = half_cosine(c)
    g, u = hinge(k1, k2, h)
    return g / h, (u + g / h) / (4.0 * h * h)


@inlined
def half_cosine(c):
    """Return cos(a / 2), kept off zero: a cable folded back on itself has no direction to bend in."""
    return math.sqrt(max(0.5 * (1.0 + c), 1e-6))


@inlined
def tabulated(p, table, c):
    """Return -dE/dc and d2E/dc2 where the moment is a table of x = 2 sin(a / 2), the curvature times the length."""
    h = half_cosine(c)
    x = math.sqrt(max(2.0 * (1.0 - c), 1e-24))
    moment, slope = look_up(p.tables, table, x)
    secant = moment / x
    G = secant / h
    return G, (slope - secant) / (x * x * h) + 0.25 * G / (h * h)


@inlined
def node_hinge(p, i, c):
    """Return -dE/dc and d2E/dc2 of an interior node."""
    if p.table[i] >= 0:
        return tabulated(p, p.table[i], c)
    return hinge(p.before[i], p.after[i], c)


@inlined
def end_hinge(p, i, rule, c):
    """Return -dE/dc and d2E/dc2 of an end held by an object (see `tabulated` for tables: the end is mirrored)."""
    if p.table[i] >= 0:
        # mirrored in the object the line turns by 2 a: E_end(c) = E(2 a) / 2 with cos 2a = 2 c^2 - 1
        G, U = tabulated(p, p.table[i], max(2.0 * c * abs(c) - 1.0, -1.0))
        return 2.0 * abs(c) * G, 8.0 * c * c * U - 2.0 * G
    if rule == PAPER:
        return half_hinge(p.before[i], p.after[i], c)
    return hinge(p.before[i], p.after[i], c)


@inlined
def bend(e1, e2):
    """Return inverse lengths, directions, cosine, and the gradients of the cosine, of two vectors that meet."""
    u, v = 1.0 / math.sqrt(dot(e1, e1)), 1.0 / math.sqrt(dot(e2, e2))
    q1, q2 = scale(u, e1), scale(v, e2)
    c = dot(q1, q2)
    t1, t2 = sub(q2, scale(c, q1)), sub(q1, scale(c, q2))
    return u, v, q1, q2, c, t1, t2


@inlined
def bending_terms(bent, G, U, k):
    """Forces and Hessian of a hinge between vectors e1 (before) and e2 (after); bent: `bend(e1, e2)`.

    G = -dE/dc and U = d2E/dc2. Returns the gradients of E to e1 and e2 (N) and k times the second derivatives H11, H22
    (symmetric) and H12 (general).
    """
    u, v, q1, q2, c, t1, t2 = bent
    g1, g2 = scale(u, t1), scale(v, t2)  # dc/de1, dc/de2
    K, U2 = k * G, k * U
    H11 = curved(K, U2, u, c, q1, g1)
    H22 = curved(K, U2, v, c, q2, g2)
    w = K * u * v
    H12 = outer_plus(-w, add(scale(w, q1), scale(U2 * v, g1)), t2, scale(w, q2), q2)
    return scale(-G, g1), scale(-G, g2), H11, H22, H12


@inlined
def clamp_terms(G, U, u, q, d, c, k):
    """Gradient (N) and k times the Hessian of an end's hinge to e, the vector from the end into the line.

    u, q: inverse length and direction of e; d: direction in which the object points into the line; c = q . d.
    """
    g = scale(u, sub(d, scale(c, q)))
    return scale(-G, g), curved(k * G, k * U, u, c, q, g)


@inlined
def curved(K, U2, u, c, q, g):
    """K (u q g^T + u g q^T + c u^2 (I - q q^T)) + U2 g g^T: minus K times the curvature of c, plus that of E."""
    return sym_add(isotropic_plus(K * c * u * u, U2, g), sym_outer(scale(K * u, q), sub(g, scale(0.5 * c * u, q))))


@inlined
def outer_plus(d, u, v, w, x):
    """d I + u v^T + w x^T."""
    return (
        d + u[0] * v[0] + w[0] * x[0], u[0] * v[1] + w[0] * x[1], u[0] * v[2] + w[0] * x[2],
        u[1] * v[0] + w[1] * x[0], d + u[1] * v[1] + w[1] * x[1], u[1] * v[2] + w[1] * x[2],
        u[2] * v[0] + w[2] * x[0], u[2] * v[1] + w[2] * x[1], d + u[2] * v[2] + w[2] * x[2],
    )  # fmt: skip


@inlined
def node_blocks(H11, H22, H12):
    """From segment vectors to nodes before, at and after: own blocks (3) and couplings (at, before), (after, at)."""
    H21 = mat_transpose(H12)
    cross = (2.0 * H12[0], H12[1] + H12[3], H12[2] + H12[6], 2.0 * H12[4], H12[5] + H12[7], 2.0 * H12[8])
    middle = sym_sub(sym_add(H11, H22), cross)
    return middle, mat_sub(H21, sym_to_general(H11)), mat_sub(H21, sym_to_general(H22)), H21


@inlined
def hinge_energy(k1, k2, c):
    """Energy of the hinge, J (of a clamp where k2 is RIGID)."""
    if k2 == RIGID:
        return k1 * (1.0 - c)
    S = math.sqrt(max(k1 * k1 + k2 * k2 + 2.0 * k1 * k2 * c, 0.0))
    return 2.0 * k1 * k2 * (1.0 - c) / (k1 + k2 + S)
