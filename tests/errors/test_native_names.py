"""What a word in a native file calls: a number before a name, and no name that two things have."""

import warnings

import pytest

from moorage.errors import ModelError, ModelWarning
from moorage.io import read
from moorage.model.checks import suspicious

TEXT = """\
moorage: 1
environment: {water_depth: 100}
line_types:
  chain: {diameter: 0.1, mass_per_length: 100, axial_stiffness: 1e9}
turbines:
  - {id: 1, name: WEST, position: [0, 0, 0]}
  - {id: 2, name: EAST, position: [900, 0, 0]}
points:
  - {id: 1, name: anchor, kind: fixed, position: [-300, 0, seabed]}
  - {id: 2, name: fairlead, kind: coupled, position: [0, 0, -10], turbine: EAST}
  - {id: 3, name: buoy, kind: fixed, position: [-100, 0, seabed]}
lines:
  - {id: 1, end_a: anchor, end_b: fairlead, sections: [{line_type: chain, length: 1300, segments: 5}]}
"""


@pytest.fixture
def native(tmp_path):
    def write(old, new):
        assert old in TEXT
        path = tmp_path / "model.yaml"
        path.write_text(TEXT.replace(old, new), "utf-8")
        return path

    return write


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "buoy",
            "anchor",
            r"model.yaml:13: points 1 and 3 have the same name \(read: 'anchor'\)\n.*write a number here",
        ),
        ("WEST", "EAST", r"model.yaml:10: turbines 1 and 2 have the same name \(read: 'EAST'\)\n.*write a number here"),
    ],
)
def test_a_name_that_two_have_calls_neither(native, old, new, message):
    with pytest.raises(ModelError, match=message):
        read(native(old, new))


@pytest.mark.parametrize(("old", "new"), [("name: buoy", "name: fairlead"), ("name: WEST", "name: EAST")])
def test_equal_names_are_labels_where_numbers_call(native, old, new):
    path = native(old, new)
    path.write_text(path.read_text().replace("end_b: fairlead", "end_b: 2").replace("turbine: EAST", "turbine: 2"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        model = read(path)
    assert (model.lines[0].end_b.id, model.points[1].turbine) == (2, 2)


@pytest.mark.parametrize(
    ("old", "new", "warning"),
    [
        ("buoy, kind", "'1', kind", "1 is taken for the number of a point, not for the name of point 3"),
        ("buoy, kind", "point 1, kind", "point 1 is taken for the number of a point, not for the name of point 3"),
        ("WEST", "'2'", "2 is taken for the number of a turbine, not for the name of turbine 1"),
    ],
)
def test_a_number_is_no_name(native, old, new, warning):
    path = native(old, new)
    word = new.split(",")[0].strip("'")
    path.write_text(path.read_text().replace("end_a: anchor", f"end_a: {word}" if "point" in warning else "end_a: 1"))
    path.write_text(path.read_text().replace("turbine: EAST", "turbine: 2"))
    with pytest.warns(ModelWarning, match=f"model.yaml:.*: {warning}"):
        model = read(path)
    assert (model.lines[0].end_a.id, model.points[1].turbine) == (1, 2)


def test_an_end_of_a_rod_is_no_name(native):
    path = native("name: anchor", "name: rod 1 A")
    path.write_text(path.read_text().replace("end_a: anchor", "end_a: rod 1 A"))
    with pytest.warns(ModelWarning, match="not for the point of that name"), pytest.raises(ModelError, match="rod 1"):
        read(path)


def test_tensions_of_a_rope_need_a_rope(native):
    with pytest.raises(
        ModelError, match=r"model.yaml:13: Syrope tensions of line 1 are given, but its line type is not"
    ):
        read(native("end_a: anchor,", "end_a: anchor, syrope_tensions: [2e5, 1e5],"))


def test_a_load_on_what_is_fixed_is_doubted(native):

    load = "external_loads: [{id: 1, target: point, target_id: 1, force: [1, 0, 0]}]\nlines:"
    assert [p.message for p in suspicious(read(native("lines:", load)))] == [
        "external load 1 is on point 1, which is fixed: it has no effect"
    ]
