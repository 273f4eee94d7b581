"""A line in the surface of waves: its end force is smooth in time, also as nodes go through the surface.

Verifies: weight, morison, sea

What of a segment is wet goes from all to nothing over its length, or over its diameter where it lies level, so that
force is continuous in time: its largest change in a step falls with the step, f(t + h) - f(t) = O(h). Were nodes wet or
dry as a whole, a change of the size of a node's share would be left at any step. Two lines: one that stands through
the surface, whose nodes go through one by one, and one that lies level along the crests, all of which goes through at
once. From steps of 10, 5 and 2.5 ms the rate must be above 0.8; 1 where force is differentiable. A level line of a
thousandth of the diameter in the surface, with all else the same, is wet or dry at once, and must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from moorings import DENSITY, fixed, kind, run, single

from moorage.model import Waves
from moorage.solve.statics import solve
from moorage.system.build import build

STEPS = 0.01, 0.005, 0.0025
# number of segments, and EA in N: stiff and of few parts, so that it stays level and much of the load is at its end
MADE = {"standing": (30, 1e7), "level": (2, 1e10)}
ENDS = {"standing": ((0.0, 0.0, -24.0), (4.0, 0.0, 6.0)), "level": ((0.0, -15.0, 0.3), (0.0, 15.0, 0.3))}


def end_force(place: str, step: float, thinner: float = 1.0) -> np.ndarray:
    """Vertical force on the upper end in each step of a period, (n,) N."""
    (a, b), (parts, stiffness) = ENDS[place], MADE[place]
    hose = kind(
        diameter=0.2, mass_per_length=0.8 * DENSITY * np.pi / 4.0 * 0.2**2, axial_stiffness=stiffness, transverse_drag=1.2,
        transverse_added_mass=1.0, axial_damping_ratio=0.8,
    )  # fmt: skip
    length = float(np.linalg.norm(np.subtract(a, b))) / 1.001
    wave = Waves.regular(3.0, 8.0, depth=40.0, ramp=4.0)
    built = build(single(hose, length, parts, fixed(1, *a), fixed(2, *b), water_depth=40.0, waves=wave))
    built.system.weight.radius[:] *= thinner
    solve(built)
    block = run(built, 16.0, dt_out=step, time_step=step, tolerance=1e-7)
    return block["end_force"][block["time"] > 8.0, 0, 1, 2]


def check_smooth(place: str, thinner: float = 1.0) -> None:
    forces = [end_force(place, step, thinner) for step in STEPS]
    jumps = [np.abs(np.diff(force)).max() for force in forces]
    print(place, "largest change in a step:", np.round(jumps, 2), "N of", round(np.ptp(forces[-1])))
    assert rate(STEPS, jumps) > 0.8


@pytest.mark.parametrize("place", ENDS)
def test_force_is_smooth(place):
    check_smooth(place)


def test_surface_without_a_band_fails():
    must_fail(check_smooth, "level", 1e-3)
