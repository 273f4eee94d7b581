"""ROD TYPES and RODS."""

from __future__ import annotations

from moorage.io.moordyn.columns import Column, Record, records
from moorage.io.moordyn.sections import Table
from moorage.io.moordyn.words import read_hold
from moorage.io.text import Findings
from moorage.model import Rod, RodType

TYPE_COLUMNS = (
    Column("TypeName", ("typename", "name", "rodtype", "type"), text=True),
    Column("Diam", ("diam", "d", "diameter")),
    Column("Mass/m", ("mass/m", "massden", "massdeninair", "mass", "w", "massperlength")),
    Column("Cd", ("cd", "cdn")),
    Column("Ca", ("ca", "can")),
    Column("CdEnd", ("cdend",)),
    Column("CaEnd", ("caend",)),
)
COLUMNS = (
    Column("ID", ("id", "rod", "number")),
    Column("RodType", ("rodtype", "type", "typename"), text=True),
    Column("Attachment", ("attachment", "bodyid", "type/bodyid"), text=True),
    Column("Xa", ("xa",)),
    Column("Ya", ("ya",)),
    Column("Za", ("za",)),
    Column("Xb", ("xb",)),
    Column("Yb", ("yb",)),
    Column("Zb", ("zb",)),
    Column("NumSegs", ("numsegs", "segs", "nsegs")),
    Column("RodOutputs", ("rodoutputs", "outputs", "flags/outputs", "lineoutputs"), text=True),
)


def read_rod_types(table: Table, found: Findings) -> list[RodType]:
    """Return the rod types of the section."""
    return [_rod_type(record, found) for record in records(table, TYPE_COLUMNS, found)]


def _rod_type(record: Record, found: Findings) -> RodType:
    name = record["TypeName"]

    def number(key: str) -> float:
        return found.number(record[key], f"{key} of rod type {name}", record.source)

    return RodType(
        name=name,
        diameter=number("Diam"),
        mass_per_length=number("Mass/m"),
        transverse_drag=number("Cd"),
        transverse_added_mass=number("Ca"),
        end_drag=number("CdEnd"),
        end_added_mass=number("CaEnd"),
        source=record.source,
    )


def read_rods(table: Table, found: Findings) -> list[Rod]:
    """Return the rods of the section."""
    return [_rod(record, found) for record in records(table, COLUMNS, found)]


def _rod(record: Record, found: Findings) -> Rod:
    source = record.source
    id = found.integer(record["ID"], "ID of a rod", source)
    hold = read_hold(record["Attachment"], "rod", found, source)

    def place(end: str) -> tuple[float, float, float]:
        x, y, z = (found.number(record[axis + end], f"{axis + end} of rod {id}", source) for axis in "XYZ")
        return x, y, z

    return Rod(
        id=id,
        rod_type=record["RodType"],
        kind=hold.kind,
        end_a=place("a"),
        end_b=place("b"),
        segments=found.integer(record["NumSegs"], f"NumSegs of rod {id}", source),
        body=hold.body,
        turbine=hold.turbine,
        outputs=record["RodOutputs"].strip("-"),
        source=source,
    )
