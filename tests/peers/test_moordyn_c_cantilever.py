"""Why MoorDyn-C's deck BeamCantilevered agrees only to 0.8 %: the length that a bend is divided by.

Files of MoorDyn have segments that cannot push. In the deck, whose beam is let go from a catenary with a kink at the clamp,
they go slack and 0.2 % short, and MoorDyn-C divides bends by the length that segments have now, we by that which they have
unstretched. Equations of our own (`planar_cantilever`) with the one rule are MoorDyn-C, with the other they are ours.
"""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from beside import needs, read, statics
from moorings import at_rest, nodes
from one_script import by_runge_kutta, off, watch, write
from planar_cantilever import Beam, G, elastica, swing
from test_moordyn_c_decks import BEAM

import moorage.moordyn as ours

pytestmark = needs("moordyn_c")
DECK = Beam(bending=1e7, axial=1.5e9, mass=100.0, weight=100.0 * G, ratio=1.0, stretched=False)
# it hangs down by more than a third of its length, and stretches so much that the rules differ by 4 mm
HANGING = DECK._replace(bending=3e5, axial=1e6, weight=(100.0 - 1025.0 * np.pi / 4.0 * 0.05**2) * G, ratio=0.5)
PLACE = -20.0  # m, in water
MIDDLE, TIP = 10, -1


@pytest.fixture
def theirs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return pytest.importorskip("moordyn")


@pytest.fixture
def folder(reference):
    return reference / "moordyn-c-tests"


def sunk(folder: Path, beam: Beam, segments: int, options: str) -> str:
    """Write the deck with another beam, and with options of its own, into water; return its name."""
    text = (folder / BEAM.deck).read_text("utf-8", errors="replace").split("0.1           cfl")[0]
    for old, new in (
        ("1.5e9      -1.0        1e7", f"{beam.axial} -{beam.ratio} {beam.bending}"),
        ("-10.0 0     10.0  0.0   0     10.0", f"-10 0 {PLACE} 0 0 {PLACE}"),
        ("10      0.0     9.9", f"10 0 {PLACE - 0.1}"),
        ("10        19 ", f"10 {segments} "),
    ):
        assert old in text, old
        text = text.replace(old, new)
    Path("sunk.txt").write_text(f"{text}{options}1025 WtrDnsty\n{G} g\n--- need this line\n", "utf-8")
    return "sunk.txt"


def damped(m, folder: Path, beam: Beam, segments: int, step: float, damping: float, duration: float) -> np.ndarray:
    """Return the tip (2,) where MoorDyn-C's beam comes to rest, from the clamp, m.

    It has no linear damping but that of the bed: here the beam hangs into a bed that only damps.
    """
    options = f"rk4 tScheme\n{step} dtM\n{0.1 - PLACE} WtrDpth\n0 TmaxIC\n0 kBot\n{damping} cBot\n1 disableOutTime\n"
    system = m.Create(sunk(folder, beam, segments, options))
    m.SetVerbosity(system, m.LEVEL_ERR)
    assert m.Init(system, [], []) == 0
    for k in range(round(duration / 0.5)):
        m.Step(system, [], [], 0.5 * k, 0.5)
    tip = np.array(m.GetPointPos(m.GetPoint(system, 1)))
    m.Close(system)
    return tip[[0, 2]] - [0.0, PLACE]


def at_statics(folder: Path, beam: Beam, segments: int) -> np.ndarray:
    """Return the tip (2,) of our statics, from the clamp, m."""
    result = statics(read(sunk(folder, beam, segments, "100 WtrDpth\n")))
    return result.point_position.values[0, [0, 2]] - [0.0, PLACE]


def test_vibration_by_either_rule(theirs, folder, record_property):
    """A quarter of a second: each program is its own rule within 1e-4, of Runge's step, and 0.8 % off the other's.

    The shortest segment is 0.2 % short, which makes bends that much stiffer. Where segments push, the rule does not matter.
    """
    scene = BEAM._replace(duration=0.25)
    mine, first = watch(ours, scene, folder)
    other, _ = watch(theirs, scene, folder, first)
    mine = by_runge_kutta(scene, folder)
    start = nodes(at_rest(read(write(scene, folder))))[:, [0, 2]]
    runs = {s: swing(DECK._replace(stretched=s), start, scene.interval, 10, 5e-5) for s in (True, False)}
    lengths = np.linalg.norm(np.diff(runs[True], axis=1), axis=2)
    assert 0.997 < lengths.min() * 19.0 / 10.0 < 0.999

    def seen(result):
        return result["position"][:, [0, -1]][:, :, [0, 2]]

    found = {(s, name): off(run[:, [TIP, MIDDLE]], seen(result))
        for s, run in runs.items() for name, result in (("theirs", other), ("ours", mine))}  # fmt: skip
    record_property("error", str(found))
    assert max(found[True, "theirs"], found[False, "ours"]) < 1e-4, found
    assert min(found[True, "ours"], found[False, "theirs"]) > 5e-3, found
    pushed = [swing(DECK._replace(stretched=s, pushes=True), start, scene.interval, 10, 5e-5) for s in (True, False)]
    assert off(*(run[:, [TIP, MIDDLE]] for run in pushed)) < 1e-4


def test_statics_converge_to_the_elastica_of_each_rule(theirs, folder, record_property):
    """Both are of second order; extrapolated by Richardson they are 4 mm apart, each on its own elastica.

    The error of extrapolations falls by 4 or more with each halving (by 16 in the limit), so that the last one has at most a
    third of their last change.
    """
    counts = (8, 16, 32)
    limits = {s: elastica(HANGING._replace(stretched=s)) for s in (True, False)}
    assert np.linalg.norm(limits[True] - limits[False]) > 4e-3
    tips = {
        True: [damped(theirs, folder, HANGING, n, 1e-3, 4e3, 40.0) for n in counts],
        False: [at_statics(folder, HANGING, n) for n in counts],
    }
    found = {}
    for rule, tip in tips.items():
        errors = [np.linalg.norm(t - limits[rule]) for t in tip]
        early, late = ((4.0 * b - a) / 3.0 for a, b in pairwise(tip))
        allowed = np.linalg.norm(late - early) / 3.0
        found[rule] = (errors, np.linalg.norm(late - limits[rule]), np.linalg.norm(late - limits[not rule]), allowed)
    record_property("error", str(found))
    for errors, near, far, allowed in found.values():
        assert np.log2(errors[1] / errors[2]) == pytest.approx(2.0, abs=0.1), found
        assert near < allowed < far, found


def test_the_decks_own_beam_at_rest(theirs, folder):
    """EA 1.5e9 N: it stretches by less than a millionth, and so both rules, and both programs, have the same tip."""
    beam = HANGING._replace(bending=DECK.bending, axial=DECK.axial, ratio=0.05)
    assert np.linalg.norm(elastica(beam) - elastica(beam._replace(stretched=True))) < 1e-7
    mine, other = at_statics(folder, beam, 19), damped(theirs, folder, beam, 19, 6e-5, 4e4, 10.0)
    assert np.linalg.norm(mine - other) < 1e-6
    linear = beam.weight * beam.length**4 / (8.0 * beam.bending)
    assert -mine[1] == pytest.approx(linear * (1.0 + 1.0 / (2.0 * 19**2)), rel=2e-3)


def test_their_start_of_the_deck_is_a_swing_that_nothing_damps(theirs, folder):
    """The tip that their statics leave, 20 % too low, is where it happens to be: it swings about our statics in air.

    With the deck's own step it then goes to NaN. Along the axis the fastest shape of critically damped segments decays with
    4 zeta sqrt(EA / m) / l; times the step of 85 us that is 2.5, and a Runge-Kutta method of second order stands 2, one of
    fourth order 2.785.
    """
    deck = (folder / BEAM.deck).read_text("utf-8", errors="replace")
    heights = {}
    for scheme in ("RK2", "RK4"):
        text = deck.replace("0.1           cfl", f"{scheme} tScheme\n0.1           cfl").replace("40.0 ", "2.0 ")
        Path("deck.txt").write_text(text, "utf-8")
        system = theirs.Create("deck.txt")
        theirs.SetVerbosity(system, theirs.LEVEL_ERR)
        assert theirs.Init(system, [], []) == 0
        heights[scheme] = [theirs.GetPointPos(theirs.GetPoint(system, 1))[2]]
        try:
            for k in range(113):  # two periods of 0.565 s
                theirs.Step(system, [], [], 0.01 * k, 0.01)
                heights[scheme].append(theirs.GetPointPos(theirs.GetPoint(system, 1))[2])
        except RuntimeError:
            heights[scheme].append(np.nan)
        theirs.Close(system)
    step = float(re.search(r"dtM = (\S+) s", Path("deck.log").read_text())[1])
    decay = 4.0 * DECK.ratio * np.sqrt(DECK.axial / DECK.mass) * 19.0 / DECK.length
    assert 2.0 < step * decay < 2.785
    assert np.isnan(heights["RK2"][-1])
    assert not np.isnan(heights["RK4"]).any()
    rest = float(statics(read(folder / BEAM.deck)).point_position[0, 2])
    swing_about = np.array(heights["RK4"][1:])
    assert heights["RK4"][0] < rest - 0.01
    assert np.ptp(swing_about) > 0.05
    assert swing_about.mean() == pytest.approx(rest, abs=3e-3)
