"""Axial waves in a taut line run at c = sqrt(EA / m) and double the tension where they meet a fixed end.

Verifies: tension, morison, motion

A line of 100 m in vacuum without weight is pulled at its end B with the velocity v(t) = V sin^4(pi t / D), 0 < t < D
= 0.8 L / c. The equation of the bar (d'Alembert) gives for the tension at its ends, before a wave has come back to
the pulled end (t < 2 L / c) and while only the first has reached the fixed one (t < 3 L / c):

    T_B(t) = T0 + (EA / c) v(t)        T_A(t) = T0 + 2 (EA / c) v(t - L / c)

(the force of the line on its end objects, with the inertia of half a segment; tension of the last segment lags by h /
2c). Segments and steps are refined together, c dt = h / 2. Lumping slows a wave of wave number k by (k h)^2 / 24 and
the step of the implicit method by about (omega dt)^2 / 24 (1 + ...), both of second order: the error in both tensions
must fall at a rate within 0.1 of 2, and be below 0.1 % of the rise on 200 segments, 160 of them to the pulse. A bar 2
% too stiff must fail.
"""

from __future__ import annotations

import numpy as np
from common import must_fail, rate, rms
from moorings import at_rest, coupled, fixed, kind, run, single

from moorage.model import Motion

LENGTH, MASS, STIFFNESS, STRAIN = 100.0, 10.0, 1e7, 2e-3
SPEED = np.sqrt(STIFFNESS / MASS)
CROSSING = LENGTH / SPEED
PULSE, HEIGHT = 0.8 * CROSSING, 0.5  # s, m/s
SEGMENTS = np.array([50, 100, 200])


def pulse(t):
    return np.where((t > 0.0) & (t < PULSE), HEIGHT * np.sin(np.pi * t / PULSE) ** 4, 0.0)


def moved(t):
    """Integral of the pulse."""
    x = np.pi * np.clip(t, 0.0, PULSE) / PULSE
    return HEIGHT * PULSE / np.pi * (0.375 * x - 0.25 * np.sin(2.0 * x) + np.sin(4.0 * x) / 32.0)


def errors(segments: int, stiffness: float = STIFFNESS) -> tuple[float, float]:
    """Rms errors of the tensions at A and B, relative to the largest rise."""
    bar = kind(mass_per_length=MASS, axial_stiffness=stiffness)
    stretched = LENGTH * (1.0 + STRAIN)
    model = single(
        bar,
        LENGTH,
        segments,
        fixed(1, 0.0, 0.0, -10.0),
        coupled(2, stretched, 0.0, -10.0),
        gravity=0.0,
        water_density=0.0,
    )
    dt = 0.5 * CROSSING / segments
    time = dt / 4.0 * np.arange(16 * segments + 9)
    motion = Motion.from_points(time, {2: np.stack([stretched + moved(time), 0.0 * time, -10.0 + 0.0 * time], axis=1)})
    block = run(at_rest(model, motion), 1.95 * CROSSING, time_step=dt, dt_out=dt, tolerance=1e-9)
    t, rise = block["time"], STIFFNESS / SPEED
    exact = STIFFNESS * STRAIN + rise * np.stack([2.0 * pulse(t - CROSSING), pulse(t)], axis=1)
    off = (np.abs(block["end_force"][:, 0, :, 0]) - exact) / (rise * HEIGHT)
    return rms(off[:, 0]), rms(off[:, 1])


def check(stiffness: float = STIFFNESS) -> None:
    found = np.array([errors(int(n), stiffness) for n in SEGMENTS])
    for column in found.T:
        assert abs(rate(1.0 / SEGMENTS, column) - 2.0) < 0.1, f"{found}"
    assert found[-1].max() < 1e-3, f"{found}"


def test_pulse_arrives_in_time_and_doubles():
    check()


def test_wrong_stiffness_fails():
    must_fail(check, 1.02 * STIFFNESS)
