"""Ends held by rotational springs, between a pin and a clamp.

Verifies: bending

A cantilever from a spring k under a load P at its tip turns there by P L / k: with few radians everywhere,

    deflection = P L^3 / 3 EI (1 + 1 / 2 N^2) + P L^2 / k        (N equal segments; a clamp's k is infinite)

and a beam on two hinges that are springs, bent by its own weight w, has the moment w L^2 / 12 / (1 + 2 EI / k L) at its ends.
The first must hold within 1e-5 (the next term is the square of 1e-3 rad), the second to second order in N, its
extrapolation within 1e-4. k = 0 is a pin. A spring of 2 % more must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from cables import at_once, beam, between, cantilever, deflection, sections
from common import must_fail, rate
from moorings import GRAVITY, statics

LENGTH, EI = 10.0, 1e5
SPRINGS = [2e3, 1e4, 1e5, 1e7]


def check(k: float, stated: float | None) -> None:
    for segments in (3, 12):
        parts = sections(("beam", LENGTH, segments))
        built = statics(cantilever(beam(EI), parts, (0.0, 0.0, -0.2), end_a_stiffness=k), tolerance=1e-8)
        soft = 0.0 if stated is None else LENGTH**2 / stated
        expected = 0.2 * (LENGTH**3 / (3.0 * EI) * (1.0 + 0.5 / segments**2) + soft)
        assert deflection(built) == pytest.approx(expected, rel=1e-5)
        # what the rod feels: the load's moment about y
        assert at_once(built)["end_moment"][0, 0, 0] == pytest.approx([0.0, 0.2 * LENGTH, 0.0], rel=1e-5, abs=1e-7)


@pytest.mark.parametrize("k", SPRINGS)
def test_cantilever_from_a_spring(k):
    check(k, k)


def test_no_spring_is_a_clamp():
    check(None, None)


def end_moments(k: float | None, segments: int) -> np.ndarray:
    """About y, of a beam of 10 g/m between two springs, on what holds it, N m."""
    model = between(
        beam(EI, mass_per_length=1e-2), sections(("beam", LENGTH, segments)), (0.0, 0.0, 0.0), (1.0, 0.0, 0.0),
        (LENGTH, 0.0, 0.0), (1.0, 0.0, 0.0), {"gravity": GRAVITY, "water_density": 0.0},
        end_a_stiffness=k, end_b_stiffness=k,
    )  # fmt: skip
    return at_once(statics(model, tolerance=1e-9))["end_moment"][0, 0, :, 1]


@pytest.mark.parametrize("k", [*SPRINGS, None])
def test_beam_on_springs(k):
    grids = np.array([8, 16, 32])
    found = np.array([end_moments(k, int(n)) for n in grids])
    assert found[:, 0] == pytest.approx(-found[:, 1], rel=1e-5)
    soft = 0.0 if k is None else 2.0 * EI / (k * LENGTH)
    exact = 1e-2 * GRAVITY * LENGTH**2 / 12.0 / (1.0 + soft)
    assert found[-1, 0] + (found[-1, 0] - found[-2, 0]) / 3.0 == pytest.approx(exact, rel=1e-4)
    assert abs(rate(1.0 / grids, np.abs(found[:, 0] - exact)) - 2.0) < 0.1


def test_a_spring_of_nothing_is_a_pin():
    assert np.abs(end_moments(0.0, 8)).max() == 0.0


def test_stiffer_spring_fails():
    must_fail(check, 1e4, 1.02e4)
