"""What a result says about where it comes from, so that a run can be repeated from its own result."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Mapping
from datetime import UTC, datetime

from moorage.model import Model, Motion, OutputChannel
from moorage.results.sea import sea_attributes
from moorage.words import current_words, friction_words, turbine_words


def run_attributes(
    model: Model, motion: Motion | None, settings: Mapping[str, object], version: str
) -> dict[str, object]:
    """Return the global attributes of a result."""
    return {
        "Conventions": "CF-1.11",
        "title": model.title or "Mooring simulation",
        "moorage_version": version,
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
        "input_file": model.file,
        "input_format": model.flavour,
        "input": model.text,
        "input_sha256": hashlib.sha256(model.text.encode()).hexdigest(),
        "motion": _motion_name(motion),
        "motion_sha256": _motion_hash(motion),
        **settings,
        "unused_options": "; ".join(f"{o.name} = {o.value} ({o.reason})" for o in model.unused_options),
        "water_depth": float(model.environment.water_depth),
        "gravity": float(model.environment.gravity),
        "water_density": float(model.environment.water_density),
        **({"turbines": turbine_words(model.turbines)} if model.turbines else {}),
        **_seabed(model),
        **sea_attributes(model.environment.waves),
        **_current(model),
        **_readings(model),
        **_failures(model),
    }


def fingerprint(model: Model, motion: Motion | None, settings: Mapping[str, object]) -> str:
    """Return a hash of all that decides the numbers of a run; where the files lie does not."""
    outputs = tuple(OutputChannel(name=output.name) for output in model.outputs)
    content = dataclasses.replace(model, file="", unused_options=(), outputs=outputs)
    text = f"{content!r}{model.text}{_motion_hash(motion)}{sorted(settings.items())!r}"
    return hashlib.sha256(text.encode()).hexdigest()


def _seabed(model: Model) -> dict[str, str]:
    """Return where the depth grid comes from, what was lost on the way, the soil, and the law of friction."""
    grid, soil, friction = model.environment.bathymetry, model.environment.soil, model.environment.friction
    words = {"soil": f"with a memory, s_u = {soil}"} if soil else {}
    words |= {"friction": friction_words(friction)} if friction and friction.largest > 0.0 else {}
    if grid is None:
        return words
    return words | {
        "bathymetry": ", ".join(filter(None, [grid.file or "a grid", str(grid.resampling or "")])),
        "bathymetry_interpolation": "bicubic" if grid.smooth else "bilinear",
    }


def _current(model: Model) -> dict[str, str]:
    """Return the current in words, where there is one."""
    words = current_words(model.environment.current)
    return {"current": words} if words else {}


def _failures(model: Model) -> dict[str, str]:
    """Return which lines come off where and when, where any do."""
    words = []
    for failure in model.failures:
        when = [f"at {failure.time:g} s"] if failure.time > 0.0 else []
        when += [f"at {failure.tension / 1e3:g} kN"] if failure.tension > 0.0 else []
        lines = ("line " if len(failure.lines) == 1 else "lines ") + ", ".join(map(str, failure.lines))
        if when:
            words.append(f"{lines} from {failure.attachment} {' or '.join(when)}")
    return {"failures": "; ".join(words)} if words else {}


def _readings(model: Model) -> dict[str, str]:
    """Return how a model with rods was read and held, where programs and their pages disagree.

    MoorDyn's pages give a rod without length a direction as end B. The sources of both flavours take the difference of
    the two ends (Body::addRod, Rod_Setup); only for free rods does the one in C take end B for a direction, which has
    no effect, because the lines turn such a rod.
    """
    if not model.rods:
        return {}
    clamps = "exact" if model.flavour == "native" else "equation 10 of Hall, Sirnivas and Yu (2020), as in MoorDyn"
    words = "end B was read as the coordinates of a point: the rod points from end A to it"
    flat = ", ".join(str(rod.id) for rod in model.rods if not rod.segments)
    return {"clamp_rule": clamps} | ({"zero_length_rods": f"{flat}: {words}"} if flat else {})


def _motion_name(motion: Motion | None) -> str:
    if motion is None:
        return "none"
    return str(motion.source) if motion.source else "from arrays"


def _motion_hash(motion: Motion | None) -> str:
    digest = hashlib.sha256()
    if motion is not None:
        digest.update(motion.time.tobytes())
        for table in (motion.platform, motion.coupled):
            digest.update(b"-" if table is None else table.tobytes())
        for tables in (motion.turbines, motion.points):
            for id, table in sorted(tables.items()):
                digest.update(f"{id}".encode() + table.tobytes())
    return digest.hexdigest()
