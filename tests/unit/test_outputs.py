"""MoorDyn's channels: which numbers they are."""

import numpy as np
import pytest

import moorage
from moorage.results.channels import watch_list

DECK = """\
A leg that splits at a float
---------------------- LINE TYPES ----------------------
TypeName   Diam     Mass/m   EA         BA/-zeta   EI        Cd    Ca    CdAx   CaAx
(name)     (m)      (kg/m)   (N)        (N-s/-)    (N-m^2)   (-)   (-)   (-)    (-)
chain      0.0766   113.35   7.536e8    -0.8       0         2.0   0.8   0.4    0.25
rope       0.15     22.0     9.0e7      -0.8       0         1.2   1.0   0.1    0.0
---------------------- POINTS --------------------------
ID    Attachment   X      Y     Z       Mass   Volume   CdA    Ca
(#)   (word)       (m)    (m)   (m)     (kg)   (m^3)    (m^2)  (-)
1     Fixed        -600   0     -120    0      0        0      0
2     Free         -60    0     -30     2000   3.0      1.5    0.5
3     Coupled      -10    15    -8      0      0        0      0
4     Coupled      -10    -15   -8      0      0        0      0
---------------------- LINES ---------------------------
ID    LineType   AttachA   AttachB   UnstrLen   NumSegs   LineOutputs
(#)   (name)     (ID)      (ID)      (m)        (-)       (-)
7     chain      1         2         560        20        -
2     rope       2         3         57.8       6         -
3     rope       2         4         57.8       6         -
---------------------- OPTIONS -------------------------
120.0    WtrDpth   water depth (m)
---------------------- OUTPUTS -------------------------
FairTen7 AnchTen7 LINE7TENA LINE7TENB L7N10T LINE7N10PX L7N10VZ LINE7N10FX LINE7NBPZ LINE7NAT LINE7PX LINE2NATEN
POINT2PZ CON2VX POINT2AX P3AX POINT3FX P3FZ POINT3T POINT2TEN
---------------------- end -----------------------------
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    path = tmp_path_factory.mktemp("outputs") / "bridle.dat"
    path.write_text(DECK)
    model = moorage.read(path)
    motion = moorage.Motion.from_harmonics(12.0, ramp=6.0, surge=(1.5, 8.0), heave=(0.5, 6.0))
    return model, moorage.simulate(model, duration=10.0, motion=motion)


def test_only_what_is_needed_is_recorded(run):
    assert watch_list(run[0]) == ((0, 10), (0, 20), (0, 0))


def test_names_are_those_that_moordyn_prints(run):
    model, ds = run
    assert [output.name for output in model.outputs] == [name for name in ds.data_vars if name.isupper()]
    assert "FAIRTEN7" in ds


def test_kinematics_are_those_of_the_nodes_and_points(run):
    _, ds = run
    line = moorage.line(ds, 7)
    for name, node, axis in (("LINE7N10PX", 10, "x"), ("LINE7NBPZ", 20, "z"), ("LINE7PX", 0, "x")):
        np.testing.assert_allclose(ds[name], line["node_position"].isel(node=node).sel(xyz=axis), atol=1e-12)
    np.testing.assert_allclose(ds["L7N10VZ"], line["node_velocity"].isel(node=10).sel(xyz="z"), atol=1e-12)
    np.testing.assert_allclose(ds["POINT2PZ"], ds["point_position"].sel(point=2, xyz="z"))
    np.testing.assert_allclose(ds["CON2VX"], ds["point_velocity"].sel(point=2, xyz="x"))
    assert ds["POINT2PZ"].attrs == {"units": "m", "long_name": "position of point 2, z"}


def test_end_tension_is_the_node_force_without_inertia(run):
    _, ds = run
    np.testing.assert_array_equal(ds["FAIRTEN7"], ds["LINE7TENB"])
    np.testing.assert_array_equal(ds["ANCHTEN7"], ds["LINE7TENA"])
    np.testing.assert_array_equal(ds["ANCHTEN7"], ds["LINE7NAT"])
    at_rest, moving = ds.isel(time=0), ds.isel(time=slice(20, None))
    assert at_rest["FAIRTEN7"].item() == pytest.approx(at_rest["fairlead_tension"].sel(line=7).item(), rel=1e-6)
    difference = abs(moving["FAIRTEN7"] - moving["fairlead_tension"].sel(line=7))
    assert difference.max() > 1.0  # the inertia of half a segment


def test_inner_tension_is_the_mean_of_its_neighbours(run):
    _, ds = run
    neighbours = moorage.line(ds, 7)["segment_tension"].isel(segment=[9, 10]).mean("segment")
    np.testing.assert_allclose(ds["L7N10T"], neighbours, rtol=2e-3)  # MoorDyn averages vectors
    assert abs(ds["LINE7N10FX"].values[0]) < 1.0  # no net force at rest


def test_a_points_force_is_that_of_lines_and_its_own(run):
    _, ds = run
    # a held point without properties feels its lines only; inertia (the motion's spline has a little) is left out
    at_rest = ds.isel(time=0)
    expected = at_rest["point_force"].sel(point=3).values
    np.testing.assert_allclose([at_rest["POINT3FX"], at_rest["P3FZ"]], expected[[0, 2]], rtol=1e-5)
    assert at_rest["POINT3T"].item() == pytest.approx(np.linalg.norm(expected), rel=1e-5)
    # a free one is in equilibrium, with its weight and buoyancy
    assert at_rest["POINT2TEN"].item() < 1.0
    own = 9.80665 * (1025.0 * 3.0 - 2000.0)
    assert at_rest["point_force"].sel(point=2, xyz="z").item() == pytest.approx(-own, rel=1e-4)


def test_accelerations_of_held_points_are_those_of_the_motion(run):
    _, ds = run
    velocity = ds["point_velocity"].sel(point=3, xyz="x").values
    np.testing.assert_allclose(ds["P3AX"].values[1:-1], np.gradient(velocity, 0.1)[1:-1], atol=0.02)
    assert np.abs(ds["POINT2AX"].values).max() > 0.1


def test_statics_has_the_channels_too(run):
    model, ds = run
    eq = moorage.solve_statics(model)
    assert eq["FAIRTEN7"].item() == pytest.approx(ds["FAIRTEN7"].values[0], rel=1e-6)
