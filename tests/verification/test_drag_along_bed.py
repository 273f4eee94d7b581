"""A chain dragged over a flat bed takes mu w L, in any number of segments and any direction.

Verifies: friction, contact, motion

200 m of chain lie on the bed without drag and are dragged at 0.5 m/s, with a coefficient mu = 0.5 along itself and 0.8
across. The nodes that lie on the bed weigh what the chain weighs, so that the pull is mu w L on any mesh once the chain
slides steadily, and the tension mu w s, s counted from the free end: exactly so in the middle of each segment. Pulled
by its end the chain rings; means over 10 s count, and must be within 0.05 % of mu w L (0.5 % is asked by the issue).

Dragged with all nodes held (a chain of lines of one segment each) at an angle b to itself, a chain that sticks to the
ellipse (F_a / mu_a N)^2 + (F_t / mu_t N)^2 = 1 and is rubbed against its velocity has

    mu = 1 / sqrt(cos^2 b / mu_a^2 + sin^2 b / mu_t^2)

in "elastic-slip" and "stick-slip". "saturated-damping" and "velocity-dependent" take both parts at their full size
(equations 7 to 13 of Housner et al. 2022): (mu_a, mu_t) at any angle but 0 and 90 degrees. With static friction above
kinetic by r, "stick-slip" keeps (r - 1) / (1 + (v / v_s)^2) of it, by its own formula.

MoorDyn's default damper, 200 N s/m a node, gives 200 mu v a node: 0.3 % of Coulomb's force on 10 segments, 2.2 % on 80.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import at_rest, coupled, free, kind, line, mooring, run, weight_in_water

from moorage.model import Friction, Motion

CHAIN = kind(diameter=0.1, mass_per_length=100.0, axial_stiffness=1e8, axial_damping_ratio=1.0)
LENGTH, DEPTH, SPEED, AXIAL, TRANSVERSE = 200.0, 100.0, 0.5, 0.5, 0.8
WEIGHT = weight_in_water(CHAIN) * LENGTH
LEVEL = -DEPTH - weight_in_water(CHAIN) / (3e6 * CHAIN.diameter)
LAWS = ["elastic-slip", "stick-slip", "saturated-damping", "velocity-dependent"]


def pulled(places: np.ndarray, held: list[int], lines, angle: float, law: str, **properties: float):
    """Pull on the held points (N), the way, and the last 10 s of a run of 30 s at an angle (degrees) to the chain."""
    towards = np.array([np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle)), 0.0])
    time = np.arange(0.0, 32.0, 0.25)
    way = SPEED * np.where(time < 5.0, time**2 / 10.0, time - 2.5)
    motion = Motion.from_points(time, {k: places[k - 1] + way[:, None] * towards for k in held})
    points = [(coupled if k in held else free)(k, *p) for k, p in enumerate(places, 1)]
    friction = Friction(**({"axial": AXIAL, "transverse": TRANSVERSE, "model": law, "damping": 1e6} | properties))
    built = at_rest(mooring(CHAIN, points, lines, water_depth=DEPTH, friction=friction), motion)
    block = run(built, 30.0, dt_out=0.1, dt_nodes=0.1, tolerance=1e-4)
    late = {name: values[-100:] for name, values in block.items()}
    return -late["point_force"][:, np.array(held) - 1].sum(axis=1).mean(axis=0), towards, late


def dragged_by_its_end(law: str, segments: int, **properties: float):
    chain = line(1, 1, 2, (CHAIN.name, LENGTH, segments))
    ends = np.array([[0.0, 0.0, LEVEL], [LENGTH, 0.0, LEVEL]])
    return pulled(ends, [2], [chain], 0.0, law, **properties)


def dragged_as_one(law: str, angle: float, pieces: int = 10, **properties: float) -> np.ndarray:
    """Pull over w L along the chain and across it."""
    chain = [line(k, k, k + 1, (CHAIN.name, LENGTH / pieces, 1)) for k in range(1, pieces + 1)]
    nodes = np.linspace([0.0, 0.0, LEVEL], [LENGTH, 0.0, LEVEL], pieces + 1)
    pull, _, late = pulled(nodes, list(range(1, pieces + 2)), chain, angle, law, **properties)
    assert late["friction_force"].sum(axis=1).mean(axis=0) == pytest.approx(-pull, abs=1e-4 * WEIGHT)
    return pull[:2] / WEIGHT


def check_pull(law: str, segments: int, mu: float = AXIAL, **properties: float) -> None:
    pull, towards, late = dragged_by_its_end(law, segments, **properties)
    assert pull @ towards / WEIGHT == pytest.approx(mu, rel=5e-4)
    behind = (np.arange(segments) + 0.5) / segments
    assert late["segment_tension"].mean(axis=0) / WEIGHT == pytest.approx(mu * behind, abs=2e-3 * mu)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("segments", [10, 20, 40, 80])
def test_pull_along_the_bed(law, segments):
    check_pull(law, segments)


def ellipse(angle: float) -> float:
    c, s = np.cos(np.deg2rad(angle)), np.sin(np.deg2rad(angle))
    return float(1.0 / np.hypot(c / AXIAL, s / TRANSVERSE))


def check_angle(law: str, angle: float, mu: float, **properties: float) -> None:
    b = np.deg2rad(angle)
    assert dragged_as_one(law, angle, **properties) == pytest.approx([mu * np.cos(b), mu * np.sin(b)], abs=1e-6)


@pytest.mark.parametrize("law", LAWS)
def test_pull_sideways(law):
    check_angle(law, 90.0, TRANSVERSE)
    check_angle(law, 0.0, AXIAL)


@pytest.mark.parametrize("law", ["elastic-slip", "stick-slip"])
@pytest.mark.parametrize("angle", [20.0, 45.0, 160.0, 225.0])
def test_pull_at_an_angle_is_on_the_ellipse(law, angle):
    check_angle(law, angle, ellipse(angle))


@pytest.mark.parametrize("law", ["saturated-damping", "velocity-dependent"])
def test_pull_at_an_angle_by_laws_of_both_parts(law):
    assert dragged_as_one(law, 45.0) == pytest.approx([AXIAL, TRANSVERSE], abs=1e-6)


@pytest.mark.parametrize("law", ["stick-slip", "saturated-damping", "velocity-dependent"])
def test_steady_sliding_has_the_kinetic_coefficient(law):
    left = 0.3 / (1.0 + (SPEED / 0.01) ** 2) if law == "stick-slip" else 0.0
    check_angle(law, 90.0, TRANSVERSE * (1.0 + left), static_ratio=1.3)


def test_default_damper_depends_on_the_mesh():
    for pieces in (10, 80):
        found = dragged_as_one("saturated-damping", 0.0, pieces, damping=200.0)
        # two nodes at each joint
        assert found[0] == pytest.approx(200.0 * AXIAL * SPEED * 2 * pieces / WEIGHT, rel=1e-6)


def test_wrong_variants_fail():
    """Coefficients exchanged; MoorDyn's default damper; each rule for 45 degrees in place of the other."""
    must_fail(check_pull, "elastic-slip", 20, axial=TRANSVERSE, transverse=AXIAL)
    must_fail(check_pull, "saturated-damping", 20, damping=200.0)
    must_fail(check_angle, "elastic-slip", 45.0, np.hypot(AXIAL, TRANSVERSE) / np.sqrt(2.0))
    must_fail(check_angle, "saturated-damping", 45.0, ellipse(45.0))
