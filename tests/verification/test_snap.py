"""Snap loads: a line that goes slack and is jerked taut, converging with the tolerance of the adaptive step.

Verifies: tension, morison, motion

A taut-moored rope is moved at its top by 3 m in 7 s, so that it falls slack and snaps to several times its static
tension. The adaptive run, at tolerances from 20 mm to 0.2 mm, is compared with a fixed step of 0.5 ms on the same
grid of segments, which is itself compared with 1 ms. The local error of a step is of third order and the tolerance
bounds h^2 |da|, of the same order: the step goes with the third root of the tolerance, the global error of second
order with its power 2/3. Snaps start when a segment becomes taut, between step ends, so that a power of at least 0.4
is asked for the rms error over the largest and smallest tolerance; errors must be below

    tolerance      rms / rms tension    highest peak
    2 mm           1 %                  1 %           (the default)
    0.2 mm         0.2 %                0.5 %

A rope 5 % stiffer must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate, rms
from moorings import coupled, fixed, kind, run, single, statics

from moorage.model import Motion

ROPE = kind(
    diameter=0.15, mass_per_length=18.5, axial_stiffness=1.5e7, axial_damping_ratio=0.3, transverse_drag=1.2,
    tangential_drag=0.05, transverse_added_mass=1.0,
)  # fmt: skip
DURATION = 35.0
MOTION = Motion.from_harmonics(DURATION + 1.0, ramp=10.0, interval=0.1, surge=(3.0, 7.0), heave=(1.0, 5.0))
TOLERANCES = (2e-2, 6e-3, 2e-3, 6e-4, 2e-4)


def taut(stiffer: float = 1.0):
    rope = kind(**{**vars(ROPE), "axial_stiffness": stiffer * 1.5e7})
    return statics(single(rope, 149.0, 20, fixed(1, -120.0, 0.0, -100.0), coupled(2, 0.0, 0.0, -10.0)), MOTION)


def tension(built, **settings) -> np.ndarray:
    return run(built, DURATION, dt_out=0.025, **settings)["end_tension"][:, 0, 1]


@pytest.fixture(scope="module")
def start():
    return taut()


@pytest.fixture(scope="module")
def reference(start):
    return tension(start, time_step=5e-4, tolerance=1e-5)


def errors(built, reference) -> np.ndarray:
    """Rms error and error of the highest peak, relative, of each tolerance."""
    found = []
    for tolerance in TOLERANCES:
        T = tension(built, tolerance=tolerance)
        found.append((rms(T - reference) / rms(reference), abs(T.max() / reference.max() - 1.0)))
    return np.array(found)


def check(built, reference) -> None:
    found = errors(built, reference)
    assert rate(TOLERANCES, found[:, 0]) > 0.4, f"{found}"
    assert (found[2] < [0.01, 0.01]).all(), f"{found}"
    assert (found[4] < [0.002, 0.005]).all(), f"{found}"


def test_rope_snaps(reference, start):
    """The case is what it claims to be: slack, and peaks of several times the static tension."""
    assert reference.min() < 1e3
    assert reference.max() > 3.0 * reference[0]
    coarser = tension(start, time_step=1e-3, tolerance=1e-5)
    assert rms(coarser - reference) < 1e-3 * rms(reference)


def test_converges_with_the_tolerance(start, reference):
    check(start, reference)


def test_stiffer_rope_fails(reference):
    must_fail(check, taut(1.05), reference)
