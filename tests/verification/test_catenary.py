"""Elastic catenaries: statics of lumped masses against the continuous line, of second order in the segment length.

Verifies: tension, weight, contact, catenary

Hanging. A chain of 500 m between points 350 m and 80 m apart, in water, high above the bed, against Irvine's closed
form. Lumping is a midpoint sum of the line's direction, which gives the error of the end tensions with its constant
(`common.Catenary.lumping`). Measured errors must be those: within 1 % from 20 segments on, the size of the next term
being (w h / H)^2 / 24 = 0.2 % there. The rate of the error of the shape must lie within 0.05 of 2.

Grounded. The chain of OC4-DeepCwind, of which a third lies on the bed, against Jonkman's closed form. The bed is 10^4
times stiffer than usual, because a chain sinks w / (k d) = 4.6 mm into the usual one. The touch-down point falls
anywhere within a segment, which makes the constant of the error jump from grid to grid, but predictably: within 20 %,
because that point itself moves by h^2.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import Catenary, must_fail, rate
from moorings import CHAIN, end_tensions, fixed, nodes, single, statics, weight_in_water

from moorage.physics.catenary import catenary

EA, WEIGHT = 7.536e8, weight_in_water(CHAIN)


def hanging(segments: int, **environment):
    """Relative errors of the tensions at both ends, and the largest distance of a node from the catenary, m."""
    a, b = fixed(1, 0.0, 0.0, -200.0), fixed(2, 280.0, 210.0, -120.0)
    built = statics(single(CHAIN, 500.0, int(segments), a, b, **environment), tolerance=1e-3)
    exact = Catenary(500.0, EA, WEIGHT, False)
    x, z = exact.shape(*exact.solve(350.0, 80.0), built.names.arc_length)
    r = nodes(built)
    off = np.hypot(np.hypot(r[:, 0], r[:, 1]) - x, r[:, 2] + 200.0 - z)
    return *(end_tensions(built)[0] / exact.end_tensions(350.0, 80.0) - 1.0), off.max()


def grounded(segments: int, **environment):
    a, b = fixed(1, -837.6, 0.0, -200.0), fixed(2, -40.868, 0.0, -14.0)
    around = {"water_depth": 200.0, "seabed_stiffness": 3e10} | environment
    built = statics(single(CHAIN, 835.5, int(segments), a, b, **around), tolerance=1.0)
    exact = Catenary(835.5, EA, WEIGHT, True)
    x, z = exact.shape(*exact.solve(796.732, 186.0), built.names.arc_length)
    r = nodes(built)
    off = np.hypot(r[:, 0] + 837.6 - x, r[:, 2] + 200.0 - z)
    return *(end_tensions(built)[0] / exact.end_tensions(796.732, 186.0) - 1.0), off.max()


def check(case, exact: Catenary, span: float, rise: float, segments, closeness: float, **environment) -> None:
    errors = np.array([case(n, **environment) for n in segments])
    p = rate(exact.length / segments, errors[:, 2])
    assert abs(p - 2.0) < 0.05, f"rate {p:.3f} of the shape, {errors[:, 2]}"
    predicted = np.array([exact.lumping(span, rise, n) for n in segments])
    off = (errors[:, :2] - predicted) / np.abs(predicted).max(axis=1, keepdims=True)
    assert np.abs(off).max() < closeness, f"errors of the tensions differ by {off} of the predicted ones"


CASES = {
    "hanging": (hanging, Catenary(500.0, EA, WEIGHT, False), 350.0, 80.0, np.array([20, 40, 80, 160]), 0.01),
    "grounded": (grounded, Catenary(835.5, EA, WEIGHT, True), 796.732, 186.0, np.array([25, 50, 100, 200, 400]), 0.2),
}


@pytest.mark.parametrize("name", CASES)
def test_statics_against_the_continuous_line(name):
    check(*CASES[name])


@pytest.mark.parametrize("name", CASES)
def test_wrong_water_density_fails(name):
    """Water that is 0.1 % too heavy makes the chain 0.004 % lighter."""
    must_fail(check, *CASES[name], water_density=1.001 * 1025.0)


@pytest.mark.parametrize("rise", [0.0, 80.0, -120.0])
@pytest.mark.parametrize("length", [275.0, 330.0, 500.0])
def test_first_guess_is_the_exact_catenary(rise, length):
    """`physics.catenary` against the reference, taut and slack, end A above or below: both are solved to 1e-9 L."""
    span, arc = 245.0, np.linspace(0.0, length, 31)
    x, z = catenary(span, rise, length, EA, WEIGHT, arc, False)
    line = Catenary(length, EA, WEIGHT, False)
    force = line.solve(span, abs(rise))
    xs, zs = line.shape(*force, arc if rise >= 0.0 else length - arc)
    if rise < 0.0:
        xs, zs = span - xs, zs + rise
    assert np.abs(x - xs).max() < 1e-6
    assert np.abs(z - zs).max() < 1e-6
