"""Currents from NetCDF files by depth, time and place, as ocean models write them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from moorage.errors import ModelError, Problem, Source
from moorage.io.text import Findings
from moorage.model import Current, CurrentGrid

if TYPE_CHECKING:
    import xarray as xr

EARTH = 6.371e6  # m, mean radius
NAMES = {  # of velocities: what CF calls them, and short names
    "u": ("eastward_sea_water_velocity", "sea_water_x_velocity", "uo", "u", "water_u"),
    "v": ("northward_sea_water_velocity", "sea_water_y_velocity", "vo", "v", "water_v"),
    "w": ("upward_sea_water_velocity", "wo", "w", "water_w"),
}
AXES = {
    "t": ("time", "t"),
    "z": ("depth", "z", "height", "lev", "level", "deptht"),
    "y": ("latitude", "lat", "y", "northing", "projection_y_coordinate"),
    "x": ("longitude", "lon", "x", "easting", "projection_x_coordinate"),
}
SPEEDS = ("m/s", "ms-1", "meter/second", "metersecond-1", "meters/second")
SECONDS = {"s": 1.0, "m": 60.0, "h": 3600.0, "d": 86400.0}
TIME = re.compile(r"(s|sec|seconds?|min|minutes?|h|hours?|d|days?)( since (?P<date>.+))?")
Values = dict[str, Any]


def current_of_file(asked: Values, folder: Path, found: Findings) -> Current | CurrentGrid:
    """Return the current of a file; a still one, with problems noted, when there is none."""
    import xarray as xr  # noqa: PLC0415  slow to import, and few models need it

    path = folder / asked["file"]
    if not path.is_file():
        found.add(
            f"file of currents not found: tried {path}", "correct the name, or put the file there", asked["source"]
        )
        return Current()
    try:
        with xr.open_dataset(path, decode_times=False) as ds:
            grid = _grid(ds.load(), path, asked)
    except ModelError as error:
        found.extend(error.problems)
        return Current()
    except (OSError, ValueError) as error:
        found.add(f"file of currents cannot be read: {error}", "give a NetCDF file", Source(str(path)))
        return Current()
    if max(len(grid.t), len(grid.x), len(grid.y)) > 1:
        return grid
    velocity = tuple((u, v, w) for u, v, w in grid.velocity[0, 0, 0].tolist())
    return Current(grid.z, velocity, asked["source"])


def _grid(ds: xr.Dataset, path: Path, asked: Values) -> CurrentGrid:
    """Return the grid of a dataset in the axes of the model; a `ModelError` says why there is none."""
    flow = {name: _find(ds, name, path) for name in "uvw"}
    eastward = flow["u"]
    assert eastward is not None
    axes = {str(dim): _axis_of(ds, str(dim)) for dim in eastward.dims}
    for dim, axis in axes.items():
        if not axis and eastward.sizes[dim] > 1:
            raise _wrong(
                path, "dimension of the currents is not known", "use time, depth, lat and lon, or x and y", dim
            )
    dims = {axis: dim for dim, axis in axes.items() if axis}
    spare = [dim for dim, axis in axes.items() if not axis]
    parts: list[np.ndarray] = []
    for values in flow.values():
        if values is None:
            parts.append(np.zeros_like(parts[0]))
            continue
        if set(values.dims) != set(eastward.dims):
            raise _wrong(path, f"{values.name} has other dimensions than {eastward.name}", "give both on one grid")
        whole = values.isel(dict.fromkeys(spare, 0)).transpose(*(dims[axis] for axis in "txyz" if axis in dims))
        shape = [whole.sizes[dims[axis]] if axis in dims else 1 for axis in "txyz"]
        parts.append(np.asarray(whole.values, float).reshape(shape))
    points = {axis: _points(ds, dims.get(axis), axis, path) for axis in "txyz"}
    if "t" in dims:
        points["t"] = points["t"] - _start(ds[dims["t"]], points["t"], asked, path)
    _to_metres(points, {axis: ds[dim] for axis, dim in dims.items()}, asked, path)
    velocity = np.stack(parts, axis=-1)
    for k, axis in enumerate("txyz"):
        order = np.argsort(points[axis], kind="stable")
        points[axis], velocity = points[axis][order], np.take(velocity, order, axis=k)
        if np.any(np.diff(points[axis]) <= 0.0):
            raise _wrong(path, f"{dims[axis]} has a value twice", "give each once")
    turn = np.deg2rad(asked.get("heading", 90.0) - 90.0)  # of the east against the model's x axis
    east, north = velocity[..., 0].copy(), velocity[..., 1].copy()
    velocity[..., 0], velocity[..., 1] = (
        np.cos(turn) * east - np.sin(turn) * north,
        np.sin(turn) * east + np.cos(turn) * north,
    )
    named = {axis: tuple(values.tolist()) for axis, values in points.items()}
    return CurrentGrid(**named, velocity=filled(velocity), turn=float(turn), file=path.name, source=asked["source"])


def filled(velocity: np.ndarray) -> np.ndarray:
    """Return velocities (..., nz, 3) without missing ones: those below the seabed are those of the level above them.

    Where a whole column is missing, on land, the water is still.
    """
    out = velocity.copy()
    for k in range(out.shape[-2] - 2, -1, -1):
        out[..., k, :] = np.where(np.isnan(out[..., k, :]), out[..., k + 1, :], out[..., k, :])
    for k in range(1, out.shape[-2]):
        out[..., k, :] = np.where(np.isnan(out[..., k, :]), out[..., k - 1, :], out[..., k, :])
    return np.nan_to_num(out, nan=0.0)


def _find(ds: xr.Dataset, name: str, path: Path) -> xr.DataArray | None:
    """Return a component of the velocity; the vertical one may be missing."""
    for known in NAMES[name]:
        for key in map(str, ds.data_vars):
            if key == known or ds[key].attrs.get("standard_name") == known:
                units = str(ds[key].attrs.get("units", ""))
                if _bare(units) in SPEEDS:
                    return ds[key]
                what = f"units of {key} are not known" if units else f"{key} does not say its units"
                raise _wrong(path, what, f"give {key} an attribute units: m/s", units or None)
    if name == "w":
        return None
    raise _wrong(
        path, f"file has no {NAMES[name][0]}", f"name a velocity {NAMES[name][2]}, or give it that standard_name"
    )


def _axis_of(ds: xr.Dataset, dim: str) -> str:
    """Return which axis a dimension is: t, x, y or z; nothing when it is not known."""
    told = str(ds[dim].attrs.get("standard_name", "")) if dim in ds else ""
    return next((axis for axis, names in AXES.items() if dim.lower() in names or told in names), "")


def _points(ds: xr.Dataset, dim: str | None, axis: str, path: Path) -> np.ndarray:
    """Return the coordinates along an axis: seconds from the file's own beginning, or metres or degrees."""
    if dim is None:
        return np.zeros(1)
    if dim not in ds:
        raise _wrong(path, f"{dim} has no values", f"give a variable {dim}({dim})")
    values, units = np.asarray(ds[dim].values, float), str(ds[dim].attrs.get("units", "")).strip()
    if axis == "t":
        told = TIME.fullmatch(units)
        if told is None:
            raise _wrong(path, f"units of {dim} are not known", "write seconds since 2020-01-31", units or None)
        return values * SECONDS["m" if units.startswith("min") else units[0]]
    if axis == "z":
        if _bare(units) not in ("m", "meter", "meters", "metre", "metres"):
            raise _wrong(path, f"units of {dim} are not known", f"give {dim} an attribute units: m", units or None)
        down = str(ds[dim].attrs.get("positive", "")).lower() == "down" or (
            "positive" not in ds[dim].attrs and values.max() > 0.0
        )
        return -values if down else values
    if not (units.lower().startswith("degree") or _bare(units) in ("m", "meter", "meters", "metre", "metres")):
        raise _wrong(
            path, f"units of {dim} are not known", f"give {dim} an attribute units: m, or degrees_east", units or None
        )
    return values


def _start(time: xr.DataArray, seconds: np.ndarray, asked: Values, path: Path) -> float:
    """Return the time 0 of the run in seconds of the file."""
    if "start" not in asked:
        return float(seconds.min())
    told = TIME.fullmatch(str(time.attrs["units"]).strip())
    assert told is not None
    try:
        begin = np.datetime64(asked["start"].rstrip("Z"))
    except ValueError:
        raise ModelError(
            Problem("start of the current is not a date", "write 2020-01-31T12:00", asked["source"], asked["start"])
        ) from None
    if told["date"] is None:
        raise _wrong(path, "times of the file are without a date, and start is one", "leave start out", asked["start"])
    date = re.sub(r"(\.0+)?( ?UTC|Z| ?\+00:?00)?$", "", told["date"].strip()).replace(" ", "T")
    date = re.sub(r"^(\d+)-(\d+)-(\d+)", lambda m: f"{int(m[1]):04d}-{int(m[2]):02d}-{int(m[3]):02d}", date)
    since = float((begin - np.datetime64(date)) / np.timedelta64(1, "s"))
    if not seconds.min() <= since <= seconds.max():
        first, last = (np.datetime64(date) + np.timedelta64(round(s), "s") for s in (seconds.min(), seconds.max()))
        raise _wrong(
            path, "start of the current is not in the file", f"give a time from {first} to {last}", asked["start"]
        )
    return since


def _to_metres(points: dict[str, np.ndarray], named: dict[str, xr.DataArray], asked: Values, path: Path) -> None:
    """Turn x and y in the file's coordinates into metres east and north of the model's origin, in place."""
    degrees = {axis: str(named[axis].attrs["units"]).lower().startswith("degree") for axis in "xy" if axis in named}
    origin = asked.get("origin", None if any(degrees.values()) else (0.0, 0.0))
    if origin is None and all(len(points[axis]) == 1 for axis in "xy"):
        origin = (float(points["x"][0]), float(points["y"][0]))  # one place: it is that of the model
    if origin is None or len(origin) != 2:
        raise ModelError(
            Problem("the current's file is in degrees, and origin says not where the model is",
                    "give origin: [longitude, latitude]", asked["source"], asked.get("origin"))
        )  # fmt: skip
    scale = np.deg2rad(EARTH)
    for axis, place, metres in (("x", origin[0], scale * np.cos(np.deg2rad(origin[1]))), ("y", origin[1], scale)):
        if axis in named:
            points[axis] = (points[axis] - place) * (metres if degrees[axis] else 1.0)


def _bare(units: str) -> str:
    """Return units without blanks and marks of powers and products."""
    return re.sub(r"[\s^{}.*_]", "", units.lower())


def _wrong(path: Path, message: str, remedy: str, value: object = None) -> ModelError:
    return ModelError(Problem(message, remedy, Source(str(path)), value))
