"""Tension at the fairleads over time."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from moorage.plot.moorings import name_of, only_cables
from moorage.plot.style import draw_curves
from moorage.results.cables import cables, end_value

CABLE_ENDS = {"fairlead_tension": "hang_off", "anchor_tension": "far"}


def plot_tension(ds: xr.Dataset, ax: Axes, variable: str = "fairlead_tension") -> Axes:
    """Draw a tension (time, line) in kN; of many lines, the ones with the highest peaks stand out.

    A cable has one tension, that at its hang-off (or at its other end), whichever of its ends that is. Later lines are
    thinner, so that an equal one under them shows.
    """
    time, (names, values) = ds["time"].values, series(ds, variable)
    draw_curves(ax, time, names, values, "other lines")
    ax.set_xlim(time[0], max(time[-1], time[0] + 1e-9))
    low, high = min(0.0, float(values.min())), float(values.max())
    ax.set_ylim(low, high + 0.05 * max(high - low, 1e-3))  # room over a tension that does not change
    ax.set_xlabel("time (s)", fontsize=9)
    hangs = variable == "fairlead_tension" and only_cables(ds, ds["line"].values.tolist())
    ax.set_ylabel(f"{'hang-off tension' if hangs else variable.replace('_', ' ')} (kN)", fontsize=9)
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=7, frameon=False, fontsize=8, borderaxespad=0.2)
    return ax


def series(ds: xr.Dataset, variable: str) -> tuple[list[str], np.ndarray]:
    """Return names and tensions (time, n), kN, of the cables and of the other lines."""
    of_line = ds[variable].transpose("line", "time").values
    columns = {int(id): (name_of([int(id)]), values) for id, values in zip(ds["line"].values, of_line, strict=True)}
    for cable in cables(ds) if variable in CABLE_ENDS else []:
        for id in cable.lines:
            del columns[id]
        values = end_value(ds, "tension", getattr(cable, CABLE_ENDS[variable]))
        columns[min(cable.lines)] = name_of(list(cable.lines)), values
    drawn = [columns[id] for id in sorted(columns)]
    return [name for name, _ in drawn], np.stack([series for _, series in drawn], axis=1) / 1e3
