"""Winches in native files, MoorDyn's files and on the command line; what is wrong with them, in words."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
import xarray as xr
from typer.testing import CliRunner
from winches import chain_to_anchor, load_on_rope, winch

import moorage
from moorage.cli import app
from moorage.io import read, write_moordyn, write_native
from moorage.model import Control, Curve
from moorage.model.payout import driven

OUT = Curve((0.0, 2.0, 20.0), (0.0, 0.5, 0.5))


NATIVE = """moorage: 1
environment: {water_depth: 100}
line_types: {chain: {diameter: 0.1, mass_per_length: 100, axial_stiffness: 5.0e8, axial_damping_ratio: 0.3}}
points:
  - {id: 1, kind: fixed, position: [0, 0, seabed]}
  - {id: 2, kind: coupled, position: [150, 0, 0]}
lines:
  - {id: 1, end_a: 1, end_b: 2, sections: [{line_type: chain, length: 210, segments: 21}]}
controls:
  - {channel: 3, lines: [1], CONTROL}
"""


def native(tmp_path, control):
    path = tmp_path / "model.yaml"
    path.write_text(NATIVE.replace("CONTROL", control))
    return path


def test_a_native_file_gives_a_table_in_place(tmp_path):
    control = read(native(tmp_path, "length: {x: [0, 10], y: [0, 5]}, end: A")).controls[0]
    assert (control.channel, control.end, control.length) == (3, "A", Curve((0.0, 10.0), (0.0, 5.0)))


def test_a_native_file_names_a_table(tmp_path):
    (tmp_path / "out.csv").write_text("time,length\n0,0\n10,5\n20,5\n")
    path = native(tmp_path, "length: {file: out.csv}, segment_range: [0.5, 2.0]")
    model = read(path)
    assert model.controls[0].length == Curve((0.0, 10.0, 20.0), (0.0, 5.0, 5.0))
    write_native(model, tmp_path / "again.yaml")
    assert read(tmp_path / "again.yaml").controls == model.controls


def test_a_native_file_gives_a_constant_rate(tmp_path):
    assert read(native(tmp_path, "rate: 0.2")).controls[0].rate == 0.2


@pytest.mark.parametrize(
    ("control", "message"),
    [
        ("length: 5", "model.yaml:10: length of a control is not a table"),
        ("length: {x: [0, 5, 5], y: [0, 1, 2]}", "times of length of control channel 3 do not increase"),
        ("rate: {x: [0], y: [0]}", "rate of control channel 3 has 1 rows"),
        ("rate: 1, length: {x: [0, 5], y: [0, 1]}", "control channel 3 has both length and rate"),
        ("rate: 1, segment_range: [0.5, 1.2]", "segment range of control channel 3 leaves no segments"),
        ("rate: .nan", "rate of control 1 (channel 3) is not a number"),
        ("rates: 1", "key of control 1 (channel 3) is not known"),
        ("rate: 1, end: C", "end of control 1 (channel 3) is not known"),
    ],
)
def test_wrong_controls_are_refused_with_their_place(tmp_path, control, message):
    with pytest.raises(moorage.ModelError) as error:
        read(native(tmp_path, control))
    assert message in str(error.value)
    assert "model.yaml:" in str(error.value)
    assert "->" in str(error.value)


def test_a_line_has_one_winch():
    model = chain_to_anchor(winch(0.1))
    twice = dataclasses.replace(model, controls=(*model.controls, Control(channel=2, lines=(1,), end="A")))
    with pytest.raises(moorage.ModelError, match="channel 2 names line 1, which follows channel 1"):
        moorage.solve_statics(twice)
    with pytest.raises(moorage.ModelError, match="channel 1 is described twice"):
        moorage.solve_statics(dataclasses.replace(model, controls=2 * model.controls))


def test_a_line_that_would_be_hauled_in_is_refused_before_the_run():
    with pytest.raises(moorage.ModelError, match=r"line 1 would have 0\.5 m left of the section at its winch at 199 s"):
        moorage.simulate(load_on_rope(winch(-0.5)), duration=300.0)
    with pytest.raises(moorage.ModelError, match="line 1 would have"):
        moorage.solve_statics(load_on_rope(winch(length=Curve((0.0, 1.0), (-100.0, 0.0)))))


def test_a_rate_too_fast_for_the_segments_is_refused():
    with pytest.raises(moorage.ModelError, match=r"a rate of 1000 m/s at .* makes a segment every 0\.01 s"):
        moorage.simulate(load_on_rope(winch(1000.0)), duration=1.0)


def test_what_a_winch_cannot_do_yet_is_refused_by_name():
    soft = load_on_rope(winch(0.1), bending_stiffness=Curve((0.0, 0.1), (0.0, 10.0)))
    with pytest.raises(moorage.UnsupportedError, match="winch at end B of line 1 with a table of EI"):
        moorage.solve_statics(soft)


def test_a_winch_that_nothing_drives_is_told():
    with pytest.warns(moorage.ModelWarning, match="nothing drives control channel 1"):
        ds = moorage.simulate(load_on_rope(winch()), duration=0.2)
    assert np.ptp(ds["line_length"].values) == 0.0


def test_payout_of_a_channel_that_is_not_there():
    with pytest.raises(moorage.ModelError, match="no control channel 7"):
        moorage.simulate(load_on_rope(winch()), duration=1.0, payout={7: OUT})
    assert driven(load_on_rope(winch(0.5)), {1: OUT}).controls[0] == winch(length=OUT)


def test_a_moordyn_file_with_control_runs_from_the_command_line(tmp_path):
    model = chain_to_anchor(winch())
    write_moordyn(model, tmp_path / "model.dat", "F")
    (tmp_path / "out.csv").write_text("time,channel 1\n0,0\n4,3\n6,3\n")
    arguments = ["run", str(tmp_path / "model.dat"), "--duration", "6", "--payout", str(tmp_path / "out.csv")]
    done = CliRunner().invoke(app, [*arguments, "-o", str(tmp_path / "run.nc")])
    assert done.exit_code == 0, done.output
    with xr.open_dataset(tmp_path / "run.nc") as ds:
        assert float(ds["line_length"][-1, 0]) == pytest.approx(213.0)
        assert ds.sizes["segment"] == 21  # MoorDyn's way: the last segment is stretched up to twice its length
    wrong = CliRunner().invoke(app, [*arguments[:-1], str(tmp_path / "model.dat")])
    assert wrong.exit_code == 2


def test_a_channel_of_moordyn_may_have_several_rows(tmp_path):
    model = chain_to_anchor(winch())
    second = dataclasses.replace(model.lines[0], id=2)
    write_moordyn(dataclasses.replace(model, lines=(*model.lines, second)), tmp_path / "model.dat", "F")
    text = (tmp_path / "model.dat").read_text().splitlines()
    row = next(k for k, line in enumerate(text) if "CONTROL" in line) + 3
    (tmp_path / "model.dat").write_text("\n".join([*text[: row + 1], " 1 2", *text[row + 1 :]]))
    control = read(tmp_path / "model.dat").controls
    assert [(c.channel, c.lines, c.segment_range) for c in control] == [(1, (1, 2), (0.5, 2.0))]
