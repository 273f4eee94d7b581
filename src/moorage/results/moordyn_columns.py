"""What MoorDyn writes into the files of single lines: a letter of LineOutputs, a set of columns.

The programs differ in letters, names, order and meaning: C's D holds the force of the water's acceleration too, and its
c is a vector where F's is a number with a sign. Both count nodes from 0 at end A and segments from 1. t is the elastic
part of the tension. Verified by tests/unit/test_moordyn_out.py and tests/peers/test_moordyn_c_out.py.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from moorage.model import Line
from moorage.solve.blocks import Block
from moorage.solve.given_water import WaterFeed
from moorage.solve.parts import part_histories
from moorage.solve.water_at import water_along
from moorage.system.build import Built

XYZ = "xyz"


class Moment(NamedTuple):
    """A line in one block: its rows among all nodes and segments, and what all lines share of that block."""

    built: Built
    block: Block
    nodes: slice
    segments: slice
    shared: dict[str, np.ndarray]  # by name, what has been computed for all nodes of the block
    feed: WaterFeed | None = None  # gives the waves in place of the model

    def at_nodes(self, name: str) -> np.ndarray:
        """Return a history of the line's nodes."""
        return self.block[name][:, self.nodes]

    @property
    def spans(self) -> tuple[np.ndarray, np.ndarray]:
        """Lengths of the segments, m, and their unit vectors from end A to end B."""
        e = np.diff(self.at_nodes("node_position"), axis=1)
        length = np.linalg.norm(e, axis=2)
        return length, e / np.maximum(length, 1e-300)[..., None]

    @property
    def rate(self) -> np.ndarray:
        """Rates of change of the strains of the segments, times their unstretched lengths, m/s."""
        length, direction = self.spans
        rate = (np.diff(self.at_nodes("node_velocity"), axis=1) * direction).sum(axis=2)
        return rate - length * self.of_winch("segment_growth", 0.0)

    def of_winch(self, name: str, otherwise: np.ndarray | float) -> np.ndarray | float:
        """Return what winches change of the line's segments over time, (n, segments); without them what it is."""
        return self.block[name][:, self.segments] if name in self.block else otherwise

    @property
    def unstretched(self) -> np.ndarray:
        """Unstretched lengths, m; NaN for what is still in a winch."""
        length = np.asarray(self.of_winch("segment_length", self.built.system.tension.length[self.segments]))
        return np.where(length > 0.0, length, np.nan)

    @property
    def damping(self) -> np.ndarray:
        """Damping parts of the tensions, N, positive for pull; from the recorded velocities."""
        p = self.built.system.tension
        force = self.of_winch("segment_damper", p.damper[self.segments]) * self.rate
        for j in np.flatnonzero(p.damper_table[self.segments] >= 0):
            speed = self.rate[:, j] / self.unstretched[..., j]
            force[:, j] = np.sign(speed) * tabulated(p.tables, p.damper_table[self.segments][j], np.abs(speed))
        return force

    @property
    def elastic(self) -> np.ndarray:
        """Elastic parts of the tensions, N; the rest of what is recorded, for EA is too large for positions to tell."""
        total = self.block["segment_tension"][:, self.segments]
        return np.maximum(total - self.damping, self.built.system.tension.slack[self.segments])

    def parts(self, *names: str) -> np.ndarray:
        """Return the sum of parts of the node forces (see `moorage.solve.parts`), (n, nodes, 3), N."""
        for name in names:
            if name not in self.shared:
                r, v = self.block["node_position"], self.block["node_velocity"]
                self.shared[name] = part_histories(self.built, name, r, v, self.all_water())
        return sum((self.shared[name][:, self.nodes] for name in names), np.zeros(self.at_nodes("node_position").shape))

    def all_water(self) -> np.ndarray:
        """Return elevation, velocity and acceleration of the water at all nodes, (n, nodes, 7)."""
        if "water" not in self.shared:
            r, times = self.block["node_position"], self.block["node_time"]
            self.shared["water"] = water_along(self.built, times, r, np.arange(r.shape[1]), self.feed)
        return self.shared["water"]

    def water(self) -> np.ndarray:
        """Return the velocity of the water at the nodes, (n, nodes, 3), m/s."""
        return self.all_water()[:, self.nodes, 1:4]

    def seabed(self) -> np.ndarray:
        """Return contact and friction of the seabed on the nodes, (n, nodes, 3), N."""
        return self.parts("contact") + self.at_nodes("friction_force")


class Columns(NamedTuple):
    """A set of columns: place ("Node" or "Seg"), endings of the names, unit, and values (n, places, endings)."""

    place: str
    endings: tuple[str, ...]
    unit: str
    values: Callable[[Any], np.ndarray]  # of a Moment, of a rod of a RodMoment


def vector(letter: str, unit: str, values: Callable[[Any], np.ndarray]) -> Columns:
    """Return the columns of a vector at the nodes."""
    return Columns("Node", tuple(letter + x for x in XYZ), unit, values)


def tabulated(tables, number: int, x: np.ndarray) -> np.ndarray:
    """Return the values of a table, continued with the slopes of its ends."""
    low, high = tables.ptr[number], tables.ptr[number + 1]
    xs, ys = tables.x[low:high], tables.y[low:high]
    k = np.clip(np.searchsorted(xs, x, side="right") - 1, 0, len(xs) - 2)
    return ys[k] + (x - xs[k]) * (ys[k + 1] - ys[k]) / (xs[k + 1] - xs[k])


def none_of(m: Moment) -> np.ndarray:
    """Return zeros at the nodes: lift of vortices, which models that are accepted do not have."""
    return np.zeros_like(m.at_nodes("node_position"))


# in the order of the programs' columns
LINE_COLUMNS: dict[str, dict[str, Columns]] = {
    "C": {
        "p": vector("p", "m", lambda m: m.at_nodes("node_position")),
        "K": Columns("Node", ("Ku",), "1/m", lambda m: m.at_nodes("curvature")[..., None]),
        "v": vector("v", "m/s", lambda m: m.at_nodes("node_velocity")),
        "U": vector("U", "m/s", Moment.water),
        "D": vector("D", "N", lambda m: m.parts("drag", "swell")),
        "V": vector("V", "N", none_of),
        "t": Columns("Seg", ("Te",), "N", lambda m: np.abs(m.elastic)[..., None]),
        "c": Columns("Seg", ("cx", "cy", "cz"), "N", lambda m: m.damping[..., None] * m.spans[1]),
        "s": Columns("Seg", ("St",), "-", lambda m: (m.spans[0] / m.unstretched - 1.0)[..., None]),
        "d": Columns("Seg", ("dSt",), "-/s", lambda m: (m.rate / m.unstretched)[..., None]),
        "b": vector("b", "N", Moment.seabed),
    },
    "F": {
        "p": vector("p", "m", lambda m: m.at_nodes("node_position")),
        "v": vector("v", "m/s", lambda m: m.at_nodes("node_velocity")),
        "U": vector("U", "m/s", Moment.water),
        "D": vector("D", "N", lambda m: m.parts("drag")),
        "b": vector("b", "N", Moment.seabed),
        "V": vector("V", "N", none_of),
        "W": Columns("Node", ("Wz",), "Nup", lambda m: m.parts("weight")[..., 2:]),
        "K": Columns("Node", ("Kurv",), "1/m", lambda m: m.at_nodes("curvature")[..., None]),
        "t": Columns("Seg", ("Ten",), "N", lambda m: np.abs(m.elastic)[..., None]),
        "c": Columns("Seg", ("Dmp",), "N", lambda m: m.damping[..., None]),
        "s": Columns("Seg", ("Str",), "-", lambda m: (m.spans[0] / m.unstretched - 1.0)[..., None]),
        "d": Columns("Seg", ("SRt",), "1/s", lambda m: (m.rate / m.unstretched)[..., None]),
        "l": Columns("Seg", ("Lst",), "m", lambda m: m.spans[0][..., None]),
    },
}


def line_columns(line: Line, program: str) -> list[Columns]:
    """Return the sets of columns that a line asks for, in the order of a program, "C" or "F"."""
    return [columns for letter, columns in LINE_COLUMNS[program].items() if letter in line.outputs]


def names_of(columns: list[Columns], segments: int) -> list[tuple[str, str]]:
    """Return name and unit of each column of a line or rod."""
    found = []
    for c in columns:
        places = range(segments + 1) if c.place == "Node" else range(1, segments + 1)
        found += [(f"{c.place}{i}{ending}", c.unit) for i in places for ending in c.endings]
    return found


def values_of(columns: list[Columns], moment: Any, n: int) -> np.ndarray:
    """Return the values of the columns of a line or rod at n times, (n, columns)."""
    if not n:
        return np.zeros((0, 0))
    parts = [np.asarray(c.values(moment)).reshape(n, -1) for c in columns]
    return np.concatenate(parts, axis=1) if parts else np.zeros((n, 0))
