"""Tension along a chain that lies on the bed and is pulled at one end: to where it sticks, and back and forth.

Verifies: friction, contact, tension

A chain of stiffness EA is laid without tension, and its end is moved slowly along it. Friction is a spring k = k_s d to
mu w for each metre ("elastic-slip"). With l = sqrt(EA / k) the reach of the spring and T1 = mu w l the end force at which
slip begins, the tension at a distance s from the end under T0 is

    T = T0 - mu w s                       where it has slipped, s < (T0 - T1) / (mu w)
    T = T1 exp(-(s - s1) / l)             beyond, s1 = (T0 - T1) / (mu w)

and the end has come by f(T0) = (T0^2 + T1^2) / (2 EA mu w) (T0 l / EA before it slips). Such a row of springs with
sliders follows Masing's rule (1926): from a turning point on, the changes of displacement and force are twice f and twice its
argument. Between forces T0 and T0 - D the loop takes, for each cycle, the energy of the closed integral

    2 D f(D / 2) - 8 int_0^{D/2} f(x) dx      (D^3 / (12 EA mu w) for l = 0),

the work of friction. On nodes h apart the force of friction comes in lumps: an error of h^2, so that errors must fall with at least h^1.5, and be below 0.5 % on 80 segments. Tensions are asked for in
the middle of segments, to 0.5 % of the largest. The pull is slow: 60 s a way, 200 times the time of a wave.

Laid statics (`laid=True`) pull the chain into place at once: there T = T0 - mu w s too. On waves of the bed (2 m high,
200 m long: slopes up to 3.6 degrees) a taut chain that follows them changes its tension by mu w cos a - w sin a for a metre,
and between crests of the same level by mu w times the way along x, less what the tension presses: N = w cos a + T k with
the curvature k, whose integral from crest to crest is 0 to first order, so that 3 % are left for T k (5 % of mu w here) and
the knees of a segment. It is the same whichever end is A. Before, the first guess knew no valleys, and friction pushed.

Saturated damping has no memory: held still, all friction is gone within seconds.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail, rate
from moorings import at_rest, coupled, fixed, kind, line, mooring, run, single, statics, weight_in_water

from moorage.model import Bathymetry, Friction, Motion
from moorage.solve.march import March, Settings

EA, MU, LENGTH, DEPTH, SHEAR = 2e7, 0.5, 200.0, 100.0, 2e7
CHAIN = kind(diameter=0.1, mass_per_length=100.0, axial_stiffness=EA, axial_damping_ratio=1.0)
RUB = MU * weight_in_water(CHAIN)  # N/m
LEVEL = -DEPTH - weight_in_water(CHAIN) / (3e6 * CHAIN.diameter)
REACH = np.sqrt(EA / (SHEAR * CHAIN.diameter))
SLIP = RUB * REACH
PULL, LOW = 150.0 * RUB, 30.0 * RUB  # N: slips over 150 m less the reach


def come(force: float) -> float:
    """f: displacement of the end by the first pull, m."""
    return (force**2 + SLIP**2) / (2.0 * EA * RUB) if force > SLIP else force * REACH / EA


def area(depth: float) -> float:
    """Energy of one loop, J."""
    x = np.linspace(0.0, 0.5 * depth, 20001)
    return float(2.0 * depth * come(0.5 * depth) - 8.0 * np.trapezoid([come(xi) for xi in x], x))


WAY, BACK = come(PULL), 2.0 * come(0.5 * (PULL - LOW))
QUARTER = 60.0  # s a way


def path() -> tuple[np.ndarray, np.ndarray]:
    """The end goes out, half back, out, half back and out again, smoothly."""
    turns = [0.0, WAY, WAY - BACK, WAY, WAY - BACK, WAY]
    time = np.arange(0.0, QUARTER * 5 + 2.0, 0.5)
    k = np.minimum((time // QUARTER).astype(int), 4)
    part = np.clip(time / QUARTER - k, 0.0, 1.0)
    smooth = part**3 * (10.0 - 15.0 * part + 6.0 * part**2)
    return time, np.array(turns)[k] + smooth * np.diff(turns)[k]


def model(segments: int, law: str, **properties):
    friction = Friction(
        **({"axial": MU, "transverse": MU, "model": law, "shear_stiffness": SHEAR, "damping": 1e5} | properties)
    )
    ends = fixed(1, 0.0, 0.0, LEVEL), coupled(2, LENGTH, 0.0, LEVEL)
    return single(CHAIN, LENGTH, segments, *ends, water_depth=DEPTH, friction=friction)


def cycled(segments: int, law: str = "elastic-slip", **properties):
    """Force and way of the end (N, m), tensions, and those at the turns."""
    time, way = path()
    motion = Motion.from_points(time, {2: np.array([LENGTH, 0.0, LEVEL]) + way[:, None] * [1.0, 0.0, 0.0]})
    built = at_rest(model(segments, law, **properties), motion)
    block = run(built, QUARTER * 5, dt_out=0.25, dt_nodes=0.25, tolerance=1e-5)
    return -block["end_force"][:, 0, 1, 0], block["point_position"][:, 1, 0] - LENGTH, block["segment_tension"]


TURNS = (np.arange(1, 6) * QUARTER / 0.25).astype(int)


def loop_error(segments: int, law: str = "elastic-slip", **properties) -> np.ndarray:
    """Relative errors of the force at the turns and of the energy of two loops."""
    force, way, _ = cycled(segments, law, **properties)
    at = force[TURNS] / PULL - np.array([1.0, LOW / PULL, 1.0, LOW / PULL, 1.0])
    loops = [-np.trapezoid(force[a : b + 1], way[a : b + 1]) for a, b in ((TURNS[0], TURNS[2]), (TURNS[2], TURNS[4]))]
    return np.array([*at, *(np.abs(loops) / area(PULL - LOW) - 1.0)])


def profile(s, force: float):
    """Tension at distances from the end (m) after the first pull."""
    begin = (force - SLIP) / RUB
    return np.where(s < begin, force - RUB * s, SLIP * np.exp(-np.maximum(s - begin, 0.0) / REACH))


def check_loops(law: str = "elastic-slip", **properties) -> None:
    segments = np.array([20, 40, 80])
    errors = [np.abs(loop_error(n, law, **properties)).max() for n in segments]
    assert errors[-1] < 5e-3, f"{errors}"
    assert rate(1.0 / segments, errors) > 1.5, f"{errors}"


def check_profile(law: str = "elastic-slip", **properties) -> None:
    n = 80
    _, _, tension = cycled(n, law, **properties)
    s = (np.arange(n)[::-1] + 0.5) * LENGTH / n
    first, back = tension[TURNS[0]], tension[TURNS[1]]
    assert first == pytest.approx(profile(s, PULL), abs=5e-3 * PULL)
    # Masing: the change is twice the profile of half the change
    change = 2.0 * profile(s, 0.5 * (PULL - LOW))
    assert back == pytest.approx(profile(s, PULL) - change, abs=5e-3 * PULL)


def test_tension_falls_to_the_stick_point_and_turns_back():
    check_profile()


def test_hysteresis_loop():
    check_loops()


def check_laid(**properties) -> None:
    n, pulled = 80, model(80, "elastic-slip", **({"laid": True} | properties))
    a, b = pulled.points
    b = dataclasses.replace(b, position=(LENGTH + WAY, 0.0, LEVEL))
    built = statics(dataclasses.replace(pulled, points=(a, b)))
    first = March(built, Settings(dt_nodes=1.0), 0.0).first()
    s = (np.arange(n)[::-1] + 0.5) * LENGTH / n
    assert first["segment_tension"][0] == pytest.approx(profile(s, PULL), abs=5e-3 * PULL)
    # and there it stays
    late = run(built, 60.0, dt_nodes=1.0)["segment_tension"][-1]
    assert late == pytest.approx(first["segment_tension"][0], abs=2e-3 * PULL)


def test_laid_statics_know_the_pull():
    check_laid()


def laid_over_waves(turned: bool):
    """A chain laid over waves and pulled; tensions from the anchor on, and where their segments are, m."""
    x = np.arange(-700.0, 300.0, 5.0)
    bed = Bathymetry(tuple(x.tolist()), (0.0,), tuple((120.0 + float(np.cos(np.pi * at / 100.0)),) for at in x))
    friction = Friction(axial=0.3, transverse=0.3, laid=True)
    ends = fixed(1, -600.0, 0.0, -bed.depth_at(-600.0, 0.0)), coupled(2, 0.0, 0.0, -20.0)
    chain = kind("chain", diameter=0.1, mass_per_length=100.0, axial_stiffness=5e8)
    hung = line(1, *((2, 1) if turned else (1, 2)), ("chain", 625.0, 125))
    built = statics(mooring(chain, ends, [hung], water_depth=120.0, bathymetry=bed, friction=friction))
    first = March(built, Settings(dt_nodes=1.0), 0.0).first()
    tension, place = first["segment_tension"][0], first["node_position"][0, :, 0]
    middle = 0.5 * (place[1:] + place[:-1])
    return (tension[::-1], middle[::-1]) if turned else (tension, middle)


def test_laid_chain_follows_the_bed():
    tension, place = laid_over_waves(False)
    rub = 0.3 * weight_in_water(CHAIN)
    for a, b in ((-550.0, -350.0), (-500.0, -300.0)):  # a wave of the bed
        change = np.diff(np.interp([a, b], place, tension))[0]
        assert change == pytest.approx(rub * (b - a), rel=0.03)
    assert laid_over_waves(True)[0] == pytest.approx(tension, rel=1e-3)


def test_statics_without_friction_fail():
    must_fail(check_laid, laid=False)


def test_other_coefficient_and_damping_law_fail():
    must_fail(check_profile, axial=1.02 * MU)
    must_fail(check_profile, "saturated-damping")
    must_fail(check_loops, axial=0.98 * MU)
