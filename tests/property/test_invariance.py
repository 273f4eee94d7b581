"""Results do not depend on where the axes point, where the origin lies, or how things are numbered.

Statics stop at an imbalance of 1e-3 N; where the mooring yields most, at 1 kN/m, that is 1e-6 m. Runs amplify
rounding and that difference a little when nodes meet the bed, which is why they are given more room.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from moorings import CHAIN, again, coupled, fixed, free, kind, line, mooring, points, run, statics

from moorage.model import Current, Model, Motion

DURATION, INTERVAL = 6.0, 0.25
ROPE = kind("rope", diameter=0.15, mass_per_length=30.0, axial_stiffness=5e6, axial_damping=1e5, transverse_drag=1.2)


def model() -> Model:
    """A chain of two sections to a coupled point, and a bridle of rope on a float, in a sheared current."""
    all_points = (
        fixed(1, -300.0, 20.0, -100.0),
        coupled(2, -20.0, 3.0, -8.0),
        fixed(3, 250.0, -60.0, -100.0),
        free(4, 100.0, -30.0, -40.0, mass=1500.0, volume=6.0, drag_area=2.0, added_mass=0.5),
        coupled(5, 15.0, -5.0, -10.0),
        fixed(6, 120.0, 140.0, -100.0),
    )
    lines = (
        line(1, 1, 2, ("chain", 150.0, 8), ("rope", 160.0, 8)),
        line(2, 3, 4, ("chain", 180.0, 10)),
        line(3, 4, 5, ("rope", 95.0, 5)),
        line(4, 6, 4, ("chain", 190.0, 8)),
    )
    current = Current((-100.0, 0.0), ((0.1, 0.05, 0.0), (0.6, -0.3, 0.0)))
    return mooring((CHAIN, ROPE), all_points, lines, water_depth=100.0, current=current)


def motion(turn=lambda vectors: vectors) -> Motion:
    """Points 2 and 5 go round in the same way, from rest."""
    time = np.linspace(0.0, DURATION + 1.0, 71)
    rise = np.clip(time / 3.0, 0.0, 1.0) ** 3
    moved = rise[:, None] * np.stack([2.0 * np.sin(time), 1.5 * np.cos(0.8 * time), 0.7 * np.sin(1.3 * time)], axis=1)
    at = {p.id: np.array(p.position) for p in model().coupled_points}
    return Motion.from_points(time, {id: turn(at[id] + moved) for id in at})


def mapped(original: Model, turn) -> Model:
    """The model with every position and the current's velocities turned."""

    def place(p):
        return dataclasses.replace(p, position=tuple(float(x) for x in turn(np.array(p.position))))

    origin = turn(np.zeros(3))
    current = original.environment.current
    velocity = tuple(tuple(float(x) for x in turn(np.array(v)) - origin) for v in current.velocity)
    return dataclasses.replace(
        original,
        points=tuple(place(p) for p in original.points),
        environment=dataclasses.replace(original.environment, current=Current(current.z, velocity)),
    )


def renumbered(original: Model, order_of_lines, order_of_points) -> Model:
    return dataclasses.replace(
        original,
        lines=tuple(original.lines[k] for k in order_of_lines),
        points=tuple(original.points[k] for k in order_of_points),
    )


def history(case: Model, prescribed: Motion):
    """Static positions of points, static forces of lines on their ends, and forces during a short run."""
    built = statics(case, prescribed, tolerance=1e-3)
    block = run(again(built), DURATION, dt_out=INTERVAL, time_step=0.025, tolerance=1e-5)
    return points(built).copy(), block["end_force"], block["point_position"]


@pytest.fixture(scope="module")
def plain():
    return history(model(), motion())


def rotation(angle: float):
    R = np.array([[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])
    return lambda vectors: vectors @ R.T


def mirror(vectors):
    return vectors * np.array([1.0, -1.0, 1.0])


TURNS = {
    "rotated by 37 degrees": rotation(np.deg2rad(37.0)),
    "rotated by 90 degrees": rotation(np.deg2rad(90.0)),
    "mirrored": mirror,
    "moved by 1 km": lambda vectors: vectors + np.array([1000.0, -700.0, 0.0]),
}


@pytest.mark.parametrize("name", TURNS)
def test_axes_do_not_matter(plain, name):
    turn = TURNS[name]
    positions, forces, path = history(mapped(model(), turn), motion(turn))
    expected_positions, expected_forces, expected_path = plain
    origin = turn(np.zeros(3))
    size = np.abs(expected_forces).max()
    assert np.abs(positions - turn(expected_positions)).max() < 1e-5
    assert np.abs(forces[0] - (turn(expected_forces[0]) - origin)).max() < 1e-6 * size
    assert np.abs(forces - (turn(expected_forces) - origin)).max() < 1e-5 * size
    assert np.abs(path - turn(expected_path)).max() < 1e-4


@pytest.mark.parametrize(
    ("lines", "order"), [((3, 2, 1, 0), (0, 1, 2, 3, 4, 5)), ((0, 1, 2, 3), (5, 3, 1, 0, 4, 2)), ((1, 3, 0, 2), (4, 0, 5, 1, 3, 2))]
)  # fmt: skip
def test_numbering_does_not_matter(plain, lines, order):
    positions, forces, path = history(renumbered(model(), lines, order), motion())
    expected_positions, expected_forces, expected_path = plain
    size = np.abs(expected_forces).max()
    assert np.abs(positions - expected_positions[list(order)]).max() < 1e-5
    assert np.abs(forces - expected_forces[:, list(lines)]).max() < 1e-6 * size
    assert np.abs(path - expected_path[:, list(order)]).max() < 1e-5


def test_direction_of_a_line_does_not_matter(plain):
    """Lines described from B to A give the same forces at exchanged ends."""
    original = model()
    flipped = dataclasses.replace(
        original,
        lines=tuple(
            dataclasses.replace(x, end_a=x.end_b, end_b=x.end_a, sections=x.sections[::-1]) for x in original.lines
        ),
    )
    positions, forces, path = history(flipped, motion())
    expected_positions, expected_forces, expected_path = plain
    size = np.abs(expected_forces).max()
    assert np.abs(positions - expected_positions).max() < 1e-5
    assert np.abs(forces[:, :, ::-1] - expected_forces).max() < 1e-5 * size
    assert np.abs(path - expected_path).max() < 1e-4


def test_a_wrong_turn_is_noticed(plain):
    """A model whose current did not turn along is told apart."""
    turn = TURNS["rotated by 37 degrees"]
    wrong = mapped(model(), turn)
    wrong = dataclasses.replace(
        wrong, environment=dataclasses.replace(wrong.environment, current=model().environment.current)
    )
    _, forces, _ = history(wrong, motion(turn))
    assert np.abs(forces[0] - turn(plain[1][0])).max() > 1e-3 * np.abs(plain[1]).max()


def test_other_lines_do_not_matter(plain):
    """Islands do not see each other: line 1 alone gives the same numbers, bit for bit."""
    whole = model()
    alone = dataclasses.replace(whole, lines=whole.lines[:1], points=whole.points[:2])
    moved = motion()
    moved = Motion.from_points(moved.time, {2: moved.points[2]})
    _, forces, _ = history(alone, moved)
    assert (forces[:, 0] == plain[1][:, 0]).all()
