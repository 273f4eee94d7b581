"""Tension at the fairleads over time."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from moorage.plot.style import COLOURS, QUIET, plain

MOST = len(COLOURS)  # more lines than this: only those with the highest peaks are coloured


def plot_tension(ds: xr.Dataset, ax: Axes, variable: str = "fairlead_tension") -> Axes:
    """Draw a tension (time, line) in kN; of many lines, the ones with the highest peaks stand out.

    Later lines are thinner, so that an equal one under them shows.
    """
    time, values = ds["time"].values, ds[variable].transpose("time", "line").values / 1e3
    loudest = np.sort(np.argsort(values.max(axis=0))[::-1][: MOST if values.shape[1] <= MOST else 3])
    rest = np.setdiff1d(np.arange(values.shape[1]), loudest)
    for k in rest:
        label = "other lines" if k == rest[0] else None
        ax.plot(time, values[:, k], color=QUIET, linewidth=0.5, alpha=0.5, label=label)
    for colour, k, width in zip(COLOURS, loudest, np.linspace(1.8, 0.8, len(loudest)), strict=False):
        ax.plot(time, values[:, k], color=colour, linewidth=width, label=f"line {ds['line'].values[k]}")
    plain(ax)
    ax.set_xlim(time[0], max(time[-1], time[0] + 1e-9))
    ax.set_ylim(bottom=min(0.0, float(values.min())))
    ax.set_xlabel("time (s)", fontsize=9)
    ax.set_ylabel(f"{variable.replace('_', ' ')} (kN)", fontsize=9)
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=7, frameon=False, fontsize=8, borderaxespad=0.2)
    return ax
