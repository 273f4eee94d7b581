"""Errors and warnings of cables, rods and stiffeners, with file and line, in both formats where both can say them."""

import warnings
from pathlib import Path

import pytest
from moorings import clamp, fixed, held, kind, line, mooring

import moorage
import moorage.model.checks
from moorage.errors import ModelError, ModelWarning
from moorage.io import read

EXAMPLE = Path(__file__).parents[2] / "examples" / "lazy_wave" / "lazy_wave.yaml"
STIFFENER = "{end: B, length: 4, root_diameter: 0.6, tip_diameter: 0.2, youngs_modulus: 60.0e6, density: 1150}"
MODULES = "{diameter: 0.75, length: 0.6, mass: 75, pitch: 4}"
EI = "bending_stiffness: 10.0e3"


@pytest.fixture
def native(tmp_path):
    """Write the example with parts of its text replaced; return its path and the number of the first line changed."""

    def write(*replacements):
        text, changed = EXAMPLE.read_text("utf-8"), []
        for old, new in replacements:
            assert old in text, old
            changed.append(text[: text.index(old)].count("\n") + 1)
            text = text.replace(old, new, 1)
        path = tmp_path / "cable.yaml"
        path.write_text(text, "utf-8")
        return path, changed[0]

    return write


def stiffener(**changes):
    text = STIFFENER
    for key, value in changes.items():
        start = text.index(f"{key}: ")
        stop = min(k for k in (text.find(",", start), text.find("}", start)) if k > 0)
        text = text[:start] + (f"{key}: {value}" if value is not None else "stiffness: 1.0e5") + text[stop:]
    return STIFFENER, text


def profile(curve):
    return STIFFENER, STIFFENER.replace("youngs_modulus: 60.0e6", f"stiffness: {curve}")


NATIVE = {
    "negative EI": ((EI, "bending_stiffness: -1"), "bending stiffness of line type cable must not be negative"),
    "curvatures fall": (
        (EI, "bending_stiffness: {x: [0, 0.2, 0.1], y: [0, 1e3, 2e3]}"),
        "bending stiffness of line type cable does not increase at row 3",
    ),
    "moments fall": (
        (EI, "bending_stiffness: {x: [0, 0.1, 0.2], y: [0, 2e3, 1e3]}"),
        "table of bending stiffness of line type cable has moments that do not increase",
    ),
    "curve begins late": (
        (EI, "bending_stiffness: {x: [0.01, 0.2], y: [1e3, 2e3]}"),
        "bending stiffness of line type cable does not start at 0, 0",
    ),
    "moment of a straight line": (
        (EI, "bending_stiffness: {x: [0, 0.2], y: [1e3, 2e3]}"),
        "bending stiffness of line type cable does not start at 0, 0",
    ),
    "negative radius": (("minimum_bend_radius: 2.5", "minimum_bend_radius: -1"), "minimum bend radius of line type cable"),
    "stiffener too long": (stiffener(length="91"), "bend stiffener at end B of line 1 is longer than its section of 90 m"),
    "stiffener of no length": (stiffener(length="0"), "length of the bend stiffener at end B of line 1 must be positive"),
    "thin stiffener": (stiffener(tip_diameter="0.1"), "bend stiffener at end B of line 1 is thinner than the line"),
    "soft stiffener": (stiffener(youngs_modulus="0"), "bend stiffener at end B of line 1 has no stiffness"),
    "light stiffener": (stiffener(density="-1"), "density of the bend stiffener at end B of line 1 must not be negative"),
    "stiffener nowhere": (stiffener(end="C"), "end of bend stiffener 1 is not known"),
    "profile back and forth": (profile("{x: [0, 4, 2], y: [2, 1, 0]}"), "distances of EI of the bend stiffener .* do not"),
    "profile below zero": (profile("{x: [0, 4], y: [1e5, -1]}"), "EI of the bend stiffener .* must not be negative"),
    "profile a negative number": (profile("-5"), "EI of the bend stiffener .* must not be negative"),
    "modules overlap": ((MODULES, MODULES.replace("pitch: 4", "pitch: 0.5")), "are 0.6 m long at a pitch of 0.5 m"),
    "modules inside": ((MODULES, MODULES.replace("0.75", "0.1")), "buoyancy modules of line 1 are thinner than the line"),
    "modules of negative mass": ((MODULES, MODULES.replace("mass: 75", "mass: -75")), "mass of the buoyancy modules of line 1"),
    "negative grading": (("grading: 0.3", "grading: -0.3"), "grading of line 1 must be positive"),
    "rod without direction": (("end_b: [-20.174, 0, -14.985]", "end_b: [-20, 0, -14]"), "rod 1 .* has no direction"),
}  # fmt: skip


@pytest.mark.parametrize("name", NATIVE)
def test_native(native, name):
    replacement, message = NATIVE[name]
    path, line = native(replacement)
    with pytest.raises(ModelError, match=message) as caught:
        read(path)
    problem = caught.value.problems[0]
    assert problem.source.file == str(path)
    assert line - 20 <= problem.source.line <= line  # an object's place is its first line
    assert problem.remedy


@pytest.mark.parametrize(
    ("spring", "message"),
    [("end_b_stiffness: -1", "rotational stiffness of end B .* must not be negative"),
     ("end_a_stiffness: 1e4", "rotational stiffness of end A of line 1 has no rod to turn in")],
)  # fmt: skip
def test_springs(native, spring, message):
    path, _ = native(("    end_b: rod 1 B", f"    end_b: rod 1 B\n    {spring}"))
    with pytest.raises(ModelError, match=message):
        read(path)


def test_a_profile_may_be_one_number(native):
    path, _ = native(profile("2e5"))
    assert read(path).lines[0].stiffeners[0].stiffness == moorage.model.Curve((0.0, 1.0), (2e5, 2e5))


JOINED = """\
---------------------- LINE TYPES ----------------------------
TypeName   Diam     Mass/m   EA         BA/-zeta   EI        Cd    Ca    CdAx   CaAx
(name)     (m)      (kg/m)   (N)        (N-s/-)    (N-m^2)   (-)   (-)   (-)    (-)
cable      0.15     40       4e8        -1.0       1e4       1.2   1.0   0.05   0.0
---------------------- ROD TYPES -----------------------------
TypeName  Diam  Mass/m  Cd  Ca  CdEnd  CaEnd
(name)    (m)   (kg/m)  (-) (-) (-)    (-)
conn      0.1   0       0   0   0      0
---------------------- RODS ----------------------------------
ID   RodType  Attachment  Xa   Ya   Za   Xb   Yb   Zb   NumSegs  RodOutputs
(#)  (name)   (word)      (m)  (m)  (m)  (m)  (m)  (m)  (-)      (-)
1    conn     Free        50   0    -60  51   0    -60  0        -
2    conn     Coupled     0    0    -10  0    0    -11  0        -
---------------------- POINTS --------------------------------
ID    Attachment   X      Y     Z      Mass   Volume   CdA    Ca
(#)   (word)       (m)    (m)   (m)    (kg)   (m^3)    (m^2)  (-)
1     Fixed        120    0.0   -80    0      0        0      0
2     Free         50     0.0   -60    0      0        0      0
---------------------- LINES ---------------------------------
ID    LineType   AttachA   AttachB   UnstrLen   NumSegs   LineOutputs
(#)   (name)     (ID)      (ID)      (m)        (-)       (-)
1     cable      1         R1A       80         40        K
2     cable      R1B       R2B       75         40        K
---------------------- OPTIONS -------------------------------
80.0     WtrDpth   water depth (m)
---------------------- need this line ------------------------
"""


@pytest.fixture
def joined(tmp_path):
    """Write two cables joined by a rod of no length, with parts of the text replaced."""

    def write(*replacements):
        text = JOINED.replace("2     Free         50     0.0   -60    0      0        0      0\n", "")
        for old, new in replacements:
            assert old in text, old
            text = text.replace(old, new, 1)
        path = tmp_path / "model.dat"
        path.write_text(text, "utf-8")
        return path

    return write


MOORDYN = {
    "clamp without direction": (("0    0    -11  0 ", "0    0    -10  0 "), r"model.dat:13: rod 2 .* has no direction"),
    "negative EI": (("-1.0       1e4", "-1.0       -1 "), r"model.dat:4: bending stiffness of line type cable must not be"),
    "table missing": (("-1.0       1e4", "-1.0       b.txt"), r"model.dat:4: table of EI of line type cable not found"),
}  # fmt: skip


@pytest.mark.parametrize("name", MOORDYN)
def test_moordyn(joined, name):
    replacement, message = MOORDYN[name]
    with pytest.raises(ModelError, match=message):
        read(joined(replacement))


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("0 0\n0.2 1e3\n0.1 2e3\n", "does not increase at row 3"),
        ("0 0\n0.1 2e3\n0.2 1e3\n", "has moments that do not increase"),
        ("0 0\n", "has 1 rows of numbers"),
        ("0.01 1e3\n0.2 2e3\n", r"model.dat:4: table bend.txt of bending .* 0, 0(.|\n)*add the row 0 0"),
    ],
)
def test_moordyn_tables(joined, tmp_path, rows, message):
    (tmp_path / "bend.txt").write_text("table\ncurvature moment\n(1/m) (N-m)\n" + rows)
    with pytest.raises(ModelError, match=message) as caught:
        read(joined(("-1.0       1e4", "-1.0       bend.txt")))
    assert all(problem.source for problem in caught.value.problems)


def test_a_line_on_the_wrong_end_of_its_clamp():
    """Refused where it is too short to turn round; with a loop's length more it may."""
    line_type = kind("cable", diameter=0.15, mass_per_length=40.0, bending_stiffness=1e4)

    def model(end, length):
        lines = [line(1, 1, held(rod, end), ("cable", length, 40))]
        return mooring(line_type, [fixed(1, 60.0, 0.0, -80.0)], lines, [rod], water_depth=80.0)

    rod = clamp(1, (0.0, 0.0, -10.0), (0.6, 0.0, -0.7))
    distance = (60.0**2 + 70.0**2) ** 0.5
    moorage.model.checks.check(model("B", distance + 1.0))
    with pytest.raises(ModelError, match=r"line 1 is on the wrong end of rod 1: .* 180 degrees(.|\n)*end B of rod 1"):
        moorage.model.checks.check(model("A", distance + 1.0))
    moorage.model.checks.check(model("A", distance + 5.0 * 0.15 * 3.2))
    rod = clamp(1, (0.0, 0.0, -10.0), (-0.3, 0.0, -1.0))  # down, and away from the anchor
    for length in (1.001 * distance, 2.0 * distance):
        moorage.model.checks.check(model("B", length))


def test_check_tells_a_clamp_that_the_first_guess_leaves_backwards(native):
    path, _ = native(("end_b: rod 1 B", "end_b: rod 1 A"))
    (problem,) = moorage.backward_clamps(read(path))
    assert "line 1 leaves the rod that clamps its end B at about 1" in problem.message
    assert problem.source.file == str(path)
    assert moorage.backward_clamps(read(EXAMPLE)) == []


FOLDED = {
    "A": ("R1B       R2B", "R1A       R2B"),
    "B": ("1         R1A", "1         R1B"),
}


@pytest.mark.parametrize("end", FOLDED)
def test_two_cables_on_one_end_of_a_joint_are_worth_a_warning(joined, end):
    message = (
        f"model.dat:12: cables 1 and 2 are all tied to end {end} of rod 1(.|\\n)*one to end A and the other to end B"
    )
    with pytest.warns(ModelWarning, match=message):
        moorage.simulate(read(joined(FOLDED[end])), start="as-given", duration=0.1)


def test_too_few_segments_between_what_turns(joined):
    with pytest.raises(ModelError, match=r"line 1 has too few segments: its end B is clamped(.|\n)*at least 2"):
        read(joined(("80         40 ", "80         1  ")))


def test_joints_on_the_right_ends_are_read(joined):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert moorage.suspicious(read(joined())) == []


PINNED = (
    ("1         R1A", "1         2  "), ("R1B       R2B", "2         R2B"),
    ("\n---------------------- LINES", "\n2     Free         50     0.0   -60    0      0        0      0\n--- LINES"),
    ("1    conn     Free        50   0    -60  51   0    -60  0        -\n2    conn", "1    conn"), ("R2B", "R1B"),
)  # fmt: skip


def test_a_pinned_junction_is_worth_a_warning(joined):
    model = read(joined(*PINNED))
    message = r"model.dat:17: cables 1, 2 meet at free point 2, which is a pin(.|\n)*free rod of no length"
    with pytest.warns(ModelWarning, match=message):
        moorage.solve_statics(model)
    with pytest.warns(ModelWarning, match=message):
        moorage.simulate(model, duration=0.2)


def test_a_line_that_leaves_its_clamp_backwards_is_worth_a_warning(joined):
    moorage.solve_statics(read(joined()))
    with pytest.warns(ModelWarning, match=r"line 2 leaves the rod that clamps its end B at 1\d\d degrees.*wrong end"):
        moorage.solve_statics(read(joined(("R1B       R2B", "R1B       R2A"))))
