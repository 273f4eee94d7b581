"""The limp line that statics start from: several sections, with floats, free or partly on the bed.

Verifies: hanging

The same line without bending in statics: what hangs freely must be where they find it, to the 1e-6 of the length at which
the search for the force at end A stops (a factor of 10 for how far that moves a node inside). On the bed, statics let a
node sink into it by its weight over the bed's stiffness, here 1 mm, and the segment that is lifted lifts off a node: the
same place within 2 cm. A wave whose floats lift 5 % less must not fit.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import coupled, fixed, kind, line, mooring, nodes, statics

from moorage.physics.hanging import hanging
from moorage.system.segments import segment_table

TYPES = (
    kind("cable", diameter=0.15, mass_per_length=40.0, axial_stiffness=4e8),
    kind("floats", diameter=0.4, mass_per_length=90.0, axial_stiffness=4e8),
)
LAZY = ("cable", 70.0, 70), ("floats", 30.0, 40), ("cable", 60.0, 50)
CASES = {  # sections, span, heights of the ends
    "W": (LAZY, 100.0, -12.0, -15.0),
    "upside down": ((("floats", 40.0, 20), ("cable", 10.0, 10), ("floats", 30.0, 11)), 60.0, -60.0, -70.0),
    "taut": ((("cable", 50.0, 20), ("floats", 50.0, 20)), 99.0, -40.0, -60.0),
    "lazy wave": (LAZY, 105.0, -80.0, -12.0),
    "lazy wave from its upper end": (LAZY[::-1], 105.0, -12.0, -80.0),
}


def check(case: str, lift: float = 1.0) -> None:
    parts, span, low, high = CASES[case]
    model = mooring(
        TYPES, (fixed(1, 0.0, 0.0, low), coupled(2, span, 0.0, high)), (line(1, 1, 2, *parts),),
        water_depth=80.0, seabed_stiffness=3e6,
    )  # fmt: skip
    table = segment_table(model)
    weight = 9.80665 * table["length"] * (table["mass"] - 1025.0 * table["area"])
    weight[weight < 0.0] *= lift
    lies = -80.0 in (low, high)
    x, z = hanging(span, high - low, table["length"], np.full(len(weight), 4e8), weight, lies)
    found = nodes(statics(model)) - [0.0, 0.0, low]
    allowed = 0.02 if lies else 1e-5 * table["length"].sum()
    assert np.abs(found[:, 0] - x).max() < allowed
    assert np.abs(found[:, 2] - z).max() < allowed


@pytest.mark.parametrize("case", CASES)
def test_as_statics_find_it(case):
    check(case)


def test_none_for_a_heap():
    """A meter lies on the bed, but there is no place for it beside the anchor."""
    assert hanging(0.0, 50.0, np.full(10, 5.1), np.full(10, 1e8), np.full(10, 500.0), True) is None


def test_less_lift_fails():
    must_fail(check, "W", 0.95)


def test_vertical_line():
    x, z = hanging(0.0, 50.0, np.full(10, 4.99), np.full(10, 1e8), np.full(10, 500.0), True)
    assert np.abs(x).max() < 1e-4
    assert z[-1] == pytest.approx(50.0, abs=1e-4)
