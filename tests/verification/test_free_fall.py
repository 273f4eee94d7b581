"""Free fall through water: v(t) = v_t tanh(t g' / v_t), with v_t from the balance of drag and weight.

Verifies: morison, weight, point

m_a dv/dt = W - D v^2 with m_a = mass and added mass, W = weight in water, has that solution with v_t = sqrt(W / D),
g' = W / m_a. Three bodies without any force between their parts: a line that falls broadside (0.5 rho Cdn d l), one
that falls along itself (0.5 rho Cdt pi d l), and a sphere (a free point with mass, volume, CdA and Ca). The step's
error must be of second order, within 0.1, relative to v_t below 3e-5 at a step of a fiftieth of v_t / g', and after
10 v_t / g' the speed be v_t to 1e-7. RK4 must give it to 1e-8. Water that is 1 % too heavy, or a tenth of added mass
forgotten, must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from moorings import DENSITY, GRAVITY, at_rest, fixed, free, kind, line, mooring, run, single

ROPE = kind(
    diameter=0.1, mass_per_length=30.0, transverse_drag=1.1, tangential_drag=0.3, transverse_added_mass=1.0,
    tangential_added_mass=0.5,
)  # fmt: skip
BUOYANT_MASS = DENSITY * np.pi / 4.0 * 0.1**2


def broadside(**water):
    built = at_rest(single(ROPE, 20.0, 6, free(1, 0.0, 0.0, -10.0), free(2, 20.0, 0.0, -10.0), **water))
    built.state.position[:7] = np.linspace([0.0, 0.0, -10.0], [20.0, 0.0, -10.0], 7)  # not on its first catenary
    mass, drag = 30.0 + BUOYANT_MASS, 0.5 * DENSITY * 1.1 * 0.1
    return built, mass, GRAVITY * (30.0 - BUOYANT_MASS), drag


def along(**water):
    built = at_rest(single(ROPE, 20.0, 6, free(1, 0.0, 0.0, -50.0), free(2, 0.0, 0.0, -30.0), **water))
    mass, drag = 30.0 + 0.5 * BUOYANT_MASS, 0.5 * DENSITY * 0.3 * np.pi * 0.1
    return built, mass, GRAVITY * (30.0 - BUOYANT_MASS), drag


def sphere(**water):
    held = fixed(1, 0.0, 0.0, -5.0), fixed(2, 9.0, 0.0, -5.0)
    ball = free(3, 50.0, 0.0, -10.0, mass=900.0, volume=0.4, drag_area=0.3, added_mass=0.5)
    built = at_rest(mooring(ROPE, (*held, ball), (line(1, 1, 2, ("rope", 10.0, 2)),), **water))
    return built, 900.0 + 0.5 * 0.4 * DENSITY, GRAVITY * (900.0 - 0.4 * DENSITY), 0.5 * DENSITY * 0.3


def error(case, steps: int, method: str = "implicit", **water) -> tuple[float, float]:
    """Largest error of the speed, and its last value, relative to the terminal speed."""
    built, mass, weight, drag = case(**water)
    terminal, scale = np.sqrt(weight / drag), mass / np.sqrt(weight * drag)
    block = run(built, 10.0 * scale, time_step=scale / steps, dt_out=scale / 5.0, method=method, tolerance=1e-10)
    falls = [k for k, velocity in enumerate(block["point_velocity"][-1]) if velocity[2] != 0.0]
    speed = -block["point_velocity"][:, falls, 2] / terminal
    exact = np.tanh(block["time"] / scale)[:, None]
    return np.abs(speed - exact).max(), np.abs(speed[-1] / np.tanh(10.0) - 1.0).max()


def check(case, **water) -> None:
    steps = np.array([25, 50, 100])
    found = np.array([error(case, n, **water) for n in steps])
    assert abs(rate(1.0 / steps, found[:, 0]) - 2.0) < 0.1, f"{found}"
    assert found[1, 0] < 3e-5, f"{found}"
    assert found[:, 1].max() < 1e-7, f"{found}"


CASES = {"line broadside": broadside, "line along itself": along, "sphere": sphere}


@pytest.mark.parametrize("name", CASES)
def test_implicit(name):
    check(CASES[name])


@pytest.mark.parametrize("name", CASES)
def test_rk4(name):
    largest, last = error(CASES[name], 50, "rk4")
    assert largest < 1e-8
    assert last < 1e-8


@pytest.mark.parametrize("name", CASES)
def test_wrong_water_fails(name):
    must_fail(check, CASES[name], water_density=1.01 * DENSITY)
