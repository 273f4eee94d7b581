"""Mass matrices (6, 6) of rods and bodies with all that they carry: mass and added mass, about their reference point.

Rows are force and moment, columns acceleration and angular acceleration, all in global axes. What rods and bodies have
by themselves is read off their loads, which are linear in the acceleration.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from moorage.solve.carried import Block, own_load
from moorage.solve.reactions import point_load, rod_load
from moorage.solve.stiffness import cross_matrix
from moorage.system.build import Built


def rod_mass(built: Built, nodes: np.ndarray, now: Block, k: int, time: float) -> np.ndarray:
    """Return the mass of rod k about its end A.

    nodes: `node_masses`; now: the block of one instant, without its axis of time.
    """
    block, times = {name: values[None] for name, values in now.items()}, np.array([time])

    def load(acceleration: np.ndarray) -> np.ndarray:
        rates = block["rod_acceleration"].copy()
        rates[0, k] = acceleration
        return rod_load(built, block | {"rod_acceleration": rates}, k, times)[0]

    origin = now["rod_position"][k, 0]
    return slope(load) + nodes_of_rod(built, nodes, k, origin) + line_ends(built, nodes, built.rods.ends[k], origin)


def body_mass(built: Built, nodes: np.ndarray, now: Block, k: int, time: float) -> np.ndarray:
    """Return the mass of body k about its origin, with the points and rods fixed to it (what is pinned to it turns)."""
    block, times = {name: values[None] for name, values in now.items()}, np.array([time])
    origin = now["body_position"][k]
    total = slope(lambda acceleration: own_load(built, block, k, acceleration[None], times)[0])
    for rod in built.bodies.rods[k]:
        total += nodes_of_rod(built, nodes, rod, origin)
    for holder in built.bodies.holders[k]:
        place = now["holder_position"][holder]

        def load(acceleration: np.ndarray, holder=holder, place=place) -> np.ndarray:
            motion = np.concatenate([place, np.zeros(3), acceleration[:3]])[None]
            return np.concatenate([point_load(built, holder, motion, times)[0], np.zeros(3)])

        total += moved(slope(load)[:3, :3], place - origin)
    return total + line_ends(built, nodes, built.bodies.holders[k], origin)


def slope(load: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
    """Return minus the derivative (6, 6) of a load (6,) that is linear in the acceleration (6,)."""
    still = load(np.zeros(6))
    return np.stack([still - load(unit) for unit in np.eye(6)], axis=1)


def nodes_of_rod(built: Built, nodes: np.ndarray, k: int, origin: np.ndarray) -> np.ndarray:
    """Return the mass of the nodes of rod k about a place, m."""
    if built.rods.line[k] < 0:
        return np.zeros((6, 6))
    rows = np.arange(*built.system.lines.node_ptr[built.rods.line[k] : built.rods.line[k] + 2])
    return np.sum([moved(nodes[i], built.state.position[i] - origin) for i in rows], axis=0)


def line_ends(built: Built, nodes: np.ndarray, holders: np.ndarray, origin: np.ndarray) -> np.ndarray:
    """Return the mass of the end nodes of all lines on some points and ends of rods, about a place, m."""
    ends, ptr = built.system.lines.end_point[: len(built.names.lines)], built.names.node_ptr
    rows = [ptr[line + end] - end for line, end in np.argwhere(np.isin(ends, holders))]
    return np.sum([np.zeros((6, 6))] + [moved(nodes[i], built.state.position[i] - origin) for i in rows], axis=0)


def moved(mass: np.ndarray, arm: np.ndarray) -> np.ndarray:
    """Return what a mass (3, 3) at an arm is about the reference point, (6, 6)."""
    G = np.hstack([np.eye(3), -cross_matrix(arm)])
    return G.T @ mass @ G
