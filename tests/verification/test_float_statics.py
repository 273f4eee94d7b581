"""Statics of floats on stiff cables: 100 random ones, all of which must come to rest, in balance and stable.

Verifies: bending, rigid, tension, weight, contact

Spars on one or two cables, under water and in the surface; bodies that clamp three cables; and a body with a rod hung
beside it by two cables that are joined: 20 of each. EI from 100 to 1e5 N m2, EA over two decades, lines of 2 % to 80 %
of the slack at which they would hang straight down and lie straight on the bed. Cables carry compression: each must be
found. The whole matrix, of lines, floats and clamps, must have no eigenvalue below -1e-8 of the largest (slack nodes on
the bed, and a spar on one cable, move without resistance: zero is no failure).

Segments that go slack have no equilibrium where such a cable pushes: they would shrink to nothing. Of the same cables
without compression, those must be told of, and none may fail.

Wrong: Newton's method with line search and continuation alone, as ropes need, fails for many.
"""

from __future__ import annotations

import warnings

import numpy as np
from common import must_fail
from floats import body, floating, rod
from moorings import DENSITY, fixed, held, joint, kind, line

from moorage.errors import ConvergenceError, ModelWarning
from moorage.model import LineType, Model, RodType
from moorage.solve import statics
from moorage.solve.modes import island_pencil
from moorage.solve.statics import solve
from moorage.solve.statics_flow import imbalance
from moorage.solve.statics_kernel import descend_island, relax_island
from moorage.system.build import build

COUNT, DEPTH = 100, 60.0
KINDS = "spar", "spar on one cable", "body", "body to rod", "spar in the surface"
AROUND = 2.0 * np.pi / 3.0 * np.arange(3)
HULL = {"mass": 2e3, "inertia": (2e3, 2e3, 2e3), "centre_of_gravity": (0.0, 0.0, -0.8)}


def cable(random, pushes: bool) -> LineType:
    d = random.uniform(0.08, 0.3)
    return kind(
        "cable", diameter=d, mass_per_length=DENSITY * np.pi / 4.0 * d**2 * random.uniform(1.2, 3.0),
        axial_stiffness=10.0 ** random.uniform(6.5, 8.5), bending_stiffness=10.0 ** random.uniform(2.0, 5.0),
        carries_compression=pushes,
    )  # fmt: skip


def random_float(number: int, pushes: bool = True) -> Model:
    random, what = np.random.default_rng(number), KINDS[number % len(KINDS)]
    type, n, share = cable(random, pushes), int(random.integers(8, 25)), random.uniform(0.02, 0.8)

    def length(a, b) -> float:
        d = np.abs(np.subtract(a, b))
        chord = float(np.linalg.norm(d))
        return chord + share * (float(np.hypot(d[0], d[1]) + d[2]) - chord)

    if what.startswith("spar"):
        lean, size = random.normal(0.0, 0.3, 2), random.uniform(0.4, 1.2)
        up = np.array([*lean, 1.0])
        low = np.array([0.0, 0.0, -6.0]) if "surface" in what else random.uniform([-3, -3, -25], [3, 3, -10])
        high = low + 9.0 * up if "surface" in what else low + random.uniform(2.0, 8.0) * up / np.linalg.norm(up)
        hull = RodType(
            name="spar", diameter=size, mass_per_length=DENSITY * np.pi / 4.0 * size**2 * random.uniform(0.2, 0.8)
        )
        spar = rod(1, "free", low, high)
        anchors = fixed(1, -30.0, 0.0, -DEPTH), fixed(2, 25.0, 20.0, -DEPTH)
        lines = [line(a.id, a.id, held(spar, "A"), ("cable", length(a.position, low), n)) for a in anchors]
        count = 1 if "one" in what else 2
        return floating((), (spar,), hull, type, {"water_depth": DEPTH}, points=anchors, lines=lines[:count])
    place = np.array([0.0, 0.0, random.uniform(-25.0, -8.0)])
    hull = body(1, position=tuple(place), rotation=tuple(random.normal(0.0, 0.15, 3)), volume=random.uniform(2.5, 8.0),
                 **HULL)  # fmt: skip
    out = np.stack([np.cos(AROUND), np.sin(AROUND), np.zeros(3)], axis=1)
    arms = 1.5 * out - [0.0, 0.0, 0.5]
    clamps = [rod(1 + k, "fixed", a, a + 0.2 * (out[k] - [0.0, 0.0, 1.0]), 0, body=1) for k, a in enumerate(arms)]
    anchors = [fixed(1 + k, *(30.0 * e - [0.0, 0.0, DEPTH])) for k, e in enumerate(out)]
    moored = [line(1 + k, 1 + k, held(c, "B"), ("cable", length(anchors[k].position, place + arms[k]), n))
              for k, c in enumerate(clamps)]  # fmt: skip
    if what == "body":
        return floating((hull,), clamps, (), type, {"water_depth": DEPTH}, points=anchors, lines=moored)
    low = random.uniform([12.0, 0.0, -30.0], [25.0, 0.0, -15.0])
    stick, middle = (
        rod(4, "free", low, np.add(low, [0.3, 0.2, 4.0]), 3),
        joint(5, *(0.5 * (low + place) - [0.0, 0.0, 6.0])),
    )
    half = (0.51 + 0.2 * share) * np.linalg.norm(low - place)
    lines = [line(1, held(clamps[0], "B"), held(middle, "A"), ("cable", half, n // 2)),
             line(2, held(middle, "B"), held(stick, "A"), ("cable", half, n // 2)),
             line(3, 1, held(stick, "A"), ("cable", length(low, anchors[0].position), n)),
             line(4, 2, held(clamps[1], "B"), ("cable", length(place + arms[1], anchors[1].position), n))]  # fmt: skip
    types = RodType(name="spar", diameter=0.6, mass_per_length=120.0)
    return floating((hull,), (*clamps, stick, middle), types, type, {"water_depth": DEPTH}, points=anchors, lines=lines)


def left(built) -> float:
    """Return the largest force, or moment over size, that is out of balance, N."""
    system = statics.static_system(built.system)
    return max(
        imbalance(system, built.state, built.work, island)[0] for island in range(len(system.islands.line_ptr) - 1)
    )


def least_eigenvalue(built) -> float:
    """Return the least eigenvalue of the stiffness of any island over the largest."""
    least = 0.0
    for island in range(len(built.system.islands.line_ptr) - 1):
        K = island_pencil(built, island).stiffness.toarray()
        squares = np.linalg.eigvalsh(0.5 * (K + K.T))
        least = min(least, squares[0] / squares[-1])
    return least


def check(count: int = COUNT) -> None:
    failed, wrong = [], []
    for number in range(count):
        built = build(random_float(number))
        try:
            equilibrium = solve(built)
        except ConvergenceError:
            failed.append(number)
            continue
        force, least = left(built), least_eigenvalue(built)
        if force > 1.001 * equilibrium.tolerance or least < -1e-8:
            wrong.append((number, force, least))
    assert not failed, f"{failed}"
    assert not wrong, f"{wrong}"


def test_all_come_to_rest():
    check()


def test_increments_for_ropes_fail(monkeypatch):
    monkeypatch.setattr(statics, "_ways", lambda built, island, begin, hung, asked, accepted: [
        (begin, relax_island, asked, 300), (hung, descend_island, accepted, 2000)
    ])  # fmt: skip
    monkeypatch.setattr(statics, "flow_island", lambda *parts: (1e300, -1, 0, 0))
    must_fail(check, 20)


def test_those_that_would_shrink_are_told_of():
    """All are found; where none of their segments pushes, in balance as they are."""
    told = 0
    for number in range(COUNT // 2):
        built = build(random_float(number, pushes=False))
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always", ModelWarning)
            equilibrium = solve(built)
        if caught:
            told += 1
            assert "carries_compression: true" in str(caught[0].message)
            assert equilibrium.residual > equilibrium.tolerance
            pushing = built._replace(system=statics.pushing(built.system))
            assert left(pushing) < 1.001 * equilibrium.tolerance
        else:
            assert equilibrium.residual < equilibrium.tolerance
            assert left(built) < 1.001 * equilibrium.tolerance
    assert 0 < told < COUNT // 4


def test_a_state_beside_equilibrium_is_noticed():
    built = build(random_float(2))
    tolerance = solve(built).tolerance
    assert left(built) < 1.001 * tolerance
    built.state.position[3] += 1e-3
    assert left(built) > 1.001 * tolerance
