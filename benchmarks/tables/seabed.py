"""What a depth grid and friction cost, beside the same run on a flat bed without friction."""

from __future__ import annotations

import dataclasses
import time

import numpy as np

from benchmarks.cases import DEPTH, chains, surge_and_heave
from benchmarks.effort import Effort
from benchmarks.report import Column, Limit, Row, Table
from moorage.layout import copy_of
from moorage.model import Bathymetry, Friction, Model
from moorage.model.seabed import place_on_seabed
from moorage.solve.march import March, Settings
from moorage.solve.statics import solve
from moorage.system.build import Built, build

SEGMENTS, LAST = 50, 400.0  # s at most
AXIS = tuple(np.linspace(-1000.0, 1000.0, 41).tolist())
BEDS = {
    "flat": None,
    "level grid": lambda x, y: 0.0,
    "slope": lambda x, y: 0.002 * x + 0.001 * y,
    "hills": lambda x, y: 8.0 * np.sin(x / 150.0) * np.cos(y / 170.0),
}
LAWS = {
    "none": None,
    "elastic-slip": Friction(axial=0.5, transverse=0.7),
    "stick-slip": Friction(axial=0.5, transverse=0.7, model="stick-slip", static_ratio=1.2),
    "saturated-damping": Friction(axial=0.5, transverse=0.7, model="saturated-damping", damping=2e5),
}
CASES = (
    ("flat", "none"), ("level grid", "none"), ("slope", "none"), ("hills", "none"), ("flat", "elastic-slip"),
    ("level grid", "elastic-slip"), ("slope", "elastic-slip"), ("hills", "elastic-slip"), ("flat", "stick-slip"),
    ("flat", "saturated-damping"),
)  # fmt: skip
COLUMNS = (
    Column("bed", "bed"), Column("friction", "friction"), Column("cpu", "CPU ms", ".1f"),
    Column("ratio", "ratio", ".2f"),
    Column("steps", "steps", ".2f"), Column("iterations", "iterations a step", ".2f"),
    Column("each", "cost of an iteration", ".2f"),
)  # fmt: skip


def measure(effort: Effort) -> Table:
    """Return CPU times of the same run on all beds, in turns in one process, and what makes their ratio."""
    duration = min(effort.duration, LAST)
    cases = {case: _built(*case, duration) for case in CASES}
    best: dict[tuple[str, str], float] = {}
    counts: dict[tuple[str, str], dict[str, int]] = {}
    for _ in range(effort.turns * effort.repeat + 1):  # the first brings all into memory
        for case, built in cases.items():
            march = March(built._replace(state=copy_of(built.state)), Settings(), duration)
            begin = time.process_time()
            march.advance(duration)
            best[case] = min(time.process_time() - begin, best.get(case, np.inf))
            counts[case] = march.counters
    rows = [_row(case, best, counts) for case in CASES]
    both = max(row["ratio"] for row in rows if row["friction"] == "elastic-slip" and row["bed"] != "flat")
    return Table(
        "seabed",
        f"Depth grid and friction, 3 x {SEGMENTS} segments, {duration:g} s",
        COLUMNS,
        rows,
        (
            "Ratios to the first row; that of CPU is the product of the other three. Uneven beds are other runs too: "
            "lines touch down elsewhere and friction jumps, which takes steps and iterations.",
        ),
        (Limit("friction and a depth grid over a flat bed without friction", both, 1.3, ""),),
    )


def _built(bed: str, law: str, duration: float) -> Built:
    model = chains(SEGMENTS)
    environment = dataclasses.replace(model.environment, bathymetry=_grid(bed), friction=LAWS[law])
    built = build(_anchored(dataclasses.replace(model, environment=environment)), surge_and_heave(duration + 1.0))
    solve(built)
    return built


def _grid(bed: str) -> Bathymetry | None:
    rise = BEDS[bed]
    if rise is None:
        return None
    return Bathymetry(AXIS, AXIS, tuple(tuple(float(DEPTH - rise(x, y)) for y in AXIS) for x in AXIS))


def _anchored(model: Model) -> Model:
    """Return the model with its anchors on the bed."""
    points = [dataclasses.replace(p, on_seabed=p.kind == "fixed") for p in model.points]
    return place_on_seabed(dataclasses.replace(model, points=tuple(points)))


def _row(case, best, counts) -> Row:
    first, mine = counts[CASES[0]], counts[case]
    ratio, steps = best[case] / best[CASES[0]], mine["steps"] / first["steps"]
    iterations = mine["iterations"] / first["iterations"]
    return {
        "bed": case[0], "friction": case[1], "cpu": 1e3 * best[case], "ratio": ratio, "steps": steps,
        "iterations": iterations / steps, "each": ratio / iterations,
    }  # fmt: skip
