"""Natural modes of rods and bodies, and stiffness past them, against closed forms.

Verifies: rigid, weight, morison, point

* A rod on a pin, in air: w^2 = m g L / 2 / (m L^2 / 3 + m d^2 / 16), to rounding; it has two such modes, and no third,
  for it does not turn about its axis. A body on a pin: m g c / (J + m c^2) about either axis.
* A spar that floats upright heaves at w^2 = rho g A / (m + m_a), to rounding: buoyancy has that slope.
* A rod of mass m hung level from two ropes of length l by its ends swings at g / l in both directions, and turns at
  m g (L / 2)^2 / (J l). Ropes of 1e-4 of its mass and 1e-5 of stretch leave 5e-4.
* Two springs in a row with a free body between have k1 k2 / (k1 + k2).
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from floats import AIR, VACUUM, WATER, body, floating, rod

import moorage
from moorage.model import Attachment, Line, LineType, Point, RodType, Section
from moorage.solve.modes import modes_at_rest
from moorage.solve.statics import solve
from moorage.system.build import build

G = 9.80665


def squares(model, number: int = 6) -> np.ndarray:
    built = build(model)
    solve(built)
    return modes_at_rest(built, number).squares


def rope(id: int, a: Attachment, b: Attachment, length: float, segments: int, kind: str = "rope") -> Line:
    return Line(id=id, end_a=a, end_b=b, sections=(Section(line_type=kind, length=length, segments=segments),))


def at(id: int) -> Attachment:
    return Attachment("point", id)


def test_rod_on_a_pin():
    found = squares(floating(rods=[rod(1, "pinned", (0, 0, -50), (0, 0, -52))], environment=AIR))
    np.testing.assert_allclose(found, 2 * [G / (4.0 / 3.0 + 0.4**2 / 16.0)], rtol=1e-9)


def check_body(arm: float = 2.0) -> None:
    found = squares(floating([body(kind="pinned", centre_of_gravity=(0.0, 0.0, -arm))], environment=AIR))
    np.testing.assert_allclose(found[0], 0.0, atol=1e-9)  # it turns freely about the vertical
    np.testing.assert_allclose(found[1:], [G * 200.0 / (400.0 + 20.0), G * 200.0 / (400.0 + 10.0)], rtol=1e-9)


def test_body_on_a_pin():
    check_body()


def test_a_body_that_hangs_lower_fails():
    must_fail(check_body, 2.1)


def test_spar_heaves():
    kind = RodType(name="spar", diameter=1.0, mass_per_length=500.0, end_added_mass=0.6)
    found = squares(floating(rods=[rod(1, "free", (0, 0, -6), (0, 0, 4), 20)], types=kind, environment=WATER), 5)
    mass = 5000.0 + 0.6 * 1025.0 * np.pi / 12.0  # the half sphere at the wet end
    assert np.abs(found / (1025.0 * G * np.pi / 4.0 / mass) - 1.0).min() < 1e-6


def hung(axial_stiffness: float = 1e9, **place) -> moorage.Model:
    """A level rod, 4 m long, on two ropes of 10 m."""
    thin = LineType(name="rope", diameter=0.01, mass_per_length=1e-3, axial_stiffness=axial_stiffness)
    points = [Point(id=1, kind="fixed", position=(-2, 0, -40)), Point(id=2, kind="fixed", position=(2, 0, -40))]
    beam = rod(1, "free", (-2, 0, -50), (2, 0, -50))
    ropes = [rope(k, at(k), Attachment("rod", 1, end), 10.0, 4) for k, end in ((1, "A"), (2, "B"))]
    return floating(rods=[beam], environment=AIR, line_types=thin, points=points, lines=ropes)


def test_modes_of_a_model_without_lines():
    ds = moorage.natural_modes(floating(rods=[rod(1, "pinned", (0, 0, -50), (0, 0, -52))], environment=AIR))
    exact = np.sqrt(G / (4.0 / 3.0 + 0.4**2 / 16.0))
    np.testing.assert_allclose(ds["frequency"] * 2.0 * np.pi, [exact, exact], rtol=1e-9)


def test_rod_on_two_ropes():
    built = build(hung())
    solve(built)
    modes = modes_at_rest(built, 3)
    inertia = 4.0**2 / 12.0 + 0.4**2 / 16.0  # of a kilogram
    np.testing.assert_allclose(modes.squares, [G / 10.0, G / 10.0, G / 10.0 * 4.0 / inertia], rtol=5e-4)
    np.testing.assert_allclose(modes.energy.sum(axis=1), 1.0)
    lines = int(built.names.node_ptr[-1])
    assert modes.energy[:, :lines].max() < 1e-3  # the rod has it all
    turn = modes.shapes[2, built.names.node_ptr[1:] - 1]  # of the ropes' lower ends: to opposite sides
    np.testing.assert_allclose(turn[0], -turn[1], atol=1e-6)
    assert abs(turn[0, 1]) == pytest.approx(1.0, rel=1e-3)
    ds = moorage.natural_modes(hung(), 3)
    np.testing.assert_allclose(ds["frequency"] * 2.0 * np.pi, np.sqrt(modes.squares))


def test_shapes_of_a_rod_on_a_pin():
    """End A stays, end B has the largest displacement, across; all energy is the rod's."""
    ds = moorage.natural_modes(floating(rods=[rod(1, "pinned", (0, 0, -50), (0, 0, -52))], environment=AIR))
    np.testing.assert_allclose(ds["rod_shape"].sel(rod=1, rod_end="A"), 0.0, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(ds["rod_shape"].sel(rod=1, rod_end="B"), axis=1), 1.0)
    np.testing.assert_allclose(ds["rod_shape"].sel(xyz="z"), 0.0, atol=1e-9)
    np.testing.assert_allclose(ds["rod_energy"], 1.0)
    for row in moorage.results.modes_report(ds):
        assert row["moves"] == "rod 1"
        assert row["along"] in ("about x", "about y")


def check_turns(yaw: float = 0.5 * np.pi) -> None:
    """A body on a pin, yawed by 90 degrees: its lower mode, about its own y (the larger inertia), is about x."""
    it = body(kind="pinned", centre_of_gravity=(0.0, 0.0, -2.0), rotation=(0.0, 0.0, yaw))
    ds = moorage.natural_modes(floating([it], environment=AIR))
    np.testing.assert_allclose(np.abs(ds["body_turn"].values[:, 0]), np.eye(3)[[2, 0, 1]], atol=1e-6)
    np.testing.assert_allclose(ds["body_shape"], 0.0, atol=1e-12)
    np.testing.assert_allclose(ds["body_energy"], 1.0)
    assert [row["along"] for row in moorage.results.modes_report(ds)] == ["about z", "about x", "about y"]


def test_turns_of_a_body_are_in_global_axes():
    check_turns()
    must_fail(check_turns, 0.0)


def test_shape_of_heave_and_of_a_rod_that_turns_level():
    kind = RodType(name="spar", diameter=1.0, mass_per_length=500.0, end_added_mass=0.6)
    it = floating(rods=[rod(1, "free", (0, 0, -6), (0, 0, 4), 20)], types=kind, environment=WATER)
    ds = moorage.natural_modes(it, 5)
    heave = int(np.abs(ds["rod_shape"].values[:, 0, 0, 2]).argmax())
    np.testing.assert_allclose(np.abs(ds["rod_shape"].values[heave, 0]), [[0, 0, 1], [0, 0, 1]], atol=1e-6)
    assert moorage.results.modes_report(ds)[heave]["along"] == "z"
    ds = moorage.natural_modes(hung(), 3)
    assert [row["moves"] for row in moorage.results.modes_report(ds)] == ["rod 1"] * 3
    assert moorage.results.modes_report(ds)[2]["along"] == "about z"
    np.testing.assert_allclose(ds["rod_energy"], 1.0, atol=2e-3)


def test_a_body_carries_its_points():
    """A point on a body moves as its reference point and turn say."""
    ds = moorage.natural_modes(springs(), 6)
    arms = np.array([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
    there = ds["body_shape"].values + np.cross(ds["body_turn"].values, arms)
    np.testing.assert_allclose(ds["point_shape"].sel(point=[2, 3]), there, atol=1e-9)
    assert (ds["body_energy"].values > 0.9).any()


def springs() -> moorage.Model:
    """A coupled point, a spring, a free body, another spring and an anchor, pulled straight in nothing."""
    kinds = [
        LineType(name=n, diameter=0.01, mass_per_length=0.1, axial_stiffness=k) for n, k in (("a", 1e5), ("b", 3e5))
    ]
    points = [
        Point(id=1, kind="coupled", position=(12, 0, -50)), Point(id=2, kind="fixed", body=1, position=(1, 0, 0)),
        Point(id=3, kind="fixed", body=1, position=(-1, 0, 0)), Point(id=4, kind="fixed", position=(-12, 0, -50)),
    ]  # fmt: skip
    lines = [rope(1, at(1), at(2), 10.0, 2, "a"), rope(2, at(3), at(4), 10.0, 2, "b")]
    return floating([body()], environment=VACUUM, line_types=kinds, points=points, lines=lines)


def test_stiffness_past_a_free_body():
    """k = EA / l of both in a row, to what central differences of 2 mm and the residual of statics leave."""
    K = moorage.stiffness(springs())["platform_stiffness"].values[0, :, 0]
    assert K[0, 0] == pytest.approx(1.0 / (10.0 / 1e5 + 10.0 / 3e5), rel=1e-3)
    still = moorage.solve_statics(springs())["stiffness"].values
    np.testing.assert_allclose(still, K, atol=1e-6 * np.abs(K).max())


@pytest.mark.parametrize("things", [
    {"bodies": [body(kind="coupled-pinned")]},
    {"rods": [rod(1, "coupled-pinned", (0, 0, -50), (0, 0, -52))]},
    {"bodies": [body(kind="coupled")], "rods": [rod(1, "pinned", (0, 0, 0), (0, 0, -2), body=1)]},
], ids=["body", "rod", "rod on a body"])  # fmt: skip
def test_stiffness_at_a_pin_that_a_host_holds_is_refused(things):
    with pytest.raises(moorage.UnsupportedError, match="hangs from a coupled pin"):
        moorage.stiffness(floating(environment=AIR, **things))
