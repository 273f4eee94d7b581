"""LINE TYPES: numbers, bar-separated values and names of table files."""

from __future__ import annotations

import dataclasses
import os
from pathlib import Path

from moorage.errors import Source
from moorage.io.moordyn.columns import Column, Record, records
from moorage.io.moordyn.sections import Table
from moorage.io.tables import read_curve
from moorage.io.text import Findings, is_number
from moorage.model import Curve, LineType

COLUMNS = (
    Column("TypeName", ("typename", "name", "linetype", "type"), text=True),
    Column("Diam", ("diam", "d", "diameter")),
    Column("Mass/m", ("mass/m", "massden", "massdeninair", "mass", "w", "massperlength")),
    Column("EA", ("ea",), text=True),
    Column("BA/-zeta", ("ba/-zeta", "ba", "-zeta", "cintdamp", "ba/zeta"), text=True),
    Column("EI", ("ei",), text=True),
    Column("Cd", ("cd", "cdn")),
    Column("Ca", ("ca", "can")),
    Column("CdAx", ("cdax", "cdt")),
    Column("CaAx", ("caax", "cat")),
    Column("Cl", ("cl",), optional=True),
    Column("dF", ("df",), optional=True),
    Column("cF", ("cf",), optional=True),
)
V1_COLUMNS = tuple(
    dataclasses.replace(next(c for c in COLUMNS if c.key == key), optional=False)
    for key in ("TypeName", "Diam", "Mass/m", "EA", "BA/-zeta", "Ca", "CaAx", "Cd", "CdAx")
)


def read_line_types(table: Table, columns: tuple[Column, ...], folder: Path, found: Findings) -> list[LineType]:
    """Return the line types of the section."""
    return [_line_type(record, folder, found) for record in records(table, columns, found)]


def _line_type(record: Record, folder: Path, found: Findings) -> LineType:
    source, name = record.source, record["TypeName"]

    def number(key: str, default: float = 0.0) -> float:
        return found.number(record[key], f"{key} of line type {name}", source) if key in record.words else default

    stiffness, viscoelastic, syrope = _stiffness(record["EA"], name, folder, found, source)
    damping, ratio, dynamic = _damping(record["BA/-zeta"], 1 + len(viscoelastic), name, folder, found, source)
    bending, bending_damping = _bending(record.get("EI", "0"), name, folder, found, source)
    return LineType(
        name=name,
        diameter=number("Diam"),
        mass_per_length=number("Mass/m"),
        axial_stiffness=stiffness,
        axial_damping=damping,
        axial_damping_ratio=ratio,
        bending_stiffness=bending,
        bending_damping=bending_damping,
        transverse_drag=number("Cd"),
        tangential_drag=number("CdAx"),
        transverse_added_mass=number("Ca"),
        tangential_added_mass=number("CaAx"),
        lift_coefficient=number("Cl"),
        viv_range=number("dF", 0.08),
        viv_centre=number("cF", 0.18),
        viscoelastic=viscoelastic,
        dynamic_damping=sum(dynamic, 0.0),
        syrope=syrope,
        source=source,
    )


def _value(word: str, what: str, folder: Path, found: Findings, source: Source) -> float | Curve:
    """Return a number, or the table in the file that a word names."""
    if is_number(word) or word.lower().lstrip("+-") in ("nan", "inf", "infinity") or not any(map(str.isalpha, word)):
        return found.number(word, what, source)
    return read_curve(folder, word, what, found, source)


def _stiffness(
    word: str, name: str, folder: Path, found: Findings, source: Source
) -> tuple[float | Curve, tuple[float, ...], str]:
    """Return EA, the dynamic stiffness values and the Syrope file: EA, EA|EA_D, EA|EA_Dc|EA_D_Lm, SYROPE:file|.|."""
    first, *dynamic = word.split("|")
    what = f"EA of line type {name}"
    if len(dynamic) > 2:
        found.add(f"{what} has {len(dynamic) + 1} values", "give at most 3, separated by bars", source, word)
    values = found.numbers(dynamic, what, source)
    if first.upper().startswith("SYROPE:"):
        if len(dynamic) != 2:
            found.add(f"{what} is incomplete", "write SYROPE:file|EA_Dc|EA_D_Lm", source, word)
        file = first[len("SYROPE:") :]
        if not os.path.isfile(folder / file):  # unlike Path.is_file, takes any name
            found.add(f"Syrope file of line type {name} not found", f"tried {folder / file}", source, file)
        return 0.0, values, file
    return _value(first, what, folder, found, source), values, ""


def _damping(
    word: str, most: int, name: str, folder: Path, found: Findings, source: Source
) -> tuple[float | Curve, float | None, tuple[float, ...]]:
    """Return BA, the damping ratio (a negative BA) and the dynamic damping of a viscoelastic type."""
    first, *dynamic = word.split("|")
    what = f"BA of line type {name}"
    if len(dynamic) + 1 > min(most, 2):
        found.add(f"{what} has more values than its EA allows", f"give at most {min(most, 2)}", source, word)
    value = _value(first, what, folder, found, source)
    values = found.numbers(dynamic, what, source)
    if isinstance(value, float) and value < 0.0:
        return 0.0, -value, values
    return value, None, values


def _bending(word: str, name: str, folder: Path, found: Findings, source: Source) -> tuple[float | Curve, float]:
    """Return EI and the internal bending damping, MoorDyn's EI|BI."""
    first, *damping = word.split("|")
    what = f"EI of line type {name}"
    if len(damping) > 1:
        found.add(f"{what} has {len(damping) + 1} values", "give at most 2, separated by bars", source, word)
    value = _value(first, what, folder, found, source)
    return value, found.number(damping[0], what, source) if damping else 0.0
