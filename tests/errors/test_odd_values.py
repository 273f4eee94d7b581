"""Values that are none, and values that are hardly meant: in native files, and in models built in Python."""

import dataclasses
import warnings

import numpy as np
import pytest

from moorage.accept import accept
from moorage.errors import ModelError, ModelWarning
from moorage.io import read
from moorage.model import Attachment, Curve, Point
from moorage.model.checks import check, suspicious
from moorage.model.odd_values import LINE_LETTERS, ROD_LETTERS
from moorage.results.moordyn_columns import LINE_COLUMNS
from moorage.results.rod_columns import ROD_COLUMNS

TEXT = """\
moorage: 1
environment:
  water_depth: 200
line_types:
  chain: {diameter: 0.1, mass_per_length: 100, axial_stiffness: 1e9, axial_damping_ratio: 0.8}
points:
  - {id: 1, name: anchor, kind: fixed, position: [-800, 0, -200]}
  - {id: 2, kind: coupled, position: [-40, 0, -14]}
lines:
  - {id: 1, end_a: 1, end_b: 2, outputs: pt, sections: [{line_type: chain, length: 830, segments: 20}]}
bodies:
  - {id: 1, kind: free, position: [0, 0, -50], mass: 1e4, inertia: [1e5, 1e5, 1e5]}
"""
LOAD = "{id: 1, target: body, target_id: 1, force: [1, 0, 0]}"
SEA = "  waves: {{spectrum: jonswap, height: 2, period: 8, {}}}\nline_types:"
END = "inertia: [1e5, 1e5, 1e5]}\n"


def spoiled(tmp_path, old, new):
    assert old in TEXT
    path = tmp_path / "model.yaml"
    path.write_bytes(new if isinstance(new, bytes) else TEXT.replace(old, new, 1).encode())
    return path


REFUSED = {
    "a comma": ("0.1,", "'0,1',", r"model.yaml:5: diameter of line type chain is not a number \(read: '0,1'\)"),
    "a flag": ("0.1,", "true,", r"model.yaml:5: diameter of line type chain is not a number \(read: 'true'\)"),
    "a flag for a number of": ("id: 2,", "id: yes,", r"model.yaml:8: id of point 2 \(id yes\) is not a whole number"),
    "digits of another script": ("830", "\u0668\u0663\u0660", r"model.yaml:10: length of section 1 is not a number"),
    "a tag": ("0.1,", "!!python/object:os.system 0.1,", r"model.yaml:5: a tag means nothing here .*python/object"),
    "a tag of one's own": ("[-40, 0, -14]", "!place [-40, 0, -14]", r"model.yaml:8: a tag means nothing here"),
    "a tab": ("  water_depth", "\twater_depth", r"model.yaml:3: not a YAML file"),
    "a list as key": ("moorage: 1\n", "moorage: 1\n? [a, b]\n: 1\n", r"model.yaml:2: a key of the model is not a word"),
    "x twice": ("1e9", "{x: [0, 1], y: [0, 1e9], x: [0, 2]}", r"model.yaml:5: a key of axial_stiffness of line type"),
    "two dampings": ("0.8}", "0.8, axial_damping: 1e6}", r"model.yaml:5: line type chain has an axial damping and its"),
    "endless segments": (
        "segments: 20",
        "segments: 1000000000",
        r"model.yaml:10: line 1 has more than 100000 segments",
    ),
    "endless seas": ("line_types:", SEA.format("components: 10000000"), r"model.yaml:4: there are too many components"),
    "a load twice": (
        END,
        f"{END}external_loads:\n  - {LOAD}\n  - {LOAD}\n",
        "model.yaml:15: external load 1 is described",
    ),
    "load 0": (
        END,
        f"{END}external_loads:\n  - {LOAD.replace('id: 1', 'id: 0', 1)}\n",
        "number of an external load must",
    ),
    "channel 0": (
        END,
        f"{END}controls:\n  - {{channel: 0, lines: [1], rate: 0.1}}\n",
        "number of a control channel must",
    ),
    "no lines": (
        END,
        f"{END}controls:\n  - {{channel: 1, lines: [], rate: 0.1}}\n",
        "control channel 1 names no lines",
    ),
    "lines twice": (
        END,
        f"{END}failures:\n  - {{id: 1, attachment: 2, lines: [1, 1], time: 1}}\n",
        r"failure 1 names a line twice \(read: \(1, 1\)\)",
    ),
    "UTF-16": ("", TEXT.encode("utf-16"), r"model.yaml is in UTF-16\n.*save it as UTF-8"),
    "nothing": ("", b"", "is empty"),
    "a comment": ("", b"# nothing\n", "model file is empty"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_refused(tmp_path, name):
    old, new, message = REFUSED[name]
    with pytest.raises(ModelError, match=message):
        read(spoiled(tmp_path, old, new))


@pytest.mark.parametrize("change", [("\n", "\r\n"), ("\n", "\r"), ("moorage", "\ufeffmoorage")])
def test_line_ends_and_marks_of_other_systems_change_nothing(tmp_path, change):
    path = tmp_path / "model.yaml"
    path.write_text(TEXT, "utf-8")
    plain = read(path)
    old, new = change
    path.write_bytes(TEXT.replace(old, new, 1 if old == "moorage" else -1).encode())
    assert read(path) == plain


DOUBTED = {
    "percent": ("0.8}", "80}", r"model.yaml:5: axial damping ratio of line type chain is above 1"),
    "tension at rest": (
        "1e9",
        "{x: [0, 0.1], y: [1e5, 1e9]}",
        r"model.yaml:5: table .* has a tension of 1e\+05 N without",
    ),
    "degrees": (
        "mass: 1e4",
        "mass: 1e4, rotation: [0, 0, 90]",
        r"model.yaml:12: rotation of body 1 is more than a turn",
    ),
    "no body": ("1e5, 1e5, 1e5", "1e5, 1e5, 1e9", r"model.yaml:12: inertia of body 1 is that of no body"),
    "t/m3": ("line_types:", "  water_density: 1.025\nline_types:", r"model.yaml:4: water is as light as air"),
    "a short line": ("830", "83", r"model.yaml:10: line 1 is 83 m long, and its ends are 782.4 m apart"),
    "a depth": ("-40, 0, -14", "-40, 0, -500", r"model.yaml:8: point 2 is 300 m below the seabed"),
    "a deep body": ("0, 0, -50", "0, 0, -250", r"model.yaml:12: body 1 is 50 m below the seabed"),
    "letters": ("outputs: pt", "outputs: pQtz", r"model.yaml:10: outputs of line 1 have letters .*: Qz"),
    "gamma": ("line_types:", SEA.format("gamma: 33"), r"model.yaml:4: gamma of the sea is 33"),
    "cm/s": (
        "line_types:",
        "  current: {speed: 50, direction: 0}\nline_types:",
        r"model.yaml:4: the current runs at 50",
    ),
}


@pytest.mark.parametrize("name", DOUBTED)
def test_doubted(tmp_path, name):
    old, new, message = DOUBTED[name]
    model = read(spoiled(tmp_path, old, new))
    with pytest.warns(ModelWarning, match=message):
        accept(model)


def test_an_empty_model_is_doubted(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text("moorage: 1\nenvironment: {water_depth: 9}\n")
    assert [p.message for p in suspicious(read(path))] == ["the model has no lines, rods or bodies"]


def test_what_is_right_is_not_doubted(tmp_path):
    new = "{x: [-1, 0, 0.1], y: [-1e9, 0, 1e8]}"
    assert not suspicious(read(spoiled(tmp_path, "1e9", new)))


def test_letters_are_those_of_the_columns():
    for letters, columns in ((LINE_LETTERS, LINE_COLUMNS), (ROD_LETTERS, ROD_COLUMNS)):
        assert sorted(letters) == sorted(set().union(*columns.values()))


def replaced(model, what, /, **values):
    """Return the model with values of its first line type, last point, line, section, or of itself."""
    if what == "model":
        return dataclasses.replace(model, **values)
    if what == "section":
        section = dataclasses.replace(model.lines[0].sections[0], **values)
        return replaced(model, "lines", sections=(section,))
    things = getattr(model, what)
    return dataclasses.replace(model, **{what: (*things[:-1], dataclasses.replace(things[-1], **values))})


UNTYPED = {
    "text": ("line_types", {"diameter": "0.1"}, r"diameter of line type chain is not a number \(read: '0.1'\)"),
    "flag": ("line_types", {"diameter": True}, r"diameter of line type chain is not a number \(read: True\)"),
    "none": ("line_types", {"mass_per_length": None}, "mass per length of line type chain is not a number"),
    "complex": ("line_types", {"diameter": 1j}, "diameter of line type chain is not a number"),
    "list": (
        "line_types",
        {"axial_stiffness": [1, 2]},
        "axial stiffness of line type chain is not a number or a Curve",
    ),
    "two": ("points", {"position": (1.0, 2.0)}, r"position of point 2 has 2 values \(read: \(1.0, 2.0\)\)\n.*give 3"),
    "words": ("points", {"position": ("a", 0, 1)}, "position of point 2 is not 3 of them, each a number"),
    "kind": ("points", {"kind": "Coupled"}, "kind of point 2 is not one of fixed, coupled, free"),
    "id": ("points", {"id": True}, "id of point True is not a whole number"),
    "half": ("section", {"segments": 5.5}, "segments of section of line 1 is not a whole number"),
    "an end": ("lines", {"end_a": "1"}, "end a of line 1 is not an Attachment"),
    "an end's kind": ("lines", {"end_a": Attachment("Point", 1)}, "kind of attachment 1 is not one of point, rod"),
    "start": ("model", {"start": "Static"}, "start of the model is not one of static, as-given"),
    "a point": (
        "model",
        {"points": Point(id=1, kind="fixed", position=(0, 0, 0))},
        "points of the model is not a list",
    ),
    "nan": ("points", {"position": [0.0, float("nan"), -9.0]}, "position of point 2 is not finite"),
    "nan of NumPy": ("line_types", {"diameter": np.float32("nan")}, "diameter of line type chain is not finite"),
    "array": (
        "line_types",
        {"axial_stiffness": Curve(np.array([0, np.nan]), (0, 1))},
        "x of line type chain is not fini",
    ),
}


@pytest.mark.parametrize("name", UNTYPED)
def test_values_of_another_type_are_refused(tmp_path, name):
    kind, values, message = UNTYPED[name]
    with pytest.raises(ModelError, match=message):
        check(replaced(read(spoiled(tmp_path, "0.1", "0.1")), kind, **values))


def test_lists_and_numbers_of_numpy_are_as_good(tmp_path):
    model = read(spoiled(tmp_path, "0.1", "0.1"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        accept(replaced(model, "line_types", diameter=np.float32(0.1), mass_per_length=100))
        accept(replaced(model, "points", position=np.array([-40.0, 0.0, -14.0]), id=np.int64(2)))
        accept(replaced(replaced(model, "section", segments=np.int32(5)), "model", points=list(model.points)))
