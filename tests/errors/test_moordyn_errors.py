"""Every error of a MoorDyn model file: its place, what was read, and what to write instead."""

import warnings

import pytest

from moorage.errors import ModelError, ModelWarning
from moorage.io import read

END = "---------------------- OPTIONS"
POINTS = "---------------------- POINTS -"
TYPE_ROW = "chain      0.0766   113.35   7.536e8    -0.8       0         2.0   0.8   0.4    0.25"
POINT_1 = "1     Fixed        -837.6    0.0   -200.0   0      0        0      0"
POINT_2 = "2     Coupled      -40.868   0.0   -14.0    0      0        0      0"
LINE = "1     chain      1         2         835.35     20        p"
UNITS = "(#)   (name)     (ID)      (ID)      (m)        (-)       (-)\n"
RODS = (
    "--- ROD TYPES ---\nTypeName Diam Mass/m Cd Ca CdEnd CaEnd\n(-) (-) (-) (-) (-) (-) (-)\ncan {diameter} 1 0 0 0 0\n"
)
RODS += "--- RODS ---\nID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs\n(-) (-) (-) (-) (-) (-) (-) (-) (-) (-) (-)\n"
BODIES = "--- BODIES ---\nID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca\n" + "(-) " * 14 + "\n"


def rods(row, diameter="1"):
    return (POINTS, RODS.format(diameter=diameter) + row + "\n" + POINTS)


def bodies(row):
    return (POINTS, BODIES + row + "\n" + POINTS)


def section(title, header, row):
    return (END, f"--- {title} ---\n{header}\n{'(-) ' * len(header.split())}\n{row}\n{END}")


def syrope(row):
    return section("SYROPE IC", "Line(s) Tmax0 Tmean0", row)


def failure(row):
    return section("FAILURE", "FailureID Point Line(s) FailTime FailTen", row)


def control(row):
    return section("CONTROL", "ChannelID Line(s)", row)


def load(row):
    return section("EXTERNAL LOADS", "ID Object Fext Blin Bquad CSys", row)


def option(row):
    return ("9.80665  g         gravity", row)


CASES = {
    # the file
    "missing section": (("---- LINES -", "---- CABLES -"), r"model.dat: section LINES is missing"),
    "missing line types": (("---- LINE TYPES -", "---- x -"), r"section LINE TYPES is missing"),
    "missing points": (("---- POINTS -", "---- Spots -"), r"section POINTS is missing"),
    "unknown section": (
        (END, f"--- FALURE ---\n1 2 3\n{END}"),
        r"model.dat:16: unknown section .*FALURE.*\n.*did you mean FAILURE",
    ),
    "section twice": ((END, f"--- LINES ---\n{END}"), r"model.dat:16: section LINES appears twice"),
    "section without rows": ((END, f"--- FAILURE ---\nFailureID Point\n{END}"), "section has no rows"),
    "column missing": (("UnstrLen   NumSegs", "UnstrLen"), r"model.dat:13: column NumSegs of LINES is missing"),
    "column missing in order": (("CdAx   CaAx", "CdAx"), r"column CaAx of LINE TYPES is missing"),
    "units missing": ((UNITS, ""), r"model.dat:14: the row of units is missing"),
    "too few values": ((LINE, "1 chain 1 2 835.35 20"), r"model.dat:15: row of LINES has 6 values for 7 columns"),
    "too many values": ((TYPE_ROW, TYPE_ROW + " 0.8"), r"model.dat:6: row of LINE TYPES has 11 values for 10 columns"),
    "rods without types": ((POINTS, "--- RODS ---\nID\n(-)\n1\n" + POINTS), "section ROD TYPES is missing"),
    # numbers
    "not a number": (("113.35", "heavy"), r"model.dat:6: Mass/m of line type chain is not a number \(read: 'heavy'\)"),
    "nan": (("113.35", "nan"), "Mass/m of line type chain is not a number"),
    "infinite": (("113.35", "1e999"), "Mass/m of line type chain is not a number"),
    "underscore": (("113.35", "1_000"), "Mass/m of line type chain is not a number"),
    "nan instead of a table": (("7.536e8 ", "nan "), "EA of line type chain is not a number"),
    "not a whole number": (("835.35     20 ", "835.35     2.5 "), r"NumSegs of line 1 is not a whole number"),
    # line types
    "negative mass": (("113.35", "-1"), r"mass per length of line type chain must not be negative \(read: -1"),
    "zero diameter": (("0.0766", "0"), "diameter of line type chain must be positive"),
    "zero stiffness": (("7.536e8", "0"), "axial stiffness of line type chain must be positive"),
    "negative bending": (
        ("-0.8       0 ", "-0.8      -1 "),
        "bending stiffness of line type chain must not be negative",
    ),
    "negative drag": (("0         2.0", "0        -2.0"), "transverse drag of line type chain must not be negative"),
    "four stiffnesses": (("7.536e8", "1|2|3|4"), r"EA of line type chain has 4 values"),
    "too much damping": (("-0.8 ", "1|2 "), "BA of line type chain has more values than its EA allows"),
    "three bendings": (("-0.8       0 ", "-0.8   1|2|3 "), "EI of line type chain has 3 values"),
    "type twice": (
        (TYPE_ROW, TYPE_ROW + "\n" + TYPE_ROW.replace("chain", "Chain")),
        r"model.dat:7: line type chain is described twice \(first: .*:6\)",
    ),
    "table missing": (
        ("7.536e8", "rope.txt"),
        r"model.dat:6: table of EA of line type chain not found: tried .*rope.txt",
    ),
    "Syrope file missing": (("7.536e8 ", "SYROPE:s.dat|1|2 "), "Syrope file of line type chain not found"),
    "Syrope incomplete": (("7.536e8 ", "SYROPE:s.dat "), "EA of line type chain is incomplete"),
    # points
    "unknown word": (
        (POINT_2, POINT_2.replace("Coupled", "Cuopled")),
        r"model.dat:11: attachment of a point is not known .*Cuopled.*\n.*did you mean Coupled",
    ),
    "body missing": (
        (POINT_2, POINT_2.replace("Coupled", "Body7  ")),
        r"point 2 is carried by body 7, which is not described\n.*there are no bodies",
    ),
    "point twice": ((POINT_2, POINT_2.replace("2 ", "1 ", 1)), "point 1 is described twice"),
    "number zero": ((POINT_2, POINT_2.replace("2 ", "0 ", 1)), "number of a point must be positive"),
    "negative volume": (
        (POINT_2, POINT_2.replace("-14.0    0      0", "-14.0    0     -1")),
        "volume of point 2 must not be negative",
    ),
    "buried anchor": (
        ("0.0   -200.0", "0.0   -201.5"),
        r"model.dat:10: fixed point 1 is 1.5 m below the seabed, where the water is 200 m deep.*\n.*write z = -200, or .*raise_to_seabed",
    ),
    "idle free point": ((POINT_2, POINT_2 + "\n3 Free 0 0 -10 0 0 0 0"), "free point 3 has neither lines nor mass"),
    # lines
    "unknown type": (
        (LINE, LINE.replace("chain", "rope ")),
        r"line type of line 1 is not described \(read: 'rope'\)\n.*use one of: chain",
    ),
    "zero length": (("835.35", "0"), "length of line 1 must be positive"),
    "negative length": (("835.35", "-5"), "length of line 1 must be positive"),
    "no segments": (("835.35     20", "835.35     0"), "number of segments of line 1 must be at least 1"),
    "dangling end": (
        (LINE, LINE.replace(" 2 ", " 9 ", 1)),
        r"end B of line 1 is tied to point 9, which is not described\n.*the points are 1, 2",
    ),
    "dangling rod": ((LINE, LINE.replace(" 2 ", "R9A", 1)), "end B of line 1 is tied to end A of rod 9"),
    "unknown end": ((LINE, LINE.replace(" 2 ", " X2 ", 1)), r"end B of line 1 is not known .*X2"),
    "rod without end": ((LINE, LINE.replace(" 2 ", " R1 ", 1)), "R1A or R1B"),
    "same ends": ((LINE, LINE.replace(" 2 ", " 1 ", 1)), "both ends of line 1 are tied to point 1"),
    "line twice": ((LINE, LINE + "\n" + LINE), "line 1 is described twice"),
    # rods and bodies
    "unknown rod word": (rods("1 can Welded 0 0 -1 0 0 -2 1 -"), "attachment of a rod is not known"),
    "unknown rod type": (
        rods("1 pipe Fixed 0 0 -1 0 0 -2 1 -"),
        r"type of rod 1 is not described .*\n.*use one of: can",
    ),
    "rod's body missing": (rods("1 can Body2 0 0 -1 0 0 -2 1 -"), "rod 1 is carried by body 2"),
    "rod without length": (rods("1 can Fixed 0 0 -1 0 0 -1 1 -"), "ends of rod 1 coincide, but it has 1 segments"),
    "negative segments": (rods("1 can Fixed 0 0 -1 0 0 -2 -1 -"), "number of segments of rod 1 must not be negative"),
    "thin rod": (rods("1 can Fixed 0 0 -1 0 0 -2 1 -", "0"), "diameter of rod type can must be positive"),
    "unknown body word": (bodies("1 flying 0 0 0 0 0 0 1 0 0 0 0 0"), "attachment of a body is not known"),
    "negative body mass": (bodies("1 free 0 0 0 0 0 0 -1 0 0 0 0 0"), "mass of body 1 must not be negative"),
    "negative inertia": (bodies("1 free 0 0 0 0 0 0 1 0 -1 0 0 0"), "inertia of body 1 must not be negative"),
    "two centres": (bodies("1 free 0 0 0 0 0 0 1 1|2 0 0 0 0"), "CG of body 1 has 2 values"),
    "four drags": (bodies("1 free 0 0 0 0 0 0 1 0 0 0 1|2|3|4 0"), "CdA of body 1 has 4 values"),
    # events
    "failure of no line": (failure("1 1 7 0 1e5"), "failure 1 names line 7, which is not described"),
    "failure elsewhere": (
        failure("1 R1A 1 0 1e5"),
        r"failure 1: line 1 is not tied to end A of rod 1\n.*it is tied to point 1 and point 2",
    ),
    "failure at nothing": (failure("1 here 1 0 1e5"), "place of failure 1 is not known"),
    "control of no line": (control("1 1,7"), "control channel 1 names line 7"),
    "control of words": (control("1 a,b"), "line of a control channel is not a whole number"),
    "load on nothing": (load("1 Rod3 0 0 0 -"), "external load 1 is on rod 3, which is not described"),
    "load on a thing": (load("1 Buoy1 0 0 0 -"), "object of load 1 is not known"),
    "load in no system": (load("1 Body1 0 0 0 X"), "CSys of load 1 is not known"),
    "load of two": (load("1 Point1 1|2 0 0 -"), "Fext of load 1 is neither 0 nor three values"),
    "damping of two": (load("1 Point1 0 1|2 0 -"), "Blin of load 1 has 2 values"),
    "negative damping": (load("1 Point1 0 -1 0 -"), "linear damping of external load 1 must not be negative"),
    "Syrope of no line": (syrope("7 1 1"), "SYROPE IC names line 7"),
    "Syrope of no rope": (syrope("1 1 1"), r"model.dat:19: SYROPE IC names line 1, and no line type is a Syrope one"),
    "Syrope twice": (syrope("1 2 1\n1 3 1"), r"model.dat:20: SYROPE IC names line 1 twice\n.*first: .*:19"),
    # options
    "unknown option": (option("3e6 kBto"), r"model.dat:18: option 'kBto' is not known .*\n.*did you mean kBot"),
    "strange option": (option("3e6 zzzzzz"), r"option 'zzzzzz' is not known .*\n.*or use one of g, rho"),
    "name first": (option("kBot 3e6"), r"name stands before its value .*\n.*write the value first: 3e6 kBot"),
    "lonely value": (option("3e6"), "an option needs a value and a name"),
    "option without number": (option("soft kBot"), "option kBot is not a number"),
    "option without whole number": (option("1.5 writeLog"), "option writeLog is not a whole number"),
    "no switch": (option("7 disableOutput"), "option disableOutput is a switch"),
    "unknown mode": (option("9 WaveKin"), "option WaveKin has no mode 9"),
    "no water": (
        ("200.0    WtrDpth", "-200.0    WtrDpth"),
        r"^\S*model.dat:17: water depth of the environment must be positive",
    ),
    "infinite water": (("200.0    WtrDpth", "inf    WtrDpth"), "water depth is not a number"),
    "negative density": (option("-1 rho"), r"model.dat:18: water density of the environment must not be negative"),
    "negative gravity": (option("-9.81 g"), r"model.dat:18: gravity of the environment must not be negative"),
    "soft seabed": (option("-1 kBot"), r"model.dat:18: seabed stiffness of the environment must not be negative"),
    "negative friction": (option("-1 mu_kT"), "transverse of seabed friction must not be negative"),
    "static below kinetic": (option("0.5 mc"), "static friction is below kinetic friction"),
    "negative interval": (option("-1 dtOut"), r"model.dat:18: output interval must be positive"),
    "depth file missing": (("200.0    WtrDpth", "depths.txt  WtrDpth"), "depth file not found: tried .*depths.txt"),
    "current file missing": (option("1 Currents"), "table of current profile not found: tried .*current_profile.txt"),
    "water file missing": (option("water.dat WaterKin"), "water kinematics file not found"),
    # outputs
    "unknown channel": (("FairTen1", "FairTension1"), r"model.dat:21: output channel is not known"),
    "unknown quantity": (("FairTen1", "Line1N5Qx"), r"output channel is not known .*\n.*write LINE1N5 and one of PX"),
    "channel of no line": (("FairTen1", "FairTen7"), "output channel FAIRTEN7 is of line 7, which is not described"),
    "channel of no node": (("FairTen1", "L1N21PX"), r"output channel L1N21PX is of node 21\n.*are 0 to 20"),
}


@pytest.mark.parametrize("name", CASES)
def test_error(deck, name):
    replacement, message = CASES[name]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(ModelError, match=message) as caught:
            read(deck(replacement))
    assert all(problem.source for problem in caught.value.problems)


def test_all_problems_come_together(deck):
    path = deck(
        ("113.35", "heavy"),
        ("835.35", "-1"),
        ("200.0    WtrDpth", "200 WtrDpht"),
        (POINT_1, POINT_1.replace("Fixed", "Fixd")),
    )
    with pytest.warns(ModelWarning, match="no water depth"), pytest.raises(ModelError) as caught:
        read(path)
    assert [problem.source.line for problem in caught.value.problems] == [6, 10, 15, 17]


@pytest.mark.parametrize("depth", ["-200", "0"])
def test_a_wrong_depth_blames_no_points(deck, depth):
    with pytest.raises(ModelError) as caught:
        read(deck(("200.0    WtrDpth", f"{depth}    WtrDpth")))
    assert [problem.source.line for problem in caught.value.problems] == [17]


@pytest.mark.parametrize(
    "change", [(POINT_2, POINT_2.replace("2 ", "1 ", 1)), (LINE, f"{LINE}\n{LINE}".replace("20  ", "5   "))]
)
def test_an_id_given_twice_is_one_problem(deck, change):
    """Not also the ends and the channels that it leaves without an object."""
    with pytest.raises(ModelError, match="is described twice") as caught:
        read(deck(change))
    assert len(caught.value.problems) == 1


TABLES = {
    "rope.txt": (
        ("7.536e8", "rope.txt"),
        [
            ("", "is empty"),
            ("strain tension\n0 0\n", "has 1 rows of numbers"),
            ("strain tension\n0 0\n0.1 x\n", r"rope.txt:3: row of the table .* is not 2 numbers"),
            ("strain tension\n0 0\n0.1 1\n0.1 2\n", "does not increase at row 3"),
            ("strain tension\n0 0\n0.1 3\n0.2 2\n", "has falling tension"),
            ("\0\0\0", "is not a text file"),
        ],
    ),
    "depths.txt": (
        ("200.0    WtrDpth", "depths.txt WtrDpth"),
        [
            ("--- grid ---\nnGridX 2\n0 1\n0 200 200\n", "lacks nGridX or nGridY"),
            ("--- grid ---\nnGridX 2\nnGridY 2\n", "has no grid"),
            ("--- grid ---\nnGridX 2\nnGridY 2\n0 1\n0 200 200\n", "has 1 rows of depths"),
            ("--- grid ---\nnGridX 2\nnGridY 1\n0 1\n0 200\n", r"depths.txt:5: row of the depth file is not 3 numbers"),
            ("--- grid ---\nnGridX two\nnGridY 1\n0 1\n0 200 200\n", "ngridx is not a whole number"),
            ("--- grid ---\nnGridX 2\nnGridY 1\n1 0\n0 200 200\n", "x of the depth grid does not increase"),
            ("--- grid ---\nnGridX 2\nnGridY 1\n0 1\n0 200 -1\n", "seabed reaches the water's surface"),
            ("--- grid ---\nnGridX 2\nnGridY 1\n0 1\n0 200 nan\n", "not 3 numbers"),
        ],
    ),
    "seafloor.txt": (
        ("200.0    WtrDpth   water depth (m)", "seafloor.txt SeafloorFile"),
        [
            ("2 1\n0 1\n0\n", "depth file has 3 rows"),
            ("2 1 1\n0 1\n0\n0 0 -200\n", "does not start with two counts"),
            ("2 1\n0 1\n0\n0 0 -200\n0.5 0 -200\n", "seafloor.txt:5: point of the depth file is not on its grid"),
            ("2 1\n0 1\n0\n0 0 -200\n0 0 -200\n1 0 -200\n", "point of the depth file is given twice"),
            ("2 1\n0 1\n0\n0 0 -200\n", "leaves 1 points of its grid without depth"),
            ("2 1\n0 1\n0\n0 0 200\n1 0 200\n", "seabed reaches the water's surface"),
        ],
    ),
    "current_profile.txt": (
        option("1 Currents"),
        [
            ("a\nb\nc\n", "has 0 rows of numbers"),
            ("a\nb\nc\n-10 1\n-10 2\n0 1\n", "levels of the current do not increase"),
            ("a\nb\nc\n-10 1\n-5 fast\n", r"current_profile.txt:5: row of the table"),
        ],
    ),
    "water.dat": (
        option("water.dat WaterKin"),
        [
            ("notes\n", "WaveKinMod is missing"),
            ("--- WAVES ---\nx WaveKinMod\n--- CURRENT ---\n0 CurrentMod\n", "WaveKinMod is not a whole number"),
            ("--- WAVES ---\n0 WaveKinMod\n--- CURRENT ---\n1 CurrentMod\n", "current profile has no rows"),
            ("--- WAVES ---\n0 WaveKinMod\n--- CURRENT ---\n1 CurrentMod\n0 1 0\n150 0.5 0\n", "above the water"),
        ],
    ),
}


@pytest.mark.parametrize(("name", "case"), [(name, case) for name, (_, cases) in TABLES.items() for case in cases])
def test_table_error(deck, tmp_path, name, case):
    text, message = case
    (tmp_path / name).write_text(text)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(ModelError, match=message):
            read(deck(TABLES[name][0]))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "is empty"),
        (b" \n\n", "is empty"),
        (bytes(range(256)) * 20, "is not a text file"),
        (b"\x7fELF\x02\x01\x01\x00\x00", "is not a text file"),
        (b"just some words\nand more\n", "section LINE TYPES is missing"),
    ],
)
def test_files_that_are_no_models(tmp_path, content, message):
    path = tmp_path / "model.dat"
    path.write_bytes(content)
    with pytest.raises(ModelError, match=message):
        read(path)


def test_missing_file_and_folder(tmp_path):
    with pytest.raises(ModelError, match=r"model file not found: tried .*none.dat\n.*correct the name"):
        read(tmp_path / "none.dat")
    with pytest.raises(ModelError, match="it is a folder"):
        read(tmp_path)


ROPE_ROW = "rope  0.1  5  SYROPE:s.dat|1.5e8|23  5e10|1e5  0  2.0  0.8  0.4  0.25"
ROPES = (
    (TYPE_ROW, f"{TYPE_ROW}\n{ROPE_ROW}"),
    (POINT_2, f"{POINT_2}\n3  Fixed  0  0  -200  0  0  0  0"),
    (LINE, f"{LINE}\n2  rope  3  2  300  5  -"),
)


def test_tensions_of_another_line_than_a_rope_are_a_warning(deck, tmp_path):
    """MoorDyn-C warns too, when another line type is a Syrope one."""
    (tmp_path / "s.dat").write_text("owc.dat OWC\n")
    with pytest.warns(ModelWarning, match=r"model.dat:22: SYROPE IC names line 1, whose line type is not a Syrope one"):
        model = read(deck(*ROPES, syrope("1,2 2e5 1e5")))
    assert [line.syrope_tensions for line in model.lines] == [None, (2e5, 1e5)]


@pytest.mark.parametrize("tensions", ["1e5 2e5", "2e5 -1"])
def test_tensions_of_a_rope_that_cannot_be(deck, tmp_path, tensions):
    (tmp_path / "s.dat").write_text("owc.dat OWC\n")
    with pytest.raises(ModelError, match="Syrope tensions of line 2 are not possible"):
        read(deck(*ROPES, syrope(f"2 {tensions}")))
