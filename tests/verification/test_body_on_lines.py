"""Free bodies on lines: bridles, tethers, statics, momentum.

Verifies: rigid, tension

* A body of weight W hung by two lines of the angle b from the vertical: each holds W / (2 cos b) at the body, less what
  its own weight of 1e-4 kg/m adds; by two that go up from arms at +-c of its own it hangs level.
* Two bodies of mass m on a tether of mass m0 and stretched length S between them that go round their middle in vacuum:
  the tether holds m w^2 (S / 2 + c) at the bodies, c the arm from there to the body's centre, and everything keeps its
  momentum and angular momentum.
* The equilibrium that Newton finds for a free body is where it comes to rest.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail
from floats import AIR, VACUUM, body, floating, momenta, throw
from moorings import CHAIN, GRAVITY, again, at_rest, fixed, kind, line, run, statics

from moorage.model import Point

THREAD = kind("thread", diameter=1e-3, mass_per_length=1e-4, axial_stiffness=1e7)
ROPE = kind("rope", mass_per_length=2.0, axial_stiffness=1e6, axial_damping=1e4)


def on(id: int, carrier: int, *arm: float) -> Point:
    return Point(id=id, kind="fixed", position=arm, body=carrier)  # type: ignore[arg-type]


def check_bridle(spread: float) -> None:
    """Anchors 6 m apart and 4 m above the eyes of a body whose arms are 1 m: the lines lean by 2 m in 4 m."""
    hung = body(position=(0.0, 0.0, -24.5), centre_of_gravity=(0.0, 0.0, -0.2), rotation=(0.03, 0.05, 0.0))
    points = (fixed(1, -3.0, 0.0, -20.0), fixed(2, 3.0, 0.0, -20.0), on(3, 1, -1.0, 0.0, 0.5), on(4, 1, 1.0, 0.0, 0.5))
    length = np.hypot(2.0, 4.0)
    lines = (line(1, 1, 3, ("thread", length, 3)), line(2, 2, 4, ("thread", length, 3)))
    built = statics(floating((hung,), line_types=THREAD, environment=AIR, points=points, lines=lines), tolerance=1e-5)
    block = run(built, 0.1, dt_out=0.1)
    expected = 0.5 * 100.0 * GRAVITY * np.hypot(spread, 4.0) / 4.0
    assert block["end_tension"][0] == pytest.approx(expected * np.ones((2, 2)), rel=1e-4)
    assert block["body_rotation"][0, 0] == pytest.approx([0.0, 0.0, 0.0], abs=1e-6)
    assert block["body_position"][0, 0] == pytest.approx([0.0, 0.0, -24.5], abs=1e-3)


def test_bridle():
    check_bridle(2.0)


def test_a_bridle_from_the_middle_of_the_body_fails():
    must_fail(check_bridle, 3.0)


def dumbbell(tether: float, segments: int = 6, offset: float = 0.5):
    """Two bodies 10 m apart; their eyes are `offset` nearer to each other, or off the line between them."""
    bodies = tuple(body(k, position=(5.0 * x, 0.0, -50.0)) for k, x in ((1, -1.0), (2, 1.0)))
    points = (on(1, 1, offset, 0.0, 0.0), on(2, 2, -offset, 0.0, 0.0))
    lines = (line(1, 1, 2, ("rope", tether, segments)),)
    return floating(bodies, line_types=ROPE, environment=VACUUM, points=points, lines=lines)


def spun(w: float, model):
    """Everything goes round the vertical through the middle."""
    built = at_rest(model)
    for o, x in ((0, -5.0), (1, 5.0)):
        throw(built, (0.0, w * x, 0.0), (0.0, 0.0, w), o)
    n = built.names.node_ptr[-1]
    built.state.velocity[:n, 1] = w * built.state.position[:n, 0]
    return built


def check_tether(arm: float) -> None:
    """The unstretched length that holds 10 m between the bodies at 1 rad/s is known but for the tether's own inertia.

    m w^2 5 m = 500 N against 2 kg/m w^2 x: the tether's tension is 20 N more in its middle, to order (1 / 6)^2 of that.
    """
    w = 1.0
    T = 100.0 * w**2 * (4.5 + arm)
    tether = 9.0 / (1.0 + (T + 13.5) / 1e6)  # mean of 2 (4.5^2 - x^2) / 2 along it
    block = run(spun(w, dumbbell(tether)), 2.0, dt_out=0.1, time_step=0.005, tolerance=1e-8)
    force = np.linalg.norm(block["end_load"][:, 0, 1], axis=-1) - 1.5 * 1.0 * 4.5  # half a segment's inertia
    # stretch oscillates by what the start is out of balance
    assert force.mean() == pytest.approx(T, rel=5e-3)


def test_tether_between_two_moving_bodies():
    check_tether(0.5)


def test_a_tether_to_the_centres_fails():
    must_fail(check_tether, 0.0)


def check_momentum(inertia: float) -> None:
    """A rope that snaps taut at an angle pulls both bodies round; 1e-3 of the angular momentum is the step's."""
    model = dumbbell(8.8)
    points = (on(1, 1, 0.5, 0.3, 0.2), on(2, 2, -0.5, -0.1, 0.4))
    built = at_rest(dataclasses.replace(model, points=points))
    throw(built, (0.0, -2.0, 0.5), (0.1, 0.0, -0.5), 0)
    throw(built, (1.0, 3.0, 0.0), (0.0, 0.3, 1.0), 1)
    block = run(built, 5.0, dt_out=0.25, dt_nodes=0.25, time_step=0.0025, tolerance=1e-8)
    mass = built.system.morison.mass[: built.names.node_ptr[-1]]
    p, H = momenta(block, inertia * mass, 100.0, (10.0, 20.0, 35.0), (0.0, 0.0, -50.0))
    assert block["end_tension"].max() > 1e3
    assert np.abs(p - p[0]).max() < 1e-3 * np.abs(p[0]).max()
    assert np.abs(H - H[0]).max() < 1e-3 * np.abs(H[0]).max()


def test_momentum_and_angular_momentum():
    check_momentum(1.0)


def test_momenta_without_the_rope_fail():
    must_fail(check_momentum, 0.0)


def moored(offset: float):
    """A buoy of 12 kN net buoyancy on three chains, in a current's absence, `offset` from where it belongs."""
    buoy = body(
        position=(offset, 0.3 * offset, -20.0 + 0.5 * offset), mass=3e3, volume=10.0, inertia=(4e3, 4e3, 4e3),
        rotation=(0.1 * offset, -0.05 * offset, 0.08 * offset), centre_of_gravity=(0.0, 0.0, -0.8),
        drag_area=(8.0, 8.0, 8.0, 30.0, 30.0, 30.0), added_mass=(0.5, 0.5, 0.5, 0.0, 0.0, 0.0),
    )  # fmt: skip
    points, lines = [], []
    for k, angle in enumerate(np.radians([10.0, 130.0, 250.0])):
        x, y = np.cos(angle), np.sin(angle)
        points += [fixed(2 * k + 1, 60.0 * x, 60.0 * y, -60.0), on(2 * k + 2, 1, 1.5 * x, 1.5 * y, -1.0)]
        lines.append(line(k + 1, 2 * k + 1, 2 * k + 2, ("chain", 72.0, 6)))
    thick = dataclasses.replace(CHAIN, mass_per_length=40.0)
    return floating((buoy,), line_types=thick, environment={"water_depth": 60.0}, points=points, lines=lines)


def check_rest(drop: float) -> None:
    built = statics(moored(0.0), tolerance=1e-2)
    other = statics(moored(1.0), tolerance=1e-2)
    still = run(built, 0.1, dt_out=0.1)
    assert run(other, 0.1, dt_out=0.1)["body_position"][0, 0] == pytest.approx(still["body_position"][0, 0], abs=1e-4)
    assert np.abs(still["body_force"][0, 0]).max() < 0.1
    moved = throw(again(built), (0.3, 0.1, 0.2), (0.02, 0.05, -0.03))
    block = run(moved, 150.0, dt_out=50.0, tolerance=1e-3)
    last, x = block["body_position"][-1, 0], still["body_position"][0, 0]
    assert last == pytest.approx(x - [0.0, 0.0, drop], abs=0.02)
    assert block["body_rotation"][-1, 0] == pytest.approx(still["body_rotation"][0, 0], abs=0.01)


def test_a_free_body_in_statics_is_where_it_comes_to_rest():
    check_rest(0.0)


def test_another_place_of_rest_fails():
    must_fail(check_rest, 0.1)
