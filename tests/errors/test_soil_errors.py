"""Errors of soils with a memory, and what MoorDyn's files cannot say of them."""

import pytest
from native_text import check_refused

from moorage.io import read, write_moordyn, write_native
from moorage.model import Soil

NATIVE = """moorage: 1
environment:
  water_depth: 200
  soil:
    shear_strength: 3000
    strength_gradient: 1500
    density: 1500
line_types:
  chain: {diameter: 0.0766, mass_per_length: 113.35, axial_stiffness: 7.536e8}
points:
  - {id: 1, kind: fixed, position: [-800, 0, -200]}
  - {id: 2, kind: coupled, position: [-40, 0, -14]}
lines:
  - {id: 1, end_a: 1, end_b: 2, sections: [{line_type: chain, length: 820, segments: 20}]}
"""

CASES = {
    "strength missing": (("    shear_strength: 3000\n", ""), "model.yaml:5: shear_strength of soil .* is missing"),
    "negative": (("3000", "-3000"), "model.yaml:5: shear strength of the soil must not be negative"),
    "no strength": (
        ("shear_strength: 3000\n    strength_gradient: 1500", "shear_strength: 0"),
        "model.yaml:5: soil has no strength",
    ),
    "no stiffness": (("density: 1500", "maximum_stiffness: 0"), "maximum stiffness of the soil must be positive"),
    "never lets go": (("density: 1500", "suction_decay: 0"), "suction decay of the soil must be positive"),
    "no number": (("density: 1500", "suction_ratio: .nan"), "is not a number"),
    "lighter than water": (
        ("1500\nline", "900\nline"),
        "density of the soil is not above that of the water, 1025 kg/m3",
    ),
    "a map too": (
        ("line_types", "  seabed_stiffness_map: {x: [0], y: [0], stiffness: [[1e6]]}\nline_types"),
        "model.yaml:5: seabed has a soil and a map of the stiffness",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_native(tmp_path, name):
    change, message = CASES[name]
    check_refused(tmp_path, NATIVE, change, message)


def test_soil_survives_a_native_file_and_moordyn_is_told_what_it_lacks(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text(NATIVE)
    model = read(path)
    assert model.environment.soil == Soil(shear_strength=3e3, strength_gradient=1.5e3, density=1.5e3)
    write_native(model, tmp_path / "again.yaml")
    assert read(tmp_path / "again.yaml").environment == model.environment
    assert "soil with suction and a memory cannot be said" in " ".join(write_moordyn(model, tmp_path / "model.dat"))
