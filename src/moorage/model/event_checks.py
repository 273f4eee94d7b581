"""Checks that failures, controls, loads and output channels name what exists."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import Any

from moorage.errors import Problem
from moorage.model.channels import parse_channel, why_not
from moorage.model.components import Attachment, Control, Curve, Failure, Line
from moorage.model.model import Model


def described(model: Model, kind: str) -> str:
    """Return in words which objects of a kind ("point", "rod", "body" or "line") are there."""
    groups: dict[str, tuple[Any, ...]] = {
        "point": model.points,
        "rod": model.rods,
        "body": model.bodies,
        "line": model.lines,
    }
    ids = [str(thing.id) for thing in groups[kind]]
    plural = {"body": "bodies"}.get(kind, kind + "s")
    shown = ", ".join(ids[:12]) + (", ..." if len(ids) > 12 else "")
    if len(ids) == 1:
        return f"the only {kind} is {shown}"
    return f"the {plural} are {shown}" if ids else f"there are no {plural}"


def events_name_what_exists(model: Model) -> Iterator[Problem]:
    """Failures, controls and loads name lines and objects that are there."""
    lines = {line.id: line for line in model.lines}
    for failure in model.failures:
        for id in failure.lines:
            if id not in lines:
                message = f"failure {failure.id} names line {id}, which is not described"
                yield Problem(message, described(model, "line"), failure.source)
            elif failure.attachment not in _ends(lines[id]):
                message = f"failure {failure.id}: line {id} is not tied to {failure.attachment}"
                remedy = f"it is tied to {lines[id].end_a} and {lines[id].end_b}"
                yield Problem(message, remedy, failure.source)
    for control in model.controls:
        for id in control.lines:
            if id not in lines:
                message = f"control channel {control.channel} names line {id}, which is not described"
                yield Problem(message, described(model, "line"), control.source)
    groups: dict[str, tuple[Any, ...]] = {"body": model.bodies, "rod": model.rods, "point": model.points}
    for load in model.external_loads:
        if all(thing.id != load.target_id for thing in groups[load.target]):
            message = f"external load {load.id} is on {load.target} {load.target_id}, which is not described"
            yield Problem(message, described(model, load.target), load.source)


def loads_that_move_nothing(model: Model) -> list[Problem]:
    """Return doubts about loads on points and rods that are held by the ground, which nobody feels."""
    held = {("point", point.id) for point in model.points if point.kind == "fixed" and point.body is None}
    held |= {("rod", rod.id) for rod in model.rods if rod.kind == "fixed" and rod.body is None}
    return [
        Problem(
            f"external load {load.id} is on {load.target} {load.target_id}, which is fixed: it has no effect",
            "remove it, or name another object",
            load.source,
        )
        for load in model.external_loads
        if (load.target, load.target_id) in held
    ]


def failures_are_possible(model: Model) -> Iterator[Problem]:
    """A failure takes lines off at a time or tension that can come, and leaves nothing behind that nothing holds."""
    for failure in model.failures:
        if not failure.lines:
            yield Problem(f"failure {failure.id} names no lines", "name those that come off", failure.source)
        if len(set(failure.lines)) < len(failure.lines):
            yield Problem(f"failure {failure.id} names a line twice", "name it once", failure.source, failure.lines)
        for name, value in (("time", failure.time), ("tension", failure.tension)):
            if value < 0.0:
                message = f"{name} of failure {failure.id} must not be negative"
                yield Problem(message, "write 0 where it does not count", failure.source, value)
    yield from _bare_once_all_fail(model)


def _bare_once_all_fail(model: Model) -> Iterator[Problem]:
    """Points and joints without mass from which failures take all lines."""
    massless = {("point", point.id) for point in model.points if point.kind == "free" and not point.mass > 0.0}
    massless |= {("rod", rod.id) for rod in model.rods if rod.kind == "free" and rod.segments == 0}
    tied = {(end.kind, end.id, line.id) for line in model.lines for end in _ends(line)}
    failing: dict[tuple[str, int], list[Failure]] = {}
    for failure in model.failures:
        place = (failure.attachment.kind, failure.attachment.id)
        if place in massless and (failure.time > 0.0 or failure.tension > 0.0):
            failing.setdefault(place, []).append(failure)
            tied -= {(*place, id) for id in failure.lines}
    for (kind, id), failures in failing.items():
        if all(tie[:2] != (kind, id) for tie in tied):
            ids = " and ".join(str(failure.id) for failure in failures)
            remedy = "give it mass, or leave a line on it" if kind == "point" else "leave a line on it"
            message = f"failure {ids}: {kind} {id} would be left with neither lines nor mass"
            yield Problem(message, remedy, failures[-1].source)


def failures_that_never_come(model: Model) -> Iterator[Problem]:
    """Doubt failures that name neither a time nor a tension."""
    for failure in model.failures:
        if failure.time == 0.0 and failure.tension == 0.0:
            yield Problem(f"failure {failure.id} never comes", "give it a time or a tension", failure.source)


def winches_are_possible(model: Model) -> Iterator[Problem]:
    """A line has one winch; what drives it is one table of increasing times; a segment cut in two leaves good parts."""
    owner: dict[int, int] = {}
    for control in model.controls:
        what = f"control channel {control.channel}"
        if not control.lines:
            yield Problem(f"{what} names no lines", "name those that follow it, or remove it", control.source)
        for id in control.lines:
            if id in owner:
                message = f"{what} names line {id}, which follows channel {owner[id]}"
                yield Problem(message, "a line has one winch", control.source)
            owner[id] = control.channel
        if control.end not in ("A", "B"):
            yield Problem(f"end of {what} is not known", "write A or B", control.source, control.end)
        if control.length is not None and control.rate is not None:
            yield Problem(f"{what} has both length and rate", "give one of them", control.source)
        yield from _table_increases(control)
        low, high = control.segment_range if len(control.segment_range) == 2 else (0.0, 0.0)
        if not (0.0 < low < 1.0 and high > 1.0 + low):
            remedy = "give two numbers: the first between 0 and 1, the second more than 1 above it"
            yield Problem(f"segment range of {what} leaves no segments", remedy, control.source, control.segment_range)


def _table_increases(control: Control) -> Iterator[Problem]:
    for name, table in (("length", control.length), ("rate", control.rate)):
        if not isinstance(table, Curve):
            continue
        what = f"{name} of control channel {control.channel}"
        if len(table.x) < 2 or len(table.x) != len(table.y):
            yield Problem(f"{what} has {len(table.x)} rows", "give at least two, of time and value", control.source)
        for before, after in pairwise(table.x):
            if not after > before:
                remedy = f"the time after {before:g} s must be larger"
                yield Problem(f"times of {what} do not increase", remedy, control.source, after)


def _ends(line: Line) -> tuple[Attachment, Attachment]:
    return line.end_a, line.end_b


def channels_exist(model: Model) -> Iterator[Problem]:
    """Output channels name objects and nodes that are there."""
    segments = {
        "line": {line.id: line.segments for line in model.lines},
        "rod": {rod.id: rod.segments for rod in model.rods},
        "point": {point.id: 0 for point in model.points},
        "body": {body.id: 0 for body in model.bodies},
    }
    for output in model.outputs:
        channel = parse_channel(output.name)
        if channel is None:
            yield Problem(why_not(output.name), "write FAIRTEN1, LINE1N5PX, ...", output.source, output.name)
        elif channel.id not in segments[channel.object]:
            message = f"output channel {output.name} is of {channel.object} {channel.id}, which is not described"
            yield Problem(message, described(model, channel.object), output.source)
        elif (channel.node or 0) > segments[channel.object][channel.id]:
            last = segments[channel.object][channel.id]
            message = f"output channel {output.name} is of node {channel.node}"
            yield Problem(message, f"the nodes of {channel.object} {channel.id} are 0 to {last}", output.source)
