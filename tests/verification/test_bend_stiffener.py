"""A tapered bend stiffener at the root of a cantilever: its stiffness, mass and buoyancy.

Verifies: bending, weight

With x from the tip and D(s) the outer diameter of the sleeve at a distance s from the root,

    deflection = P integral of x^2 / (EI + E pi / 64 (D^4 - d^4)) dx
    mass = density V,   lift = g rho V,   V = pi l / 12 (D0^2 + D0 D1 + D1^2) - pi / 4 d^2 l   (a hollow frustum)

against adaptive quadrature, and against the frustum. Segments take the values at their middles: all errors are of second
order, rates within 0.1 of 2 and below 0.2 % where the sleeve covers 16 segments. A stiffener that ends within a
segment gives it the covered share. Turned round, root at the wrong end, it must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import VACUUM, at_once, beam, between, cantilever, deflection, sections
from common import must_fail, rate
from moorings import DENSITY, GRAVITY, statics
from scipy.integrate import quad

from moorage.model import BendStiffener, Curve
from moorage.system.segments import segment_table

LENGTH, EI, d = 8.0, 1e4, 0.15
SLEEVE = BendStiffener(end="A", length=4.0, root_diameter=0.6, tip_diameter=0.2, youngs_modulus=1e7, density=1150.0)
SEGMENTS = np.array([8, 16, 32, 64])
VOLUME = np.pi * 4.0 / 12.0 * (0.6**2 + 0.6 * 0.2 + 0.2**2) - np.pi / 4.0 * d**2 * 4.0


def stiffness(s: float) -> float:
    D = 0.6 + (0.2 - 0.6) * s / 4.0
    return EI + (1e7 * np.pi / 64.0 * (D**4 - d**4) if s < 4.0 else 0.0)


def compliance(segments: int, sleeve: BendStiffener) -> float:
    """Of the tip over the force, m/N."""
    cable = beam(EI, diameter=d)
    model = cantilever(cable, sections(("beam", LENGTH, segments)), (0.0, 0.0, -0.1), stiffeners=(sleeve,))
    return deflection(statics(model, tolerance=1e-8)) / 0.1


def check(sleeve: BendStiffener) -> None:
    inner, _ = quad(lambda s: (LENGTH - s) ** 2 / stiffness(s), 0.0, 4.0, epsrel=1e-10)
    exact = inner + 4.0**3 / (3.0 * EI)
    errors = np.array([abs(compliance(int(n), sleeve) / exact - 1.0) for n in SEGMENTS])
    assert errors[2] < 2e-3
    assert abs(rate(1.0 / SEGMENTS, errors) - 2.0) < 0.1, f"{errors}"


def test_tapered_beam():
    check(SLEEVE)


def test_stiffness_as_a_table():
    """The same EI along the sleeve, given as a table of 65 rows: its chords are off by less than 2e-4."""
    s = np.linspace(0.0, 4.0, 65)
    added = *(stiffness(x) - EI for x in s[:-1]), 1e7 * np.pi / 64.0 * (0.2**4 - d**4)
    tabulated = dataclasses.replace(SLEEVE, stiffness=Curve(tuple(s), added), youngs_modulus=0.0)
    assert compliance(32, tabulated) == pytest.approx(compliance(32, SLEEVE), rel=2e-4)


@pytest.mark.parametrize("end", ["A", "B"])
@pytest.mark.parametrize("density", [0.0, DENSITY])
def test_mass_and_lift(end, density):
    """The clamps carry the cable and the sleeve."""
    errors = []
    for segments in SEGMENTS:
        cable = beam(EI, diameter=d, mass_per_length=30.0)
        sleeve = dataclasses.replace(SLEEVE, end=end)
        model = between(
            cable, sections(("beam", LENGTH, int(segments))), (0.0, 0.0, -30.0), (1.0, 0.0, 0.0),
            (LENGTH, 0.0, -30.0), (1.0, 0.0, 0.0), VACUUM | {"gravity": GRAVITY, "water_density": density},
            stiffeners=(sleeve,),
        )  # fmt: skip
        table = segment_table(model)
        mass = np.sum(table["mass"] * table["length"])
        volume = np.sum(table["area"] * table["length"])
        errors.append((mass - 30.0 * LENGTH - SLEEVE.density * VOLUME, volume - np.pi / 4.0 * d**2 * LENGTH - VOLUME))
        built = statics(model)
        carried = -_vertical(built)
        assert carried == pytest.approx(GRAVITY * (mass - density * volume), rel=1e-6, abs=1e-2)
    errors = np.abs(errors)
    assert errors[1, 0] < 2e-3 * SLEEVE.density * VOLUME
    assert np.abs(errors[:, 0] / errors[:, 1] - SLEEVE.density).max() < 1e-3 * SLEEVE.density
    assert abs(rate(1.0 / SEGMENTS, errors[:, 1]) - 2.0) < 0.1


def _vertical(built) -> float:
    """Upward pull of the cable on both clamps together, N."""
    return float(at_once(built)["end_force"][0, 0, :, 2].sum())


def test_part_of_a_segment():
    """4 m on segments of 1.6 m: the third is covered by half, and takes half of what the sleeve has in its middle there."""
    model = cantilever(beam(EI, diameter=d), sections(("beam", LENGTH, 5)), (0.0, 0.0, 0.0), stiffeners=(SLEEVE,))
    D = SLEEVE.diameter(3.6)
    assert segment_table(model)["bending_stiffness"][2] == pytest.approx(EI + 0.5 * 1e7 * np.pi / 64.0 * (D**4 - d**4))
    assert (segment_table(model)["bending_stiffness"][3:] == EI).all()


def test_root_at_the_wrong_end_fails():
    must_fail(check, dataclasses.replace(SLEEVE, end="B"))
