"""MoorDyn-C's currents that change: a profile over time, and a grid over time and place."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np

from moorage.errors import ModelError, Source
from moorage.io.text import Findings, Row, is_number, read_text, rows, to_float
from moorage.model import Current, CurrentGrid

DYNAMIC, GRID = "current_profile_dynamic.txt", "current_profile_4d.txt"


def read_changing_profile(path: Path, found: Findings, named: Source) -> Current | CurrentGrid:
    """Return the current of current_profile_dynamic.txt: levels in line 5, from line 7 on a time and its velocities.

    A row holds the x components at all levels, and then, when they are given, those in y and z.
    """
    lines = _lines(path, 7, "four header lines, the levels, a header line, and a row for each time", found, named)
    if not lines:
        return Current()
    z, times, velocity = _numbers(lines[4], found), [], []
    widths = [1 + len(z) * count for count in (1, 2, 3)]
    for row in lines[6:]:
        values = _numbers(row, found)
        if not values:
            continue
        if len(values) not in widths:
            wanted = " or ".join(map(str, widths))
            remedy = f"give {wanted} numbers: a time, and one to three components at {len(z)} levels"
            found.add(f"row of the current has {len(values)} numbers", remedy, row.source)
            return Current()
        parts = np.array(values[1:]).reshape(-1, len(z)).T
        times.append(values[0])
        velocity.append(np.pad(parts, ((0, 0), (0, 3 - parts.shape[1]))))
    grid = np.array(velocity).reshape(len(times), 1, 1, len(z), 3)
    return _checked({"t": tuple(times), "z": z}, grid, path, found)


def read_current_grid(path: Path, found: Findings, named: Source) -> Current | CurrentGrid:
    """Return the current of current_profile_4d.txt: counts, x, y, z, t, and a row x y z t u v w for each point.

    MoorDyn-C leaves out the first of those rows, and takes still water there.
    """
    lines = _lines(path, 6, "the counts, a line each for x, y, z and t, and a row for each point", found, named)
    if not lines:
        return Current()
    counts = [int(value) for value in _numbers(lines[0], found)]
    axes = [_numbers(row, found) for row in lines[1:5]]
    if len(counts) != 4 or [len(axis) for axis in axes] != counts:
        given = ", ".join(f"{len(axis)} in {name}" for name, axis in zip("xyzt", axes, strict=True))
        found.add(f"grid of the current has {given}", "count them in line 1", lines[0].source, lines[0].text.strip())
        return Current()
    velocity = np.full((*counts, 3), np.nan)
    index = [{value: k for k, value in enumerate(axis)} for axis in axes]
    for row in lines[5:]:
        values = _numbers(row, found)
        if not values:
            continue
        place = tuple(known.get(value, -1) for known, value in zip(index, values, strict=False))
        if len(values) != 7 or -1 in place:
            remedy = "give x, y, z and t of a point of the grid, and three velocities"
            found.add("row of the current is not a point of the grid", remedy, row.source, row.text.strip()[:60])
            return Current()
        velocity[place] = values[4:]
    missing = int(np.isnan(velocity[..., 0]).sum())
    if missing:
        whole = velocity[..., 0].size
        found.add(f"current is missing at {missing} of {whole} points", "give a row for each", Source(str(path)))
        return Current()
    return _checked(dict(zip("xyzt", axes, strict=True)), np.moveaxis(velocity, 3, 0), path, found)


def _checked(axes: dict[str, Any], velocity: np.ndarray, path: Path, found: Findings):
    """Return the grid, with levels upwards; a still current, and a problem noted, when an axis does not increase."""
    source = Source(str(path))
    if found.problems:
        return Current()
    if axes["z"][:1] > axes["z"][-1:]:  # given from the surface down
        axes, velocity = axes | {"z": axes["z"][::-1]}, velocity[:, :, :, ::-1]
    for name, values in axes.items():
        if any(b <= a for a, b in pairwise(values)):
            what = {"t": "times", "z": "levels"}.get(name, name)
            found.add(f"{what} of the current do not increase", "sort them, each once", source, values)
            return Current()
    return CurrentGrid(**axes, velocity=np.ascontiguousarray(velocity), file=path.name, source=source)


def _lines(path: Path, least: int, remedy: str, found: Findings, named: Source) -> list[Row]:
    """Return the lines of a file, none when it cannot be read or has too few of them (which is noted)."""
    try:
        lines = rows(read_text(path, "table of the current", source=named), str(path))
    except ModelError as error:
        found.extend(error.problems)
        return []
    if len(lines) >= least:
        return lines
    found.add(f"table of the current has {len(lines)} lines", f"give {remedy}", Source(str(path)))
    return []


def _numbers(row: Row, found: Findings) -> tuple[float, ...]:
    words = " ".join(row.words).replace(",", " ").split()
    if all(map(is_number, words)):
        return tuple(map(to_float, words))
    return found.numbers(words, "current", row.source)
