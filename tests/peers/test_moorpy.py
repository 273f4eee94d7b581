"""Quasi-static moorings of OC4-DeepCwind and VolturnUS-S beside MoorPy: tensions, total force, 6x6 stiffness.

A lumped-mass line lifts off the bed node by node. Its tension is of second order in the segment length h, but its
stiffness, the slope of the tension between two lift-offs, is a sawtooth around the exact one whose height is of first
order in h: for VolturnUS-S's 850 m chains 7 % in surge with 50 segments, 2 % with 200. The mean over the place of the
touchdown within a segment is right, which several numbers of segments give.
"""

import numpy as np
import pytest
from benchmarks.programs import call
from beside import needs, statics

from moorage.model import Attachment, Environment, Line, LineType, Model, Point, Section

pytestmark = needs("moorpy_statics")

OC4 = {"length": 835.5, "diameter": 0.0766, "mass": 113.35, "stiffness": 753.6e6}
VOLTURNUS = {"length": 850.0, "diameter": 0.333, "mass": 685.0, "stiffness": 3.27e9}
HEADINGS = np.radians([60.0, 180.0, 300.0])
SEGMENTS = range(180, 221, 4)


def ring(radius, z):
    return np.stack([radius * np.cos(HEADINGS), radius * np.sin(HEADINGS), np.full(3, z)], axis=1)


def mooring(line, anchors, fairleads, segments):
    kind = LineType(
        name="chain", diameter=line["diameter"], mass_per_length=line["mass"], axial_stiffness=line["stiffness"]
    )
    sections = (Section(line_type="chain", length=line["length"], segments=segments),)
    return Model(
        environment=Environment(water_depth=200.0),
        line_types=(kind,),
        points=tuple(Point(id=k + 1, kind="fixed", position=tuple(p)) for k, p in enumerate(anchors))
        + tuple(Point(id=k + 4, kind="coupled", position=tuple(p)) for k, p in enumerate(fairleads)),
        lines=tuple(
            Line(id=k, sections=sections, end_a=Attachment("point", k), end_b=Attachment("point", k + 3))
            for k in (1, 2, 3)
        ),
    )


@pytest.mark.parametrize(("line", "radius"), [(OC4, 40.868), (VOLTURNUS, 58.0)], ids=["OC4", "VolturnUS-S"])
def test_mooring(line, radius):
    anchors, fairleads = ring(837.6, -200.0), ring(radius, -14.0)
    theirs = call(
        "moorpy_statics", depth=200.0, gravity=9.80665, density=1025.0, anchor=anchors, fairlead=fairleads, **line
    )
    ours = [statics(mooring(line, anchors, fairleads, n)) for n in SEGMENTS]
    for state in ours:
        np.testing.assert_allclose(state["fairlead_tension"], theirs["fairlead_tension"], rtol=3e-4)
        np.testing.assert_allclose(state["anchor_tension"], theirs["anchor_tension"], rtol=5e-4)
        np.testing.assert_allclose(state["fairlead_force"].sum("line")[2], theirs["force"][2], rtol=3e-4)
    stiffness = np.array([state["stiffness"].values for state in ours])
    scale = np.sqrt(np.outer(*2 * [np.diag(theirs["stiffness"])]))  # entries with different units made comparable
    assert np.abs((stiffness.mean(axis=0) - theirs["stiffness"]) / scale).max() < 0.005
    assert np.abs((stiffness - theirs["stiffness"]) / scale).max() < 0.04
