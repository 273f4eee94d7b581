"""A chain on an inclined bed slides the same way whichever way the bed falls and however the grid lies under it.

Verifies: bathymetry, contact, friction, weight, morison

A straight chain lies in water on a plane of 10 degrees, without drag. Down and along the chain's own directions (at an
angle b to the way down) Newton's law reads, per metre and with friction mu N, N = w cos(10 deg),

    (m + Ca_i rho A) a_i = w sin(10 deg) d_i - mu N d'_i,   w = g (m - rho A)

with Ca_i of its axial or transverse direction, d the way down and d' the way it slides; for b = 0 and 90 degrees the
latter is d, and a = g (m - rho A) / (m + Ca rho A) (sin(10 deg) - mu cos(10 deg)). For other b the frictionless chain leaves the way
down, for it is lighter along itself. The bilinear grid holds a plane exactly, whether its rows lie with the slope or
cut it: 1 % is asked by the issue; 1e-6 is asked here (the chain stays straight, only
rounding and the tolerance of the solver are left).

Where mu > tan(10 deg) = 0.176 it stays: within twice the friction spring's deflection under its weight, w sin / (k_s d), for
mu = 0.4 > 2 tan so that falling into the spring does not make it slip.

The grid has cells of 50 by 35 m, the chain crosses some of them and slides over others.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import DENSITY, GRAVITY, at_rest, free, kind, run, single

from moorage.model import Bathymetry, Friction

SLOPE, DEPTH, LENGTH, STIFFNESS = np.deg2rad(10.0), 150.0, 100.0, 3e6
CHAIN = kind(
    diameter=0.1, mass_per_length=100.0, axial_stiffness=1e8, axial_damping_ratio=1.0, transverse_added_mass=0.8,
    tangential_added_mass=0.25,
)  # fmt: skip
DISPLACED = DENSITY * np.pi / 4.0 * 0.1**2
WEIGHT = GRAVITY * (100.0 - DISPLACED)
COMPASS = np.deg2rad([0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0])
CUTS = np.deg2rad([17.0, 71.0, 203.0])  # of the grid by the slope


def directions(fall: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Unit vectors down a plane that falls towards a heading, level across it, and normal to it."""
    c, s = np.cos(SLOPE), np.sin(SLOPE)
    x, y = np.cos(fall), np.sin(fall)
    return np.array([c * x, c * y, -s]), np.array([-y, x, 0.0]), np.array([s * x, s * y, c])


def plane(fall: float, smooth: bool) -> Bathymetry:
    x, y = np.linspace(-400.0, 400.0, 17), np.linspace(-350.0, 350.0, 21)
    rise = np.tan(SLOPE) * (np.cos(fall) * x[:, None] + np.sin(fall) * y)
    return Bathymetry(tuple(x), tuple(y), tuple(map(tuple, DEPTH + rise)), smooth=smooth)


def acceleration(fall: float, lie: float, friction: Friction | None = None, smooth: bool = False) -> tuple:
    """Accelerations down and across the slope between 1 and 4 s, m/s2, and the way down, m."""
    down, level, normal = directions(fall)
    along = np.cos(lie) * down + np.sin(lie) * level
    sink = WEIGHT * np.cos(SLOPE) / (STIFFNESS * CHAIN.diameter)
    a = np.array([0.0, 0.0, -DEPTH]) - sink * normal - 0.5 * LENGTH * along
    b = a + LENGTH * along
    model = single(
        CHAIN, LENGTH, 10, free(1, *a), free(2, *b), water_depth=DEPTH, seabed_stiffness=STIFFNESS,
        bathymetry=plane(fall, smooth), friction=friction,
    )  # fmt: skip
    built = at_rest(model)
    built.state.position[:11] = built.state.stuck[:11] = np.linspace(a, b, 11)
    block = run(built, 4.0, dt_out=0.5, time_step=0.05, dt_nodes=0.5, tolerance=1e-8)
    v = block["node_velocity"].mean(axis=1)
    way = (block["node_position"][-1] - np.linspace(a, b, 11)).mean(axis=0)
    dv = (v[-1] - v[1]) / (block["time"][-1] - block["time"][1])
    return float(dv @ down), float(dv @ level), float(way @ down)


def expected(lie: float, mu: float = 0.0, axial: float = 0.25, transverse: float = 0.8) -> np.ndarray:
    """Accelerations down and across the slope in closed form, m/s2; with friction for lie = 0 or 90 degrees only."""
    c, s = np.cos(lie), np.sin(lie)
    pull = WEIGHT * (np.sin(SLOPE) - mu * np.cos(SLOPE))
    a, t = pull * c / (100.0 + axial * DISPLACED), -pull * s / (100.0 + transverse * DISPLACED)
    return np.array([a * c - t * s, a * s + t * c])


def check_free(fall: float, lie: float, smooth: bool = False, **wrong: float) -> None:
    found = acceleration(fall, lie, smooth=smooth)[:2]
    assert found == pytest.approx(expected(lie, **wrong), abs=1e-6)


@pytest.mark.parametrize("lie", [0.0, np.pi / 2.0, np.deg2rad(30.0)], ids=["along", "across", "oblique"])
def test_frictionless_chain_slides_in_all_directions(lie):
    for fall in (*COMPASS, *CUTS):
        check_free(fall, lie)


def test_smooth_bed_of_a_plane_is_that_plane():
    for fall in (0.0, *CUTS):
        check_free(fall, np.deg2rad(30.0), smooth=True)


def test_exchanged_added_masses_fail():
    must_fail(check_free, 0.3, 0.0, axial=0.8, transverse=0.25)
    must_fail(check_free, 0.3, np.deg2rad(30.0), transverse=0.25)


LAWS = ["elastic-slip", "stick-slip", "saturated-damping", "velocity-dependent"]


@pytest.mark.parametrize("law", LAWS)
def test_chain_slides_at_the_difference(law):
    friction = Friction(axial=0.10, transverse=0.15, model=law, damping=1e6)
    for fall in (*COMPASS, *CUTS):
        for lie, mu in ((0.0, 0.10), (np.pi / 2.0, 0.15)):
            down, across, _ = acceleration(fall, lie, friction)
            assert down == pytest.approx(expected(lie, mu)[0], rel=1e-6)
            assert abs(across) < 1e-6 * down


def check_stays(law: str, fall: float, lie: float) -> None:
    way = acceleration(fall, lie, Friction(axial=0.4, transverse=0.4, model=law, damping=200.0))[2]
    assert 0.0 <= way < 2.0 * WEIGHT * np.sin(SLOPE) / (STIFFNESS * CHAIN.diameter)


@pytest.mark.parametrize("law", ["elastic-slip", "stick-slip"])
def test_chain_stays(law):
    for fall in (*COMPASS, *CUTS):
        for lie in (0.0, np.pi / 2.0, 0.7):
            check_stays(law, fall, lie)


def test_default_damper_of_moordyn_does_not_hold_it():
    must_fail(check_stays, "saturated-damping", 0.0, 0.0)
