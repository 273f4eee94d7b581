"""Rods at rest: hung, pinned and afloat at an angle, upright as a spar.

Verifies: rigid, weight

* A rod of mass M and volume V hung from a line hangs upright, and the line holds (M - rho V) g.
* A rod of length L and of s times the density of water, pinned at a depth D, lies at the angle T from the vertical
  where the moments about the pin are nothing. With a = D / cos T the wet length of its axis, c = 1 / cos^2 T, and r its
  radius, the centre of buoyancy of a cylinder cut by the surface gives (I = pi r^4 / 4 its waterplane's moment)

      s L^2 = a^2 + r^2 (1 + c) / 4.

  Ours makes the section dry linearly over its own diameter, which alone is r^2 c / 3, and adds what the waterplane of
  an upright rod has more than that:

      s L^2 = a^2 + r^2 (1/6 + c/3).

  They differ by r^2 (c - 1) / 12 in a^2: nothing for the upright rod.
* An upright spar that carries a weight M below sinks to (M + m L) / (rho pi r^2).

Statics stop at 1 mN, which is a few micrometres of the rod's end here.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail
from floats import SPAR, WATER, body, floating, rod
from moorings import DENSITY, GRAVITY, at_rest, fixed, held, kind, line, run, statics
from scipy.optimize import brentq

from moorage.model import RodType

AREA, RADIUS, LENGTH, DEPTH = np.pi / 4.0 * SPAR.diameter**2, 0.5 * SPAR.diameter, 10.0, 4.0


def at_once(built):
    return run(built, 0.1, dt_out=0.1)


def check_hanging(density: float) -> None:
    heavy = dataclasses.replace(SPAR, mass_per_length=300.0)
    stick = rod(1, "free", (0.0, 0.0, -20.0), (0.5, 0.2, -26.0))
    length = np.sqrt(6.0**2 + 0.5**2 + 0.2**2)
    thread = line(1, 1, held(stick, "A"), ("thread", 10.0, 4))
    thin = kind("thread", diameter=1e-4, mass_per_length=1e-4, axial_stiffness=1e6)
    model = floating(rods=(stick,), types=heavy, line_types=thin, points=(fixed(1, 0.0, 0.0, -10.0),), lines=(thread,))
    built = statics(model)
    block = at_once(built)
    r = block["rod_position"][0, 0]
    weight = (300.0 - density * AREA) * length * GRAVITY
    assert r[1] - r[0] == pytest.approx([0.0, 0.0, -length], abs=1e-5)
    assert r[0, 2] == pytest.approx(-20.0 - 10.0 * weight / 1e6, abs=1e-5)
    assert block["end_tension"][0, 0] == pytest.approx(weight, rel=1e-5)


def test_hanging_rod():
    check_hanging(DENSITY)


def test_a_rod_that_hangs_in_air_fails():
    must_fail(check_hanging, 0.0)


def leaning(segments: int) -> tuple[float, float]:
    """Angle from the vertical (rad) and draught (m) of the rod pinned at DEPTH, from our statics."""
    tilt = 0.9
    top = np.array([np.sin(tilt), 0.0, np.cos(tilt)]) * LENGTH - [0.0, 0.0, DEPTH]
    model = floating(rods=(rod(1, "pinned", (0.0, 0.0, -DEPTH), top, segments),))
    r = at_once(statics(model))["rod_position"][0, 0]
    assert np.linalg.norm(r[1] - r[0]) == pytest.approx(LENGTH, rel=1e-12)
    angle = float(np.arctan2(np.hypot(*(r[1] - r[0])[:2]), r[1, 2] - r[0, 2]))
    return angle, LENGTH - r[1, 2] / np.cos(angle)


def lean(constant: float, slope: float) -> float:
    """Angle that solves s L^2 = a^2 + r^2 (constant + slope c)."""
    s = SPAR.mass_per_length / (DENSITY * AREA)

    def miss(angle):
        c = 1.0 / np.cos(angle) ** 2
        return DEPTH**2 * c + RADIUS**2 * (constant + slope * c) - s * LENGTH**2

    return brentq(miss, 0.01, 1.5, xtol=1e-14)


def check_leaning(constant: float, slope: float, room: float) -> None:
    for segments in (1, 3, 10):
        angle, wet = leaning(segments)
        expected = lean(constant, slope)
        assert angle == pytest.approx(expected, abs=room)
        assert wet == pytest.approx(DEPTH / np.cos(expected), abs=10.0 * room)


def test_pinned_floating_rod():
    """As few segments as one are enough: the buoyancy of a segment acts where it is."""
    check_leaning(1.0 / 6.0, 1.0 / 3.0, 1e-6)


def test_pinned_floating_rod_is_nearly_a_cut_cylinder():
    """d(angle) is r^2 (c - 1) / 12 by the derivative 2 D^2 c tan T of the left-hand side."""
    exact = lean(0.25, 0.25)
    c = 1.0 / np.cos(exact) ** 2
    difference = RADIUS**2 * (c - 1.0) / 12.0 / (2.0 * DEPTH**2 * c * np.tan(exact))
    assert difference < 1e-3
    check_leaning(0.25, 0.25, 1.2 * difference)


def test_a_rod_without_waterplane_fails():
    must_fail(check_leaning, 0.0, 1.0 / 3.0, 1e-6)


def check_draught(gravity_of_water: float) -> None:
    ballast = 150.0
    low = body(position=(0.0, 0.0, -8.0), rotation=(0.05, -0.04, 0.3), mass=ballast, inertia=(5.0, 5.0, 5.0))
    spar = rod(1, "fixed", (0.0, 0.0, 0.0), (0.0, 0.0, LENGTH), 5, body=1)
    block = at_once(statics(floating((low,), (spar,), environment=WATER)))
    expected = (ballast + SPAR.mass_per_length * LENGTH) / (gravity_of_water * AREA)
    assert -block["body_position"][0, 0, 2] == pytest.approx(expected, abs=2e-6)
    assert block["body_rotation"][0, 0, :2] == pytest.approx([0.0, 0.0], abs=1e-5)
    assert np.abs(block["body_force"][0, 0, :3]).max() < 2e-3


def test_draught_of_a_spar():
    check_draught(DENSITY)


def test_draught_in_fresh_water_fails():
    must_fail(check_draught, 1000.0)


@pytest.mark.parametrize(("tilt", "wet"), [(0.0, False), (0.3, False), (0.6, True)])
def test_a_thick_rod_above_the_water_is_dry_until_its_edge_is_in(tilt, wet):
    """End A is 2 m above the water, its face reaches 5 m sin(tilt) below its middle."""
    thick = RodType(name="spar", diameter=10.0, mass_per_length=1000.0)
    end = np.array([LENGTH * np.sin(tilt), 0.0, 2.0 + LENGTH * np.cos(tilt)])
    model = floating(rods=(rod(1, "free", (0.0, 0.0, 2.0), end),), types=thick)
    force = run(at_rest(model), 0.1, dt_out=0.1)["rod_force"][0, 0]
    assert (force[2] > -1000.0 * LENGTH * GRAVITY * (1.0 - 1e-12)) == wet
    assert force[2] < 0.0
