"""Channels of rods and bodies: those of imposed motion from a run, the others from the arrays that a block may have."""

import numpy as np
import pytest

import moorage
from moorage.model import (
    Attachment,
    Body,
    Environment,
    Line,
    LineType,
    Model,
    OutputChannel,
    Point,
    Rod,
    RodType,
    Section,
)
from moorage.model.channels import parse_channel
from moorage.model.motion import rotation_matrices
from moorage.results.rigid_channels import of_body, of_rod
from moorage.results.rod_nodes import RodNodes
from moorage.solve.carried import euler_angles

NODES = RodNodes(0, slice(0, 5), (1, 2), 0.0, 0.0)  # of rod 7 below
ANGLES = np.radians([8.0, -5.0, 12.0])


def model(*names: str) -> Model:
    """Return a coupled body that carries a rod, whose end B holds a rope from the ground."""
    return Model(
        environment=Environment(water_depth=100.0),
        line_types=(LineType(name="rope", diameter=0.1, mass_per_length=20.0, axial_stiffness=1e7),),
        rod_types=(RodType(name="tube", diameter=0.5, mass_per_length=0.0),),
        bodies=(Body(id=3, kind="coupled", position=(0.0, 0.0, -10.0), rotation=(0.1, 0.0, 0.0)),),
        rods=(
            Rod(
                id=7, rod_type="tube", kind="coupled", body=3, end_a=(0.0, 0.0, 0.0), end_b=(3.0, 4.0, 0.0), segments=4
            ),
        ),
        points=(Point(id=1, kind="fixed", position=(-200.0, 0.0, -100.0)),),
        lines=(
            Line(
                id=1,
                sections=(Section(line_type="rope", length=225.0, segments=20),),
                end_a=Attachment("point", 1),
                end_b=Attachment("rod", 7, "B"),
            ),
        ),
        outputs=tuple(OutputChannel(name=name) for name in names),
    )


def test_imposed_motion():
    names = (
        "BODY3PX",
        "BODY3RX",
        "BODY3RY",
        "BODY3RZ",
        "BODY3VX",
        "ROD7N2PX",
        "ROD7RX",
        "ROD7RY",
        "ROD7TENB",
        "ROD7TENA",
    )
    time = np.linspace(0.0, 2.0, 41)
    motion = moorage.Motion.from_platform(time, [[0.3 * t**2, 0.0, 0.0, *(ANGLES * t**2)] for t in time])
    ds = moorage.simulate(model(*names), motion=motion, duration=2.0, dt_out=0.5)
    R = rotation_matrices(ANGLES[None] * 4.0)[0]
    own = rotation_matrices(np.array([[0.1, 0.0, 0.0]]))[0]
    centre = R @ [0.0, 0.0, -10.0] + [1.2, 0.0, 0.0]
    assert ds["BODY3PX"].values[-1] == pytest.approx(centre[0], abs=1e-6)
    angles = np.degrees(euler_angles((R @ own)[None])[0])
    np.testing.assert_allclose([ds[f"BODY3R{x}"].values[-1] for x in "XYZ"], angles, atol=1e-6)
    np.testing.assert_allclose(ds["BODY3RX"].values[0], np.degrees(0.1), atol=1e-9)
    assert ds["BODY3RX"].attrs["units"] == "degree"
    h = 1e-4
    before = [
        rotation_matrices(ANGLES[None] * t**2)[0] @ [0.0, 0.0, -10.0] + [0.3 * t**2, 0.0, 0.0]
        for t in (1.0 - h, 1.0 + h)
    ]
    assert ds["BODY3VX"].values[2] == pytest.approx((before[1] - before[0])[0] / (2.0 * h), rel=1e-3)
    ends = [centre, centre + R @ own @ [3.0, 4.0, 0.0]]
    assert ds["ROD7N2PX"].values[-1] == pytest.approx(0.5 * (ends[0] + ends[1])[0], abs=1e-6)
    u = (ends[1] - ends[0]) / 5.0
    phi, heading = np.arccos(u[2]), np.arctan2(u[1], u[0])
    assert ds["ROD7RX"].values[-1] == pytest.approx(np.degrees(-phi * np.sin(heading)), abs=1e-5)
    assert ds["ROD7RY"].values[-1] == pytest.approx(np.degrees(phi * np.cos(heading)), abs=1e-5)
    # the force on the rod has the inertia of half a segment in it: 110 kg and up to 3 m/s2 of 45 kN
    np.testing.assert_allclose(ds["ROD7TENB"].values[0], ds["fairlead_tension"].values[0, 0], rtol=5e-3)
    np.testing.assert_array_equal(ds["ROD7TENA"].values, 0.0)


@pytest.mark.parametrize(
    ("name", "array", "column", "scale", "unit"),
    [
        ("ROD7VX", "rod_velocity", 0, 1.0, "m s-1"),
        ("ROD7RVY", "rod_velocity", 4, np.degrees(1.0), "degree s-1"),
        ("ROD7AZ", "rod_acceleration", 2, 1.0, "m s-2"),
        ("ROD7MX", "rod_force", 3, 1.0, "N m"),
        ("BODY3RAZ", "body_acceleration", 5, np.degrees(1.0), "degree s-2"),
        ("BODY3FY", "body_force", 1, 1.0, "N"),
        ("BODY3VZ", "body_velocity", 2, 1.0, "m s-1"),
        ("BODY3RX", "body_rotation", 0, np.degrees(1.0), "degree"),
        ("BODY3PY", "body_position", 1, 1.0, "m"),
    ],
)
def test_what_the_engine_gives(name, array, column, scale, unit):
    values = np.random.default_rng(0).standard_normal((4, 1, 6))
    channel, it = parse_channel(name), model()
    found = of_rod(channel, it, NODES) if channel.object == "rod" else of_body(channel, it, 0)
    assert found[0] == unit
    np.testing.assert_allclose(found[2]({array: values, "time": np.zeros(4)}), scale * values[:, 0, column])


def test_nodes_of_a_turning_rod_and_sizes():
    it, rng = model(), np.random.default_rng(1)
    block = {
        "rod_velocity": rng.standard_normal((3, 1, 6)),
        "holder_position": rng.standard_normal((3, 3, 3)),
        "body_force": rng.standard_normal((3, 1, 6)),
        "rod_submergence": rng.random((3, 1)),
    }
    got = of_rod(parse_channel("ROD7N1VZ"), it, NODES)[2](block)
    arm = 0.25 * (block["holder_position"][:, 2] - block["holder_position"][:, 1])
    v = block["rod_velocity"][:, 0]
    np.testing.assert_allclose(got, (v[:, :3] + np.cross(v[:, 3:], arm))[:, 2])
    size = of_body(parse_channel("BODY3TEN"), it, 0)[2](block)
    np.testing.assert_allclose(size, np.linalg.norm(block["body_force"][:, 0, :3], axis=1))
    np.testing.assert_array_equal(of_rod(parse_channel("ROD7SUB"), it, NODES)[2](block), block["rod_submergence"][:, 0])


def test_angles_come_back():
    angles = np.random.default_rng(2).uniform(-1.4, 1.4, (50, 3))
    R = rotation_matrices(angles)
    np.testing.assert_allclose(rotation_matrices(euler_angles(R)), R, atol=1e-12)
    turning = np.linspace(0.0, 7.0, 80)[:, None] * [0.0, 0.0, 1.0]
    difference = euler_angles(rotation_matrices(turning)) - turning
    np.testing.assert_allclose(np.remainder(difference + np.pi, 2.0 * np.pi), np.pi, atol=1e-12)
