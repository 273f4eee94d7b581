"""How far bodies and rods go over time."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes

from moorage.plot.style import draw_curves


def ways(ds: xr.Dataset) -> dict[str, np.ndarray]:
    """Return how far each body (its reference point) and rod (its end A) is from where it was at first, (time,), m.

    Rods of no length are clamps and joints of cables, and are left out.
    """
    found: dict[str, np.ndarray] = {}
    if "body_position" in ds and "time" in ds["body_position"].dims:
        place = ds["body_position"].transpose("body", "time", "xyz").values
        found |= {f"body {id}": way(one) for id, one in zip(ds["body"].values, place, strict=True)}
    if "rod_position" in ds and "time" in ds["rod_position"].dims:
        ends = ds["rod_position"].transpose("rod", "rod_end", "time", "xyz").values
        long = [not np.array_equal(a[0], b[0]) for a, b in ends]
        found |= {f"rod {id}": way(a) for id, (a, _), has in zip(ds["rod"].values, ends, long, strict=True) if has}
    return found


def way(place: np.ndarray) -> np.ndarray:
    """Return the distance (time,) of places (time, 3) from the first, m."""
    return np.linalg.norm(place - place[0], axis=-1)


def plot_travel(ds: xr.Dataset, ax: Axes) -> Axes:
    """Draw how far bodies and rods are from where they were at first, m; of many, those that go farthest stand out."""
    drawn = ways(ds)
    names, values, time = list(drawn), np.stack(list(drawn.values()), axis=1), ds["time"].values
    draw_curves(ax, time, names, values, "others")
    ax.set_xlim(time[0], max(time[-1], time[0] + 1e-9))
    ax.set_ylim(0.0, 1.05 * max(float(values.max()), 1e-3))
    ax.set_xlabel("time (s)", fontsize=9)
    ax.set_ylabel("way from the start (m)", fontsize=9)
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=7, frameon=False, fontsize=8, borderaxespad=0.2)
    return ax
