"""Cables joined by free rods of no length are one cable of several sections.

Verifies: bending

By the exact rule a joint is the hinge of an interior node, so that with the same nodes in the same places all forces
are the same to rounding, and so is a run in water (to what Newton's method leaves): drag and added mass at a joint have
the direction of both cables.

By the paper's rule (equation 10 for both ends of the rod) a joint that turns by A carries 1 / cos(A / 4) times as much.
Both ways round and in any numbering. Joined by a point, which is a pin, the forces must differ.
"""

from __future__ import annotations

import dataclasses
from itertools import pairwise

import numpy as np
import pytest
from cables import at_once
from common import must_fail
from dense import STIFFNESS, reduced
from moorings import coupled, fixed, free, held, joint, kind, mooring, run, statics

from moorage.model import Attachment, Line, Motion, Section
from moorage.solve.statics import rest, solve
from moorage.system.build import build

DEPTH = 60.0
PARTS = (("cable", 55.0, 33), ("float", 25.0, 20), ("cable", 57.0, 24))
CUTS = np.cumsum([0, 33, 20, 24])
HYDRO = {"transverse_drag": 1.2, "tangential_drag": 0.1, "transverse_added_mass": 1.0}
MOTION = Motion.from_harmonics(12.0, ramp=4.0, interval=0.05, surge=(2.0, 8.0), heave=(3.0, 7.0))


def types(**hydro):
    common = {"axial_stiffness": 1e8, "axial_damping_ratio": 0.8} | hydro
    return (
        kind("cable", diameter=0.176, mass_per_length=77.3, bending_stiffness=2e4, **common),
        kind("float", diameter=0.559, mass_per_length=184.5, bending_stiffness=5e4, **common),
    )


def sections(*which: int) -> tuple[Section, ...]:
    return tuple(Section(line_type=t, length=x, segments=n) for t, x, n in (PARTS[k] for k in which))


def around(lines, points=(), rods=(), **hydro):
    ends = fixed(1, 105.0, 0.0, -DEPTH), coupled(2, 0.0, 0.0, -4.0)
    return mooring(types(**hydro), (*ends, *points), lines, rods, water_depth=DEPTH, seabed_stiffness=1e5)


def one_line(**hydro):
    ends = Attachment("point", 1), Attachment("point", 2)
    return around((Line(id=1, sections=sections(0, 1, 2), end_a=ends[0], end_b=ends[1]),), **hydro)


def three_lines(pinned: bool = False, flavour: str = "native", **hydro):
    """The middle one runs the other way; rods hold some of the lines at end A, some at end B."""
    low, high = joint(1, 60.0, 0.0, -50.0), joint(2, 40.0, 0.0, -40.0)
    if pinned:
        at = {("A", 1): 3, ("B", 1): 3, ("A", 2): 4, ("B", 2): 4}
        hold = {key: Attachment("point", id) for key, id in at.items()}
    else:
        hold = {(end, rod.id): held(rod, end) for rod in (low, high) for end in "AB"}
    lines = (
        Line(id=7, sections=sections(1), end_a=hold["A", 2], end_b=hold["B", 1]),
        Line(id=2, sections=sections(0), end_a=Attachment("point", 1), end_b=hold["A", 1]),
        Line(id=5, sections=sections(2), end_a=hold["B", 2], end_b=Attachment("point", 2)),
    )
    points = (free(3, *low.end_a), free(4, *high.end_a)) if pinned else ()
    return dataclasses.replace(around(lines, points, () if pinned else (low, high), **hydro), flavour=flavour)


def in_order(built) -> np.ndarray:
    """Rows of the nodes of the three lines in the order of the one line; joints appear once."""
    a, b, c, _ = built.names.node_ptr
    middle, lower, upper = np.arange(a, b)[::-1], np.arange(b, c), np.arange(c, built.names.node_ptr[-1])
    return np.concatenate([lower, middle[1:], upper[1:]])


def shaped_like(one, other):
    """The system of three lines with its nodes where those of the one line are."""
    n = one.names.node_ptr[-1]
    rows = in_order(other)
    other.state.position[rows] = one.state.position[:n]
    a, b = other.names.node_ptr[:2]
    # joints and line ends that share a row of the one line: middle line's ends, lower line's end, upper line's begin
    other.state.position[other.names.node_ptr[2] - 1] = one.state.position[CUTS[1]]
    other.state.position[other.names.node_ptr[2]] = one.state.position[CUTS[2]]
    other.state.position[b - 1], other.state.position[a] = one.state.position[CUTS[1]], one.state.position[CUTS[2]]
    free_rows = other.names.node_ptr[-1] + np.sort(other.system.islands.points)
    other.state.position[free_rows] = one.state.position[[CUTS[1], CUTS[2]]]
    return other


def forces(built, order=None) -> np.ndarray:
    """Out-of-balance forces (n, 3) of interior nodes and joints, along the one line."""
    f, T = reduced(built, STIFFNESS)[1:]
    full = (T @ f).reshape(-1, 3)  # an unknown's force in all rows that copy it
    n = built.names.node_ptr[-1]
    return full[:n] if order is None else full[order]


def check_forces(pinned: bool) -> None:
    """At a bent shape that is no equilibrium, so that every force is large."""
    one = build(one_line())
    rest(one)
    one.state.position[1:-3] += np.random.default_rng(2).normal(0.0, 0.05, one.state.position[1:-3].shape)
    other = shaped_like(one, build(three_lines(pinned)))
    ours, theirs = forces(one), forces(other, in_order(other))
    inner = slice(1, len(ours) - 1)
    size = np.abs(ours).max()
    assert np.abs(ours[inner] - theirs[inner]).max() < 1e-12 * size


def test_all_forces_are_the_same():
    check_forces(False)


def test_pin_fails():
    must_fail(check_forces, True)


def test_statics_are_the_same():
    """Both to 1e-5 N; the softest way to move costs more than 0.3 N/m."""
    one, other = statics(one_line(), tolerance=1e-5), statics(three_lines(), tolerance=1e-5)
    rows, n = in_order(other), one.names.node_ptr[-1]
    assert np.abs(other.state.position[rows] - one.state.position[:n]).max() < 1e-4
    moments = at_once(one)["bending_moment"][0], at_once(other)["bending_moment"][0][rows]
    assert np.abs(moments[0] - moments[1]).max() < 1e-4 * np.abs(moments[0]).max()


def test_statics_do_not_need_the_place_of_the_joints():
    """Described on the chord, as converted files have them, 30 m from where they hang."""
    right, chord = three_lines(), three_lines()
    a, b = np.array([105.0, 0.0, -DEPTH]), np.array([0.0, 0.0, -4.0])
    places = [a + share * (b - a) for share in (55.0 / 137.0, 80.0 / 137.0)]
    rods = tuple(
        dataclasses.replace(rod, end_a=tuple(place), end_b=tuple(place + np.subtract(rod.end_b, rod.end_a)))
        for rod, place in zip(chord.rods, places, strict=True)
    )
    found = statics(dataclasses.replace(chord, rods=rods), tolerance=1e-5).state.position
    assert np.abs(found - statics(right, tolerance=1e-5).state.position).max() < 1e-4


def moved(model, at_end: tuple[int, int]) -> np.ndarray:
    """Force on the moved point in a run with steps of 0.02 s, (n, 3)."""
    built = build(model, MOTION, 12.0)
    solve(built, 1e-5)
    return run(built, 12.0, time_step=0.02, dt_out=0.1, tolerance=1e-10)["end_force"][:, at_end[0], at_end[1]]


@pytest.mark.parametrize("hydro", [{}, HYDRO], ids=["no coefficients", "in water"])
def test_runs_are_the_same(hydro):
    ours, theirs = (moved(model(**hydro), end) for model, end in ((one_line, (0, 1)), (three_lines, (2, 1))))
    assert np.ptp(ours[:, 2]) > 1e3  # something happens
    assert np.abs(ours - theirs).max() < 1e-7 * np.linalg.norm(ours, axis=1).max()


def test_joint_of_the_paper_carries_more():
    """Two equal cables, turned by up to a radian at the joint: the same places, two rules."""
    for turn in (0.1, 0.5, 1.0):
        rod = joint(1, 0.0, 0.0, -20.0)
        away = np.array([np.cos(turn), 0.0, np.sin(turn)]) * 8.0
        points = fixed(1, -8.0, 0.0, -20.0), fixed(2, *(away - [0.0, 0.0, 20.0]))
        part = (Section(line_type="cable", length=8.0, segments=4),)
        lines = (
            Line(id=1, sections=part, end_a=Attachment("point", 1), end_b=held(rod, "A")),
            Line(id=2, sections=part, end_a=held(rod, "B"), end_b=Attachment("point", 2)),
        )
        moments = []
        for flavour in ("native", "MoorDyn-C"):
            model = mooring(types(), points, lines, (rod,), gravity=0.0, water_density=0.0)
            built = build(dataclasses.replace(model, flavour=flavour))
            rest(built)
            corners = (-8.0, 0.0, -20.0), rod.end_a, points[1].position
            for k, (a, b) in enumerate(pairwise(corners)):
                built.state.position[5 * k : 5 * k + 5] = np.linspace(a, b, 5)
            moments.append(at_once(built)["bending_moment"][0, [4, 5]])
        exact = 2.0 * 2e4 / 2.0 * np.sin(0.5 * turn)
        assert moments[0] == pytest.approx([exact, exact], rel=1e-9)
        assert moments[1] == pytest.approx(np.full(2, exact / np.cos(0.25 * turn)), rel=1e-9)
