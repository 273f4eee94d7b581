"""What MoorDyn writes into the files of single rods: a letter of RodOutputs, a set of columns.

Differences on purpose: b holds friction too, and P, the force along the rod of the pressure that accelerates the water,
is at the nodes, where MoorDyn has the pressure on the faces of the ends; the sums are the same. Verified by
tests/verification/test_rod_nodes.py and tests/peers/test_moordyn_c_rods.py.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from moorage.model import Rod
from moorage.results.moordyn_columns import Columns, vector
from moorage.results.rod_nodes import RodNodes
from moorage.solve.blocks import Block
from moorage.solve.given_water import WaterFeed
from moorage.solve.parts import part_histories
from moorage.solve.water_at import row_of_holder, water_along
from moorage.system.build import Built


class RodMoment(NamedTuple):
    """A rod in one block, and what all rods share of that block."""

    built: Built
    block: Block
    nodes: RodNodes
    shared: dict[str, np.ndarray]  # by name, what has been computed for the nodes of all rods
    feed: WaterFeed | None = None  # gives the waves in place of the model

    @property
    def position(self) -> np.ndarray:
        """Positions of the nodes, (n, nodes, 3), m."""
        return self.nodes.position(self.block)

    @property
    def axis(self) -> np.ndarray:
        """Direction of the rod, (n, 1, 3)."""
        return self.nodes.axis(self.block)[:, None]

    def water(self) -> np.ndarray:
        """Return elevation, velocity and acceleration of the water at the nodes, (n, nodes, 7)."""
        first = int(self.built.names.node_ptr[-1])
        rows = first + np.arange(self.nodes.watched.start, self.nodes.watched.stop)
        rows = rows if len(rows) else np.array([row_of_holder(self.built, self.nodes.ends[0])])
        return water_along(self.built, self.block["time"], self.position, rows, self.feed)

    def part(self, name: str) -> np.ndarray:
        """Return a part of the forces on the nodes, see `moorage.solve.parts`, (n, nodes, 3), N."""
        if self.nodes.watched.stop == self.nodes.watched.start:
            return np.zeros(self.position.shape)
        if name not in self.shared:
            first, last = self.built.names.node_ptr[-1], self.built.system.lines.node_ptr[-1]
            r, v = (self.block[f"watch_{kind}"][:, : last - first] for kind in ("position", "velocity"))
            water = water_along(self.built, self.block["time"], r, np.arange(first, last), self.feed)
            self.shared[name] = part_histories(self.built, name, r, v, water, len(self.built.names.lines))
        return self.shared[name][:, self.nodes.watched]

    def along(self, name: str) -> np.ndarray:
        """Return what of a part is along the rod."""
        part, q = self.part(name), self.axis
        return (part * q).sum(axis=2, keepdims=True) * q

    def across(self, name: str) -> np.ndarray:
        """Return what of a part is across the rod."""
        return self.part(name) - self.along(name)

    def weight(self) -> np.ndarray:
        """Return the dry weight of the nodes, (n, nodes, 3), N."""
        out, first = np.zeros(self.position.shape), int(self.built.names.node_ptr[-1])
        if self.nodes.watched.stop > self.nodes.watched.start:
            out[..., 2] = self.built.system.weight.dry[first:][self.nodes.watched]
        return out


def _force(letter: str, values: Callable[[RodMoment], np.ndarray], ending: str = "xyz", unit: str = "N") -> Columns:
    return Columns("Node", tuple(letter + x for x in ending), unit, values)


def _position(m: RodMoment) -> np.ndarray:
    return m.position


def _velocity(m: RodMoment) -> np.ndarray:
    return m.nodes.velocity(m.block)


def _net(m: RodMoment) -> np.ndarray:
    return m.nodes.force(m.block)


def _buoyancy(m: RodMoment) -> np.ndarray:
    return m.nodes.buoyancy(m.block)


def _bed(m: RodMoment) -> np.ndarray:
    return m.nodes.bed(m.block)


# in the order of the programs' columns
ROD_COLUMNS: dict[str, dict[str, Columns]] = {
    "C": {
        "p": vector("p", "m", _position),
        "v": vector("v", "m/s", _velocity),
        "f": _force("F", _net),
        "W": _force("W", RodMoment.weight),
        "B": _force("Bo", _buoyancy),
        "X": _force("Dp", lambda m: m.across("drag")),
        "Y": _force("Dq", lambda m: m.along("drag")),
        "A": _force("Ap", lambda m: m.across("swell"), "XYZ"),
        "a": _force("Aq", lambda m: m.along("swell_added"), "XYZ"),
        "P": _force("Pd", lambda m: m.along("swell_pressure"), unit="Pa"),  # so it is called there; it is N
        "b": _force("B", _bed),
    },
    "F": {
        "p": vector("p", "m", _position),
        "v": vector("v", "m/s", _velocity),
        "U": vector("U", "m/s", lambda m: m.water()[..., 1:4]),
        "B": _force("Bo", _buoyancy),
        "D": _force("D", lambda m: m.part("drag")),
        "I": _force("Fi", lambda m: m.across("swell") + m.along("swell_added")),
        "P": _force("Pd", lambda m: m.along("swell_pressure")),
        "b": _force("b", _bed),
        "W": Columns("Node", ("Wz",), "Nup", lambda m: m.weight()[..., 2:]),
        "A": _force("Ap", lambda m: m.across("swell"), "XYZ"),
        "a": _force("Aq", lambda m: m.along("swell_added"), "XYZ"),
        "X": _force("Dp", lambda m: m.across("drag"), "XYZ"),
        "Y": _force("Dq", lambda m: m.along("drag"), "XYZ"),
    },
}


def rod_columns(rod: Rod, program: str) -> list[Columns]:
    """Return the sets of columns that a rod asks for, in the order of a program, "C" or "F"."""
    return [columns for letter, columns in ROD_COLUMNS[program].items() if letter in rod.outputs]
