"""What makes a line a cable: bending stiffness, and where it passes from one line to another."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from math import acos, dist, pi, sin
from typing import Literal

from moorage.errors import Problem, Source
from moorage.model.components import Attachment, BendStiffener, Body, Curve, Line, Rod
from moorage.model.model import Model

BACKWARDS = 150.0 * pi / 180.0
TURNING = ("free", "pinned", "coupled-pinned")  # kinds of what forces turn


def bends(model: Model, line: Line, end: Literal["A", "B"]) -> bool:
    """Return whether the section of a line at an end has bending stiffness (a bend stiffener counts)."""
    section = line.sections[0 if end == "A" else -1]
    if any(stiffener.end == end for stiffener in line.stiffeners):
        return True
    known = {t.name.lower(): t.bending_stiffness for t in model.line_types}
    stiffness = known.get(section.line_type.lower(), 0.0)
    return isinstance(stiffness, Curve) or stiffness > 0.0


def ends_at(model: Model, hold: Attachment) -> list[tuple[Line, Literal["A", "B"]]]:
    """Return the line ends tied to a point, or to one end of a rod."""
    sides: tuple[tuple[Literal["A", "B"], str], ...] = (("A", "end_a"), ("B", "end_b"))
    return [(line, end) for line in model.lines for end, name in sides if getattr(line, name) == hold]


def stiff_ends(model: Model, rod: int) -> list[tuple[Line, Literal["A", "B"]]]:
    """Return the line ends with bending stiffness that are tied to a rod."""
    tied = [*ends_at(model, Attachment("rod", rod, "A")), *ends_at(model, Attachment("rod", rod, "B"))]
    return [(line, end) for line, end in tied if line.sections and bends(model, line, end)]


def clamped_ends(model: Model, rod: int) -> list[tuple[Line, Literal["A", "B"]]]:
    """Return the line ends with bending stiffness that are tied to a rod and not pinned there."""
    return [(line, end) for line, end in stiff_ends(model, rod) if _spring(line, end) != 0.0]


def _spring(line: Line, end: str) -> float | None:
    return line.end_a_stiffness if end == "A" else line.end_b_stiffness


def is_joint(rod: Rod) -> bool:
    """Return whether a rod is an end of lines that has no direction of its own: the cables on it give it one."""
    free = rod.kind == "free" and rod.body is None
    return not rod.segments and (free or rod.kind in ("pinned", "coupled-pinned"))


def is_hinge(model: Model, rod: Rod) -> bool:
    """Return whether a free joint is nothing but the hinge between two cables, one clamped at each of its ends."""
    ends = clamped_ends(model, rod.id)
    sides = {line.end_a.end if end == "A" else line.end_b.end for line, end in ends}
    springs = any(_spring(line, end) is not None for line, end in ends)
    return rod.kind == "free" and len(ends) == len(sides) == 2 and not springs


def turns(model: Model, rod: Rod) -> bool:
    """Return whether a joint has a rotation of its own, in which the moments of the cables on it balance."""
    return is_joint(rod) and len(clamped_ends(model, rod.id)) > 1 and not is_hinge(model, rod)


def folded_joints(model: Model) -> Iterator[Problem]:
    """Yield joints that all cables leave on the same side, so that one would fold back along the other."""
    for rod in model.rods:
        ends = clamped_ends(model, rod.id)
        sides = {line.end_a.end if end == "A" else line.end_b.end for line, end in ends}
        if is_joint(rod) and len(ends) > 1 and len(sides) == 1:
            ids = " and ".join(str(line.id) for line, _ in ends)
            message = (
                f"cables {ids} are all tied to end {sides.pop()} of rod {rod.id}, so that they leave it side by side"
            )
            yield Problem(message, "tie one to end A and the other to end B, if they should go on straight", rod.source)


def clamps_are_apart(model: Model) -> Iterator[Problem]:
    """A cable has enough segments where joints, or clamps on what moves, reach to the node beside its end."""
    for line in model.lines:
        near = [end for end, hold in (("A", line.end_a), ("B", line.end_b)) if _reaches_in(model, line, end, hold)]
        if near and line.segments < 1 + len(near):
            what = "both its ends are clamped" if len(near) == 2 else f"its end {near[0]} is clamped"
            message = f"line {line.id} has too few segments: {what} by what moves or turns"
            yield Problem(message, f"give it at least {1 + len(near)}", line.source, line.segments)


def _reaches_in(model: Model, line: Line, end: str, hold: Attachment) -> bool:
    """Return whether the bending of an end reaches to the node beside it: it is clamped to what forces turn."""
    rod = next((rod for rod in model.rods if hold.kind == "rod" and rod.id == hold.id), None)
    if rod is None or not line.sections or _spring(line, end) == 0.0:
        return False
    if not bends(model, line, "A" if end == "A" else "B"):
        return False
    if is_joint(rod):
        return len(clamped_ends(model, rod.id)) > 1
    carrier: Rod | Body | None = rod
    if rod.body is not None and rod.kind != "pinned":
        carrier = next((body for body in model.bodies if body.id == rod.body), None)
    return carrier is not None and carrier.kind in TURNING


def directions_are_given(model: Model) -> Iterator[Problem]:
    """A rod of no length that clamps a cable has a direction."""
    for rod in model.rods:
        if not rod.segments and not is_joint(rod) and rod.end_a == rod.end_b:
            message = f"rod {rod.id} has no length and its ends coincide, so that it has no direction"
            yield Problem(message, "put end B where the rod should point to, seen from end A", rod.source)


def clamps_face_their_lines(model: Model) -> Iterator[Problem]:
    """No line is so short that it cannot leave its clamp backwards and turn round: it is on the wrong end of the rod.

    A curve of radius R that starts at the angle a to the straight way takes R (a - sin a) more than that way. Cables
    bend to no less than five diameters, or to what their type allows.
    """
    for line in model.lines:
        if not line.sections:
            continue
        for end, hold, far, spring in (
            ("A", line.end_a, line.end_b, line.end_a_stiffness),
            ("B", line.end_b, line.end_a, line.end_b_stiffness),
        ):
            here, there, direction = _place(model, hold), _place(model, far), _clamp_direction(model, hold)
            if here is None or there is None or direction is None or spring == 0.0 or here == there:
                continue
            if not bends(model, line, "A" if end == "A" else "B"):
                continue
            way = tuple(b - a for a, b in zip(here, there, strict=True))
            cosine = sum(u * v for u, v in zip(way, direction, strict=True)) / dist(here, there)
            angle = acos(max(-1.0, min(1.0, cosine)))
            slack = sum(section.length for section in line.sections) - dist(here, there)
            if angle > BACKWARDS and slack < _tightest(model, line) * (angle - sin(angle)):
                other = "B" if hold.end == "A" else "A"
                message = (
                    f"line {line.id} is on the wrong end of rod {hold.id}: there it leaves at {angle * 180.0 / pi:.0f} "
                    "degrees to the way to its other end, and is too short to turn round"
                )
                yield Problem(message, f"tie it to end {other} of rod {hold.id}", line.source, str(hold))


def _place(model: Model, hold: Attachment) -> tuple[float, float, float] | None:
    """Return where a point or a rod of no length stands that is fixed or coupled by itself."""
    if hold.kind == "point":
        point = next((point for point in model.points if point.id == hold.id), None)
        return point.position if point and point.kind != "free" and point.body is None else None
    rod = next((rod for rod in model.rods if rod.id == hold.id), None)
    held = rod is not None and rod.kind in ("fixed", "coupled") and rod.body is None and not rod.segments
    return rod.end_a if rod is not None and held else None


def _clamp_direction(model: Model, hold: Attachment) -> tuple[float, ...] | None:
    """Return the unit vector along which a line leaves the end of a rod of no length."""
    rod = next((rod for rod in model.rods if hold.kind == "rod" and rod.id == hold.id), None)
    if rod is None or rod.segments or rod.end_a == rod.end_b:
        return None
    sign = (1.0 if hold.end == "B" else -1.0) / dist(rod.end_a, rod.end_b)
    return tuple(sign * (b - a) for a, b in zip(rod.end_a, rod.end_b, strict=True))


def _tightest(model: Model, line: Line) -> float:
    """Return the smallest radius to which a line bends anywhere, m."""
    used = {section.line_type.lower() for section in line.sections}
    types = [t for t in model.line_types if t.name.lower() in used]
    return min((max(t.minimum_bend_radius or 0.0, 5.0 * t.diameter) for t in types), default=0.0)


def stiffeners_fit(model: Model) -> Iterator[Problem]:
    """A bend stiffener lies on the section at its end, is not thinner than the line, and has a stiffness."""
    diameters = {t.name.lower(): t.diameter for t in model.line_types}
    for line in model.lines:
        for stiffener in line.stiffeners:
            section = line.sections[0 if stiffener.end == "A" else -1]
            where = stiffener.source or line.source
            name = f"bend stiffener at end {stiffener.end} of line {line.id}"
            if stiffener.length <= 0.0:
                yield Problem(f"length of the {name} must be positive", "correct it", where, stiffener.length)
            elif stiffener.length > section.length:
                message = f"{name} is longer than its section of {section.length:g} m"
                yield Problem(message, "shorten it, or lengthen the section", where, stiffener.length)
            thinnest = min(stiffener.root_diameter, stiffener.tip_diameter)
            if thinnest < diameters.get(section.line_type.lower(), 0.0):
                yield Problem(f"{name} is thinner than the line", "give outer diameters", where, thinnest)
            if stiffener.density < 0.0:
                yield Problem(f"density of the {name} must not be negative", "correct it", where, stiffener.density)
            yield from _stiffness_is_given(stiffener, name, where)


def _stiffness_is_given(stiffener: BendStiffener, name: str, where: Source | None) -> Iterator[Problem]:
    profile = stiffener.stiffness
    if profile is None:
        if stiffener.youngs_modulus <= 0.0:
            yield Problem(f"{name} has no stiffness", "give Young's modulus, or EI along it", where)
    else:
        if len(profile.x) < 2 or any(b <= a for a, b in pairwise(profile.x)):
            message = f"distances of EI of the {name} do not increase"
            yield Problem(message, "give two or more, from the root on", where, profile.x)
        if min(profile.y, default=0.0) < 0.0:
            yield Problem(f"EI of the {name} must not be negative", "correct it", where, min(profile.y))


def springs_are_possible(model: Model) -> Iterator[Problem]:
    """Rotational springs at line ends are not negative, and sit on rods."""
    for line in model.lines:
        for end, spring, hold in (("A", line.end_a_stiffness, line.end_a), ("B", line.end_b_stiffness, line.end_b)):
            name = f"rotational stiffness of end {end} of line {line.id}"
            if spring is not None and spring < 0.0:
                yield Problem(f"{name} must not be negative", "correct it", line.source, spring)
            elif spring and hold.kind == "point":
                yield Problem(f"{name} has no rod to turn in", f"tie end {end} to a rod", line.source, spring)


def sections_are_graded_well(model: Model) -> Iterator[Problem]:
    """Grading is positive, modules surround the line and fit their pitch."""
    diameters = {t.name.lower(): t.diameter for t in model.line_types}
    for line in model.lines:
        for section in line.sections:
            where = section.source or line.source
            if section.grading <= 0.0:
                yield Problem(f"grading of line {line.id} must be positive", "correct it", where, section.grading)
            modules = section.modules
            if modules is None:
                continue
            name, place = f"buoyancy modules of line {line.id}", modules.source or where
            if modules.pitch <= 0.0 or modules.length <= 0.0 or modules.length > modules.pitch:
                message = f"{name} are {modules.length:g} m long at a pitch of {modules.pitch:g} m"
                yield Problem(message, "give a pitch of at least the length", place)
            if modules.mass < 0.0:
                yield Problem(f"mass of the {name} must not be negative", "correct it", place, modules.mass)
            if modules.diameter < diameters.get(section.line_type.lower(), 0.0):
                yield Problem(f"{name} are thinner than the line", "give the outer diameter", place, modules.diameter)


def pinned_junctions(model: Model) -> list[Problem]:
    """Return the free points where cables with bending stiffness meet but no moment passes; worth a warning."""
    found = []
    for point in model.points:
        tied = [(line, end) for line, end in ends_at(model, Attachment("point", point.id)) if bends(model, line, end)]
        if point.kind == "free" and len(tied) > 1:
            ids = ", ".join(str(line.id) for line, _ in tied)
            message = f"cables {ids} meet at free point {point.id}, which is a pin: no bending moment passes there"
            found.append(Problem(message, "join them by a free rod of no length", point.source))
    return found
