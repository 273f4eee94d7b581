"""Euler's elastica: a cantilever with a load across its tip, bent up to 82 degrees.

Verifies: bending, tension

With P L^2 / EI = a, the drop of the tip over L, its shortening over L and its slope (rad) follow from elliptic integrals
(Bisshopp & Drucker 1945); the table has 5 digits. The cantilever is a cable clamped at end A by the exact rule, its other
end a free point with the force, without weight; EA is so high that it stretches by 1e-6.

The drop must converge at a rate within 0.1 of 2 over 10 to 40 segments, as do the others where they are not nearly
straight, and Richardson's extrapolation of the last two grids be the table within 1e-5 (half a digit of it, and statics
to 1e-4 N). By the paper's rule (MoorDyn's) a clamp converges to the same, for the angle there vanishes with h. EI 0.2 %
higher must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail, rate
from moorings import clamp, free, held, kind, line, mooring, nodes, statics

LENGTH, EI = 10.0, 1e5
TABLE = {
    0.25: (0.08275, 0.00412, 0.12429),
    0.5: (0.16214, 0.01592, 0.24453),
    1.0: (0.30172, 0.05643, 0.46135),
    2.0: (0.49346, 0.16064, 0.78175),
    5.0: (0.71379, 0.38763, 1.21537),
    10.0: (0.81061, 0.55500, 1.43029),
}
SEGMENTS = np.array([10, 20, 40, 80])


def bent(load: float, segments: int, stiffness: float = EI, flavour: str = "native") -> np.ndarray:
    """Drop and shortening of the tip over the length, and slope there, of a cantilever in the direction (0.6, 0.8, 0)."""
    cable = kind("cable", axial_stiffness=1e9, bending_stiffness=stiffness)
    root = clamp(1, (0.0, 0.0, -5.0), (0.6, 0.8, 0.0))
    tip = free(1, 6.0, 8.0, -5.0, external_force=(0.0, 0.0, -load * EI / LENGTH**2))
    model = mooring(cable, (tip,), (line(1, held(root, "B"), 1, ("cable", LENGTH, int(segments))),), (root,), gravity=0.0,
                    water_density=0.0)  # fmt: skip
    r = nodes(statics(dataclasses.replace(model, flavour=flavour), tolerance=1e-4)) - [0.0, 0.0, -5.0]
    along = r @ [0.6, 0.8, 0.0]
    q = r[-1] - r[-2]
    slope = np.arctan2(-q[2], q @ [0.6, 0.8, 0.0])
    return np.array([-r[-1, 2] / LENGTH, 1.0 - along[-1] / LENGTH, slope])


def check(load: float, **wrong) -> None:
    found = np.array([bent(load, n, **wrong) for n in SEGMENTS])
    extrapolated = found[-1] + (found[-1] - found[-2]) / 3.0
    assert extrapolated == pytest.approx(np.array(TABLE[load]), abs=1e-5)
    for column in np.abs(found - extrapolated).T[: 1 if load < 1.0 else 3]:
        assert abs(rate(1.0 / SEGMENTS[:3], column[:3]) - 2.0) < 0.1, f"{found}"


@pytest.mark.parametrize("load", TABLE)
def test_elastica(load):
    check(load)


def test_clamp_of_moordyn_files():
    check(2.0, flavour="MoorDyn-C")


def test_stiffer_cable_fails():
    must_fail(check, 2.0, stiffness=1.002 * EI)
