"""The lazy-wave umbilical of Hall, Sirnivas & Yu 2020 in still water, four cables joined by free rods.

Verifies: bending, tension, weight, contact

Reference: MoorDyn-C 2.7.2 and MoorDyn-F, 60 s with the top held. At the end both still swing by some 7 cm with a period of
30 s, so that what is compared with is the mean of all nodes over the last 30 s, within the 3 cm to which the two agree,
and of the tensions: at the top within 0.5 %, at the anchor within 1 % (segments there move on the bed). Curvature at the
nodes must be theirs within 2 % of the largest where the cable does not touch the bed: there MoorDyn-C's swings with the
point of touch-down. EI 20 % lower must fail.
"""

from __future__ import annotations

import dataclasses
import warnings

import numpy as np
import pytest
from common import must_fail

import moorage

NODES = (5, 54, 26, 56)


def late(path) -> np.ndarray:
    """Mean of all columns over the last 30 s."""
    rows = np.loadtxt(path, delimiter=",", skiprows=1)
    return rows[rows[:, 0] > rows[-1, 0] - 29.99].mean(axis=0)


@pytest.fixture(scope="module")
def solved(reference):
    """Solve the umbilical with EI changed by a factor."""
    done = {}

    def solve(factor: float = 1.0):
        if factor not in done:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", moorage.ModelWarning)
                model = moorage.read(reference / "rm3_umbilical" / "still" / "moordyn_C.dat")
                types = [
                    dataclasses.replace(t, bending_stiffness=factor * t.bending_stiffness) for t in model.line_types
                ]
                done[factor] = moorage.solve_statics(dataclasses.replace(model, line_types=tuple(types)))
        return done[factor]

    return solve


@pytest.mark.parametrize("program", "CF")
def test_positions(program, solved, reference):
    ours = np.split(solved()["node_position"].values, np.cumsum(NODES)[:-1])
    for k, n in enumerate(NODES, 1):
        theirs = late(reference / "rm3_umbilical" / "still" / f"line{k}_{program}.csv")[1 : 3 * n + 1].reshape(n, 3)
        assert np.abs(ours[k - 1] - theirs).max() < 0.03, f"line {k}"


@pytest.mark.parametrize("program", "CF")
def test_tensions(program, solved, reference):
    theirs = late(reference / "rm3_umbilical" / "still" / f"main_{program}.csv")
    assert solved()["LINE1TENA"] == pytest.approx(theirs[1], rel=0.005)
    assert solved()["LINE4TENB"] == pytest.approx(theirs[2], rel=0.01)


def check_curvature(solved, reference, factor: float) -> None:
    ours = np.split(solved(factor)["curvature"].values, np.cumsum(NODES)[:-1])
    theirs = [
        late(reference / "rm3_umbilical" / "still" / f"line{k}_F.csv")[3 * n + 1 : 4 * n + 1]
        for k, n in enumerate(NODES, 1)
    ]
    free = slice(1, -1)
    largest = max(part[free].max() for part in theirs[:3])
    for mine, other in zip(ours[:3], theirs[:3], strict=True):
        assert np.abs(mine[free] - other[free]).max() < 0.02 * largest


def test_curvature(solved, reference):
    check_curvature(solved, reference, 1.0)


def test_softer_cable_fails(solved, reference):
    must_fail(check_curvature, solved, reference, 0.8)
