"""The shipped example is a file that MoorDyn-C runs as it is, and they agree on its statics."""

import shutil
from pathlib import Path

import pytest

import moorage

moordyn = pytest.importorskip("moordyn", reason='MoorDyn-C is not installed: pip install ".[peers]"')
pytestmark = pytest.mark.peers

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4" / "oc4.dat"


def test_moordyn_c_runs_the_example(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copy(EXAMPLE, tmp_path)
    model = moorage.read(EXAMPLE)
    position = [x for point in model.coupled_points for x in point.position]
    system = moordyn.Create("oc4.dat")
    assert moordyn.NCoupledDOF(system) == 9
    moordyn.Init(system, position, [0.0] * 9)
    theirs = [moordyn.GetLineFairTen(moordyn.GetLine(system, k)) for k in (1, 2, 3)]
    forces = moordyn.Step(system, position, [0.0] * 9, 0.0, 0.1)
    moordyn.Close(system)
    assert len(forces) == 9
    ours = moorage.solve_statics(model)["fairlead_segment_tension"].values
    # the file leaves MoorDyn's dynamic relaxation at its defaults, which ends within 1 % of rest
    assert theirs == pytest.approx(ours.tolist(), rel=0.01)
