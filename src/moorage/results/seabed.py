"""The columns of models with friction, a soil or bathymetry beside the others: contact, friction, uplift, touchdown.

The *uplift* of an anchor is the pull of the line on it away from the seabed: the force along the normal of the bed
where end A stands at the start, and its angle over the bed. Neither is below zero while line lies on the bed, because
half a segment that weighs down on the anchor is no pull.

The *power* of friction is the sum of -F . v over the nodes of a line, from the node histories; the energy is its
integral by the trapezoidal rule over their times. It is as good as their interval, and holds the little energy of the
springs of nodes that stick.

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
TOUCHDOWN = ("touchdown_position", "touchdown_arc_length")
INTEGRALS = {"dissipated_energy": "friction_power"}


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

    @property
    def integrals(self) -> dict[str, str]:
        """Names of the integrals over time that go with them, and of what they integrate."""
        return INTEGRALS if self.friction else {}

    def columns(self, block: Block) -> dict[str, np.ndarray]:
        """Return the columns of a block, by name."""
        force, angle = uplift(block["end_force"][:, :, 0], self.normal, block["grounded_length"])
        values = {"anchor_uplift_force": force, "anchor_uplift_angle": angle}
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


def running_integral(time: np.ndarray, power: np.ndarray, before: tuple[np.ndarray, ...] | None = None) -> np.ndarray:
    """Return the integral (n, lines) of a power (n, lines) to every time (n,), by the trapezoidal rule.

    Parameters
    ----------
    before : tuple, optional
        Time, power and integral of the row before; without it the integral begins with 0 at the first time.
    """
    if not len(time):
        return np.zeros_like(power)
    t0, p0, start = before or (time[0], power[0], np.zeros(power.shape[1]))
    steps = np.diff(time, prepend=t0)[:, None] * 0.5 * (power + np.concatenate([p0[None], power[:-1]]))
    steps[0] += start
    return np.cumsum(steps, axis=0)
