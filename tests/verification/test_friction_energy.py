"""Friction takes energy: a sliding line stops where its energy ends, a closed way gains nothing, and nothing creeps.

Verifies: friction, bathymetry, contact

Stop. A short line slides with v0 down a plane of 10 degrees, with mu > tan(10 deg), or up it, along itself or across.
The spring of friction first gives way by x = mu N / k_s, with half the force. With M its mass and added mass and
N = w cos(10 deg), all for a metre, it stops after s where

    M v0^2 / 2 + w s sin(10 deg) = mu N (s - x / 2)        (down; - w s sin upwards)

to 5e-5 of s (steps of 2 ms, of which the spring takes 20 to give way; measured: 5e-6). 1 % more friction fails.

Closed way. A rope on the bed is led round closed ways by its ends, which lift and press its nodes. From turn to turn
everything comes back, so that what the ends pay in a turn is what friction takes, to 1e-3 (measured: 1.1e-4 at most), and
what the result calls dissipated is that, to 1e-3 (measured: 4e-5). Damping of the bed and of the rope is off. 1 % more fails.

Creep. A chain of 100 m lies on the slope, is pulled down by 2 cm at its lower end, and is held there for an hour: after
the first minute no node moves by more than 1 mm (measured: 2 um by both laws; without damping of its springs, elastic slip
swings by 0.06 mm), and the pull stays within 0.5 %. MoorDyn's law fails.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import DENSITY, at_rest, coupled, free, kind, run, single, weight_in_water

from moorage.model import Bathymetry, Friction, Motion

SLOPE, DEPTH, STIFFNESS = np.deg2rad(10.0), 100.0, 3e6
DOWN = np.array([np.cos(SLOPE), 0.0, -np.sin(SLOPE)])
NORMAL = np.array([np.sin(SLOPE), 0.0, np.cos(SLOPE)])
X = (-500.0, 500.0)
PLANE = Bathymetry(X, X, tuple((DEPTH + x * np.tan(SLOPE),) * 2 for x in X))
SPEED, SHEAR = 2.0, 1e4
ROPE = kind(diameter=0.1, mass_per_length=40.0, tangential_added_mass=0.3, transverse_added_mass=0.3)
W = weight_in_water(ROPE)
MASS = 40.0 + 0.3 * DENSITY * np.pi / 4.0 * 0.1**2


def sunk(weight: float, diameter: float) -> np.ndarray:
    """Return where the bed at x = 0 carries a weight (N/m)."""
    return np.array([0.0, 0.0, -DEPTH]) - weight * np.cos(SLOPE) / (STIFFNESS * diameter) * NORMAL


def way_to_stop(down: bool, across: bool, friction: Friction) -> float:
    """Return how far a line of 2 m comes that starts with 2 m/s, m."""
    begin, along = sunk(W, 0.1), np.array([0.0, 1.0, 0.0]) if across else DOWN
    ends = free(1, *(begin - along)), free(2, *(begin + along))
    model = single(
        ROPE, 2.0, 2, *ends, water_depth=DEPTH, seabed_stiffness=STIFFNESS, bathymetry=PLANE, friction=friction
    )
    built = at_rest(model)
    built.state.position[:3] = built.state.stuck[:3] = np.linspace(begin - along, begin + along, 3)
    heading = DOWN if down else -DOWN
    built.state.velocity[:] = SPEED * heading
    path = run(built, 4.0, dt_nodes=0.01, time_step=0.002, tolerance=1e-9)["node_position"][:, 1]
    return float(((path - path[0]) @ heading).max())


def check_stop(down: bool, across: bool, mu: float = 0.3) -> None:
    friction = Friction(axial=0.3, transverse=0.3, shear_stiffness=SHEAR, shear_damping=0.0)
    rub, slide = mu * W * np.cos(SLOPE), W * np.sin(SLOPE) * (1.0 if down else -1.0)
    expected = (0.5 * MASS * SPEED**2 + 0.5 * rub**2 / (SHEAR * 0.1)) / (rub - slide)
    assert way_to_stop(down, across, friction) == pytest.approx(expected, rel=5e-5)


@pytest.mark.parametrize("across", [False, True], ids=["along", "across"])
@pytest.mark.parametrize("down", [True, False], ids=["down", "up"])
def test_line_stops_where_its_energy_ends(down, across):
    check_stop(down, across)


@pytest.mark.parametrize("down", [True, False], ids=["down", "up"])
def test_damped_spring_stops_it_too(down):
    """Stick-slip's damper gives all of the friction at once; at the end the spring takes over within x = mu N / k_s."""
    friction = Friction(axial=0.3, transverse=0.3, shear_stiffness=SHEAR, model="stick-slip")
    rub, slide = 0.3 * W * np.cos(SLOPE), W * np.sin(SLOPE) * (1.0 if down else -1.0)
    expected = 0.5 * MASS * SPEED**2 / (rub - slide)
    assert -1e-3 * expected < way_to_stop(down, False, friction) - expected < rub / (SHEAR * 0.1)


def test_more_friction_fails():
    must_fail(check_stop, True, False, 0.303)


TURN = 8.0  # s
SOFT = kind(diameter=0.1, mass_per_length=40.0, axial_stiffness=1e5)


def turn(friction: Friction) -> tuple[float, float, float]:
    """Return what the ends pay in the third turn, what friction takes, and what the result says of that, J."""
    level = -DEPTH - W / (STIFFNESS * 0.1)
    time = np.arange(0.0, 3.0 * TURN + 0.5, 0.1)
    angle, grow = 2.0 * np.pi * time / TURN, np.minimum(time / TURN, 1.0) ** 2
    circle = np.stack([np.sin(angle), 1.0 - np.cos(angle), 0.02 * np.sin(2.0 * angle)], axis=1) * grow[:, None]
    other = np.stack([np.sin(2.0 * angle), np.sin(angle), 0.02 * np.sin(3.0 * angle)], axis=1) * grow[:, None]
    a, b = np.array([0.0, 0.0, level]), np.array([10.0, 0.0, level])
    model = single(
        SOFT, 10.0, 5, coupled(1, *a), coupled(2, *b), water_depth=DEPTH, seabed_stiffness=STIFFNESS, seabed_damping=0.0,
        friction=friction,
    )  # fmt: skip
    built = at_rest(model, Motion.from_points(time, {1: a + circle, 2: b + other}))
    block = run(built, 3.0 * TURN, dt_out=0.005, dt_nodes=0.005, time_step=0.0025, tolerance=1e-8)
    third = block["time"] >= 2.0 * TURN
    power = -(block["end_force"][:, 0] * block["point_velocity"]).sum(axis=(1, 2))
    rub = -(block["friction_force"] * block["node_velocity"]).sum(axis=(1, 2))
    paid, taken = (float(np.trapezoid(p[third], block["time"][third])) for p in (power, rub))
    return paid, taken, float(np.ptp(block["dissipated_energy"][third]))


def check_turn(model: str, wrong: float = 1.0) -> None:
    paid, taken, told = turn(Friction(axial=0.5, transverse=0.7, model=model, damping=1e4, velocity=0.05))
    assert paid > 1e4
    assert wrong * paid == pytest.approx(taken, rel=1e-3)
    assert told == pytest.approx(taken, rel=1e-3)


@pytest.mark.parametrize("model", ["elastic-slip", "stick-slip", "saturated-damping", "velocity-dependent"])
def test_nothing_is_gained_on_a_closed_way(model):
    check_turn(model)


def test_other_energy_fails():
    must_fail(check_turn, "elastic-slip", 1.01)


CHAIN = kind(diameter=0.1, mass_per_length=100.0, axial_stiffness=2e7, axial_damping_ratio=1.0, tangential_drag=0.4)


def check_holds(friction: Friction) -> None:
    begin = sunk(weight_in_water(CHAIN), 0.1)
    a, b = begin - 50.0 * DOWN, begin + 50.0 * DOWN
    model = single(
        CHAIN, 100.0, 20, free(1, *a), coupled(2, *b), water_depth=DEPTH, seabed_stiffness=STIFFNESS, bathymetry=PLANE,
        friction=friction,
    )  # fmt: skip
    time = np.arange(0.0, 3700.0, 1.0)
    part = np.clip(time / 20.0, 0.0, 1.0)
    pulled = b + 0.02 * (part**2 * (3.0 - 2.0 * part))[:, None] * DOWN
    built = at_rest(model, Motion.from_points(time, {2: pulled}))
    built.state.position[:21] = built.state.stuck[:21] = np.linspace(a, b, 21)
    block = run(built, 3660.0, dt_out=20.0, dt_nodes=20.0)
    late = block["node_position"][3:]
    pull = np.linalg.norm(block["end_force"][3:, 0, 1], axis=1)
    assert pull[0] > 8e3
    assert np.ptp(late, axis=0).max() < 1e-3
    assert np.ptp(pull) < 5e-3 * pull[0]


@pytest.mark.parametrize("model", ["elastic-slip", "stick-slip"])
def test_loaded_chain_does_not_creep(model):
    check_holds(Friction(axial=0.4, transverse=0.4, model=model))


def test_saturated_damping_fails():
    must_fail(check_holds, Friction(axial=0.4, transverse=0.4, model="saturated-damping", damping=1e6))
