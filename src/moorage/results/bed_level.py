"""The level of the seabed under a result, for pictures."""

from __future__ import annotations

import numpy as np
import xarray as xr

from moorage.physics.bathymetry import bed_at, grid_bed


def bed_level(ds: xr.Dataset, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return z of the seabed (m) of a result at places x and y (n,)."""
    if "bed_level" not in ds.coords:
        return np.full(np.shape(x), -float(ds.attrs["water_depth"]))
    smooth = ds.attrs["bathymetry_interpolation"] == "bicubic"
    bed = grid_bed(ds["bed_x"].values, ds["bed_y"].values, -ds["bed_level"].values, smooth)
    return np.array([bed_at(bed, float(a), float(b))[0] for a, b in zip(x, y, strict=True)])
