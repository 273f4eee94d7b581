"""MoorDyn-F's regression cases with rods and bodies, from its stored results; each difference is shown to be one.

* md_no_line, md_horizontal: a pinned rod that swings in water, a free one that sinks across: the same physics.
* md_float: a float that is let go at 45 degrees. `planar_float` has its equations twice, without any of Moorage. With
  MoorDyn-F's rules they give its results to the digits that it prints, with ours ours, to what their nodes and steps
  differ by. Its waterplane turns the float upright a tenth too strongly (a cut cylinder has a closed form), and the
  centripetal forces that it counts twice press the float up.
* md_BodiesAndRods: a body of 1000 t with rods of 10 m in diameter falls 2 m until the water takes it. MoorDyn-F reads the
  columns of line types by their place (Cd Ca CdAx CaAx), whatever their heading says; ours go by the heading, which in
  this file is Can Cat Cdn Cdt. With its numbers the tensions are the same until the rods reach the water, and then part
  with the rods' rules: see `test_bodies_and_rods`.
* md_lineFail: a free rod between four lines that come off its ends and a point one after another. Line 3 holds 2 MN, more
  than the 100 kN of its failure, which MoorDyn-F therefore has at once: here it is one at 1 ms.
"""

from __future__ import annotations

import dataclasses
import functools

import numpy as np
import pytest
from beside import read
from planar_float import FLOAT, RHO, START, G, loads, run

from moorage.solve.march import March, Settings
from moorage.solve.statics import rest, solve
from moorage.system.build import build, releases_of

pytestmark = pytest.mark.peers
DURATION = 6.0  # of the float, s
equations = functools.cache(run)


def stored(reference, case: str) -> dict[str, np.ndarray]:
    path = reference / "r-test" / case / "regenerated.csv"
    names = path.read_text("utf-8").splitlines()[0].split(",")
    return dict(zip(names, np.loadtxt(path, delimiter=",", skiprows=1).T, strict=True))


def ours(reference, case: str, duration: float, change=lambda model: model) -> dict[str, np.ndarray]:
    """Records of a run that starts as given, each 0.1 s, from time 0."""
    built = build(change(dataclasses.replace(read(reference / "r-test" / case / "moordyn.dat"), outputs=())))
    rest(built)
    march = March(built, Settings(dt_out=0.1, tolerance=1e-4), duration)
    first, block = march.first(), march.advance(duration)
    return {name: np.concatenate([first[name], values]) for name, values in block.items()}


def error(time, values, theirs, name: str, until: float) -> float:
    """Rms of the difference over the rms of their values, at their times."""
    rows = theirs["Time"] <= until + 1e-9
    mine = np.interp(theirs["Time"][rows], time, values)
    return float(np.sqrt(np.mean((mine - theirs[name][rows]) ** 2) / np.mean(theirs[name][rows] ** 2)))


@pytest.mark.parametrize(
    ("case", "channel", "end", "axis"),
    [("md_no_line", "ROD1NBPX", 1, 0), ("md_no_line", "ROD1NBPZ", 1, 2), ("md_horizontal", "ROD1PZ", 0, 2)],
)
def test_rods(case, channel, end, axis, reference):
    theirs = stored(reference, case)
    until = float(theirs["Time"][-1])
    block = ours(reference, case, until)
    assert error(block["time"], block["rod_position"][:, 0, end, axis], theirs, channel, until) < 5e-3


def test_float_of_moordyn_in_its_own_equations(reference):
    """Steps of 1 ms (its own, second order) against 20 ms (fourth): 1e-4 degrees, 1e-6 m."""
    theirs = stored(reference, "md_float")
    time, states = equations(DURATION, moordyn_water=True, moordyn_kinematics=True)
    rows = theirs["Time"] <= DURATION
    pitch = np.degrees(np.interp(theirs["Time"][rows], time, states[:, 2]))
    assert np.abs(pitch - theirs["BODY1RY"][rows]).max() < 1e-3
    assert np.abs(np.interp(theirs["Time"][rows], time, states[:, 1]) - theirs["BODY1PZ"][rows]).max() < 1e-5


def float_errors(block, moordyn_water: bool, moordyn_kinematics: bool) -> tuple[float, float]:
    """Rms differences of our run to the equations with either's rules: pitch in degrees, heave in m."""
    time, states = equations(DURATION, moordyn_water=moordyn_water, moordyn_kinematics=moordyn_kinematics)
    pitch = block["body_rotation"][:, 0, 1] - np.interp(block["time"], time, states[:, 2])
    heave = block["body_position"][:, 0, 2] - np.interp(block["time"], time, states[:, 1])
    return float(np.degrees(np.sqrt(np.mean(pitch**2)))), float(np.sqrt(np.mean(heave**2)))


def test_float_of_ours_in_its_own_equations(reference):
    """With both of our rules it is ours; either rule of MoorDyn-F makes a difference of ten times that and more."""
    block = ours(reference, "md_float", DURATION)
    pitch, heave = float_errors(block, moordyn_water=False, moordyn_kinematics=False)
    assert pitch < 0.05
    assert heave < 0.005
    assert float_errors(block, moordyn_water=True, moordyn_kinematics=False)[0] > 2.0
    assert float_errors(block, moordyn_water=False, moordyn_kinematics=True)[1] > 0.1


def test_float_turns_upright_as_a_cut_cylinder_does():
    """Moments about the reference point at 10 degrees, at rest, near the draught at which it floats."""
    state, tilt = START.copy(), np.radians(10.0)
    state[1:3] = -1.6, tilt
    can, weight = FLOAT
    area, mass = np.pi / 4.0 * can.diameter**2, [rod.mass * rod.length for rod in FLOAT]
    a = 1.6 / np.cos(tilt) - can.start  # wet length of the axis
    upright = RHO * G * area * (0.5 * a**2 + can.start * a + can.diameter**2 / 32.0 * (2.0 + np.tan(tilt) ** 2))
    volume = np.pi / 4.0 * weight.diameter**2 * weight.length
    moment = upright + (RHO * G * volume - G * mass[1]) * (weight.start + 0.5 * weight.length)
    moment = -np.sin(tilt) * (moment - G * mass[0] * (can.start + 0.5 * can.length))
    assert loads(state, False, False)[0][2] == pytest.approx(moment, rel=2e-3)
    assert loads(state, True, False)[0][2] / moment == pytest.approx(1.1, abs=0.015)


def by_place(model):
    """The model with the hydrodynamics of its line type as MoorDyn-F reads them: in the order Cd Ca CdAx CaAx."""
    (t,) = model.line_types
    order = t.transverse_added_mass, t.tangential_added_mass, t.transverse_drag, t.tangential_drag
    names = "transverse_drag", "transverse_added_mass", "tangential_drag", "tangential_added_mass"
    return dataclasses.replace(model, line_types=(dataclasses.replace(t, **dict(zip(names, order, strict=True))),))


def test_bodies_and_rods_until_the_water_takes_them(reference):
    theirs = stored(reference, "md_BodiesAndRods")
    block = ours(reference, "md_BodiesAndRods", 2.0, change=by_place)
    for k in range(3):
        tension = np.linalg.norm(block["end_load"][:, k, 1], axis=-1)
        assert error(block["time"], tension, theirs, f"FAIRTEN{k + 1}", 0.5) < 5e-3
    assert error(block["time"], block["body_position"][:, 0, 2], theirs, "BODY1PZ", 2.0) < 5e-3


def test_columns_by_their_heading_are_not_those_of_moordyn(reference):
    theirs = stored(reference, "md_BodiesAndRods")
    block = ours(reference, "md_BodiesAndRods", 0.5)
    tension = np.linalg.norm(block["end_load"][:, 0, 1], axis=-1)
    assert error(block["time"], tension, theirs, "FAIRTEN1", 0.5) > 0.5


def test_lines_that_come_off_a_rod(reference):
    """Rms of the difference over that of the way that the line ends go, in 20 s; from 10 s on they fall freely."""
    theirs = stored(reference, "md_lineFail")
    model = read(reference / "r-test" / "md_lineFail" / "moordyn.dat")
    model = dataclasses.replace(model, outputs=())
    built = build(model)
    solve(built)
    march = March(built, Settings(dt_out=0.1, dt_nodes=0.1), 20.0, releases_of(model, None, 20.0))
    first, block = march.first(), march.advance(20.0)
    assert first["end_tension"][0, 2, 1] > 1e5
    for k in (1, 2):
        end = block["node_position"][:, built.names.node_ptr[k + 1] - 1]
        for axis, letter in ((0, "X"), (2, "Z")):
            expected = np.interp(block["node_time"], theirs["Time"], theirs[f"LINE{k + 1}NBP{letter}"])
            rows = block["node_time"] < 19.95
            miss = np.sqrt(np.mean((end[rows, axis] - expected[rows]) ** 2))
            assert miss < 5e-3 * np.ptp(expected), (k, letter, miss / np.ptp(expected))
