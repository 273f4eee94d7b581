"""The lazy-wave cable in a JONSWAP sea: what waves cost beside still water, and how near the table is to the sums."""

from __future__ import annotations

import numpy as np

from benchmarks.effort import Effort
from benchmarks.programs import Arrays, call
from benchmarks.report import Column, Limit, Row, Table

DURATION, DT_OUT = 600.0, 0.1
STEP, TOLERANCE = 0.05, 1e-4  # of the runs that show the error of the table alone
RUNS = ((0, 0), (26, 0), (200, 0), (200, 1))  # components, exact
LIMITS = {26: 1.2, 200: 2.0}

COLUMNS = (
    Column("components", "components", "d"), Column("kinematics", "kinematics"), Column("cpu", "CPU ms", ".1f"),
    Column("steps", "steps", "d"), Column("still", "times still water", ".2f"),
    Column("each", "the same, for each step", ".2f"), Column("rms", "rms, N", ".2f"),
    Column("std", "rms, % of the standard deviation", ".3f"),
)  # fmt: skip


def measure(effort: Effort) -> Table:
    """Return CPU times of adaptive runs, and the table's error in runs of constant steps."""
    duration = min(DURATION, 2.0 * effort.duration)
    rows: dict[tuple[int, int], Row] = {}
    for _ in range(effort.turns):
        for key in RUNS:
            ours = _moorage(*key, duration, 0.0, 0.0, effort.repeat)
            row = rows.setdefault(key, {"cpu": np.inf})
            row |= {"cpu": min(row["cpu"], 1e3 * ours["cpu"].min()), "steps": int(ours["steps"])}
    still = rows[0, 0]
    for (components, exact), row in rows.items():
        row |= {"components": components, "kinematics": "exact sums" if exact else "table" if components else "none"}
        row["still"] = row["cpu"] / still["cpu"]
        row["each"] = row["still"] * still["steps"] / row["steps"]
        row |= _errors(components, duration) if components and not exact else {"rms": None, "std": None}
    listed = list(rows.values())
    return Table(
        "waves",
        f"The lazy-wave cable in a JONSWAP sea of 8.25 m and 14.5 s, top moved 2 m and 3 m in 14.5 s, {duration:g} s",
        COLUMNS,
        listed,
        (
            f"Moorage, adaptive, output every {DT_OUT} s. The top moves in still water as in the sea; the sea shakes "
            "the cable more and takes more steps. Rms: tension at the top with the table against exact sums, both in "
            f"steps of {STEP} s at a tolerance of {1e3 * TOLERANCE:g} mm.",
        ),
        tuple(_limits(listed)),
    )


def _limits(rows: list[Row]):
    for row in rows:
        if row["kinematics"] == "table":
            what = f"waves, {row['components']} components: a step over one in still water"
            yield Limit(what, row["each"], LIMITS[row["components"]], "")


def _errors(components: int, duration: float) -> Row:
    table, exact = (_moorage(components, way, duration, STEP, TOLERANCE, 1)["top_tension"] for way in (0, 1))
    rms = float(np.sqrt(np.mean((table - exact) ** 2)))
    return {"rms": rms, "std": 100.0 * rms / float(np.std(exact))}


def _moorage(components: int, exact: int, duration: float, step: float, tolerance: float, repeat: int) -> Arrays:
    return call(
        "moorage_waves",
        components=components, exact=exact, duration=duration, dt_out=DT_OUT, time_step=step, tolerance=tolerance,
        repeat=repeat,
    )  # fmt: skip
