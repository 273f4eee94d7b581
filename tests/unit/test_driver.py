"""MoorDyn-F's driver file: defaults, offsets and motion."""

import warnings

import numpy as np
import pytest

from moorage.errors import ModelError, ModelWarning, MotionError
from moorage.io import read, read_driver
from moorage.model.motion import rotation_matrices

DRIVER = """\
MoorDyn driver input file
another comment line
---------------------- ENVIRONMENTAL CONDITIONS ---------------
9.8                 Gravity          - Gravity (m/s^2)
1020.0              rhoW             - Water density (kg/m^3)
210.0               WtrDpth          - Water depth (m)
---------------------- MOORDYN --------------------------------
"model.dat"         MDInputFile      - Primary MoorDyn input file name (quoted string)
"driver"            OutRootName      - The name which prefixes all MoorDyn generated files
10                  TMax             - duration (s)
0.0125              dtC              - TimeInterval for the simulation (sec)
0                   InputsMode       - 0: all inputs are zero, 1: time-series inputs
"motion.dat"        InputsFile       - Filename for the MoorDyn inputs
0                   NumTurbines      - Number of wind turbines (-)
---------------------- Initial Positions ----------------------
ref_X    ref_Y    surge_init   sway_init  heave_init  roll_init  pitch_init   yaw_init
(m)      (m)        (m)          (m)        (m)       (rad)       (rad)        (rad)
0 0 0 0 0 0 0 0
END of driver input file
"""


@pytest.fixture
def driver(tmp_path, deck):
    deck(("200.0    WtrDpth   water depth (m)\n", ""), ("9.80665  g         gravity\n", ""))

    def write(*replacements):
        text = DRIVER
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new, 1)
        path = tmp_path / "md_driver.inp"
        path.write_text(text)
        return path

    return write


def test_environment_where_the_model_is_silent(driver, deck):
    case = read_driver(driver())
    environment = case.model.environment
    assert (environment.gravity, environment.water_density, environment.water_depth) == (9.8, 1020.0, 210.0)
    assert (case.motion, case.duration, case.interval) == (None, 10.0, 0.0125)
    deck()
    environment = read_driver(driver()).model.environment
    assert (environment.gravity, environment.water_density, environment.water_depth) == (9.80665, 1020.0, 200.0)


def test_read_knows_a_driver(driver):
    assert read(driver()).environment.water_depth == 210.0


def test_offset_of_coupled_points(driver):
    model = read_driver(driver(("0 0 0 0 0 0 0 0", "7 8 5 1 2 0 0 0"))).model
    assert model.points[1].position == (-35.868, 1.0, -12.0)
    assert model.points[0].position == (-837.6, 0.0, -200.0)


def test_initial_angles_are_degrees(driver):
    with pytest.warns(ModelWarning, match="read in degrees"):
        model = read_driver(driver(("0 0 0 0 0 0 0 0", "0 0 0 0 0 0 0 90"))).model
    assert model.points[1].position == pytest.approx((0.0, -40.868, -14.0))


def test_angles_turn_yaw_first(driver):
    with pytest.warns(ModelWarning):
        model = read_driver(driver(("0 0 0 0 0 0 0 0", "0 0 0 0 0 90 0 90"))).model
    # roll takes (-40.868, 0, -14) to (-40.868, 14, 0), yaw that to (-14, -40.868, 0)
    assert model.points[1].position == pytest.approx((-14.0, -40.868, 0.0))


def test_offset_of_coupled_bodies_and_rods(driver, deck):
    bodies = (
        "--- ROD TYPES ---\nTypeName Diam Mass/m Cd Ca CdEnd CaEnd\n" + "(-) " * 7 + "\ncan 1 1 0 0 0 0\n"
        "--- BODIES ---\nID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca\n" + "(-) " * 14 + "\n"
        "1 Coupled 1 0 0 10 0 0 0 0 0 0 0 0\n2 Free 1 0 0 0 0 0 1 0 0 0 0 0\n"
        "--- RODS ---\nID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs\n" + "(-) " * 11 + "\n"
        "1 can Coupled 1 0 0 2 0 0 1 -\n"
    )
    deck(("---------------------- POINTS", bodies + "---------------------- POINTS"))
    with pytest.warns(ModelWarning, match="degrees"):
        model = read_driver(driver(("0 0 0 0 0 0 0 0", "0 0 0 0 5 0 0 90"))).model
    coupled, free = model.bodies
    assert coupled.position == pytest.approx((0.0, 1.0, 5.0))
    turn = rotation_matrices(np.radians([[0.0, 0.0, 90.0]]))[0] @ rotation_matrices(np.radians([[10.0, 0.0, 0.0]]))[0]
    assert np.allclose(rotation_matrices(np.array([coupled.rotation]))[0], turn)
    assert free.position == (1.0, 0.0, 0.0)
    assert model.rods[0].end_b == pytest.approx((0.0, 2.0, 5.0))


def test_motion_is_checked_against_the_model(driver, tmp_path):
    (tmp_path / "motion.dat").write_text("# t x y z\n0 -40 0 -14\n20 -39 0 -14\n")
    mode = ("0                   InputsMode", "1                   InputsMode")
    case = read_driver(driver(mode))
    assert np.array_equal(case.motion.resolve(case.model)[2][:, 0], [-40.0, -39.0])
    (tmp_path / "motion.dat").write_text("0 1 2 3 4 5 6\n20 1 2 3 4 5 6\n")
    with pytest.raises(MotionError, match=r"6 columns after time, the coupled objects need 3"):
        read_driver(driver(mode))


def test_run_ends_with_the_motion(driver, tmp_path):
    (tmp_path / "motion.dat").write_text("0 -40 0 -14\n5 -39 0 -14\n")
    with pytest.warns(ModelWarning, match="motion ends at 5 s, TMax is 10 s"):
        assert read_driver(driver(("0                   InputsMode", "1  InputsMode"))).duration == 5.0


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("9.8                 Gravity", "abc Gravity", "Gravity is not a number"),
        ("10                  TMax", "-1 TMax", "TMax must be positive"),
        ("InputsMode ", "InputsMod3 ", "did you mean InputsMode"),
        ("0                   InputsMode", "2 InputsMode", "InputsMode must be 0 or 1"),
        ("0.0125              dtC              - TimeInterval for the simulation (sec)\n", "", "dtC is missing"),
        ("0 0 0 0 0 0 0 0\nEND", "0 0 0\nEND", "row of initial positions has 3 values"),
        ("0 0 0 0 0 0 0 0\nEND of driver input file\n", "", "0 rows of initial positions"),
        ("Initial Positions", "Elsewhere", "Initial Positions is missing"),
        (
            '"model.dat"',
            '"other.dat"',
            r"md_driver.inp:8: model file not found: tried \S*other.dat \(read: 'other.dat'\)",
        ),
        ('"model.dat"', '""', "md_driver.inp:8: MDInputFile is empty"),
        (
            "0                   InputsMode",
            "1                   InputsMode",
            r"md_driver.inp:13: motion file not found: tried \S*motion.dat \(read: 'motion.dat'\)",
        ),
    ],
)
def test_errors(driver, old, new, message):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises((ModelError, MotionError), match=message):
            read_driver(driver((old, new)))


def test_empty_motion_name(driver):
    with pytest.raises(MotionError, match="InputsFile is empty"):
        read_driver(driver(("0                   InputsMode", "1  InputsMode"), ('"motion.dat"', '""')))
