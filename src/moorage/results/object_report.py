"""Where turbines, bodies and rods are, in numbers that a table shows.

Verified by tests/unit/test_object_report.py.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

XYZ, TURNS = ("x", "y", "z"), ("roll", "pitch", "yaw")


class ObjectSummary(NamedTuple):
    """One coordinate of a turbine, a body or an end of a rod, m or deg; in statics all four are the same."""

    name: str  # "turbine 1", "body 1", "end A of rod 2"
    coordinate: str
    unit: str
    start: float
    end: float
    lowest: float
    highest: float


def object_summaries(ds: xr.Dataset) -> list[ObjectSummary]:
    """Return the coordinates of turbines, bodies and ends of rods of a static solution or a run; none without these."""
    found: list[ObjectSummary] = []
    for what in ("turbine", "body"):
        for k, id in enumerate(ds[what].values if f"{what}_position" in ds else ()):
            found += _summaries(f"{what} {id}", XYZ, "m", _history(ds[f"{what}_position"])[:, k])
            found += _summaries(f"{what} {id}", TURNS, "deg", np.degrees(_history(ds[f"{what}_rotation"])[:, k]))
    if "rod_position" in ds:
        for k, id in enumerate(ds["rod"].values):
            for side, end in enumerate(ds["rod_end"].values):
                found += _summaries(f"end {end} of rod {id}", XYZ, "m", _history(ds["rod_position"])[:, k, side])
    return found


def _history(values: xr.DataArray) -> np.ndarray:
    return values.values if "time" in values.dims else values.values[None]


def _summaries(name: str, coordinates: tuple[str, ...], unit: str, values: np.ndarray) -> list[ObjectSummary]:
    return [
        ObjectSummary(name, word, unit, *(float(x) for x in (v[0], v[-1], v.min(), v.max())))
        for word, v in zip(coordinates, values.T, strict=True)
    ]
