"""The way along which a line peels off a soil with suction, and the warning where segments are longer."""

from __future__ import annotations

import dataclasses
import warnings

import numpy as np
import pytest
from moorings import coupled, fixed, kind, single, weight_in_water

import moorage
from moorage.model import Soil
from moorage.solve.peeling import peeling
from moorage.solve.statics import solve
from moorage.system.build import build

CHAIN, DEPTH = kind(diameter=0.1, mass_per_length=100.0, axial_stiffness=1e7), 100.0
CLAY = Soil(shear_strength=3e3)


def lying(segments: int, soil: Soil = CLAY):
    """A chain that lies from its anchor up to its touchdown, and hangs from there."""
    ends = fixed(1, 0.0, 0.0, -DEPTH), coupled(2, 67.0, 0.0, -90.0)
    return single(CHAIN, 70.0, segments, *ends, water_depth=DEPTH, soil=soil)


def test_way_is_that_of_a_parabola():
    built = build(lying(70))
    solve(built)
    (found,) = peeling(built)
    block = moorage.solve_statics(lying(560, dataclasses.replace(CLAY, suction_ratio=0.0)))
    along = -float(block["anchor_force"].values[0] @ [-1.0, 0.0, 0.0])
    deep = float(np.median((-DEPTH - built.state.position[:, 2])[built.state.position[:, 2] < -DEPTH]))
    assert found.line == 1
    assert found.segment == pytest.approx(1.0)
    u, held = CLAY.suction_decay * deep, CLAY.suction_ratio * weight_in_water(CHAIN)
    assert found.way == pytest.approx(np.sqrt(2.0 * abs(along) * u / held), rel=0.05)


def test_long_segments_are_told_with_their_cure():
    with pytest.warns(moorage.ModelWarning, match=r"line 1 .*segments of 2 m .* along 0\.\d+ m.*suction_ratio"):
        moorage.solve_statics(lying(35))


@pytest.mark.parametrize(
    ("segments", "soil"), [(140, CLAY), (70, dataclasses.replace(CLAY, suction_ratio=0.0))], ids=["short", "no suction"]
)
def test_nothing_is_told_of_short_ones_or_without_suction(segments, soil):
    with warnings.catch_warnings():
        warnings.simplefilter("error", moorage.ModelWarning)
        moorage.solve_statics(lying(segments, soil))
