"""The moorings of the paper, and how the platform moves.

Of the paper: three lines of 500 m of 120 mm R3 studless chain and 1000 m of 186 mm polyester, 850 m of water, fairleads
at a radius of 58 m, anchors at 1130 m, slopes of 12.5 % between 700 and 1000 m; coefficients of friction and c_v.
Chosen: properties of chain and rope (by rules of thumb), hydrodynamic coefficients, seabed stiffness, fairleads' depth.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from moorage.model import (
    Attachment,
    Bathymetry,
    Environment,
    Failure,
    Friction,
    Line,
    LineType,
    Model,
    Motion,
    Point,
    Section,
)

CHAIN = LineType(
    name="chain",  # d 120 mm: 1.8 d, 19.9e3 d^2 kg/m, 0.854e11 d^2 N
    diameter=0.216,
    mass_per_length=286.56,
    axial_stiffness=1.22976e9,
    axial_damping_ratio=1.0,
    transverse_drag=2.0,
    tangential_drag=0.4,
    transverse_added_mass=0.8,
    tangential_added_mass=0.25,
)
POLYESTER = LineType(
    name="polyester",  # d 186 mm: 0.86 d, 0.7978e3 d^2 kg/m
    diameter=0.160,
    mass_per_length=27.60,
    axial_stiffness=1.1e8,
    axial_damping_ratio=1.0,
    transverse_drag=1.2,
    tangential_drag=0.05,
    transverse_added_mass=1.0,
)
HEADINGS = (180.0, 60.0, 300.0)  # deg, of lines 1 to 3
DEPTH, FAIRLEAD_RADIUS, FAIRLEAD_DEPTH, ANCHOR_RADIUS = 850.0, 58.0, 14.0, 1130.0
CHAIN_LENGTH, CHAIN_SEGMENTS, ROPE_LENGTH, ROPE_SEGMENTS = 500.0, 25, 1000.0, 20
GRADE = 0.125
SLOPES = {
    "normal": (0.0, 0.0),
    "upslope": (GRADE, 0.0),
    "downslope": (-GRADE, 0.0),
    "sideslope": (0.0, GRADE),
}  # as line 1 sees them
WEIGHT = 9.80665 * (CHAIN.mass_per_length - 1025.0 * np.pi / 4.0 * CHAIN.diameter**2)  # N/m of chain in water

AXIAL, TRANSVERSE, STATIC, DAMPING = 0.69, 1.0, 1.33, 1e6  # of the paper; static over kinetic (0.92 / 0.69)
DAMPED = Friction(model="saturated-damping", axial=AXIAL, transverse=TRANSVERSE, static_ratio=STATIC, damping=DAMPING)
STICKING = Friction(model="elastic-slip", axial=AXIAL, transverse=TRANSVERSE, laid=True)

HEIGHT, PERIOD = 9.3, 14.9  # m, s: regular waves that go towards +y
RAOS = {"sway": (2.8 / 4.65, 0.0), "heave": (4.0 / 4.65, 0.5 * np.pi), "roll": (np.radians(1.6) / 4.65, 0.3)}


def semi_taut(
    slope: tuple[float, float] = SLOPES["normal"],
    friction: Friction | None = None,
    lines: Sequence[int] = (1, 2, 3),
    refine: int = 1,
) -> Model:
    """Return the mooring on a plane that falls by `slope` along x and y, with some of its lines.

    Points 1, 2, 3 are the anchors, 11, 12, 13 the fairleads.
    """
    x, y = (-1200.0, 1200.0), (-1200.0, 1200.0)
    depth = tuple(tuple(DEPTH + slope[0] * a + slope[1] * b for b in y) for a in x)
    environment = Environment(
        water_depth=DEPTH, seabed_damping=1e5, friction=friction, bathymetry=Bathymetry(x=x, y=y, depth=depth)
    )
    sections = (
        Section(line_type="chain", length=CHAIN_LENGTH, segments=refine * CHAIN_SEGMENTS),
        Section(line_type="polyester", length=ROPE_LENGTH, segments=refine * ROPE_SEGMENTS),
    )
    return spread(environment, (CHAIN, POLYESTER), sections, ANCHOR_RADIUS, lines)


def spread(environment: Environment, types, sections, anchor_radius: float, lines: Sequence[int]) -> Model:
    """Return equal lines at the headings of the paper."""
    points, ropes = [], []
    for k in lines:
        c, s = np.cos(np.radians(HEADINGS[k - 1])), np.sin(np.radians(HEADINGS[k - 1]))
        x, y = float(anchor_radius * c), float(anchor_radius * s)
        top = float(FAIRLEAD_RADIUS * c), float(FAIRLEAD_RADIUS * s), -FAIRLEAD_DEPTH
        points.append(Point(id=k, kind="fixed", position=(x, y, -environment.depth_at(x, y))))
        points.append(Point(id=10 + k, kind="coupled", position=top))
        ends = {"end_a": Attachment("point", k), "end_b": Attachment("point", 10 + k)}
        ropes.append(Line(id=k, sections=sections, **ends))
    return Model(environment=environment, line_types=types, points=tuple(points), lines=tuple(ropes))


def anchor_failure(friction: Friction | None, time: float = 20.0, **other) -> Model:
    """Return line 1 alone, whose anchor lets go at a time (s)."""
    model = semi_taut(friction=friction, lines=(1,), **other)
    return dataclasses.replace(
        model, failures=(Failure(id=1, attachment=Attachment("point", 1), lines=(1,), time=time),)
    )


def in_waves(duration: float, ramp: float = 30.0) -> Motion:
    """Return the platform's motion in the waves, which grow over `ramp`."""
    modes = {mode: (response * 0.5 * HEIGHT, PERIOD, lead) for mode, (response, lead) in RAOS.items()}
    return Motion.from_harmonics(duration, ramp=ramp, interval=0.1, **modes)


def pulled(duration: float, speed: float = 0.2, ramp: float = 10.0) -> Motion:
    """Return the fairlead of line 1 pulled away from its anchor at a speed (m/s) that comes over `ramp`."""
    time = np.arange(0.0, duration + 0.1, 0.1)
    x = -FAIRLEAD_RADIUS + speed * travelled(time, ramp)
    return Motion.from_points(time, {11: np.column_stack([x, 0.0 * time, 0.0 * time - FAIRLEAD_DEPTH])})


def about_the_anchor(duration: float, speed: float = 0.9, ramp: float = 20.0) -> Motion:
    """Return the fairlead of line 1 on an arc about its anchor at constant radius and speed (m/s)."""
    time = np.arange(0.0, duration + 0.1, 0.1)
    radius = ANCHOR_RADIUS - FAIRLEAD_RADIUS
    angle = speed * travelled(time, ramp) / radius
    track = [-ANCHOR_RADIUS + radius * np.cos(angle), radius * np.sin(angle), 0.0 * time - FAIRLEAD_DEPTH]
    return Motion.from_points(time, {11: np.column_stack(track)})


def travelled(time: np.ndarray, ramp: float) -> np.ndarray:
    """Return the way at unit speed, which grows from nothing over a ramp without a jump in acceleration, s."""
    grown = np.minimum(time, ramp)
    return 0.5 * (grown - ramp / np.pi * np.sin(np.pi * grown / ramp)) + np.maximum(time - ramp, 0.0)
