"""The lazy-wave cable of the benchmarks at rest: MoorDyn-C's positions within 3 cm, its top tension within 0.5 %.

MoorDyn-C's stationary solver does not find the rest of cables joined by free rods, so the ends are held for 300 s. So that
this does not take minutes, segments are 2 m long, EA is 2e7 N and the drag twenty times as large, in both programs alike:
what is left of the swing goes with 1 / t under quadratic drag, and is a few millimetres.
"""

import dataclasses

import numpy as np
from benchmarks.cases import lazy_wave, write_deck
from beside import moordyn_at_rest, needs, read, statics

pytestmark = needs("moordyn_c")

QUIET = "1.0 dtIC", "1.0 TmaxIC", "1e-6 threshIC", "0 writeLog", "1 disableOutput", "1 disableOutTime"


def coarse():
    model = lazy_wave()
    types = tuple(
        dataclasses.replace(t, axial_stiffness=2e7, axial_damping_ratio=0.3, transverse_drag=24.0, tangential_drag=2.0)
        for t in model.line_types
    )
    (line,) = model.lines
    cut = tuple(dataclasses.replace(s, segments=round(s.segments / 2)) for s in line.sections)
    return dataclasses.replace(model, line_types=types, lines=(dataclasses.replace(line, sections=cut),))


def test_lazy_wave_in_still_water(tmp_path):
    path = write_deck(tmp_path / "cable.dat", coarse(), "0.001 dtM", "rk2 tScheme", *QUIET)
    model = read(path)
    ours, theirs = statics(model), moordyn_at_rest(path, model, 300.0)
    assert len(model.lines) == 3  # joined by free rods
    assert np.abs(ours["node_position"].values - theirs["node_position"][-1]).max() < 0.03
    top = ours["fairlead_segment_tension"].values[-1]
    assert abs(top / theirs["end_tension"][-1, -1] - 1.0) < 0.005
    assert abs(statics(coarse())["fairlead_segment_tension"].values[-1] / top - 1.0) < 0.005  # as one line, exact rule
