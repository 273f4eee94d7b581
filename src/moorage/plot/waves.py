"""The elevation of the sea over time."""

from __future__ import annotations

import xarray as xr
from matplotlib.axes import Axes

from moorage.plot.style import WATER, plain


def plot_elevation(ds: xr.Dataset, ax: Axes) -> Axes:
    """Draw the elevation of the waves at the origin (time,) in m, with the heights and periods of the sea."""
    time, elevation = ds["time"].values, ds["wave_elevation"].values
    ax.fill_between(time, elevation, color=WATER, alpha=0.25, linewidth=0.0)
    ax.plot(time, elevation, color=WATER, linewidth=0.9)
    plain(ax)
    ax.set_xlim(time[0], max(time[-1], time[0] + 1e-9))
    ax.set_ylabel("waves at\nthe origin (m)", fontsize=9)
    ax.set_title(str(ds.attrs.get("wave_asked", "")), fontsize=9, loc="left")
    return ax
