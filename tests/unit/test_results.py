"""Datasets: what is in them, that it is labelled, and that memory and disk hold the same."""

import dataclasses
import warnings
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import moorage
from moorage import streaming
from moorage.errors import ModelWarning, ResultError
from moorage.model import Waves
from moorage.results.columns import uplift_angle
from moorage.results.statistics import line_summaries, summary

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4" / "oc4.dat"
ISSUE = (
    "fairlead_tension anchor_tension segment_tension node_position node_velocity point_position point_force "
    "node_line arc_length"
)


@pytest.fixture(scope="module")
def model():
    return moorage.read(EXAMPLE)


@pytest.fixture(scope="module")
def motion():
    return moorage.Motion.from_harmonics(20.0, ramp=10.0, surge=(3.0, 10.0), yaw=(0.02, 15.0))


@pytest.fixture(scope="module")
def ds(model, motion):
    return moorage.simulate(model, duration=10.0, motion=motion)


def without_date(result):
    return result.assign_attrs(date="")


def test_every_variable_says_what_it_is(ds):
    for name in ISSUE.split():
        assert name in ds.variables
    for name, variable in ds.variables.items():
        assert variable.attrs.get("units"), name
        assert variable.attrs.get("long_name"), name
    assert ds["fairlead_tension"].dims == ("time", "line")
    assert ds["node_position"].dims == ("time", "node", "xyz")
    assert ds["FAIRTEN1"].dims == ("time",)


def test_no_number_is_missing(ds):
    for name, variable in ds.variables.items():
        if variable.dtype.kind == "f":
            assert np.isfinite(variable.values).all(), name


def test_attributes_tell_how_to_repeat_the_run(ds, model):
    assert ds.attrs["input"] == EXAMPLE.read_text("utf-8") == model.text
    assert len(ds.attrs["input_sha256"]) == 64
    settings = {name: ds.attrs[name] for name in ("duration", "dt_out", "tolerance", "method", "start", "save")}
    assert settings == {
        "duration": 10.0, "dt_out": 0.1, "tolerance": 0.002, "method": "implicit", "start": "static", "save": "all",
    }  # fmt: skip
    assert ds.attrs["time_step"] == "adaptive"
    assert ds.attrs["status"] == "complete"
    assert ds.attrs["moorage_version"] == moorage.__version__


def test_end_values_agree_with_vectors_and_nodes(ds):
    force = ds["fairlead_force"].values
    np.testing.assert_allclose(ds["fairlead_tension"].values, np.linalg.norm(force, axis=-1))
    last = ds["node_position"].values[:, np.flatnonzero(np.diff(ds["node_line"].values, append=-1))]
    fairlead = ds["point_position"].sel(point=ds["end_b"].values).values
    np.testing.assert_allclose(last, fairlead, atol=1e-5)  # between steps nodes are Hermite cubics, the motion a spline
    np.testing.assert_allclose(ds["point_force"].sel(point=4).values, force[:, 0])
    np.testing.assert_allclose(ds["fairlead_segment_tension"].values, ds["segment_tension"].values[:, [49, 99, 149]])


def test_disk_holds_what_memory_holds(ds, model, motion, tmp_path):
    path = tmp_path / "run.nc"
    on_disk = moorage.simulate(model, duration=10.0, motion=motion, output=path)
    xr.testing.assert_identical(without_date(ds), without_date(on_disk.load()))
    on_disk.close()
    assert [p.name for p in tmp_path.iterdir()] == ["run.nc"]  # the checkpoint is gone


@pytest.mark.parametrize("settings", [{"dt_nodes": 0.5}, {"save": "tensions"}])
def test_disk_holds_what_memory_holds_with_other_node_histories(settings, model, tmp_path):
    with_nodes = "dt_nodes" in settings
    memory = moorage.simulate(model, duration=3.3, dt_out=0.3, **settings)
    disk = moorage.simulate(model, duration=3.3, dt_out=0.3, output=tmp_path / "run.nc", **settings)
    assert ("node_position" in memory) == ("node_position" in disk) == with_nodes
    assert memory.sizes["time"] == 12
    if with_nodes:
        assert memory["node_position"].dims[0] == "node_time"
        np.testing.assert_allclose(memory["node_time"].values, 0.5 * np.arange(7))
    xr.testing.assert_identical(without_date(memory), without_date(disk.load()))


def test_blocks_do_not_change_the_numbers(ds, model, motion, monkeypatch):
    monkeypatch.setattr(streaming, "BLOCK_SECONDS", 0.0)  # one output time a block
    again = moorage.simulate(model, duration=10.0, motion=motion)
    xr.testing.assert_identical(without_date(ds), without_date(again))


def test_progress_reaches_the_end(model):
    calls = []
    moorage.simulate(model, duration=2.0, progress=lambda *call: calls.append(call))
    times, durations, walls = np.array(calls).T
    assert times[0] == 0.0
    assert times[-1] == 2.0
    assert (np.diff(times) > 0.0).all()
    assert (np.diff(walls) >= 0.0).all()
    assert set(durations) == {2.0}


def test_line_selects_nodes_and_segments(ds):
    part = moorage.line(ds, 2)
    assert part.sizes["node"] == 51
    assert part.sizes["segment"] == 50
    assert part["fairlead_tension"].dims == ("time",)
    np.testing.assert_allclose(part["arc_length"].values[[0, -1]], [0.0, 835.5])
    np.testing.assert_array_equal(part["segment_line"].values, 2)
    with pytest.raises(ResultError, match=r"no line 9(.|\n)*1, 2, 3"):
        moorage.line(ds, 9)


def test_statics_is_the_start_of_a_run(model):
    eq, ds = moorage.solve_statics(model), moorage.simulate(model, duration=0.1)
    assert "time" not in eq.dims
    for name in ("fairlead_tension", "node_position", "segment_tension", "point_force"):
        np.testing.assert_allclose(eq[name].values, ds[name].values[0], rtol=1e-7, atol=1e-6)
    assert eq["stiffness"].dims == ("dof", "dof_")
    assert eq["stiffness"].sel(dof="surge", dof_="surge").item() == pytest.approx(70_800, rel=0.02)  # published
    assert eq["residual"].item() < 1.0
    for name, variable in eq.variables.items():
        assert variable.attrs.get("units"), name
        assert variable.attrs.get("long_name"), name


def test_start_as_given_is_not_the_static_state(model, ds):
    given = moorage.simulate(model, duration=0.2, start="as-given")
    assert given.attrs["start"] == "as-given"
    # the first catenary is close to the discrete equilibrium, not equal to it
    np.testing.assert_allclose(given["fairlead_tension"][0], ds["fairlead_tension"][0], rtol=0.05)
    assert not np.allclose(given["node_position"].values[0], ds["node_position"].values[0], atol=1e-6)


def test_uplift_does_not_count_the_weight_of_a_node_on_the_bed():
    force = np.array([[3.0, 4.0, 5.0], [3.0, 4.0, -5.0], [3.0, 4.0, -5.0]])
    angle = uplift_angle(force, np.array([0.0, 10.0, 0.0]))
    np.testing.assert_allclose(angle, [np.pi / 4.0, 0.0, -np.pi / 4.0])


def test_statistics_are_those_of_the_series(ds):
    assert summary(np.array([2.0, 1.0, 3.0]), 2.5) == (2.5, 1.0, 2.0, 3.0, pytest.approx(np.sqrt(2.0 / 3.0)))
    rows = line_summaries(ds)
    assert [row.line for row in rows] == [1, 2, 3]
    assert rows[1].fairlead.maximum == ds["fairlead_tension"].sel(line=2).max().item()
    assert rows[1].anchor.start == pytest.approx(ds["anchor_tension"].sel(line=2)[0].item())  # starts at rest
    assert rows[2].lowest_tension == ds["segment_tension"].values[:, 100:].min()
    assert rows[0].grounded == ds["grounded_length"].sel(line=1).min().item()


def test_static_tensions_are_those_at_rest(model, tmp_path):
    """Motion and sea that start at once put drag, damping and inertia into the sample at time 0, not into these."""
    eq = moorage.solve_statics(model)
    jerk = moorage.Motion.from_harmonics(5.0, surge=(1.0, 8.0))
    sea = dataclasses.replace(model.environment, waves=Waves.regular(6.0, 10.0, depth=200.0))
    wavy = dataclasses.replace(model, environment=sea)
    np.testing.assert_allclose(moorage.solve_statics(wavy)["fairlead_force"], eq["fairlead_force"], rtol=1e-9)
    path = tmp_path / "jerk.nc"
    with pytest.warns(ModelWarning, match="starts with"):
        ds = moorage.simulate(wavy, duration=0.2, motion=jerk, output=path)
    rows = line_summaries(ds)
    for k in range(3):
        assert rows[k].fairlead.start == pytest.approx(eq["fairlead_tension"].values[k], rel=1e-9)
        assert rows[k].anchor.start == pytest.approx(eq["anchor_tension"].values[k], rel=1e-9)
    assert abs(ds["fairlead_tension"].values[0] / ds["static_fairlead_tension"].values - 1.0).max() > 0.01
    given = moorage.simulate(model, duration=0.2, start="as-given")
    assert line_summaries(given)[0].fairlead.start == given["fairlead_tension"].values[0, 0]


def test_a_motion_that_starts_with_a_jerk_is_worth_a_warning(model):
    jerk = moorage.Motion.from_harmonics(5.0, surge=(1.0, 8.0))
    with pytest.warns(ModelWarning, match=r"starts with 0\.79 m/s.*ramp"):
        moorage.simulate(model, duration=0.2, motion=jerk)


def test_a_duration_that_is_no_multiple_of_the_interval_is_told(model):
    with pytest.warns(ModelWarning, match=r"results end at 0\.9 s: the duration of 1 s is no multiple .* of 0\.3 s"):
        ds = moorage.simulate(model, duration=1.0, dt_out=0.3)
    assert ds["time"].values[-1] == pytest.approx(0.9)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        moorage.simulate(model, duration=0.9, dt_out=0.3)


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"duration": 0.0}, "duration must be a positive number"),
        ({"duration": 1.0, "dt_out": -0.1}, "dt_out must be a positive number"),
        ({"duration": 1.0, "method": "rk4"}, "rk4 needs a time step"),
        ({"duration": 1.0, "method": "euler"}, "use implicit or rk2 or rk4"),
        ({"duration": 1.0, "save": "some"}, "use all or tensions"),
        ({"duration": 1.0, "resume": True}, "without a result file"),
        ({"duration": float("nan"), "start": "rest"}, "use static or as-given"),
    ],
)
def test_settings_that_cannot_be_used_are_refused(settings, words, model):
    with pytest.raises(moorage.InputError, match=words):
        moorage.simulate(model, **settings)


def test_a_file_that_is_no_result_is_refused(tmp_path):
    with pytest.raises(ResultError, match="does not exist"):
        moorage.open_result(tmp_path / "no.nc")
    xr.Dataset({"a": ("x", [1.0])}).to_netcdf(tmp_path / "other.nc")
    with pytest.raises(ResultError, match="no result of Moorage"):
        moorage.open_result(tmp_path / "other.nc")
    (tmp_path / "text.nc").write_text("hello")
    with pytest.raises(ResultError, match="cannot read"):
        moorage.open_result(tmp_path / "text.nc")
    with pytest.raises(ResultError, match="cannot write"):
        moorage.simulate(moorage.read(EXAMPLE), duration=1.0, output=tmp_path / "none" / "run.nc")
