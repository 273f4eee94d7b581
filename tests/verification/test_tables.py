"""Nonlinear stiffness and damping from tables.

Verifies: tension, table

Pulled. A line without weight between a fixed and a free point that a force F pulls on is stretched by the strain that
the table has at F, whatever the number of segments: exact, 1e-9.

Hanging. By its own weight a line of n segments is stretched by sum h e(w (s + h / 2)), e the inverse table; the
continuous line by the integral. Where the table has a corner the midpoint rule errs by up to w h^2 / 8 times the jump
of compliance there, and nowhere else: that bound must hold, and the sum be met to 1e-9.

Damper. A line of one segment whose end moves at a constant speed V has the tension of the stiffness table at its
strain plus that of the damper table at V / l: exact, 1e-9, at the end of steps.

Between rows tables are linear, beyond the last one they go on with its slope, in compression a rope has no tension.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import GRAVITY, at_rest, coupled, curve, fixed, free, kind, nodes, run, single, statics

from moorage.model import Motion

ROWS = ((0.0, 0.0), (0.01, 2e4), (0.03, 1.2e5), (0.05, 3e5))
POLYESTER = curve(*ROWS)
DAMPER = curve((0.0, 0.0), (1e-4, 1e3), (1e-2, 2e4))
LENGTH, MASS = 80.0, 15.0
VACUUM = {"water_density": 0.0}


def strain(tension):
    """Inverse of the table, continued with its last slope."""
    x, y = np.array(ROWS).T
    beyond = x[-1] + (tension - y[-1]) * (x[-1] - x[-2]) / (y[-1] - y[-2])
    return np.where(tension > y[-1], beyond, np.interp(tension, y, x))


def pulled(force: float, segments: int) -> float:
    """Strain of a line that a force pulls on."""
    rope = kind(mass_per_length=MASS, axial_stiffness=POLYESTER)
    end = free(2, LENGTH, 0.0, -10.0, external_force=(force, 0.0, 0.0))
    built = statics(
        single(rope, LENGTH, segments, fixed(1, 0.0, 0.0, -10.0), end, gravity=0.0, **VACUUM), tolerance=1e-6
    )
    r = nodes(built)
    return float(np.linalg.norm(r[-1] - r[0]) / LENGTH - 1.0)


def check_pulled(force: float, segments: int, wrong: float = 0.0) -> None:
    assert pulled(force + wrong, segments) == pytest.approx(float(strain(force)), rel=1e-9)


@pytest.mark.parametrize("segments", [1, 7])
@pytest.mark.parametrize("force", [1e3, 2e4, 7e4, 2.9e5, 5e5])
def test_pulled(force, segments):
    check_pulled(force, segments)


def test_wrong_pull_fails():
    must_fail(check_pulled, 7e4, 7, 0.01)


def hanging(segments: int, load: float = 0.0) -> float:
    """Elongation of a line that hangs with a load at its end, m."""
    rope = kind(mass_per_length=MASS, axial_stiffness=POLYESTER)
    low = free(2, 0.0, 0.0, -10.0 - 1.02 * LENGTH, mass=load / GRAVITY)
    built = statics(single(rope, LENGTH, segments, fixed(1, 0.0, 0.0, -10.0), low, **VACUUM), tolerance=1e-5)
    return float(nodes(built)[0, 2] - nodes(built)[-1, 2] - LENGTH)


def check_hanging(segments: int, load: float, wrong: float = 1.0) -> None:
    w, h = MASS * GRAVITY * wrong, LENGTH / segments
    middles = load + w * h * (np.arange(segments) + 0.5)
    found = hanging(segments, load)
    assert found == pytest.approx(h * np.sum(strain(middles)), rel=1e-8)
    fine = load + w * LENGTH * (np.arange(100_000) + 0.5) / 100_000
    x, y = np.array(ROWS).T
    jump = np.abs(np.diff(np.diff(x) / np.diff(y))).max()
    assert abs(found - LENGTH * np.mean(strain(fine))) < w * h**2 / 8.0 * jump + 1e-8


@pytest.mark.parametrize("segments", [4, 9, 30])
@pytest.mark.parametrize("load", [0.0, 1.5e4, 1.15e5])
def test_hanging(segments, load):
    check_hanging(segments, load)


def test_wrong_weight_fails():
    must_fail(check_hanging, 30, 1.5e4, 1.0001)


def stretched(speed: float, seconds: float = 3.0):
    """Strain and tension of one segment whose end has moved away at a constant speed for some time."""
    rope = kind(mass_per_length=MASS, axial_stiffness=POLYESTER, axial_damping=DAMPER)
    begin = LENGTH * 1.012
    time = np.linspace(0.0, seconds + 1.0, 41)
    place = np.stack([begin + speed * time, 0.0 * time, -10.0 + 0.0 * time], axis=1)
    model = single(rope, LENGTH, 1, fixed(1, 0.0, 0.0, -10.0), coupled(2, begin, 0.0, -10.0), gravity=0.0, **VACUUM)
    block = run(at_rest(model, Motion.from_points(time, {2: place})), seconds, time_step=0.05, dt_out=0.5)
    return block["point_position"][1:, 1, 0] / LENGTH - 1.0, block["end_tension"][1:, 0, 1]


def check_damper(speed: float, scale: float = 1.0) -> None:
    e, tension = stretched(speed)
    x, y = np.array(ROWS).T
    u, d = np.array([DAMPER.x, DAMPER.y])
    rate = abs(speed) / LENGTH
    drag = np.sign(speed) * (np.interp(rate, u, d) + max(rate - u[-1], 0.0) * (d[-1] - d[-2]) / (u[-1] - u[-2]))
    assert tension == pytest.approx(np.interp(e, x, y) + scale * drag, rel=1e-9)


@pytest.mark.parametrize("speed", [0.004, 0.3, -0.2, 1.0])
def test_damper(speed):
    check_damper(speed)


def test_wrong_damper_fails():
    must_fail(check_damper, 0.3, 1.001)
