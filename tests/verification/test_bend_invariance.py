"""Bending does not depend on where the cable points in space, on which end is A, or on how it is cut into sections.

Verifies: bending

A bent, twisted shape of uneven segments between a clamp and a rotational spring, given node by node, so that curvatures and
forces must be the same to rounding. Statics of a beam in vacuum that a force bends must be too: they stop within
what 1e-6 N moves. A clamp that is left where it was while all else turns must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import at_once, beam, between, cantilever, curvatures, sections, turned
from common import must_fail
from dense import STIFFNESS, assembled
from moorings import nodes, statics

from moorage.model import Attachment, Line
from moorage.solve.statics import rest
from moorage.system.build import build

EI = 2e4
PARTS = sections(("beam", 6.0, 5, 3.0), ("beam", 4.0, 5))
A, B = np.array([1.0, 2.0, -30.0]), np.array([7.0, 5.0, -33.0])
OUT, IN = np.array([0.8, 0.6, 0.0]), np.array([0.0, 0.6, -0.8])
AHEAD = np.eye(3)
TURNS = [turned(0.7, (1.0, 0.0, 0.0)), turned(2.0, (0.3, -0.5, 0.8)), turned(np.pi, (0.0, 1.0, 1.0))]


def shaken(turn=AHEAD, flavour: str = "native", directions: bool = True):
    """The built cable in one and the same bent shape, turned about the origin."""
    aim = turn if directions else AHEAD
    model = between(beam(EI), PARTS, turn @ A, aim @ OUT, turn @ B, aim @ IN, end_b_stiffness=3e4)
    built = build(dataclasses.replace(model, flavour=flavour))
    rest(built)
    n = built.names.node_ptr[1]
    shape = np.linspace(A, B, n)
    shape[1:-1] += np.random.default_rng(6).normal(0.0, 0.3, (n - 2, 3))
    built.state.position[:n] = shape @ turn.T
    return built


def state(built):
    return curvatures(built), at_once(built)["bending_moment"][0], assembled(built, STIFFNESS)[1]


def check_direction(turn, flavour: str, directions: bool = True) -> None:
    curvature, moment, force = state(shaken(flavour=flavour))
    other = state(shaken(turn, flavour, directions))
    assert other[0] == pytest.approx(curvature, rel=1e-9)
    assert other[1] == pytest.approx(moment, rel=1e-9)
    assert other[2] @ turn == pytest.approx(force, abs=1e-9 * np.abs(force).max())


@pytest.mark.parametrize("flavour", ["native", "MoorDyn-C"])
@pytest.mark.parametrize("turn", TURNS)
def test_direction_in_space(turn, flavour):
    check_direction(turn, flavour)


def test_clamp_that_stays_fails():
    must_fail(check_direction, TURNS[0], "native", False)


def mirrored(built):
    """The same cable laid from its other end."""
    model = between(beam(EI), (), B, -IN, A, -OUT)
    ahead = sections(("beam", 4.0, 5), ("beam", 6.0, 5, 1.0 / 3.0))
    lines = (dataclasses.replace(model.lines[0], sections=ahead, end_a_stiffness=3e4),)
    other = build(dataclasses.replace(model, lines=lines))
    rest(other)
    n = built.names.node_ptr[1]
    other.state.position[:n] = built.state.position[:n][::-1]
    return other


def test_which_end_is_a():
    built = shaken()
    curvature, moment, force = state(built)
    other = state(mirrored(built))
    assert other[0][::-1] == pytest.approx(curvature, rel=1e-9)
    assert other[1][::-1] == pytest.approx(moment, rel=1e-9)
    assert other[2][::-1] == pytest.approx(force, abs=1e-9 * np.abs(force).max())
    swapped = at_once(mirrored(built))["end_moment"][0, 0, ::-1]
    assert swapped == pytest.approx(at_once(built)["end_moment"][0, 0], rel=1e-9)


@pytest.mark.parametrize("cuts", [(20,), (5, 15), (1, 9, 7, 3), (1,) * 20])
def test_cut_into_sections(cuts):
    """Sections of the same type: to the last digit but for how lengths add up."""
    force = (0.0, 30.0, -80.0)
    whole = statics(cantilever(beam(5e3), sections(("beam", 10.0, 20)), force), tolerance=1e-6)
    parts = sections(*(("beam", 0.5 * n, n) for n in cuts))
    cut = statics(cantilever(beam(5e3), parts, force), tolerance=1e-6)
    assert np.abs(nodes(whole)[-1, 1:]).min() > 1.0
    assert np.abs(nodes(cut) - nodes(whole)).max() < 1e-7
    assert curvatures(cut) == pytest.approx(curvatures(whole), rel=1e-6)


def test_tip_first():
    """A whole solved cantilever whose line runs from the tip to the clamp."""
    force = (0.0, 30.0, -80.0)
    model = cantilever(beam(5e3), sections(("beam", 10.0, 20)), force)
    (rod,) = model.rods
    # the same clamp seen from end B of the line: the rod points against the line
    back = dataclasses.replace(rod, end_b=tuple(2.0 * a - b for a, b in zip(rod.end_a, rod.end_b, strict=True)))
    line = Line(id=1, sections=PARTS[:0], end_a=Attachment("point", 1), end_b=Attachment("rod", 1, "A"))
    line = dataclasses.replace(line, sections=model.lines[0].sections)
    one, other = (
        statics(model, tolerance=1e-6),
        statics(dataclasses.replace(model, rods=(back,), lines=(line,)), tolerance=1e-6),
    )
    assert np.abs(nodes(other)[::-1] - nodes(one)).max() < 1e-7
    assert curvatures(other)[::-1] == pytest.approx(curvatures(one), rel=1e-6, abs=1e-7)
