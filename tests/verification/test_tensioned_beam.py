"""A cable that leaves its clamp at an angle to its tension: the boundary layer of length sqrt(EI / T).

Verifies: bending, tension

A long beam without weight, under a force T far away, clamped at an angle a to it. EI theta'' = T sin(theta) with theta -> 0
has the solution tan(theta / 4) = tan(a / 4) exp(-s / b), b = sqrt(EI / T), so that

    moment at the clamp = 2 sqrt(EI T) sin(a / 2)
    the tip lies beside the tension's line through the clamp by 2 b sin(a / 2),
    and short of the straight length by 2 b (1 - cos(a / 2)).

The beam is 25 b long: what is left out is exp(-25). All three must converge at a rate within 0.1 of 2, their
extrapolations be exact within 1e-5 of b (1e-6 is the stretch). The moment is T times the offset to rounding, as it must be
on any grid. 1 % more EI must fail.
"""

from __future__ import annotations

import numpy as np
import pytest
from cables import VACUUM, at_once, beam
from common import must_fail, rate
from moorings import clamp, free, held, line, mooring, nodes, statics

EI, T = 4e4, 1e4
LAYER = np.sqrt(EI / T)  # 2 m
GRIDS = np.array([50, 100, 200])  # segments of one layer, a half and a quarter


def found(angle: float, segments: int, stiffness: float = EI) -> np.ndarray:
    """Moment at the clamp over sqrt(EI T), offset and shortening of the tip over the layer."""
    root = clamp(1, (0.0, 0.0, 0.0), (np.cos(angle), 0.6 * np.sin(angle), 0.8 * np.sin(angle)))
    length = 25.0 * LAYER
    tip = free(1, length, 0.0, 0.0, external_force=(T, 0.0, 0.0))
    cable = beam(stiffness, axial_stiffness=1e10)
    lines = (line(1, held(root, "B"), 1, ("beam", length, segments)),)
    built = statics(mooring(cable, (tip,), lines, (root,), **VACUUM), tolerance=1e-3)
    end = nodes(built)[-1] - nodes(built)[0]
    moment = np.linalg.norm(at_once(built)["end_moment"][0, 0, 0])
    offset = np.hypot(end[1], end[2])
    assert moment == pytest.approx(T * offset, rel=1e-6)
    return np.array([moment / np.sqrt(EI * T), offset / LAYER, (length * (1.0 + T / 1e10) - end[0]) / LAYER])


def check(angle: float, **wrong) -> None:
    exact = 2.0 * np.array([np.sin(0.5 * angle), np.sin(0.5 * angle), 1.0 - np.cos(0.5 * angle)])
    values = np.array([found(angle, int(n), **wrong) for n in GRIDS])
    assert values[-1] + (values[-1] - values[-2]) / 3.0 == pytest.approx(exact, rel=1e-3, abs=1e-5)
    for column in np.abs(values - exact).T:
        assert abs(rate(1.0 / GRIDS, column) - 2.0) < 0.1, f"{values}"


@pytest.mark.parametrize("angle", [0.1, 0.5, 1.0])
def test_boundary_layer(angle):
    check(angle)


def test_stiffer_cable_fails():
    must_fail(check, 0.5, stiffness=1.01 * EI)
