"""LINES: one section each, of one type, between two ends."""

from __future__ import annotations

from moorage.io.moordyn.columns import Column, Record, records
from moorage.io.moordyn.sections import Table
from moorage.io.moordyn.words import read_attachment
from moorage.io.text import Findings
from moorage.model import Line, Section

_A = ("attacha", "nodea", "attachanch", "nodeanch", "anch", "enda", "pointa")
_B = ("attachb", "nodeb", "attachfair", "nodefair", "fair", "endb", "pointb")
COLUMNS = (
    Column("ID", ("id", "line", "number")),
    Column("LineType", ("linetype", "type", "typename"), text=True),
    Column("AttachA", _A, text=True),
    Column("AttachB", _B, text=True),
    Column("UnstrLen", ("unstrlen", "length", "unstretchedlength")),
    Column("NumSegs", ("numsegs", "segs", "nsegs")),
    Column("LineOutputs", ("lineoutputs", "outputs", "flags/outputs", "output", "flags"), text=True),
)
_BY_KEY = {column.key: column for column in COLUMNS}
V1_COLUMNS = tuple(
    _BY_KEY[key] for key in ("ID", "LineType", "UnstrLen", "NumSegs", "AttachA", "AttachB", "LineOutputs")
)


def read_lines(table: Table, columns: tuple[Column, ...], found: Findings) -> list[Line]:
    """Return the lines of the section."""
    return [_line(record, found) for record in records(table, columns, found)]


def _line(record: Record, found: Findings) -> Line:
    source = record.source
    id = found.integer(record["ID"], "ID of a line", source)
    section = Section(
        line_type=record["LineType"],
        length=found.number(record["UnstrLen"], f"UnstrLen of line {id}", source),
        segments=found.integer(record["NumSegs"], f"NumSegs of line {id}", source),
        source=source,
    )
    return Line(
        id=id,
        sections=(section,),
        end_a=read_attachment(record["AttachA"], f"end A of line {id}", found, source),
        end_b=read_attachment(record["AttachB"], f"end B of line {id}", found, source),
        outputs=record["LineOutputs"].strip("-"),
        source=source,
    )
