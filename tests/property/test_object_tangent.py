"""Newton increments of islands with rods and bodies undo the out-of-balance forces, whatever rides on what.

S x = f is solved by elimination along the lines, at the junctions and in the objects. Moved by +-e x, the forces must
change by -+e f: central differences along one direction prove matrix and elimination at once. What `solve.fold` leaves
out (how velocities and accelerations of riders turn, the attitude of drag and added mass) is nothing without velocities
and accelerations of objects; T(Psi) is the identity at the start of a step. What turns with an arm is taken from the
line as it will be when its nodes are in balance: here they are, by their own accelerations. Friction and the bed play
no part.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from dense import increments
from floats import SPAR, WATER, body, floating, rod
from moorings import again, at_rest, fixed, free, held, joint, kind, line

from moorage.layout import Weights
from moorage.model import Model, Point
from moorage.physics.rigid import SLENDER
from moorage.solve.newton import assemble_island, largest_imbalance
from moorage.system.attach import copy_free_ends
from moorage.system.build import Built
from moorage.system.ride import place_riders

STEP, STATIC = Weights(1.0, 0.03, 9e-4), Weights(1.0, 0.0, 1.0)
ROPE = kind("rope", mass_per_length=60.0, diameter=0.2, axial_stiffness=2e5, axial_damping=4e3)
CABLE = kind("cable", mass_per_length=60.0, diameter=0.2, axial_stiffness=2e5, bending_stiffness=900.0)
HULL = {"mass": 500.0, "inertia": (300.0, 400.0, 200.0), "volume": 0.7, "centre_of_gravity": (0.1, -0.2, -0.4)}
HULL |= {"added_mass": (0.5, 0.5, 0.5, 0.1, 0.2, 0.3)}


def on(id: int, carrier: int, *arm: float) -> Point:
    return Point(id=id, kind="fixed", position=arm, body=carrier)  # type: ignore[arg-type]


def topologies() -> dict[str, Model]:
    """All ways in which lines, rods and bodies meet."""
    a, b, c = fixed(1, 0.0, 0.0, -20.0), fixed(2, 16.0, 2.0, -12.0), fixed(3, 4.0, 9.0, -19.0)
    hull = body(position=(8.0, 2.0, -15.0), rotation=(0.2, -0.1, 0.3), **HULL)
    eyes = on(4, 1, -1.0, 0.0, 0.2), on(5, 1, 1.0, 0.3, 0.0), on(6, 1, 0.0, 1.0, -0.5)
    ropes = line(1, 1, 4, ("rope", 8.0, 4)), line(2, 5, 2, ("rope", 8.0, 3)), line(3, 3, 6, ("cable", 8.0, 4))
    stick = rod(1, "free", (6.0, 0.0, -16.0), (9.0, 1.0, -14.0), 3)
    A, B = held(stick, "A"), held(stick, "B")
    foot = rod(2, "pinned", (0.0, 0.0, -20.0), (1.0, 0.5, -17.0), 2)
    moved = rod(2, "coupled-pinned", (0.0, 0.0, -20.0), (1.0, 0.5, -17.0), 2)
    arm = rod(3, "pinned", (1.0, 0.0, 0.3), (3.0, 0.5, 0.0), 2, body=1)
    fin = rod(4, "fixed", (0.0, -1.0, 0.0), (0.0, -3.0, 0.5), 2, body=1)
    stub = rod(5, "fixed", (-0.5, 0.0, 0.0), (-1.0, 0.0, 0.2), 0, body=1)
    j = joint(6, 12.0, 2.0, -15.0)
    more = joint(7, 14.0, 4.0, -14.0), joint(8, 11.0, 6.0, -17.0)
    m = free(7, 4.0, 1.0, -17.0, mass=200.0, volume=0.1)
    spar = rod(1, "free", (6.0, 0.0, -5.0), (6.5, 0.4, 3.0), 4)

    def of(bodies, rods, points, *lines):
        return floating(bodies, rods, SPAR, (ROPE, CABLE), WATER, points=points, lines=lines)

    return {
        "free body on ropes": of((hull,), (), (a, b, c, *eyes), *ropes),
        "free body, a free point on its line": of((hull,), (), (a, b, c, *eyes, m), line(1, 1, 7, ("rope", 4.0, 3)),
                                                  line(2, 4, 7, ("rope", 4.0, 3)), *ropes[1:]),
        "free rod": of((), (stick,), (a, b), line(1, 1, A, ("rope", 7.0, 4)), line(2, B, 2, ("rope", 7.0, 3))),
        "free rod that clamps cables": of((), (stick,), (a, b), line(1, 1, A, ("cable", 7.0, 4)),
                                          line(2, B, 2, ("cable", 7.0, 5))),
        "pinned rod": of((), (foot,), (b,), line(1, held(foot, "B"), 2, ("cable", 18.0, 5))),
        "coupled-pinned rod": of((), (moved,), (b,), line(1, 2, held(moved, "B"), ("rope", 18.0, 5))),
        "rods pinned and fixed to a free body": of((hull,), (arm, fin), (a, b, c, *eyes), ropes[0],
                                                   line(2, held(arm, "B"), 2, ("cable", 6.0, 3)),
                                                   line(3, 3, held(fin, "B"), ("cable", 12.0, 4))),
        "rod pinned to a body, at its pin": of((hull,), (arm,), (a, b, c, *eyes), ropes[0], ropes[2],
                                               line(2, held(arm, "A"), 2, ("rope", 8.0, 3))),
        "clamp of no length on a free body": of((hull,), (stub,), (a, b, *eyes), ropes[1],
                                                line(1, 1, held(stub, "B"), ("cable", 8.0, 6))),
        "pinned body": of((body(kind="pinned", position=(8.0, 2.0, -15.0), **HULL),), (fin,), (a, c, *eyes), ropes[0],
                          line(3, 3, held(fin, "B"), ("cable", 12.0, 4))),
        "cables joined between a body and a rod": of((hull,), (stick, stub, j), (a, b, *eyes), ropes[0],
                                                     line(2, held(stub, "B"), held(j, "A"), ("cable", 6.0, 4)),
                                                     line(3, held(j, "B"), B, ("cable", 5.0, 4))),
        "joint of three cables": of((), (joint(6, 8.0, 2.0, -15.0),), (a, b, c), line(1, 1, held(j, "A"), ("cable", 9.0, 4)),
                                    line(2, held(j, "B"), 2, ("cable", 9.0, 2)), line(3, 3, held(j, "B"), ("cable", 9.0, 3))),
        "joint of three cables and a rope, between two more": of(
            (), (j, *more), (a, b, c), line(1, 1, held(j, "A"), ("cable", 13.0, 3)), line(2, held(j, "B"), held(more[0], "A"), ("cable", 5.0, 3)),
            line(3, held(j, "B"), held(more[1], "B"), ("cable", 6.0, 4)), line(4, held(more[0], "B"), 2, ("cable", 6.0, 3)),
            line(5, held(more[0], "B"), 3, ("cable", 9.0, 3)), line(6, held(more[1], "A"), 3, ("cable", 9.0, 3)),
            line(7, held(j, "A"), 3, ("rope", 12.0, 3))),
        "pinned joint": of((), (dataclasses.replace(j, kind="pinned"),), (a, b), line(1, 1, held(j, "A"), ("cable", 13.0, 2)),
                           line(2, held(j, "B"), 2, ("cable", 6.0, 4))),
        "coupled-pinned joint": of((), (dataclasses.replace(j, kind="coupled-pinned"),), (a, b),
                                   line(1, held(j, "A"), 1, ("cable", 13.0, 4)), line(2, held(j, "B"), 2, ("cable", 6.0, 4))),
        "joint pinned to a free body": of((hull,), (dataclasses.replace(joint(6, 0.5, 0.2, 0.3), kind="pinned", body=1),),
                                          (a, b, c, *eyes), ropes[0], line(2, held(j, "A"), 3, ("cable", 9.0, 4)),
                                          line(3, held(j, "B"), 2, ("cable", 10.0, 4))),
        "one segment from body to body": of((hull, body(2, position=(11.0, 3.0, -13.0), **HULL)), (),
                                            (a, *eyes, on(7, 2, 0.3, 0.2, -0.8)), ropes[0], line(2, 5, 7, ("rope", 2.0, 1))),
        "spar through the surface": of((), (spar,), (a,), line(1, 1, A, ("rope", 17.0, 4))),
    }  # fmt: skip


TOPOLOGIES = topologies()


def settle(built: Built) -> None:
    """Let riders and line ends follow the objects and free points."""
    system, state = built.system, built.state
    for island in range(len(system.islands.line_ptr) - 1):
        place_riders(system.lines, system.islands, system.riders, state, built.work.direction, island)
        for rows in state[:3]:
            copy_free_ends(system.lines, system.islands, island, rows)


def unknowns(built: Built) -> np.ndarray:
    """Rows of the state that are unknown: interior nodes, free points, and both rows of objects."""
    ptr, islands = built.names.node_ptr, built.system.islands
    inside = np.setdiff1d(np.arange(ptr[-1]), np.concatenate([ptr[:-1], ptr[1:] - 1]))
    first = built.system.lines.node_ptr[-1]
    loose = [first + p for p in islands.points if built.system.riders.points[p] < 0]
    objects = np.concatenate([built.system.riders.row, built.system.riders.row + 1])
    return np.unique(np.concatenate([inside, loose, objects]).astype(int))


def shaken(model: Model) -> Built:
    built = at_rest(model)
    random = np.random.default_rng(5)
    rows = np.setdiff1d(unknowns(built), built.system.riders.row[built.system.riders.pin >= 0])
    built.state.position[rows] += random.normal(0.0, 0.05, (len(rows), 3))
    turned = built.system.riders.row[built.system.rigid.table[:, SLENDER] > 0.0] + 1
    built.state.position[turned, 0] = 0.0  # rods do not spin
    settle(built)
    for o in range(len(built.system.riders.row)):
        built.state.base[o] = built.state.attitude[o]
        built.state.position[built.system.riders.row[o] + 1] = 0.0
    imbalance(built, STEP)
    nodes = unknowns(built)[unknowns(built) < built.names.node_ptr[-1]]
    built.state.acceleration[nodes] = built.work.force[nodes] / built.system.morison.mass[nodes, None]
    return built


def imbalance(built: Built, c: Weights) -> np.ndarray:
    """Out-of-balance forces and moments of the unknown rows, (rows, 3)."""
    for island in range(len(built.system.islands.line_ptr) - 1):
        assemble_island(built.system, built.state, built.state, built.work, island, c, 0.0)
        largest_imbalance(built.system, built.state, built.work, island, c)
    force = built.work.force.copy()
    force[built.system.riders.row[built.system.rigid.table[:, SLENDER] > 0.0] + 1, 0] = 0.0
    return force[unknowns(built)]


def missed(name: str, c: Weights, wrong: float = 1.0) -> float:
    """What is left of the forces after an increment, relative to them, by differences; `wrong` scales its rotations."""
    built = shaken(TOPOLOGIES[name])
    f = imbalance(built, c)
    x = increments(again(built), c)
    x[built.system.riders.row + 1] *= wrong
    rows = unknowns(built)
    e = 1e-5 / np.abs(c.stiffness * x[rows]).max()
    sides = []
    for sign in (1.0, -1.0):
        moved = again(built)
        for values, weight in (
            (moved.state.position, c.stiffness),
            (moved.state.velocity, c.damping),
            (moved.state.acceleration, c.mass),
        ):
            values[rows] += sign * e * weight * x[rows]
        settle(moved)
        sides.append(imbalance(moved, c))
    change = (sides[0] - sides[1]) / (2.0 * e)
    return float(np.abs(change + f).max() / np.abs(f).max())


@pytest.mark.parametrize("name", TOPOLOGIES)
@pytest.mark.parametrize("c", [STEP, STATIC], ids=["step", "static"])
def test_increment_is_that_of_the_forces(name, c):
    """Differences of 1e-5 m leave 1e-10 of curvature, and rounding of 1e-11 over 1e-5 in metres.

    The matrix leaves out how the band in which a rod dries grows as it turns: d^2 / 16 tan^2 T against a^2 / 2.
    """
    assert missed(name, c) < (1e-4 if "surface" in name else 1e-5)


def test_another_rotation_is_noticed():
    assert missed("free body on ropes", STATIC, 1.01) > 1e-4
