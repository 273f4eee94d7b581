"""A float of two cylinders in the x-z plane, by dense equations of its own, as MoorDyn-F writes them or as we do.

Nothing of Moorage is used. Both lump a rod's mass, drag and added mass at its nodes. They differ in two things.

* Inertia of rotation ("kinematics"). Ours: the force -M_i w x (w x r_i) of every node, with its moment. MoorDyn-F
  (2.3.8): for every rod first -m w x (w x r_c) of its own mass about end A, with its moment; and for a rod whose end A is
  not at the body's reference point once more -(M w x (w x r)) of mass and added mass at its middle, without its moment.
* Water ("water"). Ours: buoyancy where the axis is wet, over a band that the sections reach as they lean, and the moment
  pi d^4 / 64 rho g sin of the waterplane; nodes are wet by their shares of it. MoorDyn-F: radial pressure on the sides,
  pressure on the end faces, a moment of pi d^4 / 16 rho g sin cos for the waterplane, and a wetness of each node that
  mixes that of its length and of its section.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from integration import runge_kutta

RHO, G = 1025.0, 9.80665
DRAG, ADDED, END_DRAG, END_ADDED = 0.6, 1.0, 1.2, 1.0


class Cylinder(NamedTuple):
    start: float  # of end A along the axis, from the reference point, m
    length: float
    diameter: float
    mass: float  # kg/m
    segments: int


FLOAT = Cylinder(-1.0, 5.0, 2.0, 100.0, 30), Cylinder(-2.0, 1.0, 4.0, 2.15e4, 1)  # r-test md_float
START = np.array([0.0, -1.0, np.pi / 4.0, 0.0, 0.0, 0.0])  # x, z, pitch, and their rates


class Water(NamedTuple):
    """What water does: wetness of the nodes and of both ends, forces on the nodes, a moment beside."""

    wet: np.ndarray  # (nodes,)
    ends: np.ndarray  # (2,)
    buoyancy: np.ndarray  # (nodes, 2)
    moment: float


def water_of_moordyn(rod: Cylinder, z: np.ndarray, share: np.ndarray, q: np.ndarray) -> Water:
    """z (nodes,) heights of the nodes, share (nodes,) of the length, q (2,) the axis."""
    d, area = rod.diameter, np.pi / 4.0 * rod.diameter**2
    sine, cosine, side = abs(q[0]), q[1], np.sign(q[0]) or 1.0
    # the wet length is cut into the nodes' own, one after the other, from end A
    before = np.concatenate([[0.0], np.cumsum(share)[:-1]])
    if z[0] < 0.0 < z[-1]:
        along = np.clip((-z[0] / cosine - before) / share, 0.0, 1.0)
    elif z[-1] < 0.0 < z[0]:
        along = np.clip((before + share + z[0] / cosine) / share, 0.0, 1.0)
    else:
        along = np.full(len(z), float(z[0] < 0.0 and z[-1] < 0.0))
    half = np.clip(z / (0.5 * d * max(sine, 1e-9)), -1.0, 1.0)
    angle = np.arccos(half)
    segment = 2.0 * angle - np.sin(2.0 * angle)
    section = segment / (2.0 * np.pi)
    middle = z - 2.0 / 3.0 * d * np.sin(angle) ** 3 / np.maximum(segment, 1e-12)
    wet = along * cosine**2 + section * sine**2
    radial = -wet * area * share * RHO * G * sine
    force = np.stack([radial * side * cosine, -radial * sine], axis=-1)
    moment, ends = 0.0, np.zeros(2)
    for k, i, sign in ((0, 0, -1.0), (1, -1, 1.0)):
        if half[i] < 1.0:
            ends[k] = wet[i]
            face = sign * wet[i] * area * RHO * G * middle[i]
            force[i] += face * side * sine, face * cosine
            moment -= sign * wet[i] * np.pi / 64.0 * d**4 * RHO * G * sine * side
    if z[0] < 0.0 < z[-1]:
        moment -= np.pi / 16.0 * d**4 * RHO * G * sine * cosine * side
    return Water(wet, ends, force, moment)


def water_of_ours(rod: Cylinder, z: np.ndarray, share: np.ndarray, q: np.ndarray) -> Water:
    """By a fine sum along the axis."""
    d, n, fine = rod.diameter, rod.segments, 40
    t = (np.arange(n * fine) + 0.5) / fine
    band = d * max(0.02, abs(q[0]))
    phi = np.clip(0.5 - (z[0] + (z[-1] - z[0]) * t / n) / band, 0.0, 1.0)
    left = np.minimum(t.astype(int), n - 1)
    volume, whole = np.zeros(n + 1), np.zeros(n + 1)
    for k, weight in ((0, 1.0 - (t - left)), (1, t - left)):
        np.add.at(volume, left + k, weight * phi)
        np.add.at(whole, left + k, weight)
    force = np.zeros((n + 1, 2))
    force[:, 1] = RHO * G * np.pi / 4.0 * d**2 * rod.length / (n * fine) * volume
    ends = np.clip(0.5 - z[[0, -1]] / band, 0.0, 1.0)
    moment = -RHO * G * np.pi / 64.0 * d**4 * (ends[0] - ends[1]) * q[0]
    wet = volume / whole
    return Water(wet, wet[[0, -1]], force, moment)


def loads(state: np.ndarray, moordyn_water: bool, moordyn_kinematics: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return forces (x, z, moment about y) and mass matrix about the reference point."""
    origin, rate = state[:2], state[5]
    q = np.array([np.sin(state[2]), np.cos(state[2])])
    F, M = np.zeros(3), np.zeros((3, 3))
    for rod in FLOAT:
        d, n, area = rod.diameter, rod.segments, np.pi / 4.0 * rod.diameter**2
        share = np.full(n + 1, rod.length / n)
        share[[0, -1]] *= 0.5
        arm = (rod.start + np.linspace(0.0, rod.length, n + 1))[:, None] * q
        v = state[3:5] + rate * np.stack([arm[:, 1], -arm[:, 0]], axis=-1)
        water = (water_of_moordyn if moordyn_water else water_of_ours)(rod, origin[1] + arm[:, 1], share, q)
        along = np.outer(v @ q, q)
        across = v - along
        mass = rod.mass * share
        f = water.buoyancy - mass[:, None] * [0.0, G]
        f -= (0.5 * RHO * DRAG * d * share * water.wet * np.linalg.norm(across, axis=1))[:, None] * across
        added = (RHO * ADDED * area * share * water.wet)[:, None, None] * (np.eye(2) - np.outer(q, q))
        m = mass[:, None, None] * np.eye(2) + added
        for end, i in enumerate((0, -1)):
            f[i] -= 0.5 * RHO * END_DRAG * area * water.ends[end] * abs(v[i] @ q) * along[i]
            m[i] += RHO * END_ADDED * np.pi / 12.0 * d**3 * water.ends[end] * np.outer(q, q)
        G_ = np.zeros((n + 1, 2, 3))
        G_[:, 0, 0] = G_[:, 1, 1] = 1.0
        G_[:, 0, 2], G_[:, 1, 2] = arm[:, 1], -arm[:, 0]
        whole = rod.mass * rod.length
        if moordyn_kinematics:
            centre = 0.5 * rod.length * q
            own = whole * rate**2 * centre
            F += [*own, arm[0, 1] * own[0] - arm[0, 0] * own[1] + centre[1] * own[0] - centre[0] * own[1]]
            F[:2] += m.sum(axis=0) @ (rate**2 * (arm[0] + centre))
        else:
            f += np.einsum("nij,nj->ni", m, rate**2 * arm)
        F += np.einsum("nia,ni->a", G_, f)
        F[2] += water.moment
        M += np.einsum("nia,nij,njb->ab", G_, m, G_)
        M[2, 2] += whole * (d**2 / 16.0 - rod.length**2 / (6.0 * n**2))
    return F, M


def run(duration: float, step: float = 0.02, moordyn_water: bool = True, moordyn_kinematics: bool = True):
    """Return times (n,) and states (n, 6): x, z, pitch and their rates (classic Runge-Kutta)."""

    def slope(y):
        F, M = loads(y, moordyn_water, moordyn_kinematics)
        return np.concatenate([y[3:], np.linalg.solve(M, F)])

    return runge_kutta(slope, START, duration, step)
