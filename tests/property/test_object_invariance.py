"""Rods and bodies do not care where the axes point, where the origin lies, or how they are numbered.

Room as in `test_invariance`: statics stop at 1 mN, and runs amplify that and rounding a little.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from floats import body, floating, rod
from moorings import again, fixed, free, held, joint, kind, line, run, statics

from moorage.model import Attachment, Current, Environment, Model, Point, RodType
from moorage.model.motion import rotation_matrices
from moorage.solve.carried import euler_angles

ROPE = kind("rope", mass_per_length=20.0, axial_stiffness=2e6, axial_damping=4e4, transverse_drag=1.2)
CABLE = kind(
    "cable", mass_per_length=25.0, axial_stiffness=2e6, axial_damping=4e4, bending_stiffness=3e3, transverse_drag=1.2
)
TYPE = RodType(
    name="spar", diameter=0.5, mass_per_length=120.0, transverse_drag=0.8, transverse_added_mass=1.0, end_drag=0.5,
    end_added_mass=0.6,
)  # fmt: skip
DURATION = 3.0
MIRROR = np.diag([1.0, -1.0, 1.0])


def on(id: int, carrier: int, *arm: float) -> Point:
    return Point(id=id, kind="fixed", position=arm, body=carrier)  # type: ignore[arg-type]


def model() -> Model:
    """A buoy on three lines with a fin and a rod pinned to it, a free rod between lines, a pinned rod, a pinned body,
    a joint of three cables and one of two."""
    buoy = body(
        1, position=(0.0, 0.0, -8.0), rotation=(0.1, 0.2, -0.4), mass=3e3, volume=7.0, inertia=(4e3, 5e3, 3e3),
        centre_of_gravity=(0.1, 0.05, -0.6), drag_area=(3.0, 2.0, 4.0, 9.0, 8.0, 7.0),
        added_mass=(0.5, 0.8, 0.3, 0.1, 0.1, 0.05),
    )  # fmt: skip
    stiff = body(2, "pinned", (-25.0, 18.0, -40.0), mass=300.0, volume=2.0, inertia=(90.0, 80.0, 70.0), rotation=(0.0, 0.1, 0.9),
                 centre_of_gravity=(0.2, 0.0, 0.1), drag_area=(1.0, 1.0, 1.0, 1.0, 2.0, 1.0))  # fmt: skip
    points = (
        fixed(1, 40.0, 5.0, -50.0), fixed(2, -18.0, -40.0, -50.0), fixed(3, -22.0, 33.0, -50.0),
        on(4, 1, 1.0, 0.2, -0.3), on(5, 1, -0.5, -1.0, -0.4), on(6, 1, -0.6, 0.9, -0.5), on(7, 2, 0.0, 0.0, 1.5),
        free(8, 25.0, 4.0, -25.0, mass=60.0, volume=0.2, drag_area=0.3), fixed(9, -40.0, 5.0, -50.0),
    )  # fmt: skip
    rods = (
        rod(1, "free", (-9.0, -22.0, -26.0), (-7.5, -19.0, -22.0), 3),
        rod(2, "pinned", (0.3, 0.0, 0.4), (0.5, 0.2, 3.0), 2, body=1),
        rod(3, "fixed", (0.0, 0.0, -1.0), (0.0, 0.0, 1.2), 2, body=1),
        rod(4, "fixed", (-1.0, 0.3, 0.0), (-1.5, 0.4, -1.0), 0, body=1),
        rod(5, "pinned", (20.0, -20.0, -50.0), (20.3, -19.6, -46.0), 2),
        joint(6, -13.0, 12.0, -25.0),
        joint(7, -20.0, 10.0, -33.0),
    )
    lines = (
        line(1, 1, 8, ("rope", 28.0, 4)), line(2, 8, 4, ("rope", 30.5, 4)), line(3, 2, held(rods[0], "A"), ("cable", 32.0, 5)),
        line(4, held(rods[0], "B"), 5, ("rope", 25.0, 4)), line(5, 7, held(rods[5], "A"), ("cable", 18.0, 4)),
        line(6, held(rods[5], "B"), held(rods[3], "B"), ("cable", 24.0, 5)), line(7, 3, 6, ("rope", 56.0, 5)),
        line(8, held(rods[4], "B"), 4, ("rope", 52.0, 5)), line(9, held(rods[6], "A"), 9, ("cable", 27.0, 5)),
        line(10, held(rods[5], "A"), held(rods[6], "B"), ("cable", 13.0, 3)),
    )  # fmt: skip
    made = floating((buoy, stiff), rods, TYPE, (ROPE, CABLE), points=points, lines=lines)
    current = Current((-50.0, 0.0), ((0.1, 0.0, 0.0), (0.4, -0.2, 0.0)))
    return dataclasses.replace(made, environment=Environment(water_depth=300.0, current=current))


def mapped(original: Model, Q, shift, turns_current: bool = True) -> Model:
    """The model with every place turned by Q (a rotation about z, or MIRROR) and shifted, bodies' own axes mirrored too."""
    S = MIRROR if np.linalg.det(Q) < 0.0 else np.eye(3)

    def place(x, own=False):
        return tuple(float(v) for v in ((S @ x) if own else Q @ x + shift))

    def whole(b):
        R = Q @ rotation_matrices(np.array([b.rotation]))[0] @ S
        angles = tuple(float(v) for v in euler_angles(R))
        return dataclasses.replace(
            b, position=place(b.position), rotation=angles, centre_of_gravity=place(b.centre_of_gravity, own=True)
        )

    env, velocity = original.environment, original.environment.current.velocity
    flow = tuple(tuple(float(x) for x in (Q @ v if turns_current else v)) for v in velocity)
    return dataclasses.replace(
        original,
        points=tuple(dataclasses.replace(p, position=place(p.position, p.body is not None)) for p in original.points),
        rods=tuple(
            dataclasses.replace(r, end_a=place(r.end_a, r.body is not None), end_b=place(r.end_b, r.body is not None))
            for r in original.rods
        ),
        bodies=tuple(whole(b) for b in original.bodies),
        environment=dataclasses.replace(env, current=Current(env.current.z, flow)),
    )


def history(case: Model):
    built = statics(case, tolerance=1e-3)
    still = run(again(built), 0.05, dt_out=0.05, time_step=0.05)
    for o, row in enumerate(built.system.riders.row):
        if built.system.riders.pin[o] < 0:
            built.state.velocity[row, 2] = 0.5  # which no turn about z changes
    block = run(again(built), DURATION, dt_out=0.25, time_step=0.0125, tolerance=1e-5)
    return still, block


@pytest.fixture(scope="module")
def plain():
    return history(model())


def check(plain, other, Q, shift, lines=slice(None), bodies=slice(None), rods=slice(None)) -> None:
    S = MIRROR if np.linalg.det(Q) < 0.0 else np.eye(3)
    for mine, theirs, room in ((other[0], plain[0], 1e-5), (other[1], plain[1], 1e-4)):
        assert np.abs(mine["body_position"] - (theirs["body_position"][:, bodies] @ Q.T + shift)).max() < room
        assert np.abs(mine["rod_position"] - (theirs["rod_position"][:, rods] @ Q.T + shift)).max() < room
        assert np.abs(mine["body_axes"] - Q @ theirs["body_axes"][:, bodies] @ S).max() < room
        size = np.abs(theirs["end_force"]).max()
        assert np.abs(mine["end_force"] - theirs["end_force"][:, lines] @ Q.T).max() < 10.0 * room * size
        # an axial vector keeps its direction where a polar one is mirrored
        moment = theirs["body_force"][:, bodies, 3:] @ (np.linalg.det(Q) * Q).T
        assert np.abs(mine["body_force"][..., 3:] - moment).max() < 10.0 * room * size


def about_z(degrees: float) -> np.ndarray:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


@pytest.mark.parametrize(
    ("Q", "shift"),
    [(about_z(37.0), 0.0), (about_z(90.0), 0.0), (MIRROR, 0.0), (np.eye(3), np.array([1000.0, -700.0, 0.0]))],
    ids=["rotated by 37 degrees", "rotated by 90 degrees", "mirrored", "moved by 1 km"],
)
def test_axes_do_not_matter(plain, Q, shift):
    check(plain, history(mapped(model(), Q, shift)), Q, shift)


def test_numbering_does_not_matter(plain):
    original = model()
    number = {
        ("rod", 1): 16,
        ("rod", 2): 15,
        ("rod", 3): 12,
        ("rod", 4): 13,
        ("rod", 5): 14,
        ("rod", 6): 11,
        ("rod", 7): 17,
    }
    order, rods = (3, 7, 9, 0, 5, 1, 6, 8, 4, 2), (5, 2, 0, 6, 4, 1, 3)

    def renamed(end: Attachment) -> Attachment:
        return dataclasses.replace(end, id=number.get((end.kind, end.id), end.id))

    def on_other(thing):
        return dataclasses.replace(thing, body=None if thing.body is None else 3 - thing.body)

    lines = tuple(
        dataclasses.replace(
            original.lines[k], end_a=renamed(original.lines[k].end_a), end_b=renamed(original.lines[k].end_b)
        )
        for k in order
    )
    other = dataclasses.replace(
        original,
        lines=lines,
        bodies=tuple(dataclasses.replace(b, id=3 - b.id) for b in original.bodies[::-1]),
        rods=tuple(
            dataclasses.replace(on_other(original.rods[k]), id=number["rod", original.rods[k].id]) for k in rods
        ),
        points=tuple(on_other(p) for p in original.points[::-1]),
    )
    check(plain, history(other), np.eye(3), 0.0, list(order), [1, 0], list(rods))


def test_a_current_that_did_not_turn_is_noticed(plain):
    Q = about_z(37.0)
    with pytest.raises(AssertionError):
        check(plain, history(mapped(model(), Q, 0.0, turns_current=False)), Q, 0.0)
