"""What the jump of the bilinear normal does: a rope slides through a valley over the edges of its cells.

Verifies: bathymetry, contact

A short rope without friction slides down a parabolic valley z = x^2 / R from 60 m beside its middle and up the other
side, in vacuum, on a bed with a damper. Where the slope turns by a, the rope comes into the next plane with the speed v a
against it, which the damper takes if it is quick: (v a)^2 / 2 for each kilogram. With v^2 = 2 g (z0 - z) and a = 2 dx / R,
the valley of cells dx takes the share

    sum over its edges of (1 - z / z0) (2 dx / R)^2

of the height z0 at most, since the turn takes its time (2 % of a cell): first order in dx. Measured: 1.0 % at 20 m (of 2.5 %), 0.8 %
at 10 m, 0.5 % at 5 m. The smooth bed is the valley itself and takes 0.06 % at any spacing.
"""

from __future__ import annotations

import numpy as np
from common import must_fail
from moorings import at_rest, free, kind, run, single

from moorage.model import Bathymetry

ROPE = kind(diameter=0.1, mass_per_length=50.0, axial_stiffness=1e6, axial_damping_ratio=1.0)
RADIUS, BEGIN, DEPTH = 500.0, 60.0, 100.0


def lost(spacing: float, smooth: bool) -> float:
    """Return the share of the height that is lost on the way to the other side."""
    x = np.arange(-200.0, 200.5, spacing)
    depths = tuple((DEPTH - xi**2 / RADIUS,) * 2 for xi in x)
    bed = Bathymetry(tuple(x), (-100.0, 100.0), depths, smooth=smooth)
    z = -bed.depth_at(BEGIN, 0.0)
    a, b = np.array([BEGIN, -2.0, z]), np.array([BEGIN, 2.0, z])
    model = single(
        ROPE, 4.0, 2, free(1, *a), free(2, *b), water_depth=DEPTH, water_density=0.0, seabed_stiffness=1e6,
        seabed_damping=4.5e4, bathymetry=bed,
    )  # fmt: skip
    built = at_rest(model)
    built.state.position[:3] = np.linspace(a, b, 3)
    path = run(built, 20.0, dt_out=0.1, dt_nodes=0.05, time_step=0.005, tolerance=1e-7)["node_position"][:, 1]
    end = path[path[:, 0].argmin()]
    return float(1.0 - (end[2] + DEPTH) / (path[0, 2] + DEPTH))


def taken_by_edges(spacing: float) -> float:
    edges = np.arange(-BEGIN + spacing, BEGIN - 0.5 * spacing, spacing)
    return float(np.sum(1.0 - (edges / BEGIN) ** 2) * (2.0 * spacing / RADIUS) ** 2)


def check_nothing_is_lost(smooth: bool) -> None:
    assert abs(lost(20.0, smooth)) < 1e-3


def test_edges_take_less_than_their_turns():
    shares = [lost(spacing, False) for spacing in (20.0, 10.0, 5.0)]
    assert all(0.0 < share < taken_by_edges(h) for share, h in zip(shares, (20.0, 10.0, 5.0), strict=True)), shares
    assert shares[0] > shares[1] > shares[2] > 2e-3, shares


def test_smooth_bed_takes_nothing():
    check_nothing_is_lost(True)


def test_bilinear_bed_fails():
    must_fail(check_nothing_is_lost, False)
