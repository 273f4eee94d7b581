"""What lines can be coloured by: one table (frames, nodes) each, in the units that a page prints."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import xarray as xr

from moorage.results.bed_level import bed_level
from moorage.results.bending import TOUCH, curvatures, segment_tangents

CLEAR, ON_BED, STUCK = 0, 1, 2
CONTACT = ("clear of the seabed", "on the seabed")
CONSTANT, QUIET = 1e-6, 1e-9  # what is no range beside the value, and no value
FRICTION = ("clear of the seabed", "on the seabed, free to slide", "held by friction")


@dataclass(frozen=True)
class Quantity:
    """A quantity at the nodes.

    Attributes
    ----------
    key, label, unit : str
    values : (frames, nodes)
    states : tuple of str
        Names of the whole numbers that it takes, empty for a continuous one.
    """

    key: str
    label: str
    unit: str
    values: np.ndarray
    states: tuple[str, ...] = ()

    @property
    def words(self) -> dict:
        """What a page is told."""
        low, high = (float(f(self.values)) if self.values.size else 0.0 for f in (np.min, np.max))
        if self.key in ("utilisation", "load"):
            low, high = 0.0, max(high, 1.0)
        if not high - low > CONSTANT * max(abs(high), QUIET):  # one value: a page says it, and needs no scale
            low = high = 0.0 if abs(high) < QUIET else high
        return {
            "key": self.key, "label": self.label, "unit": self.unit,
            "low": low, "high": high, "states": list(self.states),
        }  # fmt: skip


def quantities(ds: xr.Dataset, frames: slice, position: np.ndarray) -> list[Quantity]:
    """Return the quantities of a result at some of its instants, with the positions (frames, nodes, 3) there."""
    starts = line_starts(ds)
    bent = _curvature(ds, frames, position, starts)
    found = [
        Quantity("tension", "Tension", "kN", at_nodes(_rows(ds, "segment_tension", frames), starts) / 1e3),
        Quantity("curvature", "Curvature", "1/m", bent),
        _contact(ds, frames, position),
    ]
    if _has_strength(ds):
        strength = ds["breaking_load"].values
        tension = _rows(ds, "segment_tension", frames)
        used = np.where(strength > 0.0, tension / np.where(strength > 0.0, strength, 1.0), 0.0)
        found.append(Quantity("load", "Load utilisation", "", at_nodes(used, starts)))
    if _has_limits(ds):
        used = bent * ds["allowed_bend_radius"].values
        found.append(Quantity("utilisation", "Bend utilisation", "", used))
    return found


def count(ds: xr.Dataset) -> int:
    """Return the number of quantities of a result."""
    return 3 + _has_limits(ds) + _has_strength(ds)


def line_starts(ds: xr.Dataset) -> np.ndarray:
    """Return the first node of every line; the nodes of a line stand together."""
    owner = ds["node_line"].values
    return np.flatnonzero(np.diff(owner, prepend=owner[:1] - 1))


def at_nodes(values: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """Return values of segments (m, segments) at nodes (m, nodes): the mean of both sides, at ends that of the segment.

    So MoorDyn defines the tension of a node.
    """
    nodes = values.shape[1] + len(starts)
    first, last = starts, np.append(starts, nodes)[1:] - 1
    before, after = np.empty((len(values), nodes)), np.empty((len(values), nodes))
    inner_or_first = np.setdiff1d(np.arange(nodes), last)
    after[:, inner_or_first] = values
    before[:, inner_or_first + 1] = values
    before[:, first], after[:, last] = after[:, first], before[:, last]
    return 0.5 * (before + after)


def _has_limits(ds: xr.Dataset) -> bool:
    return "allowed_bend_radius" in ds.coords and bool(ds["allowed_bend_radius"].values.any())


def _has_strength(ds: xr.Dataset) -> bool:
    return "breaking_load" in ds.coords


def _rows(ds: xr.Dataset, name: str, frames: slice) -> np.ndarray:
    return ds[name][frames].values


def _curvature(ds: xr.Dataset, frames: slice, position: np.ndarray, starts: np.ndarray) -> np.ndarray:
    """Return the curvature of a result with cables, or else that of the shape, 0 at the ends."""
    if "curvature" in ds:
        return _rows(ds, "curvature", frames)
    out, length = np.zeros(position.shape[:2]), ds["unstretched_length"].values
    for k, (a, b) in enumerate(zip(starts, np.append(starts, position.shape[1])[1:], strict=True)):
        out[:, a + 1 : b - 1] = curvatures(segment_tangents(position[:, a:b]), length[a - k : b - k - 1])
    return out


def _contact(ds: xr.Dataset, frames: slice, position: np.ndarray) -> Quantity:
    if "seabed_gap" in ds:
        gap = _rows(ds, "seabed_gap", frames)
    else:
        gap = position[..., 2] - bed_level(ds, *position[..., :2].reshape(-1, 2).T).reshape(position.shape[:2])
    state = np.where(gap <= TOUCH, ON_BED, CLEAR)
    if "sticking" not in ds:
        return Quantity("contact", "Seabed contact", "", state, CONTACT)
    held = (_rows(ds, "sticking", frames) > 0) & (state == ON_BED)
    return Quantity("contact", "Seabed contact", "", np.where(held, STUCK, state), FRICTION)
