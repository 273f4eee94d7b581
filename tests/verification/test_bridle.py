"""A free point that joins three lines: equilibrium by hand, stiffness, and natural frequency.

Verifies: point, tension

The answer is chosen first: a point p, three anchors, tensions T_i. Weightless elastic lines are straight, so that
unstretched lengths |p - a_i| / (1 + T_i / EA) and the external force -sum T_i u_i (u_i from p to the anchors) make p
the equilibrium. Statics start from 5 m away and must find p to 1e-6 m and the tensions to 1e-8.

The stiffness of the point is sum [EA / l_i u u^T + T_i / L_i (I - u u^T)], exactly, whatever the number of segments;
with a mass that dwarfs the lines' it oscillates at sqrt(K / m): the lines' own mass, 1e-6 of it, is allowed for.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import frequency, must_fail
from dense import modes
from moorings import DENSITY, end_tensions, fixed, free, kind, line, mooring, points, run, statics

from moorage.solve.stiffness import point_stiffness

EA, DIAMETER = 1e7, 0.01
WEIGHTLESS = kind("thread", diameter=DIAMETER, mass_per_length=DENSITY * np.pi / 4.0 * DIAMETER**2, axial_stiffness=EA)
ANCHORS = np.array([[-40.0, 0.0, -60.0], [30.0, 25.0, -55.0], [20.0, -35.0, -50.0]])
PLACE, TENSIONS = np.array([2.0, -3.0, -20.0]), np.array([2e4, 3e4, 1.5e4])
MASS, AWAY = 1e5, np.array([3.0, 3.0, -2.6])


def bridle(segments: int = 4, wrong: float = 1.0):
    e = ANCHORS - PLACE
    span = np.linalg.norm(e, axis=1)
    force = tuple(float(x) for x in -(TENSIONS / span) @ e)
    held = [fixed(k + 1, *a) for k, a in enumerate(ANCHORS)]
    lengths = span / (1.0 + TENSIONS / EA) * [1.0, 1.0, wrong]
    lines = [line(k + 1, k + 1, 9, ("thread", float(length), segments)) for k, length in enumerate(lengths)]
    away = free(9, *(PLACE + AWAY), mass=MASS, volume=MASS / DENSITY, external_force=force)
    return statics(mooring(WEIGHTLESS, (*held, away), lines), tolerance=1e-6)


def stiffness() -> np.ndarray:
    e = ANCHORS - PLACE
    span = np.linalg.norm(e, axis=1)
    K = np.zeros((3, 3))
    for u, L, T in zip(e / span[:, None], span, TENSIONS, strict=True):
        K += EA / (L / (1.0 + T / EA)) * np.outer(u, u) + T / L * (np.eye(3) - np.outer(u, u))
    return K


def check(segments: int, wrong: float = 1.0) -> None:
    built = bridle(segments, wrong)
    assert points(built)[3] == pytest.approx(PLACE, abs=1e-6)
    assert end_tensions(built) == pytest.approx(np.stack([TENSIONS, TENSIONS], axis=1), rel=1e-8)
    K = point_stiffness(built)[3, :, 3, :]
    assert pytest.approx(stiffness(), rel=1e-6, abs=1.0) == K


@pytest.mark.parametrize("segments", [1, 4])
def test_point_is_where_it_must_be(segments):
    check(segments)


def test_wrong_length_fails():
    """One line longer by a millionth of its length, 0.05 mm."""
    must_fail(check, 4, 1.0 + 1e-6)


def test_oscillation():
    built = bridle()
    expected = np.sqrt(np.linalg.eigvalsh(stiffness()) / MASS)
    omega, shapes = modes(built)
    assert omega[:3] == pytest.approx(expected, rel=1e-4)
    built.state.velocity[...] = 1e-3 * shapes[:, :, 0] / np.abs(shapes[-1, :, 0]).max()
    dt = 2.0 * np.pi / omega[0] / 400.0
    block = run(built, 800.0 * dt, time_step=dt, dt_out=dt, tolerance=1e-10)
    path = block["point_position"][::20, 3] @ shapes[-1, :, 0]
    assert frequency(path, 20.0 * dt) == pytest.approx(expected[0], rel=1e-4)
