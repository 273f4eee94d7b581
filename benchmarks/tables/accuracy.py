"""Errors on stored results of other programs, from ../shared/reference, where it stands beside the project."""

from __future__ import annotations

from benchmarks import accuracy
from benchmarks.effort import Effort
from benchmarks.report import Column, Limit, Row, Table
from moorage.model import Friction

COLUMNS = (
    Column("case", "case"), Column("settings", "settings"), Column("quantity", "quantity"),
    Column("error", "error %", ".4f"),
)  # fmt: skip
SETTINGS = {
    "default": {},
    "step 1 ms": {"time_step": 0.001, "tolerance": 2e-4},
    "MoorDyn-F's: midpoint, 1 ms": {"method": "rk2", "time_step": 0.001},
}
FRICTION = {"default, without friction": None, "default, elastic slip": Friction(axial=0.5, transverse=0.5)}
CHANNELS = {"md_case2": ("FAIRTEN2", "LINE1NBPZ"), "md_cable": ("FAIRTEN1", "LINE3NAPZ")}
ORCAFLEX = ("static fairlead", "static anchor", "rms fairlead", "rms anchor", "range fairlead")


def measure(effort: Effort) -> Table:
    """Return the errors of `benchmarks.accuracy`; dashes without reference data."""
    there = accuracy.REFERENCE.is_dir()
    rows: list[Row] = []
    for label, friction in FRICTION.items():
        chain = accuracy.orcaflex_chain(friction=friction) if there else dict.fromkeys(ORCAFLEX)
        rows += [_row("OrcaFlex, chain in 200 m", label, quantity, chain[quantity]) for quantity in ORCAFLEX]
    for case, channels in CHANNELS.items():
        for label, settings in SETTINGS.items():
            errors = accuracy.moordyn_f(case, **settings) if there else None
            for channel in channels:
                for part, words in (("rms", "rms"), ("after 2 s", "rms after 2 s")):
                    value = errors[channel][part] if errors else None
                    rows.append(_row(f"MoorDyn-F, {case}", label, f"{channel}, {words}", value))
    static = rows[0]["error"]
    return Table(
        "accuracy",
        "Beside stored results of other programs",
        COLUMNS,
        rows,
        (
            "OrcaFlex's friction is not known; 0.5 is MoorDyn-C's for the same case. MoorDyn-C without friction is "
            "within 0.2 % rms of Moorage, and with its own friction 1 % from OrcaFlex too. MoorDyn-F prints 8 digits.",
        ),
        (Limit("OrcaFlex, 200 m: static fairlead tension", None if static is None else abs(static), 0.5, "%"),),
    )


def _row(case: str, settings: str, quantity: str, error: float | None) -> Row:
    return {"case": case, "settings": settings, "quantity": quantity, "error": None if error is None else 100.0 * error}
