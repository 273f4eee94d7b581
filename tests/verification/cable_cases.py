"""Random power cables that hang in water: lazy waves, steep waves, catenaries and W shapes, one a number.

A shape is made from the forces in it. A limp cable with a horizontal tension H and the vertical component V(s), which its
weight changes, has the slope V / H: where V is positive it rises towards the hang-off. So the lengths that hang on
either side of each sag and hog are drawn, and H by the radius of a sag, H / w; where the ends are, follows.
"""

from __future__ import annotations

import dataclasses

import numpy as np
from cables import sections
from moorings import DENSITY, GRAVITY, clamp, fixed, held, kind, line, mooring

from moorage.model import BendStiffener, Line, Model

SHAPES = ("lazy wave", "steep wave", "catenary", "W")
AREA_TO_MASS = DENSITY * np.pi / 4.0  # times the square of a diameter: what a metre displaces, kg
SEGMENTS = 137


class Draw:
    """Random numbers of one case."""

    def __init__(self, number: int):
        self.random = np.random.default_rng([7, number])

    def between(self, low: float, high: float) -> float:
        return float(self.random.uniform(low, high))

    def decades(self, low: float, high: float) -> float:
        return float(10.0 ** self.random.uniform(np.log10(low), np.log10(high)))

    def chance(self, share: float) -> bool:
        return bool(self.random.uniform() < share)


def lengths_of(shape: str, draw: Draw, uplift: float) -> tuple[float, tuple[float, ...]]:
    """Return V / w at end A (m) and the lengths of the bare, buoyant and bare parts; what lies on the bed has V < 0."""
    hang = draw.between(20.0, 80.0)
    if shape == "catenary":
        lying = draw.between(5.0, 80.0)
        return -lying, (lying + 2.0 * hang,)
    sag = hang * draw.between(0.3, 0.9)  # from the hog down to the sag
    up = sag * draw.between(1.5, 3.0)  # and from there up to the hang-off
    start = {"lazy wave": -draw.between(5.0, 60.0), "steep wave": hang * draw.between(0.1, 0.5)}.get(shape, -up)
    return start, (hang - start, (hang + sag) / uplift, sag + up)


def places(start: float, radius: float, parts, loads, lies: bool) -> np.ndarray:
    """Return (x, z) from end A of a limp inextensible cable; loads: weight of its parts over that of the bare one."""
    n = [max(2, round(4.0 * part)) for part in parts]
    ds = np.repeat([part / k for part, k in zip(parts, n, strict=True)], n)
    weight = ds * np.repeat(loads, n)
    V = start + np.cumsum(weight) - 0.5 * weight
    if lies:
        V[: np.argmax(V > 0.0)] = 0.0
    T = np.hypot(radius, V)
    return np.cumsum(np.column_stack([radius / T * ds, V / T * ds]), axis=0)


def random_cable(number: int) -> tuple[str, Model]:
    """Return the name of a shape and a cable of about 137 segments that hangs in it."""
    shape, draw = SHAPES[number % len(SHAPES)], Draw(number)
    uplift = draw.between(0.6, 2.5)  # of floats, over the weight in water of the bare cable
    start, parts = lengths_of(shape, draw, uplift)
    lies = start < 0.0 and shape != "W"
    radius = draw.decades(4.0, 40.0)
    path = places(start, radius, parts, (1.0, -uplift, 1.0)[: len(parts)], lies)
    span, rise = path[-1]
    top = 5.0 + max(path[:, 1].max() - rise, 0.0) + draw.between(0.0, 20.0)  # the hog stays below the surface
    low = -top - rise
    depth = draw.between(10.0, 50.0) - low - path[:, 1].min() if shape == "W" else -low
    heading = draw.between(0.0, 2.0 * np.pi)
    a, b = np.array([0.0, 0.0, low]), np.array([span * np.cos(heading), span * np.sin(heading), -top])
    fine = SEGMENTS / sum(parts)
    names = ("bare",) if len(parts) == 1 else ("bare", "afloat", "bare")
    cut = sections(*((t, x, max(3, round(fine * x))) for t, x in zip(names, parts, strict=True)))
    if draw.chance(0.3):
        cut = (*cut[:-1], dataclasses.replace(cut[-1], grading=draw.between(0.3, 1.0)))
    return shape, hung(draw, shape, random_types(draw, uplift, radius), cut, a, b, heading, depth)


def random_types(draw: Draw, uplift: float, radius: float):
    """Return a bare and a buoyant line type, (EI / w)^(1/3) of the bare one 0.1 to 0.7 of the sags' radius."""
    d, ratio = draw.between(0.08, 0.25), draw.between(1.5, 4.0)
    displaced = AREA_TO_MASS * d**2
    lift = uplift * displaced * (ratio - 1.0)
    EI = GRAVITY * displaced * (ratio - 1.0) * (draw.between(0.1, 0.7) * radius) ** 3
    wide = max(d * draw.between(2.0, 4.0), np.sqrt((ratio * displaced + 1.1 * lift) / AREA_TO_MASS))
    common = {"transverse_drag": 1.2, "axial_damping_ratio": 0.5}
    common |= {"axial_stiffness": draw.decades(2e7, 1e9), "bending_stiffness": float(np.clip(EI, 1e3, 1e5))}
    bare = kind("bare", diameter=d, mass_per_length=ratio * displaced, **common)
    return bare, kind("afloat", diameter=wide, mass_per_length=AREA_TO_MASS * wide**2 - lift, **common)


def hung(draw: Draw, shape: str, types, cut, a, b, heading: float, depth: float) -> Model:
    """Return the cable from a to b, clamped at the hang-off some degrees off the vertical; pinned or clamped at end A."""
    out = np.array([np.cos(heading), np.sin(heading), 0.0])
    off, beside = draw.between(0.0, 0.5), draw.between(-0.3, 0.3)
    down = np.array([0.0, 0.0, -1.0]) - np.tan(off) * out + np.tan(beside) * np.array([-out[1], out[0], 0.0])
    rods, points = [clamp(1, b, down)], []
    if shape == "steep wave":
        rods.append(clamp(2, a, (0.0, 0.0, 1.0)))
    elif shape == "W" and draw.chance(0.5):
        rods.append(clamp(2, a, np.array([0.0, 0.0, -1.0]) + np.tan(off) * out))
    else:
        points.append(fixed(1, *map(float, a)))
    end_a = held(rods[1], "B") if len(rods) == 2 else line(1, 1, 1).end_a
    cable = Line(id=1, sections=cut, end_a=end_a, end_b=held(rods[0], "B"))
    if draw.chance(0.3):
        cable = dataclasses.replace(cable, end_b_stiffness=draw.decades(1e2, 1e6))
    d = types[0].diameter
    if draw.chance(0.3) and cut[-1].length > 6.0:
        sleeve = BendStiffener(end="B", length=draw.between(2.0, 5.0), root_diameter=d + draw.between(0.2, 0.5),
                               tip_diameter=d + 0.04, youngs_modulus=draw.decades(1e7, 1e8), density=1150.0)  # fmt: skip
        cable = dataclasses.replace(cable, stiffeners=(sleeve,))
    return mooring(types, points, (cable,), rods, water_depth=float(depth), seabed_stiffness=draw.decades(1e4, 1e6))
