"""A chain moved on a soil that is given by curves, there and back, along itself and across.

Verifies: soil_curves, friction, table

All nodes are held (a chain of lines of one segment each) and moved together, slowly and without drag, so that the pull
is w L c(d), c the curve. The way goes out by d0, beyond the end D of the curve, back to where it began, and out again. A
node remembers a place; slipping takes it along at the distance D. Back from d0 the force is therefore

    -w L c(D - (d0 - d))  while d0 - d < D,   and on the other side   w L c(min(D, (d0 - d) - D)).

Without slip the way back is the way out. The chain's weight is on its nodes exactly; it is moved over 40 s with a C2
path, whose inertia, m L a = 1.4 N at most, is 3e-5 of w L. Steps end at the records, between which forces are linear. The pull must be
met to 2e-4 of w L.

Curves that are exchanged must be noticed.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import at_rest, coupled, curve, kind, line, mooring, run, weight_in_water

from moorage.model import Friction, Motion

CHAIN = kind(diameter=0.1, mass_per_length=100.0, axial_stiffness=1e8, axial_damping_ratio=1.0)
LENGTH, DEPTH, PIECES, T = 50.0, 100.0, 5, 40.0
WEIGHT = weight_in_water(CHAIN) * LENGTH
LEVEL = -DEPTH - weight_in_water(CHAIN) / (3e6 * CHAIN.diameter)
AXIAL = curve((0.0, 0.0), (0.01, 0.3), (0.04, 0.5))
TRANSVERSE = curve((0.0, 0.0), (0.02, 0.4), (0.1, 0.9))


def smooth(part):
    part = np.clip(part, 0.0, 1.0)
    return part**3 * (10.0 - 15.0 * part + 6.0 * part**2)


def moved(way: float, angle: float, axial=AXIAL, transverse=TRANSVERSE):
    """Displacement (m) and pull (over w L, in x and y) of a chain that goes out, back and out again."""
    time = np.arange(0.0, 3.0 * T + 1.0, 0.25)
    path = way * (smooth(time / T) - smooth(time / T - 1.0) + smooth(time / T - 2.0))
    towards = np.array([np.cos(angle), np.sin(angle), 0.0])
    places = np.linspace([0.0, 0.0, LEVEL], [LENGTH, 0.0, LEVEL], PIECES + 1)
    motion = Motion.from_points(time, {k: p + path[:, None] * towards for k, p in enumerate(places, 1)})
    lines = [line(k, k, k + 1, (CHAIN.name, LENGTH / PIECES, 1)) for k in range(1, PIECES + 1)]
    points = [coupled(k, *p) for k, p in enumerate(places, 1)]
    friction = Friction(model="soil-curves", axial_curve=axial, transverse_curve=transverse)
    built = at_rest(mooring(CHAIN, points, lines, water_depth=DEPTH, friction=friction), motion)
    block = run(built, 3.0 * T, dt_out=0.5, dt_nodes=0.5, time_step=0.05)
    return block["point_position"][:, 0] @ towards, block["friction_force"].sum(axis=1)[:, :2] / WEIGHT


def play(way: np.ndarray, c) -> np.ndarray:
    """Coefficient along a way, by a place that is taken along at the end of the curve."""
    end, place, out = c.x[-1], 0.0, []
    for d in way:
        place = min(max(place, d - end), d + end)
        out.append(np.sign(d - place) * np.interp(abs(d - place), c.x, c.y))
    return np.array(out)


def check(way: float, angle: float, axial=AXIAL, transverse=TRANSVERSE) -> None:
    d, pull = moved(way, angle, axial, transverse)
    assert -pull[:, 0] == pytest.approx(play(d * np.cos(angle), AXIAL), abs=2e-4)
    assert -pull[:, 1] == pytest.approx(play(d * np.sin(angle), TRANSVERSE), abs=2e-4)


@pytest.mark.parametrize("way", [0.03, 0.3])
@pytest.mark.parametrize("angle", [0.0, 0.7, np.pi / 2.0])
def test_pull_follows_the_curves_there_and_back(way, angle):
    check(way, angle)


def test_exchanged_curves_are_noticed():
    must_fail(check, 0.3, 0.7, TRANSVERSE, AXIAL)


def test_work_of_a_loop_is_that_of_slipping():
    """Out, back and out by 0.3 m along the chain: c(D) w L over the way that slips, and the curve's energy once."""
    d, pull = moved(0.3, 0.0)
    work = -np.trapezoid(pull[:, 0], d)
    stored = np.trapezoid(AXIAL.y, AXIAL.x)
    slips = (0.3 - AXIAL.x[-1]) + 2.0 * (0.3 - 2.0 * AXIAL.x[-1])
    assert work == pytest.approx(AXIAL.y[-1] * slips + stored, rel=5e-3)
