"""Values that can be run and are hardly meant: other units, wrong signs, lines that do not reach."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist, pi
from typing import Any

from moorage.errors import Problem, Source
from moorage.model.components import Curve, Line
from moorage.model.model import Model

TONNES = (0.95, 1.1)  # densities of water in t/m3
LONGEST = 2.0  # distance of the ends over the unstretched length; ropes of nylon break at 1.5
LINE_LETTERS = "pvUDbVKtcsdWl"  # of MoorDyn-C and MoorDyn-F
ROD_LETTERS = "pvfUBDIPbWAaXY"
DEEP = 1.0  # m below the seabed that is no sinking in


def odd_types(model: Model) -> Iterator[Problem]:
    """Yield line types that ring less than nothing, or pull when they are not stretched."""
    for t in model.line_types:
        if t.axial_damping_ratio is not None and t.axial_damping_ratio > 1.0:
            what = f"axial damping ratio of line type {t.name} is above 1, which is critical"
            yield Problem(what, "give a fraction, or axial_damping in N s", t.source, t.axial_damping_ratio)
        if not isinstance(t.axial_stiffness, Curve):
            continue
        pull = _at_zero(t.axial_stiffness)
        if abs(pull) > 1e-9 * max(map(abs, t.axial_stiffness.y)):
            what = f"table of axial stiffness of line type {t.name} has a tension of {pull:.3g} N without strain"
            yield Problem(what, "add the row 0 0, or subtract it", t.source)


def _at_zero(curve: Curve) -> float:
    """Return the value of a curve at 0; beyond its ends the first or last slope goes on."""
    k = next((k for k in range(len(curve.x) - 2) if curve.x[k + 1] > 0.0), len(curve.x) - 2)
    (x0, x1), (y0, y1) = curve.x[k : k + 2], curve.y[k : k + 2]
    return y0 - x0 * (y1 - y0) / (x1 - x0)


def odd_bodies(model: Model) -> Iterator[Problem]:
    """Yield bodies that are turned by more than a turn, or that no mass can be."""
    for body in model.bodies:
        if max(map(abs, body.rotation)) > 2.0 * pi + 1e-9 and not model.flavour.startswith("MoorDyn"):
            what = f"rotation of body {body.id} is more than a turn"
            yield Problem(what, "give radians", body.source, body.rotation)
        least, middle, most = sorted(body.inertia)
        if most > 1.001 * (least + middle) and least > 0.0:
            what = f"inertia of body {body.id} is that of no body: one is more than the other two together"
            yield Problem(what, "correct it: about an axis it is the sum of m (y2 + z2)", body.source, body.inertia)


def odd_water(model: Model) -> list[Problem]:
    """Return a doubt about a density of water in t/m3."""
    density = model.environment.water_density
    if not TONNES[0] < density < TONNES[1]:
        return []
    remedy = "write kg/m3: 1025 for the sea"
    return [Problem("water is as light as air", remedy, model.source_of("water_density"), density)]


def short_lines(model: Model) -> Iterator[Problem]:
    """Yield lines between held points that would have to be stretched to twice their length."""
    places = {p.id: p.position for p in model.points if p.kind != "free" and p.body is None}
    for line in model.lines:
        apart = _apart(line, places)
        if apart > LONGEST * line.length:
            what = f"line {line.id} is {line.length:.4g} m long, and its ends are {apart:.4g} m apart"
            yield Problem(what, "correct its length, or a position", line.source)


def _apart(line: Line, places: dict[int, tuple[float, float, float]]) -> float:
    """Return how far the ends of a line are apart, m; 0 where one is not held."""
    ends = [places[end.id] for end in (line.end_a, line.end_b) if end.kind == "point" and end.id in places]
    return dist(*ends) if len(ends) == 2 else 0.0


def below_the_bed(model: Model) -> Iterator[Problem]:
    """Yield what moves and begins far below the seabed, which would throw it out; fixed points are refused there."""
    env = model.environment
    places: list[tuple[str, Any, tuple[float, float, float]]] = [("body", b, b.position) for b in model.bodies]
    places += [("point", p, p.position) for p in model.points if p.kind != "fixed" and p.body is None]
    ends = [(r, end) for r in model.rods if r.body is None for end in (r.end_a, r.end_b)[: 1 + bool(r.segments)]]
    places += [("rod", r, end) for r, end in ends]
    for kind, thing, (x, y, z) in places:
        depth = env.depth_at(x, y)
        if z < -depth - DEEP:
            what = f"{kind} {thing.id} is {-depth - z:.4g} m below the seabed, where the water is {depth:.6g} m deep"
            yield Problem(what, "correct z: it is negative below the water", thing.source, z)


def odd_letters(model: Model) -> Iterator[Problem]:
    """Yield lines and rods whose outputs have letters that ask for nothing."""
    for kind, things, letters in (("line", model.lines, LINE_LETTERS), ("rod", model.rods, ROD_LETTERS)):
        for thing in things:  # type: ignore[attr-defined]
            strange = "".join(letter for letter in thing.outputs if letter not in letters)
            if strange and thing.outputs != "-":
                what = f"outputs of {kind} {thing.id} have letters that ask for nothing: {strange}"
                yield Problem(what, f"use some of {letters}, or -", thing.source, thing.outputs)


def nothing_there(model: Model) -> list[Problem]:
    """Return a doubt about a model in which nothing can move or pull."""
    if model.lines or model.rods or model.bodies or any(point.kind == "free" for point in model.points):
        return []
    source = Source(model.file) if model.file else None
    return [Problem("the model has no lines, rods or bodies", "describe what it is made of", source)]
