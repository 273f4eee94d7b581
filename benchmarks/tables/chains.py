"""Three chains moved for 300 s: Moorage, its prototype, MoorDyn-C and CableDyn, each at the best settings found."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

from benchmarks import prototype
from benchmarks.cases import chains, paths, write_deck
from benchmarks.effort import Effort
from benchmarks.programs import Arrays, call, is_installed
from benchmarks.report import Column, Limit, Row, Table

DT_OUT = 0.05
STEP = {20: 0.05, 50: 0.05, 100: 0.025}
REFINED, REFINED_FEM = 0.0025, 0.00625
MOORDYN = {20: ("euler", 0.00833), 50: ("midpoint10", 0.025), 100: ("midpoint10", 0.0125)}  # the prototype's finding
CABLEDYN = {20: 0.05, 50: 0.025, 100: 0.0125}  # twice the step is above 1 %; rhoInf, modified Newton: not faster
CABLEDYN_SOLVER = ("dynamic_solver 1e-4 1e-6 30 12", "off ei0_substeps")
QUIET = ("1.0 dtIC", "600 TmaxIC", "1e-6 threshIC", "0 writeLog", "1 disableOutput", "1 disableOutTime")

COLUMNS = (
    Column("segments", "segments", "d"), Column("program", "program"), Column("settings", "settings"),
    Column("cpu", "CPU ms", ".1f"), Column("rms", "rms %", ".2f"), Column("worst", "worst instant %", ".1f"),
    Column("beside", "times Moorage, adaptive", ".1f"), Column("prototype", "times prototype", ".2f"),
)  # fmt: skip


def measure(effort: Effort) -> Table:
    """Return CPU times and errors; rows of programs that are not there have no numbers."""
    rows: dict[tuple[int, str, str], Row] = {}
    with tempfile.TemporaryDirectory() as folder:
        refined = {n: _refined(n, effort, Path(folder)) for n in effort.segments}
        for _ in range(effort.turns):
            for key, row in _turn(effort, Path(folder), refined):
                kept = rows.setdefault(key, row)
                kept["cpu"] = min(kept["cpu"], row["cpu"])  # the errors do not change
    listed = [_finished(rows, n, program, kind) for n in effort.segments for program, kind in _PROGRAMS]
    return Table(
        "chains",
        f"Three chains of 835.5 m, fairleads moved 5 m / 12 s and 2 m / 9 s, {effort.duration:g} s",
        COLUMNS,
        listed,
        (
            f"Output every {DT_OUT} s. Moorage and MoorDyn-C against Moorage at a step of {REFINED} s, whose equations "
            f"are MoorDyn-C's; CableDyn's finite elements against CableDyn at {REFINED_FEM} s, the prototype against "
            "its own explicit run.",
        ),
        tuple(_limits(listed)),
    )


def _refined(n: int, effort: Effort, folder: Path) -> tuple[np.ndarray, Arrays | None]:
    """Return the tensions, and the finite elements' result, that runs of n segments are compared with."""
    return _moorage(n, effort, REFINED, 1e-4, 1)["end_tension"], _cabledyn(n, effort, folder, REFINED_FEM)


def _turn(effort: Effort, folder: Path, refined):
    """Run every program once; yield (segments, program, kind) and its numbers."""
    for (n, kind), (cpu, rms) in (prototype.run() if effort.prototype and prototype.is_there() else {}).items():
        yield (n, "prototype", kind), {"cpu": cpu, "rms": rms, "worst": None}
    for n in effort.segments:
        tension, fem = refined[n]
        for kind, step in (("fixed", STEP[n]), ("adaptive", 0.0)):
            ours = _moorage(n, effort, step, 0.0, effort.repeat)
            yield (n, "Moorage", kind), {"cpu": 1e3 * ours["cpu"].min(), **_errors(ours["end_tension"], tension)}
        theirs = _moordyn(n, effort, folder)
        if theirs:
            yield (n, "MoorDyn-C", "best"), {"cpu": 1e3 * theirs["cpu"], **_errors(theirs["end_tension"], tension)}
        theirs = _cabledyn(n, effort, folder, CABLEDYN[n])
        if theirs and fem:
            errors = _errors(_on_grid(theirs, CABLEDYN[n]), _on_grid(fem, REFINED_FEM))
            yield (n, "CableDyn", "best"), {"cpu": 1e3 * theirs["cpu"], **errors}


_PROGRAMS = (
    ("Moorage", "fixed"), ("Moorage", "adaptive"), ("prototype", "fixed"), ("prototype", "adaptive"),
    ("MoorDyn-C", "best"), ("CableDyn", "best"),
)  # fmt: skip


def _settings(n: int, program: str, kind: str) -> str:
    if program == "MoorDyn-C":
        return f"{MOORDYN[n][0]}, dtM {MOORDYN[n][1]:g} s"
    if program == "CableDyn":
        return f"dtM {CABLEDYN[n]:g} s, relative tolerance 1e-4"
    return f"step {STEP[n]:g} s" if kind == "fixed" else "adaptive" + (", default" if program == "Moorage" else "")


def _finished(rows: dict, n: int, program: str, kind: str) -> Row:
    row = {"segments": n, "program": program, "settings": _settings(n, program, kind), "kind": kind}
    row |= rows.get((n, program, kind), {"cpu": None, "rms": None, "worst": None})
    ours, floor = rows[n, "Moorage", "adaptive"], rows.get((n, "prototype", kind))
    row["beside"] = row["cpu"] / ours["cpu"] if row["cpu"] else None
    row["prototype"] = row["cpu"] / floor["cpu"] if floor and program == "Moorage" else None
    return row


def _limits(rows: list[Row]):
    for row in rows:
        if row["program"] == "Moorage":
            what = f"3 x {row['segments']}, {row['kind']}"
            yield Limit(f"{what}: times the prototype", row["prototype"], 1.5, "")
            yield Limit(f"{what}: rms", row["rms"], 1.0, "%")


def _errors(tension: np.ndarray, reference: np.ndarray) -> Row:
    """Return rms and largest error of the worst line, % of its rms and of its peak."""
    difference = np.abs(tension) - np.abs(reference)
    rms = np.sqrt(np.mean(difference**2, axis=0) / np.mean(reference**2, axis=0))
    worst = np.abs(difference).max(axis=0) / np.abs(reference).max(axis=0)
    return {"rms": 100.0 * float(rms.max()), "worst": 100.0 * float(worst.max())}


def _moorage(n: int, effort: Effort, step: float, tolerance: float, repeat: int) -> Arrays:
    return call(
        "moorage_march",
        segments=n, lines=3, duration=effort.duration, dt_out=DT_OUT, time_step=step, tolerance=tolerance,
        repeat=repeat, threaded=0,
    )  # fmt: skip


def _moordyn(n: int, effort: Effort, folder: Path) -> Arrays | None:
    if not is_installed("moordyn_c"):
        return None
    scheme, dt = MOORDYN[n]
    path = write_deck(folder / f"moordyn{n}.dat", chains(n), f"{dt} dtM", f"{scheme} tScheme", *QUIET)
    time, position, *_ = paths(chains(n), effort.duration, DT_OUT)
    return call("moordyn_c", model=str(path), time=time, position=position)


def _cabledyn(n: int, effort: Effort, folder: Path, dt: float) -> Arrays | None:
    if not is_installed("cabledyn_fem"):
        return None
    path = folder / f"cabledyn{n}.dat"
    write_deck(path, chains(n), f"{dt} dtM", f"{effort.duration} TMax", *CABLEDYN_SOLVER)
    time, position, velocity, acceleration = paths(chains(n), effort.duration, dt)
    return call(
        "cabledyn_fem", model=str(path), time=time, position=position, velocity=velocity, acceleration=acceleration
    )


def _on_grid(result: Arrays, dt: float) -> np.ndarray:
    """Return CableDyn's loads on the fairleads at the output times, without the start."""
    every = round(DT_OUT / dt)
    return np.linalg.norm(result["load"], axis=-1)[every::every]
