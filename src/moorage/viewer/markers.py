"""What stands beside the lines: points, clamps, platforms, rods and bodies."""

from __future__ import annotations

import numpy as np
import xarray as xr

from moorage.model import Model
from moorage.viewer.quantities import line_starts
from moorage.viewer.times import interpolated

NEAR = 0.25  # coupled points closer than this part of the lines' reach are drawn as one platform


def markers(ds: xr.Dataset, position: np.ndarray, time: np.ndarray) -> tuple[np.ndarray, list[dict]]:
    """Return places (frames, n, 3) and names of the points, and of the line ends that rods hold.

    `position` (frames, nodes, 3) holds the nodes at the shown times (frames,).
    """
    at_points = interpolated(ds["point_position"].values, ds["time"].values, time)
    kinds = ds["point_kind"].values
    turbines = ds["point_turbine"].values if "point_turbine" in ds.coords else np.zeros(len(kinds), dtype=int)
    labels = [
        {"name": _named("point", int(id), _name(ds, "point", k)), "kind": str(kinds[k])} | _aboard(turbines[k])
        for k, id in enumerate(ds["point"].values)
    ]
    starts, nodes = line_starts(ds), []
    for k, first in enumerate(starts):
        last = (starts[k + 1] if k + 1 < len(starts) else position.shape[1]) - 1
        for end, node in (("end_a", first), ("end_b", last)):
            kind, what = str(ds[f"{end}_kind"].values[k]).rsplit(" ", 1)
            if what == "rod":
                nodes.append(node)
                labels.append({"name": f"rod {int(ds[end].values[k])}", "kind": kind})
    return np.concatenate([at_points, position[:, nodes]], axis=1), labels


def platforms(places: np.ndarray, labels: list[dict], reach: float) -> list[list[int]]:
    """Return rings of markers (rows of places (n, 3)) that are moved together: what they hang on is one body.

    Those of a turbine are together, others where they stand together. `reach` is the typical horizontal distance from
    one end of a line to the other, m.
    """
    moved = [k for k, label in enumerate(labels) if label["kind"].startswith("coupled")]
    aboard = {label["turbine"]: [] for label in labels if "turbine" in label}  # type: dict[int, list[int]]
    for k in moved:
        if "turbine" in labels[k]:
            aboard[labels[k]["turbine"]].append(k)
    groups: list[list[int]] = []
    for k in (k for k in moved if "turbine" not in labels[k]):
        near = [g for g in groups if min(np.linalg.norm(places[k] - places[i]) for i in g) < NEAR * reach]
        groups = [g for g in groups if g not in near] + [[k, *(i for g in near for i in g)]]
    return [_ring(places, group) for group in (*aboard.values(), *groups) if len(group) > 1]


def line_reach(position: np.ndarray, starts: np.ndarray) -> float:
    """Return the median horizontal distance between the ends of lines with nodes (nodes, 3), m."""
    if not len(starts):
        return 0.0
    ends = np.append(starts[1:], len(position)) - 1
    return float(np.median(np.linalg.norm(position[ends, :2] - position[starts, :2], axis=-1)))


def rods(ds: xr.Dataset, model: Model | None, time: np.ndarray) -> tuple[np.ndarray, list[dict]]:
    """Return both ends (frames, 2 rods, 3) of the rods that have a length, and their names."""
    if "rod_position" in ds:
        places = ds["rod_position"].values
        long = np.flatnonzero((places[0, :, 0] != places[0, :, 1]).any(axis=-1))  # the others are marks
        ends = interpolated(places[:, long], ds["time"].values, time)
        described = {rod.id: rod.name for rod in model.rods} if model else {}
        names = [{"name": _named("rod", int(id), described.get(int(id), ""))} for id in ds["rod"].values[long]]
        return ends.reshape(len(time), -1, 3), names
    return np.empty((len(time), 0, 3)), []


def bodies(ds: xr.Dataset, time: np.ndarray) -> tuple[np.ndarray, list[dict]]:
    """Return place (m) and intrinsic XYZ angles (rad), (frames, bodies, 6), of bodies, and their names."""
    if "body_position" not in ds:
        return np.empty((len(time), 0, 6)), []
    both = np.concatenate([ds["body_position"].values, ds["body_rotation"].values], axis=-1)
    return interpolated(both, ds["time"].values, time), [{"name": f"body {int(id)}"} for id in ds["body"].values]


def _aboard(turbine: int) -> dict[str, int]:
    return {"turbine": int(turbine)} if turbine else {}


def _name(ds: xr.Dataset, what: str, k: int) -> str:
    return str(ds[f"{what}_name"].values[k]) if f"{what}_name" in ds.coords else ""


def _named(what: str, id: int, name: str) -> str:
    return f"{what} {id}: {name}" if name and name != str(id) else f"{what} {id}"


def _ring(places: np.ndarray, group: list[int]) -> list[int]:
    """Return rows in the order of their direction from the middle."""
    away = places[group] - places[group].mean(axis=0)
    return [int(group[i]) for i in np.argsort(np.arctan2(away[:, 1], away[:, 0]))]
