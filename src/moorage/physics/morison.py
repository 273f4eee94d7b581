"""Inertia with added mass, and drag, of a slender node with tangent q (Hall & Goupee 2015, equations 10-15).

    inertia  -[m + rho V (Can (I - q q^T) + Cat q q^T)] a + rho V [(1 + Can) (I - q q^T) + (1 + Cat) q q^T] U_t
    drag     -0.5 rho Cdn d l |u_t| u_t - 0.5 rho Cdt pi d l |u_q| u_q,   u = v - U, u_q = (u.q) q, u_t = u - u_q

with U the velocity of the water and U_t its acceleration.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage._vec3 import add, dot, isotropic_plus, mat_sub, outer, scale, sub


class Morison(NamedTuple):
    """Parameters: what a node has when all of it is wet, and what each whole segment contributes."""

    mass: np.ndarray  # (nodes,) kg
    node: np.ndarray  # (nodes, 5) wet: transverse and tangential added mass, kg; same of drag, N s2/m2; displaced, kg
    segment: np.ndarray  # (segments, 5) the same of a whole segment


@inlined
def wet_node(p, i):
    """Added masses, drag factors and displaced mass of a node that is wholly under water."""
    return p.node[i, 0], p.node[i, 1], p.node[i, 2], p.node[i, 3], p.node[i, 4]


@inlined
def wet_part(p, i, j0, share0, j1, share1):
    """The same of a node of which shares of segments j0 and j1 are wet (0.5 = all)."""
    d0, d1 = 0.5 - share0, 0.5 - share1
    return (
        p.node[i, 0] - d0 * p.segment[j0, 0] - d1 * p.segment[j1, 0],
        p.node[i, 1] - d0 * p.segment[j0, 1] - d1 * p.segment[j1, 1],
        p.node[i, 2] - d0 * p.segment[j0, 2] - d1 * p.segment[j1, 2],
        p.node[i, 3] - d0 * p.segment[j0, 3] - d1 * p.segment[j1, 3],
        p.node[i, 4] - d0 * p.segment[j0, 4] - d1 * p.segment[j1, 4],
    )


@inlined
def wet_end(p, i, share):
    """The same of the end of a line or rod of whose half segment, and face, a share is wet."""
    return (
        share * p.node[i, 0],
        share * p.node[i, 1],
        share * p.node[i, 2],
        share * p.node[i, 3],
        share * p.node[i, 4],
    )


@inlined
def inertia_terms(normal, axial, q, a, c):
    """Force -M a on a node of transverse and axial mass (kg), and its block c.mass M.

    The block is (x, y) for x I + y q q^T.
    """
    return anisotropic(-normal, -axial, q, a), (c.mass * normal, c.mass * (axial - normal))


@inlined
def anisotropic(normal, axial, q, u):
    """Return normal (I - q q^T) u + axial q q^T u."""
    return add(scale(normal, u), scale((axial - normal) * dot(u, q), q))


@inlined
def drag_terms(normal, axial, q, u, c):
    """Drag on a node that moves with u (m/s) through the water, and its block, with q held.

    The block is (x, y, z, u_t) for x I + y q q^T + z u_t u_t^T.
    """
    uq = dot(u, q)
    ut = sub(u, scale(uq, q))
    speed = math.sqrt(dot(ut, ut))
    kn, kt = normal * speed, axial * abs(uq)
    force = add(scale(-kn, ut), scale(-kt * uq, q))
    along_flow = c.damping * normal / (speed + 1e-9)
    return force, (c.damping * kn, c.damping * (2.0 * kt - kn), along_flow, ut)


@inlined
def drag_turn(normal, axial, q, u):
    """Derivative of the drag to the direction q, a general 3x3 matrix, N.

    From dF = -n (|u_t| I + u_t u_t^T / |u_t|) du_t - t (2 |u_q| q u^T + |u_q| u.q I) dq, du_t = -(q u^T + u.q I) dq.
    """
    uq = dot(u, q)
    ut = sub(u, scale(uq, q))
    speed = math.sqrt(dot(ut, ut))
    kn, kt = normal * speed, axial * abs(uq)
    along = normal * uq / (speed + 1e-9)
    # u_t . q = 0, so that (u_t u_t^T) (q u^T + u.q I) = u.q u_t u_t^T
    turned = mat_sub(outer(scale(kn - 2.0 * kt, q), u), outer(scale(-along, ut), ut))
    same = (kn - kt) * uq
    return (
        turned[0] + same, turned[1], turned[2],
        turned[3], turned[4] + same, turned[5],
        turned[6], turned[7], turned[8] + same,
    )  # fmt: skip


@inlined
def hydro_block(inertia, drag, q):
    """Sum of the blocks of inertia and drag."""
    x, y, z, ut = drag
    block = isotropic_plus(inertia[0] + x, inertia[1] + y, q)
    w = scale(z, ut)
    return (
        block[0] + w[0] * ut[0],
        block[1] + w[0] * ut[1],
        block[2] + w[0] * ut[2],
        block[3] + w[1] * ut[1],
        block[4] + w[1] * ut[2],
        block[5] + w[2] * ut[2],
    )
