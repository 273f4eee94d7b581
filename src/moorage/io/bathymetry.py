"""Depth grids in MoorDyn's two layouts: C's list of x, y, z and F's matrix of depths."""

from __future__ import annotations

from pathlib import Path

from moorage.errors import ModelError, Source
from moorage.io.text import Findings, Row, is_number, read_text, rows
from moorage.model import Bathymetry


def read_bathymetry(path: Path, found: Findings, source: Source) -> Bathymetry | None:
    """Return the depth grid in a file of either layout; None, with problems noted, when it cannot be read.

    MoorDyn-F's file has a title and the counts `nGridX n` and `nGridY n`; MoorDyn-C's starts with both counts and lists
    z, which is negative below the water.
    """
    try:
        text = read_text(path, "depth file", source=source)
    except ModelError as error:
        found.extend(error.problems)
        return None
    lines = [row for row in rows(text, str(path)) if row.words]
    before = len(found.problems)
    is_matrix = any(row.words[0].lower() == "ngridx" for row in lines)
    axes, depth = (_matrix if is_matrix else _list)(lines, found, Source(str(path)))
    if len(found.problems) > before:
        return None
    grid = tuple(tuple(depth[i, j] for j in range(len(axes[1]))) for i in range(len(axes[0])))
    return Bathymetry(*axes, grid, file=str(path.name), source=Source(str(path)))


Grid = tuple[tuple[tuple[float, ...], tuple[float, ...]], dict[tuple[int, int], float]]
_NOTHING: Grid = (((), ()), {})


def _matrix(lines: list[Row], found: Findings, source: Source) -> Grid:
    counts = {row.words[0].lower(): row for row in lines if row.words[0].lower() in ("ngridx", "ngridy")}
    if counts.keys() != {"ngridx", "ngridy"} or any(len(row.words) < 2 for row in counts.values()):
        found.add("depth file lacks nGridX or nGridY", "write nGridX and nGridY, each with its count", source)
        return _NOTHING
    nx, ny = (found.integer(counts[k].words[1], k, counts[k].source) for k in ("ngridx", "ngridy"))
    body = lines[max(lines.index(row) for row in counts.values()) + 1 :]
    if not body:
        found.add("depth file has no grid", f"give {nx} values of x and {ny} rows of y and depths", source)
        return _NOTHING
    x = _row(body[0], nx, "x", found)
    table = [_row(row, nx + 1, "y and depths", found) for row in body[1 : ny + 1]]
    if len(table) < ny:
        found.add(f"depth file has {len(table)} rows of depths", f"give {ny} (nGridY)", source)
        return _NOTHING
    if len(body) > ny + 1 and all(map(is_number, body[ny + 1].words)):
        row = body[ny + 1]
        found.add(f"depth file has more rows of depths than {ny} (nGridY)", "correct the count", row.source, row.text)
    _check_increase(x, "x", [body[0]] * nx, found)
    _check_increase(tuple(row[0] for row in table), "y", body[1 : ny + 1], found)
    depth = {(i, j): value for j, row in enumerate(table) for i, value in enumerate(row[1:])}
    return (x, tuple(row[0] for row in table)), depth


def _list(lines: list[Row], found: Findings, source: Source) -> Grid:
    if len(lines) < 4:
        found.add(f"depth file has {len(lines)} rows", "give the counts, x, y and one row of x y z a point", source)
        return _NOTHING
    counts = [found.integer(word, "count of the depth grid", lines[0].source) for word in lines[0].words]
    if len(counts) != 2:
        found.add("depth file does not start with two counts", "write nx ny", lines[0].source, lines[0].text.strip())
        return _NOTHING
    x, y = _row(lines[1], counts[0], "x", found), _row(lines[2], counts[1], "y", found)
    for axis, name, row in ((x, "x", lines[1]), (y, "y", lines[2])):
        _check_increase(axis, name, [row] * len(axis), found)
    depth: dict[tuple[int, int], float] = {}
    for row in lines[3:]:
        values = _row(row, 3, "x, y and z", found)
        if values[0] not in x or values[1] not in y:
            found.add(
                "point of the depth file is not on its grid", "use the x and y listed", row.source, row.text.strip()
            )
            continue
        place = x.index(values[0]), y.index(values[1])
        if place in depth:
            found.add("point of the depth file is given twice", "remove one", row.source, row.text.strip())
        depth[place] = -values[2]
    missing = len(x) * len(y) - len(depth)
    if missing:
        found.add(f"depth file leaves {missing} points of its grid without depth", "list every point", source)
    return (x, y), depth


def _check_increase(axis: tuple[float, ...], name: str, places: list[Row], found: Findings) -> None:
    """Note where an axis of the grid does not increase; `places` are the rows that give its values."""
    for before, value, place in zip(axis, axis[1:], places[1:], strict=False):
        if value <= before and all(problem.source != place.source for problem in found.problems):
            remedy = f"the value after {before:g} must be larger"
            found.add(f"{name} of the depth grid does not increase", remedy, place.source, value)
            return


def _row(row: Row, count: int, what: str, found: Findings) -> tuple[float, ...]:
    words = row.words[:count]
    if len(row.words) != count or not all(map(is_number, words)):
        found.add(f"row of the depth file is not {count} numbers ({what})", "correct it", row.source, row.text.strip())
        return (0.0,) * max(count, 1)
    return found.numbers(words, what, row.source)
