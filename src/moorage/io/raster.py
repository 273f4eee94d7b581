"""A raster of the seabed onto a grid in the model's axes.

The model's x axis points along a compass heading h (clockwise from the grid's north), its y axis 90 degrees to the left
of it, so that a place (x, y) is at the easting E0 + x sin h - y cos h and the northing N0 + x cos h + y sin h. Depths
between the centres of cells are bilinear; what that costs on a spacing other than the raster's is measured at the
centres of all cells that the grid covers.
"""

from __future__ import annotations

from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np

from moorage.errors import ModelError, Problem, Source
from moorage.io.coordinates import Move, to_file
from moorage.io.raster_files import Raster, read_raster
from moorage.model import Bathymetry, Resampling

MOST = 4_000_000  # points of a grid
SCALES = np.linspace(1.0, 0.0, 201)  # of the box around the raster, tried from the largest
Fill = float | Literal["nearest"]


def read_bathymetry(
    path: str | Path,
    *,
    origin: tuple[float, float] = (0.0, 0.0),
    heading: float = 90.0,
    spacing: float | None = None,
    extent: tuple[float, float, float, float] | None = None,
    fill: Fill | None = None,
    crs: str | None = None,
    file_crs: str | None = None,
    water_level: float = 0.0,
    smooth: bool = False,
    source: Source | None = None,
) -> Bathymetry:
    """Read a raster of the seabed onto a depth grid in the model's axes.

    Parameters
    ----------
    path : path
        GeoTIFF (.tif), Esri ASCII (.asc), NetCDF (.nc) or a list of x, y and z (.xyz, .csv, .txt). Heights are upwards,
        unless a NetCDF file says that they are depths.
    origin : (2,)
        Easting and northing of the model's origin, m, in `crs`.
    heading : float
        Compass heading of the model's x axis, degrees clockwise from the grid's north; 90 for x to the east.
    spacing : float, optional
        Of the depth grid, m; by default that of the raster.
    extent : (4,), optional
        x and y of the depth grid: lowest x, highest x, lowest y, highest y, m. By default the largest rectangle around
        the raster's middle that the raster covers.
    fill : float or "nearest", optional
        Depth (m) of cells without data and of what the raster does not cover, or that of the nearest cell with data.
        Without it, cells without depth are an error.
    crs : str, optional
        Coordinate system of the origin, in metres ("EPSG:32631", WKT, or "metres" for a grid of its own); by default
        that of the file.
    file_crs : str, optional
        Coordinate system of the file, when it does not name one.
    water_level : float
        Height of the still water in the heights of the file, m.
    smooth : bool
        Whether the seabed is bicubic between the points of the grid.
    source : Source, optional
        Where the raster was named, for messages.

    Returns
    -------
    Bathymetry
        Its `resampling` tells the error at the centres of the raster's cells.

    Raises
    ------
    ModelError
        The file cannot be read, its coordinate system is missing or not in metres, or cells have no depth.
    """
    path = Path(path)
    place = source or Source(str(path))
    where = Where(origin, heading, spacing, extent, crs, file_crs)
    height: Fill | None = fill if fill is None or isinstance(fill, str) else water_level - fill
    x, y, level, report = onto_grid(path, where, height, ("depth grid", "depth"), place)
    depth = tuple(map(tuple, (water_level - level).tolist()))
    return Bathymetry(tuple(x.tolist()), tuple(y.tolist()), depth, smooth, path.name, place, report)


class Where(NamedTuple):
    """Where a grid lies in the coordinates of a raster; see `read_bathymetry`."""

    origin: tuple[float, float] = (0.0, 0.0)
    heading: float = 90.0
    spacing: float | None = None
    extent: tuple[float, float, float, float] | None = None
    crs: str | None = None
    file_crs: str | None = None


def onto_grid(path: Path, where: Where, fill: Fill | None, words: tuple[str, str], place: Source):
    """Return x (nx,), y (ny,), the values (nx, ny) of a raster there, and what was lost.

    `words` are what messages call the grid and its values; `fill` is a value of the raster, or "nearest".
    """
    name, thing = words
    if isinstance(fill, str) and fill != "nearest":
        raise ModelError(Problem(f"fill of the {name} is not known", f"give nearest or a {thing}", place, fill))
    raster = read_raster(path, place)
    forth, back = to_file(raster, where.crs, where.file_crs, place)
    axes = Axes(where.origin, where.heading, forth, back)
    filled = raster._replace(z=_fill(raster.z, fill))
    x, y = _grid(raster, axes, where, name, place)
    east, north = axes.to_raster(*np.meshgrid(x, y, indexing="ij"))
    values = bilinear(filled, east, north, beyond=fill is not None)
    if isinstance(fill, int | float):
        values[~covers(raster, east, north)] = fill
    holes = np.argwhere(~np.isfinite(values))
    if len(holes):
        message = f"{len(holes)} of {values.size} points of the {name} have no {thing} in {path.name}"
        remedy = f"give a smaller extent, or fill: nearest (or a {thing})"
        i, j = holes[0]
        raise ModelError(Problem(f"{message}, the first at x {x[i]:g} m, y {y[j]:g} m", remedy, place))
    return x, y, values, _resampling(raster, axes, Raster(x, y, values, "", False))


class Axes:
    """The model's axes: from x, y (m) to the coordinates of a raster and back."""

    def __init__(self, origin: tuple[float, float], heading: float, forth: Move, back: Move):
        self.origin, self.forth, self.back = origin, forth, back
        quarter = round(heading / 90.0)  # of full and quarter turns, sine and cosine are exact
        h = np.deg2rad(heading)
        whole = heading == 90.0 * quarter
        self.sin = (0.0, 1.0, 0.0, -1.0)[quarter % 4] if whole else float(np.sin(h))
        self.cos = (1.0, 0.0, -1.0, 0.0)[quarter % 4] if whole else float(np.cos(h))

    def to_raster(self, x, y):
        """Return the coordinates in the raster of places in the model."""
        return self.forth(self.origin[0] + x * self.sin - y * self.cos, self.origin[1] + x * self.cos + y * self.sin)

    def to_model(self, x, y):
        """Return the places in the model of coordinates in the raster."""
        east, north = self.back(x, y)
        e, n = np.asarray(east) - self.origin[0], np.asarray(north) - self.origin[1]
        return e * self.sin + n * self.cos, n * self.sin - e * self.cos


def _fill(z: np.ndarray, fill: Fill | None) -> np.ndarray:
    """Return values with those that are missing filled in."""
    missing = ~np.isfinite(z)
    if fill is None or not missing.any():
        return z
    if fill != "nearest":
        return np.where(missing, fill, z)
    from scipy.ndimage import distance_transform_edt  # noqa: PLC0415 (slow to load, and few rasters have holes)

    nearest = distance_transform_edt(missing, return_distances=False, return_indices=True)
    return z[tuple(nearest)]


def _grid(raster: Raster, axes: Axes, where: Where, name: str, place: Source) -> tuple[np.ndarray, np.ndarray]:
    """Return x and y of the grid."""
    step = _spacing(raster, axes) if where.spacing is None else where.spacing
    if not step > 0.0:
        raise ModelError(Problem(f"spacing of the {name} must be positive", "give metres", place, step))
    x0, x1, y0, y1 = _covered(raster, axes) if where.extent is None else where.extent
    nx, ny = (int(np.floor((b - a) / step + 1e-9)) + 1 for a, b in ((x0, x1), (y0, y1)))
    if min(nx, ny) < 2:
        message = f"extent of the {name} is smaller than its spacing of {step:g} m"
        raise ModelError(Problem(message, "give lowest x, highest x, lowest y, highest y", place, (x0, x1, y0, y1)))
    if nx * ny > MOST:
        message = f"{name} would have {nx} by {ny} points"
        raise ModelError(Problem(message, "give a wider spacing, or a smaller extent", place))
    return x0 + step * np.arange(nx), y0 + step * np.arange(ny)


def _spacing(raster: Raster, axes: Axes) -> float:
    """Return the size of the raster's cells at its middle, m: the smaller one, to a hundredth."""
    i, j = len(raster.x) // 2, len(raster.y) // 2
    x, y = axes.to_model(raster.x[[i - 1, i, i - 1]], raster.y[[j - 1, j - 1, j]])
    return float(f"{min(np.hypot(x[1] - x[0], y[1] - y[0]), np.hypot(x[2] - x[0], y[2] - y[0])):.3g}")


def _covered(raster: Raster, axes: Axes) -> tuple[float, float, float, float]:
    """Return the largest rectangle of the box around the raster, scaled about its middle, that the raster covers."""
    x, y = axes.to_model(*(a.ravel() for a in np.meshgrid(raster.x[[0, -1]], raster.y[[0, -1]])))
    middle = np.array([0.5 * (x.min() + x.max()), 0.5 * (y.min() + y.max())])
    half = np.array([0.5 * np.ptp(x), 0.5 * np.ptp(y)])
    edge = np.linspace(-1.0, 1.0, 21)
    rim = np.concatenate([[(s, e), (e, s)] for s in (-1.0, 1.0) for e in edge])
    fits = (s for s in SCALES if covers(raster, *axes.to_raster(*(middle + s * half * rim).T)).all())
    scale = next(fits, 0.0)
    (x0, y0), (x1, y1) = middle - scale * half, middle + scale * half
    return float(x0), float(x1), float(y0), float(y1)


def covers(raster: Raster, x, y) -> np.ndarray:
    """Return whether places are between the centres of the outermost cells, to rounding."""
    inside = np.ones(np.shape(x), dtype=bool)
    for axis, value in ((raster.x, x), (raster.y, y)):
        slack = 1e-6 * (axis[1] - axis[0])
        inside &= (value >= axis[0] - slack) & (value <= axis[-1] + slack)
    return inside


def bilinear(raster: Raster, x, y, beyond: bool = False) -> np.ndarray:
    """Return heights at places of a raster; outside it NaN, or with `beyond` that of the nearest edge."""
    (i, u), (j, v) = (_cell(axis, np.asarray(value)) for axis, value in ((raster.x, x), (raster.y, y)))
    total = np.zeros(i.shape)
    for p, a in ((0, 1.0 - u), (1, u)):
        for q, b in ((0, 1.0 - v), (1, v)):
            weight = a * b
            total += np.where(weight > 0.0, weight * raster.z[i + p, j + q], 0.0)  # a hole without weight is none
    return total if beyond else np.where(covers(raster, x, y), total, np.nan)


def _cell(axis: np.ndarray, value: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the interval of an axis that holds a value, and the place in it; a hair beside a centre is on it."""
    k = np.clip(np.searchsorted(axis, value, side="right") - 1, 0, len(axis) - 2)
    u = np.clip((value - axis[k]) / (axis[k + 1] - axis[k]), 0.0, 1.0)
    return k, np.where(np.abs(u - np.round(u)) < 1e-9, np.round(u), u)


def _resampling(raster: Raster, axes: Axes, grid: Raster) -> Resampling:
    """Return how far the depth grid is from the cells of the raster that it covers."""
    x, y = axes.to_model(*np.meshgrid(raster.x, raster.y, indexing="ij"))
    known = np.isfinite(raster.z) & covers(grid, x, y)
    error = bilinear(grid, x[known], y[known]) - raster.z[known]
    return Resampling(
        spacing=float(grid.x[1] - grid.x[0]),
        cells=int(known.sum()),
        largest=float(np.abs(error).max(initial=0.0)),
        rms=float(np.sqrt(np.mean(error**2))) if len(error) else 0.0,
    )
