"""FAST.Farm's primary input file: where the turbines are, and which file of MoorDyn moors them together."""

from __future__ import annotations

import dataclasses
import difflib
import warnings
from pathlib import Path
from typing import NamedTuple

from moorage.errors import ModelWarning, Source
from moorage.io.moordyn.reader import read_moordyn
from moorage.io.text import Findings, Row, read_text, rows
from moorage.model import Model, Turbine
from moorage.model.motion import MOVED

SWITCH = "mod_sharedmooring"


class FarmCase(NamedTuple):
    """What FAST.Farm's file says of a mooring: the model, and the duration of the run, s."""

    model: Model
    duration: float


def is_farm(text: str) -> bool:
    """Return whether a text is FAST.Farm's primary input file."""
    return any(row.words[1:2] and row.words[1].lower() == SWITCH for row in rows(text, ""))


def read_farm(path: str | Path, raise_to_seabed: bool = False) -> FarmCase:
    """Read the shared mooring of a FAST.Farm input file, with the reference positions of its turbines.

    Where the platforms start is in the OpenFAST files of the turbines, which are not read.
    """
    path, found = Path(path), Findings()
    lines = [row for row in rows(read_text(path, "FAST.Farm file"), str(path)) if row.text.strip()]
    values = {row.words[1].lower(): row for row in lines if len(row.words) > 1}
    named = _mooring(lines, values, path, found)
    turbines = _turbines(lines, values, found, Source(str(path)))
    row = values.get("tmax")
    duration = found.number(row.words[0], "TMax", row.source) if row else 0.0
    found.raise_any()
    assert named is not None
    return FarmCase(only_turbines(read_moordyn(named, None, raise_to_seabed, turbines)), duration)


def _mooring(lines: list[Row], values: dict[str, Row], path: Path, found: Findings) -> Path | None:
    """Return the model file: what stands below the heading of the shared mooring, whatever its name."""
    switch = values[SWITCH]
    if switch.words[0] == "0":
        found.add("there is no shared mooring", "set it to 3, and name its file", switch.source, "Mod_SharedMooring 0")
        return None
    start = next((k for k, row in enumerate(lines) if "SHARED MOORING" in row.text.upper() and "--" in row.text), None)
    if start is None or start + 1 == len(lines) or not lines[start + 1].words:
        found.add("section SHARED MOORING SYSTEM is missing", "add it, with the name of a file", switch.source)
        return None
    row = lines[start + 1]
    named = path.parent / row.words[0]
    if not named.is_file():
        remedy = "correct the name (relative to this file), or put the file there"
        found.add(f"model file not found: tried {named}", remedy, row.source, row.words[0])
    return named


def _turbines(lines: list[Row], values: dict[str, Row], found: Findings, source: Source) -> tuple[Turbine, ...]:
    """Return the turbines of the table below NumTurbines and its two rows of headings."""
    row = values.get("numturbines")
    if row is None:
        near = difflib.get_close_matches("numturbines", values, n=1)
        hint = f"; did you mean it by {near[0]}?" if near else ""
        found.add("NumTurbines is missing", f"add it with the table of turbines{hint}", source)
        return ()
    count = found.integer(row.words[0], "NumTurbines", row.source)
    body = lines[lines.index(row) + 3 :][: max(count, 0)]
    turbines = []
    for k, entry in enumerate(body):
        if len(entry.words) < 4:
            found.add(
                f"row of turbine {k + 1} is too short", "give x, y, z and a file", entry.source, entry.text.strip()
            )
            continue
        x, y, z = found.numbers(entry.words[:3], f"position of turbine {k + 1}", entry.source)
        turbines.append(Turbine(id=k + 1, position=(x, y, z), source=entry.source))
    if len(body) < count or count < 1:
        found.add(f"there are {len(body)} rows of turbines for NumTurbines {count}", "correct one", row.source)
    return tuple(turbines)


def only_turbines(model: Model) -> Model:
    """Return the model of a farm with what is Coupled on turbine 1, as MoorDyn-F takes it; a warning tells."""

    def loose(thing) -> bool:
        return thing.kind in MOVED and thing.turbine is None and getattr(thing, "body", None) is None

    def taken(things):
        return tuple(dataclasses.replace(thing, turbine=1) if loose(thing) else thing for thing in things)

    names = [f"point {p.id}" for p in model.points if loose(p)] + [f"rod {r.id}" for r in model.rods if loose(r)]
    names += [f"body {b.id}" for b in model.bodies if loose(b)]
    if not names:
        return model
    warnings.warn(
        f"{model.file}: no turbine is said for coupled {', '.join(names)}; taken as Turbine1, as MoorDyn-F does",
        ModelWarning,
        stacklevel=2,
    )
    return dataclasses.replace(model, points=taken(model.points), rods=taken(model.rods), bodies=taken(model.bodies))
