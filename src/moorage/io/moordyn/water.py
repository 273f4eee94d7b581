"""Waves and currents as MoorDyn's options name them: C's WaveKin and Currents, F's WaterKin file."""

from __future__ import annotations

from pathlib import Path

from moorage.errors import ModelError, Source
from moorage.io.moordyn.options import Value
from moorage.io.tables import current_profile, read_current
from moorage.io.text import Findings, Row, is_number, read_text, rows, to_float
from moorage.model import Current, UnreadWater

Water = tuple[UnreadWater | None, Current]
_WAVE_MODES = (0, 1, 2, 3, 4, 5, 6, 7)
_CURRENT_MODES = (0, 1, 2, 3, 4, 5)


def read_water(values: dict[str, Value], folder: Path, found: Findings) -> Water:
    """Return the sea that the options ask for, and the steady current."""
    if "WaterKin" in values:
        return _water_file(values["WaterKin"], folder, found)
    waves, mode = _mode(values, "WaveKin", _WAVE_MODES, found), _mode(values, "Currents", _CURRENT_MODES, found)
    current = Current()
    if mode == 1:
        current = read_current(folder / "current_profile.txt", found, values["Currents"].source)
    beside = ("Currents", "dtWave", "UnifyCurrentGrid")
    settings = tuple((name, values[name].word) for name in beside if name in values)
    if waves:
        source = values["WaveKin"].source
        return UnreadWater(option="WaveKin", value=str(waves), settings=settings, source=source), current
    if mode > 1:
        source = values["Currents"].source
        return UnreadWater(option="Currents", value=str(mode), settings=settings, source=source), current
    return None, current


def _mode(values: dict[str, Value], name: str, known: tuple[int, ...], found: Findings) -> int:
    value = values.get(name)
    if value is None or not is_number(value.word):
        return 0
    mode = int(to_float(value.word))
    if mode not in known:
        found.add(f"option {name} has no mode {mode}", f"use one of {known}", value.source, value.word)
    return mode


def _water_file(value: Value, folder: Path, found: Findings) -> Water:
    """Read MoorDyn-F's file of waves and currents; what is more than a steady current stays as an asked-for sea."""
    asked = UnreadWater(option="WaterKin", value=value.word, source=value.source)
    if not value.word:
        return None, Current()
    if value.word.upper() == "SEASTATE":
        return asked, Current()
    path = folder / value.word
    try:
        lines = rows(read_text(path, "water kinematics file", source=value.source), str(path))
    except ModelError as error:
        found.extend(error.problems)
        return None, Current()
    wave_rows, current_rows = _section(lines, "WAVES"), _section(lines, "CURRENT")
    waves = _first_integer(wave_rows, "WaveKinMod", found, Source(str(path)))
    mode = _first_integer(current_rows, "CurrentMod", found, Source(str(path)))
    current = _profile(current_rows[1:], found, Source(str(path))) if mode == 1 else Current()
    return (asked if waves or mode > 1 else None), current


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
