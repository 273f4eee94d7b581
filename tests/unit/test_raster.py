"""Rasters onto depth grids in the model's axes: every format, turning, resampling, holes, coordinate systems."""

import builtins
import dataclasses
import warnings

import netCDF4
import numpy as np
import pytest

import moorage
from moorage.errors import ModelError
from moorage.io import raster, raster_files
from moorage.model import Bathymetry

EAST, NORTH = 500_000.0, 6_000_000.0
X, Y = EAST + 10.0 * np.arange(9), NORTH + 20.0 * np.arange(7)  # centres of cells
UTM = "EPSG:32631"
MODEL = """
moorage: 1
environment:
  water_depth: 100
  bathymetry: {SEABED}
line_types:
  chain: {diameter: 0.1, mass_per_length: 100, axial_stiffness: 1.0e8}
points:
  - {id: 1, kind: fixed, position: [10, 20, seabed]}
  - {id: 2, kind: coupled, position: [40, 40, -20]}
lines:
  - {id: 1, end_a: 1, end_b: 2, sections: [{line_type: chain, length: 110, segments: 4}]}
"""


def plane(x, y):
    """Height of the test's seabed, whose axes must not be changed round."""
    return -100.0 + 0.1 * (x - EAST) - 0.03 * (y - NORTH)


Z = plane(X[:, None], Y[None])


def esri(path, z=Z, header="xllcorner 499995\nyllcorner 5999990", nodata=-9999):
    rows = "\n".join(" ".join(f"{value:.6f}" for value in row) for row in z.T[::-1])
    path.write_text(f"ncols {len(X)}\nnrows {len(Y)}\n{header}\ndx 10\ndy 20\nNODATA_value {nodata}\n{rows}\n")
    return path


def xyz(path, z=Z, x=X, y=Y):
    rows = [f"{a},{b},{z[i, j]:.6f}" for j, b in enumerate(y) for i, a in enumerate(x) if np.isfinite(z[i, j])]
    path.write_text("easting,northing,height\n" + "\n".join(rows))
    return path


def netcdf(path, z=Z, x=X, y=Y, units="m", name="elevation", flip=False, **attributes):
    with netCDF4.Dataset(path, "w") as file:
        for axis, values in (("lon" if units != "m" else "x", x), ("lat" if units != "m" else "y", y)):
            file.createDimension(axis, len(values))
            variable = file.createVariable(axis, "f8", (axis,))
            variable[:] = values[::-1] if flip and axis in "y lat" else values
            variable.units = units
        dims = ("lat", "lon") if units != "m" else ("y", "x")
        variable = file.createVariable(name, "f4", dims, fill_value=-32767.0)
        variable[:] = np.ma.masked_invalid(z.T[::-1] if flip else z.T)
        variable.setncatts(attributes)
    return path


def geotiff(path, z=Z, crs=UTM, nodata=-9999.0):
    rasterio = pytest.importorskip("rasterio", reason="GeoTIFF needs rasterio, of the extra geo")
    to = rasterio.Affine(10.0, 0.0, EAST - 5.0, 0.0, -20.0, NORTH + 130.0)
    shape = {"width": len(X), "height": len(Y), "count": 1, "dtype": "float32", "transform": to}
    with rasterio.open(path, "w", driver="GTiff", crs=crs, nodata=nodata, **shape) as file:
        file.write(np.where(np.isfinite(z), z, nodata).T[::-1].astype("float32"), 1)
    return path


WRITERS = {"a.asc": esri, "a.xyz": xyz, "a.csv": xyz, "a.nc": netcdf, "a.tif": geotiff}
OPTIONS = {"origin": (EAST, NORTH), "crs": UTM}


@pytest.mark.parametrize("name", WRITERS)
def test_every_format_gives_the_same_seabed(tmp_path, name):
    grid = moorage.read_bathymetry(WRITERS[name](tmp_path / name), **OPTIONS, spacing=10.0)
    np.testing.assert_allclose(grid.x, 10.0 * np.arange(9))
    np.testing.assert_allclose(grid.y, 10.0 * np.arange(13))
    expected = -plane(EAST + np.array(grid.x)[:, None], NORTH + np.array(grid.y)[None])
    np.testing.assert_allclose(grid.depth, expected, atol=2e-5)
    assert grid.resampling.cells == Z.size
    assert grid.resampling.largest < 2e-5
    assert grid.file == name


def test_centres_of_cells_may_be_given(tmp_path):
    path = esri(tmp_path / "a.asc", header=f"xllcenter {EAST}\nyllcenter {NORTH}")
    corner = raster_files.read_raster(esri(tmp_path / "b.asc"))
    for a, b in zip(raster_files.read_raster(path)[:3], corner[:3], strict=True):
        np.testing.assert_array_equal(a, b)


def test_netcdf_of_depths_and_of_falling_axes(tmp_path):
    up = raster_files.read_raster(netcdf(tmp_path / "up.nc", flip=True))
    named = raster_files.read_raster(netcdf(tmp_path / "named.nc", -Z, name="depth"))
    said = raster_files.read_raster(netcdf(tmp_path / "said.nc", -Z, name="z", positive="down"))
    for other in (up, named, said):
        np.testing.assert_allclose(other.z, Z, atol=1e-4)
        np.testing.assert_array_equal(other.y, Y)


@pytest.mark.parametrize("heading", [0.0, 90.0, 180.0, 270.0, 37.0, -450.0])
def test_axes_of_the_model(tmp_path, heading):
    middle = (EAST + 40.0, NORTH + 60.0)
    grid = moorage.read_bathymetry(esri(tmp_path / "a.asc"), origin=middle, heading=heading, crs=UTM, spacing=2.0)
    h = np.deg2rad(heading)
    for x, y in ((0.0, 0.0), (10.0, 5.0), (-8.0, 3.0)):
        east = middle[0] + x * np.sin(h) + y * np.sin(h - 0.5 * np.pi)  # y points 90 degrees to the left of x
        north = middle[1] + x * np.cos(h) + y * np.cos(h - 0.5 * np.pi)
        assert grid.depth_at(x, y) == pytest.approx(-plane(east, north), abs=1e-4)
    if heading % 90.0 == 0.0:
        assert np.ptp(grid.x) == pytest.approx(80.0 if heading in (90.0, 270.0, -450.0) else 120.0)


def test_error_of_resampling(tmp_path):
    wavy = -100.0 + np.cos(np.pi * np.arange(9))[:, None] + np.zeros(len(Y))
    fine = moorage.read_bathymetry(esri(tmp_path / "a.asc", wavy), **OPTIONS, spacing=5.0)
    coarse = moorage.read_bathymetry(esri(tmp_path / "a.asc", wavy), **OPTIONS, spacing=20.0)
    assert fine.resampling.largest < 1e-6
    assert coarse.resampling.largest == pytest.approx(2.0)  # every other cell is passed over
    assert coarse.resampling.rms == pytest.approx(2.0 * np.sqrt(4.0 / 9.0))
    assert str(coarse.resampling) == "resampled to 20 m: 63 cells of the raster differ by at most 2 m, rms 1.3 m"


def test_spacing_and_extent(tmp_path):
    path = esri(tmp_path / "a.asc")
    assert np.diff(moorage.read_bathymetry(path, **OPTIONS).x)[0] == 10.0
    grid = moorage.read_bathymetry(path, **OPTIONS, extent=(10.0, 50.0, 20.0, 80.0), spacing=20.0, smooth=True)
    assert (grid.x, grid.y, grid.smooth) == ((10.0, 30.0, 50.0), (20.0, 40.0, 60.0, 80.0), True)


def test_water_level(tmp_path):
    path = esri(tmp_path / "a.asc")
    assert moorage.read_bathymetry(path, **OPTIONS, water_level=1.5).depth_at(0.0, 0.0) == pytest.approx(101.5)


def holed():
    z = Z.copy()
    z[4, 3] = np.nan
    return z


@pytest.mark.parametrize("name", WRITERS)
def test_holes_are_an_error_unless_filled(tmp_path, name):
    path = WRITERS[name](tmp_path / name, holed())
    with pytest.raises(ModelError, match=r"have no depth in a.*, the first at x .*\n.*fill: nearest"):
        moorage.read_bathymetry(path, **OPTIONS, spacing=10.0)
    near = moorage.read_bathymetry(path, **OPTIONS, fill="nearest", spacing=10.0)
    neighbours = np.array([-Z[3, 3], -Z[5, 3], -Z[4, 2], -Z[4, 4]])
    assert np.abs(neighbours - near.depth_at(40.0, 60.0)).min() < 2e-5  # files hold single precision
    assert moorage.read_bathymetry(path, **OPTIONS, fill=50.0, spacing=10.0).depth_at(40.0, 60.0) == 50.0
    assert near.resampling.cells == Z.size - 1


def test_what_the_raster_does_not_cover(tmp_path):
    path, wide = esri(tmp_path / "a.asc"), (-100.0, 80.0, 0.0, 120.0)
    with pytest.raises(ModelError, match="have no depth"):
        moorage.read_bathymetry(path, **OPTIONS, extent=wide)
    assert moorage.read_bathymetry(path, **OPTIONS, extent=wide, fill=70.0).depth_at(-90.0, 0.0) == 70.0
    edge = moorage.read_bathymetry(path, **OPTIONS, extent=wide, fill="nearest")
    assert edge.depth_at(-90.0, 40.0) == pytest.approx(-plane(EAST, NORTH + 40.0))


def test_geographic_raster_needs_a_system_in_metres(tmp_path):
    path = netcdf(
        tmp_path / "gebco.nc", x=3.0 + 0.004 * np.arange(9), y=54.0 + 0.004 * np.arange(7), units="degrees_east"
    )
    with pytest.raises(ModelError, match=r"is in degrees where metres are needed.*\n.*give crs, .*EPSG:32631"):
        moorage.read_bathymetry(path)
    with pytest.raises(ModelError, match="is in degrees where metres are needed"):
        moorage.read_bathymetry(path, crs="EPSG:4326")
    pyproj = pytest.importorskip("pyproj", reason="coordinate systems need pyproj, of the extra geo")
    origin = pyproj.Transformer.from_crs("EPSG:4326", UTM, always_xy=True).transform(3.016, 54.012)
    grid = moorage.read_bathymetry(path, origin=origin, crs=UTM, spacing=50.0)
    assert grid.depth_at(0.0, 0.0) == pytest.approx(-Z[4, 3], abs=1e-3)
    assert grid.resampling.largest < 0.1


def test_degrees_without_a_name_show_in_the_numbers(tmp_path):
    path = xyz(tmp_path / "a.xyz", x=3.0 + 0.004 * np.arange(9), y=54.0 + 0.004 * np.arange(7))
    with pytest.raises(ModelError, match=r"is in degrees where metres are needed.*\n.*file_crs, that of the file"):
        moorage.read_bathymetry(path, crs=UTM)


def test_missing_system(tmp_path):
    path = esri(tmp_path / "a.asc")
    with pytest.raises(ModelError, match=r"raster has no coordinate system\n.*crs: metres"):
        moorage.read_bathymetry(path, origin=(EAST, NORTH))
    assert moorage.read_bathymetry(path, origin=(EAST, NORTH), crs="metres").depth_at(0.0, 0.0) == pytest.approx(100.0)


def test_systems_that_do_not_go_together(tmp_path):
    pytest.importorskip("pyproj", reason="coordinate systems need pyproj, of the extra geo")
    path = esri(tmp_path / "a.asc")
    with pytest.raises(ModelError, match=r"coordinate system is not known.*\n.*EPSG"):
        moorage.read_bathymetry(path, crs="UTM somewhere")
    with pytest.raises(ModelError, match="a grid of its own has no place in EPSG:32631"):
        moorage.read_bathymetry(path, crs="metres", file_crs=UTM)
    with pytest.raises(ModelError, match="has the unit US survey foot where metres are needed"):
        moorage.read_bathymetry(path, crs="EPSG:2263")


def test_system_beside_an_esri_grid(tmp_path):
    pyproj = pytest.importorskip("pyproj", reason="coordinate systems need pyproj, of the extra geo")
    path = esri(tmp_path / "a.asc")
    path.with_suffix(".prj").write_text(pyproj.CRS(UTM).to_wkt("WKT1_ESRI"))
    assert moorage.read_bathymetry(path, origin=(EAST, NORTH)).depth_at(20.0, 40.0) == pytest.approx(-Z[2, 2])
    turned = moorage.read_bathymetry(path, origin=(EAST, NORTH), crs=UTM, fill="nearest")
    assert turned.depth_at(20.0, 40.0) == pytest.approx(-Z[2, 2], abs=1e-3)


@pytest.mark.parametrize("name", ["a.asc", "a.xyz", "a.nc"])
def test_plain_formats_need_no_extra(tmp_path, monkeypatch, name):
    path, real = WRITERS[name](tmp_path / name), builtins.__import__

    def absent(module, *rest):
        if module.partition(".")[0] in ("rasterio", "pyproj"):
            raise ImportError(module)
        return real(module, *rest)

    monkeypatch.setattr(builtins, "__import__", absent)
    assert moorage.read_bathymetry(path, **OPTIONS).depth_at(0.0, 0.0) == pytest.approx(100.0)
    with pytest.raises(ModelError, match=r"needs pyproj\n.*pip install moorage\[geo\]"):
        moorage.read_bathymetry(path, crs=UTM, file_crs="EPSG:32632")
    (tmp_path / "a.tif").write_bytes(b"II*\0")
    with pytest.raises(ModelError, match=r"GeoTIFF needs rasterio\n.*pip install moorage\[geo\]"):
        moorage.read_bathymetry(tmp_path / "a.tif")


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.las", "x", r"kind of the raster is not known by its name"),
        ("a.asc", "ncols 2\nnrows two\n", r"a.asc:2: nrows of the raster is not a number"),
        ("a.asc", "ncols 2\nnrows 2\ncellsize 1\nxllcorner 0\n1 2\n3 4\n", "header of the raster lacks yllcorner"),
        ("a.asc", "ncols 2\nxllcorner 0\n1 2\n", "lacks ncols, nrows or cellsize"),
        ("a.asc", "ncols 2\nnrows 2\ncellsize 1\nxllcorner 0\nyllcorner 0\n1 2\n3\n", "raster has 3 values"),
        ("a.asc", "ncols 2\nnrows 2\ncellsize 1\nxllcorner 0\nyllcorner 0\n1 2\n3 x\n", "a.asc:7: row of the raster"),
        ("a.xyz", "east north height\n", "raster has no rows of x, y and z"),
        ("a.xyz", "0 0 -1\n1 0 -1\n0 1\n", "a.xyz:3: row of the raster is not x, y and z"),
        ("a.xyz", "0 0 -1\n1 0 -1\n0 1 -1\n0 1 -1\n", "point of the raster is given twice"),
        ("a.xyz", "0 0 -1\n1 0 -1\n", "raster has 2 by 1 cells"),
        ("a.xyz", "\n".join(f"{k} {k * k} -1" for k in range(9)), "9 points of the raster are scattered"),
        ("a.nc", "text", "NetCDF cannot be read"),
    ],
)
def test_files_that_are_no_rasters(tmp_path, name, text, message):
    (tmp_path / name).write_text(text)
    with pytest.raises(ModelError, match=message):
        moorage.read_bathymetry(tmp_path / name, crs="metres")


def test_files_that_are_not_there(tmp_path):
    with pytest.raises(ModelError, match=r"raster not found: tried .*none.tif"):
        moorage.read_bathymetry(tmp_path / "none.tif")


def test_netcdf_without_or_with_many_grids(tmp_path):
    with netCDF4.Dataset(tmp_path / "empty.nc", "w") as file:
        file.createDimension("x", 2)
    with pytest.raises(ModelError, match="has no heights over two axes"):
        moorage.read_bathymetry(tmp_path / "empty.nc")
    path = netcdf(tmp_path / "two.nc")
    with netCDF4.Dataset(path, "a") as file:
        file.createVariable("depth", "f4", ("y", "x"))
    with pytest.raises(ModelError, match="several grids: elevation, depth"):
        moorage.read_bathymetry(path)


def test_turned_geotiff(tmp_path):
    rasterio = pytest.importorskip("rasterio", reason="GeoTIFF needs rasterio, of the extra geo")
    to = rasterio.Affine(10.0, 1.0, EAST, 1.0, -10.0, NORTH)
    with rasterio.open(
        tmp_path / "a.tif", "w", driver="GTiff", width=3, height=3, count=1, dtype="float32", transform=to
    ):
        pass
    with pytest.raises(ModelError, match="turned against its axes"):
        moorage.read_bathymetry(tmp_path / "a.tif", crs=UTM)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"spacing": 0.0}, "spacing of the depth grid must be positive"),
        ({"spacing": 500.0}, "smaller than its spacing"),
        ({"spacing": 0.001}, "depth grid would have"),
    ],
)
def test_impossible_grids(tmp_path, options, message):
    with pytest.raises(ModelError, match=message):
        moorage.read_bathymetry(esri(tmp_path / "a.asc"), **OPTIONS, **options)


def test_bilinear_and_the_model_agree():
    rng = np.random.default_rng(4)
    x, y, z = np.array([0.0, 1.0, 4.0]), np.array([0.0, 2.0, 3.0, 7.0]), rng.normal(-50.0, 5.0, (3, 4))
    grid = Bathymetry(tuple(x), tuple(y), tuple(map(tuple, -z)))
    places = rng.uniform((0.0, 0.0), (4.0, 7.0), (50, 2))
    level = raster.bilinear(raster_files.Raster(x, y, z, "", False), *places.T)
    np.testing.assert_allclose(level, [-grid.depth_at(*place) for place in places])


def test_native_file(tmp_path):
    esri(tmp_path / "survey.asc")
    seabed = f"{{file: survey.asc, origin: [{EAST}, {NORTH}], heading: 90, spacing: 10, crs: {UTM}, smooth: true}}"
    (tmp_path / "model.yaml").write_text(MODEL.replace("{SEABED}", seabed))
    model = moorage.read(tmp_path / "model.yaml")
    grid = moorage.read_bathymetry(tmp_path / "survey.asc", **OPTIONS, spacing=10.0, smooth=True)
    assert model.environment.bathymetry == grid
    assert model.environment.bathymetry.source.line == 5
    assert model.points[0].position[2] == pytest.approx(-grid.depth_at(10.0, 20.0))
    moorage.io.write_native(model, tmp_path / "again.yaml")  # writes the grid out
    again = moorage.read(tmp_path / "again.yaml")
    assert dataclasses.replace(again.environment.bathymetry, file="") == dataclasses.replace(grid, file="")


@pytest.mark.parametrize(
    ("seabed", "message"),
    [
        ("{file: none.asc}", r"model.yaml:5: raster not found: tried .*none.asc"),
        ("{file: survey.asc}", "model.yaml:5: raster has no coordinate system"),
        ("{file: survey.asc, origin: [1]}", r"model.yaml:5: origin of the bathymetry has 1 values"),
        (
            "{file: survey.asc, fill: some}",
            "model.yaml:5: fill of bathymetry of environment of the model is not a number",
        ),
        ("{file: survey.asc, x: [0, 1]}", "key of bathymetry of environment of the model is not known"),
        ("{file: survey.asc, crs: metres, spacing: -1}", "model.yaml:5: spacing of the depth grid must be positive"),
    ],
)
def test_errors_of_a_native_file(tmp_path, seabed, message):
    esri(tmp_path / "survey.asc")
    (tmp_path / "model.yaml").write_text(MODEL.replace("{SEABED}", seabed))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(ModelError, match=message):
            moorage.read(tmp_path / "model.yaml")


def test_fill_from_python_is_a_depth_or_nearest(tmp_path):
    with pytest.raises(ModelError, match=r"fill of the depth grid is not known \(read: 'linear'\)"):
        moorage.read_bathymetry(esri(tmp_path / "a.asc"), **OPTIONS, fill="linear")
