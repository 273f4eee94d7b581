"""A model as a MoorDyn v2 file, for MoorDyn-C or MoorDyn-F, with the tables that it names."""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path

from moorage.io.moordyn.environment_writer import environment_options
from moorage.io.moordyn.events_writer import controls, failures, loads, syrope
from moorage.io.moordyn.flatten import flatten
from moorage.io.moordyn.layout import Flavour, bars, number, rule, table, tie
from moorage.io.moordyn.options import BY_NAME
from moorage.model import Body, Curve, LineType, Model, Point, Rod
from moorage.model.turbines import on_turbines, placed, turbines_have_places


def write_moordyn(model: Model, path: str | Path, flavour: Flavour = "C") -> list[str]:
    """Write a model as a MoorDyn v2 file and the tables that it names beside it.

    Returns
    -------
    list of str
        What was said otherwise, and what the file cannot say.
    """
    path = Path(path)
    flat = flatten(model)
    model, notes = flat.model, flat.notes
    model = _without_turbines(model, notes) if flavour == "C" else model
    names = _names(model, notes)
    blocks = [
        _front(model),
        _line_types(model, names, path, flavour, notes),
        _rod_types(model, names),
        _bodies(model, flavour, notes),
        _rods(model, names),
        _points(model, flavour),
        _lines(model, names),
        syrope(model, notes),
        failures(model),
        controls(model, flavour, notes),
        loads(model, flavour, notes),
        _options(model, path, flavour, notes),
        _outputs(model, flavour, notes),
    ]
    text = "\n".join(line for block in blocks for line in block) + f"\n{rule('need this line')}\n"
    path.write_text(text, "utf-8")
    notes += _unsaid(model)
    return notes


def _without_turbines(model: Model, notes: list[str]) -> Model:
    """Return the model with what is on turbines coupled, in global coordinates: MoorDyn-C knows no turbines."""
    names = [f"{kind} {thing.id}" for kind, thing in on_turbines(model)]
    if not names:
        return model
    if any(turbines_have_places(model)):
        notes.append("MoorDyn-C knows no turbines, and their positions are not known: TurbineN is written as it was")
        return model
    notes.append(f"MoorDyn-C knows no turbines: coupled, in global coordinates: {', '.join(names)}")
    model = placed(model)

    def loose(things):
        return tuple(dataclasses.replace(thing, turbine=None) for thing in things)

    return dataclasses.replace(
        model, points=loose(model.points), rods=loose(model.rods), bodies=loose(model.bodies), turbines=()
    )


def _front(model: Model) -> list[str]:
    title = [re.sub("-{2,}", "-", line) for line in model.title.splitlines()] or ["MoorDyn v2 file by Moorage"]
    return [rule("MoorDyn Input File"), *title]


def _names(model: Model, notes: list[str]) -> dict[str, str]:
    """Return the names of line and rod types as single words, by their names."""
    names = list(dict.fromkeys([t.name for t in model.line_types] + [t.name for t in model.rod_types]))
    words = {name: _word(name) for name in names}
    taken = {name.lower() for name in names if words[name] == name}
    for name in names:
        if words[name] != name:
            while words[name].lower() in taken:
                words[name] += "_"
            taken.add(words[name].lower())
            notes.append(f"type {name!r} is now called {words[name]}")
    return words


def _word(name: str) -> str:
    """Return a name as one word that neither starts a comment nor looks like a line of dashes."""
    return re.sub(r"[\s#!%|,\"']+|-{3,}", "_", name) or "type"


def _named(names: dict[str, str], name: str) -> str:
    return next(word for key, word in names.items() if key.lower() == name.lower())


def _line_types(model: Model, names: dict[str, str], path: Path, flavour: Flavour, notes: list[str]) -> list[str]:
    vibrates = any(t.lift_coefficient > 0.0 for t in model.line_types)
    header = "TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx" + (" Cl dF cF" if vibrates else "")
    units = "(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)" + (" (-) (-) (-)" if vibrates else "")
    rows = [_line_type(t, names[t.name], path, vibrates) for t in model.line_types]
    tables = any(isinstance(v, Curve) for t in model.line_types for v in _curves(t))
    if tables and flavour == "F":
        notes.append("MoorDyn-F looks for tables of line types in the folder that it is started from")
    return table("LINE TYPES", header, units, rows)


def _curves(t: LineType) -> tuple[float | Curve, ...]:
    return t.axial_stiffness, t.axial_damping, t.bending_stiffness


def _line_type(t: LineType, name: str, path: Path, vibrates: bool) -> list[str]:
    stiffness = f"SYROPE:{t.syrope}" if t.syrope else _value(t.axial_stiffness, f"EA_{name}", path)
    damping = _value(t.axial_damping, f"BA_{name}", path)
    if t.axial_damping_ratio is not None:
        damping = number(-t.axial_damping_ratio)
    bending = _value(t.bending_stiffness, f"EI_{name}", path)
    coefficients = [t.transverse_drag, t.transverse_added_mass, t.tangential_drag, t.tangential_added_mass]
    coefficients += [t.lift_coefficient, t.viv_range, t.viv_centre] if vibrates else []
    return [
        name,
        number(t.diameter),
        number(t.mass_per_length),
        "|".join([stiffness, *map(number, t.viscoelastic)]),
        damping + (f"|{number(t.dynamic_damping)}" if t.dynamic_damping else ""),
        bending + (f"|{number(t.bending_damping)}" if t.bending_damping else ""),
        *map(number, coefficients),
    ]


def _value(value: float | Curve, stem: str, path: Path) -> str:
    """Return a number, or the name of the table that a curve was written to (letters first, or C takes a number)."""
    if not isinstance(value, Curve):
        return number(value)
    name = re.sub(r"[^A-Za-z0-9_.-]", "_", f"{stem}_{path.stem}.txt").replace("---", "_")
    rows = [f"{number(x)} {number(y)}" for x, y in zip(value.x, value.y, strict=True)]
    table_text = "\n".join([f"Table of {stem}", "x y", "(-) (-)", *rows])  # MoorDyn-C refuses a newline at the end
    (path.parent / name).write_text(table_text, "utf-8")
    return name


def _rod_types(model: Model, names: dict[str, str]) -> list[str]:
    rows = [
        [names[t.name]]
        + [
            number(v)
            for v in (
                t.diameter,
                t.mass_per_length,
                t.transverse_drag,
                t.transverse_added_mass,
                t.end_drag,
                t.end_added_mass,
            )
        ]
        for t in model.rod_types
    ]
    header, units = "TypeName Diam Mass/m Cd Ca CdEnd CaEnd", "(name) (m) (kg/m) (-) (-) (-) (-)"
    return table("ROD TYPES", header, units, rows)


def _bodies(model: Model, flavour: Flavour, notes: list[str]) -> list[str]:
    header = "ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*"
    units = "(#) (word) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)"
    return table("BODIES", header, units, [_body(body, flavour, notes) for body in model.bodies])


def _body(b: Body, flavour: Flavour, notes: list[str]) -> list[str]:
    if any(b.added_mass[3:]):
        notes.append(f"body {b.id}: added inertia about the axes cannot be said")
    if flavour == "C" and max(len(set(b.drag_area[:3])), len(set(b.drag_area[3:]))) > 1:
        notes.append(f"body {b.id}: MoorDyn-C drops the first of several values of CdA")
    return [
        str(b.id),
        _hold(b),
        *map(number, b.position),
        *map(_degrees, b.rotation),
        number(b.mass),
        bars(b.centre_of_gravity),
        bars(b.inertia),
        number(b.volume),
        _drag(b.drag_area),
        bars(b.added_mass[:3]),
    ]


def _drag(values: tuple[float, ...]) -> str:
    if len(set(values)) == 1:
        return number(values[0])
    if len(set(values[:3])) == len(set(values[3:])) == 1:
        return bars((values[0], values[3]))
    return bars(values)


def _degrees(angle: float) -> str:
    """Return an angle in degrees that reads back as the same number of radians, when there is one."""
    degrees = math.degrees(angle)
    near = [degrees, math.nextafter(degrees, math.inf), math.nextafter(degrees, -math.inf), round(degrees, 12)]
    return number(next((d for d in near if math.radians(d) == angle), degrees))


def _hold(thing: Point | Rod | Body) -> str:
    words = {
        "fixed": "Fixed",
        "coupled": "Coupled",
        "free": "Free",
        "pinned": "Pinned",
        "coupled-pinned": "CoupledPinned",
    }
    body = getattr(thing, "body", None)
    if body is not None:
        return f"Body{body}" + ("Pinned" if thing.kind == "pinned" else "")
    return f"Turbine{thing.turbine}" if thing.turbine is not None else words[thing.kind]


def _rods(model: Model, names: dict[str, str]) -> list[str]:
    header = "ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs"
    units = "(#) (name) (word) (m) (m) (m) (m) (m) (m) (-) (-)"
    rows = [
        [
            str(r.id),
            _named(names, r.rod_type),
            _hold(r),
            *map(number, r.end_a),
            *map(number, r.end_b),
            str(r.segments),
            r.outputs or "-",
        ]
        for r in model.rods
    ]
    return table("RODS", header, units, rows)


def _points(model: Model, flavour: Flavour) -> list[str]:
    forced = flavour == "C" and any(any(p.external_force) for p in model.points)
    header = "ID Attachment X Y Z Mass Volume " + ("FX FY FZ " if forced else "") + "CdA Ca"
    units = "(#) (word) (m) (m) (m) (kg) (m^3) " + ("(N) (N) (N) " if forced else "") + "(m^2) (-)"
    rows = [
        [
            str(p.id),
            _hold(p),
            *map(number, p.position[:2]),
            "seabed" if p.on_seabed and flavour == "F" else number(p.position[2]),
            number(p.mass),
            number(p.volume),
            *(map(number, p.external_force) if forced else ()),
            number(p.drag_area),
            number(p.added_mass),
        ]
        for p in model.points
    ]
    return table("POINTS", header, units, rows)


def _lines(model: Model, names: dict[str, str]) -> list[str]:
    header = "ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs"
    units = "(#) (name) (ID) (ID) (m) (-) (-)"
    rows = [
        [
            str(line.id),
            _named(names, line.sections[0].line_type),
            tie(line.end_a),
            tie(line.end_b),
            number(line.sections[0].length),
            str(line.sections[0].segments),
            line.outputs or "-",
        ]
        for line in model.lines
    ]
    return table("LINES", header, units, rows)


def _options(model: Model, path: Path, flavour: Flavour, notes: list[str]) -> list[str]:
    options = environment_options(model.environment, path, flavour, notes)
    if model.start == "as-given":
        options.append(("0", "TmaxIC"))
    if model.output_interval is not None:
        options.append((number(model.output_interval), "dtOut"))
    for unused in model.unused_options:
        program = BY_NAME[unused.name.lower()].program
        if program in ("", f"MoorDyn-{flavour}"):
            options.append((unused.value, unused.name))
        else:
            notes.append(f"option {unused.name} is not one of MoorDyn-{flavour}")
    width = max(len(value) for value, _ in options)
    return [rule("OPTIONS"), *(f"{value.ljust(width)}  {name}" for value, name in options)]


def _outputs(model: Model, flavour: Flavour, notes: list[str]) -> list[str]:
    names = [output.name for output in model.outputs]
    if flavour == "C" and any(name.startswith("C") for name in names):
        names = [re.sub(r"^C[A-Z]*(?=\d)", "POINT", name) for name in names]
        notes.append("channels CON... are now called POINT..., the name that MoorDyn-C knows")
    return [rule("OUTPUTS"), *names] if names else []


def _unsaid(model: Model) -> list[str]:
    """Return what MoorDyn's tables have no place for."""
    places = [f"{t.id} at {', '.join(map(number, t.position))}" for t in model.turbines]
    notes = [f"turbines have no place in the file; a driver file says where they are: {'; '.join(places)}"] * bool(
        places
    )
    notes += [
        f"{kind} {thing.id}: MoorDyn knows no pinned things on turbines; written as Turbine{thing.turbine}"
        for kind, thing in on_turbines(model)
        if thing.kind == "coupled-pinned"
    ]
    notes += [
        f"line type {t.name}: {field.replace('_', ' ')} has no place in the file"
        for t in model.line_types
        for field in ("minimum_bend_radius", "minimum_breaking_load")
        if getattr(t, field) is not None
    ]
    for kind, things in (("line", model.lines), ("point", model.points), ("rod", model.rods), ("body", model.bodies)):
        named = [f"{thing.id} ({thing.name})" for thing in things if thing.name]  # type: ignore[attr-defined]
        if named:
            notes.append(f"names have no place in the file: {kind} {', '.join(named)}")
    return notes
