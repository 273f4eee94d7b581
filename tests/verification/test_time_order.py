"""Order in time: 2 for the implicit step and RK2, 4 for RK4; and all methods converge to the same solution.

Verifies: tension, morison, motion, weight, current

A line of 10 segments in water hangs from a moving point with drag, added mass, axial damping and a current; nothing
switches on or off on the way (no bed, never slack, no node at rest in the water), so that the solution is smooth. On
the same grid of segments, end tension and the path of a node after 2 s are compared with RK4 at a step of 0.1 ms. The
rates must lie within 0.15 of the order; the implicit result extrapolated to a step of zero (Richardson) must be that
of RK4 within 1e-6.

Prescribed motion is a cubic spline whose third derivative jumps at its knots: all steps end there.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from moorings import coupled, fixed, kind, run, single, statics

from moorage.model import Current, Motion

ROPE = kind(
    diameter=0.1, mass_per_length=40.0, axial_stiffness=1e6, axial_damping=1e4, transverse_drag=1.2, tangential_drag=0.2,
    transverse_added_mass=1.0, tangential_added_mass=0.1,
)  # fmt: skip
DURATION = 2.0
STEPS = {"implicit": (0.02, 0.01, 0.005), "rk2": (0.002, 0.001, 0.0005), "rk4": (0.004, 0.002, 0.001)}
ORDER = {"implicit": 2, "rk2": 2, "rk4": 4}


def motion() -> Motion:
    time = np.arange(0.0, DURATION + 0.5, 0.1)
    rise = (1.0 - np.cos(np.pi * np.clip(time, 0.0, 1.0))) * 0.5
    moved = rise[:, None] * np.stack(
        [0.3 * np.sin(3.0 * time), 0.1 * np.sin(2.0 * time), 0.1 * np.sin(4.0 * time)], axis=1
    )
    return Motion.from_points(time, {2: np.array([40.0, 0.0, -5.0]) + moved})


@pytest.fixture(scope="module")
def start():
    current = Current((-30.0, 0.0), ((0.3, 0.5, 0.0), (0.8, 0.2, 0.1)))
    model = single(ROPE, 46.5, 10, fixed(1, 0.0, 0.0, -25.0), coupled(2, 40.0, 0.0, -5.0), current=current)
    return statics(model, motion())


def result(start, method: str, step: float) -> np.ndarray:
    """Tensions at both ends (kN) and place of a node (m) at the end."""
    block = run(start, DURATION, method=method, time_step=step, dt_out=0.1, watch=((0, 6),), tolerance=1e-10)
    return np.concatenate([block["end_tension"][-1].ravel() / 1e3, block["watch_position"][-1, 0]])


@pytest.fixture(scope="module")
def reference(start):
    return result(start, "rk4", 1e-4)


def check(start, reference, method: str, order: int) -> None:
    errors = np.array([np.abs(result(start, method, h) - reference) for h in STEPS[method]])
    for column in (errors[:, :2].max(axis=1), errors[:, 2:].max(axis=1)):
        assert abs(rate(STEPS[method], column) - order) < 0.15, f"{errors}"


@pytest.mark.parametrize("method", ORDER)
def test_order(start, reference, method):
    check(start, reference, method, ORDER[method])


def test_implicit_converges_to_rk4(start, reference):
    coarse, fine = (result(start, "implicit", h) for h in STEPS["implicit"][1:])
    extrapolated = fine + (fine - coarse) / 3.0
    assert np.abs(extrapolated / reference - 1.0).max() < 1e-6


def test_rk2_is_not_of_order_4(start, reference):
    must_fail(check, start, reference, "rk2", 4)


def test_other_current_fails(start, reference):
    """1 % more current is noticed: no rate is left."""
    current = start.system.current
    other = start._replace(system=start.system._replace(current=current._replace(velocity=1.01 * current.velocity)))
    must_fail(check, other, reference, "implicit", 2)
