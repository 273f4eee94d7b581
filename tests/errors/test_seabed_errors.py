"""Errors and warnings of the seabed: depth grids, what stands off them, coefficients, friction that is a damper."""

import dataclasses
import warnings

import pytest
from moorings import CHAIN, coupled, fixed, free, line, mooring
from native_text import check_refused

import moorage
from moorage.errors import ModelError, ModelWarning
from moorage.io import read
from moorage.model import Bathymetry, Friction, Motion
from moorage.model.checks import check, suspicious
from moorage.model.seabed import raise_to_seabed

NATIVE = """moorage: 1
environment:
  water_depth: 200
  friction: {model: stick-slip, axial: 0.5, transverse: 0.7, static_ratio: 1.1}
  bathymetry:
    x: [-1000, 0]
    y: [-100, 100]
    depth: [[200, 210], [220, 230]]
line_types:
  chain: {diameter: 0.0766, mass_per_length: 113.35, axial_stiffness: 7.536e8}
points:
  - {id: 1, kind: fixed, position: [-800, 0, seabed]}
  - {id: 2, kind: coupled, position: [-40, 0, -14]}
lines:
  - {id: 1, end_a: 1, end_b: 2, sections: [{line_type: chain, length: 820, segments: 20}]}
"""

CASES = {
    "not rectangular": (("[220, 230]]", "[220]]"), r"model.yaml:8: rows of depth of bathymetry .* differ in length"),
    "wrong count": (("[[200, 210], [220, 230]]", "[[200, 210]]"), "model.yaml:6: depth grid is not rectangular"),
    "x falls": (("x: [-1000, 0]", "x: [0, -1000]"), "model.yaml:6: x of the depth grid does not increase"),
    "y stands": (("y: [-100, 100]", "y: [100, 100]"), "model.yaml:6: y of the depth grid does not increase"),
    "no depth": (("[[200, 210]", "[[.nan, 210]"), "model.yaml:8: depth of bathymetry .* is not a number"),
    "anchor off the grid": (
        ("[-800, 0, seabed]", "[-1100, 0, seabed]"),
        r"model.yaml:12: anchor \(fixed point 1\) is outside the depth grid \(x -1000 to 0 m, y -100 to 100 m\)",
    ),
    "negative friction": (("axial: 0.5", "axial: -0.5"), "model.yaml:4: axial of seabed friction must not be negative"),
    "negative damping": (
        ("axial: 0.5", "axial: 0.5, shear_damping: -1"),
        "shear damping of seabed friction must not be negative",
    ),
    "static below kinetic": (
        ("static_ratio: 1.1", "static_ratio: 0.9"),
        "model.yaml:4: static friction is below kinetic",
    ),
    "no spring": (
        ("axial: 0.5", "axial: 0.5, shear_stiffness: 0"),
        "shear stiffness of seabed friction must be positive",
    ),
    "no speed": (("axial: 0.5", "axial: 0.5, velocity: -1"), "velocity of seabed friction must be positive"),
}


@pytest.mark.parametrize("name", CASES)
def test_native(tmp_path, name):
    change, message = CASES[name]
    check_refused(tmp_path, NATIVE, change, message)


FILES = {
    "x stands": ("--- grid ---\nnGridX 2\nnGridY 2\n0 0\n0 200 200\n1 200 200\n", "WtrDpth", "depths.txt:4: x of the"),
    "y falls": ("--- grid ---\nnGridX 2\nnGridY 2\n0 1\n1 200 200\n0 200 200\n", "WtrDpth", "depths.txt:6: y of the"),
    "x falls in C": ("2 1\n1 0\n0\n0 0 -200\n1 0 -200\n", "SeafloorFile", "depths.txt:2: x of the depth grid does not"),
    "y falls in C": ("1 2\n0\n1 0\n0 0 -200\n0 1 -200\n", "SeafloorFile", "depths.txt:3: y of the depth grid does not"),
    "wrong count": (
        "2 1\n0 1 2\n0\n0 0 -200\n1 0 -200\n",
        "SeafloorFile",
        "depths.txt:2: row of the depth file is not",
    ),
    "more rows than the count": (
        "--- grid ---\nnGridX 2\nnGridY 2\n0 1\n0 200 200\n1 200 200\n2 200 200\n",
        "WtrDpth",
        r"depths.txt:7: depth file has more rows of depths than 2 \(nGridY\)",
    ),
    "no depth": ("2 1\n0 1\n0\n0 0 nan\n1 0 -200\n", "SeafloorFile", "depths.txt:4: row of the depth file is not"),
}


@pytest.mark.parametrize("name", FILES)
def test_depth_files(deck, tmp_path, name):
    text, option, message = FILES[name]
    (tmp_path / "depths.txt").write_text(text)
    with pytest.raises(ModelError, match=message):
        read(deck(("200.0    WtrDpth", f"depths.txt {option}")))


def test_anchor_off_a_depth_file(deck, tmp_path):
    (tmp_path / "depths.txt").write_text("--- grid ---\nnGridX 2\nnGridY 2\n-500 500\n-500 200 200\n500 200 200\n")
    with pytest.raises(ModelError, match=r"model.dat:\d+: anchor \(fixed point 1\) is outside the depth grid"):
        read(deck(("200.0    WtrDpth", "depths.txt WtrDpth")))


def chain(segments=10, **environment):
    points = [fixed(1, -600.0, 0.0, -120.0), coupled(2, 0.0, 0.0, -10.0)]
    return mooring(CHAIN, points, [line(1, 1, 2, ("chain", 640.0, segments))], water_depth=120.0, **environment)


def test_holes_in_a_grid_from_python():
    grid = Bathymetry((-700.0, 100.0), (-50.0, 50.0), ((120.0, float("nan")), (120.0, 120.0)))
    with pytest.raises(
        ModelError, match="depth grid has 1 cells without depth, the first at x -700 m, y 50 m"
    ) as caught:
        check(chain(bathymetry=grid))
    assert len(caught.value.problems) == 1


@pytest.mark.parametrize(("z", "gap"), [(-190.0, "10 m"), (-199.7, "0.3 m"), (-118.0, "82 m")])
@pytest.mark.parametrize("grid", [None, Bathymetry((-700.0, 100.0), (-50.0, 50.0), ((200.0, 200.0), (200.0, 200.0)))])
def test_anchors_that_hang_over_the_bed_are_told(z, gap, grid):
    """And the remedy names raise_to_seabed where that moves them, and nowhere else."""
    points = [fixed(1, -600.0, 0.0, z), coupled(2, 0.0, 0.0, -10.0), fixed(3, 0.0, 0.0, z)]
    model = mooring(CHAIN, points, [line(1, 1, 2, ("chain", 640.0, 10))], water_depth=200.0, bathymetry=grid)
    (problem,) = suspicious(model)  # point 3 holds no line
    assert f"anchor (fixed point 1) stands {gap} over the seabed" in problem.message
    moved = raise_to_seabed(model).points[0].position[2] == -200.0
    assert moved == ("raise_to_seabed" in problem.remedy) == (grid is not None and z < -180.0)


@pytest.mark.parametrize("z", [-199.95, -99.0])
def test_anchors_on_the_bed_and_holds_in_the_water_are_not(z):
    points = [fixed(1, -600.0, 0.0, z), coupled(2, 0.0, 0.0, -10.0)]
    assert suspicious(mooring(CHAIN, points, [line(1, 1, 2, ("chain", 640.0, 10))], water_depth=200.0)) == []


def saturated(damping, **more):
    return Friction(axial=0.5, transverse=0.5, model="saturated-damping", damping=damping, **more)


def test_weak_damper_is_told_with_its_lines():
    (problem,) = suspicious(chain(friction=saturated(200.0)))
    # a node of 64 m weighs 68 kN in water: c_v v / N = 200 * 0.1 / 68000
    assert "reaches 0.029 % of Coulomb's friction at 0.1 m/s on line 1" in problem.message
    assert "elastic-slip" in problem.remedy
    assert float(problem.remedy.split()[1]) == pytest.approx(0.9 * 68.2e3 / 0.1, rel=0.05)


def test_static_friction_of_a_law_without_it_is_told():
    (problem,) = suspicious(chain(friction=Friction(axial=0.5, static_ratio=1.5)))
    assert problem.message == "static_ratio of seabed friction has no effect on the model elastic-slip"
    assert suspicious(chain(friction=Friction(axial=0.5, static_ratio=1.5, model="stick-slip"))) == []


def test_unknown_law_from_python():
    with pytest.raises(
        ModelError, match=r"model of friction of environment is not one of elastic-slip.*\(read: 'coulomb'\)"
    ):
        check(chain(friction=Friction(axial=0.5, model="coulomb")))


def test_finer_meshes_and_stronger_dampers_are_nearer_to_coulomb():
    assert suspicious(chain(segments=640, friction=saturated(1e4))) == []
    assert suspicious(chain(friction=saturated(1e6))) == []
    assert suspicious(chain(friction=Friction(axial=0.5))) == []
    assert (
        suspicious(chain(friction=saturated(200.0, static_ratio=2.0)))[0].message
        != suspicious(chain(friction=saturated(200.0)))[0].message
    )


def test_default_damper_of_a_file(deck):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = read(deck(("9.80665  g         gravity", "1.0 FrictionCoefficient")))
    (problem,) = suspicious(model)
    assert problem.source.file.endswith("model.dat")
    model = dataclasses.replace(model, unused_options=())
    with pytest.warns(
        ModelWarning, match=r"saturated damping with c_v = 200 N s/m reaches 0\..* % of Coulomb's friction"
    ):
        moorage.solve_statics(model)


GRID = Bathymetry((-700.0, -300.0), (-50.0, 50.0), ((120.0,) * 2,) * 2)


def test_points_off_the_grid_are_told():
    (problem,) = suspicious(chain(bathymetry=GRID))
    assert problem.message.startswith("point 2 is outside the depth grid (x -700 to -300 m, y -50 to 50 m)")
    wide = dataclasses.replace(GRID, x=(-700.0, 100.0))
    assert suspicious(chain(bathymetry=wide)) == []
    assert (
        suspicious(chain(bathymetry=Bathymetry((0.0,), (-50.0, 50.0), ((120.0, 120.0),)))) == []
    )  # the same for all x


def test_anchors_that_do_not_meet_the_bed_are_told_and_put_on_it(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text(NATIVE.replace("[-800, 0, seabed]", "[-800, 0, -206.5]"))  # the grid is 209 m deep there
    (problem,) = suspicious(read(path))
    assert "anchor (fixed point 1) stands 2.5 m over the seabed of the depth grid" in str(problem)
    assert "model.yaml:12" in str(problem)
    assert "--raise-to-seabed" in problem.remedy
    raised = read(path, raise_to_seabed=True)
    assert raised.points[0].position[2] == pytest.approx(-209.0)
    assert suspicious(raised) == []
    path.write_text(NATIVE.replace("[-800, 0, seabed]", "[-800, 0, -209.5]"))
    with pytest.raises(
        ModelError, match=r"model.yaml:12: fixed point 1 is 0.5 m below the seabed.*\n.*--raise-to-seabed"
    ):
        read(path)
    assert read(path, raise_to_seabed=True).points[0].position[2] == pytest.approx(-209.0)


GRID_FILE = "1000 2000 -200\n1001 2000 -201\n1000 2001 -200\n1001 2001 -201\n"
RASTERS = {
    "no system": (GRID_FILE, "file: survey.xyz", "model.yaml:5: raster has no coordinate system"),
    "degrees": (
        "3.0 54.0 -200\n3.1 54.0 -201\n3.0 54.1 -200\n3.1 54.1 -201\n",
        "file: survey.xyz, crs: EPSG:32631",
        "model.yaml:5: coordinate system is in degrees where metres are needed",
    ),
    "hole": (
        GRID_FILE.replace("1001 2001 -201\n", ""),
        "file: survey.xyz, crs: metres, origin: [1000, 2000]",
        "model.yaml:5: 1 of 4 points of the depth grid have no depth in survey.xyz, the first at x 1 m, y 1 m",
    ),
}


@pytest.mark.parametrize("name", RASTERS)
def test_rasters_of_native_files(tmp_path, name):
    text, seabed, message = RASTERS[name]
    (tmp_path / "survey.xyz").write_text(text)
    start, end = NATIVE.index("  bathymetry:"), NATIVE.index("line_types:")
    path = tmp_path / "model.yaml"
    path.write_text(f"{NATIVE[:start]}  bathymetry: {{{seabed}}}\n{NATIVE[end:]}")
    with pytest.raises(ModelError, match=message) as caught:
        read(path)
    assert caught.value.problems[0].remedy


def test_a_line_that_lies_off_the_grid_at_the_end_is_told(tmp_path):
    points = [free(1, -600.0, 40.0, -120.0), coupled(2, -450.0, 0.0, -10.0)]
    model = mooring(CHAIN, points, [line(1, 1, 2, ("chain", 250.0, 5))], water_depth=120.0, bathymetry=GRID)
    pulled = Motion.from_harmonics(4.0, ramp=2.0, sway=(0.1, 4.0))
    settings = {"motion": pulled, "duration": 1.0, "dt_out": 0.5, "start": "as-given"}
    with warnings.catch_warnings():
        warnings.simplefilter("error", ModelWarning)
        moorage.simulate(model, **settings)
    narrow = dataclasses.replace(GRID, y=(-50.0, 10.0))
    model = dataclasses.replace(model, environment=dataclasses.replace(model.environment, bathymetry=narrow))
    for output, save in ((None, "all"), (tmp_path / "run.nc", "all"), (None, "tensions")):
        with pytest.warns(ModelWarning) as told:
            moorage.simulate(model, output=output, save=save, **settings).close()
        words = [str(warning.message) for warning in told]
        assert any(text.startswith("point 1 is outside") for text in words)
        assert any(text.startswith("line 1 lies outside the depth grid with") for text in words)
