"""A straight cable bent into a semicircle between two clamps, and into a ring.

Verifies: bending

An arc of a circle needs no force but end moments EI / R. On N equal segments of length l the regular polygon is an exact
equilibrium by the exact rule: hinges turn by a = pi / N (half of it at the clamps) and all carry (2 EI / l) sin(a / 2).
By the paper's rule the clamps carry (4 EI / l) sin(a / 4), more by 1 / cos(a / 4), and the polygon is none.

Small movements of one clamp of a semicircle (elastic centre 2 R / pi above the base; no stretch) need

    EI / (R^3 (pi / 2 - 4 / pi)) along the base,   EI / (R^3 pi / 2) across it in the plane,

N per m, converging at a rate within 0.1 of 2, the extrapolation within 1e-3 (of which the third order is the most). Half
that much stiffness, pi / 2 in place of pi / 2 - 4 / pi in the first, must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import at_once, beam, bending_moments, between, sections
from common import must_fail, rate
from dense import STIFFNESS, reduced
from moorings import nodes

from moorage.solve.statics import rest, solve
from moorage.system.build import build

R, EI, EA = 3.0, 1e4, 1e8


def polygon(segments: int, turn: float) -> tuple[np.ndarray, float]:
    """Corners (n, 3) about the origin, from (R', 0, 0) upwards in the x-z plane, and the length of the sides.

    R' is such that the sides have the arc's length: half the hinge's angle lies between the clamp and the first side.
    """
    side = R * turn / segments
    a = turn / segments
    radius = 0.5 * side / np.sin(0.5 * a)
    angle = a * np.arange(segments + 1)
    return radius * np.column_stack([np.cos(angle), 0.0 * angle, np.sin(angle)]), side


def arc(segments: int, turn: float, moved=(0.0, 0.0, 0.0), flavour: str = "native"):
    """The built system with the nodes on the polygon, its last one moved."""
    corners, side = polygon(segments, turn)
    end = corners[-1] + moved
    model = between(
        beam(EI, axial_stiffness=EA, mass_per_length=1.0), sections(("beam", side * segments, segments)), corners[0],
        (0.0, 0.0, 1.0), end, (-np.sin(turn), 0.0, np.cos(turn)),
    )  # fmt: skip
    built = build(dataclasses.replace(model, flavour=flavour))
    rest(built)
    n = built.names.node_ptr[1]
    built.state.position[1 : n - 1] = corners[1:-1] + np.linspace(0.0, 1.0, n)[1:-1, None] * np.array(moved)
    return built, corners, side


@pytest.mark.parametrize("turn", [0.5 * np.pi, np.pi, 1.5 * np.pi, 2.0 * np.pi])
@pytest.mark.parametrize("segments", [8, 30])
def test_polygon_is_an_equilibrium(turn, segments):
    """The ring is the last: both clamps in one place, the tangents alike."""
    built, _, side = arc(segments, turn)
    force = reduced(built, STIFFNESS)[1]
    moment = 2.0 * EI / side * np.sin(0.5 * turn / segments)
    assert np.abs(force).max() < EA / side * R * 1e-15  # rounding of the coordinates
    assert bending_moments(built) == pytest.approx(np.full(segments + 1, moment), rel=1e-9)
    ends = at_once(built)["end_moment"][0, 0]
    assert ends[:, 1] == pytest.approx([-moment, moment], rel=1e-9)


def test_moment_converges_to_that_of_the_circle():
    errors = [abs(bending_moments(arc(n, np.pi)[0])[0] * R / EI - 1.0) for n in (8, 16, 32)]
    assert np.array(errors) == pytest.approx((np.pi / np.array([8, 16, 32])) ** 2 / 24.0, rel=0.01)


def test_polygon_by_the_paper_s_rule_is_none():
    """Its clamps carry more than the hinges, which bends the line beside them."""
    built, _, side = arc(8, np.pi, flavour="MoorDyn-C")
    moments = bending_moments(built)
    assert moments[0] / moments[1] == pytest.approx(1.0 / np.cos(np.pi / 32.0), rel=1e-9)
    assert np.abs(reduced(built, STIFFNESS)[1]).max() > 0.5 * (moments[0] - moments[1]) / side


def pull(segments: int, moved) -> np.ndarray:
    """Force that holds the moved clamp where it is, over the movement, N/m (a difference of two)."""
    forces = []
    for sign in (1.0, -1.0):
        built, *_ = arc(segments, np.pi, sign * np.array(moved))
        solve(built, 1e-5)
        forces.append(-at_once(built)["end_force"][0, 0, 1])
    return (forces[0] - forces[1]) / (2.0 * np.linalg.norm(moved))


def check(direction, exact: float) -> None:
    direction, grids = np.array(direction), np.array([16, 32, 64])
    found = np.array([pull(int(n), 1e-3 * R * direction) @ direction for n in grids])
    assert found[-1] + (found[-1] - found[-2]) / 3.0 == pytest.approx(exact, rel=1e-3)
    assert abs(rate(1.0 / grids, np.abs(found - exact)) - 2.0) < 0.1, f"{found}, {exact}"


def test_along_the_base():
    check((1.0, 0.0, 0.0), EI / (R**3 * (np.pi / 2.0 - 4.0 / np.pi)))


def test_across_the_base():
    check((0.0, 0.0, 1.0), EI / (R**3 * np.pi / 2.0))


def test_without_its_elastic_centre_fails():
    must_fail(check, (1.0, 0.0, 0.0), EI / (R**3 * np.pi / 2.0))


def test_solved_from_nearby():
    """Statics find the polygon from 2 cm beside it, a semicircle's out of the plane too."""
    built, corners, side = arc(30, np.pi)
    random = np.random.default_rng(1).normal(0.0, 0.02, (29, 3))
    built.state.position[1:30] += random
    solve(built, 1e-3)
    assert np.abs(nodes(built) - corners).max() < 1e-6 * side
