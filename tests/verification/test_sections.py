"""Several sections in one line are the same as several lines that meet at free points without mass.

Verifies: tension, weight, contact, point

In the static equations nothing changes: half segments of both sections meet at a node, or at a point. In a run a node
has one tangent where two line ends have two, which concerns added mass and drag only: both are off. What is left is
rounding: 1e-9 of the tension in statics (accepted imbalance 1e-5 N), 1e-8 in a run of 4 s with Newton's method taken
to the end. A point with a mass of 0.1 % of a segment's must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import coupled, fixed, free, kind, line, mooring, nodes, run, statics

from moorage.model import Motion

TYPES = (
    kind("chain", diameter=0.1, mass_per_length=120.0, axial_stiffness=5e7, axial_damping=1e6),
    kind("rope", diameter=0.15, mass_per_length=16.0, axial_stiffness=5e6, axial_damping=1e5),
)
PARTS = (("chain", 60.0, 8), ("rope", 50.0, 6), ("chain", 30.0, 4))
ENDS = fixed(1, 0.0, 0.0, -70.0), coupled(2, 110.0, 10.0, -10.0)
DURATION = 4.0


def motion() -> Motion:
    time = np.linspace(0.0, DURATION + 1.0, 101)
    rise = np.clip(time / 2.0, 0.0, 1.0) ** 3
    moved = rise[:, None] * np.stack([2.0 * np.sin(2.0 * time), 0.5 * np.sin(time), np.sin(3.0 * time)], axis=1)
    return Motion.from_points(time, {2: np.array([110.0, 10.0, -10.0]) + moved})


def of_sections():
    return mooring(TYPES, ENDS, (line(1, 1, 2, *PARTS),), water_depth=70.0)


def of_lines(mass: float = 0.0):
    joints = free(3, 40.0, 0.0, -65.0, mass=mass), free(4, 85.0, 5.0, -40.0, mass=mass)
    lines = (line(1, 1, 3, PARTS[0]), line(2, 4, 3, (PARTS[1][0], PARTS[1][1], PARTS[1][2])), line(3, 4, 2, PARTS[2]))
    return mooring(TYPES, (*ENDS, *joints), lines, water_depth=70.0)


def states(model):
    """Static positions from end to end, forces on both ends at rest, and those of a run."""
    built = statics(model, motion(), tolerance=1e-5)
    parts = [nodes(built, k) for k in range(len(built.names.lines))]
    if len(parts) == 3:
        parts = [parts[0], parts[1][::-1][1:], parts[2][1:]]
    block = run(built, DURATION, time_step=0.02, dt_out=0.1, tolerance=1e-11)
    return np.concatenate(parts), block["point_force"][:, :2]


@pytest.fixture(scope="module")
def reference():
    return states(of_sections())


def check(reference, mass: float) -> None:
    positions, forces = states(of_lines(mass))
    size = np.abs(reference[1]).max()
    assert positions == pytest.approx(reference[0], abs=1e-6)
    assert np.abs(forces[0] - reference[1][0]).max() < 1e-8 * size
    assert np.abs(forces - reference[1]).max() < 1e-7 * size


def test_sections_are_joined_lines(reference):
    check(reference, 0.0)


def test_mass_at_the_joints_fails(reference):
    must_fail(check, reference, 1.0)
