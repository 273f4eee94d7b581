"""Every command, in this process and as a user starts it: what it prints, what it writes, and its exit code."""

import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import moorage
from moorage import cli, console
from moorage.results import checkpoint_path

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4"
MODEL, MOTION = str(EXAMPLE / "oc4.dat"), str(EXAMPLE / "motion.csv")


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")  # help texts unbroken


@pytest.fixture
def moorage_(monkeypatch):
    """Run a command in this process; stdout and stderr apart."""

    def run(*words, code=0):
        result = CliRunner().invoke(cli.app, [str(word) for word in words])
        assert result.exit_code == code, result.output + repr(result.exception)
        return result

    for name in ("out", "err"):  # the consoles were made with the streams of the importing process
        monkeypatch.setattr(getattr(console, name), "_file", None)
    return run


def shell(*words, **options):
    return subprocess.run(
        [sys.executable, "-m", "moorage.cli", *map(str, words)], capture_output=True, text=True, **options
    )


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    path = tmp_path_factory.mktemp("result") / "oc4.nc"
    moorage.simulate(
        moorage.read(MODEL), duration=20.0, motion=moorage.Motion.read(MOTION), dt_nodes=0.5, output=path
    ).close()
    return path


def numbers(line):
    return [float(word) for word in re.findall(r"-?\d+\.\d+", line)]


def test_help_and_version(moorage_):
    text = moorage_("--help").output
    for command in ("run", "static", "check", "info", "plot", "convert", "warmup"):
        assert command in text
    assert moorage_("--version").output == f"moorage {moorage.__version__}\n"
    options = moorage_("run", "--help").output
    flags = "--motion --duration --dt-out --tolerance --time-step --method --start --save --dt-nodes --resume -o"
    assert set(flags.split()) <= set(options.split())


def test_run_writes_a_result_and_a_figure_and_prints_a_table(moorage_):
    output = moorage_("run", MODEL, "--motion", MOTION, "--duration", 20, "--dt-nodes", 0.5).output
    assert Path("oc4.nc").stat().st_size > 1e5
    assert Path("oc4.png").read_bytes().startswith(b"\x89PNG")
    assert "results oc4.nc" in output
    assert "figure  oc4.png" in output
    assert not checkpoint_path(Path("oc4.nc")).exists()
    with moorage.open_result("oc4.nc") as ds:
        assert ds.sizes["time"] == 201
        assert ds.sizes["node_time"] == 41
        tension = ds["fairlead_tension"].sel(line=2).values / 1e3
        row = next(line for line in output.splitlines() if re.match(r"2 +fairlead", line))
        static = ds["static_fairlead_tension"].sel(line=2).item() / 1e3  # the motion starts with a velocity
        assert numbers(row)[0] == pytest.approx(static, abs=0.05)
        assert numbers(row)[3] == pytest.approx(tension.max(), abs=0.05)
    anchor = output.splitlines()[output.splitlines().index(row) + 1]
    assert len(numbers(anchor)) == 8  # five of tension, lowest, uplift, grounded
    assert max(map(len, output.splitlines())) <= 200


def test_run_takes_its_settings(moorage_):
    words = "--duration 0.5 --dt-out 0.25 --time-step 0.002 --method rk4 --start as-given --save tensions -o a.nc"
    moorage_("run", MODEL, *words.split())
    with moorage.open_result("a.nc") as ds:
        expected = {"duration": 0.5, "dt_out": 0.25, "time_step": 0.002, "method": "rk4", "start": "as-given"}
        expected |= {"save": "tensions", "dt_nodes": "none"}
        assert {name: ds.attrs[name] for name in expected} == expected
        assert "node_position" not in ds
        assert ds.sizes["time"] == 3
    assert Path("a.png").exists()


def test_run_lasts_as_long_as_its_motion(moorage_):
    rows = "\n".join(f"{t} 20.434 35.393 -14 -40.868 0 -14 20.434 -35.393 -14" for t in range(4))
    Path("motion.dat").write_text("# MoorDyn-F's columns\n" + rows + "\n")
    moorage_("run", MODEL, "--motion", "motion.dat")
    with moorage.open_result("oc4.nc") as ds:
        assert ds["time"].values[-1] == 3.0


def test_run_takes_a_driver_file_as_it_is(moorage_, reference):
    output = moorage_("run", reference / "r-test" / "md_cable" / "md_driver.inp", "--duration", 1).output
    assert "options that are not used here" in output
    with moorage.open_result("md_driver.nc") as ds:
        assert ds.attrs["start"] == "as-given"
        assert ds["time"].values[-1] == 1.0
        assert {"FAIRTEN1", "LINE3NAPZ"} <= set(ds)


def test_static_prints_json_alone_on_stdout():
    done = shell("static", MODEL, "--json")
    assert done.returncode == 0, done.stderr
    report = json.loads(done.stdout)
    assert [line["id"] for line in report["lines"]] == [1, 2, 3]
    assert report["lines"][0]["fairlead_tension"] == pytest.approx(1.0985e6, rel=1e-3)
    assert report["lines"][0]["anchor_tension"] == pytest.approx(900.6e3, rel=1e-3)
    assert report["lines"][0]["grounded_length"] == pytest.approx(250.0, abs=10.0)
    assert np.shape(report["stiffness"]) == (6, 6)
    assert report["stiffness"][0][0] == pytest.approx(70_122, rel=0.04)
    point = report["points"][3]
    assert (point["id"], point["position"]) == (4, [20.434, 35.393, -14.0])
    assert point["force"][2] == pytest.approx(-1886.8e3 / 3.0, rel=1e-3)
    assert report["residual"] < 1.0
    assert report["iterations"] > 0


def test_json_never_holds_what_is_no_json(monkeypatch):
    monkeypatch.setattr(moorage.results, "static_report", lambda ds: {"residual": float("nan")})
    result = CliRunner().invoke(cli.app, ["static", MODEL, "--json"])
    assert isinstance(result.exception, ValueError)
    assert "NaN" not in result.stdout


def test_static_prints_tables(moorage_):
    output = moorage_("static", MODEL).output
    assert "1098.4" in output
    assert "coupled" in output
    assert "surge" in output
    assert "out-of-balance force" in output


def test_check_says_what_a_file_holds(moorage_, deck):
    output = moorage_("check", deck()).output
    assert "1, 20 segments" in output
    assert "1 fixed, 1 coupled" in output
    assert "FAIRTEN1, L1N10PX" in output
    assert re.search(r"dtM 0.001 +\S", output)  # with the reason
    assert "no problems" in output
    bad = deck(("chain      1         2", "rope       1         2"), name="bad.dat")
    assert "bad.dat:15: " in moorage_("check", bad, code=2).output


def test_check_names_what_is_not_built(moorage_, deck):
    wavy = deck(("0.001    dtM       time step", "0.001    dtM       time step\n4 WaveKin"), name="wavy.dat")
    output = moorage_("check", wavy, code=2).output
    assert "not simulated yet" in output
    assert "wavy.dat:20" in output
    refused = moorage_("run", wavy, "--duration", 1, code=2)
    assert "wavy.dat:20" in refused.stderr


BODIES = """moorage: 1
environment: {water_depth: 50}
line_types: {chain: {diameter: 0.05, mass_per_length: 20, axial_stiffness: 5.0e7}}
bodies:
  - {id: 1, kind: free, position: [0, 0, -5], mass: MASS, volume: 2}
points:
  - {id: 1, kind: fixed, position: [0, 0, -50]}
  - {id: 2, kind: fixed, body: 1, position: [0, 0, 0]}
lines:
  - {id: 1, end_a: 1, end_b: 2, sections: [{line_type: LINE, length: 40, segments: 4}]}
"""


def test_check_names_what_a_run_would_refuse_or_warn_of(moorage_):
    """Bodies without mass, or without inertia about an axis: the same words as those of a run."""
    massless = (
        BODIES.replace("LINE", "thread")
        .replace("chain: {", "thread: {")
        .replace("mass_per_length: 20", "mass_per_length: 0")
    )
    for text, mass, code, words in (
        (massless, "0", 2, "body 1 is free, and can move without mass along x, y and z"),
        (BODIES.replace("LINE", "chain"), "500", 0, "body 1 is free, and can turn without inertia about x, y and z"),
    ):
        Path("bodies.yaml").write_text(text.replace("MASS", mass))
        output = " ".join(moorage_("check", "bodies.yaml", code=code).output.split())
        assert words in output
        run = moorage_("run", "bodies.yaml", "--duration", 0.1, code=code)
        assert words in " ".join(run.stderr.split())


def test_info_and_plot_on_a_result(moorage_, result):
    output = moorage_("info", result).output
    assert "status   complete" in output
    assert "OC4-DeepCwind" in output
    assert re.search(r"3 +fairlead +1098\.4", output)
    moorage_("plot", result, "-o", "picture.png")
    assert Path("picture.png").read_bytes().startswith(b"\x89PNG")
    moorage_("plot", result)
    assert result.with_suffix(".png").exists()


def test_convert_goes_both_ways(moorage_):
    moorage_("convert", MODEL, "oc4.yaml")
    moorage_("convert", "oc4.yaml", "again.dat")
    first, again = (json.loads(shell("static", name, "--json").stdout) for name in (MODEL, "again.dat"))
    assert first["lines"] == again["lines"]
    assert "not found" in moorage_("convert", "nothing.dat", "out.yaml", code=2).stderr


def test_convert_never_writes_over_what_it_reads(moorage_, deck):
    source = deck()
    text = source.read_bytes()
    link = source.with_name("link.dat")
    link.hardlink_to(source)
    for target in (source, source.parent / "." / "model.dat", link):
        assert "give another file" in moorage_("convert", source, target, code=2).stderr
    assert source.read_bytes() == text
    moorage_("convert", source, "other.dat")
    moorage_("convert", source, "other.dat")  # what was written may be written again


def test_raise_to_seabed_is_one_flag(moorage_, deck):
    buried = deck(("-837.6    0.0   -200.0", "-837.6    0.0   -201.5"), name="buried.dat")
    refused = moorage_("static", buried, code=2).stderr
    assert "below the seabed" in refused
    assert "200" in refused
    moorage_("static", buried, "--raise-to-seabed")


@pytest.mark.parametrize(
    ("words", "code", "message"),
    [
        (["run", "nothing.dat", "--duration", "1"], 2, "not found"),
        (["run", MODEL], 2, "--duration"),
        (["run", MODEL, "--duration", "-1"], 2, "duration must be a positive number"),
        (["run", MODEL, "--duration", "1", "--tolerance", "1e-3", "--time-step", "0.1"], 2, "not both"),
        (["run", MODEL, "--duration", "1", "--motion", "no.csv"], 2, "not found"),
        (["run", MODEL, "--duration", "400", "--motion", MOTION], 2, "motion ends at 300 s"),
        (["run", MODEL, "--duration", "1", "--resume"], 2, "nothing to resume"),
        (["run", MODEL, "--duration", "1", "-o", "no/such/folder.nc"], 2, "cannot write"),
        (["run", MODEL, "--duration", "9", "--method", "rk2", "--time-step", "0.2"], 3, "results up to"),
        (["run", MODEL, "--duration", "1", "-o", "picture.png"], 2, "write picture.png.nc"),
        (["run", MODEL, "--duration", "1", "-o", "result"], 2, "write result.nc"),
        (["info", MODEL], 2, "cannot read"),
        (["plot", "nothing.nc"], 2, "does not exist"),
        (["nonsense"], 2, "No such command"),
    ],
)
def test_errors_are_one_message_and_an_exit_code(words, code, message, moorage_):
    result = moorage_(*words, code=code)
    text = re.sub(r"\s+", " ", result.stderr)
    assert message in text
    assert "Traceback" not in result.output


def test_errors_of_a_process_never_show_a_traceback(deck):
    buried = deck(("chain      1         2", "chain      1         7"))
    done = shell("run", buried, "--duration", "1")
    assert done.returncode == 2
    assert "model.dat:15: " in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""


def test_a_bug_says_that_it_is_one(monkeypatch, capsys):
    monkeypatch.setattr(cli, "app", lambda: 1 / 0)
    monkeypatch.delenv("MOORAGE_DEBUG", raising=False)
    monkeypatch.setattr(console.err, "_file", sys.stderr)
    with pytest.raises(SystemExit) as left:
        cli.main()
    assert left.value.code == 1
    assert "this is a bug" in capsys.readouterr().err
    monkeypatch.setenv("MOORAGE_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        cli.main()


@pytest.mark.skipif(sys.platform == "win32", reason="Windows sends Ctrl-C to whole consoles only")
def test_ctrl_c_stops_cleanly_and_says_how_to_go_on():
    slow = ["run", MODEL, "--duration", "60", "--time-step", "0.001"]
    process = subprocess.Popen(
        [sys.executable, "-m", "moorage.cli", *slow], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    deadline = time.monotonic() + 240.0  # kernels may have to be compiled first
    while not checkpoint_path(Path("oc4.nc")).exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    _, message = process.communicate(timeout=60)
    assert process.returncode == 130, message
    stopped = float(re.search(r"stopped at ([\d.]+) s of 60 s", message)[1])
    assert "--resume" in message
    assert "Traceback" not in message
    with moorage.open_result("oc4.nc") as ds:
        assert ds.attrs["status"] == f"interrupted at {stopped:g} s"
        assert ds["time"].values[-1] == pytest.approx(stopped)


def test_warmup_compiles(moorage_):
    assert "kernels are ready" in moorage_("warmup").output
    assert not moorage.is_cold()
