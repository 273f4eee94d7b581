"""Many lines in one model: cost of a line, memory, and what a second thread brings."""

from __future__ import annotations

from benchmarks.effort import Effort
from benchmarks.programs import call
from benchmarks.report import Column, Limit, Table

SEGMENTS, DT_OUT = 20, 0.1

COLUMNS = (
    Column("lines", "lines", "d"), Column("threads", "threads"), Column("build", "build ms", ".0f"),
    Column("statics", "statics ms", ".0f"), Column("cpu", "CPU s", ".3f"), Column("wall", "wall s", ".3f"),
    Column("each", "CPU us for a line and second", ".1f"), Column("memory", "memory MB", ".0f"),
)  # fmt: skip


def measure(effort: Effort) -> Table:
    """Return the time of the solver on 3 and on many lines, with one thread and with as many as it takes."""
    cases = ((3, 0), (effort.lines, 0), (effort.lines, 1))
    best: dict[tuple[int, int], dict] = {}
    for _ in range(effort.turns):
        for lines, threaded in cases:
            size = {"segments": SEGMENTS, "lines": lines, "duration": effort.spread, "dt_out": DT_OUT}
            taken = call("moorage_march", time_step=0.0, tolerance=0.0, repeat=effort.repeat, threaded=threaded, **size)
            row = {"cpu": float(taken["cpu"].min()), "wall": float(taken["wall"].min())}
            row |= {"build": 1e3 * float(taken["cpu_build"]), "statics": 1e3 * float(taken["cpu_statics"])}
            held = best.setdefault((lines, threaded), row)
            held |= {name: min(value, held[name]) for name, value in row.items()}
    for lines, threaded in cases:
        size = {"segments": SEGMENTS, "lines": lines, "duration": effort.spread, "dt_out": DT_OUT}
        taken = call("moorage_simulate", save="tensions", to_file=1, threaded=threaded, **size)
        best[lines, threaded]["memory"] = float(taken["memory"]) / 1e6
    rows = [
        {"lines": lines, "threads": "one" if not threaded else "as it chooses", **best[lines, threaded]}
        | {"each": 1e6 * best[lines, threaded]["cpu"] / lines / effort.spread}
        for lines, threaded in cases
    ]
    return Table(
        "spread",
        f"Lines of {SEGMENTS} segments, {effort.spread:g} s, adaptive, results every {DT_OUT} s",
        COLUMNS,
        rows,
        ("Memory is the largest of the whole process in `simulate`, tensions to NetCDF; 3 lines show what is Python.",),
        (
            Limit(f"a line among {effort.lines}: times a line among 3", rows[1]["each"] / rows[0]["each"], 1.5, ""),
            Limit(f"memory with {effort.lines} lines", rows[2]["memory"], 1000.0, "MB"),
        ),
    )
