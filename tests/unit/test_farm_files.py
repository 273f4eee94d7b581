"""Farms from files: drivers with turbines, FAST.Farm's own file, native files, motions of turbines; and back into files."""

import dataclasses
import json

import numpy as np
import pytest
from farms import carrying, shared, swaying
from typer.testing import CliRunner

import moorage
from moorage import Motion
from moorage.cli import app
from moorage.errors import ModelError, ModelWarning, MotionError
from moorage.io import motion_of_turbines, read, read_driver, read_farm, read_motion, write_moordyn, write_native
from moorage.model import Turbine
from moorage.model.motion import coupled_columns
from moorage.model.turbines import placed

FARM = """\
--- MoorDyn Input File ---
Two turbines
--- LINE TYPES ---
TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)
chain 0.1 150 7e8 -1 0 1.2 1.0 0.2 0
rope 0.2 60 1e8 -1 0 1.2 1.0 0.2 0
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (word) (m) (m) (m) (kg) (m^3) (m^2) (-)
1 Fixed -500 -100 -150 0 0 0 0
2 Turbine1 -20 -5 -10 0 0 0 0
3 T1 20 0 -10 0 0 0 0
4 turbine2 -20 0 -10 0 0 0 0
5 Turbine2 20 -5 -10 0 0 0 0
6 Fixed 1300 -100 -150 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name) (ID) (ID) (m) (-) (-)
1 chain 1 2 530 20 p
2 rope 3 4 780 20 p
3 chain 6 5 530 20 p
--- OPTIONS ---
150 WtrDpth
--- OUTPUTS ---
FairTen1
Point3Fx
--- need this line ---
"""
DRIVER = """\
MoorDyn driver input file
of a farm
--- ENVIRONMENTAL CONDITIONS ---
9.80665 Gravity
1025.0  rhoW
150.0   WtrDpth
--- MOORDYN ---
"farm.dat"   MDInputFile
"driver"     OutRootName
10           TMax
0.1          dtC
0            InputsMode
"motion.dat" InputsFile
2            NumTurbines
--- Initial Positions ---
ref_X ref_Y surge_init sway_init heave_init roll_init pitch_init yaw_init
(m) (m) (m) (m) (m) (rad) (rad) (rad)
0   0 0 0 0 0 0 0
800 0 0 0 0 0 0 0
END of driver input file
"""
FSTF = """\
------- FAST.Farm for OpenFAST INPUT FILE --------------
Two turbines that share a rope
--- SIMULATION CONTROL ---
False   Echo    Echo input data to <RootName>.ech? (flag)
FATAL   AbortLevel  Error level
20.0    TMax    Total run time (s) [>=0.0]
2       Mod_AmbWind   Ambient wind model (-) (switch)
1       Mod_WaveField Wave field handling (-) (switch)
3       Mod_SharedMooring  Shared mooring system model (-) (switch) {0: None, 3: MoorDyn}
--- SHARED MOORING SYSTEM --- [used only for Mod_SharedMooring > 0]
"farm.dat"  SharedMoorFile  Name of file containing shared mooring system input parameters (quoted string)
0.01    DT_Mooring  Time step for farm-level mooring coupling with each turbine (s)
--- WIND TURBINES ---
2       NumTurbines  Number of wind turbines (-) [>=1]
WT_X    WT_Y   WT_Z   WT_FASTInFile  X0_High Y0_High Z0_High dX_High dY_High dZ_High
(m)     (m)    (m)    (string)       (m) (m) (m) (m) (m) (m)
0.0     0.0    0.0    "one.fst"      0 0 0 1 1 1
800.0   0.0    0.0    "two.fst"      0 0 0 1 1 1
--- WAKE DYNAMICS ---
"""
COLUMNS = ("surge[m]", "sway[m]", "heave[m]", "roll[deg]", "pitch[deg]", "yaw[deg]")


@pytest.fixture
def files(tmp_path):
    """Write the model, driver and FAST.Farm files with parts of their texts replaced; return their folder."""

    def write(*replacements):
        for name, text in (("farm.dat", FARM), ("driver.inp", DRIVER), ("farm.fstf", FSTF)):
            for old, new in replacements:
                text = text.replace(old, new, 1)
            (tmp_path / name).write_text(text)
        return tmp_path

    return write


def csv(path, time, **turbines):
    """Write a motion file with columns of turbines, in m and deg; `platform` for columns without an owner."""
    names, columns = ["time[s]"], [np.asarray(time, float)[:, None]]
    for owner, table in turbines.items():
        names += [name if owner == "platform" else f"{owner}.{name}" for name in COLUMNS]
        columns.append(np.asarray(table, float))
    path.write_text(
        ", ".join(names) + "\n" + "\n".join(", ".join(f"{x:.12g}" for x in row) for row in np.hstack(columns))
    )
    return path


@pytest.mark.parametrize("name", ["driver.inp", "farm.fstf"])
def test_a_driver_and_fast_farm_give_the_positions(files, name):
    model = read(files() / name)
    assert [turbine.position for turbine in model.turbines] == [(0.0, 0.0, 0.0), (800.0, 0.0, 0.0)]
    assert [point.turbine for point in model.points] == [None, 1, 1, 2, 2, None]
    ours, theirs = (moorage.solve_statics(m) for m in (model, dataclasses.replace(shared(), outputs=model.outputs)))
    np.testing.assert_allclose(ours["fairlead_tension"], theirs["fairlead_tension"], rtol=1e-4)  # CdAx does not matter
    assert read_farm(files() / "farm.fstf").duration == 20.0


def test_initial_offsets_are_about_each_reference(files):
    """Row of turbine 2: 3 m in surge, then 90 degrees of yaw, which takes (-20, 0) to (0, -20)."""
    with pytest.warns(ModelWarning, match=r"driver.inp:18: initial angles are read in degrees"):
        model = read_driver(files(("800 0 0 0 0 0 0 0", "800 0 3 0 0 0 0 90")) / "driver.inp").model
    assert model.points[1].position == (-20.0, -5.0, -10.0)
    assert model.points[3].position == pytest.approx((3.0, -20.0, -10.0), abs=1e-12)
    assert placed(model).points[3].position == pytest.approx((803.0, -20.0, -10.0), abs=1e-12)
    assert placed(placed(model)) == placed(model)


def test_coupled_in_a_farm_is_on_turbine_1(files):
    with pytest.warns(ModelWarning, match="no turbine is said for coupled point 3; taken as Turbine1"):
        model = read(files(("3 T1", "3 Coupled")) / "driver.inp")
    assert model.points[2].turbine == 1


def test_columns_go_turbine_by_turbine(files):
    """MoorDyn-F's columns are absolute positions of all coupled objects; here those of turbine 2 come last."""
    swapped = ("2 Turbine1", "2 Turbine2"), ("5 Turbine2", "5 Turbine1"), ("0            InputsMode", "1 InputsMode")
    folder = files(*swapped)
    assert [id for _, id, _ in coupled_columns(read(folder / "farm.dat"))] == [3, 5, 2, 4]
    row = " ".join(f"{100 * id + axis}" for id in (3, 5, 2, 4) for axis in range(3))
    (folder / "motion.dat").write_text(f"0 {row}\n20 {row}\n")
    case = read_driver(folder / "driver.inp")
    assert {id: track[0, 0] for id, track in case.motion.resolve(case.model).items()} == {
        2: 200,
        3: 300,
        4: 400,
        5: 500,
    }


def test_motion_columns_of_turbines(tmp_path):
    first, second = np.zeros((2, 6)), np.array([[0.0] * 6, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]])
    motion = read_motion(csv(tmp_path / "m.csv", [0, 1], turbine1=first, turbine2=second))
    assert motion.platform is None
    np.testing.assert_allclose(motion.turbines[2], second * [1, 1, 1, *[np.pi / 180] * 3])
    np.testing.assert_array_equal(motion.turbines[1], first)


def test_motions_are_put_together():
    """At the same times as they are; else at all times, by splines, to the end of the shortest."""
    one = swaying(10.0)
    both = Motion.from_turbines({1: one, 2: one})
    np.testing.assert_array_equal(both.turbines[2], one.platform)
    time = np.linspace(0.0, 12.0, 601)
    other = Motion.from_platform(time, np.sin(0.5 * time)[:, None] * np.ones(6))
    mixed = Motion.from_turbines({1: one, 2: other})
    assert mixed.duration == 10.0
    at = np.searchsorted(mixed.time, one.time)
    np.testing.assert_allclose(mixed.turbines[1][at], one.platform, atol=1e-12)
    np.testing.assert_allclose(mixed.turbines[2][:, 0], np.sin(0.5 * mixed.time), atol=1e-8)


@pytest.fixture
def native(tmp_path):
    """Write the shared farm as a native file in which turbines are called by name and have motion files."""
    west = csv(tmp_path / "west.csv", [0.0, 10.0, 20.0], platform=np.zeros((3, 6)))
    csv(tmp_path / "east.csv", [0.0, 5.0, 10.0], platform=[[0.0] * 6, [1.0] + [0.0] * 5, [2.0] + [0.0] * 5])
    model = shared()
    turbines = (
        dataclasses.replace(model.turbines[0], name="west", motion=west.name),
        dataclasses.replace(model.turbines[1], motion="east.csv"),
    )
    path = tmp_path / "farm.yaml"
    assert write_native(dataclasses.replace(model, turbines=turbines), path) == []
    path.write_text(path.read_text().replace("turbine: 2", "turbine: east"))
    return path


def test_native_files_know_turbines_by_number_and_name(native):
    model = read(native)
    assert model.points == shared().points
    assert [(t.id, t.name, t.position) for t in model.turbines] == [(1, "west", (0, 0, 0)), (2, "east", (800, 0, 0))]
    motion = motion_of_turbines(model)
    assert motion.duration == 10.0
    assert motion.turbines[2][-1, 0] == 2.0
    assert motion_of_turbines(shared()) is None


def test_a_farm_becomes_a_file_of_moordyn_f_and_comes_back(tmp_path):
    notes = write_moordyn(carrying((5.0, 6.0, 0.0)), tmp_path / "f.dat", "F")
    assert any("turbines have no place in the file" in note and "1 at 5, 6, 0" in note for note in notes)
    back = read(tmp_path / "f.dat")
    assert [p.turbine for p in back.points] == [None, None, None, 1, None]
    assert (back.rods[0].turbine, back.bodies[0].turbine) == (1, 1)
    assert back.points[3].position == carrying().points[3].position


def test_moordyn_c_gets_coupled_things_in_global_coordinates(tmp_path):
    notes = write_moordyn(shared(), tmp_path / "c.dat", "C")
    assert "MoorDyn-C knows no turbines: coupled, in global coordinates: point 2, point 3, point 4, point 5" in notes
    back = read(tmp_path / "c.dat")
    assert back.points[3].position == (780.0, 0.0, -10.0)
    assert (back.points[3].kind, back.points[3].turbine) == ("coupled", None)
    alone = dataclasses.replace(shared(), turbines=())
    notes = write_moordyn(alone, tmp_path / "u.dat", "C")
    assert any("positions are not known" in note for note in notes)
    assert read(tmp_path / "u.dat").points[3].turbine == 2


CLI = CliRunner()


def output_of(*words):
    outcome = CLI.invoke(app, [str(word) for word in words])
    assert outcome.exit_code == 0, outcome.output
    return outcome.output


def test_the_command_line_with_a_farm(native, tmp_path, monkeypatch):
    """Check, static, stiffness, run, info, report, view and plot survive several platforms, and name them."""
    monkeypatch.chdir(tmp_path)
    assert "1 west at (0, 0, 0); 2 east at (800, 0, 0)" in output_of("check", native)
    assert "Load of the mooring on each turbine" in output_of("static", native)
    text = output_of("static", native, "--json")
    assert [t["id"] for t in json.loads(text[text.index("{") :])["turbines"]] == [1, 2]
    text = output_of("stiffness", native)
    assert "Stiffness of turbine 2 (east) about (800, 0, 0)" in text
    assert "Load on turbine 1 (west) by motion of turbine 2 (east)" in text
    text = output_of("run", native, "-o", "farm.nc", "--moordyn-out")
    assert "10 s, results" in text
    assert "turbine 2" in text
    ds = moorage.open_result("farm.nc")
    assert ds["turbine_position"].dims == ("time", "turbine", "xyz")
    np.testing.assert_allclose(ds["turbine_position"].sel(turbine=2).values[-1], [802.0, 0.0, 0.0], atol=1e-6)
    assert ds["point_turbine"].values.tolist() == [0, 1, 1, 2, 2, 0]
    assert ds["turbine_name"].values.tolist() == ["west", "east"]
    assert "turbine 2" in output_of("info", "farm.nc")
    output_of("report", "farm.nc")
    assert "<th>turbines</th><td>2</td>" in (tmp_path / "farm-report.html").read_text()
    for what in ("profile", "map", "history"):
        output_of("plot", "farm.nc", "--what", what)
    output_of("view", "farm.nc", "--no-open")
    assert '"platforms":[[1,2],[3,4]]' in (tmp_path / "farm.html").read_text().replace(" ", "").replace("[2,1]", "[1,2]").replace("[4,3]", "[3,4]")  # fmt: skip


def test_fast_farm_on_the_command_line(files, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = files(("20.0    TMax", "2.0 TMax"))
    output_of("run", folder / "farm.fstf", "-o", "farm.nc")
    ds = moorage.open_result("farm.nc")
    assert float(ds["time"][-1]) == 2.0
    assert ds.attrs["turbines"] == "1 at (0, 0, 0); 2 at (800, 0, 0)"


@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        ("driver.inp", "2            NumTurbines", "1 NumTurbines", r"farm.dat:14: point 4 is on turbine 2, whose reference position is not known\D+2\D+the turbines are 1"),
        ("driver.inp", "2            NumTurbines", "3 NumTurbines", "row of initial positions has 5 values"),
        ("driver.inp", "2            NumTurbines", "-1 NumTurbines", "driver.inp:14: NumTurbines must not be negative"),
        ("farm.fstf", "3       Mod_SharedMooring", "0 Mod_SharedMooring", "farm.fstf:9: there is no shared mooring"),
        ("farm.fstf", '"farm.dat"', '"other.dat"', r"farm.fstf:11: model file not found: tried \S*other.dat"),
        ("farm.fstf", "--- SHARED MOORING SYSTEM", "--- SOMETHING", "SHARED MOORING SYSTEM is missing"),
        ("farm.fstf", "2       NumTurbines", "2 NumTurbnes", r"NumTurbines is missing\s+.*numturbnes"),
        ("farm.fstf", "2       NumTurbines", "0 NumTurbines", "0 rows of turbines for NumTurbines 0"),
        ("farm.fstf", '800.0   0.0    0.0    "two.fst"      0 0 0 1 1 1', "800.0", "row of turbine 2 is too short"),
        ("farm.fstf", '800.0   0.0 ', 'x 0.0 ', "position of turbine 2 is not a number"),
    ],
)  # fmt: skip
def test_wrong_farm_files(files, name, old, new, message):
    folder = files()
    path = folder / name
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    with pytest.raises(ModelError, match=message):
        read(path)


def test_a_model_by_itself_can_be_read_and_not_run(files):
    """MoorDyn's file does not say where the turbines are: `check` says what is missing, statics refuse."""
    path = files() / "farm.dat"
    model = read(path)
    with pytest.raises(ModelError, match=r"farm.dat:12: point 2 is on turbine 1, whose .* not known.*\n.*NumTurbines"):
        moorage.solve_statics(model)
    outcome = CLI.invoke(app, ["check", str(path)])
    assert outcome.exit_code == 2
    assert "what it lacks" in outcome.output
    known = dataclasses.replace(
        model, turbines=tuple(Turbine(id=k, position=(800.0 * (k - 1), 0.0, 0.0)) for k in (1, 2))
    )
    assert moorage.solve_statics(known)["turbine_force"].shape == (2, 3)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("turbine: east", "turbine: south", "turbine is not known.*south"),
        ("turbine: east", "turbine: 7", "point 4 is on turbine 7, whose reference position is not known"),
        ("kind: coupled", "kind: free", "point 2 is on turbine 1, and free"),
        ("motion: east.csv", "motio: east.csv", "key of turbine 2 .* not known"),
        ("- id: 2\n    name: east", "- id: 1\n    name: east", "turbine 1 is described twice"),
    ],
)
def test_wrong_native_farms(native, old, new, message):
    text = native.read_text()
    assert old in text, text
    native.write_text(text.replace(old, new, 1))
    with pytest.raises(ModelError, match=message):
        read(native)


def test_wrong_motions_of_turbines(native, tmp_path):
    model = read(native)
    two = {k: swaying(5.0) for k in (1, 2)}
    cases = {
        "motion is given for turbine 3, which is not there": lambda: Motion.from_turbines(two | {3: two[1]}),
        r"turbine 2, with point 4 on it, has no motion\s+.*turbine2.surge": lambda: Motion.from_turbines({1: two[1]}),
        "those of a platform move what is on no turbine": lambda: two[1],
    }
    for message, motion in cases.items():
        with pytest.raises(MotionError, match=message):
            moorage.simulate(model, motion=motion(), duration=1.0)
    with pytest.raises(MotionError, match=r"motion is given for turbine 1, which is not there.*\n.*no turbines"):
        Motion.from_turbines(two).resolve(dataclasses.replace(model, turbines=(), points=model.points[:1], lines=()))
    with pytest.raises(MotionError, match="motion of turbine 1 has 5 columns, not 6"):
        Motion([0.0, 1.0], turbines={1: np.zeros((2, 5))})
    with pytest.raises(MotionError, match="motion of turbine 2 is not that of a platform"):
        Motion.from_turbines({1: two[1], 2: Motion.from_points([0.0, 1.0], {4: np.zeros((2, 3))})})
    with pytest.raises(MotionError, match="there are no motions"):
        Motion.from_turbines({})
    one = dataclasses.replace(model, turbines=(model.turbines[0], dataclasses.replace(model.turbines[1], motion="")))
    with pytest.raises(MotionError, match="turbine 2 has no motion, others have"):
        motion_of_turbines(one)
    (tmp_path / "east.csv").write_text("time[s], point4.x[m], point4.y[m], point4.z[m]\n0,0,0,0\n1,0,0,0\n")
    with pytest.raises(MotionError, match="motion of turbine 2 has no columns of a platform"):
        motion_of_turbines(model)
    (tmp_path / "m.csv").write_text("time[s], turbine1.surge[m]\n0,0\n1,0\n")
    with pytest.raises(MotionError, match=r"turbine1.sway, turbine1.heave, .* is missing"):
        read_motion(tmp_path / "m.csv")


def test_doubtful_and_impossible_turbines():
    model = shared(second=(0.0, 0.0, 0.0))
    (doubt,) = [p for p in moorage.suspicious(model) if "same reference position" in str(p)]
    assert "turbines 1 and 2" in str(doubt)
    both = dataclasses.replace(carrying(), points=(*carrying().points[:3], dataclasses.replace(carrying().points[3], body=1), carrying().points[4]))  # fmt: skip
    with pytest.raises(ModelError, match="point 4 is on turbine 1 and on body 1"):
        moorage.solve_statics(both)
    nowhere = dataclasses.replace(shared(), turbines=(Turbine(id=1, position=(np.nan, 0.0, 0.0)), shared().turbines[1]))
    with pytest.raises(ModelError, match="position of turbine 1 is not finite"):
        moorage.solve_statics(nowhere)
