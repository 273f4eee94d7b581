"""The door for hosts: the mooring of a simulation, step by step, with the chance to try again."""

import copy
from pathlib import Path

import numpy as np
import pytest

import moorage
from moorage.model import Attachment, Environment, Line, LineType, Model, Point, Rod, RodType, Section

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4" / "oc4.dat"


@pytest.fixture
def sim():
    return moorage.Simulation(moorage.read(EXAMPLE))


def surge(time, amplitude=2.0, period=10.0):
    phase = 2.0 * np.pi * time / period
    x, v = amplitude * (1.0 - np.cos(phase)), amplitude * 2.0 * np.pi / period * np.sin(phase)
    return np.array([x, 0.0, 0.0]), np.array([v, 0.0, 0.0])


def test_starts_from_statics(sim):
    forces = sim.initialize()
    eq = moorage.solve_statics(sim.model)
    np.testing.assert_array_equal(sim.points, [4, 5, 6])
    np.testing.assert_allclose(forces, eq["point_force"].sel(point=[4, 5, 6]).values, rtol=1e-6)


def test_follows_a_run_with_the_same_motion(sim):
    sim.initialize()
    start, forces = sim.position, []
    times = 0.1 * np.arange(1, 101)
    for time in times:
        shift, velocity = surge(time)
        forces.append(sim.step(time, start + shift, np.tile(velocity, (3, 1))))
    assert sim.time == 10.0
    fine = np.linspace(0.0, 10.0, 401)
    motion = moorage.Motion.from_platform(fine, [[*surge(t)[0], 0.0, 0.0, 0.0] for t in fine])
    ds = moorage.simulate(sim.model, duration=10.0, motion=motion)
    expected = ds["point_force"].sel(point=[4, 5, 6]).values[1:]
    error = np.sqrt(np.mean((forces - expected) ** 2) / np.mean(expected**2))
    assert error < 0.01  # the accuracy of a run at the default tolerance


def test_restore_goes_back_bit_for_bit(sim):
    sim.initialize()
    shift, velocity = surge(0.5)
    state, target = sim.save(), sim.position + shift
    first = sim.step(0.5, target, np.tile(velocity, (3, 1)))
    sim.restore(state)
    assert sim.time == 0.0
    other = sim.step(0.5, target + 1.0, np.tile(velocity, (3, 1)))
    assert not np.allclose(first, other)
    sim.restore(state)
    np.testing.assert_array_equal(sim.step(0.5, target, np.tile(velocity, (3, 1))), first)


def test_what_cannot_be_is_refused(sim):
    with pytest.raises(moorage.SimulationError, match="initialize"):
        sim.step(0.1, sim.position, np.zeros((3, 3)))
    sim.initialize()
    with pytest.raises(moorage.SimulationError, match="time must increase"):
        sim.step(0.0, sim.position, np.zeros((3, 3)))
    with pytest.raises(moorage.SimulationError, match="3 x 3 finite numbers"):
        sim.step(0.1, sim.position[:2], np.zeros((3, 3)))
    with pytest.raises(moorage.InputError, match="tolerance"):
        moorage.Simulation(sim.model, tolerance=-1.0)


def test_a_clamp_beside_coupled_points_stays_where_it_is():
    cable = LineType(
        name="cable",
        diameter=0.2,
        mass_per_length=60.0,
        axial_stiffness=1e8,
        axial_damping_ratio=0.5,
        bending_stiffness=1e4,
    )
    model = Model(
        environment=Environment(water_depth=100.0),
        line_types=(cable,),
        rod_types=(RodType(name="clamp", diameter=0.2, mass_per_length=0.0),),
        rods=(Rod(id=1, rod_type="clamp", kind="fixed", end_a=(0.0, 0.0, -50.0), end_b=(0.0, 0.0, -49.0), segments=0),),
        points=(Point(id=1, kind="coupled", position=(30.0, 0.0, -20.0)),),
        lines=(
            Line(
                id=1,
                sections=(Section(line_type="cable", length=60.0, segments=30),),
                end_a=Attachment("rod", 1, "A"),
                end_b=Attachment("point", 1),
            ),
        ),
    )
    sim = moorage.Simulation(model)
    still = moorage.solve_statics(model)["point_force"].values
    np.testing.assert_allclose(sim.initialize(), still, rtol=1e-6)
    for time in (0.1, 0.2, 0.3):
        force = sim.step(time, sim.position, np.zeros((1, 3)))
    np.testing.assert_allclose(force, still, rtol=1e-6)


@pytest.mark.parametrize(
    ("time", "position", "words"),
    [
        (0.2, np.nan, "3 x 3 finite numbers .* NaN"),
        (0.2, np.inf, "3 x 3 finite numbers"),
        (0.1, 0.0, "time must increase"),
        (0.05, 0.0, "time must increase"),
        (np.nan, 0.0, "time must increase"),
        (0.2, 1e200, "stopped"),
    ],
)
def test_a_bad_call_leaves_the_state_as_it_was(sim, time, position, words):
    sim.initialize()
    sim.step(0.1, sim.position, np.zeros((3, 3)))
    before = sim.save()
    with pytest.raises(moorage.SimulationError, match=words):
        sim.step(time, np.full((3, 3), position), np.zeros((3, 3)))
    after = sim.save()
    assert before.keys() == after.keys()
    for name in before:
        np.testing.assert_array_equal(after[name], before[name], err_msg=name)
    assert sim.time == 0.1


def test_a_copy_goes_its_own_way(sim):
    """A host may try two futures: the copy has the same past, and what it does leaves the original alone."""
    rest, slow = sim.position.copy(), np.full_like(sim.position, 0.1)
    again = moorage.Simulation(moorage.read(EXAMPLE))
    for simulation in (sim, again):
        simulation.initialize()
        simulation.step(0.1, rest + 0.01, slow)
    twin = copy.deepcopy(sim)
    away = twin.step(0.2, rest + 1.0, 10.0 * slow)
    here = sim.step(0.2, rest + 0.02, slow)
    np.testing.assert_array_equal(again.step(0.2, rest + 0.02, slow), here)
    assert np.abs(away - here).max() > 1e3
