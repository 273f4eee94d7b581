"""A table of moment against curvature: two straight lines against the beam's integral, one line against EI.

Verifies: bending, table

EI1 up to the moment M1, and EI2 for what exceeds it. A load P at the tip of a cantilever, x from there, x1 = M1 / P:

    deflection = P L^3 / 3 EI1 + (1 / EI2 - 1 / EI1) [P (L^3 - x1^3) / 3 - M1 (L^2 - x1^2) / 2]

The corner lies within a segment, at other places on other grids: the error is bounded by that of the worst place,
twice P L h^2 / 4 (1 / EI2 - 1 / EI1), more than the hinge sum's own L^2 P h^2 / 6 EI2. It must lie within that, and fall by
more than 2^1.5 for each halving on average. On a grid, hinges turn by curvature(M) h: that sum must be met within
2e-5. A table of one line is a constant EI, to 1e-9 of the length. M1 5 % higher must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import beam, bending_moments, cantilever, curvatures, deflection, sections
from common import must_fail, rate
from moorings import curve, nodes, statics

LENGTH, STIFF, SOFT, FORCE, KINK = 10.0, 1e3, 2e2, 0.025, 0.15  # m, N m2, N m2, N, N m
SEGMENTS = np.array([10, 20, 40, 80])


def table(moment: float = KINK):
    k = moment / STIFF
    return curve((0.0, 0.0), (k, moment), (k + moment / SOFT, 2.0 * moment))


def solved(EI, segments: int, force: float = FORCE):
    return statics(cantilever(beam(EI), sections(("beam", LENGTH, segments)), (0.0, 0.0, -force)), tolerance=1e-8)


def curvature(moment):
    return moment / STIFF + np.maximum(moment - KINK, 0.0) * (1.0 / SOFT - 1.0 / STIFF)


def check(moment: float = KINK) -> None:
    for n in SEGMENTS:
        x = LENGTH * np.arange(n, -1, -1) / n
        turn = curvature(FORCE * x) * LENGTH / n
        turn[0] *= 0.5
        assert deflection(solved(table(moment), int(n))) == pytest.approx(np.sum(turn * x), rel=2e-5)


def test_on_a_grid():
    check()


def test_against_the_integral():
    x1 = KINK / FORCE
    more = FORCE * (LENGTH**3 - x1**3) / 3.0 - KINK * (LENGTH**2 - x1**2) / 2.0
    exact = FORCE * LENGTH**3 / (3.0 * STIFF) + (1.0 / SOFT - 1.0 / STIFF) * more
    errors = np.array([abs(deflection(solved(table(), int(n))) - exact) for n in SEGMENTS])
    assert (errors < FORCE * LENGTH * (LENGTH / SEGMENTS) ** 2 / SOFT).all()
    assert rate(1.0 / SEGMENTS, errors) > 1.5


def test_recorded_curvature_belongs_to_the_moment():
    built = solved(table(), 20)
    moments = bending_moments(built)
    assert moments[:-1] == pytest.approx(FORCE * LENGTH * (1.0 - np.arange(20) / 20.0), rel=1e-4)
    assert curvatures(built)[1:] == pytest.approx(curvature(moments)[1:], rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("flavour", ["native", "MoorDyn-C"])
def test_one_line_is_a_constant(flavour):
    """Bent far: 10 N turn the tip by more than 30 degrees. By the paper's rule a table's clamp is still the exact one."""
    constant = nodes(solved(STIFF, 20, 10.0))
    model = cantilever(beam(curve((0.0, 0.0), (1.0, STIFF))), sections(("beam", LENGTH, 20)), (0.0, 0.0, -10.0))
    found = nodes(statics(dataclasses.replace(model, flavour=flavour), tolerance=1e-8))
    assert np.abs(found - constant).max() < 1e-9 * LENGTH if flavour == "native" else 1e-3 * LENGTH
    assert constant[-1, 2] < -2.5


def test_other_kink_fails():
    must_fail(check, 1.05 * KINK)
