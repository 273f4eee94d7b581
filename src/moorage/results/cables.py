"""Cables in a result: lines with bending stiffness, end to end from the hang-off to the other end.

Lines that are joined by free rods of no length, or by free points, are one cable when two of them meet there.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import xarray as xr

from moorage.errors import Problem, ResultError

ENDS = ("A", "B")
End = tuple[int, int]  # index of a line, and 0 for its end A, 1 for B


class Cable(NamedTuple):
    """A cable as rows of a result, from the hang-off on. At joints, both lines have a node."""

    lines: tuple[int, ...]  # ids
    hang_off: End
    far: End  # the other end
    nodes: np.ndarray  # (n,) positions along dim node
    distance: np.ndarray  # (n,) unstretched, from the hang-off, m
    segments: np.ndarray  # (n - lines,) positions along dim segment
    middles: np.ndarray  # (n - lines,) distance of their middles, m

    def along(self, dim: str) -> tuple[np.ndarray, np.ndarray]:
        """Return rows and distances of a dimension, node or segment."""
        return (self.nodes, self.distance) if dim == "node" else (self.segments, self.middles)


def cables(ds: xr.Dataset) -> list[Cable]:
    """Return the cables of a result that has histories of nodes, in the order of the file.

    The hang-off is the end on a coupled point or rod; when both or none are coupled, the higher one.
    """
    if "bending_stiffness" not in ds.coords:
        return []
    stiff = np.unique(ds["segment_line"].values[ds["bending_stiffness"].values > 0.0])
    open_ends = _chains({k for k, id in enumerate(ds["line"].values) if id in stiff}, end_objects(ds))
    return sorted((_cable(ds, chain) for chain in open_ends), key=lambda cable: min(cable.lines))


def strand(ds: xr.Dataset, lines: Sequence[int]) -> Cable:
    """Return lines as a cable: one that is a cable of the result, or a single line, from its upper or moved end on."""
    for cable in cables(ds):
        if set(cable.lines) == set(lines):
            return cable
    if len(lines) != 1:
        raise ResultError(
            Problem("these lines are not one cable", "name the lines of a cable, or one line", value=lines)
        )
    return _cable(ds, [(int(np.flatnonzero(ds["line"].values == lines[0])[0]), 0)])


def end_objects(ds: xr.Dataset) -> dict[End, tuple[str, int]]:
    """Return what every line end is held by: kind and id."""
    return {
        (k, end): (str(kind), int(id))
        for end, side in enumerate(("end_a", "end_b"))
        for k, (kind, id) in enumerate(zip(ds[f"{side}_kind"].values, ds[side].values, strict=True))
    }


def _chains(stiff: set[int], objects: dict[End, tuple[str, int]]) -> list[list[End]]:
    """Return chains of lines, each as the ends at which one enters its lines."""
    meeting: dict[tuple[str, int], list[End]] = {}
    for end, held_by in objects.items():
        if end[0] in stiff and held_by[0].startswith("free"):
            meeting.setdefault(held_by, []).append(end)
    partner = {pair[x]: pair[1 - x] for pair in meeting.values() if len(pair) == 2 for x in range(2)}
    left, chains = set(stiff), []
    for start in sorted(left):
        if start not in left:
            continue
        enter: End = (start, 0)
        while enter in partner and partner[enter][0] != start:  # back to the open end
            enter = partner[enter][0], 1 - partner[enter][1]
        chain = [enter]
        while (beyond := partner.get((chain[-1][0], 1 - chain[-1][1]))) and beyond[0] != chain[0][0]:
            chain.append(beyond)
        left -= {line for line, _ in chain}
        chains.append(chain)
    return chains


def _cable(ds: xr.Dataset, chain: list[End]) -> Cable:
    first, last = chain[0], (chain[-1][0], 1 - chain[-1][1])
    if _hangs_lower(ds, first, last):
        chain = [(line, 1 - end) for line, end in reversed(chain)]
        first, last = last, first
    node_line, segment_line = ds["node_line"].values, ds["segment_line"].values
    nodes: list[np.ndarray] = []
    distance: list[np.ndarray] = []
    segments: list[np.ndarray] = []
    middles: list[np.ndarray] = []
    passed = 0.0
    for line, end in chain:
        id = ds["line"].values[line]
        for line_of, name, rows, places in (
            (node_line, "arc_length", nodes, distance),
            (segment_line, "segment_arc_length", segments, middles),
        ):
            own = np.flatnonzero(line_of == id)[:: 1 - 2 * end]
            arc = ds[name].values[own]
            rows.append(own)
            places.append(passed + (arc if end == 0 else _length(ds, id) - arc))
        passed += _length(ds, id)
    ids = tuple(int(ds["line"].values[line]) for line, _ in chain)
    return Cable(ids, first, last, *map(np.concatenate, (nodes, distance, segments, middles)))


def _length(ds: xr.Dataset, line: int) -> float:
    return float(ds["arc_length"].values[ds["node_line"].values == line][-1])


def _hangs_lower(ds: xr.Dataset, one: End, other: End) -> bool:
    """Return whether the other end is the hang-off."""
    moved = [str(ds[f"end_{'ab'[end]}_kind"].values[line]).startswith("coupled") for line, end in (one, other)]
    if moved[0] != moved[1]:
        return moved[1]
    return end_height(ds, other) > end_height(ds, one)


def end_height(ds: xr.Dataset, end: End) -> float:
    """Return z of a line end at the start, m."""
    rows = np.flatnonzero(ds["node_line"].values == ds["line"].values[end[0]])
    z = ds["node_position"].isel(node=rows[-1 if end[1] else 0]).sel(xyz="z")
    return float(z[0] if z.ndim else z)


def end_value(ds: xr.Dataset, what: str, end: End) -> np.ndarray:
    """Return tension, force or moment at a line end, over time if there is time."""
    name = f"{'fairlead' if end[1] else 'anchor'}_{what}"
    return ds[name].isel(line=end[0]).values
