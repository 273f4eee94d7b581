"""Natural frequencies of a clamped-free and a simply supported beam on 40 segments.

Verifies: bending, morison

    omega = (b L)^2 / L^2 sqrt(EI / m),   b L = 1.875104, 4.694091, 7.854757 (clamped-free), pi, 2 pi, 3 pi (supported)

b L of the first are the roots of cos(x) cosh(x) = -1. From the assembled stiffness and mass of the straight beam at rest:
the first two modes within 0.5 %, the third within 0.7 %, errors falling at a rate within 0.1 of 2. The lumped masses
and hinges are those of a difference scheme: on hinged ends its frequencies are known exactly (test_beam.py). A clamp
left out (a pin lets the beam turn freely) and 2 % more EI must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from cables import VACUUM, beam, cantilever, sections
from common import must_fail, rate
from dense import modes
from moorings import fixed, single
from scipy.optimize import brentq

from moorage.solve.statics import rest
from moorage.system.build import build

LENGTH, EI, MASS = 10.0, 1e5, 20.0
ROOTS = {"clamped": np.array([1.875104, 4.694091, 7.854757]), "supported": np.pi * np.arange(1, 4)}
ALLOWED = np.array([0.005, 0.005, 0.007])


def frequencies(case: str, segments: int, stiffness: float = EI) -> np.ndarray:
    """The three lowest frequencies across the beam, over sqrt(EI / m) / L^2 of the stated one."""
    cable = beam(stiffness, mass_per_length=MASS, axial_stiffness=1e9)
    if case == "clamped":
        model = cantilever(cable, sections(("beam", LENGTH, segments)), (0.0, 0.0, 0.0))
    elif case == "supported":
        model = single(cable, LENGTH, segments, fixed(1, 0.0, 0.0, 0.0), fixed(2, LENGTH, 0.0, 0.0), **VACUUM)
    else:
        model = cantilever(cable, sections(("beam", LENGTH, segments)), (0.0, 0.0, 0.0), end_a_stiffness=0.0)
    built = build(model)
    rest(built)
    n = built.names.node_ptr[1]
    built.state.position[:n] = np.linspace(0.0, LENGTH, n)[:, None] * [1.0, 0.0, 0.0]
    return modes(built)[0][:6:2] / np.sqrt(EI / MASS) * LENGTH**2


def check(case: str, against: str, **wrong) -> None:
    exact = ROOTS[against] ** 2
    assert (np.abs(frequencies(case, 40, **wrong) / exact - 1.0) < ALLOWED).all()


@pytest.mark.parametrize("case", ROOTS)
def test_forty_segments(case):
    check(case, case)


@pytest.mark.parametrize("case", ROOTS)
def test_second_order(case):
    grids = np.array([20, 40, 80])
    errors = np.array([frequencies(case, int(n)) for n in grids]) / ROOTS[case] ** 2 - 1.0
    for column in np.abs(errors).T:
        assert abs(rate(1.0 / grids, column) - 2.0) < 0.1, f"{errors}"


def test_roots_of_the_table():
    for root in ROOTS["clamped"]:
        exact = brentq(lambda x: np.cos(x) + 1.0 / np.cosh(x), root - 0.1, root + 0.1)
        assert root == pytest.approx(exact, abs=6e-7)


def test_pin_in_place_of_the_clamp_fails():
    must_fail(check, "pinned", "clamped")


def test_stiffer_beam_fails():
    must_fail(check, "clamped", "clamped", stiffness=1.02 * EI)
