"""Extremes along lines: a quantity against arc length."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from moorage.plot.along import SHOWN
from moorage.plot.moorings import name_of
from moorage.plot.style import COLOURS, QUIET, loudest, new_figure, plain
from moorage.results.envelopes import envelope

SAME = 1e-6  # of a value: less is no difference


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
        Ids of the lines; by default all. Of more than there are colours, those with the highest peaks are coloured,
        and the others have their means, in grey.

    Raises
    ------
    ResultError
        The result has no such quantity along its lines.
    """
    ax = new_figure(8.0, 4.0).add_subplot() if ax is None else ax
    whole = envelope(ds, variable)
    dim = "node" if "node" in whole.dims else "segment"
    owner, arc = whole[f"{dim}_line"].values, whole["arc_length" if dim == "node" else "segment_arc_length"].values
    unit, scale = SHOWN.get(ds[variable].attrs["units"], (ds[variable].attrs["units"], 1.0))
    ids = [int(id) for id in ds["line"].values] if lines is None else lines
    rows = [np.flatnonzero(owner == id) for id in ids]
    low, mean, high = (scale * whole[name].values for name in ("minimum", "mean", "maximum"))
    chosen = loudest(np.array([high[own].max(initial=-np.inf) for own in rows]))
    rest = np.setdiff1d(np.arange(len(ids)), chosen)
    for k in rest:
        label = "other lines, mean" if k == rest[0] else None
        ax.plot(arc[rows[k]], mean[rows[k]], color=QUIET, linewidth=0.5, alpha=0.5, label=label)
    for colour, k in zip(COLOURS, chosen, strict=False):
        own = rows[k]
        ax.fill_between(arc[own], low[own], high[own], color=colour, alpha=0.2, linewidth=0.0)
        ax.plot(arc[own], low[own], color=colour, linewidth=0.6)
        ax.plot(arc[own], high[own], color=colour, linewidth=0.6)
        ax.plot(arc[own], mean[own], color=colour, linewidth=1.4, label=name_of([ids[k]]))
    bottom, top = low.min(initial=np.inf), high.max(initial=-np.inf)
    if top - bottom < SAME * abs(top):  # the same all along: its last digits are no picture
        ax.set_ylim(*sorted((0.9 * top, 1.1 * top)))
    plain(ax)
    ax.set_xlabel("arc length from end A (m)", fontsize=9)
    words = variable.removeprefix("segment_").removeprefix("node_").replace("_", " ")
    ax.set_ylabel(f"{words}: lowest, mean, highest ({unit})", fontsize=9)
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=7, frameon=False, fontsize=8, borderaxespad=0.2)
    return ax
