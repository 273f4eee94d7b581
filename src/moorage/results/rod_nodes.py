"""Nodes of a rod: where they are, how they move, and the forces on them, as MoorDyn defines them.

All nodes of all rods are watched in a run (`solve.record.Record`), before the nodes of lines that channels ask for.

The engine's buoyancy of a node is vertical. Written out, it is pressure: across the rod on the sides of each node,
along it on the faces of the ends, rho g A times their depth. So MoorDyn has it. Sum and moment are the same, for a
force along the rod may act anywhere on its axis; of a rod in the surface the faces take what the sum says, each by its
wet share.

Source: MoorDyn documentation, "Rods". Verified by tests/verification/test_rod_nodes.py and
tests/peers/test_moordyn_c_rods.py.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.model import Model
from moorage.solve.blocks import Block
from moorage.system.build import Built
from moorage.system.objects import rigid_rods


def watched_rods(model: Model) -> tuple[tuple[int, int], ...]:
    """Return line and node of all nodes of rods; rods with nodes are counted behind the lines."""
    first = len(model.lines)
    return tuple((first + k, i) for k, rod in enumerate(rigid_rods(model)) for i in range(rod.segments + 1))


class RodNodes(NamedTuple):
    """The nodes of one rod, of which one of no length has one."""

    place: int  # of the rod in the model
    watched: slice  # of the watched nodes; empty for a rod of no length
    ends: tuple[int, int]  # end A and B among points and ends of rods
    lift: float  # N: buoyancy of an end's half segment when it is wet
    face: float  # N/m: rho g A

    @property
    def number(self) -> int:
        """Number of nodes."""
        return max(self.watched.stop - self.watched.start, 1)

    def position(self, block: Block) -> np.ndarray:
        """Return the positions, (n, nodes, 3), m."""
        return np.stack([self.place_of(block, node) for node in range(self.number)], axis=1)

    def velocity(self, block: Block) -> np.ndarray:
        """Return the velocities, (n, nodes, 3), m/s."""
        return np.stack([self.velocity_of(block, node) for node in range(self.number)], axis=1)

    def place_of(self, block: Block, node: int) -> np.ndarray:
        """Return the position of a node between the ends, (n, 3), m."""
        return block["holder_position"][:, self.ends[0]] + self._arm(block, node)

    def velocity_of(self, block: Block, node: int) -> np.ndarray:
        """Return the velocity of a node, (n, 3), m/s: that of end A, and by the turn of the axis."""
        v = block["rod_velocity"][:, self.place]
        return v[:, :3] + np.cross(v[:, 3:], self._arm(block, node))

    def acceleration_of(self, block: Block, node: int) -> np.ndarray:
        """Return the acceleration of a node, (n, 3), m/s2."""
        arm, a, spin = self._arm(block, node), block["rod_acceleration"], block["rod_velocity"][:, self.place, 3:]
        turning = np.cross(a[:, self.place, 3:], arm) + np.cross(spin, np.cross(spin, arm))
        return a[:, self.place, :3] + turning

    def _arm(self, block: Block, node: int) -> np.ndarray:
        ends = block["holder_position"][:, self.ends]
        return node / max(self.number - 1, 1) * (ends[:, 1] - ends[:, 0])

    def axis(self, block: Block) -> np.ndarray:
        """Return the unit vectors from end A to end B, (n, 3); zeros for a rod of no length."""
        along = self._arm(block, self.number - 1)
        return along / np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None]

    def force(self, block: Block) -> np.ndarray:
        """Return the forces without inertia, those of the lines on the ends included, (n, nodes, 3), N."""
        own = self._at("force", block, np.zeros((len(block["time"]), 1, 3))).copy()
        own[..., 2] -= self._lift(block)
        own += self.buoyancy(block)
        for end in dict.fromkeys(self.ends):  # both ends of a rod of no length are one
            own[:, 0 if end == self.ends[0] else -1] += block["holder_load"][:, end]
        return own

    def buoyancy(self, block: Block) -> np.ndarray:
        """Return the buoyancy as pressure, (n, nodes, 3), N."""
        lift, q = self._lift(block), self.axis(block)
        along = lift * q[:, 2:]
        out = -along[..., None] * q[:, None]
        out[..., 2] += lift
        faces = self._faces(block, lift[:, [0, -1]], along.sum(axis=1))
        out[:, 0] += faces[:, :1] * q
        out[:, -1] += faces[:, 1:] * q
        return out

    def bed(self, block: Block) -> np.ndarray:
        """Return contact and friction of the seabed, (n, nodes, 3), N."""
        return self._at("bed", block, np.zeros((len(block["time"]), 1, 3)))

    def _faces(self, block: Block, lift: np.ndarray, total: np.ndarray) -> np.ndarray:
        """Return the pressure on the faces of both ends along the rod, (n, 2), N, whose sum is `total` (n,).

        lift: (n, 2) buoyancy of the end nodes, which says how wet they are.
        """
        if self.lift == 0.0:
            return np.zeros(lift.shape)
        wet = lift / self.lift
        depth = np.maximum(-block["holder_position"][:, self.ends, 2], 0.0)
        pressure = self.face * wet * depth * [1.0, -1.0]
        some = wet.sum(axis=1)
        part = np.where(some[:, None] > 0.0, wet / np.maximum(some, 1e-300)[:, None], 0.5)
        return pressure + part * (total - pressure.sum(axis=1))[:, None]

    def _lift(self, block: Block) -> np.ndarray:
        return self._at("lift", block, np.zeros((len(block["time"]), 1)))

    def _at(self, name: str, block: Block, without: np.ndarray) -> np.ndarray:
        """Return a watched quantity, or what a rod of no length has instead."""
        return block[f"watch_{name}"][:, self.watched] if self.watched.stop > self.watched.start else without


def rod_nodes(model: Model, built: Built) -> list[RodNodes]:
    """Return the nodes of all rods of a model."""
    found, start, lines = [], 0, built.system.lines
    for k, rod in enumerate(model.rods):
        line, stop = int(built.rods.line[k]), start + (rod.segments + 1 if rod.segments else 0)
        lift = length = 0.0
        if line >= 0:
            j = int(lines.node_ptr[line]) - line
            lift, length = built.system.weight.buoyancy[j], built.system.tension.length[j]
        a, b = built.rods.ends[k].tolist()
        face = float(lift / length) if length else 0.0
        found.append(RodNodes(k, slice(start, stop), (a, b), 0.5 * float(lift), face))
        start = stop
    return found
