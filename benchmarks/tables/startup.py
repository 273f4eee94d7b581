"""Compiling the kernels once, and what each later process waits for before its first step."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time

from benchmarks.effort import Effort
from benchmarks.programs import ROOT
from benchmarks.report import Column, Limit, Table

MODEL = ROOT / "examples" / "oc4" / "oc4.dat"
WARM_UP = "import moorage; moorage.warmup()"
STARTS = {
    "python": "",
    "import moorage": "import moorage",
    "read a file": f"import moorage; moorage.read({str(MODEL)!r})",
    "first step of a host's Simulation": (
        f"import moorage; sim = moorage.Simulation(moorage.read({str(MODEL)!r})); sim.initialize(); "
        "sim.step(0.1, sim.position, 0.0 * sim.position)"
    ),
    "first step of simulate": (
        f"import moorage; moorage.simulate(moorage.read({str(MODEL)!r}), duration=0.1, save='tensions')"
    ),
    "moorage static FILE": (
        f"import moorage.cli, sys; sys.argv = ['moorage', 'static', {str(MODEL)!r}]; moorage.cli.main()"
    ),
}

COLUMNS = (Column("what", "what"), Column("wall", "wall s", ".2f"), Column("cpu", "CPU s", ".2f"))


def measure(effort: Effort) -> Table:
    """Return wall and CPU time from the start of a process to its end, smallest of several."""
    rows = []
    compiled: tuple[float, float] | tuple[None, None] = (None, None)
    if effort.cold:
        with tempfile.TemporaryDirectory() as cache:
            compiled = _timed(WARM_UP, {"MOORAGE_CACHE": cache})
    rows.append({"what": "compile all kernels, once", "wall": compiled[0], "cpu": compiled[1]})
    _timed(WARM_UP)
    best = dict.fromkeys(STARTS, (1000000000.0, 1000000000.0))
    for _ in range(effort.starts):
        for what, code in STARTS.items():
            taken = _timed(code)
            best[what] = min(best[what][0], taken[0]), min(best[what][1], taken[1])
    rows += [{"what": f"{what}, later process", "wall": wall, "cpu": cpu} for what, (wall, cpu) in best.items()]
    return Table(
        "startup",
        "From the start of a process",
        COLUMNS,
        rows,
        ("Python itself and its end are in these times. The first process that simulates compiles, and says so.",),
        (
            Limit("all kernels compiled", compiled[1], 60.0, "s CPU"),
            Limit("first step of simulate in a later process", best["first step of simulate"][0], 1.5, "s wall"),
        ),
    )


def _timed(code: str, environment: dict[str, str] | None = None) -> tuple[float, float]:
    """Return wall and CPU time of a process that runs some code, s."""
    command, variables = [sys.executable, "-W", "ignore", "-c", code], os.environ | (environment or {})
    before, clock = os.times(), time.perf_counter()
    subprocess.run(command, env=variables, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    wall, after = time.perf_counter() - clock, os.times()
    return wall, after.children_user + after.children_system - before.children_user - before.children_system
