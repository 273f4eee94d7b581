"""The grid on which MoorDyn keeps its water: not needed here, but where it ends MoorDyn's waves end too."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from itertools import pairwise
from math import cos, sin
from pathlib import Path

import numpy as np

from moorage.errors import ModelError, ModelWarning, Source
from moorage.io.text import Findings, Row, is_number, read_text, rows, to_float
from moorage.model import Waves

Extent = tuple[float, float]
Place = tuple[float, float, float]
AXES = "xyz"
REASON = "waves are summed at the nodes, not interpolated on a grid"


def read_grid(path: Path, found: Findings, named: Source) -> tuple[Extent, ...] | None:
    """Return the extents of MoorDyn-C's water_grid.txt in x, y and z; None, with problems noted, when it is wrong."""
    try:
        lines = rows(read_text(path, "wave grid", source=named), str(path))
    except ModelError as error:
        found.extend(error.problems)
        return None
    if len(lines) < 9:
        remedy = "give three header lines, then a type and coordinates for x, y and z"
        found.add(f"wave grid has {len(lines)} lines, not 9", remedy, Source(str(path)))
        return None
    return read_axes(lines[3:9], found)


def read_axes(lines: Sequence[Row], found: Findings) -> tuple[Extent, ...] | None:
    """Return the extents in x, y and z of three pairs of rows: a type, and its coordinates."""
    extents = [_axis(axis, lines[2 * k], lines[2 * k + 1], found) for k, axis in enumerate(AXES)]
    return None if any(extent is None for extent in extents) else tuple(extents)  # type: ignore[arg-type]


def _axis(axis: str, kind: Row, coordinates: Row, found: Findings) -> Extent | None:
    """Return the extent of an axis: 0 is one point at 0, 1 a list, 2 first, last and number of points."""
    word = kind.words[0] if kind.words else ""
    if word not in ("0", "1", "2"):
        found.add(f"type of the wave grid's {axis} is not known", "write 0, 1 or 2", kind.source, word)
        return None
    if word == "0":
        return 0.0, 0.0
    values = _leading_numbers(coordinates)
    enough = len(values) >= 3 and values[2] >= 2.0 if word == "2" else len(values) > 0
    used = values[:2] if word == "2" else values
    if not enough or any(b <= a for a, b in pairwise(used)):
        remedy = "give first, last and number of points" if word == "2" else "list coordinates that increase"
        found.add(f"{axis} of the wave grid is not a grid", remedy, coordinates.source, coordinates.text.strip()[:60])
        return None
    return used[0], used[-1]


def _leading_numbers(row: Row) -> list[float]:
    words = " ".join(row.words).replace(",", " ").split()
    end = next((k for k, word in enumerate(words) if not is_number(word)), len(words))
    return [to_float(word) for word in words[:end]]


def warn_of_short_grid(
    grid: tuple[Extent, ...], waves: Waves, places: Sequence[Place], grid_source: Source, depth: float
) -> None:
    """Warn where a model reaches beyond MoorDyn's grid, whose edge goes on there; here the waves do.

    Parameters
    ----------
    places : sequence of (x, y, z)
        What the model is held by, m.
    """
    if not places:
        return
    reach = np.array(places)
    ways = {"x": lambda b: abs(cos(b)), "y": lambda b: abs(sin(b)), "z": lambda b: 1.0}
    spans = {"x": reach[:, 0], "y": reach[:, 1], "z": np.array([-depth, 0.0])}
    short = []
    for axis, (first, last) in zip(AXES, grid, strict=True):
        gap = max(first - spans[axis].min(), spans[axis].max() - last)
        if gap > 0.0 and max(map(ways[axis], waves.direction)) > 1e-6:
            model = f"{spans[axis].min():g} to {spans[axis].max():g} m"
            short.append(f"{axis} by {gap:.4g} m (grid {first:g} to {last:g} m, model {model})")
    if short:
        warnings.warn(
            f"{grid_source}: the wave grid does not cover the model in {', in '.join(short)}; MoorDyn holds the water "
            "of the grid's edge there, here the waves go on",
            ModelWarning,
            stacklevel=2,
        )
