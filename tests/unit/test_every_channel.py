"""Every output channel of MoorDyn-C and MoorDyn-F by name: given, or refused with the reason.

Both programs take a line, rod, point or body by number, a node where there are nodes, and one of 29 words. Of what they
have no number for they write zeros; that is refused here by name. Values are held against MoorDyn-C live in
tests/peers/test_moordyn_c_rods.py and test_moordyn_c_out.py, and against closed forms and differences in
tests/verification/test_rod_nodes.py.
"""

import dataclasses
import warnings

import numpy as np
import pytest

import moorage
from moorage.model.channels import QUANTITIES, parse_channel, why_not

XYZ = "XYZ"
WORDS = [word + x for word in ("P", "R", "V", "RV", "A", "RA", "F", "M") for x in XYZ]
WORDS += ["T", "TEN", "TA", "TENA", "TB", "TENB", "SUB"]
# what MoorDyn-C's and MoorDyn-F's output routines have numbers for, by object; -N: of a node of a rod
NUMBERS = {
    "line": [w + x for w in "PVF" for x in XYZ] + ["T", "TEN", "TA", "TENA", "TB", "TENB"],
    "point": [w + x for w in "PVAF" for x in XYZ] + ["T", "TEN"],
    "rod": [w + x for w in "PVAFM" for x in XYZ] + ["RX", "RY", "RVX", "RVY", "RAX", "RAY", "TA", "TENA", "TB", "TENB", "SUB"],
    "rod-N": [w + x for w in "PVF" for x in XYZ],
    "body": [w + x for w in ("P", "R", "V", "RV", "A", "RA", "F", "M") for x in XYZ] + ["T", "TEN"],
}  # fmt: skip
SPELLINGS = {  # C's, then what MoorDyn-F takes besides
    "line": ["L1", "LINE1", "Line1N2", "L1NA", "line1nb"],
    "point": ["P1", "POINT1", "C1", "CON1"],
    "rod": ["R1", "ROD1", "Rod1"],
    "rod-N": ["R1N2", "ROD1NA", "rod1nb", "Rod1N0"],
    "body": ["B1", "BODY1", "Body1"],
}
DECK = """A line, a rod and a body
---------------------- ROD TYPES ----
TypeName Diam Mass/m Cd Ca CdEnd CaEnd
(name) (m) (kg/m) (-) (-) (-) (-)
tube 0.8 300 0.9 1 0.6 0.7
---------------------- LINE TYPES ----
Name Diam MassDen EA BA EI Cd Ca CdAx CaAx
(-) (-) (-) (-) (-) (-) (-) (-) (-) (-)
nylon 0.124 35 5515288 -0.8 0 1.6 1 0.05 0
---------------------- BODIES ----
ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 free -20 3 -20 10 20 30 5000 0 4000 2 3 1
---------------------- RODS ----
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 tube free 3 -10 -22 6 -8 -19 4 {letters}
---------------------- POINTS ----
ID Type X Y Z M V CdA CA
(-) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)
1 Fixed -2 -10 -30 0 0 0 0
---------------------- LINES ----
ID LineType NodeA NodeB UnstrLen NumSegs Outputs
(-) (-) (-) (-) (m) (-) (-)
1 nylon 1 R1A 9.5 3 {lines}
---------------------- OPTIONS ----
70 WtrDpth
{flavour}
---------------------- OUTPUTS ----
{channels}
---------------------- need this line
"""


def read(tmp_path, channels=(), letters="-", lines="-", flavour="1 writeUnits"):
    path = tmp_path / "deck.txt"
    path.write_text(DECK.format(channels="\n".join(channels), letters=letters, lines=lines, flavour=flavour))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        return moorage.read(path)


def run(model, **settings):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        return moorage.simulate(model, duration=0.2, time_step=0.02, start="as-given", **settings)


EVERY = [prefix + word for kind, words in NUMBERS.items() for prefix in SPELLINGS[kind] for word in words]
EVERY += ["FairTen1", "FAIRTEN1", "AnchTen1"]


def test_every_channel_has_a_number(tmp_path):
    """All spellings of all channels in one file, each a variable of the result."""
    ds = run(read(tmp_path, EVERY))
    for name in EVERY:
        assert np.isfinite(ds[name.upper()].values).all(), name
    for a, b in (("L1TA", "ANCHTEN1"), ("LINE1TENB", "FAIRTEN1"), ("R1N0FX", "ROD1NAFX"), ("C1FZ", "POINT1FZ"), ("R1PX", "ROD1NAPX")):  # fmt: skip
        if a in ds and b in ds:
            np.testing.assert_array_equal(ds[a].values, ds[b].values)


@pytest.mark.parametrize("kind", NUMBERS)
def test_what_neither_program_has_is_refused_with_the_reason(kind):
    """But what of a node of a rod follows from the rod is given: its acceleration, angles, and their rates."""
    what, _, node = kind.partition("-")
    for prefix in SPELLINGS[kind]:
        for word in set(WORDS) - set(NUMBERS[kind]):
            name = (prefix + word).upper()
            if parse_channel(name) is None:
                assert f"computes {word} of a" in why_not(name), name
                assert why_not(name).endswith("they write 0"), name
            else:
                assert what == "rod", name
                assert node or word in ("RVZ", "RAZ", "T", "TEN"), name


def test_the_refusal_names_file_and_line(tmp_path):
    with pytest.raises(moorage.InputError, match=r"deck.txt:30: neither MoorDyn-C nor MoorDyn-F computes RX of a line"):
        read(tmp_path, ["Line1RX"])
    with pytest.raises(moorage.InputError, match=r"MX of a node of a rod; they write 0"):
        read(tmp_path, ["Rod1N2MX"])
    with pytest.raises(moorage.InputError, match=r"a body has no nodes"):
        read(tmp_path, ["Body1N2PX"])


def test_quantities_are_what_is_given():
    for kind, words in NUMBERS.items():
        assert set(words) <= set(QUANTITIES[kind.partition("-")[0]])


@pytest.mark.parametrize("flavour", ["C", "F"])
def test_all_letters_of_rods_and_lines(tmp_path, flavour):
    """Files hold as many columns as MoorDyn's have; those of vectors in the order of the letters of the program."""
    letters = {"C": ("pvfWBXYAaPb", "pvUDVtcsdbK"), "F": ("pvUBDIPbWAaXY", "pvUDbVWKtcsdl")}[flavour]
    line = "1 writeUnits" if flavour == "C" else "0 inertialF"
    run(read(tmp_path, ["FairTen1"], *letters, line), moordyn_out=tmp_path / "out")
    dot = "_" if flavour == "C" else ".MD."
    names = (tmp_path / f"out{dot}Rod1.out").read_text().splitlines()[0].split()
    endings = {"C": ["p", "v", "F", "W", "Bo", "Dp", "Dq", "Ap", "Aq", "Pd", "B"],
               "F": ["p", "v", "U", "Bo", "D", "Fi", "Pd", "b", "W", "Ap", "Aq", "Dp", "Dq"]}[flavour]  # fmt: skip
    found = [name[5:-1] for name in names if name.startswith("Node0")]
    assert list(dict.fromkeys(found)) == endings
    assert len(names) == 1 + (11 * 15 if flavour == "C" else 12 * 15 + 5)
    assert (tmp_path / "out_Body1.out").exists() == (flavour == "C")
    assert len((tmp_path / f"out{dot}Line1.out").read_text().splitlines()) == 2 + 3


def test_forces_of_nodes_are_in_the_result_where_histories_are(tmp_path):
    ds = run(read(tmp_path))
    assert ds["rod_node_force"].dims == ("time", "rod_node", "xyz")
    assert ds["rod_node_number"].values.tolist() == [0, 1, 2, 3, 4]
    assert ds["node_rod"].values.tolist() == [1] * 5
    np.testing.assert_allclose(ds["rod_node_force"].sum("rod_node"), ds["rod_force"].sel(rod=1), atol=1e-6)
    assert "rod_node_force" not in run(read(tmp_path), save="tensions")
    at_rest = moorage.solve_statics(dataclasses.replace(read(tmp_path), bodies=()))  # which has nothing to rest on
    assert at_rest["rod_node_force"].shape == (5, 3)


def test_channels_of_the_api(tmp_path):
    """MoorDyn-C's module writes channels and files of rods, as it goes."""
    import moorage.moordyn as moordyn  # noqa: PLC0415

    read(tmp_path, ["Rod1N2FX", "R1TENA"], "pf", "-", "0 TmaxIC")
    system = moordyn.Create(str(tmp_path / "deck.txt"))
    assert moordyn.Init(system, [], []) == 0
    moordyn.Step(system, [], [], 0.0, 0.1)
    moordyn.Close(system)
    rows = [line.split() for line in (tmp_path / "deck_Rod1.out").read_text().splitlines()]
    main = [line.split() for line in (tmp_path / "deck.out").read_text().splitlines()]
    assert float(main[-1][main[0].index("Rod1N2FX")]) == pytest.approx(float(rows[-1][rows[0].index("Node2Fx")]))
