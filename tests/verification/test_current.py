"""Lines in a steady current: the angle of a towed line, and the deflection of a taut one in a sheared current.

Verifies: current, morison, weight, tension

Towed line. A uniform heavy line hangs from a point into a uniform current U, its lower end free. It is straight, at
the critical angle p between line and flow at which the drag across it carries its weight across it,

    0.5 rho Cdn d U^2 sin^2 p = w cos p,    T_top = L (w sin p + 0.5 rho Cdt pi d U^2 cos^2 p)

(with the flow's drag along the line pulling down it). A lumped line is straight too, so that there is no error of
discretisation: statics must give angle and end force to the 1e-6 that the accepted imbalance leaves.

Sheared current. A weightless taut line stands between two points in a current from 0 at its foot to U1 at its top.
Its deflection being small, q(s) = 0.5 rho Cdn d U1^2 (s / L)^2 pulls it with q1 L / 4 at its top and q1 L / 12 at its
foot. Lumping is the trapezoidal rule, which adds (h / L)^2 / 4 and takes off (h / L)^2 / 12 of q1 L: what is measured
must be that within 2e-6, the square of the deflection's slope being 1e-6.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import (
    DENSITY,
    coupled,
    fixed,
    free,
    kind,
    nodes,
    point_forces,
    single,
    statics,
    weight_in_water,
)
from scipy.optimize import brentq

from moorage.model import Current

ROPE = kind(diameter=0.05, mass_per_length=6.0, axial_stiffness=1e8, transverse_drag=1.2, tangential_drag=0.02)
LENGTH = 200.0


def towed(speed: float, heading: float, **water) -> tuple[float, np.ndarray, float]:
    """Angle of a towed line to the flow, force at its top in the frame of the flow, and how far it is from straight, m."""
    flow = np.array([np.cos(heading), np.sin(heading), 0.0])
    model = single(
        ROPE, LENGTH, 20, free(1, 0.0, 0.0, -LENGTH - 10.0), coupled(2, 0.0, 0.0, -10.0), current=Current((0.0,), (tuple(speed * flow),)),
        **water,
    )  # fmt: skip
    built = statics(model, tolerance=1e-3)
    r = nodes(built)
    down = r[0] - r[-1]
    q = down / np.linalg.norm(down)
    force = point_forces(built)[1]
    bow = np.linalg.norm(np.cross(r - r[-1], q), axis=1).max()
    return float(np.arccos(q @ flow)), np.array([force @ flow, force @ np.cross([0, 0, 1], flow), force[2]]), float(bow)


def check_towed(speed: float, heading: float, **water) -> None:
    w = weight_in_water(ROPE)
    across = 0.5 * DENSITY * 1.2 * 0.05 * speed**2
    p = brentq(lambda x: across * np.sin(x) ** 2 - w * np.cos(x), 1e-6, np.pi / 2.0)
    tension = LENGTH * (w * np.sin(p) + 0.5 * DENSITY * 0.02 * np.pi * 0.05 * (speed * np.cos(p)) ** 2)
    angle, force, bow = towed(speed, heading, **water)
    assert angle == pytest.approx(p, abs=1e-6)
    assert force / tension == pytest.approx(np.array([np.cos(p), 0.0, -np.sin(p)]), abs=1e-6)
    assert bow < 1e-3


@pytest.mark.parametrize(("speed", "heading"), [(0.3, 0.0), (0.6, -2.0), (1.2, 0.7)])
def test_towed_line_has_its_critical_angle(speed, heading):
    check_towed(speed, heading)


@pytest.mark.parametrize("speed", [2.0, 3.0, 5.0])
def test_line_towed_fast(speed):
    """At 5 m/s the drag across the line is 20 times its weight: what rules is how drag turns with the line."""
    check_towed(speed, 0.0)


def test_wrong_water_fails():
    must_fail(check_towed, 1.0, 0.0, water_density=1.001 * DENSITY)


def taut(segments: int, levels, speeds) -> np.ndarray:
    """Forces on foot and top across a taut line without weight in water, N."""
    neutral = kind(
        diameter=0.1, mass_per_length=DENSITY * np.pi / 4.0 * 0.1**2, axial_stiffness=1e9, transverse_drag=1.0
    )
    model = single(
        neutral, 100.0, segments, fixed(1, 0.0, 0.0, -110.0), fixed(2, 0.0, 0.0, -9.9), water_depth=200.0,
        current=Current(levels, tuple((0.0, u, 0.0) for u in speeds)),
    )  # fmt: skip
    return point_forces(statics(model))[:, 1]


def check_sheared(segments: int, levels=(-110.0, -9.9), speeds=(0.0, 1.0)) -> None:
    q1 = 0.5 * DENSITY * 1.0 * 0.1 * 1.0**2
    shares = np.array([1.0, 3.0]) / 12.0 + np.array([-1.0, 3.0]) / 12.0 / segments**2
    assert taut(segments, levels, speeds) == pytest.approx(q1 * 100.0 * shares, rel=2e-6)


@pytest.mark.parametrize("segments", [5, 10, 40])
def test_sheared_current(segments):
    check_sheared(segments)


def test_profile_of_several_levels_is_the_same_line():
    check_sheared(10, (-110.0, -60.0, -9.9), (0.0, 50.0 / 100.1, 1.0))


def test_uniform_current_of_the_same_mean_fails():
    must_fail(check_sheared, 10, (0.0,), (0.5,))
