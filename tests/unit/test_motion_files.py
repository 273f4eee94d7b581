"""Motion files of both kinds, and motions resolved into tracks of points."""

import dataclasses

import numpy as np
import pytest

from moorage.errors import MotionError
from moorage.io import read, read_motion
from moorage.model import Control, Motion
from moorage.model.motion import rotation_matrices


@pytest.fixture
def file(tmp_path):
    def write(text, name="motion.csv"):
        path = tmp_path / name
        path.write_text(text)
        return path

    return write


@pytest.fixture
def model(deck):
    return read(deck())


PLATFORM = "time[s], surge[m], sway[m], heave[m], roll[deg], pitch[deg], yaw[deg]\n"


def test_moordyn_f_columns(file, model):
    path = file("# Time(s) x y z\n0.0 -40.0 0 -14 # first\n\n0.5, -39.0, 1, -13\n")
    motion = read_motion(path, model)
    assert np.array_equal(motion.time, [0.0, 0.5])
    assert np.array_equal(motion.resolve(model)[2], [[-40.0, 0.0, -14.0], [-39.0, 1.0, -13.0]])


def test_platform_columns_in_degrees_and_radians(file, model):
    degrees = read_motion(file(PLATFORM + "0,0,0,0,0,0,0\n1,1,2,3,10,20,30\n"), model)
    angles = ",".join(map(repr, np.radians([10.0, 20.0, 30.0]).tolist()))
    radians = read_motion(file(PLATFORM.replace("deg", "rad") + f"0,0,0,0,0,0,0\n1,1,2,3,{angles}\n"), model)
    assert np.allclose(degrees.platform, radians.platform, rtol=0, atol=1e-15)


def test_columns_in_any_order_and_case(file):
    motion = read_motion(
        file("Heave[m];Time [s];yaw(deg);surge[m];sway[m];roll[deg];pitch[deg]\n3;0;0;1;2;0;0\n4;1;0;1;2;0;0\n")
    )
    assert np.array_equal(motion.platform[:, :3], [[1, 2, 3], [1, 2, 4]])


def test_columns_of_points(file, model):
    motion = read_motion(file("time[s], point2.x[m], point2.y[m], point2.z[m]\n-1,1,2,3\n1,4,5,6\n"), model)
    assert np.array_equal(motion.resolve(model, 1.0)[2], [[1, 2, 3], [4, 5, 6]])


def test_motion_read_is_the_same(file, model):
    path = file("0 1 2 3\n1 1 2 3\n")
    assert np.array_equal(Motion.read(path, model).coupled, read_motion(path).coupled)


def test_platform_turns_about_the_origin(model):
    angles = np.array([[0.1, -0.2, 0.3]])
    motion = Motion.from_platform([0.0, 1.0], np.vstack([np.zeros(6), np.hstack([[1.0, 2.0, 3.0], angles[0]])]))
    start, end = motion.resolve(model)[2]
    described = np.array(model.points[1].position)
    assert np.array_equal(start, described)
    assert np.allclose(end, [1.0, 2.0, 3.0] + rotation_matrices(angles)[0] @ described)


def test_rotation_is_intrinsic_xyz():
    def about(axis, angle):
        turn = rotation_matrices(np.eye(3)[axis][None, :] * angle)[0]
        other = [k for k in range(3) if k != axis]
        assert turn[axis, axis] == 1.0
        assert np.allclose(turn[np.ix_(other, other)].trace(), 2 * np.cos(angle))
        return turn

    assert np.allclose(about(2, np.pi / 2) @ [1, 0, 0], [0, 1, 0])
    assert np.allclose(about(0, np.pi / 2) @ [0, 1, 0], [0, 0, 1])
    assert np.allclose(about(1, np.pi / 2) @ [0, 0, 1], [1, 0, 0])
    both = rotation_matrices(np.array([[0.3, -0.4, 0.5]]))[0]
    assert np.allclose(both, about(0, 0.3) @ about(1, -0.4) @ about(2, 0.5))


def test_bodies_and_rods_come_before_points(deck):
    bodies = (
        "--- BODIES ---\nID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*\n"
        "(#) (-) (m) (m) (m) (-) (-) (-) (kg) (m) (-) (m^3) (m^2) (-)\n1 Coupled 0 0 0 0 0 0 0 0 0 0 0 0\n"
    )
    model = read(deck(("---------------------- POINTS", bodies + "---------------------- POINTS")))
    motion = Motion(np.array([0.0, 1.0]), coupled=np.arange(18.0).reshape(2, 9))
    assert np.array_equal(motion.resolve(model)[2], [[6, 7, 8], [15, 16, 17]])


def test_control_channels_have_columns(model):
    controlled = dataclasses.replace(model, controls=(Control(channel=2, lines=(1,)),))
    motion = Motion(np.array([0.0, 1.0]), coupled=np.arange(10.0).reshape(2, 5))
    assert np.array_equal(motion.resolve(controlled)[2], [[0, 1, 2], [5, 6, 7]])


@pytest.mark.parametrize(
    ("motion", "duration", "message"),
    [
        (Motion.from_points([0, 1], {1: np.zeros((2, 3))}), 1, r"motion is given for point 1, which is not coupled"),
        (Motion.from_points([0, 1], {}), 1, "coupled point 2 has no motion"),
        (Motion.from_platform([0, 1], np.zeros((2, 6))), 300, "motion ends at 1 s, the run at 300 s"),
        (Motion.from_platform([0.5, 1], np.zeros((2, 6))), 1, "motion starts after time 0"),
        (Motion(np.array([0.0, 1.0]), coupled=np.zeros((2, 6))), 1, r"6 columns .* need 3\n.*point 2 \(3\)"),
    ],
)
def test_resolve_errors(model, motion, duration, message):
    with pytest.raises(MotionError, match=message):
        motion.resolve(model, duration)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is empty"),
        ("# only a remark\n", "has no rows"),
        ("\0\1\2binary", "is not a text file"),
        ("0 1 2 3\n1 1 2\n", r"motion.csv:2: row has 3 columns, the first one 4"),
        ("0 1 2 3\n1 1 2 x\n", r"motion.csv:2: value is not a number \(read: 'x'\)"),
        ("0 1 2 3\n1 1 2 nan\n", "value is not a number"),
        ("0 1 2 3\n1 1 2 3\n\n1 1 2 3\n", r"motion.csv:4: time does not increase"),
        ("0 1 2 3\n", "motion file has one row"),
        ("0\n1\n", "no columns after time"),
        (PLATFORM, "no rows after its header"),
        (PLATFORM.replace(", yaw[deg]", "") + "0,0,0,0,0,0\n1,0,0,0,0,0\n", "motion column yaw is missing"),
        (PLATFORM.replace("time[s], ", "") + "0,0,0,0,0,0\n", r"motion column time\[s\] is missing"),
        (PLATFORM.replace("sway", "swey") + "0,0,0,0,0,0,0\n", "motion column is not known .*\n.*did you mean sway"),
        (PLATFORM.replace("sway", "surge") + "0,0,0,0,0,0,0\n", "motion column surge appears twice"),
        (PLATFORM.replace("surge[m]", "surge") + "0,0,0,0,0,0,0\n", "unit of motion column surge is missing"),
        (PLATFORM.replace("surge[m]", "surge[ft]") + "0,0,0,0,0,0,0\n", "unit of motion column surge is not known"),
        ("time[s], point4.x[m], point4.z[m]\n0,1,2\n1,1,2\n", r"motion column point4.y is missing"),
        ("time[s]\n0\n1\n", "no columns after time"),
    ],
)
def test_file_errors(file, text, message):
    with pytest.raises(MotionError, match=message):
        read_motion(file(text))


def test_missing_file(tmp_path):
    with pytest.raises(MotionError, match=r"motion file not found: tried .*nowhere.csv"):
        read_motion(tmp_path / "nowhere.csv")
