"""Extremes over time along the arc length of lines."""

from __future__ import annotations

import xarray as xr

from moorage.errors import Problem, ResultError

ALONG = ("node", "segment")
TIMES = ("time", "node_time")


def envelope(ds: xr.Dataset, name: str, start: float = 0.0) -> xr.Dataset:
    """Return `minimum`, `mean` and `maximum` over time of a quantity along the lines.

    Parameters
    ----------
    ds : xarray.Dataset
        A result, or the part of one line (`moorage.line`).
    name : str
        A quantity of nodes or segments: segment_tension, curvature, bending_moment, node_declination, ...
    start : float
        Leave out what was before that time, s. A static solution is its own envelope.

    Returns
    -------
    xarray.Dataset
        The three over `node` or `segment`, with the arc length and what else is known of these as coordinates.

    Examples
    --------
    >>> worst = moorage.envelope(moorage.line(ds, 1), "curvature")["maximum"]  # doctest: +SKIP
    """
    along = [str(n) for n, variable in ds.data_vars.items() if set(ALONG) & set(variable.dims)]
    if name not in along:
        known = ", ".join(along) or "none: it was saved without histories of nodes"
        raise ResultError(Problem("the result has no such quantity along its lines", f"it has {known}", value=name))
    values = ds[name]
    time = next((dim for dim in values.dims if dim in TIMES), None)
    if time is None:
        parts = {"minimum": values, "mean": values, "maximum": values}
    else:
        values = values.isel({time: ds[time].values >= start})
        if not values.sizes[time]:
            last = float(ds[time].values[-1])
            raise ResultError(Problem("nothing is left after the start", f"the result ends at {last:g} s", value=start))
        parts = {"minimum": values.min(time), "mean": values.mean(time), "maximum": values.max(time)}
    units, what = ds[name].attrs["units"], ds[name].attrs["long_name"]
    named = {key: part.assign_attrs(units=units, long_name=f"{key} over time of {what}") for key, part in parts.items()}
    return xr.Dataset(named).drop_vars(TIMES, errors="ignore")
