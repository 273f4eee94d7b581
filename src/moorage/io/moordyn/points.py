"""POINTS, in nine columns, or in twelve with MoorDyn v1's constant forces."""

from __future__ import annotations

import re
import warnings

from moorage.errors import ModelWarning
from moorage.io.moordyn.columns import Column, Record, records
from moorage.io.moordyn.sections import Table
from moorage.io.moordyn.words import read_hold
from moorage.io.text import Findings, is_number
from moorage.model import Point

COLUMNS = (
    Column("ID", ("id", "node", "point", "number", "connection")),
    Column("Attachment", ("attachment", "type"), text=True),
    Column("X", ("x",)),
    Column("Y", ("y",)),
    Column("Z", ("z",)),
    Column("Mass", ("mass", "m")),
    Column("Volume", ("volume", "v", "vol")),
    Column("FX", ("fx",), optional=True),
    Column("FY", ("fy",), optional=True),
    Column("FZ", ("fz",), optional=True),
    Column("CdA", ("cda",)),
    Column("Ca", ("ca",)),
)
ON_SEABED = re.compile(r"SEABED|GROUND|FLOOR")


def read_points(table: Table, found: Findings) -> list[Point]:
    """Return the points of the section."""
    points = [_point(record, found) for record in records(table, COLUMNS, found)]
    if any(any(point.external_force) for point in points) and table.units and "kN" in table.units.text:
        warnings.warn(
            f"{table.units.source}: forces of POINTS are read in newtons, as MoorDyn does; the row of units says kN",
            ModelWarning,
            stacklevel=2,
        )
    return points


def _point(record: Record, found: Findings) -> Point:
    source = record.source
    id = found.integer(record["ID"], "ID of a point", source)

    def number(key: str) -> float:
        return found.number(record.get(key, "0"), f"{key} of point {id}", source)

    hold = read_hold(record["Attachment"], "point", found, source)
    on_seabed = not is_number(record["Z"]) and ON_SEABED.search(record["Z"].upper()) is not None
    return Point(
        id=id,
        kind="coupled" if hold.kind == "coupled" else "free" if hold.kind == "free" else "fixed",
        position=(number("X"), number("Y"), 0.0 if on_seabed else number("Z")),
        mass=number("Mass"),
        volume=number("Volume"),
        drag_area=number("CdA"),
        added_mass=number("Ca"),
        external_force=(number("FX"), number("FY"), number("FZ")),
        body=hold.body,
        turbine=hold.turbine,
        on_seabed=on_seabed,
        source=source,
    )
