"""Farms of two turbines for tests: each with an anchor line, and a line between them."""

from __future__ import annotations

import dataclasses

import numpy as np

from moorage.model import (
    Attachment,
    Body,
    Environment,
    Line,
    LineType,
    Model,
    Motion,
    Point,
    Rod,
    RodType,
    Section,
    Turbine,
)

SPAN = 800.0  # m from turbine 1 to turbine 2
WET = {"transverse_drag": 1.2, "transverse_added_mass": 1.0, "axial_damping_ratio": 0.5}  # undamped ropes ring for long
CHAIN = LineType(name="chain", diameter=0.1, mass_per_length=150.0, axial_stiffness=7e8, **WET)
ROPE = LineType(name="rope", diameter=0.2, mass_per_length=60.0, axial_stiffness=1e8, **WET)
CABLE = dataclasses.replace(ROPE, name="cable", bending_stiffness=1e5)


def line(id: int, kind: str, a: Attachment | int, b: Attachment | int, length: float, segments: int = 20) -> Line:
    ends = [end if isinstance(end, Attachment) else Attachment("point", end) for end in (a, b)]
    part = (Section(line_type=kind, length=length, segments=segments),)
    return Line(id=id, sections=part, end_a=ends[0], end_b=ends[1])


def on(id: int, turbine: int, x: float, y: float = 0.0, z: float = -10.0, **rest) -> Point:
    return Point(id=id, kind="coupled", turbine=turbine, position=(x, y, z), **rest)


def shared(first=(0.0, 0.0, 0.0), second=(SPAN, 0.0, 0.0)) -> Model:
    """Return anchors at 500 m beyond each turbine, and a rope of 780 m between the fairleads of the two."""
    (x1, y1, _), (x2, y2, _) = first, second
    return Model(
        environment=Environment(water_depth=150.0),
        line_types=(CHAIN, ROPE),
        points=(
            Point(id=1, kind="fixed", position=(x1 - 500.0, y1 - 100.0, -150.0)),
            on(2, 1, -20.0, -5.0),
            on(3, 1, 20.0),
            on(4, 2, -20.0),
            on(5, 2, 20.0, -5.0),
            Point(id=6, kind="fixed", position=(x2 + 500.0, y2 - 100.0, -150.0)),
        ),
        lines=(line(1, "chain", 1, 2, 530.0), line(2, "rope", 3, 4, 780.0), line(3, "chain", 6, 5, 530.0)),
        turbines=(Turbine(id=1, position=first), Turbine(id=2, position=second, name="east")),
    )


def carrying(reference=(0.0, 0.0, 0.0)) -> Model:
    """Return one turbine with a point, a rod and a body on it, and an anchor line to each; a cable at the rod's end."""
    x, y, _z = reference
    anchors = [(-400.0, 0.0), (-300.0, 300.0), (300.0, 300.0)]
    places = [(x + a, y + b, -100.0) for a, b in anchors]
    return Model(
        environment=Environment(water_depth=100.0),
        line_types=(CHAIN, CABLE),
        rod_types=(RodType(name="can", diameter=1.0, mass_per_length=2e3, transverse_drag=1.0),),
        points=(
            *(Point(id=k + 1, kind="fixed", position=place) for k, place in enumerate(places)),
            on(4, 1, -10.0, mass=500.0),
            Point(id=5, kind="coupled", body=1, position=(2.0, 1.0, -1.0)),
        ),
        rods=(
            Rod(
                id=1,
                rod_type="can",
                kind="coupled",
                turbine=1,
                end_a=(-5.0, 5.0, -10.0),
                end_b=(-8.0, 8.0, -14.0),
                segments=4,
            ),
        ),
        bodies=(
            Body(
                id=1,
                kind="coupled",
                turbine=1,
                position=(8.0, 8.0, -8.0),
                rotation=(0.1, -0.2, 0.3),
                mass=2e4,
                volume=10.0,
                inertia=(1e5, 1e5, 1e5),
            ),
        ),
        lines=(
            line(1, "chain", 1, 4, 410.0, 10),
            line(2, "cable", 2, Attachment("rod", 1, "B"), 440.0, 20),
            line(3, "chain", 3, 5, 440.0, 10),
        ),
        turbines=(Turbine(id=1, position=reference),),
    )


def without_turbines(model: Model, at=(0.0, 0.0, 0.0)) -> Model:
    """Return the model of one turbine with reference `at` as one of coupled things, written out by hand."""

    def there(place):
        return tuple(float(a + b) for a, b in zip(place, at, strict=True))

    def loose(thing):
        if thing.turbine is None:
            return thing
        if isinstance(thing, Rod):
            return dataclasses.replace(thing, turbine=None, end_a=there(thing.end_a), end_b=there(thing.end_b))
        return dataclasses.replace(thing, turbine=None, position=there(thing.position))

    parts = {name: tuple(map(loose, getattr(model, name))) for name in ("points", "rods", "bodies")}
    return dataclasses.replace(model, turbines=(), **parts)


def swaying(duration: float = 20.0, mirrored: bool = False) -> Motion:
    """Return a platform's motion in all six; mirrored at a plane of constant x."""
    sign = -1.0 if mirrored else 1.0
    return Motion.from_harmonics(
        duration, ramp=5.0, interval=0.1, surge=(sign * 2.0, 11.0), sway=(1.0, 12.0), heave=(1.0, 9.0),
        roll=(0.03, 10.0), pitch=(sign * 0.05, 9.0), yaw=(sign * 0.04, 13.0),
    )  # fmt: skip


def loads_of(model: Model, pose) -> np.ndarray:
    """Return the static loads on all turbines that are at a pose, (turbines, 6)."""
    from moorage import Simulation  # noqa: PLC0415

    return Simulation(model).initialize(np.ravel(pose)).reshape(-1, 6)
