"""A MoorDyn model file as a `Model`: v2 of both flavours, and v1."""

from __future__ import annotations

import dataclasses
import warnings
from pathlib import Path
from typing import Literal

from moorage.errors import ModelWarning, Source
from moorage.io.finish import checked
from moorage.io.moordyn import bodies, channels, events, line_types, lines, points, rods
from moorage.io.moordyn.environment import number, read_environment, sources
from moorage.io.moordyn.options import Value, flavour, read_options, unused
from moorage.io.moordyn.sections import Table, split_sections, unknown_sections
from moorage.io.moordyn.v1 import is_v1
from moorage.io.text import Findings, Row, read_text, rows
from moorage.model import Environment, Line, LineType, Model, Turbine


def read_moordyn(
    path: str | Path,
    defaults: Environment | None = None,
    raise_to_seabed: bool = False,
    turbines: tuple[Turbine, ...] = (),
) -> Model:
    """Read and check a MoorDyn model file; all that is wrong with it comes as one `ModelError`.

    Parameters
    ----------
    defaults : Environment, optional
        Gravity, density and depth where the file does not give them (a driver file's).
    raise_to_seabed : bool
        Put fixed points that stand below the seabed on it, instead of refusing them, and those that stand less than a
        tenth of the depth over a depth grid.
    turbines : tuple of Turbine
        Where the turbines of a farm are, which another file says.
    """
    path = Path(path)
    text = read_text(path, "model file")
    found = Findings()
    model = dataclasses.replace(parse_moordyn(text, path, found, defaults), turbines=turbines)
    return checked(model, found, raise_to_seabed)


def parse_moordyn(text: str, path: Path, found: Findings, defaults: Environment | None = None) -> Model:
    """Return the model in a text, with what is wrong noted (such a model is not to be used)."""
    source = Source(str(path))
    front, tables = split_sections(rows(text, str(path)), found)
    unknown_sections(tables, found)
    _require_sections(tables, found, source)
    v1 = is_v1(tables)

    def table(name: str) -> Table:
        return tables.get(name, Table(name, source))

    values = read_options(table("options"), found)
    point_list = points.read_points(table("points"), found)
    type_columns = line_types.V1_COLUMNS if v1 else line_types.COLUMNS
    type_list = line_types.read_line_types(table("line types"), type_columns, path.parent, found)
    rod_list = rods.read_rods(table("rods"), found)
    body_list = bodies.read_bodies(table("bodies"), found)
    line_list = lines.read_lines(table("lines"), lines.V1_COLUMNS if v1 else lines.COLUMNS, found)
    return Model(
        environment=read_environment(values, point_list, rod_list, path.parent, found, source, defaults),
        line_types=tuple(type_list),
        lines=_with_tensions(line_list, type_list, events.read_syrope(table("syrope"), found), found),
        points=tuple(point_list),
        rod_types=tuple(rods.read_rod_types(table("rod types"), found)),
        rods=tuple(rod_list),
        bodies=tuple(body_list),
        failures=tuple(events.read_failures(table("failure"), found)),
        controls=tuple(events.read_controls(table("control"), found)),
        external_loads=tuple(events.read_loads(table("external loads"), found)),
        outputs=channels.read_outputs(table("outputs"), found),
        start=_start(values),
        output_interval=number(values, "dtOut", 0.0) or None,
        title=_title(front),
        flavour="MoorDyn v1" if v1 else _flavour(values, [*point_list, *rod_list, *body_list]),
        file=str(path),
        text=text,
        unused_options=unused(values),
        sources=sources(values),
    )


def _flavour(values: dict[str, Value], things: list) -> str:
    """Return whose file it is: that of MoorDyn-F where something is on a turbine, for MoorDyn-C knows none."""
    told = flavour(values)
    return "MoorDyn-F" if told == "MoorDyn v2" and any(thing.turbine is not None for thing in things) else told


def _require_sections(tables: dict[str, Table], found: Findings, source: Source) -> None:
    """Note the sections that a model cannot do without: those of lines, unless it is one of rods or bodies."""
    without_lines = bool(tables.keys() & {"rods", "bodies"}) and "lines" not in tables
    for name in () if without_lines else ("line types", "points", "lines"):
        if name not in tables and not (name == "points" and "rods" in tables):
            found.add(f"section {name.upper()} is missing", f"add a section headed --- {name.upper()} ---", source)
            found.lost_rows = True
    for name, needed in (("rods", "rod types"),):
        if name in tables and needed not in tables:
            found.add(f"section {needed.upper()} is missing", f"{name.upper()} need it", tables[name].source)
            found.lost_rows = True


def _with_tensions(
    lines: list[Line], types: list[LineType], tensions: dict[int, events.Tensions], found: Findings
) -> tuple[Line, ...]:
    """Return the lines with the tensions that those of a Syrope type start from; rows of other lines are told."""
    ropes = {t.name.lower() for t in types if t.syrope}
    known = {line.id: any(s.line_type.lower() in ropes for s in line.sections) for line in lines}
    for id, row in tensions.items():
        if id not in known:
            found.add(f"SYROPE IC names line {id}, which is not there", "correct the number", row.source)
        elif not ropes:
            remedy = "remove the section, or write SYROPE:file|EA_Dc|EA_D_Lm as EA of its line type"
            found.add(f"SYROPE IC names line {id}, and no line type is a Syrope one", remedy, row.source)
        elif not known[id]:
            what = f"SYROPE IC names line {id}, whose line type is not a Syrope one: its row has no effect"
            warnings.warn(f"{row.source}: {what}; remove it", ModelWarning, stacklevel=2)
    used = {id: (row.highest, row.mean) for id, row in tensions.items() if known.get(id)}
    return tuple(dataclasses.replace(line, syrope_tensions=used.get(line.id)) for line in lines)


def _start(values: dict[str, Value]) -> Literal["static", "as-given"]:
    """Return where a run starts: TmaxIC 0 means that no initial state is sought."""
    return "as-given" if number(values, "TmaxIC", 1.0) == 0.0 else "static"


def _title(front: list[Row]) -> str:
    """Return the free text before the first section, without lines of dashes and v1's echo flag."""
    lines = (row.text.strip() for row in front if "---" not in row.text)
    return "\n".join(line for line in lines if line and "echo" not in line.lower())
