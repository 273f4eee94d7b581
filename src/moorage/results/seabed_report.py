"""What a terminal tells of the seabed: one row for each line of a model with friction or a depth grid."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

NOWHERE = float("nan")


class SeabedReport(NamedTuple):
    """One line; NaN where the line is off the bed, or without histories of nodes, or without friction."""

    line: int
    touchdown_position: tuple[float, float, float]  # at the start, m
    touchdown_arc_length: tuple[float, float, float]  # from end A: at the start, least and largest, m
    uplift_force: float  # largest pull at end A away from the bed, N
    dissipated_energy: float  # J


def seabed_reports(ds: xr.Dataset) -> list[SeabedReport]:
    """Report every line of a result of a run or of statics; nothing for flat beds without friction."""
    if "anchor_uplift_force" not in ds:
        return []
    return [_report(ds.isel(line=k), int(id)) for k, id in enumerate(ds["line"].values)]


def _report(ds: xr.Dataset, line: int) -> SeabedReport:
    spot, arc, energy = (
        np.atleast_1d(ds[name].values) if name in ds else np.full(1, NOWHERE)
        for name in ("touchdown_position", "touchdown_arc_length", "dissipated_energy")
    )
    lies = arc[np.isfinite(arc)]
    x, y, z = np.broadcast_to(spot.reshape(len(arc), -1)[0], 3).tolist()
    limits = (float(lies.min()), float(lies.max())) if len(lies) else (NOWHERE, NOWHERE)
    return SeabedReport(
        line, (x, y, z), (float(arc[0]), *limits), float(ds["anchor_uplift_force"].max()), float(energy[-1])
    )
