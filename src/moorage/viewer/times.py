"""Which instants of a result a page shows."""

from __future__ import annotations

import numpy as np
import xarray as xr

MOST_BYTES = 13_000_000  # of all frames together, before they are compressed: a page never grows beyond 20 MB
MOST_FRAMES = 40_000
MOST_HISTORY = 100_000  # values of the tensions at the ends of all lines
BYTES = 2  # of a value


def with_time(ds: xr.Dataset) -> xr.Dataset:
    """Return a result with its complete instants only, or a static solution as an instant at time 0.

    The last rows of a run that was killed may be missing, and read as NaN.
    """
    if "time" not in ds["fairlead_tension"].dims:
        return ds.expand_dims(time=[0.0])
    held = {node_dim(ds): ds["node_position"][:, :1, 0], "time": ds["fairlead_tension"].transpose("time", ...)[:, :1]}
    return ds.isel({dim: np.isfinite(values.values).all(axis=-1) for dim, values in held.items()})


def node_dim(ds: xr.Dataset) -> str:
    """Return the time dimension of node histories."""
    return str(ds["node_position"].dims[0])


def shown_frames(time: np.ndarray, values: int) -> tuple[slice, str]:
    """Return which of the saved instants (n,) are shown, with a note when not all of them are.

    Parameters
    ----------
    values : int
        Numbers of a frame.
    """
    most = min(max(2, MOST_BYTES // (BYTES * max(values, 1))), MOST_FRAMES)
    step = -(-len(time) // most)
    if step <= 1:
        return slice(0, len(time)), ""
    interval = (time[-1] - time[0]) / (len(time) - 1) * step
    return slice(0, len(time), step), (
        f"The result is large: 1 of {step} saved instants is shown, one every {interval:.3g} s. "
        "Tension histories keep their extremes."
    )


def interpolated(values: np.ndarray, at: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Return values (n, ...) known at times (n,) at other times (m,), linear between them."""
    if len(at) == 1:
        return np.repeat(values, len(time), axis=0)
    k = np.clip(np.searchsorted(at, time, side="right") - 1, 0, len(at) - 2)
    share = np.clip((time - at[k]) / (at[k + 1] - at[k]), 0.0, 1.0).reshape(-1, *[1] * (values.ndim - 1))
    return values[k] + share * (values[k + 1] - values[k])


def end_tensions(ds: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Return times (n,) s, and tensions (n, 2 lines) kN at ends A and B of the lines, one line after the other.

    Of long histories the lowest and the highest value of every bin are kept.
    """
    time = ds["time"].values
    both = np.stack([ds[f"{end}_tension"].transpose("time", "line").values for end in ("anchor", "fairlead")], axis=-1)
    table = both.reshape(len(time), -1) / 1e3
    known = np.isfinite(table).all(axis=1)
    time, table = time[known], table[known]
    bins = max(50, MOST_HISTORY // max(2 * table.shape[1], 1))
    if len(time) <= 2 * bins:
        return time, table
    edges = np.linspace(0, len(time), bins, endpoint=False).astype(int)
    extremes = np.stack([f.reduceat(table, edges, axis=0) for f in (np.minimum, np.maximum)], axis=1)
    return np.repeat(time[edges], 2), extremes.reshape(2 * bins, -1)
