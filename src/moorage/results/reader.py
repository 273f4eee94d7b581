"""Results back from disk."""

from __future__ import annotations

from pathlib import Path

import xarray as xr

from moorage.errors import Problem, ResultError


def open_result(path: str | Path) -> xr.Dataset:
    """Open a result that `simulate` wrote; values are read when they are used."""
    path = Path(path)
    if not path.exists():
        raise ResultError(Problem(f"{path} does not exist", "give the .nc file that a run wrote"))
    try:
        ds = xr.open_dataset(path, engine="netcdf4")
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or error
        raise ResultError(Problem(f"cannot read {path}: {why}", "give the .nc file that a run wrote")) from error
    if "moorage_version" not in ds.attrs:
        ds.close()
        raise ResultError(Problem(f"{path} is no result of Moorage", "give the .nc file that a run wrote"))
    return ds
