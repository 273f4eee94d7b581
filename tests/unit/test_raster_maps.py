"""Maps of friction and stiffness from rasters: the same places as the depths, in every format, and what is refused."""

import numpy as np
import pytest
from test_raster import EAST, NORTH, OPTIONS, WRITERS, X, Y, xyz

import moorage
from moorage.errors import ModelError
from moorage.io import read, write_native
from moorage.model import FrictionMap, StiffnessMap

MU = 0.3 + 0.002 * (X[:, None] - EAST) + 0.001 * (Y[None] - NORTH)
MODEL = """
moorage: 1
environment:
  water_depth: 100
  {WHAT}
line_types:
  chain: {diameter: 0.1, mass_per_length: 100, axial_stiffness: 1.0e8}
points:
  - {id: 1, kind: fixed, position: [10, 20, seabed]}
  - {id: 2, kind: coupled, position: [40, 40, -20]}
lines:
  - {id: 1, end_a: 1, end_b: 2, sections: [{line_type: chain, length: 110, segments: 4}]}
"""
PLACE = "crs: EPSG:32631, origin: [500000, 6000000]"


@pytest.mark.parametrize("name", WRITERS)
def test_every_format_gives_the_same_coefficients(tmp_path, name):
    pytest.importorskip("pyproj", reason="coordinate systems need pyproj, of the extra geo")
    path = WRITERS[name](tmp_path / name, MU)
    grid = moorage.read_friction_map(path, file_crs="EPSG:32631", **OPTIONS)
    assert len(grid.x) > 4
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    assert np.array(grid.axial) == pytest.approx(0.3 + 0.002 * x + 0.001 * y, abs=1e-6)
    assert grid.transverse == grid.axial


def test_axes_turn_as_those_of_the_depths(tmp_path):
    """x to the north: y goes to the west."""
    path = xyz(tmp_path / "mu.xyz", MU)
    grid = moorage.read_friction_map(
        path,
        crs="metres",
        origin=(EAST + 40.0, NORTH + 60.0),
        heading=0.0,
        spacing=10.0,
        extent=(-20.0, 30.0, -30.0, 40.0),
    )
    x, y = np.meshgrid(grid.x, grid.y, indexing="ij")
    assert np.array(grid.axial) == pytest.approx(0.3 + 0.002 * (40.0 - y) + 0.001 * (60.0 + x), abs=1e-9)


def test_both_coefficients_lie_on_one_grid(tmp_path):
    """The second raster is wider and has other cells."""
    along = xyz(tmp_path / "along.xyz", MU)
    x, y = np.arange(EAST - 35.0, EAST + 130.0, 15.0), np.arange(NORTH - 15.0, NORTH + 150.0, 15.0)
    across = xyz(tmp_path / "across.xyz", 0.8 + 0.001 * (x[:, None] - EAST) + 0.0 * y, x, y)
    grid = moorage.read_friction_map(along, across, crs="metres", origin=(EAST, NORTH))
    assert np.array(grid.axial).shape == np.array(grid.transverse).shape == (len(grid.x), len(grid.y))
    assert np.array(grid.transverse)[:, 2] == pytest.approx(0.8 + 0.001 * np.array(grid.x), abs=1e-9)


def test_native_files_name_them(tmp_path):
    pytest.importorskip("pyproj", reason="coordinate systems need pyproj, of the extra geo")
    xyz(tmp_path / "mu.xyz", MU)
    xyz(tmp_path / "kb.xyz", 1e6 * MU)
    path = tmp_path / "model.yaml"
    where = f"{PLACE}, file_crs: EPSG:32631"
    what = f"""friction: {{map: {{axial_file: mu.xyz, {where}}}}}
  seabed_stiffness_map: {{file: kb.xyz, {where}, spacing: 20}}"""
    path.write_text(MODEL.replace("{WHAT}", what))
    model = read(path)
    mu, kb = model.environment.friction.map, model.environment.seabed_stiffness_map
    assert isinstance(mu, FrictionMap)
    assert isinstance(kb, StiffnessMap)
    assert kb.x[1] - kb.x[0] == pytest.approx(20.0)
    assert kb.stiffness[1][2] == pytest.approx(1e6 * (0.3 + 0.002 * kb.x[1] + 0.001 * kb.y[2]), rel=1e-6)
    write_native(model, tmp_path / "again.yaml")
    assert read(tmp_path / "again.yaml").environment == model.environment


HOLE = np.where((X[:, None] == EAST + 40.0) & (Y[None] == NORTH + 60.0), np.nan, MU)


def test_cells_without_a_value_are_an_error_unless_filled(tmp_path):
    path = xyz(tmp_path / "mu.xyz", HOLE)
    place = {"crs": "metres", "origin": (EAST, NORTH)}
    with pytest.raises(
        ModelError, match=r"points of the friction map have no coefficient in mu.xyz, the first at x 40 m"
    ):
        moorage.read_friction_map(path, **place)
    assert np.array(moorage.read_friction_map(path, fill=0.9, **place).axial).max() == 0.9
    nearest = np.array(moorage.read_friction_map(path, fill="nearest", **place).axial)
    assert 0.4 < nearest[4, 6] < 0.5


CASES = {
    "no system": ("friction: {map: {axial_file: mu.xyz}}", "model.yaml:5: raster has no coordinate system"),
    "not there": (f"friction: {{map: {{axial_file: no.xyz, {PLACE}}}}}", "model.yaml:5: raster not found"),
    "one origin": (
        "seabed_stiffness_map: {file: mu.xyz, crs: metres, origin: [1]}",
        "model.yaml:5: origin of the stiffness map has 1 values",
    ),
    "negative": (
        "friction: {map: {axial_file: below.xyz, crs: metres, origin: [500000, 6000000]}}",
        "must not be negative",
    ),
    "off it": (
        "seabed_stiffness_map: {file: mu.xyz, crs: metres, extent: [0, 50, 0, 50]}",
        "points of the stiffness map have no stiffness in mu.xyz",
    ),
    "other keys": ("seabed_stiffness_map: {file: mu.xyz, x: [0, 1]}", "key of seabed_stiffness_map .* is not known"),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_refused(tmp_path, name):
    what, message = CASES[name]
    xyz(tmp_path / "mu.xyz", MU)
    xyz(tmp_path / "below.xyz", MU - 1.0)
    path = tmp_path / "model.yaml"
    path.write_text(MODEL.replace("{WHAT}", what))
    with pytest.raises(ModelError, match=message) as caught:
        read(path)
    assert all(problem.remedy for problem in caught.value.problems)
