"""Waves and current together on a pole that stands through the surface: drag of the sum, on what is wet.

Verifies: sea, current, morison, weight

A taut vertical line without weight in water, so stiff that it does not move, carries at its two ends

    integral over -h < z < eta of  0.5 rho Cd d |u + U| (u + U) + rho A (1 + Ca) du/dt

of a wave u and a current U(z) that falls towards the bed. The integral is made with a midpoint rule of 1 cm up to the
surface of the wave. The engine takes water at nodes 0.5 m apart: the trapezoidal rule is good to (k l)^2 / 12 = 5e-5, a
surface between two nodes to the change of the load over half a segment's wet part there, a few parts in a thousand of
the load near the surface: 1e-3 of the largest force is allowed. Without the current, or wet to the still water only,
the same must fail. In still water of the same depth a current alone must give its drag on the wetted length to 1e-5.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import DENSITY, fixed, kind, point_forces, run, single, statics

from moorage.model import Current, Waves

D, CD, CA, FOOT, TOP = 0.3, 1.1, 1.0, -40.0, 8.0
LEVELS, SPEEDS = (-40.0, -15.0, 0.0), (0.2, 0.3, 0.8)
FLOW = Current(LEVELS, tuple((u, 0.0, 0.0) for u in SPEEDS))
WAVE = Waves.regular(3.0, 9.0, depth=40.0, ramp=4.0)
POLE = kind(
    diameter=D, mass_per_length=DENSITY * np.pi / 4.0 * D * D, axial_stiffness=1e11, transverse_drag=CD,
    transverse_added_mass=CA, axial_damping_ratio=0.5,
)  # fmt: skip


def standing(**water):
    ends = fixed(1, 0.0, 0.0, FOOT), fixed(2, 0.0, 0.0, TOP)
    return statics(single(POLE, (TOP - FOOT) / 1.001, 96, *ends, water_depth=40.0, seabed_stiffness=0.0, **water))


def total(t: float, current: bool, to_surface: bool) -> float:
    """Force of the water on the pole at a time, N."""
    top = float(WAVE.elevation(t)) if to_surface else 0.0
    count = round((top - FOOT) / 0.01)
    z = FOOT + (np.arange(count) + 0.5) * (top - FOOT) / count
    water = WAVE.kinematics(t, np.stack([0.0 * z, 0.0 * z, z], axis=-1))
    u = water.velocity[:, 0] + (np.interp(z, LEVELS, SPEEDS) if current else 0.0)
    inertia = DENSITY * np.pi / 4.0 * D * D * (1.0 + CA) * water.acceleration[:, 0]
    load = 0.5 * DENSITY * CD * D * np.abs(u) * u + inertia
    return float(load.mean() * (top - FOOT)) / 1.001


@pytest.fixture(scope="module")
def found():
    block = run(standing(waves=WAVE, current=FLOW), 18.0, dt_out=0.25, time_step=0.02, tolerance=1e-6)
    return block["time"], block["end_force"][:, 0, :, 0].sum(axis=1)


def check(found, current: bool = True, to_surface: bool = True) -> None:
    time, force = found
    expected = np.array([total(t, current, to_surface) for t in time])
    late = time > 9.0
    worst = np.abs(force - expected)[late].max() / np.abs(expected).max()
    print(f"differs by {worst:.1e} of {np.abs(expected).max():.0f} N")
    assert worst < 1e-3


def test_drag_of_the_sum_up_to_the_surface(found):
    check(found)


def test_waves_alone_fail(found):
    must_fail(check, found, current=False)


def test_water_to_the_still_level_fails(found):
    must_fail(check, found, to_surface=False)


def test_current_on_the_wetted_length():
    force = point_forces(standing(current=Current((0.0,), ((0.7, 0.0, 0.0),))))[:, 0].sum()
    assert force == pytest.approx(0.5 * DENSITY * CD * D * 0.7**2 * 40.0 / 1.001, rel=1e-5)
