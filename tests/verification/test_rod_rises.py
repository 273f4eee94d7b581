"""Rods and bodies that rise, fall, turn and drift against the water.

Verifies: rigid, morison

From rest under a steady force F with the mass and added mass M and the drag k v^2,

    v = U tanh(t / T),   z = U T ln cosh(t / T),   U^2 = F / k,   T = M / (k U).

* Rod across its way: M = (m + Ca rho A) L, k = rho Cd d L / 2. Along it: the half spheres at its ends add
  rho CaEnd pi d^3 / 12 each, and their faces drag with rho CdEnd pi d^2 / 8 each.
* A tilted body falls in the direction u in which |u| R D R^T u = F, D = rho CdA / 2; one that spins about an axis slows
  down as 1 / (1 + k w0 t / J), J with the added inertia rho V Ca.
* Linear damping c of an external load: v = (F / c)(1 - exp(-c t / m)), in the body's axes if it is local.

To the second order of the step; a rate of 2 within 0.15 is asserted.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from floats import AIR, VACUUM, WATER, body, floating, rod, throw
from moorings import DENSITY, GRAVITY, at_rest, run

from moorage.model import ExternalLoad, RodType
from moorage.model.motion import rotation_matrices

BUOYANT = RodType(
    name="spar", diameter=0.4, mass_per_length=50.0, transverse_drag=1.1, transverse_added_mass=0.9, end_drag=0.8,
    end_added_mass=0.7,
)  # fmt: skip
LENGTH, AREA = 6.0, np.pi / 4.0 * 0.4**2
SECOND = pytest.approx(2.0, abs=0.15)


def check_rise(along, M: float, k: float) -> None:
    """A rod at 100 m depth in the direction `along`, for 4 s."""
    F, T = (DENSITY * AREA - 50.0) * LENGTH * GRAVITY, 4.0
    U = np.sqrt(F / k)
    tau = M / (k * U)
    expected = U * tau * np.log(np.cosh(T / tau))
    end = np.array([0.0, 0.0, -100.0]) + LENGTH * np.array(along)
    model = floating(rods=(rod(1, "free", (0.0, 0.0, -100.0), end, 3),), types=BUOYANT)
    steps, errors = np.array([0.08, 0.04, 0.02]), []
    for h in steps:
        block = run(at_rest(model), T, dt_out=0.1, time_step=h, tolerance=1e-8)
        errors.append(abs(block["rod_position"][-1, 0, 0, 2] + 100.0 - expected))
    assert block["rod_velocity"][-1, 0, 2] == pytest.approx(U * np.tanh(T / tau), rel=1e-3)
    assert block["rod_acceleration"][0, 0, 2] == pytest.approx(F / M, rel=1e-9)
    assert rate(steps, errors) == SECOND
    assert errors[-1] < 2e-3


MASS, ADDED = 50.0 * LENGTH, 0.9 * DENSITY * AREA * LENGTH
ENDS = 2.0 * 0.7 * DENSITY * np.pi * 0.4**3 / 12.0


def test_rod_rises_across():
    check_rise((1.0, 0.0, 0.0), MASS + ADDED, 0.5 * DENSITY * 1.1 * 0.4 * LENGTH)


def test_rod_rises_along():
    check_rise((0.0, 0.0, 1.0), MASS + ENDS, 0.5 * DENSITY * 2.0 * 0.8 * AREA)


def test_a_rod_without_added_mass_fails():
    must_fail(check_rise, (1.0, 0.0, 0.0), MASS, 0.5 * DENSITY * 1.1 * 0.4 * LENGTH)


DRAG = np.array([0.5, 1.0, 2.0])
ROTATION = (0.4, 0.7, -0.3)


def check_fall(turned: bool) -> None:
    """Terminal velocity of a tilted body whose centre of gravity is where its drag acts."""
    model = floating((body(rotation=ROTATION, drag_area=(*DRAG, 0.0, 0.0, 0.0)),))
    u = run(at_rest(model), 8.0, dt_out=8.0, time_step=0.02, tolerance=1e-7)["body_velocity"][-1, 0, :3]
    R = rotation_matrices(np.array([ROTATION]))[0] if turned else np.eye(3)
    drag = 0.5 * DENSITY * np.linalg.norm(u) * R @ (DRAG * (R.T @ u))
    assert -drag == pytest.approx([0.0, 0.0, 100.0 * GRAVITY], abs=1e-4 * 100.0 * GRAVITY)


def test_terminal_velocity_of_a_tilted_body():
    check_fall(True)


def test_drag_along_the_wrong_axes_fails():
    must_fail(check_fall, False)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_spin_slows_down(axis):
    """At once about one axis: the coefficients of the two others play no part."""
    coefficients = np.array([0.4, 0.7, 1.1])
    drifting = body(volume=0.1, drag_area=(0.0, 0.0, 0.0, *coefficients), added_mass=(0.0, 0.0, 0.0, 0.2, 0.3, 0.5))
    J = [10.0, 20.0, 35.0][axis] + DENSITY * 0.1 * [0.2, 0.3, 0.5][axis]
    w0, T, steps, errors = 2.0, 0.2, np.array([0.02, 0.01, 0.005]), []
    for h in steps:
        spin = np.eye(3)[axis] * w0
        model = floating((drifting,), environment=WATER | {"gravity": 0.0})
        w = run(throw(at_rest(model), spin=spin), T, dt_out=T, time_step=h, tolerance=1e-9)["body_velocity"][-1, 0, 3:]
        errors.append(np.abs(w - spin / (1.0 + 0.5 * DENSITY * coefficients[axis] * w0 * T / J)).max())
    assert rate(steps, errors) == SECOND


def check_load(local: bool) -> None:
    """Given force and linear damping; the axes of the body turned by 90 degrees about z."""
    load = ExternalLoad(
        id=1, target="body", target_id=1, force=(30.0, 0.0, 0.0), linear_damping=(20.0, 90.0, 40.0), local=True
    )
    turned = body(rotation=(0.0, 0.0, 0.5 * np.pi))
    model = floating((turned,), environment=VACUUM, external_loads=(load,))
    v = run(at_rest(model), 2.0, dt_out=2.0, time_step=0.01, tolerance=1e-8)["body_velocity"][-1, 0, :3]
    expected = 1.5 * (1.0 - np.exp(-20.0 * 2.0 / 100.0))
    assert v == pytest.approx([0.0, expected, 0.0] if local else [expected, 0.0, 0.0], abs=1e-4)


def test_external_load_turns_with_the_body():
    check_load(True)


def test_a_load_in_global_axes_is_not_it():
    must_fail(check_load, False)


def test_quadratic_damping_of_a_load():
    """Terminal velocity under weight: m g = q v^2."""
    load = ExternalLoad(id=1, target="body", target_id=1, quadratic_damping=(0.0, 0.0, 200.0))
    model = floating((body(),), environment=AIR, external_loads=(load,))
    v = run(at_rest(model), 4.0, dt_out=4.0, time_step=0.02, tolerance=1e-8)["body_velocity"][-1, 0, :3]
    assert v == pytest.approx([0.0, 0.0, -np.sqrt(100.0 * GRAVITY / 200.0)], abs=1e-5)
