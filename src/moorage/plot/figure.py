"""The figure of a run: tensions over time, and how each mooring hangs."""

from __future__ import annotations

from pathlib import Path

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from moorage.plot.moorings import moorings
from moorage.plot.profile import plot_plan, plot_profile, plot_profiles
from moorage.plot.style import new_figure
from moorage.plot.tension import plot_tension

COLUMNS = 3
MOST = 6  # more moorings than this are drawn together


def result_figure(ds: xr.Dataset) -> Figure:
    """Return the figure of a result: what it holds of tensions over time and of profiles."""
    groups = moorings(ds) if "node_position" in ds else []
    many = len(groups) > MOST
    columns = 2 if many else max(1, min(COLUMNS, len(groups)))
    rows = 1 if many else -(-len(groups) // columns)
    over_time = "time" in ds["fairlead_tension"].dims
    figure = new_figure(10.0, 3.4 * over_time + 3.0 * rows)
    grid = figure.add_gridspec(over_time + rows, columns)
    if over_time:
        plot_tension(ds, figure.add_subplot(grid[0, :]))
    if many:
        plot_profiles(ds, groups, figure.add_subplot(grid[-1, 0])).set_title("at time 0", fontsize=9, loc="left")
        _legend(plot_plan(ds, figure.add_subplot(grid[-1, 1])))
        return figure
    first = None
    for k, group in enumerate(groups):
        ax = figure.add_subplot(grid[over_time + k // columns, k % columns], sharex=first, sharey=first)
        plot_profile(ds, group, ax)
        ax.set_title(_name(group), fontsize=9, loc="left")
        ax.label_outer()
        if k == 0 or len(group) > 1:
            _legend(ax)
        first = first or ax
    return figure


def save_figure(ds: xr.Dataset, path: str | Path) -> None:
    """Write the figure of a result; the ending of the name chooses the format (png, pdf, svg)."""
    result_figure(ds).savefig(path)


def _legend(ax: Axes) -> None:
    """Put the legend above the axes, where it covers nothing."""
    ax.legend(loc="lower right", bbox_to_anchor=(1.02, 1.0), ncols=4, frameon=False, fontsize=8, borderpad=0.2)


def _name(group: list[int]) -> str:
    return f"line {group[0]}" if len(group) == 1 else "lines " + ", ".join(map(str, group))
