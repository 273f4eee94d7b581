"""The columns of rods and bodies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from moorage.model import Model
from moorage.results.rod_nodes import RodNodes, rod_nodes
from moorage.solve.blocks import Block
from moorage.system.build import Built

ROD = ("rod_position", "rod_force", "rod_moment")
NODES = ("rod_node_force",)
BODY = ("body_position", "body_rotation", "body_force", "body_moment")


@dataclass(frozen=True)
class Carried:
    """Labels of the rods and bodies of a model, in the order of the file.

    Attributes
    ----------
    rod, body : (rods,), (bodies,) int
        Ids.
    rod_diameter : (rods,) float
        m.
    nodes : tuple of RodNodes
        Of all rods, where the forces on their nodes are kept.
    """

    rod: np.ndarray
    body: np.ndarray
    rod_diameter: np.ndarray
    nodes: tuple[RodNodes, ...] = ()

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the variables over time."""
        return (ROD if len(self.rod) else ()) + (NODES if self.nodes else ()) + (BODY if len(self.body) else ())

    @property
    def sizes(self) -> dict[str, int]:
        """Lengths of the dimensions."""
        rods = {"rod": len(self.rod), "rod_end": 2} if len(self.rod) else {}
        rods |= {"rod_node": sum(nodes.number for nodes in self.nodes)} if self.nodes else {}
        return rods | ({"body": len(self.body)} if len(self.body) else {})

    @property
    def coordinates(self) -> dict[str, np.ndarray]:
        """Values of the coordinates."""
        rods = {"rod": self.rod, "rod_end": np.array(["A", "B"], dtype=object), "rod_diameter": self.rod_diameter}
        if self.nodes:
            counts = [nodes.number for nodes in self.nodes]
            rods["node_rod"] = np.repeat(self.rod, counts)
            rods["rod_node_number"] = np.concatenate([np.arange(n) for n in counts])
        return (rods if len(self.rod) else {}) | ({"body": self.body} if len(self.body) else {})

    def columns(self, block: Block) -> dict[str, np.ndarray]:
        """Return the columns of a block, by name."""
        values: dict[str, np.ndarray] = {
            name: block[name] for name in ("rod_position", "body_position", "body_rotation") if name in block
        }
        if self.nodes:
            values["rod_node_force"] = np.concatenate([nodes.force(block) for nodes in self.nodes], axis=1)
        for kind in ("rod", "body"):
            if f"{kind}_force" in block:
                values[f"{kind}_force"], values[f"{kind}_moment"] = np.split(block[f"{kind}_force"], 2, axis=-1)
        return values


def carried_of(model: Model, built: Built, node_forces: bool = False) -> Carried | None:
    """Return what the columns of rods and bodies need; None for a model without. node_forces: of each node of rods."""
    if not model.rods and not model.bodies:
        return None
    diameter = {t.name.lower(): t.diameter for t in model.rod_types}
    return Carried(
        np.array([rod.id for rod in model.rods], dtype=np.int64),
        np.array([body.id for body in model.bodies], dtype=np.int64),
        np.array([diameter[rod.rod_type.lower()] for rod in model.rods]),
        tuple(rod_nodes(model, built)) if node_forces else (),
    )
