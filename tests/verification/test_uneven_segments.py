"""A cantilever of uneven segments and of two stiffnesses: right, and of second order.

Verifies: bending

A load P at the tip that bends it by little: with x from the tip, EI1 over the inner part and EI2 over the outer l2,

    deflection = P (L^3 - l2^3) / 3 EI1 + P l2^3 / 3 EI2.

A hinge between unequal halves turns by M (h1 / 2 EI1 + h2 / 2 EI2), so that on a grid the deflection is a sum, which must be
met within 2e-6 (the load bends by less than 1e-3 of the length, the next term is the square); and the sum converges to the
formula at a rate within 0.1 of 2 when all segments are halved. Hinges with the mean of the two stiffnesses, as one would
have them without thinking, must not fit.
"""

from __future__ import annotations

import numpy as np
import pytest
from cables import beam, cantilever, deflection, sections
from common import must_fail, rate
from moorings import statics

LENGTH, INNER, FORCE = 10.0, 6.0, 0.1
CASES = {  # EI of the inner and the outer part, segments, gradings
    "graded": (1e4, 1e4, (9, 6), (6.0, 0.25)),
    "joint": (1e4, 2e3, (6, 4), (1.0, 1.0)),
    "joint of unequal segments": (1e4, 2e3, (4, 7), (1.0, 1.0)),
    "graded towards a joint": (4e3, 2e4, (8, 5), (0.2, 5.0)),
}


def grid(case: str, halvings: int) -> tuple[np.ndarray, np.ndarray]:
    """Lengths and stiffnesses of the segments; halving keeps the ratio of neighbours' ends, so grading's root is taken."""
    stiff, soft, segments, gradings = CASES[case]
    lengths, EI = [], []
    for length, n, ratio, value in zip((INNER, LENGTH - INNER), segments, gradings, (stiff, soft), strict=True):
        part = ratio ** (np.arange(n * 2**halvings) / (n * 2**halvings - 1.0))
        lengths.append(length * part / part.sum())
        EI.append(np.full(len(part), value))
    return np.concatenate(lengths), np.concatenate(EI)


def found(case: str, halvings: int) -> float:
    """Deflection of the tip over the force, m/N."""
    stiff, soft, segments, gradings = CASES[case]
    parts = sections(
        ("inner", INNER, segments[0] * 2**halvings, gradings[0]),
        ("outer", LENGTH - INNER, segments[1] * 2**halvings, gradings[1]),
    )
    built = statics(cantilever((beam(stiff, "inner"), beam(soft, "outer")), parts, (0.0, 0.0, -FORCE)), tolerance=1e-7)
    return deflection(built) / FORCE


def summed(case: str, halvings: int, series: bool = True) -> float:
    """The same from the hinges: series of the halves, or by the mean of their stiffnesses."""
    h, EI = grid(case, halvings)
    arm = LENGTH - np.concatenate([[0.0], np.cumsum(h)])[:-1]  # of the force about the nodes
    first = h[0] / (2.0 * EI[0])
    inner = (h[:-1] / EI[:-1] + h[1:] / EI[1:]) / 2.0 if series else (h[:-1] + h[1:]) / (EI[:-1] + EI[1:])
    return float(np.sum(arm**2 * np.concatenate([[first], inner])))


def exact(case: str) -> float:
    stiff, soft, *_ = CASES[case]
    outer = LENGTH - INNER
    return (LENGTH**3 - outer**3) / (3.0 * stiff) + outer**3 / (3.0 * soft)


def check(case: str, series: bool = True) -> None:
    for halvings in range(3):
        assert found(case, halvings) == pytest.approx(summed(case, halvings, series), rel=2e-6)


@pytest.mark.parametrize("case", CASES)
def test_deflection_on_a_grid(case):
    check(case)


@pytest.mark.parametrize("case", CASES)
def test_second_order(case):
    errors = [abs(found(case, k) / exact(case) - 1.0) for k in range(3)]
    assert abs(rate(0.5 ** np.arange(3), errors) - 2.0) < 0.1, f"{errors}"


def test_mean_stiffness_fails():
    must_fail(check, "joint", series=False)
