"""From a block of records to the variables of a result: one table for datasets in memory and files on disk."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from moorage.model import Waves
from moorage.results.bending import COORDINATES, MOMENTS, Bending
from moorage.results.carried import Carried
from moorage.results.channels import Output
from moorage.results.index import Index
from moorage.results.sea import COMPONENT, ELEVATION, sea_columns, sea_coordinates
from moorage.results.seabed import Seabed
from moorage.results.turbines import Turbines
from moorage.solve.blocks import Block
from moorage.solve.given_water import WaterFeed
from moorage.variables import VARIABLES, attributes

NODE_VARIABLES = ("node_position", "node_velocity", "segment_tension")
LENGTHS, SEGMENT_LENGTH = ("line_length", "payout_rate"), ("segment_length",)  # of models with winches
LINE_VARIABLES = (
    "fairlead_tension",
    "anchor_tension",
    "fairlead_force",
    "anchor_force",
    "fairlead_segment_tension",
    "anchor_segment_tension",
    "minimum_tension",
    "grounded_length",
    "anchor_uplift_angle",
    "point_position",
    "point_velocity",
    "point_force",
)


@dataclass(frozen=True)
class Layout:
    """Which variables a result has.

    Attributes
    ----------
    index : Index
    outputs : tuple of Output
        MoorDyn's channels.
    node_time : str
        The time dimension of node histories: "time", "node_time" when they have an interval of their own, "" for none.
    bending : Bending or None
        For models with cables: what their columns need.
    seabed : Seabed or None
        For models with friction, a soil or bathymetry: what their columns need.
    waves : Waves, WaterFeed or None
        The sea, where there is one.
    carried : Carried or None
        For models with rods or bodies: what their columns need.
    turbines : Turbines or None
        For farms: what their columns need.
    static : mapping of str to (lines,) float
        Tensions of the static solution that a run starts from.
    winches : bool
        Whether lines have winches, and so lengths over time.
    """

    index: Index
    outputs: tuple[Output, ...] = ()
    node_time: str = "time"
    bending: Bending | None = None
    seabed: Seabed | None = None
    waves: Waves | WaterFeed | None = None
    carried: Carried | None = None
    turbines: Turbines | None = None
    static: Mapping[str, np.ndarray] = field(default_factory=dict)
    winches: bool = False

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the variables over time, coordinates of time first."""
        times = ("time", "node_time") if self.node_time == "node_time" else ("time",)
        sea = ELEVATION if self.waves else ()
        at_ends = (MOMENTS if self.bending else ()) + (self.seabed.over_time if self.seabed else ())
        carried = sum((part.names for part in (self.carried, self.turbines) if part), ())
        return (
            times
            + sea
            + LINE_VARIABLES
            + carried
            + (LENGTHS if self.winches else ())
            + at_ends
            + self.histories
            + tuple(output.name for output in self.outputs)
        )

    @property
    def histories(self) -> tuple[str, ...]:
        """Names of the variables that are kept when histories of nodes are."""
        if not self.node_time:
            return ()
        parts = [part.histories for part in (self.bending, self.seabed) if part]
        own = SEGMENT_LENGTH if self.winches else ()
        return tuple(dict.fromkeys(NODE_VARIABLES + own + sum(parts, ())))

    @property
    def sizes(self) -> dict[str, int]:
        """Length of every dimension but time."""
        sea = {COMPONENT: len(self.waves.frequency)} if isinstance(self.waves, Waves) else {}
        carried = self.carried.sizes if self.carried else {}
        carried |= self.turbines.sizes if self.turbines else {}
        return self.index.sizes | carried | (self.seabed.sizes if self.seabed else {}) | sea

    def coordinates(self) -> dict[str, np.ndarray]:
        """Return the coordinates of the rows; those of nodes and segments only where there are histories of them."""
        left_out = () if self.node_time else (("node",), ("segment",))
        unused = set(COORDINATES) - set(self.bending.coordinates if self.bending else ())
        known = self.index.coordinates().items()
        rows = {n: values for n, values in known if VARIABLES[n].dims not in left_out and n not in unused}
        sea = sea_coordinates(self.waves) if isinstance(self.waves, Waves) else {}
        carried = self.carried.coordinates if self.carried else {}
        carried |= self.turbines.coordinates if self.turbines else {}
        return rows | carried | (self.seabed.coordinates if self.seabed else {}) | sea | dict(self.static)

    def dims(self, name: str) -> tuple[str, ...]:
        """Return the dimensions of a variable over time."""
        if name not in VARIABLES:
            return ("time",)
        dims = VARIABLES[name].dims
        return (self.node_time, *dims[1:]) if name in self.histories else dims

    def attributes(self, name: str) -> dict[str, str]:
        """Return the CF attributes of a variable over time."""
        return next((output.attributes for output in self.outputs if output.name == name), None) or attributes(name)

    def columns(self, block: Block) -> dict[str, np.ndarray]:
        """Return the values of the recorded variables for one block, by name."""
        anchor, fairlead = block["end_force"][:, :, 0], block["end_force"][:, :, 1]
        values = {
            **block,
            "fairlead_tension": _norm(fairlead),
            "anchor_tension": _norm(anchor),
            "fairlead_force": fairlead,
            "anchor_force": anchor,
            "fairlead_segment_tension": block["end_tension"][:, :, 1],
            "anchor_segment_tension": block["end_tension"][:, :, 0],
            "minimum_tension": block["lowest_tension"],
            "anchor_uplift_angle": uplift_angle(anchor, block["grounded_length"]),
            **(self.bending.columns(block) if self.bending else {}),
            **(self.seabed.columns(block) if self.seabed else {}),
            **(self.carried.columns(block) if self.carried else {}),
            **(self.turbines.columns(block) if self.turbines else {}),
            **(sea_columns(self.waves, block["time"]) if self.waves else {}),
            **{output.name: output.evaluate(block) for output in self.outputs},
        }
        return {name: values[name] for name in self.names}


def uplift_angle(force: np.ndarray, grounded: np.ndarray) -> np.ndarray:
    """Return the angle (rad) of forces (..., 3) above the horizontal; not below it while line lies on the bed.

    A node on the bed at the anchor weighs down on it by half a segment, which is no pull on the anchor.
    """
    angle = np.arctan2(force[..., 2], np.hypot(force[..., 0], force[..., 1]))
    return np.where(grounded > 0.0, np.maximum(angle, 0.0), angle)


def _norm(vectors: np.ndarray) -> np.ndarray:
    return np.sqrt((vectors**2).sum(axis=-1))
