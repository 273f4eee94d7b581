"""r-test's md_BodiesAndRods in its plane by dense equations, as MoorDyn-F writes them or as we do; without its lines.

A body of 1000 t falls, with one rod fixed to it and one pinned to it. The lines pull with 36 kN at most, of 9.8 MN of
weight, and are left out. Nothing of Moorage is used. The rules are those of `planar_float`, and one more:

* The pin ("pin"). Ours: the pinned rod gives the body a force at the pin; body and rod are one system of equations.
  MoorDyn-F (2.3.8): the body gets force and moment of the pinned rod, and its mass and inertia, as if it were fixed to it,
  and the rod turns by itself about a pin that moves as the body does.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from integration import runge_kutta
from planar_float import (
    ADDED,
    DRAG,
    END_ADDED,
    END_DRAG,
    RHO,
    Cylinder,
    G,
    water_of_moordyn,
    water_of_ours,
)

MASS, INERTIA = 1e6, 1e10  # of the body, kg and kg m2
FIXED = Cylinder(0.0, 13.0, 10.0, 1000.0, 3)
PINNED = Cylinder(0.0, float(np.hypot(3.0, 13.0)), 10.0, 1000.0, 3)
ARMS = np.array([[0.0, 2.0], [2.0, 2.0]])  # of their ends A on the body, m
START = np.array([0.0, 0.0, 0.0, float(np.arctan2(3.0, 13.0)), 0.0, 0.0, 0.0, 0.0])  # x, z, both angles; their rates


class Rules(NamedTuple):
    """Which of MoorDyn-F's rules hold."""

    water: bool
    kinematics: bool
    pin: bool


class Rod(NamedTuple):
    """A rod now: nodes relative to end A (n, 2), forces on them (n, 2), their masses (n, 2, 2), a moment beside."""

    nodes: np.ndarray
    force: np.ndarray
    mass: np.ndarray
    moment: float
    inertia: float  # beyond that of the nodes, kg m2
    weight: float  # mass, kg


def turned(arm: np.ndarray) -> np.ndarray:
    """Derivative of arms (.., 2) by the angle of pitch."""
    return np.stack([arm[..., 1], -arm[..., 0]], axis=-1)


def rod_now(rod: Cylinder, place: np.ndarray, speed: np.ndarray, angle: float, rate: float, moordyn: bool) -> Rod:
    """Forces and masses on the nodes of a rod whose end A has a place and a speed."""
    d, n, area = rod.diameter, rod.segments, np.pi / 4.0 * rod.diameter**2
    q = np.array([np.sin(angle), np.cos(angle)])
    share = np.full(n + 1, rod.length / n)
    share[[0, -1]] *= 0.5
    nodes = np.linspace(0.0, rod.length, n + 1)[:, None] * q
    v = speed + rate * turned(nodes)
    water = (water_of_moordyn if moordyn else water_of_ours)(rod, place[1] + nodes[:, 1], share, q)
    along = np.outer(v @ q, q)
    across = v - along
    f = water.buoyancy - (rod.mass * share)[:, None] * [0.0, G]
    f -= (0.5 * RHO * DRAG * d * share * water.wet * np.linalg.norm(across, axis=1))[:, None] * across
    added = (RHO * ADDED * area * share * water.wet)[:, None, None] * (np.eye(2) - np.outer(q, q))
    m = (rod.mass * share)[:, None, None] * np.eye(2) + added
    for end, i in enumerate((0, -1)):
        f[i] -= 0.5 * RHO * END_DRAG * area * water.ends[end] * abs(v[i] @ q) * along[i]
        m[i] += RHO * END_ADDED * np.pi / 12.0 * d**3 * water.ends[end] * np.outer(q, q)
    whole = rod.mass * rod.length
    return Rod(nodes, f, m, water.moment, whole * (d**2 / 16.0 - rod.length**2 / (6.0 * n**2)), whole)


def accelerations(y: np.ndarray, rules: Rules) -> np.ndarray:
    """Accelerations of x, z, pitch of the body and of the pinned rod."""
    place, (theta, phi), velocity, (omega, nu) = y[:2], y[2:4], y[4:6], y[6:8]
    c, s = np.cos(theta), np.sin(theta)
    arms = ARMS @ np.array([[c, -s], [s, c]])
    F, M = np.array([0.0, -MASS * G, 0.0, 0.0]), np.diag([MASS, MASS, INERTIA, 0.0])
    rods = []
    for rod, arm, angle, rate in ((FIXED, arms[0], theta, omega), (PINNED, arms[1], phi, nu)):
        now = rod_now(rod, place + arm, velocity + omega * turned(arm), angle, rate, rules.water)
        rods.append((now, arm, rate))
    for k, (now, arm, rate) in enumerate(rods):
        as_fixed = k == 0 or rules.pin
        J = np.zeros((len(now.nodes), 2, 4))
        J[:, 0, 0] = J[:, 1, 1] = 1.0
        J[:, :, 2] = turned(arm + now.nodes) if as_fixed else turned(arm)
        if not as_fixed:
            J[:, :, 3] = turned(now.nodes)
        f, centre = now.force.copy(), 0.5 * now.nodes[-1]
        turn = 2 if as_fixed else 3
        if rules.kinematics:
            own = now.weight * rate**2 * centre
            F[:2] += own + now.mass.sum(axis=0) @ (omega**2 * (arm + centre))
            F[2] += turned(arm + centre if as_fixed else arm) @ own
            F[turn] += turned(centre) @ own if turn == 3 else 0.0
        else:
            f += np.einsum("nij,nj->ni", now.mass, omega**2 * arm + rate**2 * now.nodes)
        F += np.einsum("nia,ni->a", J, f)
        F[turn] += now.moment
        M += np.einsum("nia,nij,njb->ab", J, now.mass, J)
        M[turn, turn] += now.inertia
    if not rules.pin:
        return np.linalg.solve(M, F)
    body = np.linalg.solve(M[:3, :3], F[:3])
    now, arm, rate = rods[1]
    pin = body[:2] + body[2] * turned(arm) - omega**2 * arm
    lever = turned(now.nodes)
    own = now.weight * rate**2 * 0.5 * now.nodes[-1]
    moment = np.einsum("ni,ni->", lever, now.force - now.mass @ pin) + now.moment + turned(0.5 * now.nodes[-1]) @ own
    return np.append(body, moment / (np.einsum("ni,nij,nj->", lever, now.mass, lever) + now.inertia))


def run(duration: float, rules: Rules, step: float = 0.02) -> tuple[np.ndarray, np.ndarray]:
    """Return times (n,) and states (n, 8) (classic Runge-Kutta)."""

    def slope(y):
        return np.concatenate([y[4:], accelerations(y, rules)])

    return runge_kutta(slope, START, duration, step)
