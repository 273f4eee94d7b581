"""The OUTPUTS channels of a MoorDyn file, under MoorDyn's names and with MoorDyn's definitions.

A node force is the net force on the node without its inertia; the tension of an end node (FAIRTEN, ANCHTEN, TENA, TENB,
TEN of node 0 or N) is the norm of that force, not the force on the fairlead or anchor, which has the inertia of half a
segment in it. Inside a line, TEN is the mean of the two neighbour segments. A point's force is that of its lines
(without inertia) with its own weight, buoyancy, drag and constant force. Intended difference: accelerations of fixed
and coupled points are those of the imposed motion, where MoorDyn prints zero.

Source: MoorDyn documentation, "Outputs". Verified by tests/unit/test_outputs.py.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from moorage.layout import Weights
from moorage.model import Model
from moorage.model.channels import Channel, parse_channel
from moorage.physics.point import sample_loads
from moorage.results.rigid_channels import of_body, of_rod
from moorage.results.rod_nodes import RodNodes, rod_nodes, watched_rods
from moorage.solve.blocks import Block
from moorage.solve.given_water import WaterFeed
from moorage.solve.water_at import water_at
from moorage.system.build import Built

Evaluate = Callable[[Block], np.ndarray]

_KINDS = {  # first letter of a vector quantity: field of the block, unit
    "P": ("position", "m"),
    "V": ("velocity", "m s-1"),
    "A": ("acceleration", "m s-2"),
    "F": ("force", "N"),
}


@dataclass(frozen=True)
class Output:
    """One channel: its name as MoorDyn prints it, what it is, and how it follows from a block."""

    name: str
    unit: str
    long_name: str
    evaluate: Evaluate

    @property
    def attributes(self) -> dict[str, str]:
        """The CF attributes of the channel."""
        return {"units": self.unit, "long_name": self.long_name}


def watch_list(model: Model) -> tuple[tuple[int, int], ...]:
    """Return the (line index, node index) pairs to record: all nodes of rods, then those that channels need."""
    pairs = [_place(model, channel) for _, channel in _channels(model) if _is_watched(model, channel)]
    return tuple(dict.fromkeys((*watched_rods(model), *pairs)))


def plan_outputs(model: Model, built: Built, water: WaterFeed | None = None) -> tuple[Output, ...]:
    """Return the channels of a checked model, each once; `water` is what gives the waves in place of the model."""
    watched = {pair: k for k, pair in enumerate(watch_list(model))}
    rods = rod_nodes(model, built)
    return tuple(_output(name, channel, model, built, watched, rods, water) for name, channel in _channels(model))


def _channels(model: Model) -> list[tuple[str, Channel]]:
    parsed = {output.name: parse_channel(output.name) for output in model.outputs}
    return [(name, channel) for name, channel in parsed.items() if channel is not None]


def _place(model: Model, channel: Channel) -> tuple[int, int]:
    k = next(k for k, line in enumerate(model.lines) if line.id == channel.id)
    return k, model.lines[k].segments if channel.node == -1 else channel.node or 0


def _end(model: Model, channel: Channel) -> int | None:
    """Return 0 or 1 for a channel of the tension at end A or B, else None."""
    if channel.object != "line" or not channel.quantity.startswith("TEN"):
        return None
    k, node = _place(model, channel)
    return {0: 0, model.lines[k].segments: 1}.get(node)


def _is_watched(model: Model, channel: Channel) -> bool:
    return channel.object == "line" and _end(model, channel) is None


def _output(
    name: str,
    channel: Channel,
    model: Model,
    built: Built,
    watched: dict[tuple[int, int], int],
    rods: list[RodNodes],
    water: WaterFeed | None,
) -> Output:
    if channel.object == "point":
        unit, words, evaluate = _of_point(channel, model, built, water)
    elif channel.object == "rod":
        k = next(k for k, rod in enumerate(model.rods) if rod.id == channel.id)
        unit, words, evaluate = of_rod(channel, model, rods[k])
    elif channel.object == "body":
        k = next(k for k, body in enumerate(model.bodies) if body.id == channel.id)
        unit, words, evaluate = of_body(channel, model, k)
    elif _end(model, channel) is not None:
        unit, words, evaluate = _of_end(channel, model)
    else:
        unit, words, evaluate = _of_node(channel, model, watched)
    along = "" if channel.quantity.startswith(("TEN", "SUB")) else f", {channel.quantity[-1].lower()}"
    return Output(name, unit, words + along, evaluate)


def _of_point(channel: Channel, model: Model, built: Built, water: WaterFeed | None) -> tuple[str, str, Evaluate]:
    k, quantity = next(k for k, point in enumerate(model.points) if point.id == channel.id), channel.quantity
    if quantity[0] in "FT":
        words = f"force of lines, weight, buoyancy and drag on point {channel.id}"
        return "N", words, _point_force(built, k, quantity, water)
    field, unit = _KINDS[quantity[0]]
    return unit, f"{field} of point {channel.id}", _vector(f"point_{field}", k, quantity)


def _of_end(channel: Channel, model: Model) -> tuple[str, str, Evaluate]:
    (line, _), end = _place(model, channel), _end(model, channel)
    words = f"net force without inertia on the node at end {'AB'[end or 0]} of line {channel.id}"
    return "N", words, lambda block: _norm(block["end_load"][:, line, end])


def _of_node(channel: Channel, model: Model, watched: dict[tuple[int, int], int]) -> tuple[str, str, Evaluate]:
    line, node = _place(model, channel)
    where, w = f"node {node} of line {channel.id}", watched[line, node]
    if channel.quantity == "TEN":
        return "N", f"mean tension of the segments at {where}", lambda block: block["watch_tension"][:, w]
    field, unit = _KINDS[channel.quantity[0]]
    words = "net force without inertia on" if field == "force" else f"{field} of"
    return unit, f"{words} {where}", _vector(f"watch_{field}", w, channel.quantity)


def _vector(field: str, k: int, quantity: str) -> Evaluate:
    axis = "XYZ".index(quantity[-1])
    return lambda block: block[field][:, k, axis]


def _norm(vectors: np.ndarray) -> np.ndarray:
    return np.sqrt((vectors**2).sum(axis=-1))


def _point_force(built: Built, k: int, quantity: str, given: WaterFeed | None) -> Evaluate:
    """Return MoorDyn's net force on a point: loads of the line ends, and those on the point itself."""

    def force(block: Block) -> np.ndarray:
        own = np.empty((len(block["time"]), 3))
        place, velocity = block["point_position"][:, k].copy(), block["point_velocity"][:, k].copy()
        water = water_at(built, block["time"].copy(), place)
        if given is not None:
            water += [given.sample(t, r[None])[0] for t, r in zip(block["time"].tolist(), place, strict=True)]
        sample_loads(built.system.points, k, water, place, velocity, Weights(0.0, 0.0, 0.0), own)
        total = own + block["holder_load"][:, k]
        return _norm(total) if quantity == "TEN" else total[:, "XYZ".index(quantity[-1])]

    return force
