"""Single pictures of a result: they show the numbers of the result, and say what they miss."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from moorings import coupled, fixed, kind, line, mooring
from typer.testing import CliRunner

import moorage
from moorage.cli import app
from moorage.plot import picture, plot_envelope, plot_spectrum, plot_tension, save_figure, save_picture

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4" / "oc4.dat"
KINDS = ("profile", "history", "envelope", "spectrum", "map")


def assert_words(figure):
    """Check that the axes have data, and words that end in a unit."""
    figure.canvas.draw()
    for ax in figure.axes:
        assert ax.lines or ax.collections
        for text in (ax.get_xlabel(), ax.get_ylabel()):
            assert text == "" or text.endswith(")")
    assert any(ax.get_xlabel() for ax in figure.axes)
    assert any(ax.get_ylabel() for ax in figure.axes)


@pytest.fixture(scope="module")
def run():
    motion = moorage.Motion.from_harmonics(20.0, ramp=5.0, surge=(2.0, 8.0))
    return moorage.simulate(moorage.read(EXAMPLE), duration=20.0, motion=motion)


@pytest.fixture(scope="module")
def rest():
    return moorage.solve_statics(moorage.read(EXAMPLE))


@pytest.mark.parametrize("what", KINDS)
def test_each_picture_of_a_run_has_words_and_units(run, what):
    assert_words(picture(run, what))


@pytest.mark.parametrize("what", ["profile", "envelope", "map"])
def test_statics_have_the_pictures_that_need_no_time(rest, what):
    assert_words(picture(rest, what))


@pytest.mark.parametrize("what", ["history", "spectrum"])
def test_statics_have_no_picture_over_time(rest, what):
    with pytest.raises(moorage.ResultError, match=f"a static solution has no {what}"):
        picture(rest, what)


@pytest.mark.parametrize("what", ["profile", "envelope", "map"])
def test_without_node_histories_it_is_said_how_to_get_them(run, what):
    with pytest.raises(moorage.ResultError, match="--save all"):
        picture(run.drop_vars(["node_position", "segment_tension"]), what)


def test_an_unknown_picture_is_told_the_known_ones(run):
    with pytest.raises(moorage.ResultError, match=", ".join(KINDS)):
        picture(run, "movie")


def test_an_envelope_holds_the_extremes_of_the_run(run):
    ax = plot_envelope(run, lines=[2])
    own = run["segment_tension"].values[:, run["segment_line"].values == 2] / 1e3
    low, high, mean = (drawn.get_ydata() for drawn in ax.lines)
    np.testing.assert_allclose(low, own.min(axis=0))
    np.testing.assert_allclose(high, own.max(axis=0))
    assert np.all((low <= mean) & (mean <= high))
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["line 2"]


def test_of_many_lines_those_with_the_highest_peaks_stand_out():
    """Nine ropes whose ends are moved, the fifth one tight: it has a colour, its envelope, and its name."""
    ends = [p for k in range(9) for p in (fixed(2 * k + 1, 0.0, k, -50.0), coupled(2 * k + 2, 40.0, k, -20.0))]
    ropes = [line(k + 1, 2 * k + 1, 2 * k + 2, ("rope", 49.0 if k == 4 else 53.0, 4)) for k in range(9)]
    motion = moorage.Motion.from_harmonics(8.0, ramp=2.0, surge=(0.5, 3.0))
    nine = moorage.simulate(mooring(kind(), ends, ropes, water_depth=50.0), duration=8.0, motion=motion)
    blank = Figure().add_subplot()
    for ax, count in ((plot_envelope(nine), 6 + 3 * 3), (plot_spectrum(nine), 9), (plot_tension(nine, blank), 9)):
        names = [text.get_text() for text in ax.get_legend().get_texts()]
        assert "line 5" in names
        assert len(names) == 4
        assert names[0].startswith("other lines")
        assert len(ax.lines) == count


def test_a_tension_that_is_the_same_all_along_has_round_ticks(run):
    same = run.copy()
    same["segment_tension"] = 0.0 * run["segment_tension"] + 5e5 + 1e-4 * np.arange(run.sizes["segment"])
    ax = plot_envelope(same)
    ax.figure.canvas.draw()
    assert ax.get_ylim() == pytest.approx((450.0, 550.0), rel=1e-6)
    assert ax.yaxis.get_offset_text().get_text() == ""


def test_the_area_of_a_spectrum_is_the_variance_and_its_peak_the_frequency(run):
    """A sine of amplitude a has the variance a^2 / 2; parts of 64 s hold whole periods of 8 s, so that its peak is exact.

    A Hann window leaks into the two neighbours only, which the axis covers.
    """
    time = np.arange(0.0, 256.0, 0.1)
    wave = 1e6 + 3e4 * np.sin(2.0 * np.pi * time / 8.0)
    sine = run.isel(time=np.zeros(len(time), int)).assign_coords(time=time)
    sine["fairlead_tension"] = (("time", "line"), np.stack([wave] * 3, axis=1))
    ax = plot_spectrum(sine)
    frequency, density = ax.lines[0].get_data()
    assert frequency[np.argmax(density)] == pytest.approx(1.0 / 8.0)
    assert np.sum(density) * frequency[1] == pytest.approx(30.0**2 / 2.0, rel=1e-3)


def test_a_short_run_has_no_spectrum(run):
    with pytest.raises(moorage.ResultError, match="a spectrum needs 32 instants"):
        plot_spectrum(run.isel(time=slice(0, 20)))


def test_a_picture_of_no_known_kind_is_refused(run, tmp_path):
    for save in (save_figure, lambda ds, path: save_picture(ds, "history", path)):
        with pytest.raises(moorage.ResultError, match=r"not written in this format(.|\n)*end in \.png, \.pdf or \.svg"):
            save(run, tmp_path / "run.foo")
        with pytest.raises(moorage.ResultError, match=r"cannot write .*no.run\.png"):
            save(run, tmp_path / "no" / "run.png")


def test_the_command_writes_the_picture_that_was_asked_for(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run.to_netcdf("run.nc")
    done = CliRunner().invoke(app, ["plot", "run.nc", "--what", "spectrum"])
    assert done.exit_code == 0, done.output
    assert Path("run-spectrum.png").read_bytes()[:4] == b"\x89PNG"
    assert CliRunner().invoke(app, ["plot", "run.nc", "--what", "movie"]).exit_code == 2
