"""Waves and currents as MoorDyn's options name them: C's WaveKin and Currents, F's WaterKin file."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import radians
from pathlib import Path
from typing import NamedTuple

from moorage.errors import ModelError, Source
from moorage.io.moordyn import currents, water_grid, wave_files
from moorage.io.moordyn.options import Value
from moorage.io.tables import current_profile, read_current
from moorage.io.text import Findings, Row, is_number, read_text, rows, to_float
from moorage.model import Current, CurrentGrid, UnreadWater, Waves

_WAVE_MODES = (0, 1, 2, 3, 4, 5, 6, 7)
_CURRENT_MODES = (0, 1, 2, 3, 4, 5)
_CURRENT_FILES: dict[int, tuple[str, Callable[[Path, Findings, Source], Current | CurrentGrid]]] = {
    1: ("current_profile.txt", read_current),
    2: (currents.DYNAMIC, currents.read_changing_profile),
    5: (currents.GRID, currents.read_current_grid),
}
_STEP = 0.25  # s, MoorDyn-C's dtWave


class Water(NamedTuple):
    """What moves the water: waves, a current, what is asked for and not simulated, and whether a host gives waves."""

    waves: Waves | None = None
    current: Current | CurrentGrid = Current()
    unread: UnreadWater | None = None
    from_host: bool = False


class Surroundings(NamedTuple):
    """What the readers of waves need to know of a model: water, where its files are, what it is held by, findings."""

    water: dict[str, float]  # depth, gravity and density, as Waves has them
    folder: Path
    places: Sequence[water_grid.Place]
    found: Findings


def read_water(values: dict[str, Value], around: Surroundings) -> Water:
    """Return the sea that the options ask for."""
    if "WaterKin" in values:
        return _water_file(values["WaterKin"], around)
    found = around.found
    mode, kind = _mode(values, "WaveKin", _WAVE_MODES, found), _mode(values, "Currents", _CURRENT_MODES, found)
    if mode in (4, 5, 6):
        source = values["WaveKin"].source
        settings = tuple((name, values[name].word) for name in ("Currents", "dtWave") if name in values)
        return Water(unread=UnreadWater(option="WaveKin", value=str(mode), settings=settings, source=source))
    current: Current | CurrentGrid = Current()
    if kind in _CURRENT_FILES:
        name, read = _CURRENT_FILES[kind]
        current = read(around.folder / name, found, values["Currents"].source)
    unread = None
    if kind in (3, 4):
        source = values["Currents"].source
        unread = UnreadWater(option="Currents", value=str(kind), source=source)
    return Water(_waves(mode, values, around) if mode > 1 else None, current, unread, from_host=mode == 1)


def _waves(mode: int, values: dict[str, Value], around: Surroundings) -> Waves | None:
    """Return the waves of WaveKin 2, 3 or 7; of the grid that 2 and 3 need, only its extent is looked at."""
    folder, found, named = around.folder, around.found, values["WaveKin"].source
    if mode == 7:
        return wave_files.summed(folder / "wave_frequencies.txt", around.water, found, named)
    if mode == 2:
        waves = wave_files.evenly_spaced(folder / "wave_frequencies.txt", around.water, found, named)
    else:
        step = _interval(values["dtWave"].word, values["dtWave"].source, found) if "dtWave" in values else _STEP
        path = folder / "wave_elevation.txt"
        waves = wave_files.transformed(path, step, 0.0, around.water, found, named, "WaveKin 3") if step else None
    path = folder / "water_grid.txt"
    grid = water_grid.read_grid(path, found, named) if path.exists() else None
    if grid and waves:
        water_grid.warn_of_short_grid(grid, waves, around.places, Source(str(path)), around.water["depth"])
    return waves


def _interval(word: str, source: Source, found: Findings) -> float:
    """Return a step of time; 0, and a problem noted, when it is not positive."""
    step = found.number(word, "dtWave", source)
    if step <= 0.0:
        found.add("dtWave must be positive", "give the step of the elevations, s", source, word)
    return max(step, 0.0) if step == step else 0.0


def _mode(values: dict[str, Value], name: str, known: tuple[int, ...], found: Findings) -> int:
    value = values.get(name)
    if value is None or not is_number(value.word):
        return 0
    mode = int(to_float(value.word))
    if mode not in known:
        found.add(f"option {name} has no mode {mode}", f"use one of {known}", value.source, value.word)
    return mode


def _water_file(value: Value, around: Surroundings) -> Water:
    """Read MoorDyn-F's file of waves and currents; what is not simulated stays as an asked-for sea."""
    asked = UnreadWater(option="WaterKin", value=value.word, source=value.source)
    if not value.word:
        return Water()
    if value.word.upper() == "SEASTATE":
        return Water(unread=asked)
    path, found = around.folder / value.word, around.found
    try:
        lines = rows(read_text(path, "water kinematics file", source=value.source), str(path))
    except ModelError as error:
        found.extend(error.problems)
        return Water()
    wave_rows, current_rows = _section(lines, "WAVES"), _section(lines, "CURRENT")
    mode = _first_integer(wave_rows, "WaveKinMod", found, Source(str(path)))
    kind = _first_integer(current_rows, "CurrentMod", found, Source(str(path)))
    current = _profile(current_rows[1:], found, Source(str(path))) if kind == 1 else Current()
    waves = _waves_of_f(wave_rows, mode, around) if mode in ELEVATION_MODES else None
    refused = (mode and mode not in ELEVATION_MODES) or kind > 1
    return Water(waves, current, asked if refused else None)


ELEVATION_MODES = (1, 3)  # 3 is what files before OpenFAST 4 call it


def _waves_of_f(section: list[Row], mode: int, around: Surroundings) -> Waves | None:
    """Return the waves of a file of elevations; rows: mode, file, dtWave, WaveDir (deg), type and grid of x, y, z."""
    found, place = around.found, section[0].source
    if len(section) < 10:
        remedy = "give WaveKinMod, WaveKinFile, dtWave, WaveDir, then a type and coordinates for x, y and z"
        found.add(f"section WAVES has {len(section)} rows, not 10", remedy, place)
        return None
    name, step, direction = (row.words[0] for row in section[1:4])
    if not name:
        found.add("WaveKinFile is empty", "name a file of time and elevation", section[1].source)
        return None
    interval = _interval(step, section[2].source, found)
    way = found.number(direction, "WaveDir", section[3].source)
    grid = water_grid.read_axes(section[4:10], found)
    if not (interval and grid and way == way):
        return None
    path = around.folder / name
    source, kind = section[1].source, f"WaveKinMod {mode}"
    waves = wave_files.transformed(path, interval, radians(way), around.water, found, source, kind)
    if waves:
        water_grid.warn_of_short_grid(grid, waves, around.places, Source(place.file), around.water["depth"])
    return waves


def _section(lines: list[Row], title: str) -> list[Row]:
    """Return the rows between the line of dashes with a title and the next line of dashes."""
    starts = [k for k, row in enumerate(lines) if "---" in row.text and title in row.text.upper()]
    if not starts:
        return []
    rest = lines[starts[0] + 1 :]
    end = next((k for k, row in enumerate(rest) if "---" in row.text), len(rest))
    return [row for row in rest[:end] if row.words]


def _first_integer(section: list[Row], what: str, found: Findings, source: Source) -> int:
    if not section:
        found.add(f"{what} is missing", "give the sections WAVES and CURRENT, each starting with its mode", source)
        return 0
    return found.integer(section[0].words[0], what, section[0].source)


def _profile(section: list[Row], found: Findings, source: Source) -> Current:
    table = [
        found.numbers(row.words[:3], "current profile", row.source)
        for row in section
        if len(row.words) >= 3 and all(map(is_number, row.words[:3]))
    ]
    if not table:
        found.add("current profile has no rows of z, u and v", "add rows of three numbers", source)
    if any(row[0] > 0.0 for row in table):
        found.add(
            "levels of the current profile are above the water (MoorDyn-F reads z, not depth)",
            "write z, negative below the water",
            source,
        )
    return current_profile(table, source)
