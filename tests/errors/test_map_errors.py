"""Errors of maps of the seabed's properties and of soil curves, and what MoorDyn's files cannot say of them."""

import pytest

from moorage.errors import ModelError
from moorage.io import read, write_moordyn, write_native

NATIVE = """moorage: 1
environment:
  water_depth: 200
  friction:
    map:
      x: [-1000, 0]
      y: [-100, 0, 100]
      axial: [[0.2, 0.3, 0.4], [0.3, 0.4, 0.5]]
      transverse: [[0.6, 0.7, 0.8], [0.7, 0.8, 0.9]]
  seabed_stiffness_map: {x: [0, 10], y: [0], stiffness: [[1e6], [2e6]]}
line_types:
  chain: {diameter: 0.0766, mass_per_length: 113.35, axial_stiffness: 7.536e8}
points:
  - {id: 1, kind: fixed, position: [-800, 0, -200]}
  - {id: 2, kind: coupled, position: [-40, 0, -14]}
lines:
  - {id: 1, end_a: 1, end_b: 2, sections: [{line_type: chain, length: 820, segments: 20}]}
"""

CASES = {
    "x falls": (("x: [-1000, 0]", "x: [0, -1000]"), "model.yaml:6: x of the friction map does not increase"),
    "y missing": (("      y: [-100, 0, 100]\n", ""), "model.yaml:6: y of map of friction .* is missing"),
    "rows missing": (("axial: [[0.2, 0.3, 0.4], ", "axial: ["), "axial of the friction map is not 2 rows of 3 values"),
    "negative": (("0.3, 0.4, 0.5", "0.3, -0.4, 0.5"), "axial of the friction map must not be negative"),
    "no number": (("0.3, 0.4, 0.5", "0.3, .nan, 0.5"), "is not a number"),
    "both": (("    map:", "    axial: 0.3\n    map:"), "model.yaml:5: seabed friction has coefficients and a map"),
    "stiffness": (("[[1e6], [2e6]]", "[[1e6, 2e6]]"), "stiffness of the stiffness map is not 2 rows of 1 values"),
}


CURVES = """
    model: soil-curves
    axial_curve: {x: [0, 0.002, 0.006], y: [0, 0.3, 0.5]}
    transverse_curve: {x: [0, 0.02], y: [0, 0.8]}
"""
CURVE_CASES = {
    "one only": (("    transverse_curve: {x: [0, 0.02], y: [0, 0.8]}\n", ""), "need a table as transverse_curve"),
    "a number": (("{x: [0, 0.02], y: [0, 0.8]}", "0.8"), "need a table as transverse_curve"),
    "not from zero": (("y: [0, 0.8]", "y: [0.1, 0.8]"), "transverse_curve of friction does not start at 0, 0"),
    "x falls": (("[0, 0.002, 0.006]", "[0, 0.006, 0.002]"), "displacements of axial_curve do not increase"),
    "a peak": (("[0, 0.3, 0.5]", "[0, 0.5, 0.3]"), "axial_curve of friction falls"),
    "coefficients too": (("model: soil-curves", "model: soil-curves\n    axial: 0.3"), "take no coefficients"),
    "another law": (("soil-curves", "stick-slip"), "curves of friction go with the model soil-curves"),
}


@pytest.mark.parametrize("name", CURVE_CASES)
def test_curves(tmp_path, name):
    (old, new), message = CURVE_CASES[name]
    assert old in CURVES
    path = tmp_path / "model.yaml"
    a, b = NATIVE.index("    map:"), NATIVE.index("  seabed_stiffness_map")
    path.write_text(NATIVE[:a].rstrip() + CURVES.replace(old, new) + NATIVE[b:])
    with pytest.raises(ModelError, match=message):
        read(path)


def test_curves_survive_a_native_file_and_moordyn_is_told_what_it_lacks(tmp_path):
    path = tmp_path / "model.yaml"
    a, b = NATIVE.index("    map:"), NATIVE.index("  seabed_stiffness_map")
    path.write_text(NATIVE[:a].rstrip() + CURVES + NATIVE[b:])
    model = read(path)
    write_native(model, tmp_path / "again.yaml")
    assert read(tmp_path / "again.yaml").environment == model.environment
    assert "curves of friction cannot be said" in " ".join(write_moordyn(model, tmp_path / "model.dat"))


@pytest.mark.parametrize("name", CASES)
def test_native(tmp_path, name):
    (old, new), message = CASES[name]
    assert old in NATIVE
    path = tmp_path / "model.yaml"
    path.write_text(NATIVE.replace(old, new))
    with pytest.raises(ModelError, match=message):
        read(path)


def test_maps_survive_a_native_file_and_moordyn_is_told_what_it_lacks(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text(NATIVE)
    model = read(path)
    write_native(model, tmp_path / "again.yaml")
    assert read(tmp_path / "again.yaml").environment == model.environment
    notes = " ".join(write_moordyn(model, tmp_path / "model.dat"))
    assert "map of friction's coefficients cannot be said" in notes
    assert "map of the seabed's stiffness cannot be said" in notes
