"""MoorDyn-F's driver file: environment, the model, its initial offset, and the motion of its coupled objects."""

from __future__ import annotations

import dataclasses
import difflib
import os
import warnings
from dataclasses import dataclass
from math import radians
from pathlib import Path

import numpy as np

from moorage.errors import ModelWarning, MotionError, Source
from moorage.io.moordyn.farm import only_turbines
from moorage.io.moordyn.reader import read_moordyn
from moorage.io.motion import read_motion
from moorage.io.text import Findings, Row, read_text, rows
from moorage.model import Body, Environment, Model, Motion, Rod, Turbine
from moorage.model.motion import MOVED, rotation_matrices

NAMES = {
    "gravity": "Gravity",
    "rhow": "rhoW",
    "wtrdpth": "WtrDpth",
    "wtrdepth": "WtrDpth",
    "mdinputfile": "MDInputFile",
    "outrootname": "OutRootName",
    "tmax": "TMax",
    "dtc": "dtC",
    "inputsmode": "InputsMode",
    "inputsmod": "InputsMode",
    "inputsfile": "InputsFile",
    "numturbines": "NumTurbines",
    "farmsize": "NumTurbines",
    "seastatefile": "SeaStateFile",
    "seastateinputfile": "SeaStateFile",
}
OPTIONAL = ("OutRootName", "SeaStateFile")


@dataclass(frozen=True)
class DriverCase:
    """What a driver file asks for: a model, its motion, the duration (s) and the interval of coupling (s)."""

    model: Model
    motion: Motion | None
    duration: float
    interval: float


def is_driver(text: str) -> bool:
    """Return whether a text is a driver file: it names a MoorDyn input file."""
    return any(row.words[1:2] and row.words[1].lower() == "mdinputfile" for row in rows(text, ""))


def read_driver(path: str | Path, raise_to_seabed: bool = False) -> DriverCase:
    """Read a driver file with the model and the motion that it names, relative to its folder."""
    path = Path(path)
    found = Findings()
    lines = rows(read_text(path, "driver file"), str(path))
    values = _values(lines, found, Source(str(path)))
    numbers = {
        name: found.number(values[name].words[0], name, values[name].source)
        for name in ("Gravity", "rhoW", "WtrDpth", "TMax", "dtC")
        if name in values
    }
    for name in ("TMax", "dtC"):
        if name in numbers and not numbers[name] > 0.0:
            found.add(f"{name} must be positive", "correct it", values[name].source, numbers[name])
    mode, turbines = (_integer(values, name, found) for name in ("InputsMode", "NumTurbines"))
    if mode not in (0, 1):
        found.add("InputsMode must be 0 or 1", "1 reads InputsFile", values["InputsMode"].source, mode)
    _find_file(values, "MDInputFile", path.parent, found)
    motionless = Findings()
    if mode == 1:
        _find_file(values, "InputsFile", path.parent, motionless)
    if turbines < 0:
        found.add("NumTurbines must not be negative", "0 is for one platform", values["NumTurbines"].source, turbines)
    offsets = _offsets(lines, max(1, turbines), found, Source(str(path)))
    found.raise_any()
    motionless.raise_any(MotionError)
    environment = Environment(water_depth=numbers["WtrDpth"], gravity=numbers["Gravity"], water_density=numbers["rhoW"])
    farm = tuple(_turbine(k + 1, *offset) for k, offset in enumerate(offsets)) if turbines else ()
    model = read_moordyn(path.parent / values["MDInputFile"].words[0], environment, raise_to_seabed, farm)
    if turbines:
        model = only_turbines(model)
    for k, (row, _) in enumerate(offsets):
        model = _offset(model, row, k + 1 if turbines else None)
    motion = read_motion(path.parent / values["InputsFile"].words[0], model) if mode == 1 else None
    return DriverCase(model, motion, _duration(numbers["TMax"], motion, values["TMax"].source), numbers["dtC"])


def _duration(asked: float, motion: Motion | None, source: Source) -> float:
    """Return the duration, cut to the end of the motion as MoorDyn-F's driver does."""
    if motion is None or motion.duration >= asked:
        return asked
    warnings.warn(
        f"{source}: motion ends at {motion.duration:g} s, TMax is {asked:g} s; the run ends with the motion",
        ModelWarning,
        stacklevel=2,
    )
    return motion.duration


def _values(lines: list[Row], found: Findings, source: Source) -> dict[str, Row]:
    """Return the rows `value name` of the first two sections by name."""
    values: dict[str, Row] = {}
    section = 0
    for row in lines:
        if "---" in row.text:
            section += 1
            if "POSITION" in row.text.upper():
                break
        elif section and row.words:
            name = NAMES.get(row.words[1].lower()) if len(row.words) > 1 else None
            if name:
                values[name] = row
            else:
                near = difflib.get_close_matches(" ".join(row.words[1:2]).lower(), NAMES, n=1)
                hint = f"did you mean {NAMES[near[0]]}?" if near else f"use {', '.join(dict.fromkeys(NAMES.values()))}"
                found.add("entry of the driver file is not known", hint, row.source, row.text.strip())
    for name in dict.fromkeys(NAMES.values()):
        if name not in values and name not in OPTIONAL:
            found.add(f"{name} is missing", f"add a row: value {name}", source)
    return values


def _find_file(values: dict[str, Row], name: str, folder: Path, found: Findings) -> None:
    """Note a file that the driver file names and that is not there."""
    if name not in values:
        return
    what = {"MDInputFile": "model", "InputsFile": "motion"}[name]
    word, source = values[name].words[0], values[name].source
    if not word:
        found.add(f"{name} is empty", f"name a {what} file", source)
    elif not os.path.exists(folder / word):  # unlike Path.exists, takes any name
        message = f"{what} file not found: tried {folder / word}"
        found.add(message, "correct the name (relative to the driver file), or put the file there", source, word)


def _integer(values: dict[str, Row], name: str, found: Findings) -> int:
    return found.integer(values[name].words[0], name, values[name].source) if name in values else 0


def _offsets(lines: list[Row], count: int, found: Findings, source: Source) -> list[tuple[tuple[float, ...], Source]]:
    """Return the rows of initial positions, with their places.

    Reference x, y, then surge, sway, heave (m) and roll, pitch, yaw (deg).

    The heading of these columns says rad; MoorDyn-F's driver multiplies them by pi/180, so they are degrees.
    """
    start = next((k for k, row in enumerate(lines) if "---" in row.text and "POSITION" in row.text.upper()), None)
    if start is None:
        found.add("section Initial Positions is missing", "add it, with names, units and a row of 8 numbers", source)
        return []
    body = [row for row in lines[start + 1 :] if row.text.strip()][2:]
    table = []
    for row in body[:count]:
        if len(row.words) != 8:
            found.add(f"row of initial positions has {len(row.words)} values", "give 8", row.source, row.text.strip())
        else:
            table.append((found.numbers(row.words, "initial position", row.source), row.source))
    if len(body) < count:
        found.add(f"there are {len(body)} rows of initial positions", f"give {count}", lines[start].source)
    if any(any(row[5:]) for row, _ in table):
        warnings.warn(
            f"{body[0].source}: initial angles are read in degrees, as MoorDyn-F does (its heading says rad)",
            ModelWarning,
            stacklevel=2,
        )
    return table


def _turbine(id: int, row: tuple[float, ...], source: Source) -> Turbine:
    """Return a turbine; the reference position (the first two numbers) counts in FAST.Farm mode only."""
    return Turbine(id=id, position=(row[0], row[1], 0.0), source=source)


def _offset(model: Model, row: tuple[float, ...], turbine: int | None) -> Model:
    """Return the model with the coupled objects of a turbine moved, or of the platform where there are no turbines.

    R = Rz(yaw) Ry(pitch) Rx(roll) about the reference point, then translated (MD_Init).
    """
    if not any(row[2:]):
        return model
    shift = np.array(row[2:5])
    rotation = _rotation_zyx(*map(radians, row[5:]))

    coupled = {point.id for point in model.coupled_points if point.turbine == turbine}

    def moved(position: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = (rotation @ np.array(position) + shift).tolist()
        return x, y, z

    return dataclasses.replace(
        model,
        points=tuple(
            dataclasses.replace(p, position=moved(p.position)) if p.id in coupled else p for p in model.points
        ),
        rods=tuple(
            dataclasses.replace(r, end_a=moved(r.end_a), end_b=moved(r.end_b)) if _follows(r, turbine) else r
            for r in model.rods
        ),
        bodies=tuple(_turned(b, rotation, moved(b.position)) if _follows(b, turbine) else b for b in model.bodies),
    )


def _follows(thing: Body | Rod, turbine: int | None) -> bool:
    return thing.kind in MOVED and thing.turbine == turbine


def _turned(body: Body, rotation: np.ndarray, position: tuple[float, float, float]) -> Body:
    """Return a body at a new position, with a rotation applied before its own (as intrinsic XYZ angles)."""
    r = rotation @ rotation_matrices(np.array([body.rotation]))[0]
    angles = (
        float(np.arctan2(-r[1, 2], r[2, 2])),
        float(np.arcsin(np.clip(r[0, 2], -1.0, 1.0))),
        float(np.arctan2(-r[0, 1], r[0, 0])),
    )
    return dataclasses.replace(body, position=position, rotation=angles)


def _rotation_zyx(roll: float, pitch: float, yaw: float) -> np.ndarray:
    x, y, z = (rotation_matrices(np.array([angles]))[0] for angles in ((roll, 0, 0), (0, pitch, 0), (0, 0, yaw)))
    return z @ y @ x
