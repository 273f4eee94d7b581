"""The seabed around a mooring, as a page draws it."""

from __future__ import annotations

import numpy as np
import xarray as xr

from moorage.results.bed_level import bed_level

MARGIN = 0.1  # around the lines, as a part of their extent
NARROW = 0.4  # no narrower than this part of its length
UPRIGHT = 0.3  # and its length no shorter than this part of the lines' height
FAR, ROUND = 10.0, 1000.0  # extents away from the origin, and what another origin is a multiple of, m
FINEST = 200  # places along its longer side


def region_of(position: np.ndarray) -> np.ndarray:
    """Return the rectangle (x0, y0, x1, y1) to show around nodes (..., 3), m."""
    places = position.reshape(-1, position.shape[-1])
    low, high = places.min(axis=0), places.max(axis=0)
    extent = max(float((high - low)[:2].max()), UPRIGHT * float(high[2] - low[2]), 1.0)
    low, high = low[:2], high[:2]
    half = np.maximum(0.5 * (high - low) + MARGIN * extent, 0.5 * NARROW * extent)
    return np.concatenate([0.5 * (low + high) - half, 0.5 * (low + high) + half])


def origin_of(region: np.ndarray) -> np.ndarray:
    """Return the place (2,), m, from which a page counts x and y: (0, 0), or near a mooring that is far from there.

    A page has the seven digits of single precision: for coordinates of a survey that would be steps of half a metre.
    """
    middle, extent = 0.5 * (region[:2] + region[2:]), float((region[2:] - region[:2]).max())
    return np.round(middle / ROUND) * ROUND if np.abs(middle).max() > FAR * max(extent, ROUND) else np.zeros(2)


def ground(ds: xr.Dataset, region: np.ndarray) -> tuple[dict, np.ndarray, str]:
    """Return numbers of places in a rectangle, their z (nx ny, 1), y fastest, and a note on what is beyond the grid."""
    x0, y0, x1, y1 = region
    if "bed_level" not in ds.coords:
        z = np.full((4, 1), -float(ds.attrs["water_depth"]))
        return {"nx": 2, "ny": 2, "flat": True}, z, ""
    step = max(x1 - x0, y1 - y0) / (FINEST - 1)
    x, y = (np.linspace(a, b, max(2, round((b - a) / step) + 1)) for a, b in ((x0, x1), (y0, y1)))
    z = bed_level(ds, *(v.ravel() for v in np.meshgrid(x, y, indexing="ij")))
    gx, gy = ds["bed_x"].values, ds["bed_y"].values
    inside = gx[0] <= x0 and gx[-1] >= x1 and gy[0] <= y0 and gy[-1] >= y1
    note = "" if inside else "Beyond the depth grid its edge goes on, level."
    return {"nx": len(x), "ny": len(y), "flat": bool(np.ptp(z) < 1e-6)}, z[:, None], note
