"""A current that changes with time and place: what the engine takes from a grid, and what it makes of it.

Verifies: current

Field. The engine's velocity is compared with an interpolation in NumPy, within the grid, on its points and beyond its
edges, for axes turned against the model's: rounding of 16 products, 1e-12.

Pole. A taut vertical line without weight in water stands in a current that is uniform in depth, rises with x and y and
changes with time. Its foot and its top each carry half of 0.5 rho Cd d L |u| u at once: fluid accelerations are
left out, and the line is so stiff (it deflects by 2 mm, first natural period 0.2 s) that it follows the water to 1e-4.
Each corner of the current over time makes it ring with about 1 % of the load, which drag damps as exp(-0.8 t); from 6 s
after a corner on less than 1e-3 is left.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail
from hypothesis import given, settings
from hypothesis import strategies as st
from moorings import DENSITY, fixed, kind, run, single, statics

from moorage.model import Current, CurrentGrid
from moorage.physics.current import current_at
from moorage.solve.statics import solve
from moorage.system.build import build
from moorage.system.sea import build_current

RANDOM = np.random.default_rng(2)
T, X, Y, Z = (0.0, 3.0, 10.0), (-50.0, 0.0, 10.0, 40.0), (-20.0, 30.0), (-60.0, -20.0, -5.0, 0.0)
FIELD = CurrentGrid(t=T, x=X, y=Y, z=Z, velocity=RANDOM.normal(size=(3, 4, 2, 4, 3)), turn=0.4)


def check_field(theirs: CurrentGrid, t: float, place: tuple[float, float, float]) -> None:
    assert current_at(build_current(FIELD), place, t) == pytest.approx(theirs.at(t, place), abs=1e-12)


@settings(max_examples=60, deadline=None)
@given(
    st.floats(-5.0, 15.0) | st.sampled_from(T),
    st.floats(-80.0, 80.0) | st.just(0.0),
    st.floats(-80.0, 80.0) | st.just(0.0),
    st.floats(-80.0, 10.0) | st.sampled_from(Z),
)
def test_field(t, x, y, z):
    check_field(FIELD, t, (x, y, z))


def test_field_is_that_of_its_points():
    turned = np.array([np.cos(0.4) * 10.0 - np.sin(0.4) * 30.0, np.sin(0.4) * 10.0 + np.cos(0.4) * 30.0, -20.0])
    assert FIELD.at(3.0, turned) == pytest.approx(FIELD.velocity[1, 2, 1, 1], abs=1e-12)
    assert FIELD.at([0.0, 10.0], [[-1e3, -1e3, -1e3]] * 2) == pytest.approx(FIELD.velocity[[0, 2], 0, 0, 0], abs=1e-12)


def test_axes_turned_the_other_way_fail():
    must_fail(check_field, dataclasses.replace(FIELD, turn=-0.4), 2.0, (10.0, 5.0, -10.0))


@pytest.mark.parametrize("vary", ["t", "x", "y"])
def test_one_axis_is_enough(vary):
    axis = {vary: (0.0, 2.0)}
    shape = [2 if name == vary else 1 for name in "txy"]
    grid = CurrentGrid(**axis, z=(-10.0, 0.0), velocity=RANDOM.normal(size=(*shape, 2, 3)))
    r = (1.5, 1.5, -4.0)
    assert current_at(build_current(grid), r, 1.5) == pytest.approx(grid.at(1.5, r), abs=1e-12)


def test_a_profile_is_a_grid_of_one_column():
    levels, velocity = (-10.0, 0.0), ((0.1, 0.2, 0.0), (1.0, -1.0, 0.3))
    grid = CurrentGrid(z=levels, velocity=np.array(velocity).reshape(1, 1, 1, 2, 3))
    for z in (-12.0, -3.0, 4.0):
        found = current_at(build_current(Current(levels, velocity)), (5.0, 6.0, z), 7.0)
        assert found == pytest.approx(grid.at(0.0, (0.0, 0.0, z)), abs=1e-15)


D, LENGTH, CD = 0.5, 50.0, 1.1
AXIS = (-100.0, 100.0)
FACTOR = np.array([[0.8, 0.9], [1.1, 1.2]])  # over x and y
TIMES, SPEEDS = (0.0, 20.0, 35.0), np.array([0.2, 1.0, 0.5])
LOOK = 0.5 * np.arange(71)  # s, and those of them that are not just after a corner
CALM = ((LOOK > 6.0) & (LOOK <= 20.0)) | (LOOK > 26.0)


def pole_forces(start: float) -> np.ndarray:
    """Forces in x on both ends of a pole at (30, -20), (n, 2), in the current from a time on."""
    flow = SPEEDS[:, None, None, None] * FACTOR[None, :, :, None]
    velocity = np.stack([flow, 0.0 * flow, 0.0 * flow], axis=-1)
    current = CurrentGrid(t=tuple(np.array(TIMES) - start), x=AXIS, y=AXIS, velocity=velocity)
    pole = kind(
        diameter=D, mass_per_length=DENSITY * np.pi / 4.0 * D * D, axial_stiffness=1e11, transverse_drag=CD,
        transverse_added_mass=1.0, axial_damping_ratio=0.5,
    )  # fmt: skip
    ends = fixed(1, 30.0, -20.0, -55.0), fixed(2, 30.0, -20.0, -5.0)
    built = statics(single(pole, LENGTH / 1.001, 10, *ends, water_depth=60.0, current=current))
    return run(built, 35.0, dt_out=0.5, time_step=0.05, tolerance=1e-6)["end_force"][:, 0, :, 0]


def check_pole(start: float) -> None:
    across = 0.5 * np.array([1.0 - 0.3, 1.0 + 0.3]) @ FACTOR @ np.array([1.0 + 0.2, 1.0 - 0.2]) * 0.5
    u = across * np.interp(LOOK, TIMES, SPEEDS)
    closed = 0.25 * DENSITY * CD * D * LENGTH / 1.001 * np.abs(u) * u
    assert np.abs(pole_forces(start) - closed[:, None])[CALM].max() < 1e-3 * np.abs(closed).max()


def test_pole_in_a_current_that_turns():
    check_pole(0.0)


def test_current_of_another_time_fails():
    must_fail(check_pole, 2.0)


def test_statics_are_of_time_zero():
    grid = CurrentGrid(
        t=(-10.0, 10.0), velocity=np.array([0.0, 1.0]).reshape(2, 1, 1, 1, 1) * np.array([1.0, 0.0, 0.0])
    )
    rope = kind(transverse_drag=1.0)
    ends = fixed(1, 0.0, 0.0, -50.0), fixed(2, 30.0, 0.0, 0.0)
    one, other = (
        build(single(rope, 65.0, 10, *ends, current=current)) for current in (grid, Current((0.0,), ((0.5, 0.0, 0.0),)))
    )
    solve(one)
    solve(other)
    assert np.abs(one.state.position - other.state.position).max() < 1e-9
