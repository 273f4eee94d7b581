"""Seas from files of spectra, and currents in words: energy, directions, shapes, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from native_text import CHAIN as TEXT

from moorage.errors import ModelError
from moorage.io import convert, read
from moorage.model.spectra import jonswap

FREQUENCY = np.geomspace(0.04, 0.4, 30)
HEADINGS = np.arange(0.0, 360.0, 10.0)


def environment(tmp_path, what):
    path = tmp_path / "model.yaml"
    path.write_text(TEXT.format(what=what))
    return read(path).environment


def spectra(mean=270.0, units="m2/Hz/deg", **attrs):
    """Return two times of JONSWAP, 3 m and 10 s, then 5 m and 12 s, from 270 deg (west) by cos^2s of s = 12."""
    share = np.cos(np.deg2rad(0.5 * (HEADINGS - mean))) ** 24
    share /= share.sum() * 10.0
    along = [2 * np.pi * jonswap(2 * np.pi * FREQUENCY, *sea) for sea in ((3.0, 10.0), (5.0, 12.0))]
    values = np.array(along)[:, :, None] * share * (1.0 if "deg" in units else 180.0 / np.pi)
    ds = xr.Dataset({"efth": (("time", "freq", "dir"), values, {"units": units})}, {"freq": FREQUENCY, "dir": HEADINGS})
    ds["freq"].attrs["units"] = "Hz"
    ds["dir"].attrs.update(attrs)
    return ds


def waves_of(tmp_path, ds, more=""):
    ds.to_netcdf(tmp_path / "sea.nc")
    return environment(tmp_path, f"waves: {{file: sea.nc{more}}}").waves


def mean_direction(waves):
    energy = np.square(waves.amplitude)
    return np.rad2deg(np.angle((energy * np.exp(1j * np.array(waves.direction))).sum()))


@pytest.mark.parametrize("units", ["m2/Hz/deg", "m2/Hz/rad", "m^{2}.s.degree^{-1}", "m2 s rad-1"])
def test_energy_is_that_of_the_file(tmp_path, units):
    """What is left out is a thousandth of the energy, half of that in height; bins sum to 0.5 % of JONSWAP's 3 m."""
    waves = waves_of(tmp_path, spectra(units=units))
    asked = dict(waves.asked)
    assert asked["height"] == pytest.approx(3.0, rel=0.01)
    assert waves.significant_height == pytest.approx(asked["height"], rel=6e-4)
    assert waves.peak_period == pytest.approx(10.0, rel=0.05)
    assert waves.words.startswith("sea.nc at time 0, Hs 2.99")


def test_time_and_seed(tmp_path):
    later = waves_of(tmp_path, spectra(), ", time: 1")
    assert later.significant_height == pytest.approx(5.0, rel=0.01)
    assert later == waves_of(tmp_path, spectra(), ", time: 1, seed: 1")
    assert later != waves_of(tmp_path, spectra(), ", time: 1, seed: 2")
    assert later.repeats_after == np.inf


def check_direction(tmp_path, expected, more="", mean=270.0, **attrs):
    assert mean_direction(waves_of(tmp_path, spectra(mean, **attrs), more)) == pytest.approx(expected, abs=0.1)


def test_directions_come_from_a_compass(tmp_path):
    """Waves from the west go east, along x by default; with x to the north they go to the right, along -y."""
    check_direction(tmp_path, 0.0)
    check_direction(tmp_path, -90.0, ", heading: 0")
    check_direction(tmp_path, 90.0, mean=180.0)  # from the south to the north
    check_direction(tmp_path, 90.0, mean=0.0, standard_name="sea_surface_wave_to_direction")
    with pytest.raises(AssertionError):  # read as where they come from
        check_direction(tmp_path, 90.0, mean=0.0)


def test_order_of_dims_and_directions_does_not_count(tmp_path):
    plain = waves_of(tmp_path, spectra())
    turned = spectra().transpose("dir", "time", "freq").isel(dir=slice(None, None, -1)).expand_dims(site=1)
    assert waves_of(tmp_path, turned) == plain


REFUSED = {
    "units": (lambda ds: ds["efth"].attrs.pop("units"), "", "efth does not say its units\n    -> .*m2/Hz/deg"),
    "strange": (lambda ds: ds["efth"].attrs.update(units="J/m2"), "", r"units of efth are not known \(read: 'J/m2'\)"),
    "rate": (lambda ds: ds["freq"].attrs.pop("units"), "", "freq does not say its units"),
    "rad/s": (lambda ds: ds["freq"].attrs.update(units="rad/s"), "", "units of freq are not known"),
    "time": (lambda ds: None, ", time: 2", r"no such time \(read: 2\)\n    -> give a number from 0 to 1"),
    "negative": (lambda ds: ds["efth"].values.__setitem__((0, 3, 3), -1.0), "", "missing or negative values"),
    "hole": (lambda ds: ds["efth"].values.__setitem__((0, 3, 3), np.nan), "", "missing or negative values"),
    "calm": (lambda ds: ds["efth"].values.fill(0.0), "", "spectrum holds no waves"),
    "steep": (lambda ds: ds["efth"].values.__imul__(200.0), "", "would break"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_file_error(tmp_path, name):
    change, more, message = REFUSED[name]
    ds = spectra()
    change(ds)
    with pytest.raises(ModelError, match=message) as raised:
        waves_of(tmp_path, ds, more)
    assert len(raised.value.problems) == 1


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda ds: ds.rename(dir="theta"), "file has no dir"),
        (lambda ds: xr.concat([ds, ds], "site"), "more than one place"),
        (lambda ds: ds.isel(dir=[0]), "freq and dir are not a grid"),
        (lambda ds: ds.assign_coords(dir=HEADINGS // 20 * 20), "freq and dir are not a grid"),
    ],
)
def test_shape_error(tmp_path, change, message):
    with pytest.raises(ModelError, match=message):
        waves_of(tmp_path, change(spectra()))


def test_no_file(tmp_path):
    with pytest.raises(ModelError, match=r"model.yaml:4: file of wave spectra not found: tried .*sea.nc"):
        environment(tmp_path, "waves: {file: sea.nc}")
    (tmp_path / "sea.nc").write_text("no NetCDF")
    with pytest.raises(ModelError, match="cannot be read"):
        environment(tmp_path, "waves: {file: sea.nc}")


def test_uniform_current(tmp_path):
    current = environment(tmp_path, "current: {speed: 0.8, direction: 90}").current
    assert current.z == (0.0,)
    assert current.velocity[0] == pytest.approx((0.0, 0.8, 0.0))


@pytest.mark.parametrize("exponent", [0.05, 1.0 / 7.0, 0.5, 1.0])
def test_power_law(tmp_path, exponent):
    current = environment(tmp_path, f"current: {{speed: 2, profile: power, exponent: {exponent}}}").current
    z = np.linspace(-99.0, 0.0, 5001)
    given = np.interp(z, current.z, np.array(current.velocity)[:, 0])
    assert np.abs(given - 2.0 * (1.0 + z / 100.0) ** exponent).max() < 1e-3 * 2.0
    assert current.z[0] == -100.0
    assert current.velocity[0] == (0.0, 0.0, 0.0)
    assert current.velocity[-1] == (2.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("speed: -1", r"model.yaml:4: speed of the current is negative \(read: -1.0\)\n    -> turn its direction"),
        ("speed: 1, exponent: 0.2", "exponent means nothing for a uniform current"),
        ("speed: 1, profile: power, exponent: 0", "exponent of the current must be positive"),
        ("speed: 1, profile: log", "profile of current of environment .* is not known"),
    ],
)
def test_current_error(tmp_path, words, message):
    with pytest.raises(ModelError, match=message) as raised:
        environment(tmp_path, f"current: {{{words}}}")
    assert len(raised.value.problems) == 1


# --- spectra in tables, and what the native file keeps ---------------------------------------------------------------


def test_a_table_of_a_spectrum(tmp_path):
    """JONSWAP as 60 points: linear between them, its height is within 1 %; what it was made from is told."""
    w = np.linspace(0.3, 2.2, 60)
    np.savetxt(tmp_path / "spectrum.txt", np.column_stack([w, jonswap(w, 4.0, 10.0)]))
    more = "direction: 90, spreading: 10, components: 150, seed: 7, stretching: linear"
    env = environment(tmp_path, f"waves: {{density: {{file: spectrum.txt}}, {more}}}")
    waves = env.waves
    assert waves.significant_height == pytest.approx(4.0, rel=0.01)
    assert (len(waves.frequency), waves.seed, waves.stretching) == (150, 7, "linear")
    assert mean_direction(waves) == pytest.approx(90.0, abs=5.0)
    assert min(waves.frequency) > 0.3
    assert dict(waves.asked)["spectrum"] == "a table, spectrum.txt"
    x, y = w.tolist(), jonswap(w, 4.0, 10.0).tolist()
    inline = environment(tmp_path, f"waves: {{density: {{x: {x}, y: {y}}}, {more}}}").waves
    assert inline.amplitude == pytest.approx(waves.amplitude)


def test_converting_keeps_what_was_asked(tmp_path):
    first = environment(tmp_path, "waves: {spectrum: jonswap, height: 4, period: 10, gamma: 2, seed: 9}").waves
    convert(tmp_path / "model.yaml", tmp_path / "again.yaml")
    again = read(tmp_path / "again.yaml").environment.waves
    assert again == first
    assert (again.seed, again.asked, again.words) == (9, first.asked, first.words)
