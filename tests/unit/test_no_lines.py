"""A model of rods and bodies alone, as some of MoorDyn-C's decks are: every command shows what there is, or says why not."""

import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import moorage
from moorage import cli

ROD = """moorage: 1
environment: {water_depth: 50}
rod_types: {spar: {diameter: 1.0, mass_per_length: 300, transverse_drag: 1.0, transverse_added_mass: 1.0}}
rods:
  - {id: 1, kind: free, rod_type: spar, end_a: [0, 0, -8], end_b: [0, 0, 2], segments: 10}
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("rod")
    (path / "rod.yaml").write_text(ROD)
    outcome = command(path, "run", "rod.yaml", "--duration", "4", "--start", "as-given")
    assert outcome.exit_code == 0, outcome.output
    return path


def command(folder: Path, *words: str):
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        return CliRunner().invoke(cli.app, list(words))


def test_run_draws_how_far_it_goes(folder):
    assert (folder / "rod.png").read_bytes().startswith(b"\x89PNG")
    ds = moorage.open_result(folder / "rod.nc")
    (ax,) = moorage.plot.figure.result_figure(ds).axes
    (curve,) = ax.get_lines()
    place = ds["rod_position"].values[:, 0, 0]
    np.testing.assert_allclose(curve.get_ydata(), np.linalg.norm(place - place[0], axis=-1))
    assert curve.get_ydata().max() > 1.0
    assert ax.get_ylabel() == "way from the start (m)"


def test_statics_are_shown(folder):
    assert "end A of rod 1" in command(folder, "static", "rod.yaml").output
    assert json.loads(command(folder, "static", "rod.yaml", "--json").stdout)["lines"] == []


@pytest.mark.parametrize(
    ("words", "made"),
    [
        (("plot", "rod.nc", "-o", "again.png"), "again.png"),
        (("report", "rod.nc"), "rod-report.html"),
        (("report", "rod.nc", "-o", "rod.pdf"), "rod.pdf"),
        (("view", "rod.nc", "--no-open", "-o", "rod.html"), "rod.html"),
        (("vtk", "rod.nc"), "rod-vtk/mooring.pvd"),
        (("info", "rod.nc"), "rod.nc"),
    ],
)
def test_what_can_be_shown_is(folder, words, made):
    outcome = command(folder, *words)
    assert outcome.exit_code == 0, outcome.output
    assert (folder / made).stat().st_size > 100


@pytest.mark.parametrize(
    ("words", "why"),
    [
        *(
            (("plot", "rod.nc", "--what", what), f"without lines has no {what}")
            for what in ("profile", "history", "envelope", "spectrum", "map")
        ),
        (("animate", "rod.nc", "-o", "rod.gif"), "without lines has no film"),
    ],
)
def test_what_cannot_says_why(folder, words, why):
    outcome = command(folder, *words)
    assert outcome.exit_code == 2
    assert why in " ".join(outcome.stderr.split())
