"""The native file: every key of the schema read and written, and its errors."""

import dataclasses
import typing
from pathlib import Path

import pytest

import moorage.model as m
from moorage.errors import ModelError, Source
from moorage.io import convert, read, read_native, write_native
from moorage.io.schema import BY_KEY, SCHEMA, as_markdown

FULL = """\
moorage: 1
title: everything
start: as-given
output_interval: 0.1
environment:
  water_depth: 200
  gravity: 9.81
  water_density: 1e3
  friction: {transverse: 0.6, axial: 0.4, static_ratio: 1.2, damping: 500}
  bathymetry: {x: [-1000, 0], y: [0, 100], depth: [[200, 210], [220, 230]]}
  current: {z: [-200, 0], velocity: [[0, 0, 0], [1, 0.5, 0]]}
  waves: {spectrum: jonswap, height: 8.25, period: 14.5, components: 20, ramp: 20}
  unread_water: {option: WaveKin, value: 3, settings: {dtWave: 0.25}}
line_types:
  chain: {diameter: 0.1, mass_per_length: 100, axial_stiffness: 1e9, axial_damping_ratio: 0.8}
  rope:
    diameter: 0.2
    mass_per_length: 20
    axial_stiffness: {x: [0, 0.1], y: [0, 1e5]}
    bending_stiffness: {file: bending.txt}
    minimum_bend_radius: 2
points:
  - {id: 1, name: anchor, kind: fixed, position: [-800, 0, seabed]}
  - {id: 2, kind: coupled, position: [-40, 0, -14]}
  - {id: 3, kind: free, position: [-60, 0, -30], mass: 10, external_force: [1, 2, 3]}
lines:
  - id: 1
    name: mooring 1
    end_a: anchor
    end_b: 3
    sections:
      - {line_type: chain, length: 700, segments: 20}
      - {line_type: rope, length: 100, segments: 5}
  - {id: 2, end_a: 3, end_b: rod 1 A, sections: [{line_type: rope, length: 30, segments: 3}]}
rod_types:
  can: {diameter: 1, mass_per_length: 1000}
rods:
  - {id: 1, rod_type: can, kind: pinned, body: 1, end_a: [0, 0, -10], end_b: [0, 0, 0], segments: 4}
bodies:
  - {id: 1, kind: coupled, position: [0, 0, 0], rotation: [0, 0.1, 0], drag_area: [1, 1, 1, 2, 2, 2]}
failures:
  - {id: 1, attachment: point 3, lines: [2], time: 10}
controls:
  - {channel: 1, lines: [1, 2]}
external_loads:
  - {id: 1, target: body, target_id: 1, force: [1, 0, 0], local: true}
outputs: [FairTen1, LINE2N1PX]
"""


@pytest.fixture
def native(tmp_path):
    (tmp_path / "bending.txt").write_text("curvature moment\n0 0\n0.1 1e3\n")

    def write(*replacements):
        text = FULL
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new, 1)
        path = tmp_path / "model.yaml"
        path.write_text(text)
        return path

    return write


def test_everything_is_read(native):
    path = native()
    model = read(path)
    anchor, fairlead, joint = model.points
    assert (anchor.position, anchor.on_seabed, anchor.name) == ((-800.0, 0.0, -204.0), True, "anchor")
    assert (fairlead.kind, joint.mass, joint.external_force) == ("coupled", 10.0, (1.0, 2.0, 3.0))
    first, second = model.lines
    assert (first.end_a, second.end_b) == (m.Attachment("point", 1), m.Attachment("rod", 1, "A"))
    assert [s.segments for s in first.sections] == [20, 5]
    assert model.line_type("rope").bending_stiffness == m.Curve((0.0, 0.1), (0.0, 1e3))
    assert (model.environment.water_density, model.environment.friction.axial) == (1e3, 0.4)
    assert model.environment.current.velocity[1] == (1.0, 0.5, 0.0)
    assert model.environment.unread_water.settings == (("dtWave", "0.25"),)
    assert (model.start, model.output_interval, model.flavour) == ("as-given", 0.1, "native")
    assert model.failures[0].attachment == m.Attachment("point", 3)
    assert model.external_loads[0].local
    assert joint.source == Source(str(path), 25)


def test_round_trip(native, tmp_path):
    model = read(native())
    write_native(model, tmp_path / "again.yml")
    again = read_native(tmp_path / "again.yml")
    assert again == model
    assert "end_a: anchor" in (tmp_path / "again.yml").read_text()


def test_convert_from_moordyn(deck, tmp_path):
    source = deck()
    said = convert(source, tmp_path / "model.yaml")
    assert said == [f"option dtM = 0.001 ({source}:19): not written, Moorage chooses its own time step"]
    assert read(tmp_path / "model.yaml") == dataclasses.replace(read(source), flavour="native")


CLASSES = {
    "model": m.Model, "environment": m.Environment, "soil": m.Soil, "friction": m.Friction, "bathymetry": m.Bathymetry,
    "friction map": m.FrictionMap, "stiffness map": m.StiffnessMap, "current": m.Current, "waves": m.Waves,
    "unread water": m.UnreadWater, "line type": m.LineType, "point": m.Point, "line": m.Line,
    "section": m.Section, "buoyancy modules": m.BuoyancyModules, "bend stiffener": m.BendStiffener, "rod type": m.RodType, "rod": m.Rod, "body": m.Body, "failure": m.Failure,
    "control": m.Control, "external load": m.ExternalLoad, "turbine": m.Turbine,
}  # fmt: skip
ELSEWHERE = {
    "sources",
    "depth",
    "density",
    "seed",
    "asked",
    "source",
    "resampling",
    "file",
    "text",
    "unused_options",
    "flavour",
    "on_seabed",
    "in_place",
    "moorage",
}


def test_every_object_of_the_schema_is_a_class_or_a_file():
    assert SCHEMA.keys() - CLASSES.keys() == {other for kinds in BY_KEY.values() for other in kinds.values()}


@pytest.mark.parametrize("name", CLASSES)
def test_schema_has_every_field(name):
    fields = {field.name for field in dataclasses.fields(CLASSES[name])} - ELSEWHERE
    keys = set(SCHEMA[name]) - ELSEWHERE
    fields -= {"depth", "gravity"} if name == "waves" else set()  # those of the environment
    named_by_their_key = {"name"} if name in ("line type", "rod type") else set()
    assert fields - named_by_their_key == keys
    required = {f.name for f in dataclasses.fields(CLASSES[name]) if _has_no_default(f)} & fields - named_by_their_key
    assert required <= {key for key, entry in SCHEMA[name].items() if entry.required}


def _has_no_default(field: "dataclasses.Field[typing.Any]") -> bool:
    return field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("moorage: 1\n", "", "moorage of the model is missing"),
        ("moorage: 1\n", "moorage: 2\n", "version of the file is not known"),
        ("gravity", "gravty", r"model.yaml:7: key of environment of the model is not known .*\n.*did you mean gravity"),
        ("  water_depth: 200\n", "", "water_depth of environment of the model is missing"),
        (
            "  gravity: 9.81",
            "  gravity: 9.81\n  gravity: 9.8",
            "key gravity of environment of the model is given twice",
        ),
        ("gravity: 9.81", "gravity: -9.81", r"model.yaml:\d+: gravity of the environment must not be negative"),
        ("gravity: 9.81", "gravity: heavy", "gravity of environment of the model is not a number"),
        ("gravity: 9.81", "gravity: [1]", "gravity of environment of the model is not a word"),
        (
            "kind: coupled, position: [-40",
            "kind: cupled, position: [-40",
            "kind of point 2 .id 2. is not known.*\n.*coupled",
        ),
        ("[-40, 0, -14]", "[-40, 0]", "position of point 2 .id 2. has 2 values"),
        ("[-40, 0, -14]", "5", "position of point 2 .id 2. is not a list"),
        ("{id: 2, kind: coupled", "{id: two, kind: coupled", "id of point 2 .id two. is not a whole number"),
        ("end_a: anchor", "end_a: anker", "end is neither a point nor a rod's end"),
        ("  chain: {", "  rope: {", "line type rope is described twice"),
        ("{x: [0, 0.1], y: [0, 1e5]}", "{x: [0, 0.1], y: [0]}", "has 2 x and 1 y"),
        ("{x: [0, 0.1], y: [0, 1e5]}", "{x: [0, 0.1]}", "is not a table"),
        ("{file: bending.txt}", "{file: none.txt}", "table of bending_stiffness of line type rope not found: tried"),
        ("local: true", "local: maybe", "neither true nor false"),
        ("[[0, 0, 0], [1, 0.5, 0]]", "[[0, 0, 0], [1, 0.5]]", "differ in length"),
        ("{dtWave: 0.25}", "none", "settings of unread_water of environment of the model is not a set of names"),
        ("line_types:", "line_types: [", "not a YAML file"),
        ("  can: {diameter: 1, mass_per_length: 1000}", "  - can", "rod_types of the model is not a set of names"),
        ("  - {id: 1, rod_type: can", "  - can\n  - {id: 1, rod_type: can", "rod 1 is not an object"),
        ("x: [-1000, 0], y: [0, 100], depth: [[200, 210], [220, 230]]", "x: [], y: [], depth: []", "does not increase"),
        ("length: 700", "length: -700", "model.yaml:32: length of line 1 must be positive"),
    ],
)
def test_errors(native, old, new, message):
    with pytest.raises(ModelError, match=message):
        read(native((old, new)))


def test_only_remarks(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text("# nothing\n")
    with pytest.raises(ModelError, match="is empty"):
        read(path)


def test_page_is_made_from_the_schema():
    page = Path(__file__).parents[2] / "docs" / "native-file.md"
    made = as_markdown()
    assert page.read_text("utf-8") == made, "write as_markdown() of moorage.io.schema to docs/native-file.md"
