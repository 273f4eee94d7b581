"""Natural modes by the sparse eigenproblem: taut string, hanging chain, beam under tension, and a rigid basis.

Verifies: tension, weight, bending, morison

* A string of N equal segments of length h under tension T with mass m a metre has, exactly,
  w_n = (2 / h) sqrt(T / m') sin(n pi / (2 N)), m' = m l / h for the stretch of each segment: to 1e-8, rounding of K.
  To w_n = n pi / L sqrt(T / m') the error is (n pi / (2 N))^2 / 6: rate 2.
* A chain that hangs from one end has w_n = j_n / 2 sqrt(g / L), j_n the zeros of the Bessel function J0 (Bernoulli). Its
  lumped masses have an error of the second order in the lowest modes: 0.02 % in the first and 1 % in the third at 40 segments.
* A beam on hinges under tension has w_n^2 = (n pi / L)^4 EI / m + (n pi / L)^2 T / m: second order in the segments.
* A basis that moves two free points as one leaves the frequencies of the points tied together by a stiff line.

The last digits of K are 1e-9 of EA / l, which stands for 1e-7 of the lowest w^2 here.
"""

from __future__ import annotations

import numpy as np
import pytest
from cables import VACUUM, beam
from common import must_fail, rate
from dense import modes as full_modes
from moorings import fixed, free, kind, line, mooring, single
from scipy.optimize import brentq
from scipy.sparse import csr_array
from scipy.special import j0, jn_zeros

from moorage.solve import modes
from moorage.solve.modes import island_pencil, lowest, modes_at_rest, with_basis
from moorage.solve.statics import solve
from moorage.system.build import build

MASS, LENGTH, PULL, GRAVITY = 20.0, 100.0, 1e5, 9.80665
EA = 1e7


def string(segments: int, mass: float = MASS):
    """Return a string between two fixed points, 1 % longer than it is unstretched, and its mass a metre as stretched."""
    unstretched = LENGTH / (1.0 + PULL / EA)
    rope = kind(mass_per_length=mass, axial_stiffness=EA)
    model = single(rope, unstretched, segments, fixed(1, 0.0, 0.0, 0.0), fixed(2, LENGTH, 0.0, 0.0), **VACUUM)
    built = build(model)
    solve(built)
    return built, mass * unstretched / LENGTH


def across(built, count: int) -> np.ndarray:
    """Return the lowest frequencies (rad/s) across a line; each comes twice, for two directions."""
    return np.sqrt(modes_at_rest(built, 2 * count).squares)[::2]


def check_string(segments: int, mass: float = MASS) -> None:
    built, stretched = string(segments)
    n = np.arange(1, 6)
    exact = 2.0 * segments / LENGTH * np.sqrt(PULL / (stretched * mass / MASS)) * np.sin(0.5 * n * np.pi / segments)
    np.testing.assert_allclose(across(built, 5), exact, rtol=1e-7)


@pytest.mark.parametrize("segments", [10, 40, 200])  # the last one is sparse
def test_string_of_lumped_masses(segments):
    check_string(segments)


def test_string_converges_at_second_order():
    grids = np.array([20, 40, 80])
    n = np.arange(1, 4)
    errors = []
    for segments in grids:
        built, mass = string(int(segments))
        errors.append(1.0 - across(built, 3) / (n * np.pi / LENGTH * np.sqrt(PULL / mass)))
    for column in np.array(errors).T:
        assert abs(rate(1.0 / grids, column) - 2.0) < 0.02
    np.testing.assert_allclose(errors[0], (0.5 * n * np.pi / 20) ** 2 / 6.0, rtol=0.02)


def test_a_heavier_string_fails():
    must_fail(check_string, 40, 1.001 * MASS)


def hanging(segments: int) -> np.ndarray:
    """Return the lowest frequencies of a hanging chain over sqrt(g / L) / 2, to be the zeros of J0."""
    chain = kind(mass_per_length=MASS, axial_stiffness=1e9)
    points = fixed(1, 0.0, 0.0, 0.0), free(2, 0.0, 0.0, -LENGTH)
    built = build(single(chain, LENGTH, segments, *points, water_density=0.0, gravity=GRAVITY))
    solve(built)
    return 2.0 * across(built, 3) / np.sqrt(GRAVITY / LENGTH)


def test_hanging_chain_has_the_zeros_of_bessel():
    grids, exact = np.array([20, 40, 80]), jn_zeros(0, 3)
    errors = np.array([hanging(int(n)) for n in grids]) / exact - 1.0
    assert np.abs(errors[1]).max() < 0.01
    assert abs(errors[1, 0]) < 2e-4
    for column in np.abs(errors).T:
        assert abs(rate(1.0 / grids, column) - 2.0) < 0.1, f"{errors}"
    assert exact[0] == pytest.approx(brentq(j0, 2.0, 3.0))


def tensioned(segments: int, EI: float = 1e6) -> np.ndarray:
    """Return w_n^2 of a hinged beam under tension over the exact ones."""
    unstretched = LENGTH / (1.0 + PULL / 1e9)
    cable = beam(EI, mass_per_length=MASS, axial_stiffness=1e9)
    built = build(single(cable, unstretched, segments, fixed(1, 0.0, 0.0, 0.0), fixed(2, LENGTH, 0.0, 0.0), **VACUUM))
    solve(built)
    k = np.arange(1, 4) * np.pi / LENGTH
    return across(built, 3) ** 2 / ((1e6 * k**4 + PULL * k**2) / (MASS * unstretched / LENGTH))


def test_beam_under_tension():
    grids = np.array([20, 40, 80])
    errors = np.array([tensioned(int(n)) for n in grids]) - 1.0
    assert np.abs(errors[2]).max() < 1.5e-3
    for column in np.abs(errors).T:
        assert abs(rate(1.0 / grids, column) - 2.0) < 0.1, f"{errors}"


def test_a_stiffer_beam_fails():
    must_fail(np.testing.assert_allclose, tensioned(80, 1.5e6)[2], 1.0, atol=1.5e-3)


def tied(axial_stiffness: float = 1e9):
    """Return two clumps on ropes that a short line ties together: the bar."""
    rope, bar = kind(axial_stiffness=EA), kind("bar", axial_stiffness=axial_stiffness, mass_per_length=1.0)
    points = fixed(1, -60.0, 0.0, 0.0), free(2, -2.0, 0.0, -30.0, mass=4e3), free(3, 2.0, 0.0, -30.0, mass=1e3), fixed(4, 60.0, 0.0, 0.0)  # fmt: skip
    lines = line(1, 1, 2, ("rope", 65.0, 8)), line(2, 2, 3, ("bar", 4.0, 1)), line(3, 3, 4, ("rope", 65.0, 8))
    built = build(mooring((rope, bar), points, lines, water_density=0.0))
    solve(built)
    return built


def test_dense_and_sparse_agree_with_full_matrices(monkeypatch):
    """With free points; the full matrices are put together in another way (tests/dense.py)."""
    built = tied()
    found = modes_at_rest(built, 8)
    squares = full_modes(built)[0][:8] ** 2
    np.testing.assert_allclose(found.squares, squares, rtol=1e-6)
    monkeypatch.setattr(modes, "DENSE", 0)
    sparse = modes_at_rest(built, 8)
    np.testing.assert_allclose(sparse.squares, squares, rtol=1e-6)
    assert np.abs(found.shapes).max() == pytest.approx(1.0)
    np.testing.assert_allclose(found.energy.sum(axis=1), 1.0)
    ends = built.names.node_ptr[1] - 1  # the last node of the first line moves with its point
    np.testing.assert_array_equal(found.shapes[:, ends], found.shapes[:, built.names.node_ptr[-1] + 1])


def test_a_basis_makes_a_rigid_body_of_two_points():
    """The 4 m bar, as a rigid one: a shift and a turn of two points. The stretch of the stiff bar is all that differs.

    Its EA / l = 2.5e8 N/m against m w^2 of some 1e4 N/m: 1e-3 in w^2.
    """
    built = tied()
    pencil, nodes = island_pencil(built, 0), int(built.names.node_ptr[-1])
    rows = [int(np.flatnonzero(pencil.rows == nodes + k)[0]) for k in (1, 2)]
    a, b = (built.state.position[nodes + k] for k in (1, 2))
    others = np.setdiff1d(np.arange(len(pencil.rows)), rows)
    basis = np.zeros((3 * len(pencil.rows), 3 * len(others) + 5))
    for k, row in enumerate(others):
        basis[3 * row : 3 * row + 3, 3 * k : 3 * k + 3] = np.eye(3)
    u, last = (b - a) / np.linalg.norm(b - a), 3 * len(others)
    turns = np.linalg.svd(u[None])[2][1:]  # the two directions across the bar
    for row, side in zip(rows, (-0.5, 0.5), strict=True):
        basis[3 * row : 3 * row + 3, last : last + 3] = np.eye(3)
        basis[3 * row : 3 * row + 3, last + 3 :] = side * turns.T
    rigid = with_basis(pencil, csr_array(basis))
    squares = lowest(rigid, 8)[0]
    np.testing.assert_allclose(squares, modes_at_rest(built, 8).squares, rtol=1e-3)
    whole = modes_at_rest(built, 8, [rigid])
    np.testing.assert_allclose(whole.squares, squares)
    moved = whole.shapes[:, nodes + 2] - whole.shapes[:, nodes + 1]
    np.testing.assert_allclose(moved @ u, 0.0, atol=1e-9)
