"""A lazy-wave power cable of 137 segments moved for 60 s: Moorage, its prototype, and MoorDyn-C at its best setting."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

from benchmarks import prototype
from benchmarks.cases import lazy_wave, paths, swell, write_deck
from benchmarks.effort import Effort
from benchmarks.programs import Arrays, call, is_installed
from benchmarks.report import Column, Limit, Row, Table

DURATION, DT_OUT, STEP, REFINED = 60.0, 0.1, 0.1, 0.00125
# rk2 at 0.0003, midpoint10 at 0.001, midpoint5 at 0.0005 and rk4 at 0.0004 take longer; their next steps are unstable
MOORDYN = ("euler", 0.0002)
SETTLED = 20.0  # s; from here on MoorDyn-C, whose start is not at rest, is compared

COLUMNS = (
    Column("program", "program"), Column("settings", "settings"), Column("cpu", "CPU ms", ".1f"),
    Column("rms", "rms %", ".3f"), Column("std", "rms, % of the standard deviation", ".2f"),
    Column("beside", "times Moorage, adaptive", ".1f"), Column("prototype", "times prototype", ".2f"),
)  # fmt: skip
_PROGRAMS = {
    ("Moorage", "fixed"): f"step {STEP:g} s",
    ("Moorage", "adaptive"): "adaptive, default",
    ("prototype", "fixed"): f"step {STEP:g} s",
    ("MoorDyn-C", "best"): f"{MOORDYN[0]}, dtM {MOORDYN[1]:g} s",
}


def measure(effort: Effort) -> Table:
    """Return CPU times and errors; rows of programs that are not there have no numbers."""
    duration = min(DURATION, effort.duration)
    reference = _moorage(duration, REFINED, 1e-6, 1)["end_tension"][:, 0]
    found: dict[tuple[str, str], Row] = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(effort.turns):
            for key, row in _turn(effort, duration, reference, Path(folder)):
                kept = found.setdefault(key, row)
                kept["cpu"] = min(kept["cpu"], row["cpu"])  # the errors do not change
    rows = [_finished(found, *key) for key in _PROGRAMS]
    return Table(
        "cable",
        f"A lazy-wave cable of 137 segments, top moved 2 m and 3 m in 14.5 s, {duration:g} s",
        COLUMNS,
        rows,
        (
            f"Output every {DT_OUT} s. Moorage and MoorDyn-C against Moorage at a step of {REFINED} s, the prototype "
            f"against its own refined run. MoorDyn-C's start is not at rest: its errors are those after {SETTLED:g} s, "
            "and most of them are what is left of that.",
        ),
        tuple(_limits(rows)),
    )


def _turn(effort: Effort, duration: float, reference: np.ndarray, folder: Path):
    """Run every program once; yield (program, kind) and its numbers."""
    if effort.prototype and prototype.is_there():
        cpu, rms = prototype.run_cable()
        yield ("prototype", "fixed"), {"cpu": cpu, "rms": rms, "std": None}
    for kind, step in (("fixed", STEP), ("adaptive", 0.0)):
        ours = _moorage(duration, step, 0.0, effort.repeat)
        yield ("Moorage", kind), {"cpu": 1e3 * ours["cpu"].min(), **_errors(ours["end_tension"][:, 0], reference)}
    if is_installed("moordyn_c"):
        scheme, dt = MOORDYN
        rest = f"{min(40.0, 10.0 * duration):g} TmaxIC"
        quiet = "1.0 dtIC", rest, "1e-6 threshIC", "0 writeLog", "1 disableOutput", "1 disableOutTime"
        path = write_deck(folder / "cable.dat", lazy_wave(), f"{dt} dtM", f"{scheme} tScheme", *quiet)
        time, position, *_ = paths(lazy_wave(), duration, DT_OUT, swell)
        theirs = call("moordyn_c", model=str(path), time=time, position=position)
        top = theirs["end_tension"][:, -1]  # the sections are lines, joined by free rods; the last one is at the top
        late = time > min(SETTLED, 0.5 * duration)
        yield ("MoorDyn-C", "best"), {"cpu": 1e3 * theirs["cpu"], **_errors(top[late], reference[late])}


def _errors(tension: np.ndarray, reference: np.ndarray) -> Row:
    """Return the rms error in % of the rms of the tension at the top, and of its standard deviation."""
    rms = float(np.sqrt(np.mean((np.abs(tension) - np.abs(reference)) ** 2)))
    return {
        "rms": 100.0 * rms / float(np.sqrt(np.mean(reference**2))),
        "std": 100.0 * rms / float(np.std(np.abs(reference))),
    }


def _moorage(duration: float, step: float, tolerance: float, repeat: int) -> Arrays:
    return call(
        "moorage_march",
        segments=0, lines=0, duration=duration, dt_out=DT_OUT, time_step=step, tolerance=tolerance, repeat=repeat,
        threaded=0,
    )  # fmt: skip


def _finished(found: dict, program: str, kind: str) -> Row:
    row = {"program": program, "settings": _PROGRAMS[program, kind], "kind": kind}
    row |= found.get((program, kind), {"cpu": None, "rms": None, "std": None})
    floor = found.get(("prototype", "fixed"))
    row["beside"] = row["cpu"] / found["Moorage", "adaptive"]["cpu"] if row["cpu"] else None
    row["prototype"] = row["cpu"] / floor["cpu"] if floor and program == "Moorage" else None
    return row


def _limits(rows: list[Row]):
    theirs = next((row["cpu"] for row in rows if row["program"] == "MoorDyn-C"), None)
    for row in rows:
        if row["program"] == "Moorage":
            what = f"cable, {row['kind']}"
            share = 100.0 * row["cpu"] / theirs if theirs else None
            yield Limit(f"{what}: times the prototype", row["prototype"], 1.5, "")
            yield Limit(f"{what}: time over MoorDyn-C's", share, 100.0 / 85.0, "%")
            yield Limit(f"{what}: rms", row["rms"], 0.1, "%")
            yield Limit(f"{what}: rms over the standard deviation", row["std"], 2.0, "%")
