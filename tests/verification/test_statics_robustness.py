"""Statics of whatever line: 300 random ones, all of which must come to rest, in balance and stable; 100 in currents.

Verifies: tension, weight, contact, point, catenary

Lines of 2 to 40 cm, EA over three decades, 1 to 60 segments, weight from 5 % to 7 times their displacement, 30 of
each kind (`statics_cases`): heaps longer than span and depth together, taut, vertical, fully grounded, clear of the
bed, buoyant ones that reach the surface, under a clump, with a float, of three sections, and described from top to
bottom. Each converges or raises ConvergenceError and is left as it was; at most 1 % may do the latter. What is found
must be balanced within the tolerance that is stated, by forces assembled anew, and stable: no eigenvalue of its
stiffness below -1e-9 of the largest, what rounding of EA leaves (slack nodes on the bed slide without resistance:
zero is no failure). In a current of 0.1 to 4 m/s the tangent is not symmetric, so that only balance is looked at.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from dense import STIFFNESS, reduced
from moorings import fixed, kind, single
from statics_cases import KINDS, random_line

from moorage.errors import ConvergenceError
from moorage.layout import copy_of
from moorage.model import Current
from moorage.solve.statics import solve
from moorage.system.build import build

COUNT = 300


def balanced_and_stable(built, tolerance: float) -> bool:
    K, f, _ = reduced(built, STIFFNESS)
    if not len(f):
        return True
    squares = np.linalg.eigvalsh(K)
    return bool(np.abs(f).max() <= 1.001 * tolerance and squares[0] >= -1e-9 * squares[-1])


@pytest.fixture(scope="module")
def verdicts():
    """(what, number) of lines that failed, and of those that were not at rest."""
    failed, wrong = [], []
    for number in range(COUNT):
        what, model = random_line(number)
        built = build(model)
        before = copy_of(built.state)
        try:
            equilibrium = solve(built)
        except ConvergenceError:
            failed.append((what, number))
            if not all((a == b).all() for a, b in zip(before, built.state, strict=True)):
                wrong.append((what, number))
            continue
        if not balanced_and_stable(built, equilibrium.tolerance):
            wrong.append((what, number))
    return failed, wrong


def test_nearly_all_lines_come_to_rest(verdicts):
    failed, _ = verdicts
    assert len(failed) <= COUNT // 100, f"{failed}"


def test_equilibria_are_balanced_and_stable(verdicts):
    _, wrong = verdicts
    assert wrong == []


def test_lines_in_currents():
    random, failed, wrong = np.random.default_rng(0), [], []
    for number in range(COUNT // 3):
        what, model = random_line(number)
        speed, heading = 10.0 ** random.uniform(-1.0, 0.6), random.uniform(0.0, 2.0 * np.pi)
        current = Current((0.0,), ((speed * np.cos(heading), speed * np.sin(heading), 0.0),))
        built = build(dataclasses.replace(model, environment=dataclasses.replace(model.environment, current=current)))
        try:
            equilibrium = solve(built)
        except ConvergenceError:
            failed.append((what, number))
            continue
        force = reduced(built, STIFFNESS)[1]
        if np.abs(force).max(initial=0.0) > 1.001 * equilibrium.tolerance:
            wrong.append((what, number))
    assert len(failed) <= COUNT // 300, f"{failed}"
    assert wrong == []


def test_every_kind_was_tried():
    assert {random_line(k)[0] for k in range(len(KINDS))} == set(KINDS)


def test_a_state_beside_equilibrium_is_noticed():
    """Moved by 1 mm, a line is not balanced; with a segment pushed together that may push, it is not stable."""
    built = build(random_line(1)[1])
    tolerance = solve(built).tolerance
    assert balanced_and_stable(built, tolerance)
    built.state.position[1] += 1e-3
    assert not balanced_and_stable(built, tolerance)
    strut = build(
        single(kind(), 10.0, 2, fixed(1, 0.0, 0.0, -9.0), fixed(2, 9.9, 0.0, -9.0), gravity=0.0, water_density=0.0)
    )
    strut.state.position[1] = 4.95, 0.0, -9.0
    assert balanced_and_stable(strut, 1e-3)
    pushing = strut.system.tension._replace(slack=np.full(2, -1e9))
    assert not balanced_and_stable(strut._replace(system=strut.system._replace(tension=pushing)), 1e-3)
