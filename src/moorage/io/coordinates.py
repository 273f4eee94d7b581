"""Coordinate systems of rasters and of the model's origin: metres or not, and from one to the other (extra `geo`)."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from moorage.errors import ModelError, Problem, Source
from moorage.io.raster_files import GEO, Raster

METRES = "metres"  # the name of a grid of its own
DEGREES = ("EPSG:4326", "EPSG:4258", "EPSG:4269", "OGC:CRS84")

Move = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]


def unit_of(crs: str) -> str:
    """Return the unit of a coordinate system, "metre", "degree" or another; without pyproj as far as its text tells."""
    if crs.lower() == METRES:
        return "metre"
    try:
        from pyproj import CRS  # noqa: PLC0415 (optional)
        from pyproj.exceptions import CRSError  # noqa: PLC0415 (optional)
    except ImportError:
        return _unit_by_text(crs)
    try:
        axes = CRS.from_user_input(crs).axis_info
    except CRSError:
        return ""
    return axes[0].unit_name if axes else ""


def _unit_by_text(crs: str) -> str:
    if crs.upper() in DEGREES or crs.upper().startswith("GEOG"):
        return "degree"
    if crs.upper().startswith("PROJ"):
        found = re.findall(r'(?:LENGTH)?UNIT\["([^"]+)"', crs, re.IGNORECASE)
        return (found[-1] if found else "metre").lower().replace("meter", "metre")
    return "metre"  # a code or a name; that it is not in degrees shows in the numbers


def to_file(raster: Raster, crs: str | None, file_crs: str | None, place: Source) -> tuple[Move, Move]:
    """Return the moves from the system of the model's origin, in metres, to the raster's coordinates, and back.

    Parameters
    ----------
    crs : str or None
        System of the origin; by default that of the raster.
    file_crs : str or None
        System of the raster, when its file does not name it.
    """
    theirs = raster.crs or file_crs or crs or ""
    ours = crs or theirs
    if not theirs:
        remedy = f"give crs, such as EPSG:32631, or crs: {METRES} for a grid of its own in metres"
        raise ModelError(Problem("raster has no coordinate system", remedy, place))
    for name in {theirs, ours}:
        if not unit_of(name):
            raise ModelError(Problem("coordinate system is not known", "give an EPSG code or WKT", place, _short(name)))
    if unit_of(ours) not in ("metre", "meter") or (ours == theirs and _looks_like_degrees(raster)):
        remedy = "give crs, the system in metres in which the origin is, such as EPSG:32631"
        remedy += "" if raster.crs else ", and file_crs, that of the file, such as EPSG:4326"
        word = "is in degrees" if _looks_like_degrees(raster) else f"has the unit {unit_of(ours)}"
        raise ModelError(Problem(f"coordinate system {word} where metres are needed", remedy, place, _short(ours)))
    if ours.lower() == theirs.lower() or theirs.lower() == METRES:
        return _same, _same
    if ours.lower() == METRES:
        remedy = f"give crs as an EPSG code or WKT, or leave it out for that of the file, {_short(theirs)}"
        raise ModelError(Problem(f"a grid of its own has no place in {_short(theirs)}", remedy, place))
    try:
        from pyproj import CRS, Transformer  # noqa: PLC0415 (optional)
    except ImportError:
        message = f"going from {_short(ours)} to the file's {_short(theirs)} needs pyproj"
        raise ModelError(Problem(message, f"{GEO}, or give the file in {_short(ours)}", place)) from None
    there, here = CRS.from_user_input(theirs), CRS.from_user_input(ours)
    forth = Transformer.from_crs(here, there, always_xy=True).transform
    back = Transformer.from_crs(there, here, always_xy=True).transform
    return forth, back


def _same(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return x, y


def _looks_like_degrees(raster: Raster) -> bool:
    """Return whether all coordinates could be degrees and the cells are far too fine for metres."""
    small = np.abs(raster.x).max() <= 360.0 and np.abs(raster.y).max() <= 90.0
    return bool(small and np.diff(raster.x).min() < 0.5)


def _short(crs: str) -> str:
    """Return a code, or the name within a WKT."""
    name = re.search(r'"([^"]+)"', crs)
    return name[1] if name and len(crs) > 40 else crs
