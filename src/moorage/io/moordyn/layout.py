"""Numbers and tables as a MoorDyn file writes them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from moorage.model import Attachment

Flavour = Literal["C", "F"]


def number(value: float) -> str:
    """Return a number so that reading it gives the same one."""
    return str(int(value)) if value == int(value) and abs(value) < 1e15 else repr(float(value))


def rule(title: str) -> str:
    """Return the line of dashes that opens a section."""
    return f"---------------------- {title} ----------------------"


def table(title: str, header: str, units: str, rows: Iterable[Iterable[str]]) -> list[str]:
    """Return a section with aligned columns; nothing when it has no rows."""
    body = [list(row) for row in rows]
    if not body:
        return []
    cells = [header.split(), units.split(), *body]
    widths = [max(len(row[k]) for row in cells) for k in range(len(cells[0]))]
    lines = ["  ".join(word.ljust(width) for word, width in zip(row, widths, strict=True)).rstrip() for row in cells]
    return [rule(title), *lines]


def bars(values: Iterable[float]) -> str:
    """Return values with bars between them."""
    return "|".join(map(number, values))


def tie(attachment: Attachment) -> str:
    """Return what a line end is tied to, as MoorDyn names it."""
    return str(attachment.id) if attachment.kind == "point" else f"R{attachment.id}{attachment.end}"
