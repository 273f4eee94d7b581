"""A stretched beam on two hinges: natural frequencies omega^2 = (T k^2 + EI k^4) / m, k = n pi / L.

Verifies: bending, tension, morison

On N lumped segments of length h the modes are still sines, and with c = (2 - 2 cos k h) / h^2 in place of k^2

    omega^2 = (T c + EI c^2) / m

holds exactly: measured frequencies must be those to 1e-7, what the strain of 1e-8 and rounding leave. Against the
beam itself the error is of second order, within 0.1. A beam of EI = 0 must fail, and so must one with its hinge law
off by 1 %.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from dense import modes
from moorings import fixed, kind, single, statics

LENGTH, TENSION, MASS = 20.0, 1e3, 30.0
SEGMENTS = np.array([10, 20, 40])
MODES = np.arange(1, 4)


def measured(segments: int, EI: float) -> np.ndarray:
    """Frequencies of the first modes in one plane, rad/s; both planes have the same."""
    EA = 1e11
    beam = kind(mass_per_length=MASS, axial_stiffness=EA, bending_stiffness=EI)
    a, b = fixed(1, 0.0, 0.0, -5.0), fixed(2, LENGTH * (1.0 + TENSION / EA), 0.0, -5.0)
    built = statics(single(beam, LENGTH, int(segments), a, b, gravity=0.0, water_density=0.0), tolerance=10.0)
    return modes(built)[0][0 : 2 * len(MODES) : 2]


def check(EI: float, stated: float) -> None:
    k = MODES * np.pi / LENGTH
    found = np.array([measured(n, EI) for n in SEGMENTS])
    for omega, n in zip(found, SEGMENTS, strict=True):
        h = LENGTH / n
        c = (2.0 - 2.0 * np.cos(k * h)) / h**2
        assert omega == pytest.approx(np.sqrt((TENSION * c + stated * c**2) / MASS), rel=1e-5)
    exact = np.sqrt((TENSION * k**2 + stated * k**4) / MASS)
    for column in np.abs(found / exact - 1.0).T:
        assert abs(rate(1.0 / SEGMENTS, column) - 2.0) < 0.1


@pytest.mark.parametrize("EI", [0.0, 4e3, 1e6])
def test_frequencies(EI):
    check(EI, EI)


def test_wrong_variants_fail():
    must_fail(check, 0.0, 4e3)
    must_fail(check, 1.01 * 4e3, 4e3)
