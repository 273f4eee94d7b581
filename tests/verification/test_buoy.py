"""Small motions of buoys about where they float: heave, pitch and roll.

Verifies: rigid, weight

A buoy of mass M = rho V on a rod of radius r that goes through the surface, with added mass A along and none across:

* heave: w^2 = rho g pi r^2 / (M + A), A that of the half sphere at its wet end and of the body;
* pitch about its centre of gravity G, with B the centre of buoyancy and J the inertia about G:
  w^2 = (M g (z_B - z_G) + rho g pi r^4 / 4) / J.

The second term is the waterplane's: a tenth of the restoring moment here. Motions are 1e-3 m and 1e-3 rad, so that what
is not linear is 1e-6; steps h = 0.01 s make (w h)^2 / 12 < 1e-4 of the frequency at w = 3.3 rad/s.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import frequency, must_fail
from floats import WATER, body, floating, rod, throw
from moorings import DENSITY, GRAVITY, at_rest, run

from moorage.model import RodType

DIAMETER, LENGTH, DRAUGHT = 2.0, 6.0, 4.0
RADIUS = 0.5 * DIAMETER
AREA = np.pi * RADIUS**2
HULL = RodType(name="spar", diameter=DIAMETER, mass_per_length=200.0, end_added_mass=0.6)
BALLAST = DENSITY * AREA * DRAUGHT - HULL.mass_per_length * LENGTH
STEP = 0.01


def buoy(end_added_mass: float = 0.0, **properties):
    """A hull with its end A at the body's reference point, DRAUGHT deep, and ballast 0.5 m above there."""
    hull = RodType(name="spar", diameter=DIAMETER, mass_per_length=200.0, end_added_mass=end_added_mass)
    keel = body(
        position=(0.0, 0.0, -DRAUGHT),
        mass=BALLAST,
        inertia=(5e3, 6e3, 7e3),
        centre_of_gravity=(0.0, 0.0, 0.5),
        **properties,
    )
    return floating(
        (keel,), (rod(1, "fixed", (0.0, 0.0, 0.0), (0.0, 0.0, LENGTH), 6, body=1),), types=hull, environment=WATER
    )


def test_it_floats_at_its_draught():
    block = run(at_rest(buoy()), STEP, dt_out=STEP, time_step=STEP)
    assert np.abs(block["body_force"][0, 0]).max() < 1e-6 * BALLAST * GRAVITY


def check_heave(added: float) -> None:
    built = throw(at_rest(buoy(end_added_mass=0.6)), velocity=(0.0, 0.0, 1e-3))
    z = run(built, 8.0, dt_out=STEP, time_step=STEP, tolerance=1e-10)["body_position"][:, 0, 2]
    expected = np.sqrt(DENSITY * GRAVITY * AREA / (BALLAST + HULL.mass_per_length * LENGTH + added))
    assert frequency(z, STEP) == pytest.approx(expected, rel=2e-4)


def test_heave():
    check_heave(0.6 * DENSITY * np.pi * DIAMETER**3 / 12.0)


def test_heave_without_added_mass_fails():
    must_fail(check_heave, 0.0)


def check_pitch(waterplane: float, axis: int) -> None:
    spin = 1e-3 * np.eye(3)[axis]
    hull = HULL.mass_per_length * LENGTH
    M = BALLAST + hull
    G = (0.5 * BALLAST + 0.5 * LENGTH * hull) / M
    solid = hull * (LENGTH**2 / 12.0 + DIAMETER**2 / 16.0)
    J = [5e3, 6e3][axis] + BALLAST * (G - 0.5) ** 2 + solid + hull * (G - 0.5 * LENGTH) ** 2
    K = M * GRAVITY * (0.5 * DRAUGHT - G) + waterplane * DENSITY * GRAVITY * np.pi * RADIUS**4 / 4.0
    # it turns about G: the reference point moves
    side = np.cross(spin, [0.0, 0.0, -G])
    built = throw(at_rest(buoy()), velocity=side, spin=spin)
    angle = run(built, 12.0, dt_out=STEP, time_step=STEP, tolerance=1e-10)["body_rotation"][:, 0, axis]
    assert frequency(angle, STEP) == pytest.approx(np.sqrt(K / J), rel=2e-4)


@pytest.mark.parametrize("axis", [0, 1])
def test_pitch_and_roll(axis):
    check_pitch(1.0, axis)


@pytest.mark.parametrize("wrong", [0.0, 5.0 / 3.0])
def test_another_waterplane_fails(wrong):
    """None, and that of dry sections and of the whole waterplane together."""
    must_fail(check_pitch, wrong, 1)


def check_moment(cut: float) -> None:
    """Moment about the keel of the buoy tilted by 0.05 rad: a cylinder cut by the surface, to tan^2 / 12 of r^2."""
    tilt = 0.05
    model = buoy(rotation=(0.0, tilt, 0.0))
    force = run(at_rest(model), STEP, dt_out=STEP, time_step=STEP)["body_force"][0, 0]
    a, hull = DRAUGHT / np.cos(tilt), HULL.mass_per_length * LENGTH
    upright = DENSITY * AREA * (0.5 * a**2 + cut * RADIUS**2 / 8.0 * (2.0 + np.tan(tilt) ** 2))
    expected = -GRAVITY * np.sin(tilt) * (upright - 0.5 * BALLAST - 0.5 * LENGTH * hull)
    assert force[4] == pytest.approx(expected, rel=2e-4)
    assert force[2] == pytest.approx(GRAVITY * DENSITY * AREA * (a - DRAUGHT), rel=1e-3)


def test_moment_of_a_tilted_buoy():
    check_moment(1.0)


def test_moment_without_waterplane_fails():
    must_fail(check_moment, 0.0)
