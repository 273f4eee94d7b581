"""Whether a line came to lie outside the depth grid, where the seabed is a guess.

Verified by tests/unit/test_seabed_results.py.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from moorage.errors import ModelWarning


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


def warn_of_lines_off_the_grid(source: Any) -> None:
    """Warn of every line that came to lie outside the depth grid."""
    for line, count in lines_off_the_grid(source).items():
        warnings.warn(
            f"line {line} lies outside the depth grid with {count} of its nodes, where the edge of the grid goes on "
            "level: give a grid that covers the whole mooring",
            ModelWarning,
            stacklevel=3,
        )
