"""The columns of models with friction, a soil or bathymetry beside the others: contact, friction, uplift, touchdown.

The *uplift* of an anchor is the pull of the line on it away from the seabed: the force along the normal of the bed
where end A stands at the start, and its angle over the bed. Neither is below zero while line lies on the bed, because
half a segment that weighs down on the anchor is no pull.

The *dissipated energy* is that of friction alone, summed in the steps of the run: of laws that stick what slip and
damper take, of laws of the velocity the integral of the *power*, the sum of -F . v over the nodes of a line. The power
itself is of the node histories, and also holds what goes into springs of nodes that stick.

Verified by tests/unit/test_seabed_results.py.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from moorage.model import Model
from moorage.physics.bathymetry import bed_at, normal_of
from moorage.results.bending import touchdown
from moorage.solve.blocks import Block
from moorage.solve.sticking import sticking
from moorage.system.build import Built

UPLIFT = ("anchor_uplift_force",)
CONTACT = ("seabed_gap", "seabed_force")
FRICTION = ("friction_force", "sticking", "friction_power")
ENERGY = ("dissipated_energy",)
TOUCHDOWN = ("touchdown_position", "touchdown_arc_length")


@dataclass(frozen=True)
class Seabed:
    """What the columns need beside the records.

    Attributes
    ----------
    built : Built
        For the laws of contact and friction.
    normal : (lines, 3)
        Unit normal of the bed where end A of a line stands at the start.
    friction : bool
        Whether the seabed has friction.
    """

    built: Built
    normal: np.ndarray
    friction: bool

    @property
    def over_time(self) -> tuple[str, ...]:
        """Names of the columns of every output time."""
        return UPLIFT + (ENERGY if self.friction else ())

    @property
    def histories(self) -> tuple[str, ...]:
        """Names of the columns that go with histories of nodes."""
        return CONTACT + (FRICTION if self.friction else ()) + TOUCHDOWN

    @property
    def coordinates(self) -> dict[str, np.ndarray]:
        """The depth grid, empty without one."""
        bed = self.built.system.contact.bed
        return {"bed_x": bed.x.at, "bed_y": bed.y.at, "bed_level": bed.level} if len(bed.x.at) else {}

    @property
    def sizes(self) -> dict[str, int]:
        """Lengths of the dimensions of the depth grid."""
        return {name: len(self.coordinates[name]) for name in ("bed_x", "bed_y") if name in self.coordinates}

    def columns(self, block: Block) -> dict[str, np.ndarray]:
        """Return the columns of a block, by name."""
        force, angle = uplift(block["end_force"][:, :, 0], self.normal, block["grounded_length"])
        values = {"anchor_uplift_force": force, "anchor_uplift_angle": angle}
        if self.friction:
            values["dissipated_energy"] = block["dissipated_energy"]
        return values | (self._histories(block) if "seabed_gap" in block else {})

    def _histories(self, block: Block) -> dict[str, np.ndarray]:
        position, velocity, rub = block["node_position"], block["node_velocity"], block["friction_force"]
        names, gap = self.built.names, block["seabed_gap"]
        power = -(rub * velocity).sum(axis=-1)
        spot, arc = np.empty((len(gap), len(names.lines), 3)), np.empty((len(gap), len(names.lines)))
        for k, (a, b) in enumerate(zip(names.node_ptr[:-1], names.node_ptr[1:], strict=True)):
            spot[:, k], arc[:, k] = touchdown(position[:, a:b], gap[:, a:b], names.arc_length[a:b])
        values = {"touchdown_position": spot, "touchdown_arc_length": arc}
        if self.friction:
            values["sticking"] = sticking(self.built.system, position, velocity, block["seabed_force"], rub)
            values["friction_power"] = np.add.reduceat(power, names.node_ptr[:-1], axis=1)
        return values


def seabed_of(model: Model, built: Built) -> Seabed | None:
    """Return what the columns of a seabed need; None for a flat spring without friction."""
    friction = model.environment.friction
    rough = friction is not None and friction.largest > 0.0
    if not rough and model.environment.bathymetry is None and model.environment.soil is None:
        return None
    bed, ends = built.system.contact.bed, built.state.position[built.names.node_ptr[:-1]]
    normal = np.array([normal_of(*bed_at(bed, x, y)[1:3]) for x, y, _ in ends]).reshape(-1, 3)
    return Seabed(built, normal, rough)


def uplift(force: np.ndarray, normal: np.ndarray, grounded: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the parts (N) of forces (n, lines, 3) along normals (lines, 3), and their angles (rad) over the bed."""
    up = (force * normal).sum(axis=-1)
    along = force - up[..., None] * normal
    angle = np.arctan2(up, np.sqrt((along**2).sum(axis=-1)))
    lies = grounded > 0.0
    return np.where(lies, np.maximum(up, 0.0), up), np.where(lies, np.maximum(angle, 0.0), angle)
