"""A coupling step: another program moves three chains of 20 segments and receives the forces."""

from __future__ import annotations

import tempfile
from pathlib import Path

from benchmarks.cases import chains, paths, write_deck
from benchmarks.effort import Effort
from benchmarks.programs import call, is_installed
from benchmarks.report import Column, Table
from benchmarks.tables.chains import CABLEDYN_SOLVER, MOORDYN, QUIET

SEGMENTS, STEPS = 20, (0.0125, 0.05, 0.1)

COLUMNS = (
    Column("step", "coupling step s", "g"), Column("program", "program"), Column("each", "CPU us a step", ".1f"),
    Column("second", "CPU ms for a second", ".3f"),
)  # fmt: skip


def measure(effort: Effort) -> Table:
    """Return the CPU time of a coupling step by its length."""
    best: dict[tuple[float, str], float] = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(effort.turns):
            for step in STEPS:
                for program, cpu in _all(step, effort, Path(folder)):
                    best[step, program] = min(cpu, best.get((step, program), cpu))
    rows = []
    for step in STEPS:
        for program in ("Moorage", "MoorDyn-C", "CableDyn"):
            cpu = best.get((step, program))
            each = None if cpu is None else cpu / (effort.duration / step)
            second = None if cpu is None else 1e3 * cpu / effort.duration
            rows.append({"step": step, "program": program, "each": each and 1e6 * each, "second": second})
    note = (
        "Moorage's own step is adaptive within the coupling step, MoorDyn-C's and CableDyn's as in the table of chains."
    )
    return Table("coupling", f"Coupling step of 3 x {SEGMENTS} segments", COLUMNS, rows, (note,))


def _all(step: float, effort: Effort, folder: Path):
    time, position, velocity, acceleration = paths(chains(SEGMENTS), effort.duration, step)
    ours = call("moorage_host", segments=SEGMENTS, lines=3, time=time, position=position, velocity=velocity)
    yield "Moorage", float(ours["cpu"])
    if is_installed("moordyn_c"):
        scheme, dt = MOORDYN[SEGMENTS]
        path = write_deck(folder / "moordyn.dat", chains(SEGMENTS), f"{dt} dtM", f"{scheme} tScheme", *QUIET)
        yield "MoorDyn-C", float(call("moordyn_c", model=str(path), time=time, position=position)["cpu"])
    if is_installed("cabledyn_fem"):
        path = folder / "cabledyn.dat"
        write_deck(path, chains(SEGMENTS), f"{step} dtM", f"{effort.duration} TMax", *CABLEDYN_SOLVER)
        moved = {"position": position, "velocity": velocity, "acceleration": acceleration}
        yield "CableDyn", float(call("cabledyn_fem", model=str(path), time=time, **moved)["cpu"])
