"""Rasters of the seabed as they come: GeoTIFF, Esri ASCII, NetCDF (GEBCO, EMODnet) and lists of x, y, z.

Every reader gives heights upwards at the centres of cells, with both axes increasing; cells without data are NaN. Only
GeoTIFF needs rasterio (extra `geo`).
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

from moorage.errors import ModelError, Problem, Source
from moorage.io.text import COMMENT, is_number, read_text, to_float

GEO = "install it: pip install moorage[geo]"
SCATTERED = 4.0  # more cells than this for each point: no grid


class Raster(NamedTuple):
    """Heights at the centres of cells."""

    x: np.ndarray  # (nx,) increasing, in the file's coordinates
    y: np.ndarray  # (ny,)
    z: np.ndarray  # (nx, ny) m, upwards; NaN: no data
    crs: str  # coordinate system as the file names it, "" when it does not
    down: bool  # whether the file says that its values are depths; z is turned up already


def read_raster(path: Path, source: Source | None = None) -> Raster:
    """Read a raster by the ending of its name.

    Parameters
    ----------
    source : Source, optional
        Where the file was named.

    Raises
    ------
    ModelError
        The file is not there, or is not what its name says.
    """
    reader = READERS.get(path.suffix.lower())
    place = source or Source(str(path))
    if reader is None:
        known = ", ".join(READERS)
        raise _wrong("kind of the raster is not known by its name", f"give a file that ends in {known}", place, path)
    if not path.is_file():
        raise _wrong(f"raster not found: tried {path}", "correct the name, or put the file there", place)
    x, y, z, crs, down = reader(path)
    if min(z.shape) < 2:
        raise _wrong(f"raster has {z.shape[0]} by {z.shape[1]} cells", "give at least 2 by 2", Source(str(path)))
    along, across = np.argsort(x), np.argsort(y)
    x, y = x[along], y[across]
    if not (np.all(np.diff(x) > 0.0) and np.all(np.diff(y) > 0.0)):
        raise _wrong("coordinates of the raster are given twice", "give each x and y once", Source(str(path)))
    z = z[np.ix_(along, across)]
    return Raster(x, y, -z if down else z, crs, down)


def _wrong(message: str, remedy: str, source: Source, value: object = None) -> ModelError:
    return ModelError(Problem(message, remedy, source, None if value is None else str(value)))


def _geotiff(path: Path) -> Raster:
    try:
        import rasterio  # noqa: PLC0415 (optional)
        from rasterio.errors import RasterioIOError  # noqa: PLC0415 (optional)
    except ImportError:
        raise _wrong("GeoTIFF needs rasterio", GEO, Source(str(path))) from None
    try:
        with rasterio.open(path) as file:
            band = file.read(1, masked=True)
            to, crs = file.transform, file.crs.to_wkt() if file.crs else ""
    except RasterioIOError as error:
        raise _wrong(f"GeoTIFF cannot be read: {error}", "give a GeoTIFF", Source(str(path))) from None
    if to.b or to.d:
        remedy = "warp it to the north first: gdalwarp -t_srs EPSG:... in.tif out.tif"
        raise _wrong("GeoTIFF is turned against its axes", remedy, Source(str(path)))
    rows, columns = band.shape
    x, y = to.c + to.a * (np.arange(columns) + 0.5), to.f + to.e * (np.arange(rows) + 0.5)
    return Raster(x, y, np.ma.filled(band.astype(float), np.nan).T, crs, False)


def _esri(path: Path) -> Raster:
    """Read an Esri ASCII grid; its rows come from the north. The system is that of a .prj file beside it."""
    head: dict[str, float] = {}
    lines = read_text(path, "raster").splitlines()
    for first, line in enumerate(lines):
        words = line.split()
        if len(words) != 2 or is_number(words[0]):
            break
        if not is_number(words[1]):
            raise _wrong(
                f"{words[0]} of the raster is not a number", "correct it", Source(str(path), first + 1), words[1]
            )
        head[words[0].lower()] = to_float(words[1])
    columns, rows = (int(head.get(name, 0)) for name in ("ncols", "nrows"))
    dx, dy = head.get("dx", head.get("cellsize", 0.0)), head.get("dy", head.get("cellsize", 0.0))
    if min(columns, rows) < 1 or min(dx, dy) <= 0.0:
        raise _wrong("header of the raster lacks ncols, nrows or cellsize", "add them", Source(str(path)))
    corner = []
    for axis, step in (("x", dx), ("y", dy)):
        if f"{axis}llcenter" in head:
            corner.append(head[f"{axis}llcenter"])
        elif f"{axis}llcorner" in head:
            corner.append(head[f"{axis}llcorner"] + 0.5 * step)
        else:
            raise _wrong(f"header of the raster lacks {axis}llcorner", "add it", Source(str(path)))
    values = _numbers(lines[first:], first, path)
    if len(values) != rows * columns:
        message = f"raster has {len(values)} values"
        raise _wrong(message, f"give {rows} rows of {columns} (nrows, ncols)", Source(str(path)))
    z = values.reshape(rows, columns)[::-1].T.copy()
    z[z == head.get("nodata_value", -9999.0)] = np.nan
    beside = path.with_suffix(".prj")
    crs = beside.read_text("utf-8", errors="replace").strip() if beside.is_file() else ""
    return Raster(corner[0] + dx * np.arange(columns), corner[1] + dy * np.arange(rows), z, crs, False)


def _numbers(lines: list[str], first: int, path: Path) -> np.ndarray:
    """Return all numbers of lines; `first` is the number of the line before them."""
    values: list[float] = []
    for k, line in enumerate(lines):
        try:
            values.extend(map(float, line.split()))
        except ValueError:
            raise _wrong(
                "row of the raster is not numbers", "correct it", Source(str(path), first + k + 1), line
            ) from None
    return np.array(values)


def _points(path: Path) -> Raster:
    """Read a list of x, y and z, with blanks, commas or semicolons between; what is before the numbers is a header."""
    table: list[tuple[float, ...]] = []
    for k, line in enumerate(read_text(path, "raster").splitlines()):
        words = COMMENT.sub("", line).replace(",", " ").replace(";", " ").split()
        try:
            row = tuple(map(float, words))
        except ValueError:
            row = ()
        if len(row) == 3:
            table.append(row)
        elif words and table:
            raise _wrong("row of the raster is not x, y and z", "correct it", Source(str(path), k + 1), line.strip())
    if not table:
        raise _wrong("raster has no rows of x, y and z", "give one row for each point", Source(str(path)))
    points = np.array(table)
    (x, i), (y, j) = (np.unique(points[:, axis], return_inverse=True) for axis in (0, 1))
    if len(x) * len(y) > SCATTERED * len(points):
        message = f"the {len(points)} points of the raster are scattered: they have {len(x)} x and {len(y)} y"
        raise _wrong(message, "grid them first (gdal_grid, GMT's surface)", Source(str(path)))
    if len(np.unique(i * len(y) + j)) < len(points):
        raise _wrong("point of the raster is given twice", "remove one", Source(str(path)))
    z = np.full((len(x), len(y)), np.nan)
    z[i, j] = points[:, 2]
    return Raster(x, y, z, "", False)


NAMES = {"x": ("x", "lon", "longitude", "easting"), "y": ("y", "lat", "latitude", "northing")}
HEIGHTS = ("elevation", "z", "height", "depth", "band1", "altitude", "topo", "bathymetry")


def _netcdf(path: Path) -> Raster:
    """Read the heights of a NetCDF file: the variable over two axes, by their usual names."""
    import netCDF4  # noqa: PLC0415 (slow to load, and few models have a raster)

    try:
        file = netCDF4.Dataset(path)
    except OSError as error:
        raise _wrong(f"NetCDF cannot be read: {error}", "give a NetCDF file", Source(str(path))) from None
    with file:
        axes = {a: next((n for n in file.variables if n.lower() in NAMES[a] and file[n].ndim == 1), "") for a in "xy"}
        grids = [n for n in file.variables if sorted(file[n].dimensions) == sorted(axes.values())]
        named = [n for n in grids if n.lower() in HEIGHTS] or grids
        if not all(axes.values()) or not named:
            remedy = "give axes x and y (or lon and lat) and a variable elevation over both"
            raise _wrong("NetCDF has no heights over two axes", remedy, Source(str(path)))
        if len(named) > 1:
            raise _wrong(f"NetCDF has several grids: {', '.join(named)}", "keep one", Source(str(path)))
        heights = file[named[0]]
        z: np.ndarray = np.ma.filled(np.ma.asarray(heights[...], dtype=float), np.nan)
        if heights.dimensions[0] == axes["y"]:
            z = z.T
        x, y = (np.ma.getdata(file[axes[a]][...]).astype(float) for a in "xy")
        degrees = any("degree" in str(getattr(file[axes[a]], "units", "")).lower() for a in "xy")
        crs = _grid_mapping(file, heights) or ("EPSG:4326" if degrees else "")
        down = getattr(heights, "positive", "") == "down" or "depth" in f"{named[0]} {_standard_name(heights)}".lower()
    return Raster(x, y, z, crs, down)


def _standard_name(variable) -> str:
    return str(getattr(variable, "standard_name", ""))


def _grid_mapping(file, heights) -> str:
    """Return the coordinate system by CF's grid mapping, or GDAL's."""
    mapping = file.variables.get(getattr(heights, "grid_mapping", ""))
    return str(getattr(mapping, "crs_wkt", getattr(mapping, "spatial_ref", ""))) if mapping is not None else ""


READERS: dict[str, Callable[[Path], Raster]] = {
    ".tif": _geotiff,
    ".tiff": _geotiff,
    ".asc": _esri,
    ".nc": _netcdf,
    ".xyz": _points,
    ".csv": _points,
    ".txt": _points,
}
