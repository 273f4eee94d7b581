"""`moorage.moordyn` keeps to MoorDyn-C's Python module: arguments, results, errors; a state survives bad calls."""

import dataclasses
import time
from pathlib import Path

import numpy as np
import pytest

import moorage
import moorage.moordyn as moordyn
from moorage.model import Current
from moorage.model.motion import rotation_matrices
from moorage.solve.coupling import Coupling, angular_velocity, described
from moorage.solve.host import HostMarch
from moorage.system.build import build

DT = 0.1
THREE = (
    ("1     Fixed        -837.6    0.0   -200.0", "1     Fixed        -837.6    0.0   -200.0   0   0   0   0\n"
     "2     Fixed        418.8    725.4   -200.0   0   0   0   0\n3     Fixed        418.8    -725.4   -200.0"),
    ("2     Coupled      -40.868   0.0   -14.0", "4     Coupled      -40.868   0.0   -14.0  0 0 0 0\n"
     "5     Coupled      20.434   35.393   -14.0   0   0   0   0\n6     Coupled      20.434   -35.393   -14.0"),
    ("1     chain      1         2         835.35     20        p", "1  chain  1  4  835.35  20  p\n"
     "2  chain  2  5  835.35  20  -\n3  chain  3  6  835.35  20  -"),
)  # fmt: skip


@pytest.fixture
def path(deck):
    return deck(("0.001    dtM       time step\n", ""))


@pytest.fixture
def system(path):
    made = moordyn.Create(str(path))
    assert moordyn.Init(made, start(made), [0.0] * 3) == 0
    return made


def start(system, point=2):
    return list(moordyn.GetPointPos(moordyn.GetPoint(system, point)))


def surge(system, count=5, speed=0.5):
    """Pull the fairlead away and return the forces of each step."""
    forces = []
    for _ in range(count):
        forces.append(moordyn.Step(system, start(system), [speed, 0.0, 0.0], system.time, DT))
    return np.array(forces)


def test_life_of_a_system(path):
    system = moordyn.Create(str(path))
    assert moordyn.NCoupledDOF(system) == 3
    assert [moordyn.GetNumberLines(system), moordyn.GetNumberPoints(system)] == [1, 2]
    assert [moordyn.GetNumberRods(system), moordyn.GetNumberBodies(system)] == [0, 0]
    assert start(system) == [-40.868, 0.0, -14.0]
    assert moordyn.Init(system, start(system), [0, 0, 0]) == moordyn.ERRCODE_SUCCESS
    force = moordyn.Step(system, start(system), [0, 0, 0], 0.0, DT)
    assert isinstance(force, tuple)
    assert all(isinstance(f, float) for f in force)
    still = moorage.solve_statics(moorage.read(path))["point_force"].sel(point=2).values
    np.testing.assert_allclose(force, still, rtol=1e-4, atol=1e-3 * abs(still).max())
    assert moordyn.Close(system) == 0
    with pytest.raises(RuntimeError, match="closed"):
        moordyn.Step(system, [0] * 3, [0] * 3, 0.1, DT)


def test_the_default_file_is_that_of_moordyn(path, monkeypatch):
    folder = path.parent / "Mooring"
    folder.mkdir()
    (folder / "lines.txt").write_text(path.read_text())
    monkeypatch.chdir(path.parent)
    assert moordyn.GetNumberLines(moordyn.Create()) == 1


def test_a_file_that_cannot_be_read_is_a_runtime_error(tmp_path):
    with pytest.raises(RuntimeError, match="invalid"):
        moordyn.Create("file.invalid")
    wrong = tmp_path / "wrong.dat"
    wrong.write_text("--- LINE TYPES ---\nnonsense\n")
    with pytest.raises(RuntimeError):
        moordyn.Create(str(wrong))


def test_positions_are_those_at_the_start_and_velocities_hold(system):
    """After a step from x by v a point is at x + v dt, with v: MoorDyn's rule."""
    x = start(system)
    moordyn.Step(system, x, [0.5, 0.0, -0.2], 0.0, DT)
    np.testing.assert_allclose(start(system), np.add(x, [0.05, 0.0, -0.02]), atol=1e-12)
    point, line = moordyn.GetPoint(system, 2), moordyn.GetLine(system, 1)
    np.testing.assert_allclose(moordyn.GetPointVel(point), [0.5, 0.0, -0.2], atol=1e-9)
    np.testing.assert_allclose(moordyn.GetLineNodePos(line, 20), start(system), atol=1e-12)


def test_a_step_of_no_time_gives_the_forces_again(system):
    force = surge(system)[-1]
    np.testing.assert_allclose(moordyn.Step(system, [0] * 3, [0] * 3, system.time, 0.0), force, rtol=1e-12)


@pytest.mark.parametrize(
    ("x", "v", "t", "dt", "error", "words"),
    [
        ([0.0, 0.0], [0.0] * 3, 0.5, DT, ValueError, "1st argument must have 3 components"),
        ([0.0] * 3, [0.0] * 4, 0.5, DT, ValueError, "2nd argument must have 3 components"),
        ([0.0, np.nan, 0.0], [0.0] * 3, 0.5, DT, RuntimeError, "NaN"),
        ([0.0] * 3, [np.inf, 0.0, 0.0], 0.5, DT, RuntimeError, "NaN"),
        ([0.0] * 3, [0.0] * 3, 0.2, DT, RuntimeError, "restore"),
        ([0.0] * 3, [0.0] * 3, 0.5, -DT, RuntimeError, "time must go on"),
        ([0.0] * 3, [0.0] * 3, np.nan, DT, RuntimeError, "time must go on"),
        ([1e200, 0.0, 0.0], [0.0] * 3, 0.5, DT, RuntimeError, "stopped"),
    ],
)
def test_a_bad_step_is_refused_and_changes_nothing(system, x, v, t, dt, error, words):
    surge(system)
    before = moordyn.Serialize(system)
    with pytest.raises(error, match=words):
        moordyn.Step(system, x, v, t, dt)
    assert moordyn.Serialize(system) == before


def test_a_bad_start_is_an_error_code(path, capsys):
    system = moordyn.Create(str(path))
    with pytest.raises(ValueError, match="1st argument must have 3 components"):
        moordyn.Init(system, [0.0], [0.0])
    assert moordyn.Init(system, [np.nan] * 3, [0.0] * 3) == moordyn.ERRCODE_NAN_ERROR
    assert "NaN" in capsys.readouterr().err
    with pytest.raises(RuntimeError, match="before Init"):
        moordyn.Step(system, start(system), [0.0] * 3, 0.0, DT)


def test_a_clock_one_step_behind_is_warned_of(system, capsys):
    """MoorDyn-C's own test of rotations calls twice with one time; its clock counts, not the host's."""
    surge(system, 2)
    moordyn.Step(system, start(system), [0.0] * 3, 0.1, DT)
    assert "its own clock counts" in capsys.readouterr().err
    assert system.time == pytest.approx(0.3)


def test_saved_states_come_back_bit_for_bit(system, path, tmp_path):
    surge(system)
    state, file = moordyn.Serialize(system), tmp_path / "state"
    moordyn.Save(system, str(file))
    forces = surge(system)
    moordyn.Deserialize(system, state)
    np.testing.assert_array_equal(surge(system), forces)
    other = moordyn.Create(str(path))
    moordyn.Init_NoIC(other, start(other), [0] * 3)
    moordyn.Load(other, str(file))
    np.testing.assert_array_equal(surge(other), forces)
    with pytest.raises(RuntimeError, match="no saved state"):
        moordyn.Deserialize(system, b"nonsense")


def test_a_limit_of_the_steps_stays_when_a_state_comes_back(system, path, tmp_path):
    surge(system)
    state, file = moordyn.Serialize(system), tmp_path / "state"
    moordyn.SaveState(system, str(file))
    for load in (lambda s: moordyn.Deserialize(s, state), lambda s: moordyn.LoadState(s, str(file))):
        other = moordyn.Create(str(path))
        moordyn.SetDt(other, 0.01)
        assert moordyn.Init(other, start(other), [0.0] * 3) == 0
        load(other)
        assert moordyn.GetDt(other) == 0.01
        assert other.host.march.clocks.step.max() <= 0.01


def test_what_a_host_has_set_goes_with_a_state(system, path):
    line, other = moordyn.GetLine(system, 1), moordyn.Create(str(path))
    plain, given = moordyn.Serialize(system), moordyn.GetLineConstantEA(line)
    moordyn.SetDt(system, 0.02)
    moordyn.SetLineConstantEA(line, 5e8)
    moordyn.SetLineUnstretchedLengthVel(line, 0.1)
    surge(system)
    state, forces = moordyn.Serialize(system), surge(system)
    for fresh in (other, system):
        if fresh is other:
            assert moordyn.Init_NoIC(other, start(other), [0.0] * 3) == 0
        moordyn.Deserialize(fresh, state)
        assert moordyn.GetDt(fresh) == 0.02
        assert moordyn.GetLineConstantEA(moordyn.GetLine(fresh, 1)) == 5e8
        assert np.array_equal(surge(fresh), forces)
    moordyn.Deserialize(system, plain)
    assert moordyn.GetLineConstantEA(line) == given
    length = moordyn.GetLineUnstretchedLength(line)
    surge(system)
    assert moordyn.GetLineUnstretchedLength(line) == length


def test_states_in_moordyns_format(system, path, tmp_path):
    """Positions and velocities only: the run goes on within the error of the accelerations it begins without."""
    surge(system, 20)
    file = tmp_path / "moordyn.ic"
    moordyn.SaveState(system, str(file))
    assert file.read_bytes()[:7] == b"MoorDyn"
    other = moordyn.Create(str(path))
    moordyn.Init_NoIC(other, start(system), [0.5, 0.0, 0.0])
    moordyn.LoadState(other, str(file))
    line = [moordyn.GetLine(s, 1) for s in (system, other)]
    for i in range(1, 20):
        assert moordyn.GetLineNodePos(line[0], i) == moordyn.GetLineNodePos(line[1], i)
    np.testing.assert_allclose(surge(other)[-1], surge(system)[-1], rtol=0.01)
    file.write_bytes(file.read_bytes()[:-8])
    with pytest.raises(RuntimeError, match="no state of MoorDyn"):
        moordyn.LoadState(other, str(file))


def test_objects_know_themselves(system):
    line, anchor, fairlead = moordyn.GetLine(system, 1), moordyn.GetPoint(system, 1), moordyn.GetPoint(system, 2)
    assert [moordyn.GetLineID(line), moordyn.GetPointID(fairlead)] == [1, 2]
    assert [moordyn.GetLineN(line), moordyn.GetLineNumberNodes(line)] == [20, 21]
    assert moordyn.GetLineUnstretchedLength(line) == 835.35
    assert moordyn.IsLineConstantEA(line)
    assert moordyn.GetLineConstantEA(line) == 7.536e8
    assert not moordyn.IsLinePressBend(line)
    assert moordyn.GetPointType(anchor) == moordyn.POINT_TYPE_FIXED
    assert moordyn.GetPointType(fairlead) == moordyn.POINT_TYPE_COUPLED
    assert moordyn.GetPointNAttached(fairlead) == 1
    attached, end = moordyn.GetPointAttached(fairlead, 0)
    assert (moordyn.GetLineID(attached), end) == (1, moordyn.ENDPOINT_B)
    for wrong in (lambda: moordyn.GetLine(system, 0), lambda: moordyn.GetPoint(system, 3)):
        with pytest.raises(RuntimeError, match="there is no"):
            wrong()
    with pytest.raises(RuntimeError, match="nodes 0 to 20"):
        moordyn.GetLineNodePos(line, 21)
    with pytest.raises(TypeError, match="system"):
        moordyn.GetNumberLines(None)


def test_parts_of_the_node_forces_add_up(system):
    """Net force = difference of the pulls + weight + drag + water's acceleration + seabed, at each inner node."""
    surge(system, 20)
    line = moordyn.GetLine(system, 1)
    parts = (moordyn.GetLineNodeWeight, moordyn.GetLineNodeDrag, moordyn.GetLineNodeFroudeKrilov,
             moordyn.GetLineNodeSeabedForce, moordyn.GetLineNodeBendStiff)  # fmt: skip
    r = np.array([moordyn.GetLineNodePos(line, i) for i in range(21)])
    T = system.block["segment_tension"]
    pull = T[:, None] * np.diff(r, axis=0) / np.linalg.norm(np.diff(r, axis=0), axis=1)[:, None]
    scale = np.linalg.norm(pull, axis=1).max()
    for i in range(1, 20):
        total = pull[i] - pull[i - 1] + sum(np.array(part(line, i)) for part in parts)
        np.testing.assert_allclose(moordyn.GetLineNodeForce(line, i), total, atol=1e-9 * scale)
        np.testing.assert_allclose(moordyn.GetLineNodeTen(line, i), 0.5 * (pull[i] + pull[i - 1]), atol=1e-9 * scale)
    assert moordyn.GetLineFairTen(line) == pytest.approx(T[-1])
    assert moordyn.GetLineMaxTen(line) == pytest.approx(
        max(np.linalg.norm(moordyn.GetLineNodeTen(line, i)) for i in range(21))
    )
    assert moordyn.GetLineNodeCurv(line, 10) == 0.0


def test_mass_of_a_node_is_that_of_its_share_with_added_mass(system):
    """Transverse: m l + rho A l Ca; along the line m l + rho A l CaAx, with l the length between two middles."""
    line = moordyn.GetLine(system, 1)
    M = np.array(moordyn.GetLineNodeM(line, 19))
    l, area = 835.35 / 20, 0.25 * np.pi * 0.0766**2
    expected = sorted(113.35 * l + 1025.0 * area * l * np.array([0.25, 0.8, 0.8]))
    np.testing.assert_allclose(np.linalg.eigvalsh(M), expected, rtol=1e-9)
    at_end = np.array(moordyn.GetPointM(moordyn.GetPoint(system, 2)))
    np.testing.assert_allclose(np.linalg.eigvalsh(at_end), 0.5 * np.array(expected), rtol=1e-9)


def test_fast_tensions_are_the_ends(system):
    fair_h, fair_v, anchor_h, _ = moordyn.GetFASTtens(system, 1)
    force = np.array(moordyn.GetPointForce(moordyn.GetPoint(system, 2)))
    assert fair_h[0] == pytest.approx(np.hypot(*force[:2]))
    assert fair_v[0] == pytest.approx(force[2])
    assert anchor_h[0] == pytest.approx(fair_h[0], rel=0.01)  # without friction
    with pytest.raises(RuntimeError, match="there are 1 lines"):
        moordyn.GetFASTtens(system, 2)


def test_a_line_can_be_shortened_and_stiffened(system):
    line = moordyn.GetLine(system, 1)
    for _ in range(100):
        slack = moordyn.Step(system, start(system), [0.0] * 3, system.time, DT)
    moordyn.SetLineUnstretchedLength(line, 833.0)
    assert moordyn.GetLineUnstretchedLength(line) == pytest.approx(833.0)
    for _ in range(600):
        tight = moordyn.Step(system, start(system), [0.0] * 3, system.time, DT)
    model = dataclasses.replace(system.model, file="")
    expected = moorage.solve_statics(model)["point_force"].sel(point=2).values
    np.testing.assert_allclose(tight, expected, rtol=0.01, atol=100.0)
    assert np.linalg.norm(tight) > 1.03 * np.linalg.norm(slack)
    moordyn.SetLineConstantEA(line, 1e8)
    assert moordyn.GetLineConstantEA(line) == 1e8
    assert np.isfinite(moordyn.Step(system, start(system), [0.0] * 3, system.time, DT)).all()
    moordyn.SetLineUnstretchedLengthVel(line, 0.5)
    moordyn.Step(system, start(system), [0.0] * 3, system.time, DT)
    assert moordyn.GetLineUnstretchedLength(line) == pytest.approx(833.05)
    for wrong in (0.0, -1.0, np.nan):
        with pytest.raises(RuntimeError):
            moordyn.SetLineUnstretchedLength(line, wrong)


def test_a_broken_line_falls(system):
    surge(system)
    point, line = moordyn.GetPoint(system, 2), moordyn.GetLine(system, 1)
    before = np.array(moordyn.GetLineNodePos(line, 20))
    moordyn.BreakLine(system, point, line)
    assert moordyn.GetNumberPoints(system) == 3
    assert moordyn.GetPointNAttached(point) == 0
    freed = moordyn.GetPoint(system, 3)
    assert moordyn.GetPointType(freed) == moordyn.POINT_TYPE_FREE
    np.testing.assert_allclose(moordyn.GetPointPos(freed), before, atol=1e-9)
    force = surge(system, 20)
    np.testing.assert_allclose(force, 0.0)
    assert moordyn.GetPointPos(freed)[2] < before[2] - 1.0
    with pytest.raises(RuntimeError, match="does not hold on"):
        moordyn.BreakLine(system, point, line)


@pytest.mark.parametrize("failure", ["1   2   1   0.25   0", "1   2   1   0   1000"])
def test_failures_come_at_their_time_or_tension(deck, failure):
    rows = f"---------------------- FAILURE ----\nID Point Lines Time Tension\n(-) (-) (-) (s) (N)\n{failure}\n"
    path = deck(("---------------------- OPTIONS", rows + "---------------------- OPTIONS"), ("0.001    dtM       time step\n", ""))  # fmt: skip
    system = moordyn.Create(str(path))
    assert moordyn.Init(system, start(system), [0.0] * 3) == 0
    forces = surge(system, 4)
    held = np.linalg.norm(forces, axis=1) > 0.0
    assert held.tolist() == ([True, True, False, False] if "0.25" in failure else [False] * 4)


def test_the_host_may_give_the_water(deck):
    path = deck(("0.001    dtM       time step", "1   WaveKin"))
    system = moordyn.Create(str(path))
    moordyn.Init(system, start(system), [0.0] * 3)
    n = moordyn.ExternalWaveKinInit(system)
    assert n == moordyn.ExternalWaveKinGetN(system) == 21 + 2 + 1  # nodes, points, the ground
    where = moordyn.ExternalWaveKinGetCoordinates(system)
    assert where == moordyn.GetWaveKinCoordinates(system)
    np.testing.assert_allclose(where[0], [-837.6, 0.0, -200.0])
    assert moordyn.ExternalWaveKinSet(system, [[0.0, 1.0, 0.0]] * n, [[0.0] * 3] * n, 0.0) == 0
    for _ in range(600):
        force = moordyn.Step(system, start(system), [0.0] * 3, system.time, DT)
    current = Current(z=(-200.0, 0.0), velocity=((0.0, 1.0, 0.0),) * 2)
    model = dataclasses.replace(
        system.model, environment=dataclasses.replace(system.model.environment, current=current)
    )
    expected = moorage.solve_statics(model)["point_force"].sel(point=2).values
    np.testing.assert_allclose(force, expected, atol=0.01 * np.linalg.norm(expected))
    saved = moordyn.Serialize(system)  # with the water
    other = moordyn.Create(str(path))
    moordyn.Init(other, start(other), [0.0] * 3)
    still = moordyn.Serialize(other)
    moordyn.Deserialize(other, saved)
    again, on = (moordyn.Step(s, start(s), [0.0] * 3, s.time, DT) for s in (other, system))
    np.testing.assert_array_equal(again, on)
    moordyn.Deserialize(other, still)  # without
    for _ in range(3):
        force = moordyn.Step(other, start(other), [0.0] * 3, other.time, DT)
    assert abs(force[1]) < 1e-3 * abs(force[0])
    with pytest.raises(ValueError, match="24 x 3"):
        moordyn.ExternalWaveKinSet(system, [[0.0] * 3], [[0.0] * 3], 0.0)
    with pytest.raises(RuntimeError, match="NaN or inf among the accelerations"):
        moordyn.ExternalWaveKinSet(system, [[0.0] * 3] * 24, [[np.nan] * 3] * 24, 0.0)
    assert moordyn.GetSeafloor(system) is None
    assert moordyn.GetWavesKin(moordyn.GetWaves(system), 0.0, 0.0, -10.0) == ((0.0,) * 3, (0.0,) * 3, 0.0, 0.0)


def test_logs(system, tmp_path, capsys):
    file = tmp_path / "run.log"
    assert moordyn.SetLogFile(system, str(file)) == 0
    assert moordyn.SetLogLevel(system, moordyn.LEVEL_MSG) == 0
    assert moordyn.SetVerbosity(system, moordyn.LEVEL_NONE) == 0
    moordyn.Log(system, moordyn.LEVEL_MSG, "ready to work")
    moordyn.Log(system, moordyn.LEVEL_DBG, "not this")
    text = file.read_text()
    assert "MSG " in text
    assert "test_logs() : ready to work" in text
    assert "not this" not in text
    assert capsys.readouterr().err == ""
    assert moordyn.SetLogFile(system, str(tmp_path / "none" / "run.log")) == moordyn.ERRCODE_INVALID_OUTPUT_FILE


def test_a_step_can_be_limited_before_the_start(path):
    system = moordyn.Create(str(path))
    assert moordyn.GetDt(system) == 0.15
    moordyn.SetDt(system, 0.01)
    moordyn.Init(system, start(system), [0.0] * 3)
    assert moordyn.GetDt(system) == 0.01
    surge(system, 1)
    assert system.host.march.counters["steps"] >= 10
    with pytest.raises(RuntimeError, match="no time step"):
        moordyn.SetDt(system, 0.0)


def test_before_the_start_lines_are_on_their_catenaries(path):
    system = moordyn.Create(str(path))
    line = moordyn.GetLine(system, 1)
    np.testing.assert_allclose(moordyn.GetLineNodePos(line, 20), start(system))
    assert 1e5 < moordyn.GetLineFairTen(line) < 1e7
    assert not system.started
    for call in (
        lambda: moordyn.Serialize(system),
        lambda: moordyn.BreakLine(system, moordyn.GetPoint(system, 2), line),
    ):
        with pytest.raises(RuntimeError, match="before Init"):
            call()


def test_steps_and_schemes(system):
    moordyn.SetDt(system, 0.01)
    assert moordyn.GetDt(system) == 0.01
    cfl = moordyn.GetCFL(system)
    assert cfl == pytest.approx(0.01 * np.sqrt(7.536e8 / 113.35) / (835.35 / 20) * np.sqrt(2.0), rel=1e-6)  # end nodes
    moordyn.SetCFL(system, 2.0 * cfl)
    assert moordyn.GetDt(system) == pytest.approx(0.02)
    steps = system.host.march.counters["steps"]
    surge(system, 1)
    assert system.host.march.counters["steps"] - steps >= 5
    assert moordyn.GetTimeScheme(system) == "implicit"
    moordyn.SetTimeScheme(system, "RK4")
    assert moordyn.GetTimeScheme(system) == "RK4"
    with pytest.raises(RuntimeError, match="no time scheme"):
        moordyn.SetTimeScheme(system, "magic")


def test_out_files_are_written_beside_the_input(deck):
    """At every step, or at dtOut; they go on when a line breaks; disableOutput leaves them out."""
    path = deck(("0.001    dtM       time step", "0.2  dtOut"), ("L1N10PX", "L1N10PX Point2FX"))
    system = moordyn.Create(str(path))
    moordyn.Init(system, start(system), [0.0] * 3)
    forces = surge(system, 4)
    held = moordyn.GetPointForce(moordyn.GetPoint(system, 2))
    moordyn.BreakLine(system, moordyn.GetPoint(system, 2), moordyn.GetLine(system, 1))
    surge(system, 2)
    assert moordyn.Close(system) == 0
    lines = (path.parent / "model.out").read_text().splitlines()
    assert lines[0].split() == ["Time", "FairTen1", "L1N10PX", "Point2FX"]
    rows = np.array([line.split() for line in lines[2:]], dtype=float)
    np.testing.assert_allclose(rows[:, 0], [0.0, 0.2, 0.4, 0.6])
    np.testing.assert_allclose(rows[2, 3], held[0], rtol=1e-6)
    np.testing.assert_allclose(held[0], forces[-1][0], rtol=1e-6)
    assert rows[3, 3] == 0.0
    nodes = (path.parent / "model_Line1.out").read_text().splitlines()
    assert len(nodes) == len(lines)
    quiet = deck(("0.001    dtM       time step", "1  disableOutput"), name="quiet.dat")
    system = moordyn.Create(str(quiet))
    moordyn.Init(system, start(system), [0.0] * 3)
    surge(system)
    assert not (path.parent / "quiet.out").exists()


BODY = (
    ("---------------------- POINTS", "---------------------- BODIES ---\n"
     "ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca\n(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (-) (m3) (m2) (-)\n"
     "1  Coupled  0 0 0  0 0 0  0 0 0 0 0 0\n---------------------- POINTS"),
    ("2     Coupled      -40.868   0.0   -14.0", "2     Body1      -40.868   0.0   -14.0"),
)  # fmt: skip


def test_a_coupled_body_carries_its_points(deck):
    """Force and moment about the body's origin; angles add up as intrinsic XYZ Euler angles."""
    system = moordyn.Create(str(deck(*BODY)))
    assert moordyn.NCoupledDOF(system) == 6
    body = moordyn.GetBody(system, 1)
    assert moordyn.GetBodyType(body) == moordyn.BODY_TYPE_COUPLED
    assert moordyn.GetPointType(moordyn.GetPoint(system, 2)) == moordyn.POINT_TYPE_FIXED
    moordyn.Init(system, [0.0] * 6, [0.0] * 6)
    rates = np.radians([2.0, -1.0, 3.0])
    for k in range(10):
        pose, _ = moordyn.GetBodyState(body)
        load = moordyn.Step(system, pose, [0.1, 0.0, 0.2, *rates], k * DT, DT)
    pose, rate = moordyn.GetBodyState(body)
    np.testing.assert_allclose(pose, [0.1, 0.0, 0.2, *rates], atol=1e-12)
    spin = angular_velocity(np.array([rates]), np.array([rates]))[0]
    np.testing.assert_allclose(rate, [0.1, 0.0, 0.2, *spin], atol=1e-9)
    R = rotation_matrices(rates[None])[0]
    arm = R @ [-40.868, 0.0, -14.0]
    fairlead = moordyn.GetPoint(system, 2)
    np.testing.assert_allclose(moordyn.GetPointPos(fairlead), np.add(arm, [0.1, 0.0, 0.2]), atol=1e-9)
    spin = np.array(moordyn.GetBodyAngVel(body))
    np.testing.assert_allclose(moordyn.GetPointVel(fairlead), np.add([0.1, 0.0, 0.2], np.cross(spin, arm)), atol=1e-9)
    np.testing.assert_allclose(load[3:], np.cross(arm, load[:3]), atol=1e-6 * abs(np.array(load)).max())
    force = moordyn.GetBodyForce(body)
    np.testing.assert_allclose(force[:3], moordyn.GetPointForce(fairlead), rtol=1e-9)
    np.testing.assert_allclose(moordyn.GetBodyPos(body) + moordyn.GetBodyAngle(body), pose)
    assert moordyn.GetBodyVel(body) == pytest.approx((0.1, 0.0, 0.2))


def test_a_body_without_lines_turns_its_points(tmp_path):
    """One turn about all axes at once, in three steps, ends where the angles say."""
    path = tmp_path / "turn.txt"
    path.write_text(
        "--- BODIES ---\nID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG I Volume CdA Ca\n(#) (-) m m m d d d kg m - m3 m2 -\n"
        "1 coupled 0 0 0 0 0 0 0 0 0 0 0 0\n--- POINTS ---\nID Type X Y Z M V CdA Ca\n(-) (-) m m m kg m3 m2 -\n"
        "1 Body1 1 0 0 0 0 0 0\n2 Body1 0 1 0 0 0 0 0\n--- OPTIONS ---\n100 WtrDpth\n0 TmaxIC\n--- end ---\n"
    )
    system = moordyn.Create(str(path))
    body = moordyn.GetBody(system, 1)
    assert moordyn.Init(system, [0.0] * 6, [0.0] * 6) == 0
    for k in range(3):
        force = moordyn.Step(system, moordyn.GetBodyState(body)[0], [0.0, 0.0, 0.0, 0.1, 0.2, 0.3], float(k), 1.0)
    R = rotation_matrices(np.array([[0.3, 0.6, 0.9]]))[0]
    for k in (1, 2):
        np.testing.assert_allclose(moordyn.GetPointPos(moordyn.GetPoint(system, k)), R[:, k - 1], atol=1e-12)
    assert force == (0.0,) * 6


def test_angular_velocity_is_the_rate_of_the_rotation():
    """R(t + h) R(t - h)^T = 1 + 2 h [w] + O(h^3): h = 1e-4 gives 1e-8 of it."""
    angles, rates, h = np.array([[0.3, -0.7, 1.1]]), np.array([[0.2, 0.5, -0.4]]), 1e-4
    R0, R1 = (rotation_matrices(angles + s * h * rates)[0] for s in (-1.0, 1.0))
    W = (R1 @ R0.T - R0 @ R1.T) / (4.0 * h)
    np.testing.assert_allclose(angular_velocity(angles, rates)[0], [W[2, 1], W[0, 2], W[1, 0]], atol=1e-7)


def test_rods_on_coupled_bodies_turn_their_clamps(deck):
    """The host drives points, ends of rods and the directions of clamps; described angles give back the description."""
    rods = (
        "---------------------- ROD TYPES ---\nName Diam Mass Cd Ca CdEnd CaEnd\n(-) (m) (kg/m) (-) (-) (-) (-)\n"
        "tube 0.2 0 0 0 0 0\n---------------------- RODS ---\nID Type Attachment Xa Ya Za Xb Yb Zb NumSegs Outputs\n"
        "(#) (-) (-) (m) (m) (m) (m) (m) (m) (-) (-)\n1 tube Coupled -40.868 0 -14 -39.868 0 -13 1 -\n"
        "---------------------- POINTS"
    )
    path = deck(("---------------------- POINTS", rods), ("2     Coupled      -40.868   0.0   -14.0    0      0        0      0\n", ""), ("1         2         835.35", "1         R1A       835.35"), ("-0.8       0  ", "-0.8       1e5  "))  # fmt: skip
    system = moordyn.Create(str(path))
    pose = described(system.model)
    assert moordyn.Init(system, pose, [0.0] * 6) == 0
    rod = moordyn.GetRod(system, 1)
    assert [moordyn.GetRodID(rod), moordyn.GetRodN(rod), moordyn.GetRodNumberNodes(rod)] == [1, 1, 2]
    assert moordyn.GetRodType(rod) == moordyn.ROD_TYPE_COUPLED
    np.testing.assert_allclose(moordyn.GetRodNodePos(rod, 1), [-39.868, 0.0, -13.0], atol=1e-12)
    load = moordyn.Step(system, pose, [0.0, 0.0, 0.0, 0.0, 0.1, 0.0], 0.0, DT)
    turned = np.add(pose, [0, 0, 0, 0, 0.01, 0])
    axis = rotation_matrices(turned[None, 3:])[0][:, 2]
    np.testing.assert_allclose(np.subtract(moordyn.GetRodNodePos(rod, 1), moordyn.GetRodNodePos(rod, 0)), np.sqrt(2.0) * axis, atol=1e-9)  # fmt: skip
    assert np.linalg.norm(load[3:]) > 100.0  # the clamp's moment
    built = build(system.model)
    host = HostMarch(built)
    places, _ = Coupling(system.model, built, host.driven).at(pose, np.zeros(6))
    np.testing.assert_allclose(places, host.position, atol=1e-12)


def test_three_lines_step_in_less_than_a_millisecond(deck):
    """Three chains of 20 segments in steps of 0.1 s: 0.1 ms here; ten times that is allowed for."""
    system = moordyn.Create(str(deck(*THREE)))
    x0 = np.concatenate([start(system, k) for k in (4, 5, 6)])
    assert moordyn.Init(system, x0, np.zeros(9)) == 0
    times = []
    for k in range(100):
        v = np.tile([0.5 * np.cos(0.6 * k * DT), 0.0, 0.0], 3)
        begin = time.perf_counter()
        moordyn.Step(system, system.pose, v, k * DT, DT)
        times.append(time.perf_counter() - begin)
    assert np.median(times) < 1e-3


def test_files_can_be_put_together_in_a_script():
    mooring, made = moordyn.Generator.Mooring(), moordyn.Generator
    chain = made.LineMaterial("chain", 0.0766, 113.35, 7.536e8, -0.8, 0, 2.0, 0.8, 0.4, 0.25)
    ends = [made.Point("Fixed", [-837.6, 0, -200], 0, 0, 0, 0), made.Point("Coupled", [-40.868, 0, -14], 0, 0, 0, 0)]
    mooring.AddLineMaterial(chain)
    for end in ends:
        mooring.AddPoint(end)
    mooring.AddLine(made.Line(chain, made.LinePoint(ends[0]), made.LinePoint(ends[1]), 835.35, 20))
    mooring.AddOption(made.Option("WtrDpth", 200))
    system = mooring.Create()
    assert moordyn.GetNumberLines(system) == 1
    assert moordyn.GetLineUnstretchedLength(moordyn.GetLine(system, 1)) == 835.35
    body = made.Body(made.BodyPoint(coupled=True), [0, 0, 0], [0, 0, np.pi], 1.0, 0.0, [1, 2, 3], 0.0, 1.0)
    assert str(body.words()[1]) == "Coupled"
    assert body.words()[7] == pytest.approx(180.0)
    assert body.words()[8:] == (1.0, "0.0", "1|2|3", 1.0, "0.0", "0.0")
    body.name = 2
    tube = made.RodMaterial("tube", 0.5, 100.0, 1.0, 1.0, 0.5, 0.5)
    rod = made.Rod(tube, made.RodPoint(pinned=True, body=body), [0, 0, 0], [0, 0, 2], 4)
    assert " ".join(map(str, rod.words())) == "0 tube Body2Pinned 0 0 0 0 0 2 4 -"
    kinds = {"Pinned": {"pinned": True}, "CoupledPinned": {"pinned": True, "coupled": True}, "Free": {"fixed": False}}
    assert {name: str(made.RodPoint(**how)) for name, how in kinds.items()} == {name: name for name in kinds}


def test_everything_that_can_be_put_together_can_be_read():
    """Bodies, rods, failures and options in one file."""
    made = moordyn.Generator
    mooring = made.Mooring()
    chain = made.LineMaterial("chain", 0.0766, 113.35, 7.536e8, -0.8, 0, 2.0, 0.8, 0.4, 0.25)
    tube = made.RodMaterial("tube", 0.5, 0.0, 0.0, 0.0, 0.0, 0.0)
    body = made.Body(made.BodyPoint(coupled=True), [0, 0, 0], [0, 0, 0.5], 0.0, 0.0, 0.0, 0.0, 0.0)
    rod = made.Rod(tube, made.RodPoint(body=body), [-40, 0, -14], [-41, 0, -14], 1)
    anchor = made.Point("Fixed", [-737.0, -400.0, -200.0], 0, 0, 0, 0)
    line = made.Line(chain, made.LinePoint(anchor), made.LinePoint(rod, "B"), 835.35, 20)
    mooring.AddLineMaterial(chain)
    mooring.AddRodMaterial(tube)
    mooring.AddBody(body)
    mooring.AddRod(rod)
    mooring.AddPoint(anchor)
    mooring.AddLine(line)
    mooring.AddFailure(made.Failure(made.LinePoint(anchor), [line], 100.0, 0.0))
    mooring.AddOption(made.Option("WtrDpth", 200))
    system = mooring.Create()
    assert [moordyn.GetNumberBodies(system), moordyn.GetNumberRods(system), moordyn.NCoupledDOF(system)] == [1, 1, 6]
    pose = moordyn.GetBodyState(moordyn.GetBody(system, 1))[0]
    np.testing.assert_allclose(pose, [0, 0, 0, 0, 0, 0.5])
    end = moordyn.GetRodNodePos(moordyn.GetRod(system, 1), 1)
    np.testing.assert_allclose(end, [-41.0 * np.cos(0.5), -41.0 * np.sin(0.5), -14.0])
    assert [failure.time for failure in system.failures] == [100.0]


def test_the_seafloor_is_a_grid_of_levels(deck, monkeypatch):
    """MoorDyn-C's layout: counts, x, y, then x y z; looked for beside the input and where the program is started."""
    path = deck(("0.001    dtM       time step", "Mooring/bed.txt SeafloorFile"))
    folder = path.parent / "Mooring"
    folder.mkdir()
    rows = [f"{x} {y} {-200.0 - 0.01 * (x + 1000.0)}" for x in (-1000.0, 1000.0) for y in (-500.0, 500.0)]
    (folder / "bed.txt").write_text("2 2\n-1000 1000\n-500 500\n" + "\n".join(rows) + "\n")
    moved = folder / "lines.txt"
    moved.write_text(path.read_text())
    monkeypatch.chdir(path.parent)
    for file in (path, moved):
        bed = moordyn.GetSeafloor(moordyn.Create(str(file)))
        assert moordyn.GetDepthAt(bed, 0.0, 100.0) == pytest.approx(-210.0)
        assert moordyn.GetAverageDepth(bed) == pytest.approx(-210.0)
        assert moordyn.GetMinDepth(bed) == pytest.approx(-200.0)


def test_waves_are_those_of_the_model():
    path = Path(__file__).parents[2] / "examples" / "waves" / "cable_in_waves.yaml"
    system = moordyn.Create(str(path))
    waves, place = system.model.environment.waves, np.array([10.0, -5.0, -12.0])
    size = moordyn.NCoupledDOF(system)
    assert moordyn.Init(system, system.pose, np.zeros(size)) == 0
    for k in range(12):
        moordyn.Step(system, system.pose, np.zeros(size), 0.5 * k, 0.5)
    u, a, eta, pressure = moordyn.GetWavesKin(moordyn.GetWaves(system), *place)
    expected = waves.kinematics(6.0, place)
    assert abs(float(expected.elevation)) > 0.01
    current = np.subtract(u, expected.velocity)
    np.testing.assert_allclose(current, [-0.5 * (48.0 / 60.0) ** (1.0 / 7.0), 0.0, 0.0], atol=0.01)
    np.testing.assert_allclose(a, expected.acceleration, atol=1e-9)
    assert (eta, pressure) == (pytest.approx(float(expected.elevation)), pytest.approx(float(expected.pressure)))
    with pytest.raises(RuntimeError, match="waves of its own"):
        moordyn.ExternalWaveKinSet(system, [], [], 0.0)
