"""Maps of the seabed's friction and stiffness from rasters."""

from __future__ import annotations

from pathlib import Path

from moorage.errors import Source
from moorage.io.raster import Fill, Where, onto_grid
from moorage.model import FrictionMap, StiffnessMap


def read_friction_map(
    axial_file: str | Path,
    transverse_file: str | Path | None = None,
    *,
    fill: Fill | None = None,
    source: Source | None = None,
    **where,
) -> FrictionMap:
    """Read rasters of kinetic coefficients onto a grid in the model's axes.

    Parameters
    ----------
    axial_file, transverse_file : path
        Rasters of the coefficients along and across the line, in the formats of `read_bathymetry`; without the second
        both are those of the first. The grid is made from the first.
    fill : float or "nearest", optional
        Coefficient where a raster has none, or that of the nearest cell.
    source : Source, optional
        Where the rasters were named, for messages.
    **where
        origin, heading, spacing, extent, crs and file_crs, as for `read_bathymetry`.

    Raises
    ------
    ModelError
        As `read_bathymetry` does.
    """
    path = Path(axial_file)
    words, place = ("friction map", "coefficient"), source or Source(str(path))
    asked = Where(**where)
    x, y, axial, report = onto_grid(path, asked, fill, words, place)
    if transverse_file is None:
        transverse = axial
    else:
        same = asked._replace(extent=(x[0], x[-1], y[0], y[-1]), spacing=report.spacing)
        transverse = onto_grid(Path(transverse_file), same, fill, words, source or Source(str(transverse_file)))[2]
    return FrictionMap(tuple(x.tolist()), tuple(y.tolist()), _table(axial), _table(transverse), place)


def read_stiffness_map(
    path: str | Path, *, fill: Fill | None = None, source: Source | None = None, **where
) -> StiffnessMap:
    """Read a raster of the seabed's stiffness (Pa/m) onto a grid in the model's axes; parameters as above."""
    path = Path(path)
    place = source or Source(str(path))
    x, y, stiffness, _ = onto_grid(path, Where(**where), fill, ("stiffness map", "stiffness"), place)
    return StiffnessMap(tuple(x.tolist()), tuple(y.tolist()), _table(stiffness), place)


def _table(values) -> tuple[tuple[float, ...], ...]:
    return tuple(map(tuple, values.tolist()))
