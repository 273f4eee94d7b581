"""What a clamp feels: force and moment of rod and cable balance, at rest and in motion.

Verifies: bending

Newton's and Euler's laws for the cable as a whole, about the origin, with the forces F and moments C of the cable on
what holds its ends, weights W_i at the nodes, and H = sum m_i r_i x v_i:

    sum F = sum W - d(sum m v) / dt,   sum (C + r x F) = sum r_i x W_i - dH / dt.

Inside, bends and clamps make no net force and no net moment, whatever the shape: to rounding. At rest the laws hold to
what statics leave, in motion to the second order of the step, with which the integrals over time are taken. Without the
moment C on the clamp's rod (MoorDyn-C never hands it over) they must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import VACUUM, at_once, beam, between, cantilever, sections
from common import must_fail, rate
from dense import MASS, STIFFNESS, assembled
from moorings import GRAVITY, free, held, joint, line, mooring, nodes, run, statics

from moorage.solve.statics import rest
from moorage.system.build import build

LENGTH, EI = 12.0, 2e4


def moment_about_origin(places, forces) -> np.ndarray:
    return np.cross(places, forces).sum(axis=0)


def clamped(flavour: str, spring: float | None = None):
    model = between(
        beam(EI, mass_per_length=15.0), sections(("beam", 5.0, 5), ("beam", 7.0, 4, 3.0)), (1.0, 2.0, -30.0),
        (0.8, 0.6, 0.0), (7.0, 5.0, -33.0), (0.0, 0.6, -0.8), end_b_stiffness=spring,
    )  # fmt: skip
    return dataclasses.replace(model, flavour=flavour)


@pytest.mark.parametrize("spring", [None, 3e4])
@pytest.mark.parametrize("flavour", ["native", "MoorDyn-C"])
def test_bends_and_clamps_are_in_balance_in_any_shape(flavour, spring):
    built = build(clamped(flavour, spring))
    rest(built)
    random = np.random.default_rng(4)
    n = built.names.node_ptr[-1]
    built.state.position[1 : n - 1] += random.normal(0.0, 0.4, (n - 2, 3))
    f = assembled(built, STIFFNESS)[1]
    moments = at_once(built)["end_moment"][0, 0]
    size = np.abs(f).max()
    assert np.abs(moments).max() > 1e2
    assert np.abs(f.sum(axis=0)).max() < 1e-12 * size
    assert np.abs(moment_about_origin(nodes(built), f) + moments.sum(axis=0)).max() < 1e-11 * size * 30.0


def check_rest(with_moment: bool) -> None:
    model = dataclasses.replace(clamped("native"))
    model = dataclasses.replace(model, environment=dataclasses.replace(model.environment, gravity=GRAVITY))
    built = statics(model, tolerance=1e-4)
    block, r = at_once(built), nodes(built)
    weight = built.system.weight.dry[: len(r), None] * [0.0, 0.0, 1.0]
    force, moment = block["end_force"][0, 0], block["end_moment"][0, 0]
    assert force.sum(axis=0) == pytest.approx(weight.sum(axis=0), abs=1e-3)
    total = moment_about_origin(r[[0, -1]], force) + (moment.sum(axis=0) if with_moment else 0.0)
    assert total == pytest.approx(moment_about_origin(r, weight), abs=0.1)  # 30 m times what statics leave


def test_at_rest():
    check_rest(True)


def test_at_rest_without_the_moment_fails():
    must_fail(check_rest, False)


def let_go(step: float):
    """A cantilever that is let go straight: places, velocities, reactions; and the masses of its nodes."""
    environment = {"gravity": GRAVITY, "water_density": 0.0}
    cable = beam(EI, mass_per_length=15.0, axial_stiffness=1e7, axial_damping_ratio=0.3)
    model = cantilever(cable, sections(("beam", LENGTH, 12)), (0.0, 30.0, 0.0), environment=environment)
    built = build(model)
    rest(built)
    n = built.names.node_ptr[-1]
    built.state.position[:n] = np.linspace(0.0, LENGTH, n)[:, None] * [1.0, 0.0, 0.0]
    block = run(built, 1.0, time_step=step, dt_out=step, dt_nodes=step, tolerance=1e-9)
    return block, built.system.morison.mass[:n]


def impulse(values, step: float) -> np.ndarray:
    """Integral over time of records, by the trapezoidal rule."""
    return step * (values.sum(axis=0) - 0.5 * (values[0] + values[-1]))


def missing(step: float, with_moment: bool) -> np.ndarray:
    """What is missing in the balance of momentum and of angular momentum over 1 s, N s and N m s."""
    block, mass = let_go(step)
    r, v = block["node_position"], block["node_velocity"]
    weight = -GRAVITY * mass[:, None] * [0.0, 0.0, 1.0]
    pull = np.array([0.0, 30.0, 0.0])  # on the tip
    momentum = (mass[:, None] * v).sum(axis=1)
    angular = np.cross(r, mass[:, None] * v).sum(axis=1)
    force = weight.sum(axis=0) + pull - block["end_force"][:, 0, 0]
    moment = np.cross(r, weight).sum(axis=1) + np.cross(r[:, -1], pull)
    if with_moment:
        moment = moment - block["end_moment"][:, 0, 0]
    errors = impulse(force, step) - momentum[-1], impulse(moment, step) - angular[-1]
    return np.array([np.abs(error).max() for error in errors])


def check_motion(with_moment: bool) -> None:
    steps = np.array([4e-3, 2e-3, 1e-3])
    errors = np.array([missing(step, with_moment) for step in steps])
    block, mass = let_go(1e-3)
    moved = np.abs((mass[:, None] * block["node_velocity"][-1]).sum(axis=0)).max()
    assert errors[-1, 0] < 1e-4 * moved
    assert errors[-1, 1] < 1e-4 * moved * LENGTH
    assert (np.array([rate(steps, column) for column in errors.T]) > 1.7).all(), f"{errors}"


def test_in_motion():
    check_motion(True)


def test_in_motion_without_the_moment_fails():
    must_fail(check_motion, False)


def tumbling(step: float) -> tuple[np.ndarray, float]:
    """Angular momentum over time of two bent cables joined by a rod, free in vacuum, and its size in parts."""
    rod = joint(1, 0.0, 0.0, -50.0)
    ends = free(1, -6.0, 0.0, -50.0), free(2, 6.0, 0.0, -50.0)
    cables = (
        beam(EI, "one", axial_stiffness=1e6, mass_per_length=15.0),
        beam(5e4, "two", axial_stiffness=1e6, mass_per_length=25.0),
    )
    lines = line(1, 1, held(rod, "A"), ("one", 6.0, 6)), line(2, held(rod, "B"), 2, ("two", 6.0, 5))
    built = build(mooring(cables, ends, lines, (rod,), **VACUUM))
    rest(built)
    a, b = built.names.node_ptr[1:3]
    n = built.names.node_ptr[-1]
    built.state.position[:a] = np.array([0.0, 0.0, -50.0]) + np.linspace(-6.0, 0.0, a)[:, None] * [0.9, 0.3, 0.3]
    built.state.position[a:b] = np.array([0.0, 0.0, -50.0]) + np.linspace(0.0, 6.0, b - a)[:, None] * [0.9, 0.0, -0.4]
    spin = np.array([0.5, -1.0, 2.0])
    built.state.position[n : n + 3] = built.state.position[[0, b - 1, a]]
    built.state.velocity[: n + 3] = np.cross(spin, built.state.position[: n + 3] - [0.0, 0.0, -50.0])
    block = run(built, 2.0, time_step=step, dt_out=0.1, dt_nodes=0.1, tolerance=1e-10)
    mass = assembled(built, MASS)[0].diagonal()[::3]
    r, p = block["node_position"] - [0.0, 0.0, -50.0], mass[:, None] * block["node_velocity"]
    H = np.cross(r, p)
    return H.sum(axis=1), float(np.linalg.norm(H, axis=2).sum(axis=1).max())


def test_free_pair_of_cables_keeps_its_angular_momentum():
    """To the second order of the step; a joint that is left out of the balance would feed it EI / l rad each second."""
    steps = np.array([4e-3, 2e-3, 1e-3])
    drifts = []
    for step in steps:
        H, size = tumbling(step)
        drifts.append(np.abs(H - H[0]).max() / size)
    assert drifts[-1] < 1e-4
    assert rate(steps, drifts) > 1.7, f"{drifts}"
