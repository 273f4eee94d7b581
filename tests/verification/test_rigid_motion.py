"""Free and pinned rotation at large angles: pendulum, tumbling, top, body in an ideal fluid.

Verifies: rigid

Closed forms and invariants, each approached to the second order of the step (a rate of 2 within 0.15 is asserted):

* A rod of length L hung at end A from rest at the angle a: sin(angle / 2) = k cd(w t | k^2), k = sin(a / 2),
  w^2 = m g L / (2 J), J = m L^2 / 3 + m d^2 / 16 (solid cylinder, about a diameter of its end).
* A body without loads keeps energy and the angular momentum R J Omega about its centre of gravity, which goes straight.
* A top of weight m g with its centre of gravity l up its axis from the pin, tilted by A, goes round the vertical at the
  steady rate W if its spin along the axis is n = (m g l + J1 W^2 cos A) / (J3 W), J1 about the pin (Goldstein, 5.7).
* A body with different added mass along its axes keeps Kirchhoff's energy and impulses (Lamb, Hydrodynamics, 124).
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from floats import AIR, VACUUM, body, floating, rod, throw, world
from moorings import GRAVITY, at_rest, run
from scipy.special import ellipj, ellipk

from moorage.model import RodType
from moorage.model.motion import rotation_matrices

THICK = RodType(name="thick", diameter=1.0, mass_per_length=10.0)
LENGTH, START = 4.0, np.radians(150.0)
SECOND = pytest.approx(2.0, abs=0.15)


def pendulum_angle(t: float, inertia: float) -> float:
    """Angle from straight down of a pendulum let go at START, rad."""
    w, k = np.sqrt(THICK.mass_per_length * LENGTH * GRAVITY * LENGTH / (2.0 * inertia)), np.sin(0.5 * START)
    _, cn, dn, _ = ellipj(w * t, k * k)
    return 2.0 * np.arcsin(k * cn / dn)


def check_pendulum(thickness: float) -> None:
    mass, T = THICK.mass_per_length * LENGTH, 5.0
    J = mass * (LENGTH**2 / 3.0 + thickness * THICK.diameter**2 / 16.0)
    expected = pendulum_angle(T, J)
    tip = np.array([np.sin(START), 0.0, -np.cos(START)]) * LENGTH
    for segments in (1, 4):
        model = floating(
            rods=(rod(1, "pinned", (0, 0, -20), tip - [0, 0, 20], segments, "thick"),), types=THICK, environment=AIR
        )
        errors, steps = [], np.array([0.04, 0.02, 0.01])
        for h in steps:
            r = run(at_rest(model), T, dt_out=T, time_step=h, tolerance=1e-7)["rod_position"][-1, 0]
            errors.append(abs(np.arctan2(r[1, 0] - r[0, 0], r[0, 2] - r[1, 2]) - expected))
        assert rate(steps, errors) == SECOND
        assert errors[-1] < 0.01


def test_pendulum():
    """It has gone almost to the other side and back in 5 s; more segments of the rod change nothing."""
    assert ellipk(np.sin(0.5 * START) ** 2) > 2.5  # far from a small angle
    check_pendulum(1.0)


def test_a_thin_pendulum_fails():
    must_fail(check_pendulum, 0.0)


INERTIA, CENTRE = np.array([10.0, 20.0, 35.0]), np.array([0.2, 0.1, -0.3])


def tumbling(h: float, **environment):
    tumbler = body(inertia=tuple(INERTIA), centre_of_gravity=tuple(CENTRE))
    built = throw(at_rest(floating((tumbler,), environment=VACUUM)), (0.3, 0.0, -0.1), (1.0, 5.0, 0.3))
    return run(built, 5.0, dt_out=0.5, time_step=h, tolerance=1e-9)


def tumbling_errors(h: float, inertia) -> np.ndarray:
    block = tumbling(h)
    R, w = block["body_axes"][:, 0], block["body_velocity"][:, 0, 3:]
    H = np.einsum("nij,nj->ni", world(R, np.diag(inertia)), w)
    v = block["body_velocity"][:, 0, :3] + np.cross(w, R @ CENTRE)
    spin = np.array([1.0, 5.0, 0.3])
    H0, E0 = inertia * spin, 0.5 * (inertia * spin) @ spin
    v0 = np.array([0.3, 0.0, -0.1]) + np.cross(spin, CENTRE)
    energy = 0.5 * np.einsum("ni,ni->n", H, w)
    return np.array([np.abs(H - H0).max() / np.abs(H0).max(), np.abs(energy / E0 - 1.0).max(), np.abs(v - v0).max()])


def check_tumbling(inertia) -> None:
    steps = np.array([0.02, 0.01, 0.005])
    errors = np.array([tumbling_errors(h, inertia) for h in steps])
    for k in range(3):
        assert rate(steps, errors[:, k]) == SECOND
    assert (errors[-1] < [2e-3, 2e-3, 5e-3]).all()


def test_tumbling_keeps_energy_and_momenta():
    """The axis of middle inertia is unstable: the body turns over again and again."""
    assert (tumbling(0.01)["body_axes"][:, 0, 1, 1].min()) < 0.0
    check_tumbling(INERTIA)


def test_tumbling_with_another_inertia_fails():
    must_fail(check_tumbling, INERTIA[[1, 0, 2]])


def check_top(about_pin: bool) -> None:
    mass, arm, tilt, W = 30.0, 0.5, np.radians(40.0), 2.0
    J1, J3 = 2.0, 1.5
    J = J1 + mass * arm**2 * about_pin
    spin = (mass * GRAVITY * arm + J * W**2 * np.cos(tilt)) / (J3 * W)
    top = body(
        kind="pinned", mass=mass, inertia=(J1, J1, J3), centre_of_gravity=(0.0, 0.0, arm), rotation=(0.0, tilt, 0.0)
    )
    axis = np.array([np.sin(tilt), 0.0, np.cos(tilt)])
    w = W * np.array([0.0, 0.0, 1.0]) + (spin - W * np.cos(tilt)) * axis
    R, T = rotation_matrices(np.array([[0.0, tilt, 0.0]]))[0], 3.0
    expected = [np.sin(tilt) * np.cos(W * T), np.sin(tilt) * np.sin(W * T), np.cos(tilt)]
    steps, errors = np.array([4e-3, 2e-3, 1e-3]), []
    for h in steps:
        built = throw(at_rest(floating((top,), environment=AIR)), spin=R.T @ w)
        axes = run(built, T, dt_out=T, time_step=h, tolerance=1e-9)["body_axes"][-1, 0]
        errors.append(np.abs(axes[:, 2] - expected).max())
    assert rate(steps, errors) == SECOND
    assert errors[-1] < 0.02


def test_heavy_top_with_spin():
    """It spins at 50 rad/s: 0.05 rad a step at the least one."""
    check_top(True)


def test_a_top_with_the_inertia_about_its_centre_fails():
    must_fail(check_top, False)


def check_ideal_fluid(munk: float) -> None:
    """Energy, impulse and moment of impulse about the origin, with or without the part of the velocity in the last."""
    added = np.array([0.2, 1.0, 2.0])
    model = floating(
        (body(volume=0.1, added_mass=(*added, 0.0, 0.0, 0.0)),), environment={"gravity": 0.0, "water_depth": 300.0}
    )
    mass = np.diag(100.0 + 1025.0 * 0.1 * added)
    steps, errors = np.array([0.02, 0.01, 0.005]), []
    for h in steps:
        built = throw(at_rest(model), (2.0, 1.0, -0.5), (0.3, 1.0, 2.0))
        block = run(built, 3.0, dt_out=0.5, time_step=h, tolerance=1e-9)
        R, u, w = block["body_axes"][:, 0], block["body_velocity"][:, 0, :3], block["body_velocity"][:, 0, 3:]
        P = np.einsum("nij,nj->ni", world(R, mass), u)
        H = np.einsum("nij,nj->ni", world(R, np.diag(INERTIA)), w)
        moment = H + munk * np.cross(block["body_position"][:, 0] - [0.0, 0.0, -50.0], P)
        energy = 0.5 * np.einsum("ni,ni->n", P, u) + 0.5 * np.einsum("ni,ni->n", H, w)
        P0, H0 = np.diag(mass) * [2.0, 1.0, -0.5], INERTIA * [0.3, 1.0, 2.0]
        E0 = 0.5 * P0 @ [2.0, 1.0, -0.5] + 0.5 * H0 @ [0.3, 1.0, 2.0]
        errors.append(
            [
                np.abs(P - P0).max() / np.linalg.norm(P0),
                np.abs(moment - H0).max() / np.linalg.norm(H0),
                np.abs(energy / E0 - 1.0).max(),
            ]
        )
    for k in range(3):
        assert rate(steps, np.array(errors)[:, k]) == SECOND
    assert np.max(errors[-1]) < 5e-3


def test_ideal_fluid_keeps_energy_and_impulses():
    check_ideal_fluid(1.0)


def test_angular_momentum_alone_is_not_kept_in_a_fluid():
    must_fail(check_ideal_fluid, 0.0)


def check_order(extrinsic: bool) -> None:
    roll, pitch, yaw = 0.3, -0.5, 0.8
    cx, cy, cz, sx, sy, sz = *np.cos([roll, pitch, yaw]), *np.sin([roll, pitch, yaw])
    X = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    Y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    Z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    expected = Z @ Y @ X if extrinsic else X @ Y @ Z
    turned = body(rotation=(roll, pitch, yaw))
    arm = rod(1, "fixed", (1.0, 2.0, 3.0), (1.0, 2.0, 4.0), body=1)
    block = run(at_rest(floating((turned,), (arm,), environment=VACUUM)), 0.1, dt_out=0.1)
    assert np.abs(block["body_axes"][0, 0] - expected).max() < 1e-12
    assert np.abs(block["rod_position"][0, 0, 0] - (expected @ [1.0, 2.0, 3.0] + [0.0, 0.0, -50.0])).max() < 1e-12
    assert block["body_rotation"][0, 0] == pytest.approx([roll, pitch, yaw], abs=1e-12)


def test_rotations_are_intrinsic_roll_pitch_yaw():
    check_order(False)


def test_the_other_order_is_not_it():
    must_fail(check_order, True)
