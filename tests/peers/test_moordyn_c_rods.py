"""MoorDyn-C's files and channels of rods and bodies, beside ours: header lines to the letter, and the numbers.

A free rod rises, a heavy one falls on to the seabed, a fixed one pierces the surface, a body sinks. Both solve the same
equations, MoorDyn-C in steps of 0.5 ms of fourth order, ours in steps of 2 ms of second order: 1e-5 of the largest number
of a kind, and 1e-3 for the heavy rod, which turns: MoorDyn-C leaves out the centripetal force on a free rod.

MoorDyn-C 2.7 takes no channel of a rod (it calls all of them invalid), so that those are held against its files of
rods. There it writes transverse drag (X) under the names of the axial one (Y), and the other way round, when both are
asked for; and zeros for the forces on fixed rods.
"""

import os
import warnings

import numpy as np
import pytest
from beside import needs

import moorage

pytestmark = needs("moordyn_c")

LETTERS = "pvfWBXYAaPb"
CHANNELS = (
    "Body1PX Body1PY Body1PZ Body1RX Body1RY Body1RZ Body1VX Body1VY Body1VZ B1RVX B1RVY B1RVZ\n"
    "Body1AX Body1AY Body1AZ Body1RAX Body1RAY Body1RAZ B1TEN Body1FX Body1FY Body1FZ Body1MX Body1MY Body1MZ\n"
    "Point1PX P1FZ Point2VX Point2AZ Point2T L1TENA L1TB Line1N2PX L1N1TEN L1N2FZ L1NAFX L1NBPZ L1N1VX"
)
RODS = {  # channel of a rod: file and column that MoorDyn-C has
    "Rod1PX": "Node0px", "R1VZ": "Node0vz", "R1N2PX": "Node2px", "R1N3VZ": "Node3vz", "Rod1N0FX": "Node0Fx",
    "Rod1NAFZ": "Node0Fz", "Rod1N2FX": "Node2Fx", "Rod1N2FZ": "Node2Fz", "R1NBFY": "Node4Fy",
}  # fmt: skip
DECK = """MoorDyn input of rods
---------------------- ROD TYPES ------------------------------------
TypeName      Diam     Mass/m    Cd     Ca      CdEnd    CaEnd
(name)        (m)      (kg/m)    (-)    (-)     (-)      (-)
buoy          0.8      300.0     0.9    1.0     0.6      0.7
heavy         0.8      700.0     0.9    1.0     0.6      0.7
---------------------- LINE TYPES ------------------------------------
Name   Diam   MassDen  EA         BA    EI   Cd   Ca   CdAx  CaAx
(-)    (-)    (-)      (-)        (-)   (-)  (-)  (-)  (-)   (-)
nylon  0.124  35.0     5515288.0  -0.8  0.0  1.6  1.0  0.05  0.0
---------------------- BODIES ----------------------------------------
ID   Attachment    X0     Y0     Z0     r0      p0     y0     Mass          CG*          I*      Volume   CdA*   Ca*
(#)     (-)        (m)    (m)    (m)   (deg)   (deg)  (deg)   (kg)          (m)         (kg-m^2)  (m^3)   (m^2)  (-)
1    free        -20     3    -20     10      20      30    5000    0             4000|5000|6000   2.0    0        1.0
---------------------- RODS ----------------------------------------
ID  RodType  Attachment  Xa  Ya   Za   Xb  Yb     Zb   NumSegs  RodOutputs
(#) (name)   (#/key)     (m) (m)  (m)  (m) (m)    (m)  (-)      (-)
1   buoy     free        3   -10  -22  6   -8.0  -19   4        {letters}
2   heavy    free        20  -10  -70.1  24  -9.0  -69.9   4        {letters}
3   buoy     fixed       30  -10  -3   31  -9.0  2   5        p
----------------------- POINTS ----------------------------------------------
ID  Type   X    Y    Z    M     V  CdA  CA
(-) (-)    (m)  (m)  (m)  (kg)  (m^3)  (m^2)  (-)
1   Fixed  -2.0  -10  -30   0.0  0  0    0
2   Free   40.0  -10  -30   800.0  0.5  1.0    0.5
-------------------------- LINES -------------------------------------------------
ID  LineType  NodeA  NodeB  UnstrLen  NumSegs  Outputs
(-) (-)       (-)    (-)    (m)       (-)      (-)
1   nylon     1      2       45        3        p
-------------------------- SOLVER OPTIONS---------------------------------------------------
0       writeLog
0.0005  dtM
rk4     tScheme
70      WtrDpth
3e4     kBot
1e3     cBot
0.0     TmaxIC
-------------------------- OUTPUTS ---------------------------------------------------
{channels}
--------------------------- need this line -------------------------------------------------
"""
TIME = 1.0
KINDS = ("", "_Rod1", "_Rod2", "_Rod3", "_Body1")


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    moordyn = pytest.importorskip("moordyn")
    folder = tmp_path_factory.mktemp("rods")
    path = folder / "their.txt"
    path.write_text(DECK.format(letters=LETTERS, channels=CHANNELS))
    before = os.getcwd()
    os.chdir(folder)
    try:
        system = moordyn.Create(str(path))
        moordyn.SetVerbosity(system, moordyn.LEVEL_ERR)
        assert moordyn.Init(system, [], []) == 0
        for k in range(4):
            moordyn.Step(system, [], [], 0.25 * k * TIME, 0.25 * TIME)
        moordyn.Close(system)
    finally:
        os.chdir(before)
    ours = folder / "our.txt"
    ours.write_text(path.read_text().replace(CHANNELS, CHANNELS + "\n" + "\n".join([*RODS, "R1N2FX R1FX"])))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        moorage.simulate(
            moorage.read(ours), duration=TIME, dt_out=0.25 * TIME, time_step=0.002, start="as-given",
            moordyn_out=folder / "our",
        )  # fmt: skip
    return {kind: [read(folder / f"{who}{kind}.out") for who in ("our", "their")] for kind in KINDS}


def read(path):
    names, units, *rows = path.read_text().splitlines()
    return names, units, np.array([row.split() for row in rows], dtype=float)


@pytest.mark.parametrize("kind", KINDS)
def test_header_lines_are_the_same(tables, kind):
    ours, theirs = tables[kind]
    assert ours[0].startswith(theirs[0])  # ours has the channels of rods behind
    assert ours[1].startswith(theirs[1])
    assert ours[2].shape[1] == theirs[2].shape[1] + (len(RODS) + 2 if kind == "" else 0)
    np.testing.assert_allclose(ours[2][:, 0], theirs[2][:, 0])


def columns(table, names):
    where = table[0].split()
    return table[2][1:, [where.index(name) for name in names]]


@pytest.mark.parametrize(
    ("kind", "ending"),
    [("_Rod1", ending) for ending in ("p", "v", "F", "W", "Bo", "Dp", "Dq")]
    + [("_Rod2", ending) for ending in ("p", "v", "F", "Bo", "B")],
)
def test_columns_of_rods(tables, kind, ending, record_property):
    ours, theirs = tables[kind]
    axes = "z" if kind == "_Rod2" and ending == "v" else "xyz"
    mine = columns(ours, [f"Node{i}{ending}{x}" for i in range(5) for x in axes])
    swapped = {"Dp": "Dq", "Dq": "Dp"}.get(ending, ending)
    other = columns(theirs, [f"Node{i}{swapped}{x}" for i in range(5) for x in axes])
    error = np.abs(mine - other).max() / max(np.abs(other).max(), 1.0)
    record_property("error", float(error))
    assert np.abs(mine).max() > 0.4
    assert error < (1e-5 if kind == "_Rod1" else 1e-3)


@pytest.mark.parametrize("ending", ["Ap", "Aq", "Pd"])
def test_still_water_pushes_nothing(tables, ending):
    for kind in ("_Rod1", "_Rod2"):
        for table in tables[kind]:
            where = [k for k, name in enumerate(table[0].split()) if name[5:7] == ending]
            assert len(where) == 15
            np.testing.assert_array_equal(table[2][:, where], 0.0)


@pytest.mark.parametrize("name", RODS)
def test_channels_of_rods(tables, name):
    mine, other = columns(tables[""][0], [name]), columns(tables["_Rod1"][1], [RODS[name]])
    np.testing.assert_allclose(mine, other, rtol=1e-5, atol=1e-5)


def test_columns_of_bodies(tables):
    ours, theirs = tables["_Body1"]
    np.testing.assert_allclose(ours[2], theirs[2], rtol=1e-4, atol=1e-5)  # six digits are written


def test_channels(tables, record_property):
    """Of the fixed point MoorDyn-C writes no force."""
    ours, theirs = tables[""]
    names = [name for name in theirs[0].split()[1:] if name != "P1FZ"]
    mine, other = columns(ours, names), columns(theirs, names)
    kind = [name[-2] if name[-1] in "XYZ" else "F" for name in names]  # P, V, A, F, M and so on
    size = np.array([max(np.abs(other[:, [k == one for k in kind]]).max(), 1e-3) for one in kind])
    error = np.abs(mine - other).max(axis=0) / size
    record_property("error", float(error.max()))
    assert error.max() < 1e-5, dict(zip(names, error, strict=True))
