"""r-test's md_BodiesAndRods over 60 s: why ours leaves MoorDyn-F's results once its rods reach the water, in numbers.

A body of 1000 t with a fixed and a pinned rod of 10 m in diameter falls into the water. It is no sensitivity: a start 1 mm
aside is 1 mm aside after 60 s, and a tolerance ten times as fine moves the body by 5 mm, while MoorDyn-F's is 0.4 m away
within 4 s. `planar_body` has the equations twice, without its lines, and without any of Moorage:

* with our rules, ours without lines comes out to 1 mm and 2e-4 degrees in 20 s (segments of 4 m, steps of 20 ms);
* with MoorDyn-F's rules, its own results: heave to 6 mm and pitch to 0.005 degrees in 6 s, once what the lines do (26 mm rms
  in 2 s, from our runs with and without them) is added;
* the water departs first. As end A of a rod dips in, MoorDyn-F takes the pressure on its face times the wet part of the
  half segment there: at 1 m, 0.46 of the buoyancy that is displaced. That is all of the 16 mm of the first second;
* the pin departs next, and is the larger part of both afterwards. MoorDyn-F gives the body the moment and the inertia of
  the pinned rod as if it were fixed to it. In 6 s ours is 0.34 m and 0.27 degrees rms off; with its pin alone 0.10 m and
  0.11 degrees, with its water as well 0.04 m (the lines) and 0.003 degrees;
* the centripetal force that it counts twice is nothing here: the body turns with less than 1 degree a second.
"""

from __future__ import annotations

import dataclasses
import functools

import numpy as np
import planar_body
import pytest
from planar_body import Rules
from test_rtest_objects import by_place, ours, stored

pytestmark = pytest.mark.peers
CASE, OURS, THEIRS = "md_BodiesAndRods", Rules(False, False, False), Rules(True, True, True)
equations = functools.cache(planar_body.run)


def without_lines(model):
    return dataclasses.replace(by_place(model), lines=())


def aside(model):
    body = dataclasses.replace(model.bodies[0], position=(1e-3, 0.0, 0.0))
    return dataclasses.replace(by_place(model), bodies=(body,))


def heave_pitch(block, time) -> np.ndarray:
    """Heave (m) and pitch (degrees) of a run of ours at some times, (2, n)."""
    values = block["body_position"][:, 0, 2], np.degrees(block["body_rotation"][:, 0, 1])
    return np.array([np.interp(time, block["time"], value) for value in values])


def by_equations(rules: Rules, time) -> np.ndarray:
    t, y = equations(20.0, rules)
    return np.array([np.interp(time, t, y[:, 1]), np.degrees(np.interp(time, t, y[:, 2]))])


def rms(values) -> np.ndarray:
    return np.sqrt(np.mean(values**2, axis=-1))


def their_motion(reference, until: float) -> tuple[np.ndarray, np.ndarray]:
    theirs = stored(reference, CASE)
    rows = theirs["Time"] <= until
    return theirs["Time"][rows], np.array([theirs["BODY1PZ"][rows], theirs["BODY1RY"][rows]])


def test_it_is_no_sensitivity(reference):
    first = ours(reference, CASE, 60.0, by_place)["body_position"][:, 0]
    moved = ours(reference, CASE, 60.0, aside)["body_position"][:, 0]
    assert np.linalg.norm(moved - first, axis=-1).max() < 2e-3
    time, z = their_motion(reference, 4.0)
    assert np.abs(np.interp(time, 0.1 * np.arange(len(first)), first[:, 2]) - z[0]).max() > 0.3


def test_ours_in_its_own_equations(reference):
    block = ours(reference, CASE, 20.0, without_lines)
    heave, pitch = rms(heave_pitch(block, block["time"]) - by_equations(OURS, block["time"]))
    assert heave < 2e-3
    assert pitch < 3e-4


def test_moordyn_in_its_own_equations(reference):
    time, theirs = their_motion(reference, 6.0)
    lines = heave_pitch(ours(reference, CASE, 6.0, by_place), time)
    lines -= heave_pitch(ours(reference, CASE, 6.0, without_lines), time)
    heave, pitch = rms(by_equations(THEIRS, time) + lines - theirs)
    assert heave < 0.02, heave
    assert pitch < 0.01, pitch


def test_water_departs_first_and_the_pin_makes_the_larger_part(reference):
    """Heave in the first second, then differences to MoorDyn-F's results in 6 s, with some of its rules."""
    first = np.linspace(0.0, 1.0, 51)
    early = {r: by_equations(r, first)[0] - by_equations(THEIRS, first)[0] for r in (OURS, Rules(True, False, False))}
    assert np.abs(early[OURS]).max() > 0.012
    assert np.abs(early[Rules(True, False, False)]).max() < 0.2 * np.abs(early[OURS]).max()
    time, theirs = their_motion(reference, 6.0)
    off = {rules: rms(by_equations(rules, time) - theirs) for rules in (OURS, THEIRS, Rules(True, False, True))}
    only_water = rms(by_equations(Rules(True, False, False), time) - theirs)
    only_pin = rms(by_equations(Rules(False, False, True), time) - theirs)
    assert (off[OURS] > [0.3, 0.25]).all()
    assert (only_water > 0.75 * off[OURS]).all()
    assert (only_pin < 0.5 * off[OURS]).all()
    assert off[THEIRS][1] < 0.01 < 0.2 * only_pin[1]
    assert off[Rules(True, False, True)] == pytest.approx(off[THEIRS], abs=0.01)


def test_a_face_that_dips_in_lifts_by_what_it_displaces_here():
    """An upright rod, 1 m of it wet: 80 t x g here, and 1 / 2.17 of that by MoorDyn-F's rule."""
    rod = planar_body.FIXED
    forces = [
        planar_body.rod_now(rod, np.array([0.0, -1.0]), np.zeros(2), 0.0, 0.0, moordyn).force[:, 1].sum()
        + rod.mass * rod.length * planar_body.G
        for moordyn in (False, True)
    ]
    displaced = planar_body.RHO * planar_body.G * np.pi / 4.0 * rod.diameter**2
    assert forces[0] == pytest.approx(displaced, rel=5e-3)  # summed over cells of 0.1 m
    assert forces[1] == pytest.approx(displaced / (rod.length / 6.0), rel=2e-3)
