"""Why MoorDyn-C's deck seafloor agrees only to 4.5 % as given: how the lift of a segment in the surface is shared out.

Its rope weighs as much as its water and is slack, so that nothing but that lift moves it beside the weight at its end, and it
begins in the surface. Equations of our own (`planar_rope`) with the one rule are MoorDyn-C, with the other they are ours.
"""

from __future__ import annotations

import pytest
from beside import needs, read
from moorings import at_rest, nodes
from one_script import by_runge_kutta, off, watch, write
from planar_rope import fall, wet_by_rims, wet_by_sections
from test_moordyn_c_decks import SEAFLOOR

import moorage.moordyn as ours

pytestmark = needs("moordyn_c")


def test_slack_rope_in_the_surface_by_either_rule(reference, tmp_path, monkeypatch, record_property):
    """0.8 s: each program is its own rule within 1e-4 (of Runge's step), and 7 % off the other's."""
    monkeypatch.chdir(tmp_path)
    theirs, folder = pytest.importorskip("moordyn"), reference / "moordyn-c-tests"
    scene = SEAFLOOR._replace(duration=0.8)
    _, first = watch(ours, scene, folder)
    other, _ = watch(theirs, scene, folder, first)
    mine = by_runge_kutta(scene, folder)
    start = nodes(at_rest(read(write(scene, folder))))[:, [0, 2]]
    found = {}
    for rule in (wet_by_rims, wet_by_sections):
        run = fall(rule, start, scene.interval, 16, scene.interval / 320)[:, [-1, 10]]
        for name, seen in (("theirs", other), ("ours", mine)):
            found[rule.__name__, name] = off(run, seen["position"][:, 1:][:, :, [0, 2]])
    record_property("error", str(found))
    assert max(found["wet_by_rims", "theirs"], found["wet_by_sections", "ours"]) < 1e-4, found
    assert min(found["wet_by_rims", "ours"], found["wet_by_sections", "theirs"]) > 0.05, found
