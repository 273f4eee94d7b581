"""Statics of whatever cable: 500 random lazy waves, steep waves, catenaries and W shapes of 137 segments, from scratch.

Verifies: bending, tension, weight, contact

Which cables is told in cable_cases.py: EI over two decades, EA over two, floats, stiffeners, springs, graded segments, ends
pinned or clamped at angles that the shape does not have. Each must come to rest, or raise ConvergenceError; at most
1 % may take more than the 300 iterations of continuation, which is when Moorage falls back on descent. What is found must
be balanced within the tolerance that is stated, by forces assembled anew, and stable: its stiffness, a band matrix here,
has a Cholesky factor when 1e-9 of its largest entry (rounding of EA) is added on the diagonal. A
sample gets a push of 5 cm/s a node in water: after 30 s it must be within 10 cm of where it was, where an unstable one
would be metres away.
"""

from __future__ import annotations

import numpy as np
import pytest
from cable_cases import SHAPES, random_cable
from dense import STIFFNESS, assembled
from moorings import nodes, run
from scipy.linalg import LinAlgError, cholesky_banded

from moorage.errors import ConvergenceError
from moorage.solve.newton import assemble_island
from moorage.solve.statics import QUICK, solve
from moorage.system.build import build

COUNT = 500


def band(built) -> tuple[np.ndarray, np.ndarray]:
    """Stiffness of the interior nodes in lower band form (9, 3 n), and the largest force on one (N)."""
    assemble_island(built.system, built.state, built.state, built.work, 0, STIFFNESS, 0.0)
    blocks, n = built.work.blocks, int(built.names.node_ptr[1])
    matrix = np.zeros((n - 2, 9, 3))
    upper = np.array([[0, 1, 2], [1, 3, 4], [2, 4, 5]])  # of (xx, xy, xz, yy, yz, zz)
    for reach, entries in enumerate((blocks.own[1 : n - 1][:, upper], blocks.next[1 : n - 2], blocks.skip[1 : n - 3])):
        entries = entries.reshape(-1, 3, 3)
        for i in range(3):
            for j in range(i + 1 if reach == 0 else 3):
                matrix[: len(entries), 3 * reach + i - j, j] = entries[:, i, j]
    return matrix.transpose(1, 0, 2).reshape(9, -1), np.abs(built.work.force[1 : n - 1]).max()


def at_rest(built, tolerance: float) -> bool:
    """Whether a cable is balanced and stable."""
    matrix, force = band(built)
    matrix[0] += 1e-9 * matrix[0].max()
    try:
        cholesky_banded(matrix, lower=True)
    except LinAlgError:
        return False
    return bool(force <= 1.001 * tolerance)


@pytest.fixture(scope="module")
def verdicts():
    """(shape, number) of cables that failed, took long, or are not at rest."""
    failed, slow, wrong = [], [], []
    for number in range(COUNT):
        shape, model = random_cable(number)
        built = build(model)
        try:
            found = solve(built)
        except ConvergenceError:
            failed.append((shape, number))
            continue
        if found.iterations > QUICK:
            slow.append((shape, number))
        if not at_rest(built, found.tolerance):
            wrong.append((shape, number))
    return failed, slow, wrong


def test_cables_come_to_rest(verdicts):
    failed, slow, _ = verdicts
    assert failed == []
    assert len(slow) <= COUNT // 100, f"{slow}"


def test_equilibria_are_balanced_and_stable(verdicts):
    assert verdicts[2] == []


@pytest.mark.parametrize("number", range(len(SHAPES)))
def test_band_is_the_stiffness(number):
    """Against the matrix as tests of elimination assemble it."""
    built = build(random_cable(number)[1])
    solve(built)
    full, _ = assembled(built, STIFFNESS)
    matrix, _ = band(built)
    inner = full[3:-3, 3:-3]
    for k in range(9):
        assert matrix[k, : len(inner) - k] == pytest.approx(np.diagonal(inner, -k), abs=1e-9 * np.abs(inner).max())


@pytest.mark.parametrize("number", range(3 * len(SHAPES)))
def test_pushed_cables_come_back(number):
    shape, model = random_cable(number)
    built = build(model)
    solve(built)
    place, n = nodes(built).copy(), built.names.node_ptr[1]
    built.state.velocity[1 : n - 1] = np.random.default_rng(number).normal(0.0, 0.05, (n - 2, 3))
    block = run(built, 30.0, time_step=0.1, dt_out=30.0, dt_nodes=30.0)
    assert np.abs(block["node_position"][-1] - place).max() < 0.1, shape


def test_a_state_beside_equilibrium_is_noticed():
    built = build(random_cable(1)[1])
    tolerance = solve(built).tolerance
    assert at_rest(built, tolerance)
    built.state.position[9] += 1e-3
    assert not at_rest(built, tolerance)
