"""BODIES: angles in degrees, and columns of several values with bars between them."""

from __future__ import annotations

from math import radians

from moorage.io.moordyn.columns import Column, Record, records
from moorage.io.moordyn.sections import Table
from moorage.io.moordyn.words import read_hold
from moorage.io.text import Findings
from moorage.model import Body

# The heading of the yaw angle, y0, is that of a coordinate in another case: the first one is the coordinate.
COLUMNS = (
    Column("ID", ("id", "body", "number")),
    Column("Attachment", ("attachment", "type", "word"), text=True),
    Column("X0", ("x0", "x")),
    Column("Y0", ("y0", "y")),
    Column("Z0", ("z0", "z")),
    Column("r0", ("r0", "roll", "roll0", "rx")),
    Column("p0", ("p0", "pitch", "pitch0", "ry")),
    Column("yaw0", ("y0", "yaw", "yaw0", "rz")),
    Column("Mass", ("mass", "m")),
    Column("CG", ("cg", "cog"), text=True),
    Column("I", ("i", "inertia"), text=True),
    Column("Volume", ("volume", "v", "vol")),
    Column("CdA", ("cda",), text=True),
    Column("Ca", ("ca",), text=True),
)


def read_bodies(table: Table, found: Findings) -> list[Body]:
    """Return the bodies of the section."""
    return [_body(record, found) for record in records(table, COLUMNS, found)]


def _body(record: Record, found: Findings) -> Body:
    source = record.source
    id = found.integer(record["ID"], "ID of a body", source)
    hold = read_hold(record["Attachment"], "body", found, source)

    def number(key: str) -> float:
        return found.number(record[key], f"{key} of body {id}", source)

    def values(key: str, counts: tuple[int, ...]) -> tuple[float, ...]:
        words = record[key].split("|")
        if len(words) not in counts:
            expected = " or ".join(map(str, counts))
            found.add(f"{key} of body {id} has {len(words)} values", f"give {expected}", source, record[key])
            return (0.0,)
        return found.numbers(words, f"{key} of body {id}", source)

    centre, inertia = values("CG", (1, 3)), values("I", (1, 3))
    x, y, z = centre if len(centre) == 3 else (0.0, 0.0, centre[0])
    ix, iy, iz = inertia if len(inertia) == 3 else inertia * 3
    return Body(
        id=id,
        kind=hold.kind,
        position=(number("X0"), number("Y0"), number("Z0")),
        rotation=(radians(number("r0")), radians(number("p0")), radians(number("yaw0"))),
        mass=number("Mass"),
        centre_of_gravity=(x, y, z),
        inertia=(ix, iy, iz),
        volume=number("Volume"),
        drag_area=_six(values("CdA", (1, 2, 3, 6))),
        added_mass=_added_mass(values("Ca", (1, 3))),
        turbine=hold.turbine,
        source=source,
    )


def _six(values: tuple[float, ...]) -> tuple[float, ...]:
    """Spread 1, 2 (translation, rotation), 3 (axes) or 6 values over six components."""
    if len(values) == 2:
        return (values[0],) * 3 + (values[1],) * 3
    return (values * 6)[:6]


def _added_mass(values: tuple[float, ...]) -> tuple[float, ...]:
    """Spread 1 or 3 values over the translations; MoorDyn has no added inertia of bodies."""
    return (values * 3)[:3] + (0.0,) * 3
