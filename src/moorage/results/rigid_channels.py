"""Channels of rods and bodies: MoorDyn's definitions, from the blocks of a run.

A rod's roll and pitch are -phi sin b and phi cos b, with phi its angle from the vertical and b its heading; a body's
angles are intrinsic XYZ Euler angles. Both are in degrees, as are their rates. TENA and TENB of a rod are the norms of
the forces of all lines on that end, without inertia; TEN is one of both by the node.

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

from moorage.model import Attachment, Model, Rod
from moorage.model.channels import Channel
from moorage.solve.march import Block

Described = tuple[str, str, Callable[[Block], np.ndarray]]  # unit, words, evaluation

FIELDS = {  # letters of a quantity: end of the block's array, first of its columns, unit, words
    "V": ("velocity", 0, "m s-1", "velocity"),
    "RV": ("velocity", 3, "degree s-1", "angular velocity"),
    "A": ("acceleration", 0, "m s-2", "acceleration"),
    "RA": ("acceleration", 3, "degree s-2", "angular acceleration"),
    "F": ("force", 0, "N", "force"),
    "M": ("force", 3, "N m", "moment"),
}


def of_rod(channel: Channel, model: Model, k: int, first: int) -> Described:
    """Return a channel of the k-th rod; first: the number of its end A among points and ends of rods."""
    rod, quantity = model.rods[k], channel.quantity
    last = first + 1 if rod.segments else first
    node = rod.segments if channel.node == -1 else channel.node or 0
    share = node / rod.segments if rod.segments else 0.0
    if quantity in ("PX", "PY", "PZ"):
        axis = "XYZ".index(quantity[1])

        def place(block: Block) -> np.ndarray:
            r = block["holder_position"][:, :, axis]
            return (1.0 - share) * r[:, first] + share * r[:, last]

        return "m", f"position of node {node} of rod {rod.id}", place
    if quantity in ("RX", "RY"):
        words = f"{'roll' if quantity == 'RX' else 'pitch'} of rod {rod.id}"
        return "degree", words, rod_angle(quantity, rod, first, last)
    if quantity.startswith("TEN"):
        end = "B" if quantity == "TENB" or (quantity == "TEN" and node > 0) else "A"
        return "N", f"force of the lines on end {end} of rod {rod.id}", line_loads(model, rod, end)
    if quantity == "SUB":
        return "1", f"share of rod {rod.id} under water", lambda block: block["rod_submergence"][:, k]
    if quantity[0] == "V" and channel.node is not None:
        return "m s-1", f"velocity of node {node} of rod {rod.id}", node_velocity(quantity, k, share, first, last)
    return of_array("rod", channel, k)


def rod_angle(quantity: str, rod: Rod, first: int, last: int) -> Callable[[Block], np.ndarray]:
    """Return the evaluation of roll (RX) or pitch (RY) of a rod, degrees; as described where it has no length."""

    def angle(block: Block) -> np.ndarray:
        r = block["holder_position"]
        u = r[:, last] - r[:, first] if last > first else np.tile(rod.direction, (len(r), 1))
        across = np.hypot(u[:, 0], u[:, 1])
        phi, size = np.arctan2(across, u[:, 2]), np.where(across > 0.0, across, 1.0)
        return np.degrees(-phi * u[:, 1] / size if quantity == "RX" else phi * u[:, 0] / size)

    return angle


def line_loads(model: Model, rod: Rod, end: str) -> Callable[[Block], np.ndarray]:
    """Return the evaluation of the size of the force of all lines on an end of a rod, N."""
    ends = ("A", "B") if rod.segments == 0 else (end,)  # both ends of a rod without length are one
    holds = [Attachment("rod", rod.id, e) for e in ends]  # type: ignore[arg-type]
    pairs = [(k, e) for k, line in enumerate(model.lines) for e, a in enumerate((line.end_a, line.end_b)) if a in holds]

    def size(block: Block) -> np.ndarray:
        load = block["end_load"]
        total = sum((load[:, k, e] for k, e in pairs), np.zeros((len(load), 3)))
        return np.sqrt((total**2).sum(axis=1))

    return size


def node_velocity(quantity: str, k: int, share: float, first: int, last: int) -> Callable[[Block], np.ndarray]:
    """Return the evaluation of the velocity of a node of a rod, m/s: that of end A, and the turn of the axis."""

    def velocity(block: Block) -> np.ndarray:
        r, v = block["holder_position"], block["rod_velocity"][:, k]
        arm = share * (r[:, last] - r[:, first])
        return (v[:, :3] + np.cross(v[:, 3:], arm))[:, "XYZ".index(quantity[-1])]

    return velocity


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
