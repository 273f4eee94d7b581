"""FAILURE, CONTROL, EXTERNAL LOADS and SYROPE IC: what happens to objects, or where they start from."""

from __future__ import annotations

from typing import Literal, NamedTuple

from moorage.errors import Source
from moorage.io.moordyn.columns import Column, Record, records
from moorage.io.moordyn.sections import Table
from moorage.io.moordyn.words import decompose, read_attachment, read_ids
from moorage.io.text import Findings
from moorage.model import Control, ExternalLoad, Failure

FAILURE_COLUMNS = (
    Column("FailureID", ("failureid", "id", "failid")),
    Column("Point", ("point", "node", "attachment"), text=True),
    Column("Line(s)", ("line(s)", "lines", "line"), text=True),
    Column("FailTime", ("failtime", "time")),
    Column("FailTen", ("failten", "tension", "failtension")),
)
CONTROL_COLUMNS = (
    Column("ChannelID", ("channelid", "channel", "id")),
    Column("Line(s)", ("line(s)", "lines", "line"), text=True),
)
LOAD_COLUMNS = (
    Column("ID", ("id", "loadid")),
    Column("Object", ("object",), text=True),
    Column("Fext", ("fext", "force"), text=True),
    Column("Blin", ("blin",), text=True),
    Column("Bquad", ("bquad",), text=True),
    Column("CSys", ("csys",), text=True),
)
SYROPE_COLUMNS = (
    Column("Line(s)", ("line(s)", "lines", "line"), text=True),
    Column("Tmax0", ("tmax0", "tmax")),
    Column("Tmean0", ("tmean0", "tmean")),
)
MOORDYN_RANGE = (0.5, 2.0)  # MoorDyn-F stretches the last segment between these, and stops beyond
_TARGETS: dict[str, Literal["body", "rod", "point"]] = {
    "BODY": "body",
    "B": "body",
    "ROD": "rod",
    "R": "rod",
    "POINT": "point",
    "P": "point",
}


class Tensions(NamedTuple):
    """What a Syrope line starts from, N, and where that is said."""

    highest: float
    mean: float
    source: Source


def read_failures(table: Table, found: Findings) -> list[Failure]:
    """Return the failures of the section."""
    return [_failure(record, found) for record in records(table, FAILURE_COLUMNS, found)]


def _failure(record: Record, found: Findings) -> Failure:
    source = record.source
    id = found.integer(record["FailureID"], "FailureID", source)
    return Failure(
        id=id,
        attachment=read_attachment(record["Point"], f"place of failure {id}", found, source),
        lines=read_ids(record["Line(s)"], f"line of failure {id}", found, source),
        time=found.number(record["FailTime"], f"FailTime of failure {id}", source),
        tension=found.number(record["FailTen"], f"FailTen of failure {id}", source),
        source=source,
    )


def read_controls(table: Table, found: Findings) -> list[Control]:
    """Return the control channels of the section; a channel may have several rows."""
    channels: dict[int, Control] = {}
    for record in records(table, CONTROL_COLUMNS, found):
        channel = found.integer(record["ChannelID"], "ChannelID", record.source)
        lines = read_ids(record["Line(s)"], "line of a control channel", found, record.source)
        before = channels[channel].lines if channel in channels else ()
        channels[channel] = Control(
            channel=channel, lines=(*before, *lines), segment_range=MOORDYN_RANGE, source=record.source
        )
    return list(channels.values())


def read_loads(table: Table, found: Findings) -> list[ExternalLoad]:
    """Return the external loads of the section."""
    return [_load(record, found) for record in records(table, LOAD_COLUMNS, found)]


def _load(record: Record, found: Findings) -> ExternalLoad:
    source = record.source
    id = found.integer(record["ID"], "ID of an external load", source)
    letters, digits, rest = decompose(record["Object"])
    if letters not in _TARGETS or not digits or rest:
        found.add(f"object of load {id} is not known", "write Body1, Rod1 or Point1", source, record["Object"])
    target = _TARGETS.get(letters, "point")
    if record["CSys"].upper() not in (("G", "L") if target == "body" else ("-", "G", "L")):
        remedy = "write G (global) or L (local)" if target == "body" else "write -"
        found.add(f"CSys of load {id} is not known", remedy, source, record["CSys"])
    x, y, z = _triple(record["Fext"], f"Fext of load {id}", found, source)
    counts = (1, 2) if target == "rod" else (1, 3)
    return ExternalLoad(
        id=id,
        target=target,
        target_id=int(digits or 0),
        force=(x, y, z),
        linear_damping=_damping(record["Blin"], counts, f"Blin of load {id}", found, source),
        quadratic_damping=_damping(record["Bquad"], counts, f"Bquad of load {id}", found, source),
        local=target == "rod" or (target == "body" and record["CSys"].upper() == "L"),
        source=source,
    )


def _triple(word: str, what: str, found: Findings, source: Source) -> tuple[float, float, float]:
    values = found.numbers(word.split("|"), what, source)
    if len(values) == 3:
        return values[0], values[1], values[2]
    if values != (0.0,):
        found.add(f"{what} is neither 0 nor three values", "write Fx|Fy|Fz", source, word)
    return 0.0, 0.0, 0.0


def _damping(word: str, counts: tuple[int, int], what: str, found: Findings, source: Source) -> tuple[float, ...]:
    values = found.numbers(word.split("|"), what, source)
    if len(values) not in counts:
        found.add(f"{what} has {len(values)} values", f"give {counts[0]} or {counts[1]}", source, word)
    return values if len(values) == counts[1] else (values * counts[1])[: counts[1]]


def read_syrope(table: Table, found: Findings) -> dict[int, Tensions]:
    """Return the highest and the mean tension that Syrope lines start from, by line."""
    tensions: dict[int, Tensions] = {}
    for record in records(table, SYROPE_COLUMNS, found):
        highest, mean = (found.number(record[key], key, record.source) for key in ("Tmax0", "Tmean0"))
        for id in read_ids(record["Line(s)"], "line of SYROPE IC", found, record.source):
            if id in tensions:
                remedy = f"give it once (first: {tensions[id].source})"
                found.add(f"SYROPE IC names line {id} twice", remedy, record.source)
            tensions[id] = Tensions(highest, mean, record.source)
    return tensions
