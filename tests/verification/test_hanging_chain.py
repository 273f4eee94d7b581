"""Natural frequencies of a chain that hangs from one end: omega_n sqrt(L / g) = 1.202413, 2.760039, 4.326864.

Verifies: tension, weight, morison, point

Bernoulli's chain (Lamb 1910): half the zeros of J0. The lower end is a free point without mass. Measured twice: from
the eigenvalues of the assembled tangent and mass, and from a run that starts with the velocities of a mode.

Tolerance. With stiffness T / h at the middle of each segment and masses lumped at the nodes, the eigenvalue of a grid
is the Rayleigh quotient of the exact mode J0(2 omega sqrt(s / g)) on that grid, to order h^2: the error e that is
predicted so must be the one measured, within 1 % and the next order (5 e), and fall at a rate within 0.05 of 2. EA is
so high that the chain stretches by 1e-6, for which 3e-6 are allowed.

In time, the step adds an error of second order. Extrapolated to a step of zero, the frequency must be that of the
eigenvalues within 1e-6 (the amplitude is 1e-4 of the length); the rate must lie within 0.1 of 2.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import frequency, must_fail, rate
from dense import modes
from moorings import GRAVITY, fixed, free, kind, run, single, statics
from scipy.special import j0, jn_zeros

LENGTH, MASS = 50.0, 20.0
SEGMENTS = np.array([30, 60, 120])
TABLE = np.array([1.202413, 2.760039, 4.326864])


def hanging(segments: int, gravity: float = GRAVITY):
    rope = kind(mass_per_length=MASS, axial_stiffness=1e10)
    model = single(
        rope, LENGTH, segments, fixed(1, 0.0, 0.0, -10.0), free(2, 0.0, 0.0, -60.0), water_density=0.0, gravity=gravity
    )
    return statics(model, tolerance=5e-4)


def frequencies(segments: int, gravity: float = GRAVITY) -> np.ndarray:
    """The three lowest of the modes in one plane, times sqrt(L / g)."""
    return modes(hanging(segments, gravity))[0][0:6:2] * np.sqrt(LENGTH / GRAVITY)


def predicted(segments: int, n: int) -> float:
    """Relative error of the n-th frequency on a grid, from the Rayleigh quotient of the exact mode."""
    omega = 0.5 * jn_zeros(0, n)[-1] * np.sqrt(GRAVITY / LENGTH)
    s = np.linspace(0.0, LENGTH, segments + 1)
    h, y = LENGTH / segments, j0(2.0 * omega * np.sqrt(s / GRAVITY))
    masses = np.full(segments + 1, MASS * h)
    masses[[0, -1]] *= 0.5
    stiffness = np.sum(MASS * GRAVITY * 0.5 * (s[1:] + s[:-1]) * np.diff(y) ** 2 / h)
    return 0.5 * (stiffness / np.sum(masses * y**2) / omega**2 - 1.0)


def check_eigenvalues(gravity: float = GRAVITY) -> None:
    errors = np.array([frequencies(n, gravity) for n in SEGMENTS]) / (0.5 * jn_zeros(0, 3)) - 1.0
    for n, column in enumerate(errors.T, 1):
        expected = np.array([predicted(k, n) for k in SEGMENTS])
        assert (np.abs(column / expected - 1.0) < 0.01 + 5.0 * np.abs(expected) + 3e-6 / np.abs(expected)).all()
        assert abs(rate(1.0 / SEGMENTS, np.abs(column)) - 2.0) < 0.05


def test_table_is_that_of_the_bessel_zeros():
    assert np.abs(0.5 * jn_zeros(0, 3) - TABLE).max() < 5e-7


def test_eigenvalues():
    check_eigenvalues()


def test_wrong_gravity_fails():
    must_fail(check_eigenvalues, 1.001 * GRAVITY)


def measured(steps_per_period: int, n: int) -> tuple[float, float]:
    """Frequency of a run that starts with the n-th mode, and that of its eigenvalue, rad/s."""
    built = hanging(20)
    omega, shapes = modes(built)
    k = 2 * (n - 1)
    shape = shapes[:, :, k] / np.abs(shapes[:, :, k]).max()
    built.state.velocity[...] = 1e-4 * LENGTH * omega[k] * shape
    period = 2.0 * np.pi / omega[k]
    dt = period / steps_per_period
    block = run(built, 2.5 * period, time_step=dt, dt_out=dt, dt_nodes=dt, tolerance=1e-9)
    largest = int(np.argmax(np.abs(shape[:21, 0]) + np.abs(shape[:21, 1])))
    path = block["node_position"][:, largest, :2]
    return frequency(path[:: steps_per_period // 20] @ shape[largest, :2], dt * (steps_per_period // 20)), omega[k]


@pytest.mark.parametrize("n", [1, 2])
def test_small_oscillation(n):
    steps = np.array([80, 160, 320])
    found = np.array([measured(k, n) for k in steps])
    errors = found[:, 0] / found[:, 1] - 1.0
    assert abs(rate(1.0 / steps, np.abs(errors)) - 2.0) < 0.1
    assert abs(errors[-1] + (errors[-1] - errors[-2]) / 3.0) < 1e-6
