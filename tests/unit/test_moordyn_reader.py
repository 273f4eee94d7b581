"""The reader of MoorDyn model files: what each section gives, in the spellings of C and F."""

import warnings
from math import radians

import pytest

from moorage.errors import ModelWarning, Source
from moorage.io import read
from moorage.model import Attachment, Current, Curve

OLD_TYPES = "TypeName   Diam     Mass/m   EA         BA/-zeta   EI        Cd    Ca    CdAx   CaAx"
OLD_ROW = "chain      0.0766   113.35   7.536e8    -0.8       0         2.0   0.8   0.4    0.25"
POINT_2 = "2     Coupled      -40.868   0.0   -14.0    0      0        0      0"
END = "---------------------- OPTIONS"


@pytest.fixture(autouse=True)
def _no_warnings():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


def test_small_file(deck):
    path = deck()
    model = read(path)
    (line_type,) = model.line_types
    assert (line_type.name, line_type.diameter, line_type.mass_per_length) == ("chain", 0.0766, 113.35)
    assert (line_type.axial_stiffness, line_type.axial_damping_ratio, line_type.bending_stiffness) == (
        7.536e8,
        0.8,
        0.0,
    )
    assert (line_type.transverse_drag, line_type.transverse_added_mass) == (2.0, 0.8)
    assert (line_type.tangential_drag, line_type.tangential_added_mass) == (0.4, 0.25)
    assert [p.kind for p in model.points] == ["fixed", "coupled"]
    assert model.points[1].position == (-40.868, 0.0, -14.0)
    (line,) = model.lines
    assert (line.length, line.segments, line.outputs) == (835.35, 20, "p")
    assert (line.end_a, line.end_b) == (Attachment("point", 1), Attachment("point", 2))
    assert (model.environment.water_depth, model.start, model.title) == (200.0, "static", "A chain in 200 m")
    assert [o.name for o in model.outputs] == ["FAIRTEN1", "L1N10PX"]
    assert [o.name for o in model.unused_options] == ["dtM"]
    assert line_type.source == Source(str(path), 6)
    assert line.source == Source(str(path), 15)
    assert model.text == path.read_text()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("- LINE TYPES -", "- line dictionary -"),
        ("- POINTS -", "- Connection Properties -"),
        ("- POINTS -", "- NODE PROPERTIES -"),
        ("- POINTS -", "- POINT LIST -"),
        ("- LINES -", "- LINE PROPERTIES -"),
        ("- LINES -", "- line list -"),
        ("- OPTIONS -", "- SOLVER OPTIONS -"),
        ("- OUTPUTS -", "- OUTPUT CHANNELS -"),
    ],
)
def test_section_keywords(deck, old, new):
    assert read(deck((old, new))) == read(deck())


def test_comments_blank_lines_tabs_and_numbers(deck):
    changed = deck(
        (OLD_ROW, "\n# a remark\nchain\t.0766 +113.35 7.536D8 -0.8 0. 2 0.8 0.4 0.25 # the chain\n"),
        ("1     chain ", "1     chain "),
        ("FairTen1", "FairTen1 # tension\n! another remark"),
    )
    assert read(changed) == read(deck(name="plain.dat"))


def test_columns_by_name_in_the_old_order(deck):
    path = deck(
        (OLD_TYPES, "LineType Diam MassDenInAir EA BA/-zeta EI Can Cat Cdn Cdt"),
        (OLD_ROW, "chain 0.0766 113.35 7.536e8 -0.8 0 0.8 0.25 2.0 0.4"),
    )
    with pytest.warns(ModelWarning, match="read by their names"):
        model = read(path)
    assert model == read(deck(name="plain.dat"))


def test_stray_column_switches_nothing_on(deck):
    path = deck(
        (OLD_TYPES, "LineType Diam MassDenInAir EA BA/-zeta EI tbd Cd Ca CdAx CaAx"),
        (OLD_ROW, "chain 0.0766 113.35 7.536e8 -0.8 0 9.9 2.0 0.8 0.4 0.25"),
    )
    with pytest.warns(ModelWarning, match="column tbd of LINE TYPES is not known"):
        model = read(path)
    assert model.line_types[0].lift_coefficient == 0.0
    assert model == read(deck(name="plain.dat"))


def test_unfamiliar_names_count_by_position(deck):
    path = deck((OLD_TYPES, "Kind Diam Mass/m Stiffness BA/-zeta EI Cd Ca CdAx CaAx"))
    assert read(path) == read(deck(name="plain.dat"))


@pytest.mark.parametrize(
    ("names", "values", "expected"),
    [("Cl", "0.8", (0.8, 0.08, 0.18)), ("Cl dF cF", "0.8 0.1 0.2", (0.8, 0.1, 0.2)), ("Cl", "", (0.0, 0.08, 0.18))],
)
def test_vortex_vibration_columns(deck, names, values, expected):
    line_type = read(deck((OLD_TYPES, f"{OLD_TYPES} {names}"), (OLD_ROW, f"{OLD_ROW} {values}"))).line_types[0]
    assert (line_type.lift_coefficient, line_type.viv_range, line_type.viv_centre) == expected


def test_viscoelastic_values(deck):
    line_type = read(deck(("7.536e8    -0.8", "1.4e8|1.6e8|0.4   4E9|11E6"))).line_types[0]
    assert (line_type.axial_stiffness, line_type.viscoelastic) == (1.4e8, (1.6e8, 0.4))
    assert (line_type.axial_damping, line_type.dynamic_damping) == (4e9, 11e6)


def test_syrope(deck, tmp_path):
    (tmp_path / "syrope.dat").write_text("owc.dat OWC\n")
    model = read(
        deck(
            ("7.536e8    -0.8", "SYROPE:syrope.dat|1.5e8|23   5e10|1e5"),
            (END, "--- SYROPE IC ---\nLine(s) Tmax0 Tmean0\n(-) (N) (N)\n1 1.3e6 4.3e5\n" + END),
        )
    )
    assert (model.line_types[0].syrope, model.line_types[0].viscoelastic) == ("syrope.dat", (1.5e8, 23.0))
    assert model.lines[0].syrope_tensions == (1.3e6, 4.3e5)


def test_tables(deck, tmp_path):
    (tmp_path / "rope.txt").write_text("--- rope ---\nStrain Tension\n(-) (N)\n0 0\n0.1 2e5\n0.2 5e5\n")
    model = read(deck(("7.536e8    -0.8       0 ", "rope.txt rope.txt rope.txt ")))
    curve = Curve((0.0, 0.1, 0.2), (0.0, 2e5, 5e5))
    line_type = model.line_types[0]
    assert line_type.axial_stiffness == line_type.axial_damping == line_type.bending_stiffness == curve
    assert line_type.axial_stiffness.file == "rope.txt"


def test_bending_with_damping(deck):
    line_type = read(deck(("-0.8       0 ", "-0.8  1e4|2e3 "))).line_types[0]
    assert (line_type.bending_stiffness, line_type.bending_damping) == (1e4, 2e3)


@pytest.mark.parametrize(
    ("word", "kind", "turbine"),
    [(w, "fixed", None) for w in ("Fixed", "ANCHOR", "fix")]
    + [(w, "coupled", None) for w in ("Coupled", "Vessel", "ves", "CPLD", "Fairlead")]
    + [("Turbine2", "coupled", 2), ("T3", "coupled", 3)],
)
def test_attachment_words(deck, word, kind, turbine):
    point = read(deck((POINT_2, POINT_2.replace("Coupled", word)))).points[1]
    assert (point.kind, point.turbine, point.body) == (kind, turbine, None)


@pytest.mark.parametrize("word", ["Free", "Point", "Connect", "Con", "P"])
def test_free_words(deck, word):
    assert read(deck((POINT_2, POINT_2.replace("Coupled", word)))).points[1].kind == "free"


@pytest.mark.parametrize("word", ["2", "P2", "Point2", "Con2", "c2"])
def test_line_ends_on_points(deck, word):
    path = deck(("1     chain      1         2 ", f"1     chain      1         {word} "))
    assert read(path).lines[0].end_b == Attachment("point", 2)


def test_point_on_seabed_word(deck):
    point = read(deck(("0.0   -200.0", "0.0   Seabed"))).points[0]
    assert (point.on_seabed, point.position[2]) == (True, -200.0)


def test_points_with_forces(deck):
    model = read(
        deck(
            ("Mass   Volume   CdA    Ca", "M V FX FY FZ CdA CA"),
            (
                "1     Fixed        -837.6    0.0   -200.0   0      0        0      0",
                "1 Fixed -837.6 0 -200 0 0 0 0 0 0 0",
            ),
            (POINT_2, "2 Connect -40.868 0 -14 10 0.5 1 2 3 4 5"),
        )
    )
    point = model.points[1]
    assert (point.mass, point.volume, point.external_force) == (10.0, 0.5, (1.0, 2.0, 3.0))
    assert (point.drag_area, point.added_mass) == (4.0, 5.0)


BODIES_AND_RODS = """\
--- ROD TYPES ---
TypeName Diam Mass/m Cd Ca CdEnd CaEnd
(name) (m) (kg/m) (-) (-) (-) (-)
can 10 1.0e3 0.6 1.0 1.2 1.1
--- BODIES ---
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 free 1 2 -3 10 20 30 1e6 -4 1e10 5 7 8
2 VesselPinned 0 0 0 0 0 0 1 1|2|3 4|5|6 0 1|2|3|4|5|6 7|8|9
3 Coupled 0 0 0 0 0 0 0 0 0 0 1|2 0
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 can Body1 0 0 2 0 0 15 8 p
2 can Body1Pinned 2 0 2 5 0 15 8 -
3 can Fixed 0 0 -50 0 0 -60 0 -
4 can Pinned 0 0 -50 0 0 -60 2 -
5 can CoupledPinned 0 0 -50 0 0 -60 2 -
6 can Turbine1 0 0 -50 0 0 -60 2 -
"""
POINTS = "---------------------- POINTS -"


def test_bodies_and_rods(deck):
    model = read(
        deck(
            (POINTS, BODIES_AND_RODS + POINTS),
            (POINT_2, POINT_2.replace("Coupled", "Body3 ")),
            ("1     chain      1         2 ", "1     chain      1         R1A "),
        )
    )
    first, second, third = model.bodies
    assert (first.kind, first.position, first.mass) == ("free", (1.0, 2.0, -3.0), 1e6)
    assert first.rotation == pytest.approx((radians(10), radians(20), radians(30)))
    assert (first.centre_of_gravity, first.inertia) == ((0.0, 0.0, -4.0), (1e10,) * 3)
    assert (first.drag_area, first.added_mass) == ((7.0,) * 6, (8.0, 8.0, 8.0, 0.0, 0.0, 0.0))
    assert (second.kind, second.centre_of_gravity, second.inertia) == ("coupled-pinned", (1, 2, 3), (4, 5, 6))
    assert (second.drag_area, second.added_mass[:3]) == ((1, 2, 3, 4, 5, 6), (7, 8, 9))
    assert third.drag_area == (1, 1, 1, 2, 2, 2)
    assert [r.kind for r in model.rods] == ["fixed", "pinned", "fixed", "pinned", "coupled-pinned", "coupled"]
    assert [r.body for r in model.rods] == [1, 1, None, None, None, None]
    assert (model.rods[2].segments, model.rods[5].turbine) == (0, 1)
    assert (model.rod_types[0].end_drag, model.rod_types[0].end_added_mass) == (1.2, 1.1)
    assert model.points[1].body == 3
    assert model.lines[0].end_b == Attachment("rod", 1, "A")


def test_events(deck):
    model = read(
        deck(
            (POINTS, BODIES_AND_RODS + POINTS),
            (
                END,
                "--- FAILURE ---\nFailureID Point Line(s) FailTime FailTen\n() () (,) (s or 0) (N or 0)\n1 P1 1 12 3e5\n"
                "--- CONTROL ---\nChannelID Line(s)\n() (,)\n2 1,\n"
                "--- EXTERNAL LOADS ---\nID Object Fext Blin Bquad CSys\n(#) (name) (N) (-) (-) (-)\n"
                "1 Body1 1|2|3 4 5|6|7 L\n2 Rod2 0 1|2 3 -\n3 Point2 1|0|0 0 0 -\n" + END,
            ),
        )
    )
    (failure,) = model.failures
    assert (failure.attachment, failure.lines) == (Attachment("point", 1), (1,))
    assert (failure.time, failure.tension) == (12.0, 3e5)
    assert (model.controls[0].channel, model.controls[0].lines) == (2, (1,))
    body, rod, point = model.external_loads
    assert (body.force, body.linear_damping, body.quadratic_damping) == ((1, 2, 3), (4, 4, 4), (5, 6, 7))
    assert (body.local, rod.local, point.local) == (True, True, False)
    assert (rod.linear_damping, rod.quadratic_damping) == ((1, 2), (3, 3))
    assert (point.target, point.target_id) == ("point", 2)


def with_options(deck, *rows, keep_depth=True):
    depth = () if keep_depth else (("200.0    WtrDpth   water depth (m)\n", ""),)
    return read(deck(*depth, ("9.80665  g         gravity", "\n".join(rows))))


def test_options_and_their_aliases(deck):
    model = with_options(deck, "9.7 GRAVITY", "1000 WtrDnsty", "1e5 KB", "2e4 cb", "0 ICTmax", "0.25 dtOut")
    environment = model.environment
    assert (environment.gravity, environment.water_density) == (9.7, 1000.0)
    assert (environment.seabed_stiffness, environment.seabed_damping) == (1e5, 2e4)
    assert (model.start, model.output_interval) == ("as-given", 0.25)
    assert with_options(deck, "1010 rhoW").environment.water_density == 1010.0


@pytest.mark.parametrize("name", ["WtrDpth", "Depth", "WaterDepth", "wtrdpth"])
def test_depth_aliases(deck, name):
    assert with_options(deck, f"210 {name}", keep_depth=False).environment.water_depth == 210.0


def test_depth_of_the_lowest_point_when_none_is_given(deck):
    with pytest.warns(ModelWarning, match="that of the lowest point, 200 m"):
        assert with_options(deck, "9.8 g", keep_depth=False).environment.water_depth == 200.0


def test_option_given_twice(deck):
    with pytest.warns(ModelWarning, match="option rho was given before"):
        assert with_options(deck, "1000 rho", "1010 WtrDnsty").environment.water_density == 1010.0


def test_unused_options_of_both_programs(deck):
    rows = ["0.5 CFL", "RK4 tScheme", "5 CdScaleIC", "0.01 icthresh", "1 ICgenDynamic", "2 writeLog", "1 inertialF"]
    assert {o.name for o in with_options(deck, *rows).unused_options} == {
        "CFL", "tScheme", "CdScaleIC", "threshIC", "ICgenDynamic", "writeLog", "inertialF", "dtM",
    }  # fmt: skip


@pytest.mark.parametrize(
    ("rows", "flavour"),
    [
        (["0.5 CFL"], "MoorDyn-C"),
        (["0.3 mu_kT"], "MoorDyn-F"),
        (["9.8 g"], "MoorDyn v2"),
        (["1 CFL", "0.3 mu_kT"], "MoorDyn v2"),
    ],
)
def test_flavour(deck, rows, flavour):
    assert with_options(deck, *rows).flavour == flavour


def test_friction_of_both_programs(deck):
    c = with_options(deck, "0.6 FrictionCoefficient", "500 FricDamp", "1.2 StatDynFricScale").environment.friction
    assert (c.transverse, c.axial, c.damping, c.static_ratio) == (0.6, 0.6, 500.0, 1.2)
    f = with_options(deck, "0.6 mu_kT", "0.4 mu_kA", "1e6 cv", "1.3 mc").environment.friction
    assert (f.transverse, f.axial, f.damping, f.static_ratio) == (0.6, 0.4, 1e6, 1.3)


C_GRID = "2 3\n-1000 0\n-500 0 500\n" + "".join(
    f"{x} {y} {-(200 + x / 10 + y / 100)}\n" for x in (-1000, 0) for y in (-500, 0, 500)
)
F_GRID = "--- grid ---\nnGridX 2\nnGridY 3\n-1000 0\n" + "".join(
    f"{y} {200 - 1000 / 10 + y / 100} {200 + y / 100}\n" for y in (-500, 0, 500)
)


@pytest.mark.parametrize(("text", "option"), [(C_GRID, "SeafloorFile"), (F_GRID, "WtrDpth")])
def test_both_depth_files_give_the_same_grid(deck, tmp_path, text, option):
    (tmp_path / "depths.txt").write_text(text)
    path = deck(("200.0    WtrDpth", f"depths.txt {option}"), ("-200.0", "-110.0"))
    environment = read(path).environment
    grid = environment.bathymetry
    assert (grid.x, grid.y) == ((-1000.0, 0.0), (-500.0, 0.0, 500.0))
    assert grid.depth == ((95.0, 100.0, 105.0), (195.0, 200.0, 205.0))
    assert environment.water_depth == environment.depth_at(0.0, 0.0) == 200.0
    assert environment.depth_at(-500.0, 250.0) == pytest.approx(152.5)
    assert environment.depth_at(1e4, -1e4) == 195.0


def test_steady_current_of_c(deck, tmp_path):
    (tmp_path / "current_profile.txt").write_text("---\ncurrent\nz ux uy\n-200 0 0\n-10.0 1.0 0.5\n0 1.25 0.5\n")
    current = with_options(deck, "1 Currents").environment.current
    assert current == Current((-200.0, -10.0, 0.0), ((0.0, 0.0, 0.0), (1.0, 0.5, 0.0), (1.25, 0.5, 0.0)))


WATER = """\
MoorDyn Waves and Currents
notes
--- WAVES ---
{waves} WaveKinMod
"" WaveKinFile
0.5 dtWave
--- CURRENT ---
1 CurrentMod
2 - Z input type
-600, 0, 60 - Z grid
z-depth x-current y-current
(m) (m/s) (m/s)
0.0 0.2 0
-10.0 0.1 0
--- need this line ---
"""


def test_water_file_of_f(deck, tmp_path):
    (tmp_path / "water.dat").write_text(WATER.format(waves=0))
    environment = with_options(deck, "water.dat WaterKin").environment
    assert environment.current == Current((-10.0, 0.0), ((0.1, 0.0, 0.0), (0.2, 0.0, 0.0)))
    assert environment.unread_water is None
    (tmp_path / "water.dat").write_text(WATER.format(waves=2))
    assert with_options(deck, "water.dat WaterKin").environment.unread_water.value == "water.dat"


def test_waves_are_remembered(deck):
    waves = with_options(deck, "4 WaveKin", "0.1 dtWave", "2 Currents").environment.unread_water
    assert (waves.option, waves.value, waves.settings) == ("WaveKin", "4", (("Currents", "2"), ("dtWave", "0.1")))
    assert with_options(deck, "4 Currents").environment.unread_water.option == "Currents"
    assert with_options(deck, "SeaState WaterKin").environment.unread_water.option == "WaterKin"


def test_outputs_end_with_a_word(deck):
    assert [o.name for o in read(deck(("L1N10PX", "Con2Fx, Line1NBPZ\nEND\nremarks about it"))).outputs] == [
        "FAIRTEN1", "CON2FX", "LINE1NBPZ",
    ]  # fmt: skip


V1 = """\
MoorDyn input file
MoorDyn v1 sample
True   Echo   echo the input file data (flag)
------------------------- LINE TYPES -------------------------
{count}LineType  Diam    MassDen    EA       BA/-zeta   Can   Cat   Cdn   Cdt
(-)       (m)     (kg/m)     (N)      (Pa-s/-)   (-)   (-)   (-)   (-)
nylon    0.124    13.76    2515288.0    -0.8     1.0   0.0   1.6   0.05
----------------------- CONNECTION PROPERTIES -----------------
Node      Type      X        Y         Z        M        V        FX       FY      FZ     CdA   CA
(-)       (-)      (m)      (m)       (m)      (kg)     (m^3)    (kN)     (kN)    (kN)   (m^2)  (-)
1         Vessel     0.0     0      -10.00       0        0        0        0       0       0     0
2         Fixed    267.0     0      -70.00       0        0        0        0       0       0     0
-------------------------- LINE PROPERTIES --------------------
Line     LineType  UnstrLen  NumSegs    NodeAnch  NodeFair  Flags/Outputs
(-)      (-)       (m)         (-)       (-)       (-)      (-)
1        nylon     300.0        50        2         1        p
-------------------------- SOLVER OPTIONS----------------------
0.001    dtM          - time step to use in mooring integration
3.0e6    kb           - bottom stiffness
70       WtrDpth      - water depth
0        ICTmax       - none
---------------------- OUTPUTS --------------------------------
FairTen1
Con2Fz
END
------------------------- need this line -----------------------
"""


@pytest.mark.parametrize("count", ["", "1   NTypes   - number of LineTypes\n"])
def test_version_1(tmp_path, count):
    path = tmp_path / "lines.txt"
    path.write_text(V1.format(count=count))
    model = read(path)
    (line_type,), (line,) = model.line_types, model.lines
    assert model.flavour == "MoorDyn v1"
    assert (line_type.transverse_added_mass, line_type.tangential_added_mass) == (1.0, 0.0)
    assert (line_type.transverse_drag, line_type.tangential_drag) == (1.6, 0.05)
    assert line_type.bending_stiffness == 0.0
    assert (line.length, line.segments, line.end_a.id, line.end_b.id) == (300.0, 50, 2, 1)
    assert [p.kind for p in model.points] == ["coupled", "fixed"]
    assert model.start == "as-given"


def test_version_1_forces_are_newtons(tmp_path):
    path = tmp_path / "lines.txt"
    path.write_text(
        V1.format(count="").replace("-70.00       0        0        0  ", "-70.00       0        0        5  ")
    )
    with pytest.warns(ModelWarning, match="read in newtons"):
        assert read(path).points[1].external_force == (5.0, 0.0, 0.0)


def test_numbers_after_words_mean_nothing(deck):
    with pytest.warns(ModelWarning, match="number in Coupled1 means nothing"):
        assert read(deck((POINT_2, POINT_2.replace("Coupled", "Coupled1")))).points[1].kind == "coupled"


def test_byte_order_mark_and_other_encodings(deck, tmp_path):
    text = deck().read_text().replace("(m^3)", "(m³)")
    for encoding in ("utf-8-sig", "latin-1"):
        path = tmp_path / "other.dat"
        path.write_bytes(text.encode(encoding))
        assert read(path) == read(deck())


def test_anchor_is_raised_when_asked(deck):
    path = deck(("0.0   -200.0", "0.0   -205.0"))
    assert read(path, raise_to_seabed=True).points[0].position == (-837.6, 0.0, -200.0)
