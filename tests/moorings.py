"""Small moorings for tests of all kinds: words in, a model, a built system or a run out."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from moorage.layout import copy_of
from moorage.model import Attachment, Curve, Environment, Line, LineType, Model, Motion, Point, Rod, RodType, Section
from moorage.solve.march import Block, March, Settings
from moorage.solve.statics import rest, solve
from moorage.system.build import Built, build

GRAVITY, DENSITY = 9.80665, 1025.0

CHAIN = LineType(
    name="chain",
    diameter=0.0766,
    mass_per_length=113.35,
    axial_stiffness=7.536e8,
    axial_damping_ratio=0.8,
    transverse_drag=2.0,
    tangential_drag=0.4,
    transverse_added_mass=0.8,
    tangential_added_mass=0.25,
)


def kind(name: str = "rope", **properties: Any) -> LineType:
    """Return a line type with no hydrodynamics and no damping but what is asked for."""
    defaults: dict[str, Any] = {"diameter": 0.1, "mass_per_length": 20.0, "axial_stiffness": 1e7}
    return LineType(name=name, **(defaults | properties))


def line(id: int, a: int | Attachment, b: int | Attachment, *sections: tuple[str, float, int]) -> Line:
    """Return a line from point a to point b, or a rod's end; each section is (type, length in m, segments)."""
    parts = tuple(Section(line_type=name, length=length, segments=n) for name, length, n in sections)
    ends = (hold if isinstance(hold, Attachment) else Attachment("point", hold) for hold in (a, b))
    return Line(id=id, sections=parts, **dict(zip(("end_a", "end_b"), ends, strict=True)))


def clamp(id: int, position, direction) -> Rod:
    """Return a rod of no length that does not move; it points in a direction (into a line at end B)."""
    end = tuple(float(x + d) for x, d in zip(position, direction, strict=True))
    return Rod(id=id, rod_type="clamp", kind="fixed", end_a=tuple(map(float, position)), end_b=end, segments=0)  # type: ignore[arg-type]


def joint(id: int, *position: float) -> Rod:
    """Return a free rod of no length, through which the bending of two cables passes."""
    return Rod(id=id, rod_type="clamp", kind="free", end_a=position, end_b=position, segments=0)  # type: ignore[arg-type]


def held(rod: Rod, end: str) -> Attachment:
    """Return a hold on end A or B of a rod."""
    return Attachment("rod", rod.id, end)  # type: ignore[arg-type]


def fixed(id: int, *position: float, **properties: Any) -> Point:
    return Point(id=id, kind="fixed", position=position, **properties)  # type: ignore[arg-type]


def coupled(id: int, *position: float, **properties: Any) -> Point:
    return Point(id=id, kind="coupled", position=position, **properties)  # type: ignore[arg-type]


def free(id: int, *position: float, **properties: Any) -> Point:
    return Point(id=id, kind="free", position=position, **properties)  # type: ignore[arg-type]


def mooring(
    types: Iterable[LineType] | LineType,
    points: Iterable[Point],
    lines: Iterable[Line],
    rods: Iterable[Rod] = (),
    **environment: Any,
) -> Model:
    """Return a model in deep water, unless `environment` says otherwise."""
    kinds = (types,) if isinstance(types, LineType) else tuple(types)
    surroundings = Environment(**({"water_depth": 1e4} | environment))
    return Model(
        environment=surroundings,
        line_types=kinds,
        lines=tuple(lines),
        points=tuple(points),
        rod_types=(RodType(name="clamp", diameter=0.1, mass_per_length=0.0),),
        rods=tuple(rods),
    )


def single(line_type: LineType, length: float, segments: int, a: Point, b: Point, **environment: Any) -> Model:
    """Return a model of one line of one section between two points, with ids 1 and 2."""
    return mooring(line_type, (a, b), (line(1, 1, 2, (line_type.name, length, segments)),), **environment)


def spread(
    segments: int,
    line_type: LineType = CHAIN,
    length: float = 835.5,
    anchor_radius: float = 837.6,
    fairlead_radius: float = 40.868,
    **environment: Any,
) -> Model:
    """Return three chains at 60, 180 and 300 degrees in 200 m (by default those of OC4-DeepCwind)."""
    points, lines = [], []
    for k, angle in enumerate(np.deg2rad([60.0, 180.0, 300.0])):
        x, y = np.cos(angle), np.sin(angle)
        points.append(fixed(2 * k + 1, anchor_radius * x, anchor_radius * y, -200.0))
        points.append(coupled(2 * k + 2, fairlead_radius * x, fairlead_radius * y, -14.0))
        lines.append(line(k + 1, 2 * k + 1, 2 * k + 2, (line_type.name, length, segments)))
    return mooring(line_type, points, lines, **({"water_depth": 200.0} | environment))


def weight_in_water(t: LineType, density: float = DENSITY, gravity: float = GRAVITY) -> float:
    """Return the weight in water of a line type, N/m."""
    return gravity * (t.mass_per_length - density * np.pi / 4.0 * t.diameter**2)


def curve(*rows: tuple[float, float]) -> Curve:
    """Return a table from its rows (x, y)."""
    return Curve(tuple(x for x, _ in rows), tuple(y for _, y in rows))


def statics(model: Model, motion: Motion | None = None, tolerance: float | None = None) -> Built:
    """Build a model and put it into equilibrium."""
    built = build(model, motion)
    solve(built, tolerance)
    return built


def at_rest(model: Model, motion: Motion | None = None) -> Built:
    """Build a model with everything where it is described, at rest."""
    built = build(model, motion)
    rest(built)
    return built


def run(built: Built, duration: float, **settings: Any) -> Block:
    """Run a copy of a built system from its present state; return all records."""
    march = March(again(built), Settings(**settings), duration)
    return march.advance(duration)


def again(built: Built) -> Built:
    """Return the same system with a state of its own."""
    return built._replace(state=copy_of(built.state))


def nodes(built: Built, index: int = 0) -> np.ndarray:
    """Return the positions (n, 3) of the nodes of a line, m."""
    a, b = built.names.node_ptr[index : index + 2]
    return built.state.position[a:b]


def points(built: Built) -> np.ndarray:
    """Return the positions (P, 3) of the points, m."""
    return built.state.position[built.names.node_ptr[-1] :]


def end_tensions(built: Built) -> np.ndarray:
    """Return the size of the force on the end objects at rest, (lines, 2) for ends A and B, N."""
    block = March(again(built), Settings(), 0.0).first()
    return np.linalg.norm(block["end_force"][0], axis=-1)


def point_forces(built: Built) -> np.ndarray:
    """Return the force of the lines on every point at rest, (P, 3), N."""
    return March(again(built), Settings(), 0.0).first()["point_force"][0]
