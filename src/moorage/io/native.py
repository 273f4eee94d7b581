"""The native model file: YAML by the schema in `moorage.io.schema`."""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path
from typing import Any

import yaml

from moorage.errors import ModelError, Problem, Source
from moorage.io.current import current_grid, current_of, grid_as_plain
from moorage.io.current_files import current_of_file
from moorage.io.finish import checked
from moorage.io.native_names import end_called, turbine_called
from moorage.io.native_seabed import bathymetry_of, friction_map_of, stiffness_map_of
from moorage.io.schema import SCHEMA
from moorage.io.sea_state import components, sea_state, tabled
from moorage.io.text import Findings, read_text
from moorage.io.wave_spectra import sea_of_file
from moorage.io.yaml_nodes import NodeReader, Values, tagged
from moorage.model import (
    BendStiffener,
    Body,
    BuoyancyModules,
    Control,
    Current,
    CurrentGrid,
    Curve,
    Environment,
    ExternalLoad,
    Failure,
    Friction,
    Line,
    LineType,
    Model,
    OutputChannel,
    Point,
    Rod,
    RodType,
    Section,
    Soil,
    Turbine,
    UnreadWater,
    Waves,
)

VERSION = 1


def read_native(path: str | Path, raise_to_seabed: bool = False) -> Model:
    """Read and check a native model file; all that is wrong with it comes as one `ModelError`."""
    path = Path(path)
    text = read_text(path, "model file")
    found = Findings()
    values = _load(text, path, found)
    found.raise_any()
    assert values is not None
    return checked(
        dataclasses.replace(_model(values, path.parent, found), file=str(path), text=text), found, raise_to_seabed
    )


def _load(text: str, path: Path, found: Findings) -> Values | None:
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except (yaml.YAMLError, RecursionError, ValueError) as error:
        mark = getattr(error, "problem_mark", None)
        source = Source(str(path), mark.line + 1 if mark else 0)
        reason = getattr(error, "problem", None) or str(error).split("\n")[0] or type(error).__name__
        raise ModelError(Problem(f"not a YAML file: {reason}", "correct the text", source)) from None
    if (odd := tagged(node)) is not None:
        source = Source(str(path), odd.start_mark.line + 1)
        raise ModelError(Problem("a tag means nothing here", "remove it, write the value alone", source, odd.tag))
    if node is None:
        raise ModelError(Problem("model file is empty", "write a model", Source(str(path))))
    values = NodeReader(str(path), path.parent, found).read_object(node, "model", "the model")
    if values is not None and values["moorage"] != VERSION:
        found.add("version of the file is not known", f"write moorage: {VERSION}", Source(str(path)), values["moorage"])
    return values


def _model(values: Values, folder: Path, found: Findings) -> Model:
    turbines = tuple(Turbine(**entry) for entry in values.get("turbines", ()))
    for entry in (*values.get("points", ()), *values.get("rods", ()), *values.get("bodies", ())):
        if "turbine" in entry:
            entry["turbine"] = turbine_called(entry["turbine"], turbines, found)
    points = tuple(_point(entry) for entry in values.get("points", ()))
    return Model(
        environment=_environment(values["environment"], folder, found),
        line_types=tuple(LineType(name=name, **entry) for name, entry in values.get("line_types", {}).items()),
        lines=tuple(_line(entry, points, found) for entry in values.get("lines", ())),
        points=points,
        rod_types=tuple(RodType(name=name, **entry) for name, entry in values.get("rod_types", {}).items()),
        rods=tuple(Rod(**entry) for entry in values.get("rods", ())),
        bodies=tuple(Body(**entry) for entry in values.get("bodies", ())),
        turbines=turbines,
        failures=tuple(
            Failure(**entry | {"attachment": end_called(entry["attachment"], points, found)})
            for entry in values.get("failures", ())
        ),
        controls=tuple(_control(entry, found) for entry in values.get("controls", ())),
        external_loads=tuple(ExternalLoad(**entry) for entry in values.get("external_loads", ())),
        outputs=tuple(OutputChannel(name=name.upper(), source=source) for name, source in values.get("outputs", ())),
        start=values.get("start", "static"),
        output_interval=values.get("output_interval"),
        title=values.get("title", ""),
        sources=tuple((values["places"] | values["environment"]["places"]).items()),
    )


def _environment(values: Values, folder: Path, found: Findings) -> Environment:
    if "bathymetry" in values:
        values = values | {"bathymetry": bathymetry_of(values["bathymetry"], folder, found)}
    if "waves" in values:
        values = values | {"waves": _waves(values, folder, found)}
    if "current" in values:
        values = values | {"current": _current(values, folder, found)}
    if "map" in values.get("friction", ()):
        mu = friction_map_of(values["friction"]["map"], folder, found)
        values = values | {"friction": values["friction"] | {"map": mu}}
    if "seabed_stiffness_map" in values:
        values = values | {"seabed_stiffness_map": stiffness_map_of(values["seabed_stiffness_map"], folder, found)}
    parts: dict[str, type] = {
        "soil": Soil, "friction": Friction, "unread_water": UnreadWater,
    }  # fmt: skip
    made = {
        key: parts[key](**value) if key in parts and isinstance(value, dict) else value
        for key, value in values.items()
        if key not in ("source", "places")
    }
    return Environment(**made)


def _current(values: Values, folder: Path, found: Findings) -> Current | CurrentGrid:
    """Return the current of an environment, from words, a file, a grid or levels."""
    asked = values["current"]
    if "speed" in asked:
        return current_of(asked, values["water_depth"], found)
    if "file" in asked:
        return current_of_file(asked, folder, found)
    return current_grid(asked, found) if asked.keys() & {"t", "x"} else Current(**asked)


def _waves(values: Values, folder: Path, found: Findings) -> Waves | None:
    """Return the waves of an environment, from components, a file or a sea state."""
    asked, plain = values["waves"], Environment(water_depth=values["water_depth"])
    water = {
        "depth": values["water_depth"],
        "gravity": values.get("gravity", plain.gravity),
        "density": values.get("water_density", plain.water_density),
    }
    if not min(water["depth"], water["gravity"]) > 0.0:
        return None  # the checks of the environment tell
    if "file" in asked:
        return sea_of_file(asked, folder, water, found)
    if "density" in asked:
        return tabled(asked, water, found)
    if "spectrum" in asked:
        return sea_state(asked, water, found)
    return components(asked, water, found)


def _point(values: Values) -> Point:
    position, on_seabed = values["position"]
    return Point(**values | {"position": position, "on_seabed": on_seabed})


def _line(values: Values, points: tuple[Point, ...], found: Findings) -> Line:
    sections = tuple(_section(section) for section in values["sections"])
    stiffeners = tuple(_stiffener(stiffener) for stiffener in values.get("stiffeners", ()))
    ends = {end: end_called(values[end], points, found) for end in ("end_a", "end_b")}
    return Line(**values | ends | {"sections": sections, "stiffeners": stiffeners})


def _control(values: Values, found: Findings) -> Control:
    if isinstance(values.get("length"), float):
        remedy = "write {x: [0, 60], y: [0, 30]} or {file: name}, or a rate"
        found.add("length of a control is not a table", remedy, values["source"], values["length"])
        values = values | {"length": None}
    return Control(**values)


def _stiffener(values: Values) -> BendStiffener:
    profile = values.get("stiffness")
    if isinstance(profile, float):  # the same all along
        profile = Curve((0.0, 1.0), (profile, profile))
    return BendStiffener(**values | {"stiffness": profile})


def _section(values: Values) -> Section:
    modules = BuoyancyModules(**values["modules"]) if "modules" in values else None
    return Section(**values | {"modules": modules})


def write_native(model: Model, path: str | Path) -> list[str]:
    """Write a model as a native file; return what it cannot say (options of other programs)."""
    names = {point.id: point.name for point in model.points}
    names = {id: name for id, name in names.items() if _is_name(name, list(names.values()))}
    tree = {"moorage": VERSION} | _tree("model", model, names)
    Path(path).write_text(yaml.dump(tree, Dumper=_Dumper, sort_keys=False, width=120, allow_unicode=True), "utf-8")
    return [
        f"option {option.name} = {option.value} ({option.source}): not written, {option.reason}"
        for option in model.unused_options
    ]


def _is_name(name: str, names: list[str]) -> bool:
    return bool(name) and names.count(name) == 1 and not re.fullmatch(r"(?i)(point\s*)?\d+|rod.*", name)


def _tree(name: str, thing: Any, names: dict[int, str]) -> dict[str, Any]:
    """Return an object as plain values by the schema, without what has its default."""
    defaults = {f.name: f.default for f in dataclasses.fields(thing)}
    tree: dict[str, Any] = {}
    for key, entry in SCHEMA[name].items():
        if key == "moorage":
            continue
        value = getattr(thing, key)
        if entry.required or value != defaults[key]:
            tree[key] = _plain(value, entry.kind, names)
    if name == "point" and thing.on_seabed:
        tree["position"][2] = "seabed"
    return tree


def _plain(value: Any, kind: str, names: dict[int, str]) -> Any:
    if kind.startswith("list of "):
        return [_tree(kind[len("list of ") :], item, names) for item in value]
    if kind.startswith("map of "):
        return {item.name: _tree(kind[len("map of ") :], item, names) for item in value}
    if isinstance(value, CurrentGrid):
        return grid_as_plain(value)
    if kind in SCHEMA:
        return _tree(kind, value, names)
    if kind == "end":
        return names.get(value.id, value.id) if value.kind == "point" else f"rod {value.id} {value.end}"
    if kind == "texts":
        return [channel.name for channel in value]
    if kind == "pairs":
        return dict(value)
    if isinstance(value, Curve):
        return {"x": list(value.x), "y": list(value.y)}
    if kind == "table":
        return [list(row) for row in value]
    return list(value) if isinstance(value, tuple) else value


class _Dumper(yaml.SafeDumper):
    """Writes objects in blocks, and short lists and sections in one line."""

    def increase_indent(self, flow: bool = False, indentless: bool = False) -> None:
        """Indent lists under their key."""
        return super().increase_indent(flow, False)


def _represent_list(dumper: yaml.SafeDumper, items: list[Any]) -> yaml.Node:
    flow = not any(isinstance(item, dict | list) for item in items)
    return dumper.represent_sequence("tag:yaml.org,2002:seq", items, flow_style=flow)


def _represent_dict(dumper: yaml.SafeDumper, items: dict[str, Any]) -> yaml.Node:
    flow = "line_type" in items
    return dumper.represent_mapping("tag:yaml.org,2002:map", items.items(), flow_style=flow)


def _represent_text(dumper: yaml.SafeDumper, text: str) -> yaml.Node:
    return dumper.represent_scalar("tag:yaml.org,2002:str", text, style="|" if "\n" in text else None)


_Dumper.add_representer(str, _represent_text)
_Dumper.add_representer(list, _represent_list)
_Dumper.add_representer(dict, _represent_dict)
