"""The environment that the options of a file describe, with the depth and current files that they name."""

from __future__ import annotations

import dataclasses
import warnings
from pathlib import Path

from moorage.errors import ModelWarning, Source
from moorage.io.moordyn.options import Value
from moorage.io.text import Findings, is_number, to_float
from moorage.model import Environment, Friction, Point

Values = dict[str, Value]


def read_environment(
    values: Values, points: list[Point], folder: Path, found: Findings, source: Source, defaults: Environment | None
) -> Environment:
    """Return the environment; `defaults` holds what a driver file says where the options are silent."""
    given = {
        field: _number(values, name)
        for field, name in (
            ("gravity", "g"),
            ("water_density", "rho"),
            ("seabed_stiffness", "kBot"),
            ("seabed_damping", "cBot"),
        )
        if name in values
    }
    depth = _depth(values, points, found, source, defaults)
    environment = dataclasses.replace(defaults or Environment(water_depth=depth), water_depth=depth, **given)
    return dataclasses.replace(environment, friction=_friction(values))


def _number(values: Values, name: str, default: float = 0.0) -> float:
    word = values[name].word if name in values else ""
    return to_float(word) if is_number(word) else default


def _depth(values: Values, points: list[Point], found: Findings, source: Source, defaults: Environment | None) -> float:
    if "WtrDpth" in values and is_number(values["WtrDpth"].word):
        return _number(values, "WtrDpth")
    if defaults is not None:
        return defaults.water_depth
    lowest = min((p.position[2] for p in points if p.body is None and not p.on_seabed), default=0.0)
    if not lowest < 0.0:
        found.add("no water depth is given", "add the option: 200 WtrDpth", source)
        return float("nan")
    warnings.warn(
        f"{source}: no water depth is given; it is that of the lowest point, {-lowest:g} m, as in MoorDyn-C",
        ModelWarning,
        stacklevel=2,
    )
    return -lowest


def _friction(values: Values) -> Friction | None:
    """Return the friction: axial and transverse coefficients of F, or the one of C for both."""
    names = ("FrictionCoefficient", "mu_kT", "mu_kA", "StatDynFricScale", "FricDamp")
    named = next((values[name] for name in names if name in values), None)
    if named is None:
        return None
    both = _number(values, "FrictionCoefficient")
    return Friction(
        transverse=_number(values, "mu_kT", both),
        axial=_number(values, "mu_kA", both),
        static_ratio=_number(values, "StatDynFricScale", 1.0),
        damping=_number(values, "FricDamp", 200.0),
        source=named.source,
    )
