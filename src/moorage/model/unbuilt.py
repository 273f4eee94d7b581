"""Features that files can describe and that are not simulated yet; an entry goes when its physics comes."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from moorage.errors import Problem, UnsupportedError
from moorage.model.cables import stiff_ends
from moorage.model.channels import parse_channel
from moorage.model.model import Model


def refuse_unbuilt(model: Model) -> None:
    """Raise one `UnsupportedError` that names every feature of the model that is not simulated yet."""
    problems = unbuilt(model)
    if problems:
        raise UnsupportedError(problems)


def unbuilt(model: Model) -> list[Problem]:
    """Return the features of a model that are not simulated yet, with their places."""
    return [problem for feature in UNBUILT for problem in feature(model)]


def _moving_rods(model: Model) -> Iterator[Problem]:
    for rod in model.rods:
        if rod.kind in ("pinned", "coupled-pinned") or (rod.kind == "free" and rod.body is None and rod.segments):
            message = f"rod {rod.id}: {rod.kind} rods are not simulated yet"
            yield Problem(message, "make it fixed, coupled or carried by a body, or give it no length", rod.source)


def _moving_bodies(model: Model) -> Iterator[Problem]:
    for body in model.bodies:
        if body.kind not in ("fixed", "coupled"):
            message = f"body {body.id}: {body.kind} bodies are not simulated yet"
            yield Problem(message, "make it fixed, or coupled and moved by a motion", body.source)


def _joints(model: Model) -> Iterator[Problem]:
    for rod in model.rods:
        if rod.kind == "free" and not rod.segments and len(stiff_ends(model, rod.id)) > 2:
            message = f"rod {rod.id}: joints of more than two cables are not simulated yet"
            yield Problem(message, "join two cables at a rod", rod.source)


def _turbines(model: Model) -> Iterator[Problem]:
    for kind, things in (("point", model.points), ("rod", model.rods), ("body", model.bodies)):
        for thing in things:
            if thing.turbine is not None:  # type: ignore[attr-defined]
                message = f"{kind} {thing.id}: attachments to turbines are not simulated yet"  # type: ignore[attr-defined]
                yield Problem(message, "describe it as coupled", thing.source)  # type: ignore[attr-defined]


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


def _failures(model: Model) -> Iterator[Problem]:
    for failure in model.failures:
        if failure.tension > 0.0:
            message = f"failure {failure.id}: failures at a tension are not simulated yet"
            yield Problem(message, "give a time only, and a tension of 0", failure.source, failure.tension)
        if failure.attachment.kind == "rod":
            message = f"failure {failure.id}: failures at rods are not simulated yet"
            yield Problem(message, "tie the line to a point", failure.source)


def _controls(model: Model) -> Iterator[Problem]:
    for control in model.controls:
        message = f"control channel {control.channel}: controlled lengths are not simulated yet"
        yield Problem(message, "remove it", control.source)


def _external_loads(model: Model) -> Iterator[Problem]:
    for load in model.external_loads:
        yield Problem(f"external load {load.id}: external loads are not simulated yet", "remove it", load.source)


def _channels(model: Model) -> Iterator[Problem]:
    for output in model.outputs:
        channel = parse_channel(output.name)
        if channel and channel.object in ("rod", "body") and channel.quantity not in ("PX", "PY", "PZ"):
            message = f"channel {output.name}: other channels of rods and bodies than positions are not simulated yet"
            yield Problem(message, "remove it, or ask for PX, PY, PZ", output.source)


UNBUILT: tuple[Callable[[Model], Iterator[Problem]], ...] = (
    _moving_rods,
    _moving_bodies,
    _joints,
    _turbines,
    _viscoelastic,
    _bending_damping,
    _syrope,
    _vortex_vibration,
    _waves,
    _failures,
    _controls,
    _external_loads,
    _channels,
)
