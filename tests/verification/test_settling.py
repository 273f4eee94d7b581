"""Statics are where damped dynamics come to rest.

Verifies: tension, weight, contact, point, morison, current, bending

Three systems start far from equilibrium, at rest, in a current (in still water quadratic drag lets motions die with 1
/ t only): chains with a float and a bridle; a slack line with a clump that lies partly on the bed; a cable with
bending stiffness. They run with a step of 0.5 s, whose numerical damping helps that of the water (what a scheme rests
at is an equilibrium whatever its step), until their speed is below 1e-9 m/s. Tensions must then be those of statics
within 1e-7 and positions within 0.01 mm. With 0.1 % more line the check must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import CHAIN, at_rest, end_tensions, fixed, free, kind, line, mooring, nodes, run, statics

from moorage.model import Current, Model

ROPE = kind("rope", diameter=0.15, mass_per_length=25.0, axial_stiffness=2e6, axial_damping_ratio=0.5, transverse_drag=1.5,
            tangential_drag=0.3)  # fmt: skip
CABLE = kind("cable", diameter=0.2, mass_per_length=60.0, axial_stiffness=5e7, axial_damping_ratio=0.5, transverse_drag=1.5,
             bending_stiffness=2e5)  # fmt: skip
STREAM = Current((-80.0, 0.0), ((0.2, 0.1, 0.0), (0.5, 0.4, 0.0)))


def bridle(longer: float) -> Model:
    """Three chains to a float in a current, and a rope from there to a point above."""
    anchors = [fixed(k + 1, 150.0 * np.cos(a), 150.0 * np.sin(a), -80.0) for k, a in enumerate((0.2, 2.1, 4.5))]
    ball = free(4, 10.0, -20.0, -50.0, mass=8e3, volume=20.0, drag_area=6.0, added_mass=0.5)
    lines = [line(k + 1, k + 1, 4, ("chain", 170.0 * longer, 12)) for k in range(3)]
    rope = line(4, 4, 5, ("rope", 60.0, 6))
    return mooring(
        (CHAIN, ROPE), (*anchors, ball, fixed(5, 0.0, 0.0, -5.0)), (*lines, rope), water_depth=80.0, current=STREAM
    )


def clump(longer: float) -> Model:
    """A slack line of chain, rope and chain with a clump between."""
    points = (
        fixed(1, 0.0, 0.0, -60.0),
        free(2, 70.0, 0.0, -50.0, mass=3e3, volume=0.4, drag_area=2.0),
        fixed(3, 120.0, 30.0, -3.0),
    )
    lines = line(1, 1, 2, ("chain", 85.0 * longer, 12)), line(2, 2, 3, ("chain", 20.0, 3), ("rope", 70.0, 8))
    return mooring((CHAIN, ROPE), points, lines, water_depth=60.0, current=STREAM)


def cable(longer: float) -> Model:
    """A stiff cable that hangs between two points."""
    return mooring(
        CABLE,
        (fixed(1, 0.0, 0.0, -40.0), fixed(2, 60.0, 0.0, -10.0)),
        (line(1, 1, 2, ("cable", 75.0 * longer, 25)),),
        current=STREAM,
    )


def settled(model: Model):
    """Tensions and node positions after a run from the first guess, shaken by up to 1 m."""
    built = at_rest(model)
    random = np.random.default_rng(0)
    inner = np.setdiff1d(
        np.arange(built.names.node_ptr[-1]), np.concatenate([built.names.node_ptr[:-1], built.names.node_ptr[1:] - 1])
    )
    built.state.position[inner] += random.uniform(-0.5, 0.5, (len(inner), 3))
    block = run(built, 4000.0, time_step=0.5, dt_out=2000.0, dt_nodes=2000.0, tolerance=1e-7)
    return (
        np.linalg.norm(block["end_force"][-1], axis=-1),
        block["node_position"][-1],
        np.abs(block["node_velocity"][-1]).max(),
    )


def check(make, longer: float = 1.0) -> None:
    tensions, positions, speed = settled(make(1.0))
    built = statics(make(longer), tolerance=1e-4)
    expected = np.concatenate([nodes(built, k) for k in range(len(built.names.lines))])
    assert speed < 1e-9, f"still moving at {speed} m/s"
    assert np.abs(tensions / end_tensions(built) - 1.0).max() < 1e-7
    assert np.abs(positions - expected).max() < 1e-5


CASES = {"bridle": bridle, "clump": clump, "cable": cable}


@pytest.mark.parametrize("name", CASES)
def test_statics_are_where_dynamics_come_to_rest(name):
    check(CASES[name])


@pytest.mark.parametrize("name", CASES)
def test_longer_line_fails(name):
    must_fail(check, CASES[name], 1.001)
