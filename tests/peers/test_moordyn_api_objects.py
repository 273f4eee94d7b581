"""Rods and bodies that one script moves and looks at, through MoorDyn-C's module and through ours.

Both solve the same equations for rods, and for bodies that do not turn; MoorDyn-C takes steps of 1 ms of a second-order
scheme. Not compared: coupled-pinned rods, which MoorDyn-C 2.7 does not turn, and the forces on coupled bodies, whose own
weight and inertia it leaves out.
"""

from pathlib import Path

import numpy as np
import pytest
from beside import needs

import moorage.moordyn as ours

pytestmark = needs("moordyn_c")

DECKS = Path(__file__).parents[3] / "shared" / "reference" / "moordyn-c-tests"
ROD = """MoorDyn input of a rod and a line
---------------------- ROD TYPES ------------------------------------
TypeName      Diam     Mass/m    Cd     Ca      CdEnd    CaEnd
(name)        (m)      (kg/m)    (-)    (-)     (-)      (-)
buoy          1        1.0e3     0.5    1.0     0.6      0.7
---------------------- LINE TYPES ------------------------------------
Name   Diam   MassDen  EA         BA    EI   Cd   Ca   CdAx  CaAx
(-)    (-)    (-)      (-)        (-)   (-)  (-)  (-)  (-)   (-)
nylon  0.124  35.0     5515288.0  -0.8  0.0  1.6  1.0  0.05  0.0
---------------------- RODS ----------------------------------------
ID  RodType  Attachment  Xa  Ya   Za   Xb  Yb     Zb   NumSegs  RodOutputs
(#) (name)   (#/key)     (m) (m)  (m)  (m) (m)    (m)  (-)      (-)
1   buoy     {kind}      3   -10  -22  4   -10.0  -20  4        -
2   buoy     pinned      13  -10  -22  14  -10.0  -20  4        -
----------------------- POINTS ----------------------------------------------
ID  Type   X    Y    Z    M     V  CdA  CA
(-) (-)    (m)  (m)  (m)  (kg)  (m^3)  (m^2)  (-)
1   Free   0.0  -10  -2   20.0  0  0    0
2   Fixed  0.0  -10  -12  0     0  0    0
-------------------------- LINES -------------------------------------------------
ID  LineType  NodeA  NodeB  UnstrLen  NumSegs  Outputs
(-) (-)       (-)    (-)    (m)       (-)      (-)
1   nylon     2      1      9         3        -
-------------------------- SOLVER OPTIONS---------------------------------------------------
2      writeLog
0.001  dtM
70     WtrDpth
0.0    TmaxIC
1      disableOutput
--------------------------- need this line -------------------------------------------------
"""


@pytest.fixture
def theirs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return pytest.importorskip("moordyn")


def begin(m, text, x=(), name="deck.txt"):
    Path(name).write_text(text)
    system = m.Create(name)
    m.SetVerbosity(system, m.LEVEL_ERR)
    assert m.Init(system, list(x), [0.0] * len(x)) == 0
    return system


def drop(m, text, time):
    """Let go, and look at all rods and bodies after a time."""
    system, found = begin(m, text), {}
    for k in range(round(time / 0.05)):
        m.Step(system, [], [], 0.05 * k, 0.05)
    for k in range(1, m.GetNumberRods(system) + 1):
        rod = m.GetRod(system, k)
        n = m.GetRodN(rod)
        found[f"ends of rod {k}"] = np.array([m.GetRodNodePos(rod, i) for i in (0, n)])
        found[f"speed of rod {k}"] = np.array([m.GetRodNodeVel(rod, i) for i in (0, n)])
        found[f"force on rod {k}"] = np.array(m.GetRodForce(rod))
        found[f"mass of rod {k}"] = np.array(m.GetRodM(rod))[:3]
    for k in range(1, m.GetNumberBodies(system) + 1):
        body = m.GetBody(system, k)
        found[f"state of body {k}"] = np.array(m.GetBodyState(body))
        found[f"mass of body {k}"] = np.array(m.GetBodyM(body))[:3]
    m.SaveState(system, f"{m.__name__}.ic")
    m.Close(system)
    return found


CASES = {
    # deck: text, time (s), largest difference in units of the largest number of its kind
    "free and pinned rod": (ROD.replace("{kind}", "free"), 2.0, 1e-3),
    "AddedMass": ("rod_tests/AddedMass.txt", 2.0, 1e-5),
    "bodyDrag": ("body_tests/bodyDrag.txt", 2.0, 1e-3),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_let_go_moves_alike(theirs, name, record_property):
    """1e-5 to 5e-4 were measured (the pressure on a rod's ends is in its buoyancy here, and in MoorDyn-C's forces)."""
    text, time, tolerance = CASES[name]
    text = text if "\n" in text else (DECKS / text).read_text()
    mine, other = drop(ours, text, time), drop(theirs, text, time)
    assert list(mine) == list(other)
    worst = {key: float(np.abs(mine[key] - other[key]).max() / np.abs(other[key]).max()) for key in mine}
    record_property("error", str(worst))
    assert max(worst.values()) < tolerance, worst


def test_states_go_from_one_to_the_other(theirs):
    """A free and a pinned rod of MoorDyn-C's file stand here where they stood there, and the other way round.

    After a step of 1 ms, because MoorDyn-C does not show a state before; a h^2 / 2 = 2e-6 m at the 4 m/s2 that there are.
    """
    text = ROD.replace("{kind}", "free")
    there, here = drop(theirs, text, 1.0), drop(ours, text, 2.0)
    for m, file, wanted in ((ours, "moordyn.ic", there), (theirs, "moorage.moordyn.ic", here)):
        system = begin(m, text)
        m.LoadState(system, file)
        m.Step(system, [], [], 0.0, 1e-3)
        for k in (1, 2):
            ends = [m.GetRodNodePos(m.GetRod(system, k), i) for i in (0, 4)]
            there_now = wanted[f"ends of rod {k}"] + 1e-3 * wanted[f"speed of rod {k}"]
            np.testing.assert_allclose(ends, there_now, atol=1e-5)
        m.Close(system)


def coupled_rod(m, way, pitch):
    """Forces (200, 3) along x and z and moments about y that a host feels, which moves a rod by steps of 10 ms."""
    x0 = np.array([3.0, -10.0, -22.0, 0.0, pitch, 0.0])
    system, x, forces = begin(m, ROD.replace("{kind}", "Coupled"), x0), x0, []
    for k in range(200):
        target = x0 + 0.5 * (1.0 - np.cos(0.02 * (k + 1))) * np.array(way)
        forces.append(m.Step(system, x, (target - x) / 0.01, 0.01 * k, 0.01))
        x = target
    return np.array(forces)[:, [0, 2, 4]]


WAYS = {
    "still": (0, 0, 0, 0, 0, 0),
    "surge": (1, 0, 0, 0, 0, 0),
    "heave": (0, 0, 1, 0, 0, 0),
    "pitch": (1, 0, 0, 0, 0.2, 0),
}


@pytest.mark.parametrize("name", WAYS)
def test_a_host_feels_a_coupled_rod_alike(theirs, name, record_property):
    """A rod in water, held and moved: forces and moment to 0.5 % of their deviation.

    MoorDyn-C has no centripetal force there: as the rod turns, the mean vertical force is 1 % (4 % of its deviation) from
    ours. With m L / 2 w^2 of its mass and A_end L w^2 of the water at end B along the axis it is the same; without, the
    check must fail. MoorDyn-C's forces belong to one step earlier, and to it the angles count from where the file has the
    rod. Held, both feel weight less buoyancy, -4275.3 N.
    """
    upright = np.arctan2(1.0, 2.0)
    mine, other = coupled_rod(ours, WAYS[name], upright)[20:-1], coupled_rod(theirs, WAYS[name], 0.0)[21:]
    deviation = other.std(axis=0)
    if name == "still":
        assert np.abs(mine - other).max() < 1e-3
        return
    t, turn = 0.01 * np.arange(21, 200), WAYS[name][4]
    rate, angle = turn * np.sin(2.0 * t), upright + 0.5 * turn * (1.0 - np.cos(2.0 * t))
    length, end = np.sqrt(5.0), 0.7 * 1025.0 * np.pi / 12.0  # m, kg of water that goes with end B
    pull = rate**2 * length * (0.5 * 1e3 * length + end)
    centripetal = pull[:, None] * np.stack([np.sin(angle), np.cos(angle), 0.0 * angle], axis=1)
    error = np.sqrt(((mine - centripetal - other) ** 2).mean(axis=0)) / deviation
    record_property("error", str(error))
    assert (error < 5e-3).all(), error
    if turn:
        assert (np.sqrt(((mine - other) ** 2).mean(axis=0)) / deviation)[1] > 0.03


def kicked(m, ratio: float) -> np.ndarray:
    """Return the changes of velocity (m/s) by step of a host that is kicked once, and steps explicitly by 10 ms.

    A rod of 50 t in air rides on it; the host's own mass is that over `ratio`.
    """
    text = (
        (DECKS / "body_tests/pinnedBody.txt").read_text("utf-8", errors="replace").replace("CoupledPinned", "Coupled")
    )
    x, v, force, changes = np.array([0.0, 0.0, -5.0, 0.0, 0.0, 0.0]), np.zeros(6), 1e4, []
    system = begin(m, text, x)
    for k in range(120):
        change = 0.01 * force * ratio / 5e4
        v[1] += change
        force = m.Step(system, x, v, 0.01 * k, 0.01)[1]
        x = x + 0.01 * v
        changes.append(abs(change))
    m.Close(system)
    return np.array(changes)


def test_a_host_with_little_mass_of_its_own(theirs):
    """What rides on an explicit host may weigh 0.75 of it: where z^3 + r (4 z^2 + z - 2) / 3 has a root of size 1.

    With MoorDyn-C it may weigh as much as the host.
    """
    for m, ratio, stable in ((ours, 0.5, True), (ours, 0.9, False), (theirs, 0.9, True), (theirs, 1.1, False)):
        changes = kicked(m, ratio)
        assert (changes[-1] < 1e-3 * changes[0]) == stable, (m.__name__, ratio)
