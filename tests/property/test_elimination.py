"""Elimination along the lines and at the junctions gives the increment of the dense system, whatever the topology.

Tolerances are rounding times the condition of the matrices, which is below 1e5 for S = M + c_C C + c_K K here.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from dense import STIFFNESS, assembled, dense_increments, increments, reduced, shaken
from moorings import CHAIN, clamp, coupled, fixed, free, held, joint, kind, line, mooring, point_forces, spread, statics

from moorage._jit import kernel
from moorage.layout import Weights, copy_of, new_work
from moorage.model import Attachment, Line, Model, Rod
from moorage.solve.line_solve import assemble_and_reduce, back_substitute, reduce_line, substitute
from moorage.solve.newton import newton_island
from moorage.solve.statics import solve
from moorage.solve.stiffness import condense_island, coupled_stiffness, platform_stiffness
from moorage.system.assemble import assemble_line
from moorage.system.attach import copy_free_ends

STEP = Weights(1.0, 0.03, 9e-4)
PROPERTIES = {
    "axial_damping": 4e3, "transverse_drag": 1.2, "tangential_drag": 0.3, "transverse_added_mass": 1.0,
    "tangential_added_mass": 0.1,
}  # fmt: skip
ROPE = kind("rope", mass_per_length=60.0, diameter=0.2, axial_stiffness=2e5, **PROPERTIES)
CABLE = kind("cable", mass_per_length=60.0, diameter=0.2, axial_stiffness=2e5, bending_stiffness=900.0, **PROPERTIES)
MASS = {"mass": 200.0, "volume": 0.1, "drag_area": 0.5, "added_mass": 0.7}


def topologies() -> dict[str, Model]:
    """All ways in which lines meet: rope does not bend, cable does."""
    a, b, c = fixed(1, 0.0, 0.0, -20.0), coupled(2, 16.0, 2.0, -12.0), fixed(3, 4.0, 9.0, -19.0)
    m, m2 = free(4, 8.0, 1.0, -17.0, **MASS), free(5, 11.0, 2.0, -15.0, **MASS)
    loose = free(5, 8.0, 1.0, -27.0)

    foot = clamp(1, (0.0, 0.0, -20.0), (0.3, 0.1, 1.0))
    top = clamp(2, (16.0, 2.0, -12.0), (0.0, 0.2, 1.0))
    j1, j2, pin = joint(3, 8.0, 1.0, -17.0), joint(4, 11.0, 1.5, -15.0), joint(5, 8.0, 1.0, -17.0)
    A, B = held(foot, "B"), held(top, "A")

    def of(points, *lines, rods=()):
        return mooring((ROPE, CABLE), points, lines, rods, water_depth=19.9)

    return {
        "ends held": of((a, b), line(1, 1, 2, ("rope", 15.0, 7))),
        "ends held, bent": of((a, b), line(1, 1, 2, ("cable", 15.0, 7))),
        "end B free": of((a, m), line(1, 1, 4, ("rope", 15.0, 7))),
        "end A free": of((a, m), line(1, 4, 1, ("rope", 15.0, 7))),
        "end A free, bent": of((a, m), line(1, 4, 1, ("cable", 15.0, 7))),
        "both ends free": of((m, loose), line(1, 4, 5, ("rope", 9.0, 6))),
        "bridle": of((a, b, c, m), line(1, 4, 1, ("rope", 8.0, 4)), line(2, 4, 2, ("cable", 8.0, 5)),
                     line(3, 3, 4, ("rope", 8.0, 1))),
        "chain of free points": of((a, b, m, m2), line(1, 1, 4, ("rope", 8.0, 4)), line(2, 5, 4, ("cable", 3.0, 4)),
                                   line(3, 5, 2, ("rope", 5.0, 3)), line(4, 4, 5, ("rope", 3.2, 2))),
        "one segment": of((a, b), line(1, 1, 2, ("rope", 15.0, 1))),
        "one segment, both ends free": of((a, b, m, m2), line(1, 1, 4, ("rope", 8.0, 1)), line(2, 4, 5, ("rope", 3.0, 1)),
                                          line(3, 5, 2, ("cable", 5.0, 1))),
        "two segments": of((a, m), line(1, 4, 1, ("rope", 8.0, 2))),
        "two segments, bent": of((a, m), line(1, 4, 1, ("cable", 8.0, 2))),
        "two islands": of((a, b, c, m), line(1, 1, 2, ("rope", 15.0, 5)), line(2, 4, 3, ("cable", 9.0, 5))),
        "clamped at both ends": of((), line(1, A, B, ("cable", 19.0, 8)), rods=(foot, top)),
        "clamped and free": of((m,), line(1, A, 4, ("cable", 10.0, 6)), line(2, 4, B, ("cable", 10.0, 3)), rods=(foot, top)),
        "joined cables": of((), line(1, A, held(j1, "A"), ("cable", 9.0, 5)), line(2, held(j1, "B"), B, ("cable", 10.0, 6)),
                            rods=(foot, top, j1)),
        "joined, turned round": of((a, b), line(1, held(j1, "A"), 1, ("cable", 9.0, 4)), line(2, 2, held(j1, "B"), ("cable", 10.0, 4)),
                                   rods=(j1,)),
        "two joints": of((a,), line(1, 1, held(j1, "A"), ("cable", 9.0, 3)), line(2, held(j2, "A"), held(j1, "B"), ("cable", 4.0, 4)),
                         line(3, held(j2, "B"), B, ("cable", 7.0, 3)), rods=(top, j1, j2)),
        "joint with a rope on it": of((b, c), line(1, A, held(pin, "A"), ("cable", 9.0, 4)), line(2, held(pin, "B"), 2, ("cable", 9.0, 4)),
                                      line(3, 3, held(pin, "A"), ("rope", 9.0, 3)), rods=(foot, pin)),
        "a point by itself": of((a, b, m), line(1, 1, 2, ("rope", 15.0, 4))),
    }  # fmt: skip


TOPOLOGIES = topologies()


@pytest.mark.parametrize("name", TOPOLOGIES)
@pytest.mark.parametrize("c", [STEP, Weights(1.0, 0.0, 0.0), Weights(1.0, 0.5, 0.5)])
def test_condensed_increment_is_the_dense_one(name, c):
    built = shaken(TOPOLOGIES[name])
    x = dense_increments(built, c)
    used = np.concatenate([np.arange(built.names.node_ptr[-1]), built.names.node_ptr[-1] + built.system.islands.points])
    assert np.abs(increments(built, c) - x)[used].max() <= 1e-9 * max(np.abs(x).max(), 1e-300)


@pytest.mark.parametrize("name", [name for name in TOPOLOGIES if "join" in name or "clamp" in name or "bridle" in name])
def test_matrix_of_joined_lines_is_the_derivative_of_their_forces(name):
    """Hinges of joints and clamps included, in the unknowns that line ends share (central differences, 1e-6 m)."""
    built = shaken(TOPOLOGIES[name], 0.05)
    for rows in built.state[1:4]:
        rows[...] = 0.0
    K, _, T = reduced(built, STIFFNESS)
    D = np.zeros_like(K)
    for k in range(len(K)):
        sides = []
        for sign in (1.0, -1.0):
            moved = copy_of(built.state)
            moved.position[...] += sign * 1e-6 * T[:, k].reshape(-1, 3)
            sides.append(reduced(built._replace(state=moved), STIFFNESS)[1])
        D[:, k] = -(sides[0] - sides[1]) / 2e-6
    assert np.abs(K - D).max() < 1e-6 * np.abs(D).max()


@kernel
def newton(system, state, before, work, island, c):
    newton_island(system, state, before, work, island, c, 0.0)


@pytest.mark.parametrize("name", TOPOLOGIES)
def test_newton_in_one_walk_is_newton_step_by_step(name):
    """`newton_island` merges assembly and elimination for lines that allow it; the increment is the same."""
    built = shaken(TOPOLOGIES[name])
    expected = increments(built, STEP)
    other = built._replace(work=new_work(built.system))
    other.work.direction[...] = built.work.direction
    for island in range(len(built.system.islands.line_ptr) - 1):
        newton(other.system, other.state, other.state, other.work, island, STEP)
    assert np.abs(other.work.increment - expected).max() <= 1e-12 * max(np.abs(expected).max(), 1e-300)


@kernel
def merged(system, state, work, line, c):
    assemble_and_reduce(system, state, state, work, line, c)


@kernel
def merged_back(system, work, line):
    substitute(system.lines, work, line)


@pytest.mark.parametrize("segments", [1, 2, 3, 12])
def test_merged_walk_is_assembly_then_elimination(segments):
    model = mooring(
        ROPE, (fixed(1, 0.0, 0.0, -20.0), free(2, 9.0, 1.0, -15.0, **MASS)), (line(1, 1, 2, ("rope", 11.0, segments)),)
    )
    built = shaken(model)
    system, last = built.system, segments
    results = []
    for one_walk in (True, False):
        work = new_work(system)
        if one_walk:
            merged(system, built.state, work, 0, STEP)
        else:
            assemble_line(system, built.state, built.state, work, 0, STEP)
            reduce_line(system.lines, work, 0, False)
        condensed = work.blocks.own[last].copy(), work.force[last].copy()
        work.increment[last] = 0.3, -0.2, 0.1
        if one_walk:
            merged_back(system, work, 0)
        else:
            back_substitute(system.lines, work, 0, False)
        results.append((*condensed, work.increment[: last + 1].copy()))
    for a, b in zip(*results, strict=True):
        assert np.abs(a - b).max() <= 1e-12 * np.abs(b).max()


@pytest.mark.parametrize("name", ["end B free", "end A free, bent", "bridle", "chain of free points"])
def test_ends_move_with_their_points(name):
    built = shaken(TOPOLOGIES[name])
    x = increments(built, STEP)
    copied = x.copy()
    copy_free_ends(built.system.lines, built.system.islands, 0, copied)
    assert (copied == x).all()


@pytest.mark.parametrize("name", ["ends held", "ends held, bent", "both ends free", "one segment", "bridle"])
def test_condensed_end_blocks_are_schur_complements(name):
    """What elimination leaves at the ends of a line is K_ee - K_ei K_ii^-1 K_ie of the line's dense matrix."""
    built = shaken(TOPOLOGIES[name])
    K = assembled(built, STIFFNESS)[0]
    blocks, across = np.zeros((len(built.names.lines), 4, 4, 9)), np.zeros((0, 9))
    for island in range(len(built.system.islands.line_ptr) - 1):
        condense_island(built.system, built.state, built.work, island, STIFFNESS, blocks, across)
    blocks = blocks[:, ::3, ::3].reshape(-1, 2, 2, 3, 3)
    for k, (first, end) in enumerate(zip(built.names.node_ptr[:-1], built.names.node_ptr[1:], strict=True)):
        n = 3 * (end - first)
        part = K[3 * first : 3 * end, 3 * first : 3 * end]
        ends, inner = np.r_[0:3, n - 3 : n], np.arange(3, n - 3)
        schur = part[np.ix_(ends, ends)]
        if len(inner):
            schur = schur - part[np.ix_(ends, inner)] @ np.linalg.solve(
                part[np.ix_(inner, inner)], part[np.ix_(inner, ends)]
            )
        mine = blocks[k].transpose(0, 2, 1, 3).reshape(6, 6)
        assert np.abs(mine - schur).max() <= 1e-8 * np.abs(schur).max()


def bridled() -> Model:
    """Two coupled points, a free one with buoyancy, and three chains: everything that a stiffness can contain."""
    points = (
        fixed(1, -400.0, 0.0, -100.0),
        fixed(2, 400.0, 100.0, -100.0),
        coupled(3, -10.0, 5.0, -10.0),
        coupled(4, 12.0, -3.0, -8.0),
        free(5, 200.0, 60.0, -30.0, mass=2e3, volume=8.0),
    )
    lines = (
        line(1, 1, 3, ("chain", 402.0, 20)),
        line(2, 2, 5, ("chain", 225.0, 10)),
        line(3, 5, 4, ("chain", 200.0, 10)),
    )
    return mooring(CHAIN, points, lines, water_depth=100.0)


def test_platform_stiffness_is_the_derivative_of_the_static_forces():
    """Against central differences of whole static solutions: statics to 1e-4 N and moves of 1 mm make 1e-6 of K."""
    model = bridled()
    built = statics(model, tolerance=1e-4)

    def load(displacement):
        """Force, and moment about the platform's point that was at the origin, with the platform moved."""
        moved = statics(model, tolerance=1e-4)
        dx, turn = displacement[:3], displacement[3:]
        arms = []
        for k in moved.coupled:
            r = moved.system.tracks.rest[k]
            moved.system.tracks.rest[k] = r + dx + np.cross(turn, r) + 0.5 * np.cross(turn, np.cross(turn, r))
            arms.append(moved.system.tracks.rest[k] - dx)
        solve(moved, 1e-4)
        force = point_forces(moved)[moved.coupled]
        return np.concatenate([force.sum(axis=0), np.cross(arms, force).sum(axis=0)])

    expected = np.zeros((6, 6))
    for k in range(6):
        d = np.zeros(6)
        d[k] = 1e-3 if k < 3 else 1e-4
        expected[:, k] = -(load(d) - load(-d)) / (2.0 * d[k])
    K = platform_stiffness(built, point_forces(built)[built.coupled])
    size = np.sqrt(np.abs(np.diag(expected)))
    assert np.abs((K - expected) / np.outer(size, size)).max() < 1e-5
    assert coupled_stiffness(built, built.coupled).shape == (2, 3, 2, 3)


def on_a_rod(stiffness: float) -> Model:
    """The chain of `bridled` to point 3, held by a coupled rod that points down instead."""
    rod = Rod(id=1, rod_type="clamp", kind="coupled", end_a=(-10.0, 5.0, -10.0), end_b=(-10.0, 5.0, -11.0), segments=0)
    chain = dataclasses.replace(CHAIN, bending_stiffness=stiffness)
    lines = (
        Line(
            id=1,
            sections=line(1, 1, 2, ("chain", 402.0, 20)).sections,
            end_a=Attachment("point", 1),
            end_b=held(rod, "B"),
        ),
    )
    return mooring(chain, (fixed(1, -400.0, 0.0, -100.0),), lines, (rod,), water_depth=100.0)


def test_stiffness_of_a_rod_that_hardly_bends_a_cable_is_that_of_a_point():
    """EI of 1 N m2 turns the chain's end by T l / EI times less than it would like; measured steps leave 2e-3."""
    point = mooring(
        CHAIN, (fixed(1, -400.0, 0.0, -100.0), coupled(3, -10.0, 5.0, -10.0)), (line(1, 1, 3, ("chain", 402.0, 20)),),
        water_depth=100.0,
    )  # fmt: skip
    reference, rod = statics(point, tolerance=1e-4), statics(on_a_rod(1.0), tolerance=1e-4)
    expected = platform_stiffness(reference, point_forces(reference)[reference.coupled])
    size = np.sqrt(np.abs(np.diag(expected)))
    assert np.abs((platform_stiffness(rod) - expected) / np.outer(size, size)).max() < 2e-3


@pytest.mark.parametrize("length", [1100.0, 2000.0])
def test_slack_lines_have_a_finite_stiffness(length):
    """Piled on the bed or hanging straight down, nodes yield without resistance; a platform over them yields too.

    What rounding leaves of EA / l is 1e-6 of it.
    """
    built = statics(spread(20, length=length))
    K = platform_stiffness(built, point_forces(built)[built.coupled])
    assert np.isfinite(K).all()
    assert (np.diag(K) >= -1e-6 * built.system.tension.spring.max()).all()
