"""A cantilever with a mass at its tip that is let go straight: MoorDyn-C's swing (Hall, Sirnivas & Yu 2020, figure 4).

Verifies: bending, morison, tension

Reference: MoorDyn-C 2.7.2 with steps of 0.2 ms and less, places of the tip every 0.05 s for 30 s. The same files are read,
so that the clamp follows equation 10. One difference is intended. MoorDyn divides by the *present* length of a segment
where Moorage divides by the unstretched one, so that bends follow from an energy. That counts where the beam swings up
and the segment at the clamp goes slack, by up to 3 % on 8 segments. The rms error of the tip, over the standard
deviation of its movement, must be less than 1e-3 plus the largest shortening of a segment, and the period right to
2e-4. EI 1 % higher must fail.
"""

from __future__ import annotations

import dataclasses
import warnings

import numpy as np
import pytest
from common import must_fail

import moorage

CASES = {f"L10_m{mass}_N{n}": True for mass in (1000, 2000) for n in (2, 4, 6, 8)}  # whether it swings
CASES |= {"L20_m1000_N10": False, "L20_m2000_N10": False}


def table(path) -> np.ndarray:
    return np.loadtxt(path, delimiter=",", skiprows=1)


def period(z) -> float:
    """Mean time between upward passes of the mean, s."""
    z = z - z.mean()
    k = np.flatnonzero((z[1:] > 0.0) & (z[:-1] <= 0.0))
    return float(0.05 * np.mean(np.diff(k + z[k] / (z[k] - z[k + 1]))))


def swing(folder, stiffer: float) -> np.ndarray:
    """Places (x, z) of the tip every 0.05 s."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        model = moorage.read(folder / "moordyn_C.dat")
        cable = model.line_types[0]
        cable = dataclasses.replace(cable, bending_stiffness=stiffer * cable.bending_stiffness)
        model = dataclasses.replace(model, line_types=(cable,))
        ds = moorage.simulate(model, duration=30.0, dt_out=0.05, tolerance=1e-6, save="tensions")
    return np.column_stack([ds["POINT1PX"], ds["POINT1PZ"]])


def check(folder, swings: bool, stiffer: float = 1.0) -> None:
    ours, theirs, line = swing(folder, stiffer), table(folder / "tip_C.csv")[:, 1:3], table(folder / "line_C.csv")
    n = round((line.shape[1] - 4) / 4)  # segments: t, three coordinates of n + 1 nodes, n tensions
    lengths = np.linalg.norm(np.diff(line[:, 1 : 3 * n + 4].reshape(-1, n + 1, 3), axis=1), axis=2)
    shortening = 1.0 - lengths.min() / lengths[0].max()
    errors = np.sqrt(np.mean((ours - theirs) ** 2, axis=0)) / theirs.std(axis=0)
    assert (errors < 1e-3 + max(shortening, 0.0)).all(), f"{errors}, {shortening}"
    if swings:
        assert period(ours[:, 1]) == pytest.approx(period(theirs[:, 1]), rel=2e-4)


@pytest.mark.parametrize("case", CASES)
def test_swing_of_moordyn(case, reference):
    check(reference / "bending" / f"{case}_decay", CASES[case])


def test_stiffer_cable_fails(reference):
    must_fail(check, reference / "bending" / "L10_m1000_N2_decay", True, 1.01)
