"""The numbers of a run that people ask for, one row for each line."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

from moorage.results.cable_report import as_plain, cable_reports

OF_SEABED = ("anchor_uplift_force", "touchdown_position", "touchdown_arc_length")


class Summary(NamedTuple):
    """A series at its start or at rest, and its minimum, mean, maximum and standard deviation."""

    start: float
    minimum: float
    mean: float
    maximum: float
    deviation: float


class LineSummary(NamedTuple):
    """One line: tensions at end B (fairlead) and end A (anchor) in N, and what matters for its anchor."""

    line: int
    fairlead: Summary
    anchor: Summary
    lowest_tension: float  # of any segment at any time, N
    uplift: float  # largest angle of the pull at end A above the horizontal, rad
    grounded: float  # shortest length on the seabed, m


def summary(values: np.ndarray, start: float) -> Summary:
    """Summarise a series (n,)."""
    return Summary(start, float(values.min()), float(values.mean()), float(values.max()), float(values.std()))


def line_summaries(ds: xr.Dataset) -> list[LineSummary]:
    """Summarise every line of a run; it starts with its static tensions where it began with statics."""
    names = ("fairlead_tension", "anchor_tension", "minimum_tension", "anchor_uplift_angle", "grounded_length")
    fairlead, anchor, lowest, uplift, grounded = (ds[name].transpose("time", "line").values for name in names)
    start_fairlead = ds["static_fairlead_tension"].values if has_static_tensions(ds) else fairlead[0]
    start_anchor = ds["static_anchor_tension"].values if has_static_tensions(ds) else anchor[0]
    return [
        LineSummary(
            int(id),
            summary(fairlead[:, k], float(start_fairlead[k])),
            summary(anchor[:, k], float(start_anchor[k])),
            float(lowest[:, k].min()),
            float(uplift[:, k].max()),
            float(grounded[:, k].min()),
        )
        for k, id in enumerate(ds["line"].values)
    ]


def has_static_tensions(ds: xr.Dataset) -> bool:
    """Return whether a result holds the static tensions that its run started from."""
    return "static_fairlead_tension" in ds.variables


def static_report(ds: xr.Dataset) -> dict[str, object]:
    """Return a static solution as plain lists and numbers, in N, m and rad, for JSON.

    Every line of a cable has the numbers of the cable.
    """
    cable = {id: {"cable": as_plain(report)} for report in cable_reports(ds) for id in report.lines}
    bed = [name for name in OF_SEABED if "anchor_uplift_force" in ds and name in ds]
    of_line = ("fairlead_tension", "anchor_tension", "minimum_tension", "grounded_length", "anchor_uplift_angle")
    return {
        "lines": [
            {"id": int(id)}
            | {name: float(ds[name].values[k]) for name in of_line}
            | {name: plain(ds[name].values[k]) for name in bed}
            | cable.get(int(id), {})
            for k, id in enumerate(ds["line"].values)
        ],
        "points": [
            {
                "id": int(id),
                "kind": str(ds["point_kind"].values[k]),
                "position": ds["point_position"].values[k].tolist(),
                "force": ds["point_force"].values[k].tolist(),
            }
            for k, id in enumerate(ds["point"].values)
        ],
        **({"turbines": _turbines(ds)} if "turbine_force" in ds else {}),
        "stiffness": plain(ds["stiffness"].values),
        "residual": float(ds["residual"]),
        "iterations": int(ds["iterations"]),
    }


def _turbines(ds: xr.Dataset) -> list[dict[str, object]]:
    names = ("position", "force", "moment")
    return [
        {"id": int(id)} | {name: ds[f"turbine_{name}"].values[k].tolist() for name in names}
        for k, id in enumerate(ds["turbine"].values)
    ]


def plain(value: np.ndarray) -> object:
    """Return numbers as JSON knows them, null for those that are none."""
    return [plain(part) for part in value] if np.ndim(value) else (float(value) if np.isfinite(value) else None)
