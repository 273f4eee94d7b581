"""A chain that lies on an inclined bed and hangs from it: statics against the closed form.

Verifies: bathymetry, contact, tension, weight

On a smooth plane that rises at an angle a from the anchor to the fairlead, the weight's part along the bed adds up,

    T(s) = T_A + w s sin a        up to the place s_t where the line leaves the bed,

and from there on, at the slope of the bed, the line is a catenary with H = T_t cos a and V_0 = T_t sin a (the equations
of `common.Catenary`, there for a level bed). T_t and s_t are chosen, and give the place of the fairlead. The bed is
stiff: the chain sinks in by 30 um. The plane rises or falls by 8 degrees along a heading of 25 degrees, over a grid that
it cuts at an angle.

A segment has the direction at its middle for all of its length: tensions and places err with the square of that. How
much depends on where in a segment the line leaves the bed; meshes of 20, 60 and 180 keep that in its middle. The rate
must be 2 within 0.2, and 180 segments within 1e-4 of the tension at the fairlead and of the length. Another slope, by
half a degree, fails.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate
from moorings import coupled, fixed, kind, nodes, single, statics, weight_in_water

from moorage.model import Bathymetry
from moorage.solve.march import March, Settings

CHAIN = kind(diameter=0.1, mass_per_length=100.0, axial_stiffness=5e7)
W, EA = weight_in_water(CHAIN), CHAIN.axial_stiffness
LENGTH, DEPTH, STIFFNESS = 600.0, 400.0, 3e8
HEADING = np.deg2rad(25.0)
TOUCH = 7.5 / 20.0 * LENGTH
TENSIONS = {8.0: 9e4, -8.0: 1.5e5}  # slope, degrees: tension at the touch-down, N


def level(x, slope: float):
    """z of the bed at a distance x (m) from the anchor."""
    return x * np.tan(slope) - DEPTH


def at_touch(slope: float) -> float:
    return TENSIONS[round(float(np.rad2deg(slope)))]


def shape(s, slope: float) -> np.ndarray:
    """Return x and z (2, ...) from the anchor at arc lengths s (m)."""
    T, on, up = at_touch(slope), np.minimum(s, TOUCH), np.maximum(s - TOUCH, 0.0)
    along = on * (1.0 + (T - W * np.sin(slope) * (TOUCH - 0.5 * on)) / EA)
    H, V0 = T * np.cos(slope), T * np.sin(slope)
    V = V0 + W * up
    x = H * up / EA + H / W * (np.arcsinh(V / H) - np.arcsinh(V0 / H))
    z = up / EA * (V0 + 0.5 * W * up) + (np.hypot(H, V) - np.hypot(H, V0)) / W
    return np.array([x + along * np.cos(slope), z + along * np.sin(slope)])


def tension(s, slope: float):
    T, up = at_touch(slope), np.maximum(s - TOUCH, 0.0)
    lying = T - W * np.sin(slope) * (TOUCH - s)
    return np.where(s < TOUCH, lying, np.hypot(T * np.cos(slope), T * np.sin(slope) + W * up))


def chain(segments: int, slope: float, other: float = 0.0):
    span, rise = shape(LENGTH, slope)
    x, y = np.linspace(-100.0, 700.0, 9), np.linspace(-300.0, 500.0, 5)
    down = x[:, None] * np.cos(HEADING) + y[None, :] * np.sin(HEADING)
    grid = Bathymetry(tuple(x), tuple(y), tuple(map(tuple, -level(down, slope + other))))
    there = span * np.array([np.cos(HEADING), np.sin(HEADING)])
    ends = fixed(1, 0.0, 0.0, -DEPTH), coupled(2, *there, rise - DEPTH)
    return single(CHAIN, LENGTH, segments, *ends, water_depth=DEPTH, seabed_stiffness=STIFFNESS, bathymetry=grid)


def errors(segments: int, slope: float, other: float = 0.0) -> tuple[float, float]:
    """Return the largest errors of tensions (of that at the fairlead) and of places (of the length)."""
    built = statics(chain(segments, slope, other))
    found = March(built, Settings(dt_nodes=1.0), 0.0).first()["segment_tension"][0]
    s = np.linspace(0.0, LENGTH, segments + 1)
    exact = tension(0.5 * (s[1:] + s[:-1]), slope)
    x, z = shape(s, slope)
    place = nodes(built) - np.stack([x * np.cos(HEADING), x * np.sin(HEADING), z - DEPTH], axis=1)
    worst = np.abs(found - exact).max() / exact[-1]
    return float(worst), float(np.linalg.norm(place, axis=1).max() / LENGTH)


def check(slope: float, other: float = 0.0) -> None:
    segments = np.array([20, 60, 180])
    found = np.array([errors(n, np.deg2rad(slope), np.deg2rad(other)) for n in segments])
    for column in found.T:
        assert rate(1.0 / segments, column) == pytest.approx(2.0, abs=0.2), found
        assert column[2] < 1e-4, found


@pytest.mark.parametrize("slope", TENSIONS)
def test_chain_on_a_slope(slope):
    check(slope)


@pytest.mark.parametrize("slope", TENSIONS)
def test_tension_changes_by_the_weight_along_the_bed(slope):
    """Between nodes on the bed this is exact, whatever the mesh."""
    n = 20
    found = March(statics(chain(n, np.deg2rad(slope))), Settings(dt_nodes=1.0), 0.0).first()["segment_tension"][0]
    change = np.diff(found[:7])
    assert change == pytest.approx(W * LENGTH / n * np.sin(np.deg2rad(slope)), rel=1e-3)


@pytest.mark.parametrize("slope", TENSIONS)
def test_other_slope_fails(slope):
    must_fail(check, slope, 0.5)
