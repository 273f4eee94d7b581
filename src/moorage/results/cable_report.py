"""The numbers of a cable in static equilibrium that its designer asks for.

Verified by tests/unit/test_cable_results.py.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import xarray as xr

from moorage.results.cables import Cable, cables, end_value

NOWHERE = float("nan")
CLEAR = 1e-3  # of the cable's height over the bed: less is a cable that lies on it


class CableReport(NamedTuple):
    """One cable, in N, m and rad; NaN for what it does not have. Distances are unstretched, from the hang-off."""

    lines: tuple[int, ...]  # from the hang-off on
    hang_off_tension: float
    hang_off_angle: float  # of the pull from straight down
    hang_off_moment: float  # on the rod that clamps it, N m
    sag_height: float  # lowest sag over the seabed
    hog_height: float  # highest hog over the seabed
    peak_curvature: float  # 1/m
    peak_curvature_distance: float
    peak_curvature_line: int
    peak_curvature_node: int  # of that line, from its end A
    minimum_bend_radius: float
    bend_utilisation: float  # allowed over smallest radius
    touchdown_position: tuple[float, float, float]
    touchdown_distance: float
    anchor_tension: float


def cable_reports(ds: xr.Dataset) -> list[CableReport]:
    """Return the reports of all cables of a static solution."""
    return [_report(ds, cable) for cable in cables(ds)]


def as_plain(report: CableReport) -> dict[str, object]:
    """Return a report for JSON: lists, and null for what is not a number."""
    return {name: _plain(value) for name, value in report._asdict().items()}


def _plain(value: object) -> object:
    if isinstance(value, tuple):
        return [_plain(part) for part in value] if all(part == part for part in value) else None
    return None if isinstance(value, float) and not np.isfinite(value) else value


def _report(ds: xr.Dataset, cable: Cable) -> CableReport:
    fx, fy, fz = end_value(ds, "force", cable.hang_off)
    curvature = ds["curvature"].values[cable.nodes]
    peak = int(np.argmax(curvature))
    line = int(ds["node_line"].values[cable.nodes[peak]])
    first = int(np.flatnonzero(ds["node_line"].values == line)[0])
    z, gap = ds["node_position"].values[cable.nodes, 2], ds["seabed_gap"].values[cable.nodes]
    sag, hog = sag_and_hog(cable.distance, z, gap)
    spot, distance = _touchdown(ds, cable)
    used = "bend_utilisation" in ds
    return CableReport(
        cable.lines,
        float(end_value(ds, "tension", cable.hang_off)),
        float(np.arctan2(np.hypot(fx, fy), -fz)),
        float(np.linalg.norm(end_value(ds, "moment", cable.hang_off))),
        sag,
        hog,
        float(curvature[peak]),
        float(cable.distance[peak]),
        line,
        int(cable.nodes[peak]) - first,
        float(1.0 / curvature[peak]) if curvature[peak] > 0.0 else float("inf"),
        float(ds["bend_utilisation"].sel(line=list(cable.lines)).max()) if used else NOWHERE,
        spot,
        distance,
        float(end_value(ds, "tension", cable.far)),
    )


def _touchdown(ds: xr.Dataset, cable: Cable) -> tuple[tuple[float, float, float], float]:
    """Return where the cable first meets the bed, seen from the hang-off, and the distance to there."""
    for line in cable.lines:
        part = ds.sel(line=line)
        arc = float(part["touchdown_arc_length"])
        if np.isfinite(arc):
            own = ds["node_line"].values[cable.nodes] == line
            arcs = ds["arc_length"].values[cable.nodes[own]]
            order = np.argsort(arcs)
            x, y, z = map(float, part["touchdown_position"].values)
            return (x, y, z), float(np.interp(arc, arcs[order], cable.distance[own][order]))
    return (NOWHERE, NOWHERE, NOWHERE), NOWHERE


def sag_and_hog(distance: np.ndarray, z: np.ndarray, gap: np.ndarray) -> tuple[float, float]:
    """Return the heights over the bed of the lowest sag that is off it and of the highest hog, NaN for none.

    A parabola through a node and its neighbours gives the turning point between nodes.
    """
    keep = np.concatenate([[True], np.diff(distance) > 0.0])  # joints have two nodes
    s, z, gap = distance[keep], z[keep], gap[keep]
    slopes, steps = np.diff(z) / np.diff(s), np.diff(s)
    before, after = slopes[:-1], slopes[1:]
    slope = (before * steps[1:] + after * steps[:-1]) / (steps[1:] + steps[:-1])
    bend = 2.0 * (after - before) / (steps[1:] + steps[:-1])
    with np.errstate(divide="ignore", invalid="ignore"):
        height = gap[1:-1] - 0.5 * slope**2 / bend
    off = gap[1:-1] > CLEAR * gap.max()
    sags, hogs = height[off & (before < 0.0) & (after >= 0.0)], height[off & (before > 0.0) & (after <= 0.0)]
    return float(sags.min()) if len(sags) else NOWHERE, float(hogs.max()) if len(hogs) else NOWHERE
