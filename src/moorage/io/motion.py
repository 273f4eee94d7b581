"""Motion files: MoorDyn-F's rows of numbers, and CSV files with named columns and units.

MoorDyn-F's file has no header: time (s), then the coordinates of every coupled body, rod and point in the order of the
model file (m and rad), with `#` comments. A CSV file names its columns: `time[s]`, then `surge[m], sway[m], heave[m],
roll[deg], pitch[deg], yaw[deg]` of one rigid platform about the origin, `turbine2.surge[m]` and so on of a turbine
about its reference position, or `point4.x[m], point4.y[m], point4.z[m]` for the absolute position of one coupled point.
"""

from __future__ import annotations

import dataclasses
import difflib
import re
from dataclasses import dataclass
from math import pi
from pathlib import Path

import numpy as np

from moorage.errors import MotionError, Source
from moorage.io.text import Findings, Row, is_number, read_text, rows
from moorage.model import Model, Motion

PLATFORM = ("surge", "sway", "heave", "roll", "pitch", "yaw")
UNITS = {"time": {"s": 1.0}, "length": {"m": 1.0}, "angle": {"rad": 1.0, "deg": pi / 180.0}}


def read_motion(path: str | Path, model: Model | None = None) -> Motion:
    """Read a motion file of either kind, told apart by its header.

    Parameters
    ----------
    model : Model, optional
        The model that it moves; with it, the columns are checked against the coupled objects.
    """
    path = Path(path)
    source = Source(str(path))
    found = Findings()
    lines = [row for row in rows(read_text(path, "motion file", MotionError), str(path)) if row.words]
    if not lines:
        found.add("motion file has no rows", "add time and coordinates", source)
        found.raise_any(MotionError)
    if is_number(_cells(lines[0])[0]):
        table = _table(lines, len(_cells(lines[0])), found)
        motion = Motion(table[:, 0], coupled=table[:, 1:], source=source)
    else:
        motion = _named(lines, found, source)
    if model is not None:
        motion.resolve(model)
    return motion


def _cells(row: Row) -> list[str]:
    """Return the values of a row, separated by commas, semicolons, tabs or blanks."""
    return re.split(r"[\s,;]+", " ".join(row.words).strip(" ,;"))


def _table(lines: list[Row], width: int, found: Findings) -> np.ndarray:
    """Return rows of `width` numbers with increasing time, or raise with every row that is not."""
    table: list[tuple[float, ...]] = []
    for row in lines:
        cells = _cells(row)
        if len(cells) != width:
            found.add(
                f"row has {len(cells)} columns, the first one {width}", "correct it", row.source, row.text.strip()
            )
        else:
            values = found.numbers(cells, "value", row.source)
            if table and not values[0] > table[-1][0]:
                remedy = f"the time after {table[-1][0]:g} s must be larger"
                found.add("time does not increase", remedy, row.source, values[0])
            table.append(values)
    if width < 2:
        found.add("motion file has no columns after time", "add coordinates", lines[0].source)
    if len(lines) < 2:
        found.add("motion file has one row", "give at least two", lines[0].source)
    found.raise_any(MotionError)
    return np.array(table)


@dataclass(frozen=True)
class _Heading:
    """What a column holds: an owner ("time", "platform", "turbine 2", "point 4"), a component, and a factor to SI."""

    owner: str
    component: int
    factor: float


def _named(lines: list[Row], found: Findings, source: Source) -> Motion:
    header, body = lines[0], lines[1:]
    names = [name.strip() for name in re.split(r"[,;\t]", header.text.split("#")[0]) if name.strip()]
    if len(names) == 1:
        names = names[0].split()
    headings = [_heading(name, found, header.source) for name in names]
    found.raise_any(MotionError)
    _complete([h for h in headings if h], found, header.source)
    if not body:
        found.add("motion file has no rows after its header", "add rows of numbers", header.source)
    found.raise_any(MotionError)
    table = _table(body, len(names), found)
    columns: dict[str, dict[int, np.ndarray]] = {}
    for heading, values in zip(headings, table.T, strict=True):
        if heading:
            columns.setdefault(heading.owner, {})[heading.component] = values * heading.factor
    stacked = {owner: np.stack([parts[k] for k in sorted(parts)], axis=-1) for owner, parts in columns.items()}
    time, platform = stacked.pop("time")[:, 0], stacked.pop("platform", None)
    turbines, points = (
        {int(owner.split()[1]): values for owner, values in stacked.items() if owner.startswith(kind)}
        for kind in ("turbine", "point")
    )
    return Motion(time, platform=platform, turbines=turbines, points=points, source=source)


def motion_of_turbines(model: Model) -> Motion | None:
    """Return the motion that a native file gives its turbines, from the files that it names; None where it gives none.

    Raises
    ------
    MotionError
        Only some of the turbines have one, or a file of them moves no platform.
    """
    named = [turbine for turbine in model.turbines if turbine.motion]
    if not named:
        return None
    found = Findings()
    for turbine in model.turbines:
        if not turbine.motion:
            message = f"turbine {turbine.id} has no motion, others have"
            found.add(message, "name a file (with zeros where it rests)", turbine.source)
    found.raise_any(MotionError)
    motions = {turbine.id: read_motion(Path(model.file).parent / turbine.motion) for turbine in named}
    for turbine in named:
        if motions[turbine.id].platform is None:
            message = f"motion of turbine {turbine.id} has no columns of a platform"
            found.add(message, f"give time[s], {', '.join(PLATFORM)}", turbine.source, turbine.motion)
    found.raise_any(MotionError)
    return dataclasses.replace(Motion.from_turbines(motions), source=Source(model.file))


def _heading(name: str, found: Findings, source: Source) -> _Heading | None:
    match = re.fullmatch(r"([a-z0-9_. ]+?)\s*(?:[\[(]\s*([^\])]*?)\s*[\])])?", name.lower())
    word, unit = (match[1].strip(), match[2]) if match else (name.lower(), None)
    owner, component, dimension = _meaning(word)
    if not owner:
        every = ["time", *PLATFORM, "point1.x", "point1.y", "point1.z", *(f"turbine1.{part}" for part in PLATFORM)]
        nearest = difflib.get_close_matches(word, every, n=1)
        hint = f"did you mean {nearest[0]}? " if nearest else ""
        remedy = f"{hint}use time[s], {', '.join(PLATFORM)}, turbine2.surge[m], or point4.x[m]"
        found.add("motion column is not known", remedy, source, name)
        return None
    factor = UNITS[dimension].get(unit or "")
    if factor is None:
        known = " or ".join(f"{word}[{unit}]" for unit in UNITS[dimension])
        found.add(
            f"unit of motion column {word} is " + ("missing" if not unit else "not known"),
            f"write {known}",
            source,
            name,
        )
        return None
    return _Heading(owner, component, factor)


def _meaning(word: str) -> tuple[str, int, str]:
    """Return owner, component and dimension of a column's name; no owner for an unknown one."""
    if word in ("time", "t"):
        return "time", 0, "time"
    if word in PLATFORM:
        component = PLATFORM.index(word)
        return "platform", component, "length" if component < 3 else "angle"
    match = re.fullmatch(rf"turbine\s*(\d+)\.({'|'.join(PLATFORM)})", word)
    if match:
        _, component, dimension = _meaning(match[2])
        return f"turbine {int(match[1])}", component, dimension
    match = re.fullmatch(r"point\s*(\d+)\.([xyz])", word)
    if match:
        return f"point {int(match[1])}", "xyz".index(match[2]), "length"
    return "", 0, ""


def _complete(headings: list[_Heading], found: Findings, source: Source) -> None:
    """Note components that are missing or given twice."""
    owners = {"time": ("time[s]",)} | {h.owner: _names_of(h.owner) for h in headings if h.owner != "time"}
    for owner, names in owners.items():
        given = [h.component for h in headings if h.owner == owner]
        missing = [name for k, name in enumerate(names) if k not in given]
        if missing:
            found.add(f"motion column {', '.join(missing)} is missing", "add it (zeros when it rests)", source)
        twice = sorted({names[k] for k in given if given.count(k) > 1})
        if twice:
            found.add(f"motion column {', '.join(twice)} appears twice", "remove one", source)
    if len(owners) == 1:
        found.add("motion file has no columns after time", f"add {', '.join(PLATFORM)}, or point4.x[m], ...", source)


def _names_of(owner: str) -> tuple[str, ...]:
    """Return the names of the columns of a platform, a turbine or a point."""
    if owner == "platform":
        return PLATFORM
    parts: tuple[str, ...] = PLATFORM if owner.startswith("turbine") else ("x", "y", "z")
    return tuple(f"{owner.replace(' ', '')}.{part}" for part in parts)


Motion.reader = read_motion
