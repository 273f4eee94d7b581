"""Generated models survive writing and reading; spoiled files give an error of ours or a model, never anything else."""

import contextlib
import dataclasses
import tempfile
import warnings
from pathlib import Path

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from moorage.errors import MoorageError
from moorage.io import read, read_motion, read_native, write_moordyn, write_native
from moorage.model import (
    Attachment,
    Current,
    Curve,
    Environment,
    Line,
    LineType,
    Model,
    OutputChannel,
    Point,
    Section,
    Turbine,
)

QUICK = settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
LENGTHS = st.floats(1e-3, 1e4)
POSITIVE = st.floats(1e-6, 1e12)
NOT_NEGATIVE = st.floats(0.0, 1e6)
COORDINATES = st.floats(-1e4, 1e4)
WORDS = st.from_regex(r"[A-Za-z][A-Za-z0-9_]{0,8}", fullmatch=True)


@st.composite
def curves(draw):
    x = sorted(draw(st.lists(st.floats(-10.0, 10.0), min_size=2, max_size=5, unique=True)))
    y = sorted(draw(st.lists(st.floats(0.0, 1e9), min_size=len(x), max_size=len(x), unique=True)))
    return Curve(tuple(x), tuple(y))


@st.composite
def moment_curves(draw):
    """From 0, 0 on, where a straight line has no moment."""
    x = sorted(draw(st.lists(st.floats(1e-3, 10.0), min_size=1, max_size=4, unique=True)))
    y = sorted(draw(st.lists(st.floats(1.0, 1e9), min_size=len(x), max_size=len(x), unique=True)))
    return Curve((0.0, *x), (0.0, *y))


@st.composite
def line_types(draw, name):
    ratio = draw(st.none() | st.floats(1e-3, 2.0))
    return LineType(
        name=name,
        diameter=draw(LENGTHS),
        mass_per_length=draw(NOT_NEGATIVE),
        axial_stiffness=draw(POSITIVE | curves()),
        axial_damping=0.0 if ratio is not None else draw(NOT_NEGATIVE | curves()),
        axial_damping_ratio=ratio,
        bending_stiffness=draw(st.just(0.0) | POSITIVE | moment_curves()),
        transverse_drag=draw(NOT_NEGATIVE),
        tangential_drag=draw(NOT_NEGATIVE),
        transverse_added_mass=draw(NOT_NEGATIVE),
        tangential_added_mass=draw(NOT_NEGATIVE),
    )


@st.composite
def models(draw, most_sections):
    names = draw(st.lists(WORDS, min_size=1, max_size=3, unique_by=str.lower))
    depth = draw(st.floats(1.0, 1e4))
    count = draw(st.integers(2, 5))
    points = tuple(
        Point(
            id=k + 1,
            kind=draw(st.sampled_from(("fixed", "coupled"))) if k else "fixed",
            position=(draw(COORDINATES), draw(COORDINATES), draw(st.floats(-depth, 100.0))),
            mass=draw(NOT_NEGATIVE),
            volume=draw(NOT_NEGATIVE),
            drag_area=draw(NOT_NEGATIVE),
            added_mass=draw(NOT_NEGATIVE),
            external_force=draw(st.just((0.0,) * 3) | st.tuples(COORDINATES, COORDINATES, COORDINATES)),
        )
        for k in range(count)
    )
    lines = tuple(
        Line(
            id=k + 1,
            sections=tuple(
                Section(
                    line_type=draw(st.sampled_from(names)), length=draw(LENGTHS), segments=draw(st.integers(1, 200))
                )
                for _ in range(draw(st.integers(1, most_sections)))
            ),
            end_a=Attachment("point", k + 1),
            end_b=Attachment("point", k + 2),
            outputs=draw(st.sampled_from(("", "p", "ptD"))),
        )
        for k in range(count - 1)
    )
    levels = sorted(draw(st.lists(st.floats(-depth, 0.0), min_size=1, max_size=4, unique=True)))
    velocity = tuple(draw(st.tuples(*[st.floats(-3.0, 3.0)] * 3)) for _ in levels)
    return Model(
        environment=Environment(
            water_depth=depth,
            gravity=draw(NOT_NEGATIVE),
            water_density=draw(NOT_NEGATIVE),
            seabed_stiffness=draw(NOT_NEGATIVE),
            seabed_damping=draw(NOT_NEGATIVE),
            current=draw(st.just(Current()) | st.just(Current(tuple(levels), velocity))),
        ),
        line_types=tuple(draw(line_types(name)) for name in names),
        points=points,
        lines=lines,
        outputs=tuple(OutputChannel(name=f"FAIRTEN{line.id}") for line in lines),
        start=draw(st.sampled_from(("static", "as-given"))),
        output_interval=draw(st.none() | st.floats(1e-3, 10.0)),
        title=draw(st.sampled_from(("", "a title", "two\nlines: of # it"))),
    )


@st.composite
def farms(draw):
    """Models with some of their coupled points on turbines."""
    model = draw(models(most_sections=3))
    places = draw(st.lists(st.tuples(COORDINATES, COORDINATES, COORDINATES), max_size=3))
    turbines = tuple(Turbine(id=k + 1, position=place, name=draw(WORDS)) for k, place in enumerate(places))
    choices = st.sampled_from([None, *(turbine.id for turbine in turbines)])
    points = tuple(
        dataclasses.replace(point, turbine=draw(choices)) if point.kind == "coupled" else point
        for point in model.points
    )
    return dataclasses.replace(model, points=points, turbines=turbines)


@QUICK
@given(farms())
def test_native_round_trip(model):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "model.yaml"
        write_native(model, path)
        assert read_native(path) == model


@QUICK
@given(models(most_sections=1))
def test_moordyn_round_trip(model):
    model = dataclasses.replace(model, title="a title")
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("error")
        path = Path(folder) / "model.dat"
        write_moordyn(model, path, "C")
        assert dataclasses.replace(read(path), flavour=model.flavour) == model


@QUICK
@given(models(most_sections=3))
def test_sections_keep_length_and_segments(model):
    # such a file has lines at joints for sections beside others; cables have 2 segments there, between joints 3
    assume(all(section.segments >= 3 for line in model.lines for section in line.sections[1:-1]))
    assume(all(line.sections[k].segments >= 2 for line in model.lines for k in (0, -1) if len(line.sections) > 1))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "model.dat"
        write_moordyn(model, path, "F")
        again = read(path)
    assert sum(line.segments for line in again.lines) == sum(line.segments for line in model.lines)
    assert len(again.lines) == sum(len(line.sections) for line in model.lines)


MARKS = "nan -1 0 1e999 | 1|2 # \0 é R1A Body9 LINES - --- { [ : &a *a !!python/x .nan \" '"
HEADS = ("--- POINTS ---", "--- RODS ---", "--- BODIES ---", "--- FAILURE ---")
NOISE = st.sampled_from([*MARKS.split(" "), *HEADS, "", "\t", "9" * 400, "- x"])


@st.composite
def spoiled(draw, text):
    """Return a text with words, lines or characters replaced, removed or doubled."""
    for _ in range(draw(st.integers(1, 4))):
        unit = draw(st.sampled_from(("word", "line", "character")))
        pieces = text.split(" ") if unit == "word" else text.split("\n") if unit == "line" else list(text)
        k = draw(st.integers(0, max(len(pieces) - 1, 0)))
        what = draw(st.sampled_from(("replace", "remove", "double", "cut")))
        if what == "replace":
            pieces[k : k + 1] = [draw(NOISE)]
        elif what == "remove":
            del pieces[k : k + 1]
        elif what == "double":
            pieces[k:k] = pieces[k : k + 1]
        else:
            del pieces[k:]
        text = {"word": " ", "line": "\n", "character": ""}[unit].join(pieces)
    return text


def _survives(reader, text, name):
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        path = Path(folder) / name
        path.write_text(text, "utf-8")
        with contextlib.suppress(MoorageError):
            reader(path)


FUZZ = settings(max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.mark.parametrize("name", ["model.dat", "model.yaml", "md_driver.inp", "motion.csv"])
def test_spoiled_files(name):
    texts = {"model.dat": MOORDYN, "model.yaml": NATIVE, "md_driver.inp": DRIVER, "motion.csv": MOTION}
    reader = read_motion if name == "motion.csv" else read

    @FUZZ
    @given(spoiled(texts[name]))
    def survives(text):
        _survives(reader, text, name)

    survives()


@settings(max_examples=100, deadline=None)
@given(st.binary(max_size=300), st.sampled_from(["a.dat", "a.yaml"]))
def test_random_bytes(data, name):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_bytes(data)
        with pytest.raises(MoorageError):
            read(path)


MOORDYN = """\
a chain with everything
--- LINE TYPES ---
TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx
(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)
chain 0.0766 113.35 7.536e8 -0.8 0 2.0 0.8 0.4 0.25
rope 0.1 10 1e8|2e8 1e4|1e5 1e3 2.0 0.8 0.4 0.25
--- ROD TYPES ---
TypeName Diam Mass/m Cd Ca CdEnd CaEnd
(-) (-) (-) (-) (-) (-) (-)
can 1 1 0 0 0 0
--- BODIES ---
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 free 0 0 -1 0 0 0 1 1|2|3 1|2|3 0 1|2 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(-) (-) (-) (-) (-) (-) (-) (-) (-) (-) (-)
1 can Body1Pinned 0 0 -1 0 0 -2 1 -
--- POINTS ---
ID Attachment X Y Z Mass Volume CdA Ca
(#) (word) (m) (m) (m) (kg) (m^3) (m^2) (-)
1 Fixed -837.6 0.0 -200.0 0 0 0 0
2 Coupled -40.868 0.0 -14.0 0 0 0 0
--- LINES ---
ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name) (ID) (ID) (m) (-) (-)
1 chain 1 2 835.35 20 p
2 rope 1 R1B 835.35 20 -
--- FAILURE ---
FailureID Point Line(s) FailTime FailTen
(-) (-) (-) (-) (-)
1 R1B 2 10 0
--- CONTROL ---
ChannelID Line(s)
(-) (-)
1 1,2
--- EXTERNAL LOADS ---
ID Object Fext Blin Bquad CSys
(-) (-) (-) (-) (-) (-)
1 Body1 1|2|3 1|2|3 0 G
--- OPTIONS ---
200.0 WtrDpth
9.80665 g
0.5 mu_kT
1 Currents
0 TmaxIC
--- OUTPUTS ---
FairTen1
L1N10PX
--- need this line ---
"""
NATIVE = """\
moorage: 1
environment:
  water_depth: 200
  current: {z: [-200, 0], velocity: [[0, 0, 0], [1, 0, 0]]}
  bathymetry: {x: [0, 1], y: [0], depth: [[200], [200]]}
line_types:
  chain: {diameter: 0.1, mass_per_length: 100, axial_stiffness: {x: [0, 1], y: [0, 1e8]}}
points:
  - {id: 1, name: anchor, kind: fixed, position: [-800, 0, seabed]}
  - {id: 2, kind: coupled, position: [-40, 0, -14]}
lines:
  - {id: 1, end_a: anchor, end_b: 2, sections: [{line_type: chain, length: 800, segments: 10}]}
outputs: [FAIRTEN1]
"""
DRIVER = """\
driver
--- ENVIRONMENTAL CONDITIONS ---
9.8 Gravity
1020.0 rhoW
210.0 WtrDpth
--- MOORDYN ---
"model.dat" MDInputFile
10 TMax
0.0125 dtC
0 InputsMode
"motion.dat" InputsFile
0 NumTurbines
--- Initial Positions ---
ref_X ref_Y surge_init sway_init heave_init roll_init pitch_init yaw_init
(m) (m) (m) (m) (m) (rad) (rad) (rad)
0 0 0 0 0 0 0 0
"""
MOTION = """\
time[s], surge[m], sway[m], heave[m], roll[deg], pitch[deg], yaw[deg], point2.x[m], point2.y[m], point2.z[m]
0, 0, 0, 0, 0, 0, 0, 1, 2, 3
1, 0, 0, 0, 0, 0, 0, 1, 2, 3
"""
