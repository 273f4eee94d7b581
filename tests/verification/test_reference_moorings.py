"""Two reference moorings of floating wind turbines: OC4-DeepCwind (three light chains) and VolturnUS-S (three heavy
ones).

Verifies: tension, weight, contact

Reference. Quasi-static solutions in closed form (`common.Catenary`), which must first give the values computed with
MoorPy 1.3.0 and published for these moorings, to the digits quoted.

Tensions and vertical load, 50 to 400 segments. Predicted error: lumping, of order h^2 with its constant, within 20 %;
and the bed. A string under the tension H on springs lies w / (k d) deep (4.6 mm for OC4) and lifts off with a slope,
as if the bed lay w / (2 k d) deeper; with segments longer than sqrt(H / (k d)) = 2 m it depends on the grid whether
none or all of w / (k d) counts. This effect is 4e-5 of the tension.

Stiffness. Between two lift-offs a lumped line turns about the last node on the bed, where a real one rolls off it.
The tangent stiffness is therefore of **first** order only, with an error that depends on where the point of
touch-down falls between nodes: up to 2.9 % (surge) and 4.1 % (heave) on OC4 with 50 segments, 7.7 and 12 % on
VolturnUS-S, whose segments of 17 m weigh more. On a hard bed the measured error must be the predicted one within 0.2
% of the stiffness; on the usual, softer bed it must stay within the largest of all phases, which halves with each
refinement.
"""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np
import pytest
from common import Catenary, must_fail
from moorings import CHAIN, end_tensions, point_forces, spread, statics, weight_in_water

from moorage.model import LineType
from moorage.solve.stiffness import platform_stiffness

SEGMENTS = (50, 100, 200, 400)
RISE = 186.0


class Case(NamedTuple):
    """Three lines at 60, 180 and 300 degrees, anchors at a radius of 837.6 m."""

    line_type: LineType
    length: float
    fairlead_radius: float
    values: dict[str, float]  # MoorPy 1.3.0: tensions and Fz in kN, stiffness in N/m and N m/rad

    @property
    def span(self) -> float:
        return 837.6 - self.fairlead_radius

    @property
    def line(self) -> Catenary:
        return Catenary(self.length, self.line_type.axial_stiffness, weight_in_water(self.line_type), True)

    def solved(self, segments: int, **environment):
        model = spread(segments, self.line_type, self.length, 837.6, self.fairlead_radius, **environment)
        return statics(model, tolerance=0.1 if not environment else 1.0)

    def platform(self, K: np.ndarray, H: float) -> np.ndarray:
        """Surge, heave and yaw stiffness of the mooring from d(H, V) / d(x, z) of a line."""
        lateral, r = H / self.span, self.fairlead_radius
        return np.array([1.5 * (K[0, 0] + lateral), 3.0 * K[1, 1], 3.0 * (lateral * r**2 + H * r)])


CASES = {
    "OC4-DeepCwind": Case(
        CHAIN, 835.5, 40.868,
        {"fairlead": 1098.5, "anchor": 900.6, "surge": 70122.0, "heave": 19080.0, "yaw": 1.161e8, "load": -1886.8},
    ),
    "VolturnUS-S": Case(
        dataclasses.replace(CHAIN, diameter=0.333, mass_per_length=685.0, axial_stiffness=3.27e9), 850.0, 58.0,
        {"fairlead": 2435.6, "anchor": 1349.6, "surge": 71891.0, "heave": 60743.0, "yaw": 2.523e8, "load": -6082.4},
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_closed_form_gives_the_published_values(case):
    """The reference itself, to half a unit of the last digit that is quoted."""
    anchor, fairlead = case.line.end_tensions(case.span, RISE) / 1e3
    H, V = case.line.solve(case.span, RISE)
    surge, heave, yaw = case.platform(case.line.stiffness_of_ends(case.span, RISE), H)
    v = case.values
    assert [anchor, fairlead, -3e-3 * V] == pytest.approx([v["anchor"], v["fairlead"], v["load"]], abs=0.055)
    assert [surge, heave] == pytest.approx([v["surge"], v["heave"]], abs=1.5)
    assert yaw == pytest.approx(v["yaw"], abs=0.005e8)


def check_tensions(case: Case, segments: int, **environment) -> None:
    built = case.solved(segments, **environment)
    line = case.line
    exact = line.end_tensions(case.span, RISE)
    H, V = line.solve(case.span, RISE)
    sink = 0.5 * line.weight / (3e6 * case.line_type.diameter)
    dH, dV = line.stiffness_of_ends(case.span, RISE) @ [0.0, sink]
    bed = np.array([dH / H, (H * dH + V * dV) / (H**2 + V**2)])
    lumping = line.lumping(case.span, RISE, segments)
    size = 0.2 * np.abs(lumping).max() + np.abs(bed).max()
    error = end_tensions(built) / exact - 1.0
    assert np.abs(error - lumping - bed).max() < size, f"{error} against {lumping} and {bed}"
    load = point_forces(built)[built.coupled].sum(axis=0)
    assert np.abs(load[:2]).max() < 1e-6 * -load[2]
    assert abs(load[2] / (-3.0 * V) - 1.0) < 2.0 * (np.abs(bed).max() + np.abs(lumping).max())


@pytest.mark.parametrize("segments", SEGMENTS)
@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_tensions(case, segments):
    check_tensions(case, segments)


def stiffness_error(case: Case, segments: int, **environment) -> np.ndarray:
    """Relative errors of surge, sway, heave and yaw."""
    exact = case.platform(case.line.stiffness_of_ends(case.span, RISE), case.line.solve(case.span, RISE)[0])
    built = case.solved(segments, **environment)
    K = np.diag(platform_stiffness(built, point_forces(built)[built.coupled]))
    return K[[0, 1, 2, 5]] / exact[[0, 0, 1, 2]] - 1.0


def predicted_error(case: Case, segments: int, phase: float | None = None) -> np.ndarray:
    H = case.line.solve(case.span, RISE)[0]
    exact = case.platform(case.line.stiffness_of_ends(case.span, RISE), H)
    lumped = case.platform(case.line.stiffness_of_ends(case.span, RISE, segments, phase), H)
    return (lumped / exact - 1.0)[[0, 0, 1, 2]]


def check_hard_bed(case: Case, segments: int, phase: float | None = None) -> None:
    off = stiffness_error(case, segments, seabed_stiffness=3e9) - predicted_error(case, segments, phase)
    assert np.abs(off).max() < 2e-3, f"{off}"


@pytest.mark.parametrize("segments", SEGMENTS)
@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_stiffness_on_a_hard_bed(case, segments):
    check_hard_bed(case, segments)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_stiffness_converges(case):
    bounds = []
    for segments in SEGMENTS:
        bound = np.maximum(*(np.abs(predicted_error(case, segments, phase)) for phase in (0.0, 1.0)))
        assert (np.abs(stiffness_error(case, segments))[:3] < bound[:3] + 1e-3).all()
        bounds.append(bound[2])
    assert bounds[0] / bounds[-1] == pytest.approx(8.0, rel=0.25)


def test_wrong_variants_fail():
    """Water that is 1 % too heavy (0.04 % of the weight), and a stiffness without the effect of the grid."""
    case = CASES["OC4-DeepCwind"]
    must_fail(check_tensions, case, 400, water_density=1025.0 * 1.01)
    must_fail(check_hard_bed, case, 50, 0.5)
