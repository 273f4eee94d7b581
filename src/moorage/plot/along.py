"""What acts along a cable: a quantity against the distance from the hang-off, with its extremes over time."""

from __future__ import annotations

from math import pi

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from moorage.plot.style import COLOURS, QUIET, plain
from moorage.results.cables import Cable, strand
from moorage.results.envelopes import envelope

SHOWN = {"N": ("kN", 1e-3), "N m": ("kN m", 1e-3), "rad": ("deg", 180.0 / pi), "m-1": ("1/m", 1.0)}
LIMIT = COLOURS[1]
CLOSE = 0.4  # of the allowed curvature: below that, its line would squeeze the rest


def plot_along(ds: xr.Dataset, lines: list[int], ax: Axes, variable: str = "segment_tension") -> Axes:
    """Draw a quantity of the nodes or segments of a cable (or of one line): at time 0, over its extremes and mean.

    Parts that are thicker, with modules or a stiffener, are shaded. Curvature comes with what is allowed, when it gets
    near that, and with a note of it otherwise.
    """
    dim = "segment" if "segment" in ds[variable].dims else "node"
    cable, values = strand(ds, lines), ds[variable]
    rows, distance = cable.along(dim)
    unit, scale = SHOWN.get(values.attrs["units"], (values.attrs["units"], 1.0))
    over_time = values.ndim > 1
    _shade(ds, cable, ax)
    if over_time:
        extremes = {key: scale * part.values[rows] for key, part in envelope(ds, variable).items()}
        ax.fill_between(
            distance, extremes["minimum"], extremes["maximum"], color=COLOURS[0], alpha=0.25, lw=0, label="extremes"
        )
        ax.plot(distance, extremes["mean"], color=COLOURS[0], lw=1.0, label="mean")
    first = (values[0] if over_time else values).values[rows]
    label = "static" if ds.attrs["start"] == "static" else "at time 0"
    ax.plot(distance, scale * first, color="black", lw=1.0, label=label)
    plain(ax)
    ax.set_xlim(0.0, distance[-1] if dim == "node" else cable.distance[-1])
    if variable in ("curvature", "bending_moment"):
        ax.set_ylim(bottom=0.0)
    if variable == "curvature":
        _limit(ds, cable, ax)
    ax.set_xlabel("distance from the hang-off (m)", fontsize=9)
    ax.set_ylabel(f"{variable.removeprefix('segment_').removeprefix('node_').replace('_', ' ')} ({unit})", fontsize=9)
    return ax


def _shade(ds: xr.Dataset, cable: Cable, ax: Axes) -> None:
    """Shade where a cable is thicker than elsewhere."""
    if "outer_diameter" not in ds.coords:
        return
    diameter = ds["outer_diameter"].values[cable.segments]
    half = 0.5 * ds["unstretched_length"].values[cable.segments]
    thick = np.concatenate([[False], diameter > 1.02 * diameter.min(), [False]])
    starts, stops = np.flatnonzero(np.diff(thick.astype(int)) > 0), np.flatnonzero(np.diff(thick.astype(int)) < 0) - 1
    for a, b in zip(starts, stops, strict=True):
        span = cable.middles[a] - half[a], cable.middles[b] + half[b]
        label = "thicker" if a == starts[0] else None
        ax.axvspan(*span, color=QUIET, alpha=0.15, lw=0, zorder=0, label=label)


def _limit(ds: xr.Dataset, cable: Cable, ax: Axes) -> None:
    """Draw the largest curvature that is allowed, or say it."""
    if "allowed_bend_radius" not in ds.coords:
        return
    radius = ds["allowed_bend_radius"].values[cable.nodes]
    allowed = np.where(radius > 0.0, 1.0 / np.maximum(radius, 1e-12), np.nan)
    if np.nanmin(allowed) * CLOSE < ax.get_ylim()[1]:
        ax.plot(cable.distance, allowed, "--", color=LIMIT, lw=1.2, label="allowed")
        ax.set_ylim(top=1.1 * max(float(np.nanmin(allowed)), ax.get_ylim()[1] / 1.1))
    else:
        ax.set_ylim(top=1.15 * ax.get_ylim()[1])  # room for the note
        text = f"allowed: {np.nanmin(allowed):.3g} 1/m, off the scale (radius {radius.max():g} m)"
        ax.text(0.99, 0.97, text, transform=ax.transAxes, ha="right", va="top", fontsize=8, color=LIMIT)
