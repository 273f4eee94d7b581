"""Columns of a section, found by the names in its header row.

MoorDyn reads by position and ignores the names. Files exist whose columns stand in another order or have one column
more, and reading those by position turns a drag coefficient into an added mass, or vortex-induced vibration on. So the
names count here, and a file in which names and positions disagree is reported.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from dataclasses import dataclass

from moorage.errors import ModelWarning, Source
from moorage.io.moordyn.sections import Table
from moorage.io.text import Findings, Row, is_number


@dataclass(frozen=True)
class Column:
    """A column: key, the names it goes by (lower case), and whether it may be missing."""

    key: str
    names: tuple[str, ...]
    optional: bool = False
    text: bool = False


@dataclass(frozen=True)
class Record:
    """One row of data: words by column key."""

    words: dict[str, str]
    source: Source

    def __getitem__(self, key: str) -> str:
        return self.words[key]

    def get(self, key: str, default: str = "") -> str:
        """Return the word of a column, or a default when the file has no such column."""
        return self.words.get(key, default)


def records(table: Table, columns: tuple[Column, ...], found: Findings) -> Iterator[Record]:
    """Yield the rows of a section; problems of header and rows are noted and the rows left out."""
    if table.header is None:
        return
    if table.units is None:
        found.add("section has no rows", "add column names, units and data, or remove the section", table.header.source)
        return
    keys = _match(table, columns, found)
    if keys is None:
        return
    if _looks_like_data(table.units, keys, columns):
        message = "the row of units is missing (MoorDyn skips the row after the column names)"
        found.add(message, "add a row of units such as (-)", table.units.source, table.units.text.strip())
    needed = [k for k, key in enumerate(keys) if key and not _column(columns, key).optional]
    for row in table.rows:
        if max(needed) < len(row.words) <= len(keys):
            words = {key: word for key, word in zip(keys, row.words, strict=False) if key}
            yield Record(words, row.source)
        else:
            _wrong_count(table, keys, row, found)


def _column(columns: tuple[Column, ...], key: str) -> Column:
    return next(column for column in columns if column.key == key)


def _wrong_count(table: Table, keys: list[str], row: Row, found: Findings) -> None:
    found.lost_rows = True
    names = " ".join(table.header.words) if table.header else ""
    found.add(
        f"row of {table.name.upper()} has {len(row.words)} values for {len(keys)} columns",
        f"give one value for each of: {names} (comments start with #)",
        row.source,
        row.text.strip(),
    )


def _match(table: Table, columns: tuple[Column, ...], found: Findings) -> list[str] | None:
    """Return the key of every column of the header ("" for one that is not used)."""
    assert table.header is not None
    names = [name.lower().rstrip("*") for name in table.header.words]
    keys = [""] * len(names)
    free = list(columns)
    for k, name in enumerate(names):
        column = next((c for c in free if name in c.names), None)
        if column:
            keys[k] = column.key
            free.remove(column)
    unknown = [k for k, key in enumerate(keys) if not key]
    missing = [column for column in free if not column.optional]
    if missing and len(unknown) >= len(missing):
        _by_position(keys, names, unknown, missing, columns)
        missing = [column for column in missing if column.key not in keys]
    if missing:
        found.lost_rows = True
        found.add(
            f"column {', '.join(c.key for c in missing)} of {table.name.upper()} is missing",
            f"name the columns {' '.join(c.key for c in columns if not c.optional)}",
            table.header.source,
            " ".join(table.header.words),
        )
        return None
    _report(table, keys, columns)
    return keys


def _by_position(
    keys: list[str], names: list[str], unknown: list[int], missing: list[Column], columns: tuple[Column, ...]
) -> None:
    """Let unfamiliar names stand for the columns that MoorDyn has at their place, when all others are in place."""
    standard = [column.key for column in columns if not column.optional]
    in_place = all(key in ("", standard[k]) for k, key in enumerate(keys[: len(standard)]))
    known_names = {name for column in columns for name in column.names}
    wanted = {column.key for column in missing}
    if in_place and len(keys) >= len(standard):
        for k in unknown:
            if k < len(standard) and standard[k] in wanted and names[k] not in known_names and not is_number(names[k]):
                keys[k] = standard[k]


def _looks_like_data(units: Row, keys: list[str], columns: tuple[Column, ...]) -> bool:
    numeric = [k for k, key in enumerate(keys) if key and not _column(columns, key).text and k < len(units.words)]
    return bool(numeric) and sum(is_number(units.words[k]) for k in numeric) > len(numeric) // 2


def _report(table: Table, keys: list[str], columns: tuple[Column, ...]) -> None:
    """Warn once when MoorDyn would read other values, or when a column is not read."""
    assert table.header is not None
    stray = [name for name, key in zip(table.header.words, keys, strict=True) if not key]
    standard = [column.key for column in columns if not column.optional]
    said = []
    if stray:
        said.append(f"column {', '.join(stray)} of {table.name.upper()} is not known and not read")
    if keys[: len(standard)] != standard and not _has_optional_between(keys, columns):
        names = " ".join(table.header.words)
        said.append(
            f"columns of {table.name.upper()} are read by their names ({names}); "
            f"MoorDyn v2 reads {' '.join(standard)} by position"
        )
    if said:
        warnings.warn(f"{table.header.source}: {'; '.join(said)}", ModelWarning, stacklevel=2)


def _has_optional_between(keys: list[str], columns: tuple[Column, ...]) -> bool:
    """Return whether the columns stand in order, with optional ones (forces on points) among them."""
    return keys == [column.key for column in columns if column.key in keys]
