"""What the paper leaves open about the umbilical, and how much each choice moves the results."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from moorage.model import Model, Point
from studies.bending_2020.umbilical import DURATION, GAMMA, RAOS, run, sea, statistics, umbilical
from studies.parts import Effort, Part, table
from studies.peers import with_environment, with_types


class Choice(NamedTuple):
    """Something chosen, and what else it could be."""

    what: str
    change: Callable[[Model], Model] = lambda model: model
    sea: dict = {}  # noqa: RUF012
    raos: dict = RAOS
    settings: dict = {}  # noqa: RUF012


def depth(model: Model, value: float) -> Model:
    """Return the cable in another depth, its anchor on the seabed."""

    def lower(point: Point) -> Point:
        return dataclasses.replace(point, position=(*point.position[:2], -value))

    model = dataclasses.replace(model, points=tuple(map(lower, model.points)))
    return with_environment(model, water_depth=value)


def hang(model: Model, lower: float = 0.0, degrees: float = 30.0) -> Model:
    """Return the cable hung some metres lower, or leaving at another angle from the vertical."""
    (rod,) = model.rods
    x, y, z = rod.end_b
    back = -np.sin(np.radians(degrees)), np.cos(np.radians(degrees))
    top = float(z - lower)
    end_a = (float(x - back[0]), y, float(top + back[1]))
    return dataclasses.replace(model, rods=(dataclasses.replace(rod, end_a=end_a, end_b=(x, y, top)),))


def raos(**changed) -> dict:
    """Return the responses with some of them changed."""
    return RAOS | changed


def choices() -> Iterator[Choice]:
    """Yield what was chosen and, one by one, what else it could be."""
    yield Choice("as chosen")
    yield Choice("depth 65 m instead of 70", lambda m: depth(m, 65.0), {"depth": 65.0})
    yield Choice("depth 75 m", lambda m: depth(m, 75.0), {"depth": 75.0})
    yield Choice("hang-off 5 m higher, at -15 m", lambda m: hang(m, -5.0))
    yield Choice("cable leaves straight down instead of at 30 degrees", lambda m: hang(m, 0.0, 0.0))
    yield Choice(f"gamma 1 instead of {GAMMA:g}", sea={"gamma": 1.0})
    yield Choice("another realisation of the sea", sea={"seed": 2})
    yield Choice("a third one", sea={"seed": 3})
    yield Choice("heave 1.0 m/m instead of 0.9", raos=raos(heave=(1.0, -0.15)))
    yield Choice("surge 0.8 m/m instead of 0.6", raos=raos(surge=(0.8, -0.5 * np.pi)))
    yield Choice("surge leads the crest instead of following it", raos=raos(surge=(0.6, 0.5 * np.pi)))
    yield Choice("no pitch", raos=raos(pitch=(0.0, 0.0)))
    other_way = raos(surge=(-0.6, -0.5 * np.pi), pitch=(-RAOS["pitch"][0], 0.5 * np.pi))
    yield Choice("anchor down-wave", sea={"direction": np.pi}, raos=other_way)
    yield Choice(
        "seabed 3 MPa/m instead of 0.15", lambda m: with_environment(m, seabed_stiffness=3e6, seabed_damping=3e5)
    )
    yield Choice("no tangential drag instead of 0.05", lambda m: with_types(m, tangential_drag=0.0))
    yield Choice("axial damping 0.1 of critical instead of 0.8", lambda m: with_types(m, axial_damping_ratio=0.1))
    yield Choice("clamp by equation 10", lambda m: dataclasses.replace(m, flavour="MoorDyn-C"))
    yield Choice("no stretching of the waves instead of Wheeler's", sea={"stretching": "none"})
    yield Choice("segments of 0.5 m", lambda _: umbilical(2))
    yield Choice("steps ten times as accurate", settings={"tolerance": 2e-4})


def open_values(effort: Effort) -> Part:
    """Return the table of what was chosen."""
    duration = 100.0 if effort.quick else DURATION
    rows, numbers = [], {}
    for choice in choices():
        found = statistics(run(choice.change(umbilical()), sea(**choice.sea), duration, choice.raos, **choice.settings))
        numbers[choice.what] = found
        rows.append(
            (choice.what, *(f"{found[key]:.2f}" for key in ("mean", "std", "min", "max")), f"{found['curvature']:.3f}")
        )
    header = ("changed", "mean, kN", "std", "lowest", "highest", "largest curvature, 1/m")
    return Part({"umbilical_open": numbers}, {"umbilical_open": table(header, rows)}, {})
