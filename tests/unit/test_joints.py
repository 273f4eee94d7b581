"""Joints of cables at every door: files of MoorDyn, runs, lines that come off, hosts, states, loads, modes."""

import dataclasses
import json
import warnings

import numpy as np
import pytest
from cables import JOINT, at_once
from moorings import fixed, held, joint, kind, line, mooring, statics
from typer.testing import CliRunner

import moorage
import moorage.moordyn as moordyn
from moorage.cli import app
from moorage.errors import UnsupportedError
from moorage.io import write_native
from moorage.model import ExternalLoad, Failure, Motion


@pytest.fixture
def deck(tmp_path):
    def write(kind: str = "Free"):
        path = tmp_path / "joint.txt"
        path.write_text(JOINT.replace("KIND", kind))
        return path

    return write


def model(kind_: str = "free", **parts):
    rod = dataclasses.replace(joint(1, 0.0, 0.0, -30.0), kind=kind_)
    points = fixed(1, -14.0, 0.0, -22.0), fixed(2, 12.0, 6.0, -24.0), fixed(3, 9.0, -9.0, -20.0)
    cable = kind("cable", diameter=0.15, mass_per_length=40.0, axial_stiffness=1e7, bending_stiffness=5e3,
                 axial_damping_ratio=0.8, transverse_drag=1.2)  # fmt: skip
    lines = [line(1, 1, held(rod, "A"), ("cable", 18.0, 9)), line(2, held(rod, "B"), 2, ("cable", 17.0, 8)),
             line(3, held(rod, "B"), 3, ("cable", 17.0, 7))]  # fmt: skip
    return dataclasses.replace(mooring(cable, points, lines, (rod,), water_depth=60.0), **parts)


def test_a_file_of_moordyn_is_read_written_and_run(deck, tmp_path):
    read = moorage.read(deck())
    still = moorage.solve_statics(read)
    again = tmp_path / "again.yaml"
    moorage.convert(deck(), again)
    same = moorage.solve_statics(moorage.read(again))
    place = still["rod_position"].values[0]
    assert same["rod_position"].values[0] == pytest.approx(place, abs=0.01)  # the exact rule for the paper's
    assert np.abs(moorage.simulate(read, duration=0.1)["rod_moment"].values[0]).max() < 1e-6  # TmaxIC 0: as given
    run = moorage.simulate(
        read, start="static", motion=Motion.from_harmonics(8.0, ramp=4.0, heave=(0.5, 6.0)), duration=8.0
    )
    assert np.abs(run["rod_position"].values[:, 0, 0] - place[0]).max() > 0.05
    assert np.abs(run["rod_moment"].values).max() < 10.0  # N m, of 500 in each cable: what turns half segments


@pytest.mark.parametrize("kind_", ["pinned", "coupled-pinned"])
def test_a_joint_that_is_held_passes_moments(kind_):
    built = statics(model(kind_))
    moments = at_once(built)["end_moment"][0]
    at_joint = [moments[0, 1], moments[1, 0], moments[2, 0]]
    assert min(np.linalg.norm(m) for m in at_joint) > 50.0
    assert np.linalg.norm(sum(at_joint)) < 0.01
    assert at_once(built)["rod_position"][0, 0, 0] == pytest.approx([0.0, 0.0, -30.0], abs=1e-12)


def test_lines_that_come_off_a_joint():
    """Two of the three come off in turn, and the last one hangs from its anchor, pinned to nothing."""
    hold = held(joint(1, 0.0, 0.0, 0.0), "B")
    failures = tuple(Failure(id=k, attachment=hold, lines=(1 + k,), time=0.2 * k) for k in (1, 2))
    run = moorage.simulate(model(failures=failures), duration=3.0)
    assert np.isfinite(run["rod_position"].values).all()
    assert run["rod_position"].values[-1, 0, 0, 2] < run["rod_position"].values[0, 0, 0, 2] - 1.0


def test_a_force_on_a_joint_acts_at_its_place():
    load = ExternalLoad(id=1, target="rod", target_id=1, force=(0.0, 300.0, 0.0))
    pulled, plain = (at_once(statics(model(external_loads=loads))) for loads in ((load,), ()))
    assert pulled["rod_position"][0, 0, 0, 1] > plain["rod_position"][0, 0, 0, 1] + 0.1
    force = [
        sum(block["end_force"][0, line, end] for line, end in ((0, 0), (1, 1), (2, 1))) for block in (pulled, plain)
    ]
    assert force[0] - force[1] == pytest.approx([0.0, 300.0, 0.0], abs=0.1)


def test_a_pair_with_a_spring_is_no_hinge():
    """A spring of 0 at one of two cables pins both, one that is large clamps them: formerly springs did not count."""
    plain = dataclasses.replace(model(), lines=model().lines[:2])
    moments = []
    for spring in (None, 1e9, 0.0):
        lines = plain.lines[0], dataclasses.replace(plain.lines[1], end_a_stiffness=spring)
        moments.append(at_once(statics(dataclasses.replace(plain, lines=lines)))["bending_moment"][0, [9, 10]])
    assert moments[1] == pytest.approx(moments[0], rel=1e-4, abs=1e-2)
    assert moments[0][0] == pytest.approx(moments[0][1])
    assert moments[0][0] > 50.0
    assert np.abs(moments[2]).max() < 1e-6


def test_states_of_moordyn_hold_joints(deck, tmp_path):
    """Bit for bit in its own file; one without a rotation, as MoorDyn writes, is turned by the cables."""
    path, file = str(deck()), tmp_path / "state.bin"
    system = moordyn.Create(path)
    x = np.array([12.0, 6.0, -24.0])
    moordyn.Init(system, x, np.zeros(3))
    t = 0.0
    for _ in range(10):
        moordyn.Step(system, x, [0.5, 0.0, 0.0], t, 0.05)
        t += 0.05
        x[0] += 0.025
    moordyn.SaveState(system, str(file))
    other = moordyn.Create(path)
    moordyn.Init_NoIC(other, x, np.zeros(3))
    moordyn.LoadState(other, str(file))
    nodes = system.built.system.riders.row[0] + 1  # what follows is the rotation since the step's start
    assert other.built.state.position[:nodes] == pytest.approx(system.built.state.position[:nodes], abs=1e-9)
    axes = system.built.state.attitude[0].reshape(3, 3)
    assert other.built.state.attitude[0].reshape(3, 3) == pytest.approx(axes, abs=1e-9)
    data = bytearray(file.read_bytes())
    at = 17 + 8 + 16 + 24  # the head, the number of parts, the shape of the first one, its position
    data[at : at + 32] = np.array([0.0, 0.0, 0.0, 1.0]).tobytes()
    file.write_bytes(bytes(data))
    moordyn.LoadState(other, str(file))
    assert other.built.state.attitude[0].reshape(3, 3)[:, 0] == pytest.approx(axes[:, 0], abs=0.05)
    for each in (system, other):
        moordyn.Close(each)


def test_modes_of_a_joint_are_positive():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert (moorage.natural_modes(model(), 4)["frequency"].values > 0.0).all()


def test_stiffness_at_a_coupled_pin_is_refused():
    with pytest.raises(UnsupportedError, match="rod 1 hangs from a coupled pin"):
        moorage.stiffness(model("coupled-pinned"))


def test_statics_at_a_coupled_pin_say_that_there_is_no_stiffness(tmp_path):
    path = tmp_path / "joint.yaml"
    write_native(model("coupled-pinned"), path)
    printed = CliRunner().invoke(app, ["static", str(path)]).stdout
    assert "is not computed: rods or bodies hang from a coupled pin" in " ".join(printed.split())
    assert "nan" not in printed
    report = json.loads(CliRunner().invoke(app, ["static", str(path), "--json"]).stdout)
    assert report["stiffness"] == [[None] * 6] * 6
