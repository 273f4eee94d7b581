"""Contact with the seabed: a falling line in closed form, its energy, and how errors fall with the step.

Verifies: contact, weight, morison

Landing. A level line that falls in vacuum hits the bed with v0; in contact its penetration x obeys, for each metre,

    m x'' + c x' + k x = w,  x = 0, x' = v0

(k = k_b d, c = c_b d), a damped oscillator in closed form; with a strong damper it never leaves again. The damper's
force jumps from 0 to c v0 at touch-down, which limits any step that does not end just there to first order: the error
of the path must stay below v0 h / 2, half a step's fall, and fall at a rate within 0.1 of 1.

Bounce. Without damper the line leaves with the speed at which it came. The force has a corner only, where the
implicit method gains or loses energy of second order: rate at least 1.7, and 1e-3 at a step of a hundredth of the
contact's time.

Chain. Three chains with touch-down points, moved at the fairlead by 4 m: the rms error of the fairlead tension
against a run with a step 16 times finer falls with the step at a rate of at least 1.3, although dampers switch on and
off all the time. It must be below 0.05 % of the tension at 12.5 ms.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate, rms
from moorings import GRAVITY, at_rest, free, kind, run, single, spread, statics

from moorage.model import Motion

DIAMETER, MASS, DEPTH, DROP = 0.1, 40.0, 30.0, 0.5
SPEED = np.sqrt(2.0 * GRAVITY * DROP)
FALL = SPEED / GRAVITY


def fallen(step: float, stiffness: float, damping: float, duration: float):
    """Times after touch-down and penetration of a line dropped from 0.5 m, and its vertical velocity."""
    rope = kind(diameter=DIAMETER, mass_per_length=MASS)
    z = DROP - DEPTH
    model = single(
        rope, 10.0, 4, free(1, 0.0, 0.0, z), free(2, 10.0, 0.0, z), water_depth=DEPTH, water_density=0.0,
        seabed_stiffness=stiffness, seabed_damping=damping,
    )  # fmt: skip
    built = at_rest(model)
    built.state.position[:5] = np.linspace([0.0, 0.0, z], [10.0, 0.0, z], 5)
    steps = int(np.ceil((FALL + duration) / step))
    block = run(built, steps * step, time_step=step, dt_out=step, tolerance=1e-9)
    return block["time"] - FALL, -DEPTH - block["point_position"][:, 0, 2], block["point_velocity"][:, 0, 2]


def penetration(t, stiffness: float, damping: float):
    """Closed form of the damped oscillator, for either sign of its discriminant."""
    k, c, w = stiffness * DIAMETER, damping * DIAMETER, MASS * GRAVITY
    s = np.roots([MASS, c, k]).astype(complex)
    a, b = np.linalg.solve(np.array([[1.0, 1.0], s]), [-w / k, SPEED])
    return np.real(w / k + a * np.exp(s[0] * t) + b * np.exp(s[1] * t))


LANDING = 4e5, 4e4  # Pa/m, Pa s/m: k / m = 1000 / s2, c / m = 100 / s, over-damped


def landing_error(step: float, wrong: float = 1.0) -> float:
    """Largest error of the path, m."""
    t, x, _ = fallen(step, *LANDING, 0.3)
    exact = penetration(np.maximum(t, 0.0), LANDING[0], LANDING[1] * wrong)
    return float(np.abs(x - exact)[t > 0.0].max())


def check_landing(wrong: float = 1.0) -> None:
    steps = np.array([0.004, 0.002, 0.001, 0.0005])
    errors = np.array([landing_error(h, wrong) for h in steps])
    assert abs(rate(steps, errors) - 1.0) < 0.1, f"{errors}"
    assert (errors < 0.5 * SPEED * steps).all(), f"{errors}"


def test_landing():
    check_landing()


def test_landing_on_another_bed_fails():
    must_fail(check_landing, 1.05)


BOUNCE = 4e5, 0.0
CONTACT = np.pi / np.sqrt(4e5 * DIAMETER / MASS)  # s, about


def bounce_error(step: float, damping: float = 0.0) -> float:
    """Relative loss of energy over one bounce."""
    _, x, v = fallen(step, BOUNCE[0], damping, 1.5 * CONTACT + 0.1)
    height, speed = -x[-1], v[-1]
    assert height > 0.0
    return float(abs((0.5 * speed**2 + GRAVITY * height) / (GRAVITY * DROP) - 1.0))


def check_bounce(damping: float = 0.0) -> None:
    steps = CONTACT / np.array([25, 50, 100, 200])
    # where a step begins relative to touch-down makes the error jump about: the mean of five phases counts
    errors = np.array([rms([bounce_error(h * s, damping) for s in (0.92, 0.96, 1.0, 1.04, 1.08)]) for h in steps])
    assert rate(steps, errors) > 1.7, f"{errors}"
    assert errors[2] < 1e-3, f"{errors}"


def test_bounce_keeps_energy():
    check_bounce()


def test_damped_bounce_fails():
    must_fail(check_bounce, 10.0)


MOTION = Motion.from_harmonics(21.0, ramp=5.0, interval=0.1, surge=(4.0, 8.0), heave=(2.0, 6.0))


@pytest.fixture(scope="module")
def chains():
    return statics(spread(20), MOTION)


def tension(built, step: float) -> np.ndarray:
    return run(built, 20.0, time_step=step, dt_out=0.1, tolerance=1e-5)["end_tension"][:, :, 1]


def check_chains(built, reference) -> None:
    steps = np.array([0.1, 0.05, 0.025, 0.0125])
    errors = np.array([rms(tension(built, h) - reference) / rms(reference) for h in steps])
    assert rate(steps, errors) > 1.3, f"{errors}"
    assert errors[-1] < 5e-4, f"{errors}"


def test_chains_on_the_bed(chains):
    check_chains(chains, tension(chains, 0.0125 / 16.0))


def test_chains_on_a_bed_without_damping_fail(chains):
    seabed = chains.system.contact
    undamped = chains._replace(system=chains.system._replace(contact=seabed._replace(damper=0.0 * seabed.damper)))
    must_fail(check_chains, undamped, tension(chains, 0.0125 / 16.0))
