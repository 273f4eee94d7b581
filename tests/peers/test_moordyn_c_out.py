"""MoorDyn-C's own .out files beside ours: the same files, header lines and units, and numbers at rest to 1e-5.

A chain at rest, so that nothing depends on time steps; 2e-6 was measured, of the force of the seabed. Node 0, at the
anchor, is left out.
"""

import os
import warnings

import numpy as np
import pytest
from beside import REFINED, needs

import moorage

pytestmark = needs("moordyn_c")

ASK = "pvUDVtcsdbK"


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    moordyn = pytest.importorskip("moordyn")
    from conftest import DECK  # noqa: PLC0415 (tests/conftest.py, which peers import by pytest's path)

    folder = tmp_path_factory.mktemp("out")
    text = DECK.replace("835.35     20        p", f"835.35     20        {ASK}").replace(
        "FairTen1", "FairTen1\nAnchTen1 Point2FZ\nL1N19Ten"
    )
    text = text.replace(
        "0.001    dtM       time step", "\n".join(f"{v} {k}" for k, v in REFINED.items() if k != "disableOutput")
    )
    path = folder / "their.txt"
    path.write_text(text)
    before = os.getcwd()
    os.chdir(folder)
    try:
        system = moordyn.Create(str(path))
        x = moordyn.GetPointPos(moordyn.GetPoint(system, 2))
        assert moordyn.Init(system, x, [0.0] * 3) == 0
        moordyn.Step(system, x, [0.0] * 3, 0.0, 0.5)
        moordyn.Close(system)
    finally:
        os.chdir(before)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        moorage.simulate(moorage.read(path), duration=0.5, dt_out=0.5, moordyn_out=folder / "our")
    return {kind: [read(folder / f"{who}{kind}.out") for who in ("our", "their")] for kind in ("", "_Line1")}


def read(path):
    names, units, *rows = path.read_text().splitlines()
    return names, units, np.array([row.split() for row in rows], dtype=float)


@pytest.mark.parametrize("kind", ["", "_Line1"])
def test_header_lines_are_the_same(tables, kind):
    ours, theirs = tables[kind]
    assert ours[0] == theirs[0]
    assert ours[1] == theirs[1]
    assert ours[2].shape == theirs[2].shape


@pytest.mark.parametrize(("start", "scale"), [("Fair", 0), ("Anch", 0), ("Point2FZ", 0), ("L1N19", 0)])
def test_channels(tables, start, scale):
    (names, _, ours), (_, _, theirs) = tables[""]
    k = next(k for k, name in enumerate(names.split()) if name.startswith(start))
    assert ours[-1, k] == pytest.approx(theirs[-1, k], rel=1e-5)


@pytest.mark.parametrize("ending", ["px", "pz", "vx", "Ux", "Dx", "Vx", "Te", "St", "bz", "Ku"])
def test_line_columns(tables, ending, record_property):
    (names, _, ours), (_, _, theirs) = tables["_Line1"]
    columns = [k for k, name in enumerate(names.split()) if name.endswith(ending) and not name.startswith("Node0")]
    mine, other = ours[-1, columns], theirs[-1, columns]
    scale = np.abs(other).max()
    error = np.abs(mine - other).max() / (scale if ending not in ("vx", "Ux", "Dx", "Vx", "Ku") else 1.0 + scale)
    record_property("error", float(error))
    assert error < 1e-5
