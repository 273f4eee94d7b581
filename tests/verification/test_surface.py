"""Lines and points in the surface: statics and heave in closed form.

Verifies: weight, point, tension, morison

Hanging line. A stiff heavy line hangs from a point above the water, its lower part in it: the force at its top is its
weight less the buoyancy of what is below the surface, wherever nodes happen to be. The wet fraction of a section
falls linearly across the surface, so that a vertical line whose ends are clear of it has exactly the displaced volume
below it: 0.2 N of 25 kN are allowed for the imbalance that statics accept and for stretching (1e-7).

Spar. A line of one segment, held at its foot under water, carries a horizontal and a vertical force at its top in the
air. With the wet part w = D / (L cos a) at a depth D of the foot, moments about the foot (its buoyancy B acts at w L
/ 2) give

    (B w^2 / 2 - W / 2 + F) sin a = P cos a

for the angle a to the vertical. The band in which the wet fraction falls, of half height d / 2, adds (d / (2 L cos
a))^2 / 3 to w^2, some 1e-4: 2e-4 rad are allowed.

Floating line. A line lighter than water lies in the surface with its axis at z = (d / 2)(1 - 2 m / (rho A)), and
heaves about it with omega^2 = (rho g A / d) / (m + share of the added mass), because the wet fraction falls by 1 / d.
(A real cylinder has another chord there; the linear law is MoorDyn's.)

Float. A sphere of half the water's density floats with its centre in the surface and heaves with
omega^2 = rho g pi R^2 / (m + Ca rho V / 2); with another density it floats where (1 - s)^2 (2 + s) / 4 = m / (rho V).
"""

from __future__ import annotations

import numpy as np
import pytest
from common import frequency, must_fail
from moorings import (
    DENSITY,
    GRAVITY,
    fixed,
    free,
    kind,
    line,
    mooring,
    nodes,
    point_forces,
    points,
    run,
    single,
    statics,
    weight_in_water,
)
from scipy.optimize import brentq

AREA = np.pi / 4.0 * 0.3**2


def check_hanging(top: float, segments: int, density: float = DENSITY) -> None:
    rope = kind(diameter=0.3, mass_per_length=150.0, axial_stiffness=1e11)
    built = statics(
        single(rope, 30.0, segments, free(1, 0.0, 0.0, top - 30.0), fixed(2, 0.0, 0.0, top)), tolerance=5e-3
    )
    expected = GRAVITY * (150.0 * 30.0 - density * AREA * (30.0 - top))
    assert -point_forces(built)[1, 2] == pytest.approx(expected, abs=0.2)


@pytest.mark.parametrize("segments", [1, 3, 10])
@pytest.mark.parametrize("top", [0.2, 3.21, 12.0, 29.8])
def test_line_hanging_into_the_water(top, segments):
    check_hanging(top, segments)


def test_hanging_into_other_water_fails():
    must_fail(check_hanging, 3.21, 10, 1.001 * DENSITY)


def spar(depth: float, vertical: float, horizontal: float) -> float:
    """Angle of the spar to the vertical."""
    pole = kind(diameter=0.3, mass_per_length=40.0, axial_stiffness=1e9)
    foot, top = (
        fixed(1, 0.0, 0.0, -depth),
        free(2, 3.0, 4.0, 12.0 - depth, external_force=(0.6 * horizontal, 0.8 * horizontal, vertical)),
    )
    built = statics(single(pole, 20.0, 1, foot, top), tolerance=1e-2)
    q = nodes(built)[1] - nodes(built)[0]
    assert q[0] * 0.8 == pytest.approx(q[1] * 0.6, abs=1e-6)
    return float(np.arccos(q[2] / np.linalg.norm(q)))


def check_spar(depth: float, vertical: float, horizontal: float, weight: float = 40.0 * GRAVITY) -> None:
    def moment(a):
        wet = min(depth / (20.0 * np.cos(a)), 1.0)
        lift = 0.5 * DENSITY * GRAVITY * AREA * 20.0 * wet**2 - 0.5 * weight * 20.0 + vertical
        return lift * np.sin(a) - horizontal * np.cos(a)

    expected = brentq(moment, 1e-3, np.pi / 2.0 - 1e-3)
    assert spar(depth, vertical, horizontal) == pytest.approx(expected, abs=2e-4)


@pytest.mark.parametrize(
    ("depth", "vertical", "horizontal"), [(12.0, 0.0, 400.0), (12.0, 1000.0, 100.0), (8.0, 2500.0, 900.0)]
)
def test_spar_leans(depth, vertical, horizontal):
    check_spar(depth, vertical, horizontal)


def test_wrong_spar_fails():
    must_fail(check_spar, 12.0, 1000.0, 100.0, 1.005 * 40.0 * GRAVITY)


LIGHT = kind(diameter=0.3, mass_per_length=0.4 * DENSITY * AREA, axial_stiffness=1e6, transverse_added_mass=0.8)
FLOATS_AT = 0.15 * (1.0 - 2.0 * 0.4)


def floating(offset: float = 0.0):
    """A line on the water between two free ends; `offset` above the level where it floats."""
    model = single(LIGHT, 20.0, 5, free(1, 0.0, 0.0, 0.0), free(2, 20.0, 0.0, 0.0))
    built = statics(model)
    built.state.position[...] += [0.0, 0.0, offset]
    return built


def test_line_floats_at_its_level():
    z = nodes(floating())[:, 2]
    assert z == pytest.approx(np.full(6, FLOATS_AT), abs=1e-6)


def check_line_heave(added_mass: float) -> None:
    omega = np.sqrt(DENSITY * GRAVITY * AREA / 0.3 / (0.4 * DENSITY * AREA * (1.0 + added_mass)))
    dt = 2.0 * np.pi / omega / 400.0
    built = floating(1e-4)
    block = run(built, 800.0 * dt, time_step=dt, dt_out=dt, tolerance=1e-10)
    assert frequency(block["point_position"][::20, 0, 2], 20.0 * dt) == pytest.approx(omega, rel=2e-4)


def test_line_heaves():
    check_line_heave(0.8)


def test_line_with_all_its_added_mass_fails():
    """Only the wet part (0.4) has added mass; with all of it the frequency would be 28 % lower."""
    must_fail(check_line_heave, 2.0)


RADIUS = (0.75 * 5.0 / np.pi) ** (1.0 / 3.0)


def sphere(share: float, added_mass: float = 0.5):
    """A float of 5 m3 that has `share` of the water's density, beside two held lines."""
    ball = free(3, 50.0, 0.0, 0.3, mass=share * DENSITY * 5.0, volume=5.0, added_mass=added_mass)
    held = fixed(1, 0.0, 0.0, -5.0), fixed(2, 9.0, 0.0, -5.0)
    return statics(mooring(LIGHT, (*held, ball), (line(1, 1, 2, ("rope", 9.0, 2)),)), tolerance=1e-5)


@pytest.mark.parametrize("share", [0.05, 0.3, 0.5, 0.8, 0.99])
def test_sphere_floats_at_its_level(share):
    s = brentq(lambda x: 0.25 * (1.0 - x) ** 2 * (2.0 + x) - share, -1.0, 1.0)
    assert points(sphere(share))[2, 2] == pytest.approx(s * RADIUS, abs=1e-6)


def check_sphere_heave(added_mass: float) -> None:
    omega = np.sqrt(DENSITY * GRAVITY * np.pi * RADIUS**2 / (0.5 * DENSITY * 5.0 * (1.0 + added_mass)))
    dt = 2.0 * np.pi / omega / 400.0
    built = sphere(0.5)
    built.state.position[-1, 2] += 1e-3
    block = run(built, 800.0 * dt, time_step=dt, dt_out=dt, tolerance=1e-10)
    assert frequency(block["point_position"][::20, 2, 2], 20.0 * dt) == pytest.approx(omega, rel=1e-4)


def test_sphere_heaves():
    check_sphere_heave(0.5)


def test_sphere_with_other_added_mass_fails():
    must_fail(check_sphere_heave, 0.51)


def test_weight_in_water_is_what_a_sunken_line_weighs():
    rope = kind(diameter=0.3, mass_per_length=150.0)
    built = statics(single(rope, 31.0, 8, fixed(1, 0.0, 0.0, -50.0), fixed(2, 30.0, 0.0, -45.0)))
    assert -point_forces(built)[:, 2].sum() == pytest.approx(31.0 * weight_in_water(rope), abs=0.01)
