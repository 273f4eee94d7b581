"""Maps of the bed's stiffness and of friction's coefficients over x and y.

Verifies: grid, friction, contact

A chain without drag is dragged along a bed whose coefficient grows evenly, mu = a + b x + c y. The sum of mu w over its
nodes is w L times mu at its centre, exactly, on any mesh; its tension rings, so that the pull, over which a straight
line in time is fitted, must follow w L (a + b (x_m + v t)) within 0.2 % at both ends of the last 10 s. Across a chain
that lies along x the same holds with c.

At rest on a bed of stiffness k(x, y) a chain without bending stiffness, held where it belongs, sinks in by w / (k d)
at each node; segments of 5 m pull each other by their slack only, so that 1e-6 of the depth must be met.

Transposed maps must be noticed.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import at_rest, coupled, fixed, free, kind, nodes, run, single, statics, weight_in_water

from moorage.model import Friction, FrictionMap, Motion, StiffnessMap

CHAIN = kind(diameter=0.1, mass_per_length=100.0, axial_stiffness=1e8, axial_damping_ratio=1.0)
LENGTH, DEPTH, SPEED, SEGMENTS = 200.0, 100.0, 0.5, 40
W = weight_in_water(CHAIN)
LEVEL = -DEPTH - W / (3e6 * CHAIN.diameter)
A, B, C = 0.5, 1e-3, 4e-3  # coefficient, and its growth along x and y, 1/m


def rising(b: float, c: float) -> FrictionMap:
    """Coefficients a + b x + c y on an uneven grid, across twice as large."""
    x, y = (-50.0, 20.0, 90.0, 300.0), (-60.0, 10.0, 80.0)
    axial = tuple(tuple(A + b * xi + c * yi for yi in y) for xi in x)
    return FrictionMap(x, y, axial, tuple(tuple(2.0 * mu for mu in row) for row in axial))


def check_pull(b: float, c: float, law: str = "elastic-slip", read: tuple[float, float] | None = None) -> None:
    friction = Friction(model=law, damping=1e6, map=rising(*(read or (b, c))))
    time = np.arange(0.0, 32.0, 0.25)
    way = SPEED * np.where(time < 5.0, time**2 / 10.0, time - 2.5)
    motion = Motion.from_points(time, {2: np.array([LENGTH, 0.0, LEVEL]) + way[:, None] * [1.0, 0.0, 0.0]})
    ends = free(1, 0.0, 0.0, LEVEL), coupled(2, LENGTH, 0.0, LEVEL)
    built = at_rest(single(CHAIN, LENGTH, SEGMENTS, *ends, water_depth=DEPTH, friction=friction), motion)
    block = run(built, 30.0, dt_out=0.1, tolerance=1e-4)
    late = block["time"] >= 20.0
    t, pull = block["time"][late], -block["point_force"][late, 1, 0]
    fit = np.polyval(np.polyfit(t, pull, 1), t[[0, -1]]) / (W * LENGTH)
    stretch = 0.5 * A * W * LENGTH / 1e8 * LENGTH / 3.0  # its centre is that much behind half its length
    centre = 0.5 * LENGTH + SPEED * (t[[0, -1]] - 2.5) - stretch
    assert fit == pytest.approx(A + b * centre, rel=2e-3)


@pytest.mark.parametrize("law", ["elastic-slip", "saturated-damping", "velocity-dependent"])
def test_pull_grows_with_the_coefficient_along_the_way(law):
    check_pull(B, C, law)


def test_a_transposed_map_is_noticed():
    must_fail(check_pull, B, C, read=(C, B))


def check_depth(kx: float = 2e4, ky: float = 0.0) -> None:
    x, y = (-10.0, 60.0, 210.0), (-5.0, 5.0)
    stiff = tuple(tuple(1e6 + kx * xi + ky * yi for yi in y) for xi in x)
    place = np.linspace(0.0, LENGTH, SEGMENTS + 1)
    sinks = W / ((1e6 + 2e4 * place) * CHAIN.diameter)
    ends = fixed(1, 0.0, 0.0, -DEPTH - sinks[0]), fixed(2, LENGTH, 0.0, -DEPTH - sinks[-1])
    model = single(CHAIN, LENGTH, SEGMENTS, *ends, water_depth=DEPTH, seabed_stiffness_map=StiffnessMap(x, y, stiff))
    found = -DEPTH - nodes(statics(model))[:, 2]
    assert found == pytest.approx(sinks, rel=1e-3)


def test_a_chain_sinks_in_where_the_bed_is_soft():
    check_depth()
    must_fail(check_depth, 0.0, 2e4)
