"""Extremes along lines: a quantity against arc length."""

from __future__ import annotations

import xarray as xr
from matplotlib.axes import Axes

from moorage.plot.along import SHOWN
from moorage.plot.moorings import name_of
from moorage.plot.style import COLOURS, QUIET, new_figure, plain
from moorage.results.dataset import line
from moorage.results.envelopes import envelope


def plot_envelope(
    ds: xr.Dataset, ax: Axes | None = None, variable: str = "segment_tension", lines: list[int] | None = None
) -> Axes:
    """Draw the extremes and the mean of a quantity over the time of a run, along its lines.

    Parameters
    ----------
    ds : xarray.Dataset
        A result with histories of nodes; of a static solution there is one curve a line.
    ax : matplotlib Axes, optional
        Where to draw; by default a new figure, `ax.figure`.
    variable : str
        A quantity of nodes or segments: segment_tension, curvature, bending_moment, ...
    lines : list of int, optional
        Ids of the lines; by default all. Of more than there are colours, the later ones are grey.

    Raises
    ------
    ResultError
        The result has no such quantity along its lines.
    """
    ax = new_figure(8.0, 4.0).add_subplot() if ax is None else ax
    envelope(ds, variable)  # tells what there is, when there is no such thing
    unit, scale = SHOWN.get(ds[variable].attrs["units"], (ds[variable].attrs["units"], 1.0))
    ids = [int(id) for id in ds["line"].values] if lines is None else lines
    for k, id in enumerate(ids):
        extremes = envelope(line(ds, id), variable)
        arc = extremes["node_arc_length" if "node" in extremes.dims else "segment_arc_length"].values
        low, mean, high = (scale * extremes[name].values for name in ("minimum", "mean", "maximum"))
        colour = COLOURS[k] if k < len(COLOURS) else QUIET
        ax.fill_between(arc, low, high, color=colour, alpha=0.2, linewidth=0.0)
        ax.plot(arc, low, color=colour, linewidth=0.6)
        ax.plot(arc, high, color=colour, linewidth=0.6)
        label = name_of([id]) if k < len(COLOURS) else ("other lines" if k == len(COLOURS) else None)
        ax.plot(arc, mean, color=colour, linewidth=1.4, label=label)
    plain(ax)
    ax.set_xlabel("arc length from end A (m)", fontsize=9)
    words = variable.removeprefix("segment_").removeprefix("node_").replace("_", " ")
    ax.set_ylabel(f"{words}: lowest, mean, highest ({unit})", fontsize=9)
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=7, frameon=False, fontsize=8, borderaxespad=0.2)
    return ax
