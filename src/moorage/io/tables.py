"""Tables in files that a model names: curves of two columns and current profiles."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from moorage.errors import ModelError, Source
from moorage.io.text import Findings, is_number, read_text, rows
from moorage.model import Current, Curve


class Entry(NamedTuple):
    """A row of numbers, with its place."""

    values: tuple[float, ...]
    source: Source


def read_columns(
    path: Path, what: str, widths: range, found: Findings, source: Source, least: int = 2
) -> list[tuple[float, ...]]:
    """Return the rows of numbers of a table file, empty when something is wrong (which is noted).

    What stands before the first row of numbers is the header; blanks or commas separate the columns.

    Parameters
    ----------
    widths : range
        Numbers that a row may have.
    source : Source
        Where the file is named.
    least : int
        Rows that it must have.
    """
    return [entry.values for entry in _read(path, what, widths, found, source, least, False)]


def read_entries(path: Path, what: str, widths: range, found: Findings, source: Source, least: int = 2) -> list[Entry]:
    """Return the rows of a table with their places, as `read_columns`; a row that starts with a number is no header."""
    return _read(path, what, widths, found, source, least, True)


def _read(
    path: Path, what: str, widths: range, found: Findings, source: Source, least: int, numbers_begin: bool
) -> list[Entry]:
    try:
        text = read_text(path, f"table of {what}", source=source)
    except ModelError as error:
        found.extend(error.problems)
        return []
    table: list[Entry] = []
    for row in rows(text, str(path)):
        words = " ".join(row.words).replace(",", " ").split()
        begun = table or (numbers_begin and words and is_number(words[0]))
        if len(words) in widths and all(map(is_number, words)):
            table.append(Entry(found.numbers(words, what, row.source), row.source))
        elif words and begun and not row.text.strip().startswith("---"):
            expected = " or ".join(map(str, widths))
            found.add(
                f"row of the table of {what} is not {expected} numbers", "correct it", row.source, row.text.strip()
            )
            return []
    if len(table) < least:
        found.add(f"table of {what} has {len(table)} rows of numbers", f"give at least {least}", Source(str(path)))
        return []
    return table


def read_curve(folder: Path, name: str, what: str, found: Findings, source: Source) -> Curve:
    """Return the curve in a table file, found relative to the model's folder."""
    table = read_columns(folder / name, what, range(2, 3), found, source)
    return Curve(tuple(row[0] for row in table), tuple(row[1] for row in table), name)


def read_current(path: Path, found: Findings, source: Source) -> Current:
    """Return the steady profile in MoorDyn-C's current_profile.txt: z, u and, when given, v and w."""
    return current_profile(
        read_columns(path, "current profile", range(2, 5), found, source, least=1), Source(str(path))
    )


def current_profile(table: list[tuple[float, ...]], source: Source) -> Current:
    """Return the profile of rows z, u, v, w (m, m/s), given upwards or downwards."""
    if not table:
        return Current()
    if table[0][0] > table[-1][0]:
        table = table[::-1]
    velocity = [(*row[1:], 0.0, 0.0)[:3] for row in table]
    return Current(tuple(row[0] for row in table), tuple((u, v, w) for u, v, w in velocity), source)
