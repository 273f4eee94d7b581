"""What a host changes in a model: lengths and stiffness of lines, broken ends; and what this module does by itself."""

from __future__ import annotations

import dataclasses

import numpy as np

from moorage.model import Attachment, Model, Point


def without_host_parts(model: Model) -> Model:
    """Return a model without what this module does itself (failures, water that the host gives), and without winches,
    which MoorDyn-C does not know: hosts set lengths with `SetLineUnstretchedLength`.
    """
    env = model.environment
    if env.unread_water is not None and (env.unread_water.option, str(env.unread_water.value)) == ("WaveKin", "1"):
        env = dataclasses.replace(env, unread_water=None)
    return dataclasses.replace(model, failures=(), controls=(), environment=env)


def option(model: Model, name: str, default: str) -> str:
    """Return the value of an option that means nothing to the engine."""
    return next((o.value for o in model.unused_options if o.name == name), default)


def with_line(model: Model, k: int, length: float | None, stiffness: float | None) -> Model:
    """Return a model with another unstretched length (all sections in proportion) or axial stiffness of a line."""
    line, types = model.lines[k], model.line_types
    sections = line.sections
    if length is not None:
        factor = length / line.length
        sections = tuple(dataclasses.replace(s, length=s.length * factor) for s in sections)
    if stiffness is not None:
        own = {s.line_type: f"{s.line_type} of line {line.id}" for s in sections if " of line " not in s.line_type}
        made = [dataclasses.replace(model.line_type(name), name=new) for name, new in own.items()]
        sections = tuple(dataclasses.replace(s, line_type=own.get(s.line_type, s.line_type)) for s in sections)
        names = {s.line_type for s in sections}
        types = tuple(
            dataclasses.replace(t, axial_stiffness=stiffness) if t.name in names else t for t in (*types, *made)
        )
    lines = list(model.lines)
    lines[k] = dataclasses.replace(line, sections=sections)
    return dataclasses.replace(model, lines=tuple(lines), line_types=types)


def without_stiffness(model: Model, k: int) -> Model:
    """Return a model whose line has its own types again, without the axial stiffness of `with_line`."""
    line = model.lines[k]
    own = tuple(
        dataclasses.replace(s, line_type=s.line_type.removesuffix(f" of line {line.id}")) for s in line.sections
    )
    lines = list(model.lines)
    lines[k] = dataclasses.replace(line, sections=own)
    return dataclasses.replace(model, lines=tuple(lines))


def broken(model: Model, attachment: Attachment, places: tuple[int, ...], position: np.ndarray) -> Model:
    """Return a model in which lines hold on to a free point of their own, at a position, instead of an attachment."""
    id, free = max((point.id for point in model.points), default=0) + 1, tuple(position.tolist())
    if attachment.kind == "point":
        old = model.point(attachment.id)
        new = dataclasses.replace(old, id=id, kind="free", body=None, turbine=None, position=free)
    else:
        new = Point(id=id, kind="free", position=free)
    lines = list(model.lines)
    for k in places:
        ends = {name: Attachment("point", id) for name in ("end_a", "end_b") if getattr(lines[k], name) == attachment}
        lines[k] = dataclasses.replace(lines[k], **ends)  # type: ignore[arg-type]
    return dataclasses.replace(model, points=(*model.points, new), lines=tuple(lines))
