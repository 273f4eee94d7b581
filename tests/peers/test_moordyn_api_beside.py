"""One script, run with MoorDyn-C's module and with ours: the same names, shapes and numbers.

At rest they agree to 1e-4 (1e-5 m and 1e-6 of forces were measured: what MoorDyn-C's relaxation leaves behind); the
fairlead force under a motion of 2 m in 10 s to 0.5 % of its standard deviation (0.12 % measured, from steps in time;
both hold velocities over 0.1 s).
"""

import inspect
import os

import decks
import numpy as np
import pytest
from beside import REFINED, needs

import moorage.moordyn as ours

pytestmark = needs("moordyn_c")

VECTORS = ("GetLineNodePos", "GetLineNodeVel", "GetLineNodeForce", "GetLineNodeTen", "GetLineNodeWeight",
           "GetLineNodeDrag", "GetLineNodeSeabedForce", "GetLineNodeM")  # fmt: skip
# not of MoorDyn's functions, or files that ours are not made from
LEFT_OUT = {"moorpy_export", "moorpy_ic"}


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    theirs = pytest.importorskip("moordyn")
    folder = tmp_path_factory.mktemp("api")
    path = decks.write(decks.CHAINS, folder, **REFINED)
    before = os.getcwd()
    os.chdir(folder)
    try:
        return {"ours": script(ours, path), "theirs": script(theirs, path)}
    finally:
        os.chdir(before)


def script(m, path):
    """Look at a mooring at rest, move it for 20 s, and look again."""
    system = m.Create(str(path))
    m.SetVerbosity(system, m.LEVEL_ERR)
    found = {"dof": m.NCoupledDOF(system), "lines": m.GetNumberLines(system), "points": m.GetNumberPoints(system)}
    points = [m.GetPoint(system, k) for k in (4, 5, 6)]
    x0 = np.concatenate([m.GetPointPos(p) for p in points])
    found["init"] = m.Init(system, x0, np.zeros(9))
    found["first"] = m.Step(system, x0, np.zeros(9), 0.0, 0.1)
    line = m.GetLine(system, 1)
    found["kinds"] = [m.GetPointType(p) for p in points], m.GetPointNAttached(points[0])
    found["attached"] = m.GetPointAttached(points[0], 0)[1]
    found["length"], found["ea"] = m.GetLineUnstretchedLength(line), m.GetLineConstantEA(line)
    for name in VECTORS:
        found[name] = np.array([getattr(m, name)(line, i) for i in range(m.GetLineN(line) + 1)])
    found["fair"], found["most"] = m.GetLineFairTen(line), m.GetLineMaxTen(line)
    found["point"], found["mass"] = np.array(m.GetPointForce(points[0])), np.array(m.GetPointM(points[0]))
    found["fast"] = np.array(m.GetFASTtens(system, 3))
    history, t = [], 0.1
    while t < 20.1:
        shift = [2.0 * (1.0 - np.cos(0.2 * np.pi * (s - 0.1))) for s in (t, t + 0.1)]
        x = x0 + np.tile([shift[0], 0.0, 0.0], 3)
        history.append(m.Step(system, x, np.tile([(shift[1] - shift[0]) / 0.1, 0.0, 0.0], 3), t, 0.1))
        t += 0.1
    found["history"], found["moved"] = np.array(history), np.array([m.GetPointPos(p) for p in points])
    with pytest.raises(ValueError, match="1st argument must have 9 components"):
        m.Step(system, [0.0], [0.0], t, 0.1)
    with pytest.raises(RuntimeError):
        m.Create(str(path) + ".none")
    found["close"] = m.Close(system)
    return found


def test_every_function_is_there_with_the_same_arguments():
    theirs = pytest.importorskip("moordyn")
    functions = {n: f for n, f in vars(theirs).items() if inspect.isfunction(f) and n not in LEFT_OUT}
    assert len(functions) == 100
    missing = [n for n in functions if not hasattr(ours, n)]
    assert missing == []
    for name, function in functions.items():
        wanted = list(inspect.signature(function).parameters)
        assert list(inspect.signature(getattr(ours, name)).parameters) == wanted, name
    constants = {n: v for n, v in vars(theirs).items() if n.isupper() and isinstance(v, int)}
    assert {n: getattr(ours, n) for n in constants} == constants
    classes = [n for n in vars(theirs.Generator) if n[0].isupper() and inspect.isclass(getattr(theirs.Generator, n))]
    assert len(classes) == 12
    for name in classes:
        wanted = list(inspect.signature(getattr(theirs.Generator, name)).parameters)
        assert list(inspect.signature(getattr(ours.Generator, name)).parameters)[: len(wanted)] == wanted, name


@pytest.mark.parametrize("name", ["dof", "lines", "points", "init", "kinds", "attached", "length", "ea", "close"])
def test_what_is_asked_for_is_answered_alike(results, name):
    assert results["ours"][name] == results["theirs"][name]


@pytest.mark.parametrize("name", ["first", "fair", "point", "mass", "fast", *VECTORS])
def test_numbers_at_rest(results, name, record_property):
    mine, other = np.array(results["ours"][name]), np.array(results["theirs"][name])
    assert mine.shape == other.shape
    if name == "fast":  # MoorDyn subtracts the weight of half a segment once more from the vertical forces
        mine, other = mine[::2], other[::2]
    scale = {"GetLineNodePos": 1.0, "GetLineNodeVel": 1.0, "GetLineNodeDrag": 1e4}.get(name, np.abs(other).max())
    error = float(np.abs(mine - other).max() / scale)
    record_property("error", error)
    assert error < 1e-4


def test_the_largest_tension_of_moordyn_leaves_out_the_last_node(results):
    for who, tensions in results.items():
        nodes = np.linalg.norm(tensions["GetLineNodeTen"], axis=1)
        assert tensions["most"] == pytest.approx((nodes if who == "ours" else nodes[:-1]).max(), rel=1e-6)


def test_the_history_of_forces(results, record_property):
    mine, other = results["ours"]["history"], results["theirs"]["history"]
    error = np.sqrt(np.mean((mine - other) ** 2)) / np.std(other, axis=0).max()
    record_property("error", error)
    assert error < 0.005
    np.testing.assert_allclose(results["ours"]["moved"], results["theirs"]["moved"], atol=1e-9)


def broken(m, path):
    """Break a chain at its fairlead after a second, and follow the free end for four more."""
    system = m.Create(str(path))
    m.SetVerbosity(system, m.LEVEL_ERR)
    points = [m.GetPoint(system, k) for k in (4, 5, 6)]
    x = np.concatenate([m.GetPointPos(p) for p in points])
    m.Init(system, x, np.zeros(9))
    line, track = m.GetLine(system, 1), []
    for k in range(100):
        if k == 20:
            m.BreakLine(system, points[0], line)
        force = m.Step(system, x, np.zeros(9), 0.05 * k, 0.05)
        track.append(m.GetLineNodePos(line, m.GetLineN(line)))
    found = np.array(track), m.GetNumberPoints(system), m.GetPointNAttached(points[0]), np.array(force)
    m.Close(system)
    return found


def test_a_broken_line_falls_as_there(tmp_path, monkeypatch, record_property):
    """The free end within 1e-3 of its way: 18 m in 4 s (1e-4 measured)."""
    theirs = pytest.importorskip("moordyn")
    monkeypatch.chdir(tmp_path)
    path = decks.write(decks.CHAINS, tmp_path, **REFINED)
    mine, other = broken(ours, path), broken(theirs, path)
    assert mine[1:3] == other[1:3] == (7, 0)
    way = np.linalg.norm(other[0][-1] - other[0][19])
    error = float(np.linalg.norm(mine[0] - other[0], axis=1).max() / way)
    record_property("error", error)
    assert error < 1e-3
    np.testing.assert_array_equal(mine[3][:3], 0.0)
