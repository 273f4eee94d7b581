"""Currents over depth, time and place: from MoorDyn's files, NetCDF and the native file, and what is refused."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
import xarray as xr
from native_text import CHAIN as TEXT

from moorage.errors import ModelError, ModelWarning, UnsupportedError
from moorage.io import convert, read
from moorage.model import Current, CurrentGrid
from moorage.model.unbuilt import refuse_unbuilt
from moorage.model.water_checks import doubtful_current
from moorage.results import warn_of_short_current


def native(tmp_path, what):
    path = tmp_path / "model.yaml"
    path.write_text(TEXT.format(what=what))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return read(path)


# --- NetCDF ---------------------------------------------------------------------------------------------------------

LAT, LON = np.array([60.1, 60.0, 59.9]), np.array([4.9, 5.0, 5.1])
DEPTH, HOURS = np.array([0.5, 20.0, 99.0]), np.array([0.0, 6.0, 12.0])


def flow(t, z, lat, lon):
    """East, linear in all that the grid has; the north is a tenth of it the other way."""
    return 0.1 + 0.01 * t + 0.001 * z + 0.2 * (lat - 60.0) + 0.5 * (lon - 5.0)


def ocean(**change):
    """Return a dataset as ocean models write it: depth down, latitude falling, the deepest level missing in places."""
    values = flow(HOURS[:, None, None, None], -DEPTH[:, None, None], LAT[:, None], LON)
    values[:, 2, 0, 0] = np.nan
    dims = ("time", "depth", "latitude", "longitude")
    speed = {"units": "m s-1"}
    ds = xr.Dataset(
        {
            "uo": (dims, values, speed | {"standard_name": "eastward_sea_water_velocity"}),
            "vo": (dims, -0.1 * values, speed),
        },
        {"time": HOURS, "depth": DEPTH, "latitude": LAT, "longitude": LON},
    )
    ds["time"].attrs["units"] = "hours since 2020-01-31 06:00:00"
    ds["depth"].attrs.update(units="m", positive="down")
    ds["latitude"].attrs["units"], ds["longitude"].attrs["units"] = "degrees_north", "degrees_east"
    return ds


def of_file(tmp_path, ds, more=", origin: [5.0, 60.0]"):
    ds.to_netcdf(tmp_path / "ocean.nc")
    return native(tmp_path, f"current: {{file: ocean.nc{more}}}").environment.current


@pytest.mark.parametrize("heading", [90.0, 0.0, 215.0])
def test_an_ocean_models_file(tmp_path, heading):
    """East and north metres of a sphere of 6371 km; velocities turn with the axes."""
    current = of_file(tmp_path, ocean(), f", origin: [5.0, 60.0], heading: {heading}")
    assert isinstance(current, CurrentGrid)
    assert current.shape == (3, 3, 3, 3)
    east, north, z, t = 1500.0, -4000.0, -13.0, 5 * 3600.0
    degree = np.deg2rad(6.371e6)
    u = flow(5.0, z, 60.0 + north / degree, 5.0 + east / degree / np.cos(np.deg2rad(60.0)))
    b = np.deg2rad(heading)
    x_axis, y_axis = np.array([np.sin(b), np.cos(b)]), np.array([-np.cos(b), np.sin(b)])
    place, speed = np.array([east, north]), np.array([u, -0.1 * u])
    found = current.at(t, (place @ x_axis, place @ y_axis, z))
    assert found == pytest.approx([speed @ x_axis, speed @ y_axis, 0.0], abs=1e-12)


def test_missing_levels_are_those_above_them(tmp_path):
    current = of_file(tmp_path, ocean())
    corner = current.velocity[0, 0, -1]
    assert corner[0] == pytest.approx(corner[1])
    assert corner[2] != pytest.approx(corner[1])
    ds = ocean()
    ds["uo"][:, :, 1, 1] = ds["vo"][:, :, 1, 1] = np.nan
    assert not of_file(tmp_path, ds).velocity[:, 1, 1].any()


def test_start(tmp_path):
    whole = of_file(tmp_path, ocean())
    later = of_file(tmp_path, ocean(), ", origin: [5.0, 60.0], start: 2020-01-31T09:00")
    assert later.at(0.0, (0.0, 0.0, -5.0)) == pytest.approx(whole.at(3 * 3600.0, (0.0, 0.0, -5.0)))


def test_a_file_of_one_place_and_time_is_a_profile(tmp_path):
    current = of_file(tmp_path, ocean().isel(time=0, latitude=1, longitude=1), "")
    assert isinstance(current, Current)
    assert current.z == (-99.0, -20.0, -0.5)
    series = of_file(tmp_path, ocean().isel(latitude=[1], longitude=[1]), "")
    assert isinstance(series, CurrentGrid)
    assert series.shape == (3, 1, 1, 3)
    assert series.x == series.y == (0.0,)


def test_metres(tmp_path):
    ds = ocean().rename(latitude="y", longitude="x")
    ds = ds.assign_coords(x=[-500.0, 0.0, 700.0], y=[1000.0, 0.0, -900.0])
    ds["x"].attrs["units"] = ds["y"].attrs["units"] = "m"
    assert of_file(tmp_path, ds, "").x == (-500.0, 0.0, 700.0)
    assert of_file(tmp_path, ds, ", origin: [100, 50]").y == (-950.0, -50.0, 950.0)


def without(name, key):
    ds = ocean()
    del ds[name].attrs[key]
    return ds


BAD = {
    "no units of velocity": (without("uo", "units"), "", r"ocean.nc: uo does not say its units\n    -> give uo an attribute"),
    "knots": (ocean().pipe(lambda ds: ds.assign(uo=ds.uo.assign_attrs(units="knots"))), "", r"units of uo .*'knots'"),
    "no units of depth": (without("depth", "units"), "", r"units of depth are not known\n    -> give depth"),
    "no units of latitude": (without("latitude", "units"), "", "units of latitude are not known"),
    "no units of time": (without("time", "units"), "", r"units of time are not known\n    -> write seconds since"),
    "no velocity": (ocean().drop_vars("vo"), "", r"file has no northward_sea_water_velocity\n    -> name a velocity vo"),
    "no origin": (ocean(), None, r"in degrees, and origin says not where the model is\n    -> give origin: \[longitude"),
    "elsewhere": (ocean(), ", origin: [5.15, 60.0]", r"does not cover the model in x by 27\d\d m \(grid -1.*, model -300 to 0"),
    "not then": (ocean(), ", start: 2021-01-01", r"start of the current is not in the file .*\n    -> give a time from 2020"),
    "no date": (ocean(), ", start: noon", r"model.yaml:4: start of the current is not a date \(read: 'noon'\)"),
    "twice": (ocean().assign_coords(depth=[0.5, 0.5, 9.0]).pipe(
        lambda ds: ds.assign_coords(depth=ds.depth.assign_attrs(units="m"))), "", "depth has a value twice"),
    "ensemble": (xr.concat([ocean(), ocean()], "member"), "", r"dimension of the currents is not known .*'member'"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_file_error(tmp_path, name):
    ds, more, message = BAD[name]
    more = "" if more is None else ", origin: [5.0, 60.0]" + more if "origin" not in more else more
    with pytest.raises(ModelError, match=message) as raised:
        of_file(tmp_path, ds, more)
    assert len(raised.value.problems) == 1


def test_no_file(tmp_path):
    with pytest.raises(ModelError, match=r"model.yaml:4: file of currents not found: tried .*none.nc"):
        native(tmp_path, "current: {file: none.nc}")
    (tmp_path / "none.nc").write_text("not NetCDF")
    with pytest.raises(ModelError, match=r"none.nc: file of currents cannot be read"):
        native(tmp_path, "current: {file: none.nc}")


# --- native ---------------------------------------------------------------------------------------------------------


def test_a_grid_in_the_native_file(tmp_path):
    rows = [[0.1, 0, 0], [0.2, 0, 0], [0.3, 0, 0], [0.4, 0.1, 0]]
    model = native(tmp_path, f"current: {{t: [0, 60], z: [-100, 0], velocity: {rows}, turn: 0.5}}")
    current = model.environment.current
    assert current.at(60.0, (0.0, 0.0, 0.0)) == pytest.approx([0.4, 0.1, 0.0])
    assert current.at(0.0, (0.0, 0.0, 0.0)) == pytest.approx([0.2, 0.0, 0.0])
    convert(tmp_path / "model.yaml", tmp_path / "again.yaml")
    assert read(tmp_path / "again.yaml").environment.current == current


@pytest.mark.parametrize(
    ("what", "message"),
    [
        (
            "t: [0, 1], velocity: [[1, 0, 0]]",
            r"model.yaml:4: .* do not fit its grid .*1 rows of 3.*\n    -> give 2 rows",
        ),
        ("t: [0, 1], velocity: [[1, 0], [1, 0]]", "give 2 rows of 3"),
        ("t: [1, 0], velocity: [[1, 0, 0], [1, 0, 0]]", r"times of the current do not increase"),
        (
            "x: [-100, 5], velocity: [[1, 0, 0], [1, 0, 0]]",
            r"cover the model in x by 200 m \(grid -100 to 5 m, model -300",
        ),
    ],
)
def test_native_error(tmp_path, what, message):
    with pytest.raises(ModelError, match=message) as raised:
        native(tmp_path, f"current: {{{what}}}")
    assert len(raised.value.problems) == 1


def test_levels_of_another_place_are_told(tmp_path):
    ds = ocean().assign_coords(depth=DEPTH * 2.0)
    ds["depth"].attrs.update(units="m", positive="down")
    of_file(tmp_path, ds)  # at several places some are deeper than the model
    with pytest.raises(ModelWarning, match=r"current's lowest level, -198 m, is 98 m below the seabed at -100 m"):
        of_file(tmp_path, ds.isel(latitude=1, longitude=1), "")


def test_a_current_that_ends_is_told():
    current = CurrentGrid(t=(0.0, 60.0), velocity=np.zeros((2, 1, 1, 1, 3)))
    with pytest.warns(ModelWarning, match=r"current is given up to 60 s, the run is 100 s long: its last values go on"):
        warn_of_short_current(current, 100.0)


# --- MoorDyn --------------------------------------------------------------------------------------------------------

DYNAMIC = "a\nb\nc\nd\n-40 -20 0\n\n0 0.1 0.2 0.3\n10 0.4 0.5 0.6\n"
GRID = "2 2 2 1\n-999 999\n-999 999\n-40 0\n0\n" + "".join(
    f"{x} {y} {z} 0 {0.1 * k} 0 0.01\n"
    for k, (x, y, z) in enumerate((x, y, z) for x in (-999, 999) for y in (-999, 999) for z in (-40, 0))
)


def deck_with(deck, tmp_path, mode, text):
    names = {1: "current_profile.txt", 2: "current_profile_dynamic.txt", 5: "current_profile_4d.txt"}
    if text is not None:
        (tmp_path / names[mode]).write_text(text)
    return read(deck(("0.001    dtM       time step", f"0.001    dtM       time step\n{mode} Currents")))


def test_profile_over_time(deck, tmp_path):
    current = deck_with(deck, tmp_path, 2, DYNAMIC).environment.current
    assert current.at(5.0, (0.0, 0.0, -30.0)) == pytest.approx([0.3, 0.0, 0.0])
    three = DYNAMIC.replace("0.1 0.2 0.3", "0.1 0.2 0.3 1 1 1 2 2 2").replace("0.4 0.5 0.6", "0.4 0.5 0.6 1 1 1 2 2 2")
    assert deck_with(deck, tmp_path, 2, three).environment.current.at(5.0, (0.0, 0.0, -30.0)) == pytest.approx(
        [0.3, 1, 2]
    )


def test_grid_over_place(deck, tmp_path):
    """Also the first row counts, which MoorDyn-C leaves out."""
    current = deck_with(deck, tmp_path, 5, GRID.replace("-40 0 0.0 0 0.01", "-40 0 0.5 0 0.01")).environment.current
    assert current.at(3.0, (-999.0, -999.0, -40.0)) == pytest.approx([0.5, 0.0, 0.01])
    assert current.at(3.0, (999.0, -999.0, -20.0)) == pytest.approx([0.45, 0.0, 0.01])


MOORDYN = {
    "a row too short": (2, DYNAMIC.replace("0.1 0.2 0.3", "0.1 0.2"), r"dynamic.txt:7: row .* 3 numbers\n    -> give 4 or 7 or 10"),
    "times fall": (2, DYNAMIC.replace("10 0.4", "-1 0.4"), r"dynamic.txt: times of the current do not increase"),
    "levels": (2, DYNAMIC.replace("-40 -20 0", "-40 -50 0"), "levels of the current do not increase"),
    "not a number": (2, DYNAMIC.replace("0.5", "half"), r"dynamic.txt:8: current is not a number \(read: 'half'\)"),
    "no rows": (2, "a\nb\nc\nd\n-40 0\n", r"table of the current has 5 lines\n    -> give four header lines"),
    "no file": (2, None, r"model.dat:20: table of the current not found: tried .*current_profile_dynamic.txt"),
    "counts": (5, GRID.replace("2 2 2 1", "2 3 2 1"), r"4d.txt:1: grid of the current has 2 in x, 2 in y, 2 in z, 1 in t"),
    "a point elsewhere": (5, GRID.replace("-999 999 0 0", "-999 998 0 0"), r"4d.txt:9: row .* not a point of the grid"),
    "a point missing": (5, "\n".join(GRID.split("\n")[:-2]) + "\n", "current is missing at 1 of 8 points"),
}  # fmt: skip


@pytest.mark.parametrize("name", MOORDYN)
def test_moordyn_error(deck, tmp_path, name):
    mode, text, message = MOORDYN[name]
    with pytest.raises(ModelError, match=message) as raised:
        deck_with(deck, tmp_path, mode, text)
    assert len(raised.value.problems) == 1


def test_grid_that_is_too_small_for_the_model(deck, tmp_path):
    """As in MoorDyn, whose own tests have one, the edge goes on; a native file is refused (`elsewhere`)."""
    model = deck_with(deck, tmp_path, 5, GRID.replace("-999", "-800"))
    problem = doubtful_current(model)[0]
    assert "does not cover the model in x by 37.6 m (grid -800 to 999 m, model -837" in str(problem)
    assert model.environment.current.at(3.0, (-837.0, -999.0, -20.0)) == pytest.approx([0.05, 0.0, 0.01])


@pytest.mark.parametrize("mode", [3, 4])
def test_node_currents_are_refused_with_the_mode_that_reads_the_file(deck, tmp_path, mode):
    model = deck_with(deck, tmp_path, mode, None)
    with pytest.raises(
        UnsupportedError, match=rf"model.dat:20: currents of Currents {mode} .*\n    -> write {mode - 2}"
    ):
        refuse_unbuilt(model)


def test_waves_of_a_host(deck, tmp_path):
    (tmp_path / "current_profile.txt").write_text("a\nb\nc\n-200 0.1\n0 1\n")
    line = "0.001    dtM       time step"
    model = read(deck((line, f"{line}\n1 WaveKin\n1 Currents")))
    assert model.environment.host_waves
    assert model.environment.current.velocity[1] == (1.0, 0.0, 0.0)
    refuse_unbuilt(model)
    convert(model.file, tmp_path / "again.yaml")
    assert read(tmp_path / "again.yaml").environment.host_waves
    (tmp_path / "c").mkdir()
    convert(model.file, tmp_path / "c" / "again.dat")
    assert "1 WaveKin" in " ".join((tmp_path / "c" / "again.dat").read_text().split())
