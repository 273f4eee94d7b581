"""The cantilever of Hall, Sirnivas & Yu 2020, figures 3 to 5: 10 and 20 m, EI 2 MN m2, 100 kg/m, a mass at its tip.

Verifies: bending, tension, weight, point

The exact shape is the elastica that stretches, with its own weight w in water and a load P at the tip,

    EI theta'' = -(P + w (L - s)) (1 + e) cos theta,   e = (P + w (L - s)) sin(theta) / EA,   x' = (1 + e) cos theta,

theta down from the horizontal, solved here by shooting. For small loads the tip sinks by P L^3 / 3 EI, on N equal
segments by exactly 1 + 1 / (2 N^2) times that: hinges at the nodes make a trapezoidal sum of the moment's lever.

Tolerances. The tip must converge at a rate within 0.1 of 2 (0.2 for 8000 kg on 20 m, where it hangs nearly straight down),
its extrapolation be the elastica within 2e-5 of the length. By MoorDyn's rule it must be MoorDyn-C's place, whose numbers
stand below, within 1 mm (they are averages over what was left of a swing of up to 2 mm), and as near to the elastica
within 0.1 %. By the exact rule a clamp that turns by a is softer by 1 / cos(a / 2), which moves the tip down by a L times
that at most: where a is large, on 2 segments of 5 m, MoorDyn-C is nearer by up to 4 %, by luck of sign, and on 8 by
0.5 %. EI 1 % higher must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail, rate
from moorings import DENSITY, GRAVITY, clamp, free, held, kind, line, mooring, nodes, statics, weight_in_water
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

EI, EA = 2e6, 1e8
CABLE = kind("cable", diameter=0.3525, mass_per_length=100.0, axial_stiffness=EA, bending_stiffness=EI)
# MoorDyn-C 2.7.2: {(length m, mass kg, segments): (x, z) of the tip from the clamp, m}
MOORDYN = {
    (10.0, 1000.0, 2): (9.82113, -1.787299),
    (10.0, 1000.0, 4): (9.840812, -1.640741),
    (10.0, 1000.0, 6): (9.844189, -1.613448),
    (10.0, 1000.0, 8): (9.84535, -1.603884),
    (10.0, 2000.0, 2): (9.368163, -3.321625),
    (10.0, 2000.0, 4): (9.434351, -3.058327),
    (10.0, 2000.0, 6): (9.445727, -3.00898),
    (10.0, 2000.0, 8): (9.449662, -2.991613),
    (20.0, 1000.0, 10): (16.851448, -9.803123),
    (20.0, 2000.0, 10): (13.49382, -13.382202),
}
GRIDS = np.array([16, 32, 64])


def shape(length: float, mass: float, segments: int, EI: float = EI, flavour: str = "native") -> np.ndarray:
    """Positions (n, 3) of the nodes from the clamp."""
    root = clamp(1, (0.0, 0.0, -40.0), (1.0, 0.0, 0.0))
    tip = free(1, length, 0.0, -40.0, mass=mass)
    cable = dataclasses.replace(CABLE, bending_stiffness=EI)
    lines = (line(1, held(root, "B"), 1, ("cable", length, segments)),)
    model = dataclasses.replace(mooring(cable, (tip,), lines, (root,), water_depth=100.0), flavour=flavour)
    return nodes(statics(model)) - [0.0, 0.0, -40.0]


def tip(*given, **changed) -> np.ndarray:
    return shape(*given, **changed)[-1, [0, 2]]


def elastica(length: float, mass: float, at=None) -> np.ndarray:
    """Exact positions (x, z) (n, 2) at arc lengths (m), by default of the tip: shot from there, where theta' = 0."""
    w, P = weight_in_water(CABLE), mass * GRAVITY

    def slopes(s, u):  # s, x and z from the tip
        load = P + w * s
        stretch = 1.0 + load * np.sin(u[0]) / EA
        return u[1], -load * stretch * np.cos(u[0]) / EI, stretch * np.cos(u[0]), -stretch * np.sin(u[0])

    def shoot(angle):
        return solve_ivp(slopes, (0.0, length), (angle, 0.0, 0.0, 0.0), rtol=1e-11, atol=1e-12, method="DOP853",
                         dense_output=True).sol  # fmt: skip

    shot = shoot(brentq(lambda angle: shoot(angle)(length)[0], 0.0, 0.5 * np.pi, xtol=1e-14))
    return (shot(length)[2:, None] - shot(length - np.asarray([length] if at is None else at))[2:]).T


def check(length: float, mass: float, spread: float = 0.1, **wrong) -> None:
    exact = elastica(length, mass)[0]
    found = np.array([tip(length, mass, int(n), **wrong) for n in GRIDS])
    assert found[-1] + (found[-1] - found[-2]) / 3.0 == pytest.approx(exact, abs=2e-5 * length)
    assert abs(rate(1.0 / GRIDS, np.linalg.norm(found - exact, axis=1)) - 2.0) < spread, f"{found}, {exact}"


@pytest.mark.parametrize("mass", [1000.0, 2000.0])
def test_figures_3_and_4(mass):
    check(10.0, mass)


@pytest.mark.parametrize("mass", [1000.0, 2000.0, 4000.0, 8000.0])
def test_figure_5(mass):
    check(20.0, mass, 0.2 if mass == 8000.0 else 0.1)


def test_whole_shape():
    """All nodes, not the tip only, at the same rate."""
    errors = []
    for n in GRIDS:
        found = shape(20.0, 2000.0, int(n))[:, [0, 2]]
        errors.append(np.abs(found - elastica(20.0, 2000.0, np.linspace(0.0, 20.0, n + 1))).max())
    assert abs(rate(1.0 / GRIDS, errors) - 2.0) < 0.1


@pytest.mark.parametrize("segments", [2, 4, 6, 8])
def test_linear_beam(segments):
    """A load so small that the beam is linear: 2 mm on 10 m, where the next term is of 1e-7."""
    deflection = -tip(10.0, 1.0, segments)[1]
    own = weight_in_water(CABLE) * 10.0**4
    # its own weight, lumped at the nodes, adds to that
    expected = GRAVITY * 10.0**3 / (3.0 * EI) * (1.0 + 0.5 / segments**2)
    expected += own / (8.0 * EI) * (1.0 + uniform_load_error(segments))
    assert deflection == pytest.approx(expected, rel=1e-4)


def uniform_load_error(n: int) -> float:
    """Relative error of the tip of a cantilever with loads lumped at n nodes, hinges at all."""
    s = np.linspace(0.0, 1.0, n + 1)
    load = np.full(n + 1, 1.0 / n)
    load[[0, -1]] *= 0.5
    moment = np.array([np.sum(load * np.maximum(s - x, 0.0)) for x in s])
    flexible = np.full(n + 1, 1.0 / n)
    flexible[0] *= 0.5
    return float(8.0 * np.sum(moment * flexible * (1.0 - s)) - 1.0)


def test_neutral_buoyancy():
    assert abs(weight_in_water(CABLE)) < 1e-3 * DENSITY


@pytest.mark.parametrize("case", MOORDYN)
def test_as_near_as_moordyn_by_its_rule(case):
    ours, theirs, exact = tip(*case, flavour="MoorDyn-C"), np.array(MOORDYN[case]), elastica(*case[:2])[0]
    assert ours == pytest.approx(theirs, abs=1e-3)
    assert np.linalg.norm(ours - exact) < 1.001 * np.linalg.norm(theirs - exact)


@pytest.mark.parametrize("case", MOORDYN)
def test_as_near_as_moordyn_by_the_exact_rule(case):
    length, mass, _ = case
    found, exact = shape(*case), elastica(length, mass)[0]
    a = np.arctan2(-found[1, 2], found[1, 0])
    softer = a * length / np.cos(0.5 * a) - a * length
    assert np.linalg.norm(found[-1, [0, 2]] - tip(*case, flavour="MoorDyn-C")) < softer
    ours, theirs = (np.linalg.norm(place - exact) for place in (found[-1, [0, 2]], np.array(MOORDYN[case])))
    assert ours < 1.04 * theirs


def test_stiffer_cable_fails():
    must_fail(check, 10.0, 1000.0, EI=1.01 * EI)
