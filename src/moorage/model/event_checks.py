"""Checks that failures, controls, loads and output channels name what exists."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from moorage.errors import Problem
from moorage.model.channels import parse_channel, why_not
from moorage.model.components import Attachment, Line
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
