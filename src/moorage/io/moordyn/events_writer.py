"""FAILURE, CONTROL, EXTERNAL LOADS and SYROPE IC as sections of a MoorDyn file."""

from __future__ import annotations

from moorage.io.moordyn.layout import Flavour, bars, number, table, tie
from moorage.model import Model


def syrope(model: Model, notes: list[str]) -> list[str]:
    """Return the section SYROPE IC."""
    rows = [[str(line.id), *map(number, line.syrope_tensions)] for line in model.lines if line.syrope_tensions]
    if any(t.syrope for t in model.line_types):
        notes.append("files of Syrope curves are named as they were, not copied")
    return table("SYROPE IC", "Line(s) Tmax0 Tmean0", "(-) (N) (N)", rows)


def failures(model: Model) -> list[str]:
    """Return the section FAILURE."""
    rows = [
        [
            str(f.id),
            tie(f.attachment),
            ",".join(map(str, f.lines)),
            number(f.time),
            number(f.tension),
        ]
        for f in model.failures
    ]
    return table("FAILURE", "FailureID Point Line(s) FailTime FailTen", "(-) (-) (-) (s) (N)", rows)


def controls(model: Model, flavour: Flavour, notes: list[str]) -> list[str]:
    """Return the section CONTROL."""
    if model.controls and flavour == "C":
        notes.append("MoorDyn-C does not read CONTROL")
    if any(c.length is not None or c.rate is not None for c in model.controls):
        notes.append("lengths and rates of control channels: not written, MoorDyn-F takes them from its host")
    if any(c.end == "A" for c in model.controls):
        notes.append("MoorDyn-F controls the length at end B only")
    rows = [[str(c.channel), ",".join(map(str, c.lines))] for c in model.controls]
    return table("CONTROL", "ChannelID Line(s)", "(-) (-)", rows)


def loads(model: Model, flavour: Flavour, notes: list[str]) -> list[str]:
    """Return the section EXTERNAL LOADS; for MoorDyn-F the constant forces on points too."""
    if model.external_loads and flavour == "C":
        notes.append("MoorDyn-C does not read EXTERNAL LOADS")
    rows = [
        [
            str(load.id),
            f"{load.target.capitalize()}{load.target_id}",
            bars(load.force),
            bars(load.linear_damping),
            bars(load.quadratic_damping),
            ("L" if load.local else "G") if load.target == "body" else "-",
        ]
        for load in model.external_loads
    ]
    if flavour == "F":
        forced = [p for p in model.points if any(p.external_force)]
        rows += [
            [str(len(rows) + k + 1), f"Point{p.id}", bars(p.external_force), "0", "0", "-"]
            for k, p in enumerate(forced)
        ]
        if forced:
            notes.append("constant forces on points are now EXTERNAL LOADS")
    header, units = "ID Object Fext Blin Bquad CSys", "(#) (name) (N) (N-s/m) (N-s^2/m^2) (-)"
    return table("EXTERNAL LOADS", header, units, rows)
