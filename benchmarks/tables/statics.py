"""Static equilibrium of one chain, of OC4's three, and of the same by other programs."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np

from benchmarks.cases import (
    ANCHOR_RADIUS,
    CHAIN,
    DEPTH,
    FAIRLEAD_DEPTH,
    FAIRLEAD_RADIUS,
    LENGTH,
    chains,
    write_deck,
)
from benchmarks.effort import Effort
from benchmarks.programs import call, is_installed
from benchmarks.report import Column, Limit, Table
from benchmarks.tables.chains import QUIET

SEGMENTS = 50

COLUMNS = (Column("program", "program"), Column("lines", "lines", "d"), Column("cpu", "CPU ms", ".2f"))


def measure(effort: Effort) -> Table:
    """Return the CPU time from a model, or a file, to equilibrium, with everything loaded and compiled."""
    cpu: dict[tuple[str, int], float] = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(effort.turns):
            for lines in (1, 3):
                for name, seconds in _all(lines, effort, Path(folder)):
                    cpu[name, lines] = min(seconds, cpu.get((name, lines), np.inf))
    programs = (
        "Moorage, solver",
        "Moorage, model to solver",
        "Moorage, model to dataset",
        "MoorPy",
        "MoorDyn-C",
        "CableDyn",
    )
    rows = [
        {"program": p, "lines": n, "cpu": 1e3 * cpu[p, n] if (p, n) in cpu else None} for n in (1, 3) for p in programs
    ]
    return Table(
        "statics",
        f"Statics of chains of {SEGMENTS} segments",
        COLUMNS,
        rows,
        (
            "Moorage to a residual of 2 mN, with the 6x6 stiffness where it ends in a dataset. MoorPy solves "
            "catenaries without segments; MoorDyn-C relaxes until 1e-6; CableDyn includes reading the file.",
        ),
        (Limit("statics of one chain of 50 segments, warm", 1e3 * cpu["Moorage, model to solver", 1], 5.0, "ms"),),
    )


def _all(lines: int, effort: Effort, folder: Path):
    ours = call("moorage_statics", segments=SEGMENTS, lines=lines, repeat=10 * effort.repeat)
    for part in ("solver", "model to solver", "model to dataset"):
        yield f"Moorage, {part}", float(ours[part].min())
    model = chains(SEGMENTS, lines)
    held = np.array([[point.position for point in model.coupled_points]] * 2)
    two = np.array([0.0, 0.1])
    if is_installed("moorpy_statics"):
        heading = np.pi + 2.0 * np.pi * np.arange(lines) / lines
        out = np.column_stack([np.cos(heading), np.sin(heading), np.zeros(lines)])
        theirs = call(
            "moorpy_statics",
            depth=DEPTH, gravity=9.80665, density=1025.0, anchor=ANCHOR_RADIUS * out - (0, 0, DEPTH),
            fairlead=FAIRLEAD_RADIUS * out - (0, 0, FAIRLEAD_DEPTH), length=LENGTH, diameter=CHAIN.diameter,
            mass=CHAIN.mass_per_length, stiffness=CHAIN.axial_stiffness,
        )  # fmt: skip
        yield "MoorPy", float(theirs["cpu"])
    if is_installed("moordyn_c"):
        path = write_deck(folder / "moordyn.dat", model, "0.01 dtM", "midpoint10 tScheme", *QUIET)
        yield "MoorDyn-C", float(call("moordyn_c", model=str(path), time=two, position=held)["cpu_start"])
    if is_installed("cabledyn_fem"):
        path = write_deck(folder / "cabledyn.dat", model, "0.1 dtM", "0.1 TMax")
        still = {"velocity": 0.0 * held, "acceleration": 0.0 * held}
        theirs = call("cabledyn_fem", model=str(path), time=two, position=held, **still)
        yield "CableDyn", float(theirs["cpu_start"])
