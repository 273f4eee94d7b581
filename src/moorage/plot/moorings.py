"""Lines that free points and free rods join into one mooring, and what is drawn of them as one."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import xarray as xr

from moorage.results.cables import cables, end_objects


def moorings(ds: xr.Dataset) -> list[list[int]]:
    """Return groups of line ids that hang together at free points or rods, in the order of the file."""
    objects = end_objects(ds)
    groups: list[tuple[set[tuple[str, int]], list[int]]] = []
    for k, id in enumerate(ds["line"].values):
        joints = {objects[k, end] for end in (0, 1) if objects[k, end][0].startswith("free")}
        lines = [int(id)]
        for group in [g for g in groups if g[0] & joints]:
            groups.remove(group)
            joints, lines = joints | group[0], group[1] + lines
        groups.append((joints, lines))
    return sorted((sorted(lines) for _, lines in groups), key=lambda lines: lines[0])


def strands(ds: xr.Dataset, lines: list[int]) -> list[list[int]]:
    """Return the parts of a mooring that are drawn as one: its cables, and its other lines."""
    whole = [list(cable.lines) for cable in cables(ds) if set(cable.lines) <= set(lines)]
    taken = {id for cable in whole for id in cable}
    return sorted(whole + [[id] for id in lines if id not in taken], key=min)


def only_cables(ds: xr.Dataset, lines: Iterable[int]) -> bool:
    """Return whether all of these lines are parts of cables."""
    return set(lines) <= {id for cable in cables(ds) for id in cable.lines}


def name_of(lines: list[int]) -> str:
    """Return what a mooring or cable is called in pictures."""
    return f"line {lines[0]}" if len(lines) == 1 else "lines " + ", ".join(map(str, lines))


def held_ends(ds: xr.Dataset, lines: list[int]) -> list[tuple[int, int]]:
    """Return the ends (index of the line, 0 for A, 1 for B) by which a mooring is held, those that move first."""
    objects, chosen = end_objects(ds), np.flatnonzero(np.isin(ds["line"].values, lines))
    ends = [(int(k), end) for end in (1, 0) for k in chosen if not objects[int(k), end][0].startswith("free")]
    return sorted(ends, key=lambda end: not objects[end][0].startswith("coupled"))
