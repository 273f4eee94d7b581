"""Bending at a node between two segments (Hall, Sirnivas & Yu 2020): moment (2 EI / l) sin(a/2) at the angle a.

It derives from the energy U = (4 EI / l)(1 - cos(a/2)) with l the mean of the two unstretched lengths, so that forces
are its gradient, add up to zero, and the tangent is its Hessian.
"""

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
)  # fmt: skip


class Bending(NamedTuple):
    """Parameters of the nodes."""

    stiffness: np.ndarray  # (nodes,) EI / l, N m; zero at the ends of a line


@inlined
def bending_terms(p, i, e1, e2, k):
    """Forces and Hessian of the bending energy at node i, between segment vectors e1 (before) and e2 (after).

    Returns the gradients of U to e1 and e2 (N) and k times the second derivatives H11, H22 (symmetric), H12 (general).
    """
    u, v = 1.0 / math.sqrt(dot(e1, e1)), 1.0 / math.sqrt(dot(e2, e2))
    q1, q2 = scale(u, e1), scale(v, e2)
    c = dot(q1, q2)
    h = math.sqrt(max(0.5 * (1.0 + c), 1e-6))  # cos(a/2)
    G = p.stiffness[i] / h  # -dU/dc
    t1, t2 = sub(q2, scale(c, q1)), sub(q1, scale(c, q2))
    g1, g2 = scale(u, t1), scale(v, t2)  # dc/de1, dc/de2
    K, U2 = k * G, 0.25 * k * G / (h * h)  # k G and k d2U/dc2
    H11 = curved(K, U2, u, c, q1, g1)
    H22 = curved(K, U2, v, c, q2, g2)
    w = K * u * v
    H12 = outer_plus(-w, add(scale(w, q1), scale(U2 * v, g1)), t2, scale(w, q2), q2)
    return scale(-G, g1), scale(-G, g2), H11, H22, H12


@inlined
def curved(K, U2, u, c, q, g):
    """K (u q g^T + u g q^T + c u^2 (I - q q^T)) + U2 g g^T: minus K times the curvature of c, plus that of U."""
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
