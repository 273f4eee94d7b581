"""OPTIONS: value first, then the name, in any case; every alias that MoorDyn-C and MoorDyn-F accept."""

from __future__ import annotations

import difflib
import warnings
from dataclasses import dataclass
from typing import Literal

from moorage.errors import ModelWarning, Source
from moorage.io.moordyn.sections import Table
from moorage.io.text import Findings, Row, is_number
from moorage.model import UnusedOption

Kind = Literal["number", "integer", "text", "number or text", "switch"]


@dataclass(frozen=True)
class Option:
    """An option: its main name, what its value is, its other names, whose it is, and why it is not used."""

    name: str
    kind: Kind
    aliases: tuple[str, ...] = ()
    program: Literal["", "MoorDyn-C", "MoorDyn-F"] = ""
    unused: str = ""


_STEP = "Moorage chooses its own time step"
_START = "statics are solved directly, without relaxation in time"
_LOG = "it only concerns what the other program writes"

OPTIONS = (
    Option("g", "number", ("gravity",)),
    Option("rho", "number", ("rhow", "wtrdnsty")),
    Option("WtrDpth", "number or text", ("depth", "waterdepth")),
    Option("kBot", "number", ("kb",)),
    Option("cBot", "number", ("cb",)),
    Option("TmaxIC", "number", ("ictmax",)),
    Option("dtOut", "number"),
    Option("SeafloorFile", "text", (), "MoorDyn-C"),
    Option("FrictionCoefficient", "number", (), "MoorDyn-C"),
    Option("FricDamp", "number", ("cv",)),
    Option("StatDynFricScale", "number", ("mc",)),
    Option("mu_kT", "number", (), "MoorDyn-F"),
    Option("mu_kA", "number", (), "MoorDyn-F"),
    Option("WaveKin", "integer", (), "MoorDyn-C"),
    Option("Currents", "integer", (), "MoorDyn-C"),
    Option("dtWave", "number", (), "MoorDyn-C"),
    Option(
        "UnifyCurrentGrid", "switch", (), "MoorDyn-C", "waves and current are evaluated at the nodes, without a grid"
    ),
    Option("WaterKin", "text", (), "MoorDyn-F"),
    Option("dtM", "number", ("dt",), "", _STEP),
    Option("CFL", "number", (), "MoorDyn-C", _STEP),
    Option("tScheme", "text", (), "", _STEP),
    Option("dtIC", "number", ("icdt",), "", _START),
    Option("threshIC", "number", ("icthresh",), "", _START),
    Option("CdScaleIC", "number", ("icdfac",), "", _START),
    Option("ICgenDynamic", "number", ("gendynamicic",), "", _START),
    Option("fileIC", "text", ("icfile",), "MoorDyn-C", _START),
    Option("writeLog", "integer", (), "", _LOG),
    Option("WriteUnits", "integer", (), "MoorDyn-C", _LOG),
    Option("disableOutput", "switch", (), "", _LOG),
    Option("disableOutTime", "switch", (), "", _LOG),
    Option("OutSwitch", "integer", (), "MoorDyn-F", _LOG),
    Option("inertialF", "integer", (), "MoorDyn-F", "forces on coupled objects are always given with their inertia"),
    Option("inertialF_rampT", "number", (), "MoorDyn-F", "forces on coupled objects are never ramped"),
)
BY_NAME = {name.lower(): option for option in OPTIONS for name in (option.name, *option.aliases)}


@dataclass(frozen=True)
class Value:
    """An option as read."""

    option: Option
    word: str
    source: Source


def read_options(table: Table, found: Findings) -> dict[str, Value]:
    """Return the options of the section by their main name; unknown names and wrong values are noted."""
    values: dict[str, Value] = {}
    for row in table.rows:
        value = _read_row(row, found)
        if value is None:
            continue
        earlier = values.get(value.option.name)
        if earlier is not None:
            warnings.warn(
                f"{row.source}: option {value.option.name} was given before ({earlier.source}); the last one counts",
                ModelWarning,
                stacklevel=2,
            )
        values[value.option.name] = value
    return values


def _read_row(row: Row, found: Findings) -> Value | None:
    if len(row.words) < 2:
        found.add(
            "an option needs a value and a name", "write the value first: 200 WtrDpth", row.source, row.text.strip()
        )
        return None
    word, name = row.words[:2]
    option = BY_NAME.get(name.lower())
    if option is None:
        found.add(*_unknown(word, name), row.source, " ".join(row.words[:2]))
        return None
    _check_value(option, word, row.source, found)
    return Value(option, word, row.source)


def _unknown(word: str, name: str) -> tuple[str, str]:
    if word.lower() in BY_NAME and is_number(name):
        return "the option's name stands before its value", f"write the value first: {name} {word}"
    nearest = difflib.get_close_matches(name.lower(), BY_NAME, n=1)
    known = ", ".join(option.name for option in OPTIONS)
    remedy = f"did you mean {BY_NAME[nearest[0]].name}?" if nearest else f"remove it, or use one of {known}"
    return f"option {name!r} is not known", remedy


def _check_value(option: Option, word: str, source: Source, found: Findings) -> None:
    what = f"option {option.name}"
    if option.kind == "number":
        found.number(word, what, source)
    elif option.kind == "integer":
        found.integer(word, what, source)
    elif option.kind == "switch" and word.lower() not in ("0", "1", "true", "false"):
        found.add(f"{what} is a switch", "write 0 or 1", source, word)


def unused(values: dict[str, Value]) -> tuple[UnusedOption, ...]:
    """Return the options that mean nothing here, with the reason."""
    return tuple(
        UnusedOption(name=v.option.name, value=v.word, reason=v.option.unused, source=v.source)
        for v in values.values()
        if v.option.unused
    ) + _unused_step(values)


def _unused_step(values: dict[str, Value]) -> tuple[UnusedOption, ...]:
    """Return dtWave where the waves are not those of an elevation, from which it takes samples."""
    step, mode = values.get("dtWave"), values.get("WaveKin")
    if step is None or (mode is not None and mode.word not in ("2", "7")):
        return ()
    reason = "waves are summed at the nodes, without a grid in time"
    return (UnusedOption(name=step.option.name, value=step.word, reason=reason, source=step.source),)


def flavour(values: dict[str, Value]) -> str:
    """Return "MoorDyn-C" or "MoorDyn-F" when the options are of one of them only, else "MoorDyn v2"."""
    programs = {v.option.program for v in values.values()} - {""}
    return programs.pop() if len(programs) == 1 else "MoorDyn v2"
