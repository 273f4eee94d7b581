"""Lines that free points join into one mooring, in the order from anchor to fairlead."""

from __future__ import annotations

import numpy as np
import xarray as xr


def moorings(ds: xr.Dataset) -> list[list[int]]:
    """Return groups of line ids that hang together at free points, in the order of the file."""
    free = {int(id) for id, kind in zip(ds["point"].values, ds["point_kind"].values, strict=True) if kind == "free"}
    groups: list[tuple[set[int], list[int]]] = []
    for id, *ends in zip(ds["line"].values, ds["end_a"].values, ds["end_b"].values, strict=True):
        joints, lines = {int(end) for end in ends} & free, [int(id)]
        for group in [g for g in groups if g[0] & joints]:
            groups.remove(group)
            joints, lines = joints | group[0], group[1] + lines
        groups.append((joints, lines))
    return sorted((sorted(lines) for _, lines in groups), key=lambda lines: lines[0])


def held_ends(ds: xr.Dataset, lines: list[int]) -> list[int]:
    """Return the ids of the points that hold a mooring, those that move (coupled) first."""
    kind = dict(zip(ds["point"].values.tolist(), ds["point_kind"].values.tolist(), strict=True))
    chosen = np.isin(ds["line"].values, lines)
    ends = dict.fromkeys(np.stack([ds["end_b"].values[chosen], ds["end_a"].values[chosen]]).ravel().tolist())
    return sorted((end for end in ends if kind[end] != "free"), key=lambda end: kind[end] != "coupled")
