"""A clamp that a coupled body carries and turns: rods on bodies, and coupled rods.

Verifies: bending

A cantilever in vacuum whose root is moved and turned by the platform. For the cable as a whole, as in
test_clamp_balance.py, the momentum and the moment of momentum about a fixed origin change by what the root gives and
the weight. Their integrals over 2 s of a motion in all six directions must hold to the second order of the step. A clamp
that does not turn with the body must not: its cable ends elsewhere. Turned so slowly that nothing swings, the cable must
be where statics find it with the clamp turned at once; and a rod that is coupled itself must do as one on a coupled
body, to rounding.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import VACUUM, beam, sections, turned
from common import must_fail, rate
from moorings import GRAVITY, clamp, free, held, line, mooring, nodes, run, statics

from moorage.model import Body, Motion
from moorage.solve.statics import solve
from moorage.system.build import build

LENGTH, EI, ARM = 6.0, 2e4, np.array([2.0, 0.5, -3.0])
AHEAD = np.eye(3)
CABLE = beam(EI, mass_per_length=15.0, axial_stiffness=1e6, axial_damping_ratio=0.3)


def model(hold: str, turn=AHEAD, weight: float = GRAVITY):
    """A cable along x from a rod: on the coupled body at the origin, coupled itself, or fixed and turned with its arm."""
    rod = clamp(1, turn @ ARM, turn @ [1.0, 0.0, 0.0])
    kind = "coupled" if hold == "coupled" else "fixed"
    rod = dataclasses.replace(rod, kind=kind, body=1 if hold == "body" else None)
    tip = free(1, *(turn @ (ARM + LENGTH * AHEAD[0])), mass=20.0)
    cable = dataclasses.replace(line(1, held(rod, "B"), 1), sections=sections(("beam", LENGTH, 12)))
    system = mooring(CABLE, (tip,), (cable,), (rod,), **(VACUUM | {"gravity": weight}))
    bodies = (Body(id=1, kind="coupled", position=(0.0, 0.0, 0.0)),) if hold == "body" else ()
    return dataclasses.replace(system, bodies=bodies)


def shaking(duration: float, **more) -> Motion:
    modes = {"surge": (0.3, 1.7), "heave": (0.2, 1.1), "roll": (0.3, 2.3), "pitch": (0.4, 1.3), "yaw": (0.5, 1.9)}
    return Motion.from_harmonics(duration + 1.0, ramp=1.0, interval=0.01, **(modes | more))


def moved(hold: str, step: float, motion: Motion, duration: float = 2.0):
    built = build(model(hold), motion, duration)
    solve(built)
    return run(built, duration, time_step=step, dt_out=step, dt_nodes=step, tolerance=1e-9), built


def missing(step: float, with_moment: bool) -> np.ndarray:
    """What is missing in the two balances over 2 s, over the largest momentum and its moment."""
    block, built = moved("body", step, shaking(2.0))
    r, v = block["node_position"], block["node_velocity"]
    n = r.shape[1]
    mass = built.system.morison.mass[:n] + np.eye(n)[-1] * 20.0
    p, W = mass[:, None] * v, -GRAVITY * mass[:, None] * [0.0, 0.0, 1.0]
    force, moment = block["end_force"][:, 0, 0], block["end_moment"][:, 0, 0]
    push = W.sum(axis=0) - force
    turn = np.cross(r, W).sum(axis=1) - np.cross(r[:, 0], force) - (moment if with_moment else 0.0)
    errors = []
    for given, held_now in ((push, p.sum(axis=1)), (turn, np.cross(r, p).sum(axis=1))):
        given = step * (given.sum(axis=0) - 0.5 * (given[0] + given[-1]))
        errors.append(np.abs(given - held_now[-1] + held_now[0]).max() / np.abs(held_now).max())
    return np.array(errors)


def check_balance(with_moment: bool) -> None:
    steps = np.array([8e-3, 4e-3, 2e-3])
    errors = np.array([missing(step, with_moment) for step in steps])
    assert (errors[-1] < 1e-3).all(), f"{errors}"
    assert (np.array([rate(steps, column) for column in errors.T]) > 1.7).all(), f"{errors}"


def test_balance_in_motion():
    check_balance(True)


def test_balance_without_the_moment_fails():
    must_fail(check_balance, False)


def test_coupled_rod_is_a_rod_on_a_coupled_body():
    motion = shaking(2.0)
    one, other = moved("body", 0.01, motion)[0], moved("coupled", 0.01, motion)[0]
    for name in ("node_position", "end_force", "end_moment"):
        assert np.abs(one[name] - other[name]).max() < 1e-8 * np.abs(one[name]).max(), name


def check_slow(hold: str) -> None:
    """Half a radian about a skew axis within 40 s; the first mode's period is below a second."""
    angles = np.array([0.3, -0.4, 0.2])
    time = np.linspace(0.0, 60.0, 601)
    share = np.clip(time / 40.0, 0.0, 1.0)
    share = share**3 * (10.0 - 15.0 * share + 6.0 * share**2)
    motion = Motion.from_platform(time, np.concatenate([np.zeros((601, 3)), share[:, None] * angles], axis=1))
    built = build(model(hold), motion, 50.0)
    solve(built)
    block = run(built, 50.0, time_step=0.02, dt_out=1.0, dt_nodes=50.0, tolerance=1e-7)
    turn = turned(0.3, (1, 0, 0)) @ turned(-0.4, (0, 1, 0)) @ turned(0.2, (0, 0, 1))
    still = statics(model("fixed", turn))
    assert np.abs(block["node_position"][-1] - nodes(still)).max() < 1e-3 * LENGTH


@pytest.mark.parametrize("hold", ["body", "coupled"])
def test_turned_slowly(hold):
    check_slow(hold)


def test_clamp_that_does_not_turn_fails():
    must_fail(check_slow, "fixed")
