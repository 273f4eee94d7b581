"""A MoorDyn model file as a `Model`: v2 of both flavours, and v1."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

from moorage.errors import Source
from moorage.io.moordyn import line_types, lines, points
from moorage.io.moordyn.environment import read_environment
from moorage.io.moordyn.options import flavour, read_options, unused
from moorage.io.moordyn.sections import Table, split_sections, unknown_sections
from moorage.io.text import Findings, Row, read_text, rows, to_float
from moorage.model import Environment, Model


def read_moordyn(path: str | Path, defaults: Environment | None = None) -> Model:
    """Read a MoorDyn file.

    Parameters
    ----------
    defaults : Environment, optional
        Gravity, density and depth where the file does not give them (a driver file's).
    """
    path = Path(path)
    text = read_text(path, "model file")
    found = Findings()
    front, tables = split_sections(rows(text, str(path)), found)
    unknown_sections(tables, found)
    source = Source(str(path))
    _require_sections(tables, found, source)
    empty = Table("", source)
    v1 = _is_v1(tables)
    values = read_options(tables.get("options", empty), found)
    point_list = points.read_points(tables.get("points", empty), found)
    environment = read_environment(values, point_list, path.parent, found, source, defaults)
    model = Model(
        environment=environment,
        line_types=tuple(
            line_types.read_line_types(
                tables.get("line types", empty),
                line_types.V1_COLUMNS if v1 else line_types.COLUMNS,
                path.parent,
                found,
            )
        ),
        lines=tuple(lines.read_lines(tables.get("lines", empty), lines.V1_COLUMNS if v1 else lines.COLUMNS, found)),
        points=tuple(point_list),
        start=_start(values),
        output_interval=_output_interval(values),
        title=_title(front),
        flavour="MoorDyn v1" if v1 else flavour(values),
        file=str(path),
        text=text,
        unused_options=unused(values),
    )
    found.raise_any()
    return model


def _require_sections(tables: dict[str, Table], found: Findings, source: Source) -> None:
    needed = {
        "line types": not tables.keys() & {"rods", "bodies"} or "lines" in tables,
        "lines": not tables.keys() & {"rods", "bodies"},
        "points": not tables.keys() & {"rods", "bodies"},
    }
    for name, needs in needed.items():
        if needs and name not in tables:
            found.add(f"section {name.upper()} is missing", f"add a section headed --- {name.upper()} ---", source)


def _is_v1(tables: dict[str, Table]) -> bool:
    """Return whether a file is of MoorDyn v1: line types without EI, or lengths before the ends of lines."""
    types, lines = tables.get("line types"), tables.get("lines")
    if types is None or lines is None or types.header is None or lines.header is None:
        return False
    names = [name.lower() for name in lines.header.words]
    return "ei" not in map(str.lower, types.header.words) or names[2:3] == ["unstrlen"]


def _start(values: dict) -> Literal["static", "as-given"]:
    value = values.get("TmaxIC")
    return "as-given" if value is not None and value.word and to_float(value.word) == 0.0 else "static"


def _output_interval(values: dict) -> float | None:
    value = values.get("dtOut")
    return to_float(value.word) or None if value is not None else None


def _title(front: list[Row]) -> str:
    lines = (row.text.strip(" -\t") for row in front)
    return "\n".join(line for line in lines if line and "echo" not in line.lower())
