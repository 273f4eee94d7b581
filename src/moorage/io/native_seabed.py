"""Depths and properties of the seabed in native files: written out, or in rasters."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from moorage.errors import ModelError
from moorage.io.property_maps import read_friction_map, read_stiffness_map
from moorage.io.raster import read_bathymetry
from moorage.io.text import Findings
from moorage.io.yaml_nodes import Values
from moorage.model import Bathymetry, FrictionMap, StiffnessMap


def bathymetry_of(values: Values, folder: Path, found: Findings) -> Bathymetry | None:
    """Return the depth grid that is written out or in a raster; None, with problems noted, when there is none."""
    if "file" not in values:
        return Bathymetry(**values)
    return _from_raster(read_bathymetry, ("file",), values, folder, found, "bathymetry")


def friction_map_of(values: Values, folder: Path, found: Findings) -> FrictionMap | None:
    """Return the coefficients that are written out or in rasters; None, with problems noted, when there are none."""
    if "axial_file" not in values:
        return FrictionMap(**values)
    return _from_raster(read_friction_map, ("axial_file", "transverse_file"), values, folder, found, "friction map")


def stiffness_map_of(values: Values, folder: Path, found: Findings) -> StiffnessMap | None:
    """Return the stiffness that is written out or in a raster; None, with problems noted, when there is none."""
    if "file" not in values:
        return StiffnessMap(**values)
    return _from_raster(read_stiffness_map, ("file",), values, folder, found, "stiffness map")


def _from_raster(
    read: Callable, files: tuple[str, ...], values: Values, folder: Path, found: Findings, name: str
) -> Any:
    """Return what a reader makes of rasters named in `values`; None, with problems noted, when it cannot."""
    for key, count in (("origin", 2), ("extent", 4)):
        if len(values.get(key, range(count))) != count:
            found.add(f"{key} of the {name} has {len(values[key])} values", f"give {count}", values["source"])
            found.lost_rows = True
            return None
    try:
        paths = [folder / values[key] for key in files if key in values]
        return read(*paths, **{key: value for key, value in values.items() if key not in files})
    except ModelError as error:
        found.extend(error.problems)
        found.lost_rows = True
        return None
