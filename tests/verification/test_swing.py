"""Lorentz's pendulum: a load that swings on a line that is paid out or hauled in.

Verifies: winch

With L(t) the length from the winch to the load, d(L^2 theta')/dt = -g L sin(theta):

    L theta'' + 2 L' theta' + g sin(theta) = 0

(L. D. Landau & E. M. Lifshitz, Mechanics, 1976, section 49, for slow changes). It is solved apart, by SciPy. The rope
has 0.4 of 1000 kg, which changes the period by 1e-4 at most, and gives way by M g / EA = 1e-4. Both leave 1e-4 of
0.1 rad an angle of 1e-4 after 30 s, or 15 rad of phase. Segments are made, or removed, on the way.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from scipy.integrate import solve_ivp
from winches import GRAVITY, load_on_rope, smooth_rate, winch

import moorage
from moorage.model.payout import paid_out

LENGTH, ANGLE, STRETCH = 20.0, 0.1, 1000.0 * GRAVITY / 1e8


def swing(speed, step):
    place = (LENGTH * np.sin(ANGLE), 0.0, -LENGTH * np.cos(ANGLE))
    model = load_on_rope(
        winch(smooth_rate(speed)), LENGTH / (1.0 + STRETCH), 5, place, mass_per_length=0.02, axial_stiffness=1e8,
        axial_damping_ratio=0.5,
    )  # fmt: skip
    ds = moorage.simulate(model, duration=30.0, start="as-given", time_step=step)
    x, _, z = ds["point_position"].values[:, 0].T
    return ds["time"].values, np.arctan2(x, -z)


def pendulum(speed, time, coriolis=2.0):
    paid = paid_out(winch(smooth_rate(speed)))

    def slopes(t, y):
        length, rate = paid.at(t)
        turn = coriolis * rate * y[1] + GRAVITY * np.sin(y[0])
        return [y[1], -turn / (LENGTH + length * (1.0 + STRETCH))]

    return solve_ivp(slopes, (0.0, time[-1]), [ANGLE, 0.0], t_eval=time, rtol=1e-9, atol=1e-11, max_step=0.1).y[0]


def check(speed, step, coriolis=2.0):
    time, angle = swing(speed, step)
    assert np.abs(angle - pendulum(speed, time, coriolis)).max() < 2e-4


@pytest.mark.parametrize("speed", [0.5, -0.4], ids=["paid out", "hauled in"])
def test_a_load_swings_as_the_pendulum_does(speed):
    check(speed, 0.025)


def test_a_pendulum_without_the_change_of_its_moment_fails():
    must_fail(check, 0.5, 0.025, coriolis=0.0)


def test_the_error_falls_with_the_square_of_the_step():
    steps, errors = (0.1, 0.05), []
    for step in steps:
        time, angle = swing(-0.4, step)
        errors.append(np.abs(angle - pendulum(-0.4, time)).max())
    assert 1.6 < rate(steps, errors) < 2.7
