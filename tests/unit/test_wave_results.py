"""Results carry the sea: elevation, what was asked, what came out; people see it; repetition is told."""

from __future__ import annotations

import dataclasses
import warnings

import numpy as np
import pytest
from typer.testing import CliRunner

import moorage
import moorage.cli
from moorage.errors import ModelWarning
from moorage.model import Current, Waves
from moorage.plot import result_figure
from moorage.words import current_words

SEA = Waves.irregular("jonswap", 4.0, 9.0, depth=200.0, gamma=2.0, components=30, seed=5, ramp=2.0)


def in_sea(path, waves):
    model = moorage.read(path)
    return dataclasses.replace(model, environment=dataclasses.replace(model.environment, waves=waves))


@pytest.fixture
def result(deck):
    return moorage.simulate(in_sea(deck(), SEA), duration=3.0)


def test_elevation_and_attributes(result):
    time = result["time"].values
    assert result["wave_elevation"].dims == ("time",)
    assert result["wave_elevation"].attrs["units"] == "m"
    assert np.allclose(result["wave_elevation"], SEA.kinematics(time, np.zeros((len(time), 3))).elevation, atol=1e-12)
    told = {name: value for name, value in result.attrs.items() if name.startswith("wave_")}
    assert told == {
        "wave_asked": "jonswap, Hs 4 m, Tp 9 s, gamma 2",
        "wave_components": 30,
        "wave_seed": 5,
        "wave_stretching": "wheeler",
        "wave_ramp": 2.0,
        "wave_significant_height": SEA.significant_height,
        "wave_peak_period": SEA.peak_period,
    }


def test_the_sea_can_be_made_again_from_its_components(deck, tmp_path):
    """On disk as in memory: eta of the components at another place is that of the model's sea."""
    ds = moorage.simulate(in_sea(deck(), SEA), duration=1.0, output=tmp_path / "sea.nc")
    assert {"wave_frequency", "wave_number", "wave_direction"} <= set(ds.coords)
    t, x, y = 7.0, 30.0, -20.0
    a, w, k, b, phase = (
        ds[f"wave_{name}"].values for name in ("amplitude", "frequency", "number", "direction", "phase")
    )
    eta = (a * np.cos(w * t + phase - k * (x * np.cos(b) + y * np.sin(b)))).sum()
    assert eta == pytest.approx(float(SEA.elevation(t, x, y)), abs=1e-12)


def test_the_figure_starts_with_the_waves(result):
    first, second = result_figure(result).axes[:2]
    assert first.get_title(loc="left") == "jonswap, Hs 4 m, Tp 9 s, gamma 2"
    assert first.get_xlim() == second.get_xlim()
    assert np.allclose(first.lines[0].get_ydata(), result["wave_elevation"])


def test_statics_have_no_elevation(deck):
    ds = moorage.solve_statics(in_sea(deck(), SEA))
    assert "wave_elevation" not in ds
    assert ds.attrs["wave_components"] == 30


def test_still_water_says_nothing_of_waves(deck):
    ds = moorage.solve_statics(moorage.read(deck()))
    assert not [name for name in ds.attrs if name.startswith("wave_")]


def test_a_file_on_disk_carries_the_sea(deck, tmp_path):
    ds = moorage.simulate(in_sea(deck(), SEA), duration=1.0, output=tmp_path / "sea.nc")
    assert np.allclose(ds["wave_elevation"], SEA.elevation(ds["time"].values), atol=1e-12)
    assert ds.attrs["wave_seed"] == 5
    output = CliRunner().invoke(moorage.cli.app, ["info", str(tmp_path / "sea.nc")]).output
    words = " ".join(output.split())
    achieved = f"achieved Hs {SEA.significant_height:.3g} m, Tp {SEA.peak_period:.3g} s with 30 components of seed 5"
    assert f"jonswap, Hs 4 m, Tp 9 s, gamma 2; {achieved}" in words


@pytest.mark.parametrize(("method", "repeats"), [("equal-frequency", True), ("random", False), ("equal-energy", False)])
def test_repetition(method, repeats):
    """Bins of 3 wp / 50 make groups that come again after 50 / 3 peak periods."""
    waves = Waves.irregular("jonswap", 4.0, 9.0, depth=200.0, components=50, method=method)
    assert waves.repeats_after == pytest.approx(150.0 if repeats else np.inf)
    time = np.linspace(0.0, 150.0, 601)
    same = np.allclose(np.abs(hilbert(waves, time + 150.0)), np.abs(hilbert(waves, time)), atol=1e-9)
    assert same == repeats


def test_repetition_with_components_missing():
    """Multiples 5, 7 and 10 of 2 pi / 60 s."""
    parts = dict.fromkeys(("amplitude", "phase", "direction"), (0.0,) * 3)
    waves = Waves(frequency=tuple(2.0 * np.pi / 60.0 * k for k in (5, 7, 10)), depth=50.0, **parts)
    assert waves.repeats_after == pytest.approx(60.0)


def hilbert(waves, time):
    """Return the sum of the components as complex numbers, whose size is the envelope of the elevation."""
    parts = np.array(waves.amplitude) * np.exp(1j * np.array(waves.phase))
    return (parts * np.exp(1j * time[:, None] * np.array(waves.frequency))).sum(axis=1)


def test_a_repeating_sea_is_told(deck):
    waves = Waves.irregular("jonswap", 4.0, 9.0, depth=200.0, components=10, method="equal-frequency")
    with pytest.warns(ModelWarning, match=r"the waves repeat after 30 s, the run is 31 s long"):
        moorage.simulate(in_sea(deck(), waves), duration=31.0, dt_out=1.0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        moorage.results.warn_of_repetition(waves, 29.0)
        moorage.results.warn_of_repetition(Waves.regular(2.0, 8.0, depth=50.0), 1e6)
        moorage.results.warn_of_repetition(None, 1e6)


def test_words_of_seas():
    assert Waves.regular(2.0, 8.0, depth=50.0).words == "regular, height 2 m, period 8 s"
    assert dataclasses.replace(SEA, asked=()).words == "components as given"


def test_words_of_currents():
    two = Current((-10.0, 0.0), ((0.4, 0.0, 0.0), (1.0, 0.0, 0.0)))
    assert current_words(Current((0.0,), ((0.3, 0.4, 0.0),))) == "0.5 m/s"
    assert current_words(two) == "1 m/s at z = 0 m, 0.4 m/s at -10 m"
    assert current_words(Current()) == ""
