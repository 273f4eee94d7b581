"""Features that files can describe and that are not simulated yet; an entry goes when its physics comes."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from moorage.errors import Problem, UnsupportedError
from moorage.model.cables import is_joint
from moorage.model.components import Curve
from moorage.model.model import Model


def refuse_unbuilt(model: Model) -> None:
    """Raise one `UnsupportedError` that names every feature of the model that is not simulated yet."""
    problems = unbuilt(model)
    if problems:
        raise UnsupportedError(problems)


def unbuilt(model: Model) -> list[Problem]:
    """Return the features of a model that are not simulated yet, with their places."""
    return [problem for feature in UNBUILT for problem in feature(model)]


def _rod_damping(model: Model) -> Iterator[Problem]:
    short = {rod.id for rod in model.rods if not rod.segments}
    carried = {rod.id for rod in model.rods if rod.body is not None and rod.kind == "fixed"}
    for load in model.external_loads:
        damped = any((*load.linear_damping, *load.quadratic_damping))
        if load.target != "rod" or not load.local or not damped:
            continue
        if load.target_id in carried:
            message = f"external load {load.id}: damping along a rod that is fixed to a body is not simulated yet"
            yield Problem(message, "give the body a damping in its own axes", load.source)
        elif load.target_id in short:
            message = f"external load {load.id}: damping along a rod of no length is not simulated yet"
            yield Problem(message, "give it in global axes", load.source)


def _viscoelastic(model: Model) -> Iterator[Problem]:
    for t in model.line_types:
        if t.viscoelastic and not t.syrope:
            message = f"line type {t.name}: viscoelastic lines are not simulated yet"
            yield Problem(message, "give one value of EA", t.source, t.viscoelastic)


def _bending_damping(model: Model) -> Iterator[Problem]:
    for t in model.line_types:
        if t.bending_damping > 0.0:
            message = f"line type {t.name}: damping in bending is not simulated yet"
            yield Problem(message, "give EI alone", t.source, t.bending_damping)


def _syrope(model: Model) -> Iterator[Problem]:
    for t in model.line_types:
        if t.syrope:
            message = f"line type {t.name}: the Syrope model is not simulated yet"
            yield Problem(message, "give one value of EA, or a table", t.source, t.syrope)


def _vortex_vibration(model: Model) -> Iterator[Problem]:
    for t in model.line_types:
        if t.lift_coefficient > 0.0:
            message = f"line type {t.name}: vortex-induced vibration is not simulated yet"
            yield Problem(message, "set Cl to 0", t.source, t.lift_coefficient)


def _waves(model: Model) -> Iterator[Problem]:
    waves = model.environment.unread_water
    if waves is not None:
        what = "currents" if waves.option == "Currents" else "waves"
        remedy = f"remove option {waves.option}"
        if waves.option == "Currents":
            remedy = f"write {int(waves.value) - 2}, which reads the same file at all places"
        yield Problem(
            f"{what} of {waves.option} {waves.value} are not simulated yet", remedy, waves.source, waves.value
        )


def _winches(model: Model) -> Iterator[Problem]:
    lines = {line.id: line for line in model.lines}
    joints = {rod.id for rod in model.rods if is_joint(rod)}
    for control in model.controls:
        for line in (lines[id] for id in control.lines if id in lines):
            tie, section = (line.end_b, line.sections[-1]) if control.end == "B" else (line.end_a, line.sections[0])
            what = f"control channel {control.channel}: a winch at end {control.end} of line {line.id}"
            if tie.kind == "rod" and tie.id in joints:
                yield Problem(
                    f"{what}, on a joint of cables, is not simulated yet", "use the other end", control.source
                )
            if any(stiffener.end == control.end for stiffener in line.stiffeners):
                yield Problem(
                    f"{what}, where a bend stiffener is, is not simulated yet", "use the other end", control.source
                )
            if isinstance(model.line_type(section.line_type).bending_stiffness, Curve):
                remedy = "give one value of EI"
                yield Problem(f"{what} with a table of EI is not simulated yet", remedy, control.source)


UNBUILT: tuple[Callable[[Model], Iterator[Problem]], ...] = (
    _rod_damping,
    _viscoelastic,
    _bending_damping,
    _syrope,
    _vortex_vibration,
    _waves,
    _winches,
)
