"""Whether a line came to lie outside the depth grid, where the seabed is a guess.

Verified by tests/unit/test_seabed_results.py.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np

from moorage.errors import ModelWarning
from moorage.physics.bathymetry import bed_at
from moorage.system.build import Built


def _values(values: Any) -> np.ndarray:
    """Return plain numbers of a slice of either library."""
    return np.ma.filled(values, np.nan) if np.ma.isMaskedArray(values) else np.asarray(values)


def _at_end(variable: Any, dims: int) -> np.ndarray:
    """Return the last row of a history, which has so many dimensions with its time."""
    return _values(variable[-1] if variable.ndim == dims else variable[...])


def lines_off_the_grid(source: Any) -> dict[int, int]:
    """Return how many nodes of each line lie on the seabed outside the depth grid at the end of a run, by line id.

    Parameters
    ----------
    source : xarray.Dataset or netCDF4.Dataset
        A result; only its last shapes are read.
    """
    if "bed_x" not in source.variables or "seabed_gap" not in source.variables:
        return {}
    position, gap = _at_end(source["node_position"], 3), _at_end(source["seabed_gap"], 2)
    off = np.zeros(len(gap), dtype=bool)
    for k, name in enumerate(("bed_x", "bed_y")):
        axis = _values(source[name][...])
        if len(axis) > 1:
            off |= (position[:, k] < axis[0]) | (position[:, k] > axis[-1])
    owners, counts = np.unique(_values(source["node_line"][...])[off & (gap <= 0.0)], return_counts=True)
    return dict(zip(owners.tolist(), counts.tolist(), strict=True))


def lines_off_the_grid_now(built: Built) -> dict[int, int]:
    """Return the same of the present state, which needs no histories of nodes."""
    bed, names, found = built.system.contact.bed, built.names, {}
    for line, first, last in zip(names.lines.tolist(), names.node_ptr[:-1], names.node_ptr[1:], strict=True):
        r = built.state.position[first:last]
        off = np.zeros(len(r), dtype=bool)
        for k, axis in enumerate((bed.x.at, bed.y.at)):
            if len(axis) > 1:
                off |= (r[:, k] < axis[0]) | (r[:, k] > axis[-1])
        count = sum(z <= bed_at(bed, x, y)[0] for x, y, z in r[off])
        if count:
            found[line] = int(count)
    return found


def warn_of_lines_off_the_grid(found: Mapping[int, int]) -> None:
    """Warn of every line that came to lie outside the depth grid, with so many of its nodes."""
    for line, count in found.items():
        warnings.warn(
            f"line {line} lies outside the depth grid with {count} of its nodes, where the edge of the grid goes on "
            "level: give a grid that covers the whole mooring",
            ModelWarning,
            stacklevel=3,
        )
