"""What a model must fulfil. Every check is one small function that yields the problems it finds."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import isfinite

from moorage.errors import ModelError, Problem, Source
from moorage.model.bed_checks import (
    anchors_are_on_the_grid,
    depths_are_positive,
    friction_is_possible,
    maps_are_grids,
    soil_is_possible,
)
from moorage.model.bed_doubts import anchors_over_the_bed, idle_static_friction, points_off_the_grid, weak_friction
from moorage.model.cables import (
    clamps_are_apart,
    clamps_face_their_lines,
    directions_are_given,
    folded_joints,
    pinned_junctions,
    sections_are_graded_well,
    springs_are_possible,
    stiffeners_fit,
)
from moorage.model.components import Body, ExternalLoad
from moorage.model.event_checks import (
    channels_exist,
    described,
    events_name_what_exists,
    failures_are_possible,
    failures_that_never_come,
    loads_that_move_nothing,
    winches_are_possible,
)
from moorage.model.inertia import lendings, objects_have_inertia
from moorage.model.line_type_checks import line_types_are_possible
from moorage.model.model import Model
from moorage.model.odd_values import (
    below_the_bed,
    nothing_there,
    odd_bodies,
    odd_letters,
    odd_types,
    odd_water,
    short_lines,
)
from moorage.model.ropes import rope_tensions_are_possible
from moorage.model.seabed import below_seabed
from moorage.model.signs import floats_of, wrong_signs
from moorage.model.turbines import (
    listed_turbines_exist,
    placed,
    turbines_at_one_place,
    turbines_carry_what_is_coupled,
    turbines_have_places,
)
from moorage.model.type_checks import values_have_types
from moorage.model.water_checks import (
    crowded_energy,
    current_is_possible,
    doubtful_current,
    doubtful_directions,
    growing_profiles,
    steep_waves,
    waves_are_given_once,
    waves_are_possible,
)

REMEDY = {"name": "rename one; case does not count", "channel": "list all its lines in one control"}
Check = Callable[[Model], Iterator[Problem]]

MOST_SEGMENTS = 100_000


def check(model: Model) -> None:
    """Raise one `ModelError` with everything that is wrong with a model."""
    problems = problems_of(model)
    if problems:
        raise ModelError(problems)


def problems_of(model: Model) -> list[Problem]:
    """Return everything that is wrong with a model; what names others is not judged until the names are right."""
    if wrong := list(values_have_types(model)):
        return wrong  # nothing can be said of values that are none
    left_out = REFERRING if any(names_are_unique(model)) else ()
    model = placed(model)
    return [problem for function in CHECKS if function not in left_out for problem in function(model)]


def lacking(model: Model) -> list[Problem]:
    """Return what a model that is right still lacks to be run: places of turbines, mass of what forces move."""
    return [*turbines_have_places(model), *objects_have_inertia(model)]


def suspicious(model: Model) -> list[Problem]:
    """Return what can be run but is hardly meant."""
    doubts = (
        pinned_junctions, folded_joints, weak_friction, idle_static_friction, points_off_the_grid, anchors_over_the_bed,
        steep_waves,
        growing_profiles, crowded_energy, doubtful_current, doubtful_directions, turbines_at_one_place,
        failures_that_never_come, loads_that_move_nothing, lendings, odd_types, odd_bodies, odd_water, short_lines,
        below_the_bed, odd_letters, nothing_there,
    )  # fmt: skip
    model = placed(model)
    return [problem for doubt in doubts for problem in doubt(model)]


def _named(model: Model) -> Iterator[tuple[str, object, Source | None]]:
    """Yield every component with the name it goes by in messages."""
    yield "environment", model.environment, Source(model.file) if model.file else None
    for kind, things in (("line type", model.line_types), ("rod type", model.rod_types)):
        yield from ((f"{kind} {thing.name}", thing, thing.source) for thing in things)  # type: ignore[attr-defined]
    for kind, objects in (
        ("line", model.lines),
        ("point", model.points),
        ("rod", model.rods),
        ("body", model.bodies),
        ("turbine", model.turbines),
        ("failure", model.failures),
        ("external load", model.external_loads),
    ):
        yield from ((f"{kind} {thing.id}", thing, thing.source) for thing in objects)  # type: ignore[attr-defined]
    yield from ((f"control channel {control.channel}", control, control.source) for control in model.controls)


def numbers_are_finite(model: Model) -> Iterator[Problem]:
    """No value is nan or infinite."""
    for name, thing, source in _named(model):
        for field, value in floats_of(thing):
            if not isfinite(value):
                yield Problem(f"{field.replace('_', ' ')} of {name} is not finite", "give a number", source, value)


def environment_is_possible(model: Model) -> Iterator[Problem]:
    """Depth is positive; gravity, density and seabed are not negative."""
    name, environment = "the environment", model.environment
    yield from wrong_signs(environment, name, model.source_of("water_depth"), "water_depth", "")
    for field in ("gravity", "water_density", "seabed_stiffness", "seabed_damping"):
        yield from wrong_signs(environment, name, model.source_of(field), "", field)
    if model.output_interval is not None and model.output_interval <= 0.0:
        source = model.source_of("output_interval")
        yield Problem("output interval must be positive", "correct it", source, model.output_interval)


def rod_types_are_possible(model: Model) -> Iterator[Problem]:
    """Rods have a diameter; mass and coefficients are not negative."""
    weak = "mass_per_length transverse_drag transverse_added_mass end_drag end_added_mass"
    for rod_type in model.rod_types:
        yield from wrong_signs(rod_type, f"rod type {rod_type.name}", rod_type.source, "diameter", weak)


def objects_are_possible(model: Model) -> Iterator[Problem]:
    """Masses, volumes and coefficients of points and bodies are not negative."""
    for point in model.points:
        weak = "mass volume drag_area added_mass"
        yield from wrong_signs(point, f"point {point.id}", point.source, "", weak)
    for body in model.bodies:
        weak = "mass inertia volume drag_area added_mass"
        yield from wrong_signs(body, f"body {body.id}", body.source, "", weak)
        yield from _counts(body, f"body {body.id}", "drag_area added_mass", (6,))
    for load in model.external_loads:
        weak = "linear_damping quadratic_damping"
        yield from wrong_signs(load, f"external load {load.id}", load.source, "", weak)
        yield from _counts(load, f"external load {load.id}", weak, (1, 2, 3) if load.target == "rod" else (1, 3))


def _counts(thing: Body | ExternalLoad, name: str, fields: str, counts: tuple[int, ...]) -> Iterator[Problem]:
    """Yield the fields (listed with blanks between) that have another number of values."""
    for field in fields.split():
        values = getattr(thing, field)
        if len(values) not in counts:
            wanted = " or ".join(map(str, counts))
            message = f"{field.replace('_', ' ')} of {name} has {len(values)} values"
            yield Problem(message, f"give {wanted}", thing.source, values)


def names_are_unique(model: Model) -> Iterator[Problem]:
    """Ids and names of types are given once, and ids are positive."""
    for kind, things, attribute in (
        ("line type", model.line_types, "name"),
        ("rod type", model.rod_types, "name"),
        ("line", model.lines, "id"),
        ("point", model.points, "id"),
        ("rod", model.rods, "id"),
        ("body", model.bodies, "id"),
        ("turbine", model.turbines, "id"),
        ("failure", model.failures, "id"),
        ("control channel", model.controls, "channel"),
        ("external load", model.external_loads, "id"),
    ):
        seen: dict[object, object] = {}
        for thing in things:
            key, source = getattr(thing, attribute), getattr(thing, "source", None)
            key = key.lower() if isinstance(key, str) else key
            if isinstance(key, int) and key < 1:
                article = "an" if kind[0] in "aeio" else "a"
                yield Problem(f"number of {article} {kind} must be positive", "count from 1", source, key)
            if key in seen:
                first = f" (first: {seen[key]})" if seen[key] else ""
                remedy = REMEDY.get(attribute, "give each its own")
                yield Problem(f"{kind} {key} is described twice{first}", remedy, source, key)
            seen.setdefault(key, source)


def sections_are_possible(model: Model) -> Iterator[Problem]:
    """Sections have a known type, a length and segments."""
    types = {line_type.name.lower(): line_type.name for line_type in model.line_types}
    for line in model.lines:
        if not line.sections:
            yield Problem(f"line {line.id} has no sections", "give at least one", line.source)
        for section in line.sections:
            source = section.source or line.source
            if section.line_type.lower() not in types:
                known = ", ".join(types.values()) or "none is described"
                message = f"line type of line {line.id} is not described"
                yield Problem(message, f"use one of: {known}", source, section.line_type)
            if section.length <= 0.0:
                yield Problem(f"length of line {line.id} must be positive", "correct it", source, section.length)
            if section.segments < 1:
                message = f"number of segments of line {line.id} must be at least 1"
                yield Problem(message, "correct it", source, section.segments)
            if section.segments > MOST_SEGMENTS:
                message = f"line {line.id} has more than {MOST_SEGMENTS} segments"
                yield Problem(message, "give fewer: some hundreds are fine", source, section.segments)


def ends_exist(model: Model) -> Iterator[Problem]:
    """Line ends are tied to points and rods that are there, and not both to one."""
    places = {("point", point.id) for point in model.points} | {("rod", rod.id) for rod in model.rods}
    for line in model.lines:
        for end, attachment in (("A", line.end_a), ("B", line.end_b)):
            if (attachment.kind, attachment.id) not in places:
                yield Problem(
                    f"end {end} of line {line.id} is tied to {attachment}, which is not described",
                    described(model, attachment.kind),
                    line.source,
                )
        if line.end_a == line.end_b:
            message = f"both ends of line {line.id} are tied to {line.end_a}"
            yield Problem(message, "tie its ends to different things", line.source)


def carriers_exist(model: Model) -> Iterator[Problem]:
    """Points and rods are carried by bodies that are there, rods have a type that is there."""
    bodies = {body.id for body in model.bodies}
    for kind, things in (("point", model.points), ("rod", model.rods)):
        for thing in things:
            if thing.body is not None and thing.body not in bodies:
                message = f"{kind} {thing.id} is carried by body {thing.body}, which is not described"
                yield Problem(message, described(model, "body"), thing.source)
    types = {rod_type.name.lower() for rod_type in model.rod_types}
    for rod in model.rods:
        if rod.rod_type.lower() not in types:
            known = ", ".join(t.name for t in model.rod_types) or "none is described"
            yield Problem(f"type of rod {rod.id} is not described", f"use one of: {known}", rod.source, rod.rod_type)


def rods_have_length(model: Model) -> Iterator[Problem]:
    """A rod with segments has two different ends."""
    for rod in model.rods:
        if rod.segments < 0:
            message = f"number of segments of rod {rod.id} must not be negative"
            yield Problem(message, "give 0 for a rod without length", rod.source, rod.segments)
        elif rod.segments > 0 and rod.end_a == rod.end_b:
            message = f"ends of rod {rod.id} coincide, but it has {rod.segments} segments"
            yield Problem(message, "give 0 segments for a rod without length", rod.source)


def anchors_are_not_buried(model: Model) -> Iterator[Problem]:
    """Fixed points stand on the seabed or above, where its depth is one."""
    if not model.environment.water_depth > 0.0 or any(depths_are_positive(model)):
        return
    for point in model.points:
        gap = below_seabed(point, model.environment)
        if gap > 0.0:
            depth = model.environment.depth_at(*point.position[:2])
            yield Problem(
                f"fixed point {point.id} is {gap:.4g} m below the seabed, where the water is {depth:.6g} m deep",
                f"write z = {-depth:.6g}, or read with raise_to_seabed (--raise-to-seabed)",
                point.source,
                point.position[2],
            )


def free_points_are_held(model: Model) -> Iterator[Problem]:
    """A free point has mass, or lines that pull it."""
    tied = {end.id for line in model.lines for end in (line.end_a, line.end_b) if end.kind == "point"}
    for point in model.points:
        if point.kind == "free" and point.id not in tied and not point.mass > 0.0:
            remedy = "tie a line to it, give it mass, or remove it"
            yield Problem(f"free point {point.id} has neither lines nor mass", remedy, point.source)


CHECKS: tuple[Check, ...] = (
    numbers_are_finite,
    environment_is_possible,
    friction_is_possible,
    soil_is_possible,
    maps_are_grids,
    depths_are_positive,
    current_is_possible,
    waves_are_given_once,
    waves_are_possible,
    line_types_are_possible,
    rod_types_are_possible,
    objects_are_possible,
    names_are_unique,
    sections_are_possible,
    rope_tensions_are_possible,
    ends_exist,
    carriers_exist,
    listed_turbines_exist,
    turbines_carry_what_is_coupled,
    rods_have_length,
    directions_are_given,
    clamps_face_their_lines,
    clamps_are_apart,
    stiffeners_fit,
    springs_are_possible,
    sections_are_graded_well,
    free_points_are_held,
    events_name_what_exists,
    failures_are_possible,
    winches_are_possible,
    channels_exist,
    anchors_are_not_buried,
    anchors_are_on_the_grid,
)

REFERRING: tuple[Check, ...] = (
    ends_exist,
    carriers_exist,
    listed_turbines_exist,
    clamps_face_their_lines,
    clamps_are_apart,
    free_points_are_held,
    events_name_what_exists,
    failures_are_possible,
    channels_exist,
)
