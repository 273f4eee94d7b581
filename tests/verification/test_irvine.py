"""Irvine's cable: first symmetric in-plane mode, where stretching and sag work together.

Verifies: tension, weight, morison

Irvine & Caughey (1974): with lambda^2 = (m g l / H)^2 l EA / (H Le), Omega = omega l sqrt(m / H) solves

    tan(Omega / 2) = Omega / 2 - (4 / lambda^2) (Omega / 2)^3

and Omega / pi = 1.04020, 1.34512, 2, 2.59718 for lambda^2 = 1, 10, 4 pi^2, 100. The theory drops terms of (m g l /
H)^2, 2.5e-5 here, and the strain H / EA, which is that over lambda^2. Lumped masses lower a frequency by (Omega /
N)^2 / 24, as those of a string; measured errors must lie within that and 5e-5, and fall at a rate within 0.1 of 2 on
grids where that is all.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import Catenary, frequency, must_fail, rate
from dense import modes
from moorings import GRAVITY, fixed, kind, nodes, run, single, statics
from scipy.optimize import brentq

TABLE = {1.0: 1.04020, 10.0: 1.34512, 4.0 * np.pi**2: 2.0, 100.0: 2.59718}
SPAN, H, RATIO = 100.0, 1e5, 0.005  # RATIO = m g l / H
SEGMENTS = np.array([10, 20, 40])


def cable(square: float, segments: int, ratio: float = RATIO):
    """A level cable in air with horizontal tension H."""
    stiffness, mass = square * H / ratio**2, ratio * H / SPAN / GRAVITY

    def miss(length):
        line = Catenary(length, stiffness, mass * GRAVITY, False)
        return line.shape(H, 0.5 * mass * GRAVITY * length, length)[0] - SPAN

    length = brentq(miss, SPAN / (1.0 + H / stiffness) * 0.999, SPAN * 1.001, xtol=1e-13, rtol=1e-15)
    t = kind(mass_per_length=mass, axial_stiffness=stiffness)
    a, b = fixed(1, 0.0, 0.0, -20.0), fixed(2, SPAN, 0.0, -20.0)
    return statics(single(t, length, int(segments), a, b, water_density=0.0))


def symmetric_mode(built) -> tuple[float, np.ndarray]:
    """Frequency and shape of the first mode in the plane of the cable that is the same at both ends."""
    omega, shapes = modes(built)
    for k in range(len(omega)):
        z = shapes[: len(nodes(built)), 2, k]
        y = shapes[: len(nodes(built)), 1, k]
        if np.abs(y).max() < 1e-3 * np.abs(z).max() and np.abs(z - z[::-1]).max() < 1e-2 * np.abs(z).max():
            return omega[k], shapes[:, :, k] / np.abs(z).max()
    raise AssertionError("no symmetric mode")


def exact(square: float) -> float:
    """Omega / pi, the lowest root beyond the singular points of tan."""

    def f(x):
        return np.sin(x) - np.cos(x) * (x - 4.0 / square * x**3)

    return brentq(f, np.pi / 2.0 * 1.0001, 1.4999 * np.pi) * 2.0 / np.pi


def check(square: float, wrong: float = 1.0) -> None:
    unit = np.pi / SPAN * np.sqrt(GRAVITY * SPAN / RATIO)  # pi / l sqrt(H / m)
    found = np.array([symmetric_mode(cable(square * wrong, n))[0] for n in SEGMENTS]) / unit
    reference = exact(square)
    errors = np.abs(found / reference - 1.0)
    allowed = (np.pi * reference / SEGMENTS) ** 2 / 24.0
    assert (errors < 1.1 * allowed + 5e-5).all(), f"{errors} against {allowed}"
    assert abs(rate(1.0 / SEGMENTS, errors) - 2.0) < 0.1, f"{errors}"


@pytest.mark.parametrize("square", TABLE)
def test_root_is_that_of_the_table(square):
    assert exact(square) == pytest.approx(TABLE[square], abs=6e-6)


@pytest.mark.parametrize("square", TABLE)
def test_eigenvalue(square):
    check(square)


def test_wrong_stiffness_fails():
    """3 % more EA: at lambda^2 = 4 pi^2 the frequency goes with about its fourth root."""
    must_fail(check, 4.0 * np.pi**2, 1.03)


def test_small_oscillation():
    """In a run the frequency is that of the eigenvalue; the step's error is removed by extrapolation."""
    errors = []
    for steps in (80, 160, 320):
        built = cable(10.0, 20, 0.05)
        omega, shape = symmetric_mode(built)
        built.state.velocity[...] = 1e-6 * SPAN * omega * shape
        dt = 2.0 * np.pi / omega / steps
        block = run(built, 2.5 * steps * dt, time_step=dt, dt_out=dt, dt_nodes=dt, tolerance=1e-12)
        path = block["node_position"][:, 10, 2] - nodes(built)[10, 2]
        errors.append(frequency(path[:: steps // 20], dt * (steps // 20)) / omega - 1.0)
    assert abs(rate([4.0, 2.0, 1.0], np.abs(errors)) - 2.0) < 0.1
    assert abs(errors[-1] + (errors[-1] - errors[-2]) / 3.0) < 1e-5
