"""A model in MoorDyn's terms: lines of one section each, and objects numbered from 1 in their order."""

from __future__ import annotations

import dataclasses
import re
from itertools import accumulate, pairwise

from moorage.model import Attachment, Curve, Line, Model, OutputChannel, Point, Rod, RodType
from moorage.model.channels import parse_channel
from moorage.model.turbines import placed


@dataclasses.dataclass(frozen=True)
class Flat:
    """A model that MoorDyn's tables can say, and what was changed for that."""

    model: Model
    notes: list[str]


def flatten(model: Model) -> Flat:
    """Return the model with sections split into lines and with numbers counting from 1.

    Sections are joined by free points without mass, or by free zero-length rods where a moment has to pass.
    """
    notes: list[str] = _unsaid(model)
    model = _numbered(model, notes)
    return Flat(_split(model, notes), notes)


def _unsaid(model: Model) -> list[str]:
    """Return what a line of MoorDyn cannot have."""
    notes = [
        f"line type {t.name}: carries_compression is not written; MoorDyn's segments go slack"
        for t in model.line_types
        if t.carries_compression
    ]
    for line in model.lines:
        if line.stiffeners:
            notes.append(f"line {line.id}: bend stiffeners are not written; MoorDyn has none")
        if line.end_a_stiffness is not None or line.end_b_stiffness is not None:
            notes.append(f"line {line.id}: rotational stiffness of its ends is not written; rods clamp in MoorDyn")
        if any(section.grading != 1.0 for section in line.sections):
            notes.append(f"line {line.id}: graded segments are written as equal ones")
        if any(section.modules for section in line.sections):
            notes.append(f"line {line.id}: buoyancy modules are not written; give them a line type of their own")
    return notes


def _numbered(model: Model, notes: list[str]) -> Model:
    """Return the model with lines, points, rods, bodies, failures and loads numbered 1, 2, 3, ..."""
    maps = {
        "line": {line.id: k + 1 for k, line in enumerate(model.lines)},
        "point": {point.id: k + 1 for k, point in enumerate(model.points)},
        "rod": {rod.id: k + 1 for k, rod in enumerate(model.rods)},
        "body": {body.id: k + 1 for k, body in enumerate(model.bodies)},
    }
    changed = [f"{kind} {old} is now {new}" for kind, ids in maps.items() for old, new in ids.items() if old != new]
    if not changed:
        return model
    notes.append("numbers must count from 1: " + ", ".join(changed))

    def tied(end: Attachment) -> Attachment:
        return dataclasses.replace(end, id=maps[end.kind][end.id])

    def carried(body: int | None) -> int | None:
        return None if body is None else maps["body"][body]

    def numbers(lines: tuple[int, ...]) -> tuple[int, ...]:
        return tuple(maps["line"][id] for id in lines)

    return dataclasses.replace(
        model,
        lines=tuple(
            dataclasses.replace(x, id=maps["line"][x.id], end_a=tied(x.end_a), end_b=tied(x.end_b)) for x in model.lines
        ),
        points=tuple(dataclasses.replace(x, id=maps["point"][x.id], body=carried(x.body)) for x in model.points),
        rods=tuple(dataclasses.replace(x, id=maps["rod"][x.id], body=carried(x.body)) for x in model.rods),
        bodies=tuple(dataclasses.replace(x, id=maps["body"][x.id]) for x in model.bodies),
        failures=tuple(
            dataclasses.replace(x, attachment=tied(x.attachment), lines=numbers(x.lines)) for x in model.failures
        ),
        controls=tuple(dataclasses.replace(x, lines=numbers(x.lines)) for x in model.controls),
        external_loads=tuple(
            dataclasses.replace(x, target_id=maps[x.target][x.target_id]) for x in model.external_loads
        ),
        outputs=tuple(_renamed(x, maps) for x in model.outputs),
    )


def _renamed(output: OutputChannel, maps: dict[str, dict[int, int]]) -> OutputChannel:
    channel = parse_channel(output.name)
    if channel is None:
        return output
    name = re.sub(r"\d+", str(maps[channel.object][channel.id]), output.name, count=1)
    return dataclasses.replace(output, name=name)


def _split(model: Model, notes: list[str]) -> Model:
    """Return the model with every section as a line of its own; line k's first section keeps its place in the order."""
    if all(len(line.sections) == 1 for line in model.lines):
        return model
    lines: list[Line] = []
    points, rods = list(model.points), list(model.rods)
    joint = _free_name("joint", [t.name for t in model.rod_types])
    pieces: dict[int, list[Line]] = {}
    for line in model.lines:
        joints = _joints(line, model, points, rods, joint)
        starts, stops = [line.end_a, *(after for _, after in joints)], [*(before for before, _ in joints), line.end_b]
        pieces[line.id] = [
            Line(
                id=len(lines) + k + 1,
                sections=(section,),
                end_a=starts[k],
                end_b=stops[k],
                name=line.name,
                outputs=line.outputs,
                syrope_tensions=line.syrope_tensions,
                source=line.source,
            )
            for k, section in enumerate(line.sections)
        ]
        lines += pieces[line.id]
        if joints:
            first, last = pieces[line.id][0].id, lines[-1].id
            what = "free points" if joints[0][0].kind == "point" else "free zero-length rods"
            notes.append(
                f"line {line.id} of {len(joints) + 1} sections is now lines {first} to {last}, joined by {what}"
            )
    made = RodType(name=joint, diameter=0.1, mass_per_length=0.0)
    types = model.rod_types + ((made,) if len(rods) > len(model.rods) else ())
    model = _renumbered_events(model, pieces)
    return dataclasses.replace(model, lines=tuple(lines), points=tuple(points), rods=tuple(rods), rod_types=types)


def _free_name(name: str, taken: list[str]) -> str:
    while name in taken:
        name += "_"
    return name


def _joints(
    line: Line, model: Model, points: list[Point], rods: list[Rod], joint: str
) -> list[tuple[Attachment, Attachment]]:
    """Add the points or rods between the sections of a line, on the chord between its ends.

    Returns what the section before a joint and the one after it are tied to.
    """
    start, end = (_position(tie, placed(model)) for tie in (line.end_a, line.end_b))
    lengths = list(accumulate(section.length for section in line.sections))
    stiff = any(_is_stiff(model, section.line_type) for section in line.sections)
    axis = tuple(b - a for a, b in zip(start, end, strict=True))
    joints: list[tuple[Attachment, Attachment]] = []
    for length in lengths[:-1]:
        x, y, z = (a + length / lengths[-1] * d for a, d in zip(start, axis, strict=True))
        z = max(z, -model.environment.depth_at(x, y))
        if stiff:
            ahead = (x + axis[0], y + axis[1], z + axis[2])
            rods.append(Rod(id=len(rods) + 1, rod_type=joint, kind="free", end_a=(x, y, z), end_b=ahead, segments=0))
            joints.append((Attachment("rod", len(rods), "A"), Attachment("rod", len(rods), "B")))
        else:
            points.append(Point(id=len(points) + 1, kind="free", position=(x, y, z)))
            joints.append((Attachment("point", len(points)),) * 2)
    return joints


def _is_stiff(model: Model, name: str) -> bool:
    stiffness = model.line_type(name).bending_stiffness
    return isinstance(stiffness, Curve) or stiffness > 0.0


def _position(tie: Attachment, model: Model) -> tuple[float, float, float]:
    """Return where a line end is at the start (objects on bodies: without the body's rotation)."""
    if tie.kind == "point":
        thing = model.point(tie.id)
        place, body = thing.position, thing.body
    else:
        rod = next(rod for rod in model.rods if rod.id == tie.id)
        place, body = rod.end_a if tie.end == "A" or rod.segments == 0 else rod.end_b, rod.body
    if body is not None:
        carrier = next(b for b in model.bodies if b.id == body)
        place = tuple(a + b for a, b in zip(place, carrier.position, strict=True))  # type: ignore[assignment]
    return place


def _renumbered_events(model: Model, pieces: dict[int, list[Line]]) -> Model:
    """Return the model with failures, controls and channels naming the pieces that they mean."""
    ends = {line.id: line for line in model.lines}

    def piece(id: int, place: Attachment) -> int:
        return pieces[id][0 if ends[id].end_a == place else -1].id

    return dataclasses.replace(
        model,
        failures=tuple(
            dataclasses.replace(x, lines=tuple(piece(id, x.attachment) for id in x.lines)) for x in model.failures
        ),
        controls=tuple(
            dataclasses.replace(x, lines=tuple(part.id for id in x.lines for part in pieces[id]))
            for x in model.controls
        ),
        outputs=tuple(_repointed(x, pieces) for x in model.outputs),
    )


def _repointed(output: OutputChannel, pieces: dict[int, list[Line]]) -> OutputChannel:
    channel = parse_channel(output.name)
    if channel is None or channel.object != "line":
        return output
    parts = pieces[channel.id]
    node = channel.node or 0
    if node == -1:
        name = re.sub(r"\d+", str(parts[-1].id), output.name, count=1)
        return dataclasses.replace(output, name=name)
    bounds = [0, *accumulate(part.segments for part in parts)]
    k = next(k for k, (_, last) in enumerate(pairwise(bounds)) if node <= last)
    name = re.sub(r"\d+", str(parts[k].id), output.name, count=1)
    node_number = re.compile(r"(?<=\dN)\d+")
    return dataclasses.replace(output, name=node_number.sub(str(node - bounds[k]), name, count=1))
