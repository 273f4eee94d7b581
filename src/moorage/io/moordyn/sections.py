"""A MoorDyn file cut into its sections, which MoorDyn finds by a keyword in a line of dashes."""

from __future__ import annotations

import difflib
import re
from dataclasses import dataclass, field

from moorage.errors import Source
from moorage.io.text import Findings, Row

# The first match counts. Spellings: docs/inputs.rst of MoorDyn, findStartOfSection of C, MD_Init of F.
KEYWORDS = (
    ("line types", ("LINE DICTIONARY", "LINE TYPES")),
    ("rod types", ("ROD DICTIONARY", "ROD TYPES")),
    ("bodies", ("BODIES", "BODY LIST", "BODY PROPERTIES")),
    ("rods", ("RODS", "ROD LIST", "ROD PROPERTIES")),
    ("points", ("POINTS", "POINT LIST", "POINT PROPERTIES", "CONNECTION PROPERTIES", "NODE PROPERTIES")),
    ("lines", ("LINES", "LINE LIST", "LINE PROPERTIES")),
    ("syrope", ("SYROPE IC",)),
    ("external loads", ("EXTERNAL LOADS",)),
    ("control", ("CONTROL",)),
    ("failure", ("FAILURE",)),
    ("options", ("OPTIONS",)),
    ("outputs", ("OUTPUT",)),
)
WITHOUT_HEADER = ("options", "outputs")


@dataclass
class Table:
    """One section: its row of column names, its row of units and its rows of data."""

    name: str
    source: Source
    header: Row | None = None
    units: Row | None = None
    rows: list[Row] = field(default_factory=list)


def section_of(line: str) -> str | None:
    """Return the name of the section that a line opens; "" for a line of dashes that names none; else None."""
    if "---" not in line:
        return None
    text = line.upper()
    return next((name for name, words in KEYWORDS if any(word in text for word in words)), "")


def split_sections(rows: list[Row], found: Findings) -> tuple[list[Row], dict[str, Table]]:
    """Return the rows before the first section and the sections by name."""
    front: list[Row] = []
    tables: dict[str, Table] = {}
    current: Table | None = None
    for row in rows:
        name = section_of(row.text)
        if name is None:
            (current.rows if current else front).append(row)
        elif name or current is not None:
            current = Table(name or _title(row.text), row.source)
            _keep(current, tables, found)
        else:
            front.append(row)
    for table in tables.values():
        _take_header(table, found)
    return front, tables


def _keep(table: Table, tables: dict[str, Table], found: Findings) -> None:
    key = table.name
    if key in tables and key in dict(KEYWORDS):
        found.add(f"section {key.upper()} appears twice", "join both into one", table.source)
    while key in tables:
        key += "+"
    tables[key] = table


def _title(line: str) -> str:
    return " ".join(line.strip(" -\t\r").split())


def unknown_sections(tables: dict[str, Table], found: Findings) -> None:
    """Note sections whose name says nothing but that hold data (a closing line of dashes holds none)."""
    known = [word for _, words in KEYWORDS for word in words]
    for table in tables.values():
        if table.name in dict(KEYWORDS) or not any(row.words for row in table.rows):
            continue
        if re.search(r"need this line|^end\b|^$", table.name.lower()):
            continue
        nearest = difflib.get_close_matches(table.name.upper(), known, n=1)
        remedy = f"did you mean {nearest[0]}?" if nearest else f"use one of {', '.join(known)}"
        found.add("unknown section", remedy, table.source, table.name)


def _take_header(table: Table, found: Findings) -> None:
    table.rows = [row for row in table.rows if row.text.strip()]
    if table.name in dict(KEYWORDS) and table.name not in WITHOUT_HEADER:
        rows = table.rows
        if rows and len(rows[0].words) > 1 and re.fullmatch(r"(?i)n(types|connects|lines|points)", rows[0].words[1]):
            rows = rows[1:]  # MoorDyn v1 of FAST v8 gives the number of entries first
        table.header, table.units = (*rows[:2], None, None)[:2]
        table.rows = rows[2:]
    table.rows = [row for row in table.rows if row.words]
