"""Runs that are killed, interrupted or fail: what was reported is on disk, and a run goes on as if nothing had been."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import moorage
from moorage import streaming
from moorage.errors import ResultError, RunInterrupted, SimulationError
from moorage.results import checkpoint_path

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4"
DURATION = 40.0
STEP = 0.004  # s; small enough for a run that can be killed before it ends
RUN = f"""
import moorage
from moorage import streaming

streaming.BLOCK_SECONDS = 0.01
moorage.simulate(
    moorage.read(r"{EXAMPLE / "oc4.dat"}"), motion=moorage.Motion.read(r"{EXAMPLE / "motion.csv"}"),
    duration={DURATION}, dt_nodes=0.25, time_step={STEP}, output="run.nc",
    progress=lambda time, *rest: print(time, flush=True),
)
"""


@pytest.fixture(scope="module")
def settings():
    motion = moorage.Motion.read(EXAMPLE / "motion.csv")
    return {"motion": motion, "duration": DURATION, "dt_nodes": 0.25}


@pytest.fixture(scope="module")
def model():
    return moorage.read(EXAMPLE / "oc4.dat")


@pytest.fixture(scope="module")
def whole(model, settings):
    return moorage.simulate(model, **settings)


@pytest.fixture(scope="module")
def whole_in_small_steps(model, settings):
    return moorage.simulate(model, **settings, time_step=STEP)


@pytest.fixture
def small_blocks(monkeypatch):
    monkeypatch.setattr(streaming, "BLOCK_SECONDS", 0.01)


def interrupt_at(when):
    def progress(time, duration, wall):
        if time >= when:
            signal.raise_signal(signal.SIGINT)

    return progress


def assert_same(result, whole):
    xr.testing.assert_identical(result.load().assign_attrs(date=""), whole.assign_attrs(date=""))
    result.close()


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system has no SIGKILL")
@pytest.mark.parametrize("reports", [1, 4, 11])
def test_kill_loses_no_reported_block_and_resume_equals_the_whole_run(
    reports, tmp_path, model, settings, whole_in_small_steps, small_blocks
):
    whole = whole_in_small_steps
    process = subprocess.Popen([sys.executable, "-c", RUN], stdout=subprocess.PIPE, text=True, cwd=tmp_path)
    for _ in range(reports):
        process.stdout.readline()
    process.kill()
    rest = process.stdout.read().splitlines()
    process.wait()
    path = tmp_path / "run.nc"
    with moorage.open_result(path) as killed:
        assert killed.attrs["status"] == "running"
        reported = [float(line) for line in rest if line]
        if reported:
            assert killed["time"].values[-1] >= reported[-1]
        n, m = killed.sizes["time"], killed.sizes["node_time"]
        assert n >= 1 if reports == 1 else n > 1
        done = whole.isel(time=slice(n), node_time=slice(m))
        for name in done.data_vars:
            np.testing.assert_array_equal(killed[name].values, done[name].values, err_msg=name)
    resumed = moorage.simulate(model, **settings, time_step=STEP, output=path, resume=True)
    assert_same(resumed, whole)
    assert not checkpoint_path(path).exists()


def test_interrupt_leaves_a_valid_file_and_resume_equals_the_whole_run(tmp_path, model, settings, whole, small_blocks):
    path = tmp_path / "run.nc"
    with pytest.raises(RunInterrupted) as caught:
        moorage.simulate(model, **settings, output=path, progress=interrupt_at(3.0))
    stopped = caught.value.dataset()
    assert stopped.attrs["status"] == f"interrupted at {caught.value.time:g} s"
    assert 3.0 <= caught.value.time == pytest.approx(stopped["time"].values[-1])
    assert caught.value.time < DURATION
    stopped.close()
    with pytest.raises(RunInterrupted):  # and once more
        moorage.simulate(model, **settings, output=path, resume=True, progress=interrupt_at(10.0))
    assert_same(moorage.simulate(model, **settings, output=path, resume=True), whole)


def test_interrupt_in_memory_gives_what_there_is(model, settings, small_blocks):
    before = signal.getsignal(signal.SIGINT)  # ignored in a background job of a shell
    with pytest.raises(RunInterrupted) as caught:
        moorage.simulate(model, **settings, progress=interrupt_at(3.0))
    assert caught.value.dataset()["time"].values[-1] == pytest.approx(caught.value.time)
    assert signal.getsignal(signal.SIGINT) is before


def test_a_second_interrupt_acts_at_once():
    with streaming.deferred_interrupt() as asked:
        assert not asked()
        signal.raise_signal(signal.SIGINT)
        assert asked()
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_resume_refuses_another_run(tmp_path, model, settings, monkeypatch, small_blocks):
    path = tmp_path / "run.nc"
    with pytest.raises(ResultError, match="no such result"):
        moorage.simulate(model, **settings, output=path, resume=True)
    with pytest.raises(RunInterrupted):
        moorage.simulate(model, **settings, output=path, progress=interrupt_at(1.0))
    for change in ({"tolerance": 0.01}, {"duration": 30.0}, {"motion": None}, {"dt_out": 0.2}):
        with pytest.raises(ResultError, match="of another run"):
            moorage.simulate(model, **settings | change, output=path, resume=True)
    monkeypatch.setattr("moorage.run.VERSION", "99.0")
    with pytest.raises(ResultError, match=r"this is 99\.0"):
        moorage.simulate(model, **settings, output=path, resume=True)
    checkpoint_path(path).write_bytes(b"PK, but not much else")
    with pytest.raises(ResultError, match="cannot read"):
        moorage.simulate(model, **settings, output=path, resume=True)


def test_there_is_nothing_to_resume_after_a_complete_run(tmp_path, model):
    path = tmp_path / "run.nc"
    moorage.simulate(model, duration=0.2, output=path).close()
    with pytest.raises(ResultError, match="the run is complete"):
        moorage.simulate(model, duration=0.2, output=path, resume=True)


@pytest.mark.parametrize("dt_out", [0.08, 8.0])  # with records before it, or only that of the start
@pytest.mark.parametrize("on_disk", [True, False])
def test_a_run_that_fails_keeps_what_was_before(on_disk, dt_out, tmp_path, model):
    path = tmp_path / "run.nc"
    motion = moorage.Motion.from_harmonics(20.0, ramp=5.0, surge=(3.0, 8.0))
    with pytest.raises(SimulationError, match="explicit step") as caught:
        moorage.simulate(
            model, duration=20.0, motion=motion, method="rk2", time_step=0.08, dt_out=dt_out,
            output=path if on_disk else None,
        )  # fmt: skip
    kept = caught.value.dataset()
    assert kept.attrs["status"].startswith(f"failed at {caught.value.time:g} s: ")
    assert kept["time"].values[-1] <= caught.value.time
    for name, variable in kept.variables.items():
        if variable.dtype.kind == "f":
            assert np.isfinite(variable.values).all(), name
    kept.close()
    assert not list(tmp_path.glob("*.checkpoint"))


def test_checkpoints_are_replaced_as_a_whole(tmp_path, model, monkeypatch, small_blocks):
    path = tmp_path / "run.nc"
    replaced = []
    replace = os.replace
    monkeypatch.setattr("os.replace", lambda a, b: (replaced.append((Path(a).name, Path(b).name)), replace(a, b)))
    moorage.simulate(model, duration=2.0, output=path).close()
    assert set(replaced) == {("run.nc.checkpoint.new", "run.nc.checkpoint")}
    assert len(replaced) > 2
