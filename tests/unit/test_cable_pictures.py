"""What users see of cables: pictures, the static table, and what `check` says; and that both example files agree."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import moorage
from moorage import cli, console
from moorage.plot import moorings, plot_along, plot_profile, plot_tension, result_figure
from moorage.plot.style import new_figure
from moorage.results import cable_reports

FOLDER = Path(__file__).parents[2] / "examples" / "lazy_wave"


@pytest.fixture(scope="module")
def native():
    return moorage.read(FOLDER / "lazy_wave.yaml")


@pytest.fixture(scope="module")
def run(native):
    motion = moorage.Motion.from_harmonics(12.0, ramp=6.0, surge=(2.0, 10.0), heave=(1.5, 8.0))
    return moorage.simulate(native, duration=8.0, motion=motion, dt_nodes=0.2)


@pytest.fixture(scope="module")
def chain():
    return moorage.solve_statics(moorage.read(FOLDER / "lazy_wave.dat"))


def texts(ax):
    return [text.get_text() for text in ax.get_legend().get_texts()]


def test_both_files_of_the_example_are_the_same_cable(native, chain):
    (one,), (other,) = cable_reports(moorage.solve_statics(native)), cable_reports(chain)
    assert other.lines == (5, 4, 3, 2, 1)
    assert other.hang_off_tension == pytest.approx(one.hang_off_tension, rel=5e-3)
    assert other.anchor_tension == pytest.approx(one.anchor_tension, rel=5e-3)
    assert other.minimum_bend_radius == pytest.approx(one.minimum_bend_radius, rel=5e-3)
    for name in ("sag_height", "hog_height", "touchdown_distance", "peak_curvature_distance"):
        assert getattr(other, name) == pytest.approx(getattr(one, name), abs=0.3), name
    # a lazy wave: it sags, arches over the sag, and comes down to the bed
    assert 10.0 < one.sag_height < one.hog_height < 86.0
    assert one.touchdown_distance < 230.0
    assert one.bend_utilisation < 1.0


def test_figure_of_a_cable_has_profile_tension_and_curvature(run):
    figure = result_figure(run)
    over_time, profile, tension, curvature = figure.axes
    assert over_time.get_ylabel() == "hang-off tension (kN)"
    assert profile.get_xlabel() == "distance from the hang-off (m)"
    assert texts(profile) == ["static", "during the run", "touchdown"]
    assert texts(tension) == ["thicker", "extremes", "mean", "static"]
    assert (tension.get_ylabel(), curvature.get_ylabel()) == ("tension (kN)", "curvature (1/m)")
    np.testing.assert_allclose(curvature.get_xlim(), (0.0, 230.0))
    assert [text.get_text() for text in curvature.texts] == ["allowed: 0.4 1/m, off the scale (radius 2.5 m)"]


def test_a_chain_of_cables_is_drawn_as_one(chain):
    assert moorings(chain) == [[1, 2, 3, 4, 5]]
    figure = result_figure(chain)
    titles = [ax.get_title(loc="left") for ax in figure.axes]
    assert titles == ["lines 1, 2, 3, 4, 5"] + ["along lines 5, 4, 3, 2, 1"] * 2
    profile = figure.axes[0]
    assert texts(profile) == ["static", "touchdown"]
    x, z = profile.lines[0].get_data()
    np.testing.assert_allclose([x[-1], z[-1], z[0]], [0.0, -14.0, -100.0], atol=1e-9)
    assert (np.hypot(np.diff(x), np.diff(z)) < 2.0).all()  # no jump from line to line


def test_what_acts_along_a_cable_lies_within_its_extremes(run):
    ax = plot_along(run, [1], new_figure(5, 3).add_subplot(), "bending_moment")
    mean, start = (drawn.get_data() for drawn in ax.lines)
    np.testing.assert_allclose(mean[0], start[0])
    np.testing.assert_allclose(start[1], 1e-3 * run["bending_moment"].values[0, ::-1])  # from end B on
    assert ax.get_ylabel() == "bending moment (kN m)"


def test_allowed_curvature_is_drawn_when_it_is_near(run):
    near = run.assign_coords(allowed_bend_radius=0.0 * run["allowed_bend_radius"] + 9.0)
    ax = plot_along(near, [1], new_figure(5, 3).add_subplot(), "curvature")
    np.testing.assert_allclose(ax.lines[-1].get_data()[1], 1.0 / 9.0)
    assert ax.get_ylim()[1] > 1.0 / 9.0


def test_tension_over_time_is_that_of_the_hang_off(run):
    figure = new_figure(6, 3)
    for k, (variable, name) in enumerate((("fairlead_tension", "fairlead"), ("anchor_tension", "anchor"))):
        (drawn,) = plot_tension(run, figure.add_subplot(1, 2, k + 1), variable).lines
        np.testing.assert_allclose(drawn.get_data()[1], run[f"{name}_tension"].values[:, 0] / 1e3)


def test_profile_of_a_part_of_a_chain(chain):
    ax = plot_profile(chain, [3], new_figure(5, 3).add_subplot())
    assert len(ax.lines[0].get_data()[0]) == 87


@pytest.fixture
def moorage_(monkeypatch, tmp_path):
    """Run a command in this process, in an empty folder."""
    monkeypatch.chdir(tmp_path)
    for name in ("out", "err"):  # the consoles were made with the streams of the importing process
        monkeypatch.setattr(getattr(console, name), "_file", None)

    def command(*words, code=0):
        result = CliRunner().invoke(cli.app, [str(word) for word in words])
        assert result.exit_code == code, result.output + repr(result.exception)
        return result

    return command


def test_static_prints_the_report_of_cables(moorage_, native):
    output = moorage_("static", FOLDER / "lazy_wave.yaml").output
    (report,) = cable_reports(moorage.solve_statics(native))
    for words, value in (
        ("hang-off tension", f"{report.hang_off_tension / 1e3:.2f}"),
        ("lowest sag over the seabed", f"{report.sag_height:.2f}"),
        ("peak curvature (1/m)", f"{report.peak_curvature:.4f}"),
        ("anchor tension", f"{report.anchor_tension / 1e3:.2f}"),
    ):
        assert re.search(rf"{re.escape(words)} +{value}", output), words
    assert output.index("Cables") < output.index("out-of-balance")


def test_static_json_has_the_cable_in_each_line(moorage_):
    report = json.loads(moorage_("static", FOLDER / "lazy_wave.dat", "--json").stdout)
    assert {tuple(line["cable"]["lines"]) for line in report["lines"]} == {(5, 4, 3, 2, 1)}
    assert {"fairlead_tension", "grounded_length", "cable"} <= set(report["lines"][0])


def test_tables_of_moorings_without_cables_stay_as_they_were(moorage_):
    assert "Cables" not in moorage_("static", FOLDER.parent / "oc4" / "oc4.dat").output


def test_plot_draws_a_result_with_cables(moorage_, run):
    run.to_netcdf("cable.nc")
    moorage_("plot", "cable.nc")
    assert Path("cable.png").read_bytes().startswith(b"\x89PNG")


def test_check_names_pinned_junctions(moorage_):
    text = (FOLDER / "lazy_wave.dat").read_text("utf-8")
    text = text.replace(" R2A  ", " 2    ").replace(" R2B  ", " 2    ")
    point = "\n2    Free         -103.0   0    -75.0   0      0        0      0"
    text = text.replace("\n1    Fixed ", point + "\n1    Fixed ")
    Path("pinned.dat").write_text(re.sub(r"\n2    joint .*", "\n2    joint     Fixed        0 0 -50 0 0 -51 0 -", text))
    output = moorage_("check", "pinned.dat").output
    assert "cables 1, 2 meet at free point 2" in output
    assert "this can be run" in output
    shutil.copy(FOLDER / "lazy_wave.dat", "whole.dat")
    assert "meet at" not in moorage_("check", "whole.dat").output
