"""Channels of rods and bodies: MoorDyn's definitions, from the blocks of a run.

A rod's roll and pitch are -phi sin b and phi cos b, with phi its angle from the vertical and b its heading; a body's
angles are intrinsic XYZ Euler angles. Both are in degrees, as are their rates. TENA and TENB of a rod are the norms of
the forces of all lines on that end, without inertia; TEN is one of both by the node. Forces on nodes of rods are
those of `moorage.results.rod_nodes`.

All is taken from arrays of the block (`solve.carried`):

    rod_velocity, rod_acceleration, rod_force      (n, rods, 6)    of end A, linear then angular; force about it
    rod_submergence                                (n, rods)
    body_position, body_rotation                   (n, bodies, 3)
    body_velocity, body_acceleration, body_force   (n, bodies, 6)

Source: MoorDyn documentation, "Outputs". Verified by tests/unit/test_rigid_channels.py.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from moorage.model import Model, Rod
from moorage.model.channels import Channel
from moorage.results.rod_nodes import RodNodes
from moorage.solve.blocks import Block

Described = tuple[str, str, Callable[[Block], np.ndarray]]  # unit, words, evaluation

FIELDS = {  # letters of a quantity: end of the block's array, first of its columns, unit, words
    "V": ("velocity", 0, "m s-1", "velocity"),
    "RV": ("velocity", 3, "degree s-1", "angular velocity"),
    "A": ("acceleration", 0, "m s-2", "acceleration"),
    "RA": ("acceleration", 3, "degree s-2", "angular acceleration"),
    "F": ("force", 0, "N", "force"),
    "M": ("force", 3, "N m", "moment"),
}


def of_rod(channel: Channel, model: Model, nodes: RodNodes) -> Described:
    """Return a channel of a rod, or of a node of it."""
    rod, quantity, k = model.rods[nodes.place], channel.quantity, nodes.place
    node = (channel.node or 0) % nodes.number
    where = f"node {node} of rod {rod.id}"
    if quantity in ("RX", "RY"):
        words = f"{'roll' if quantity == 'RX' else 'pitch'} of rod {rod.id}"
        return "degree", words, rod_angle(quantity, rod, nodes)
    if quantity.startswith("TEN"):
        end = "B" if quantity == "TENB" or (quantity == "TEN" and node > 0) else "A"
        return "N", f"force of the lines on end {end} of rod {rod.id}", line_loads(nodes.ends[end == "B"])
    if quantity == "SUB":
        return "1", f"share of rod {rod.id} under water", lambda block: block["rod_submergence"][:, k]
    axis = "XYZ".index(quantity[-1])
    if quantity[0] == "P":
        return "m", f"position of {where}", lambda block: nodes.place_of(block, node)[:, axis]
    if channel.node is None or quantity[:-1] in ("RV", "RA"):
        return of_array("rod", channel, k)
    if quantity[0] == "V":
        return "m s-1", f"velocity of {where}", lambda block: nodes.velocity_of(block, node)[:, axis]
    if quantity[0] == "A":
        return "m s-2", f"acceleration of {where}", lambda block: nodes.acceleration_of(block, node)[:, axis]
    return "N", f"force without inertia on {where}", lambda block: nodes.force(block)[:, node, axis]


def rod_angle(quantity: str, rod: Rod, nodes: RodNodes) -> Callable[[Block], np.ndarray]:
    """Return the evaluation of roll (RX) or pitch (RY) of a rod, degrees; as described where it has no length."""

    def angle(block: Block) -> np.ndarray:
        u = nodes.axis(block) if rod.segments else np.tile(rod.direction, (len(block["time"]), 1))
        across = np.hypot(u[:, 0], u[:, 1])
        phi, size = np.arctan2(across, u[:, 2]), np.where(across > 0.0, across, 1.0)
        return np.degrees(-phi * u[:, 1] / size if quantity == "RX" else phi * u[:, 0] / size)

    return angle


def line_loads(holder: int) -> Callable[[Block], np.ndarray]:
    """Return the evaluation of the size of the force of all lines on an end of a rod, N."""
    return lambda block: np.sqrt((block["holder_load"][:, holder] ** 2).sum(axis=1))


def of_body(channel: Channel, model: Model, k: int) -> Described:
    """Return a channel of the k-th body."""
    body, quantity = model.bodies[k], channel.quantity
    if quantity == "TEN":

        def size(block: Block) -> np.ndarray:
            return np.sqrt((block["body_force"][:, k, :3] ** 2).sum(axis=1))

        return "N", f"size of the force on body {body.id}", size
    if quantity[:-1] not in ("P", "R"):
        return of_array("body", channel, k)
    axis, name = "XYZ".index(quantity[-1]), "position" if quantity[0] == "P" else "rotation"
    scale, unit = (1.0, "m") if quantity[0] == "P" else (180.0 / np.pi, "degree")
    return unit, f"{name} of body {body.id}", lambda block: scale * block[f"body_{name}"][:, k, axis]


def of_array(kind: str, channel: Channel, k: int) -> Described:
    """Return a channel that is a column of one of the block's arrays of rods or bodies."""
    array, start, unit, words = FIELDS[channel.quantity[:-1]]
    column = start + "XYZ".index(channel.quantity[-1])
    scale = 180.0 / np.pi if unit.startswith("degree") else 1.0
    return unit, f"{words} of {kind} {channel.id}", lambda block: scale * block[f"{kind}_{array}"][:, k, column]
