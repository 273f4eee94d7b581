"""Tables: printed, stored as JSON, and written as one page of Markdown."""

from __future__ import annotations

import json
import os
import platform
import sys
from collections.abc import Iterable, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any, NamedTuple

Row = dict[str, Any]


class Column(NamedTuple):
    """A column: key of its values in the rows, heading, and format of numbers."""

    key: str
    heading: str
    format: str = ""


class Limit(NamedTuple):
    """A number that was promised."""

    what: str
    value: float | None
    limit: float
    unit: str

    @property
    def verdict(self) -> str:
        """Whether the limit is kept."""
        return "not measured" if self.value is None else "kept" if self.value <= self.limit else "MISSED"


class Table(NamedTuple):
    """One measurement."""

    name: str
    title: str
    columns: tuple[Column, ...]
    rows: list[Row]
    notes: tuple[str, ...] = ()
    limits: tuple[Limit, ...] = ()


def cells(table: Table) -> list[list[str]]:
    """Return the table as text, headings first; a value that was not measured is a dash."""

    def cell(row: Row, column: Column) -> str:
        value = row.get(column.key)
        return "-" if value is None else format(value, column.format)

    return [[c.heading for c in table.columns]] + [[cell(row, c) for c in table.columns] for row in table.rows]


def as_text(table: Table) -> str:
    """Return a table for the terminal."""
    grid = cells(table)
    widths = [max(map(len, column)) for column in zip(*grid, strict=True)]
    rows = ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in grid]
    return "\n".join([table.title, *rows, *table.notes])


def as_markdown(table: Table) -> str:
    """Return a table as a section of a page."""
    head, *rows = cells(table)
    lines = [f"## {table.title}", "", _bar(head), _bar(["---"] * len(head)), *map(_bar, rows), ""]
    return "\n".join(lines + [f"{note}\n" for note in table.notes])


def _bar(row: Sequence[str]) -> str:
    return "| " + " | ".join(row) + " |"


def limits_table(tables: Iterable[Table]) -> Table:
    """Return all promises with what was measured."""
    columns = (
        Column("what", "promise"), Column("value", "measured", ".3g"), Column("limit", "limit", "g"),
        Column("unit", "unit"), Column("verdict", "verdict"),
    )  # fmt: skip
    rows = [limit._asdict() | {"verdict": limit.verdict} for table in tables for limit in table.limits]
    return Table("limits", "Promised and measured", columns, rows)


def conditions() -> dict[str, str]:
    """Return when, where and with what was measured."""

    def of(package: str) -> str:
        try:
            return version(package)
        except PackageNotFoundError:
            return "not installed"

    packages = ("moorage", "moordyn", "cabledyn", "MoorPy", "numpy", "numba")
    return {
        "date": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "machine": f"{_processor()}, {os.cpu_count()} processors, {platform.system()} {platform.machine()}",
        "python": sys.version.split()[0],
        **{package: of(package) for package in packages},
    }


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for row in cpuinfo.read_text().splitlines():
            if row.startswith("model name"):
                return row.split(":", 1)[1].strip()
    return platform.processor() or "unknown processor"


def store(tables: Sequence[Table], results: Path, page: Path) -> None:
    """Write each table to results/NAME.json, and all tables whose file is there to the page."""
    results.mkdir(parents=True, exist_ok=True)
    for table in tables:
        text = json.dumps({"conditions": conditions(), "table": table._asdict()}, indent=1, default=_plain)
        (results / f"{table.name}.json").write_text(text + "\n")
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(render(results))


def load(path: Path) -> tuple[dict[str, str], Table]:
    """Return a stored table with its conditions."""
    stored = json.loads(path.read_text())
    table = stored["table"]
    table["columns"] = tuple(Column(*c) for c in table["columns"])
    table["limits"] = tuple(Limit(*limit) for limit in table["limits"])
    table["notes"] = tuple(table["notes"])
    return stored["conditions"], Table(**table)


def render(results: Path) -> str:
    """Return the page of all stored tables."""
    loaded = [load(path) for path in sorted(results.glob("*.json"))]
    tables = [table for _, table in loaded]
    parts = [
        "# Benchmarks",
        "",
        "Written by `python -m benchmarks`; how each number was taken is in "
        "[developer/measurements.md](developer/measurements.md). Each program runs in a process of its own and they "
        "take turns; CPU time is the smallest of several runs. rms is that of the error over that of the tension, "
        "against a refined run of the same equations on the same grid, largest of the lines.",
        "",
        as_markdown(limits_table(tables)),
    ]
    for stamp, table in loaded:
        parts += [as_markdown(table), "*" + ", ".join(f"{k} {v}" for k, v in stamp.items()) + "*", ""]
    return "\n".join(parts).rstrip() + "\n"


def _plain(value):
    return value.item() if hasattr(value, "item") else value.tolist()
