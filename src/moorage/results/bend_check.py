"""Whether a line was bent more than its type allows: where, when, and what a result says of it.

Verified by tests/unit/test_cable_results.py.
"""

from __future__ import annotations

import warnings
from typing import Any, NamedTuple

import numpy as np

from moorage.errors import ModelWarning
from moorage.results.bending import UTILISATION
from moorage.results.columns import Layout


class TightBend(NamedTuple):
    """The place and time where a line is bent most beyond what is allowed there."""

    line: int
    node: int  # counted from end A
    arc_length: float  # m, from end A
    time: float | None  # s; None in a static solution
    radius: float  # m
    allowed: float  # m

    def __str__(self) -> str:
        when = "" if self.time is None else f" at {self.time:g} s"
        return (
            f"line {self.line} is bent to a radius of {self.radius:.3g} m (allowed: {self.allowed:g} m) at node "
            f"{self.node}, {self.arc_length:.4g} m from end A{when}"
        )


def has_limits(layout: Layout) -> bool:
    """Return whether a result has bend radii and what is allowed for them."""
    return UTILISATION in layout.names


def tight_bends(source: Any) -> list[TightBend]:
    """Return the worst bend of every line that is bent more than its types allow.

    Parameters
    ----------
    source : xarray.Dataset or netCDF4.Dataset
        A result; only the columns of the lines, and for each line found one row of curvatures, are read.
    """
    if UTILISATION not in source.variables:
        return []
    histories = source[UTILISATION].ndim == 2
    use = _values(source[UTILISATION][...])
    ratios = use if histories else use[None]
    found = []
    for line in np.flatnonzero((ratios > 1.0).any(axis=0)):
        row = int(np.nanargmax(ratios[:, line]))
        curvature = _values(source["curvature"][row] if histories else source["curvature"][...])
        found.append(_worst(source, int(source["line"][line]), curvature, _time(source, row) if histories else None))
    return found


def _worst(source: Any, line: int, curvature: np.ndarray, time: float | None) -> TightBend:
    nodes = np.flatnonzero(_values(source["node_line"][...]) == line)
    allowed = _values(source["allowed_bend_radius"][...])[nodes]
    k = int(np.argmax(curvature[nodes] * allowed))
    arc_length = float(_values(source["arc_length"][...])[nodes[k]])
    return TightBend(line, k, arc_length, time, float(1.0 / curvature[nodes[k]]), float(allowed[k]))


def _time(source: Any, row: int) -> float:
    return float(source["node_time" if "node_time" in source.variables else "time"][row])


def _values(values: Any) -> np.ndarray:
    """Return plain numbers of a slice of either library; what is not written yet is NaN."""
    return np.ma.filled(values, np.nan) if np.ma.isMaskedArray(values) else np.asarray(values)


def bend_attributes(source: Any) -> dict[str, str]:
    """Return what a result says of the check."""
    return {"bend_radius_check": "; ".join(map(str, tight_bends(source))) or "passed"}


def warn_of_tight_bends(source: Any) -> None:
    """Warn of every line that is bent more than its types allow."""
    for bend in tight_bends(source):
        warnings.warn(str(bend), ModelWarning, stacklevel=3)
