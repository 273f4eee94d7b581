"""The environment that the options of a file describe, with the depth and current files that they name."""

from __future__ import annotations

import warnings
from pathlib import Path

from moorage.errors import ModelWarning, Source
from moorage.io.bathymetry import read_bathymetry
from moorage.io.moordyn.options import Value
from moorage.io.moordyn.water import Surroundings, read_water
from moorage.io.text import Findings, is_number, to_float
from moorage.model import Bathymetry, Environment, Friction, Point, Rod

Values = dict[str, Value]
_NUMBERS = {"gravity": "g", "water_density": "rho", "seabed_stiffness": "kBot", "seabed_damping": "cBot"}


def read_environment(
    values: Values,
    points: list[Point],
    rods: list[Rod],
    folder: Path,
    found: Findings,
    source: Source,
    defaults: Environment | None,
) -> Environment:
    """Return the environment; `defaults` holds what a driver file says where the options are silent."""
    bathymetry = _bathymetry(values, folder, found)
    base = defaults or Environment(water_depth=0.0)
    numbers = {field: number(values, name, getattr(base, field)) for field, name in _NUMBERS.items()}
    depth = _depth(values, points, bathymetry, found, source, defaults)
    places = [point.position for point in points if point.body is None and point.turbine is None]
    held = [rod for rod in rods if rod.body is None and rod.turbine is None]
    places += [end for rod in held for end in (rod.end_a, rod.end_b if rod.segments else rod.end_a)]
    sea = {"depth": depth, "gravity": numbers["gravity"], "density": numbers["water_density"]}
    water = read_water(values, Surroundings(sea, folder, places, found))
    return Environment(
        water_depth=depth,
        gravity=numbers["gravity"],
        water_density=numbers["water_density"],
        seabed_stiffness=numbers["seabed_stiffness"],
        seabed_damping=numbers["seabed_damping"],
        friction=_friction(values),
        bathymetry=bathymetry,
        current=water.current,
        waves=water.waves,
        unread_water=water.unread,
        host_waves=water.from_host,
    )


def sources(values: Values) -> tuple[tuple[str, Source], ...]:
    """Return where the options stand that give the values of a model, by the names of those."""
    names = _NUMBERS | {"water_depth": "WtrDpth", "output_interval": "dtOut"}
    names |= {"host_waves": "WaveKin"}
    return tuple((field, values[name].source) for field, name in names.items() if name in values)


def number(values: Values, name: str, default: float) -> float:
    """Return the number that an option has, or a default when it is not given."""
    word = values[name].word if name in values else ""
    return to_float(word) if is_number(word) else default


def _bathymetry(values: Values, folder: Path, found: Findings) -> Bathymetry | None:
    """Return the grid of C's SeafloorFile, or of F's WtrDpth when that is not a number."""
    named = values.get("SeafloorFile")
    if named is None and "WtrDpth" in values and not is_number(values["WtrDpth"].word):
        named = values["WtrDpth"]
        if named.word.lower() in ("nan", "inf", "-inf", "+inf"):
            found.number(named.word, "water depth", named.source)
            return None
    if named is None:
        return None
    path, from_here = folder / named.word, Path(named.word)
    # MoorDyn-C looks for this file alone in the folder that it is started from
    return read_bathymetry(from_here if not path.exists() and from_here.exists() else path, found, named.source)


def _depth(
    values: Values,
    points: list[Point],
    bathymetry: Bathymetry | None,
    found: Findings,
    source: Source,
    defaults: Environment | None,
) -> float:
    if "WtrDpth" in values and is_number(values["WtrDpth"].word):
        return number(values, "WtrDpth", 0.0)
    if bathymetry is not None:
        return bathymetry.depth_at(0.0, 0.0)
    if "WtrDpth" in values or "SeafloorFile" in values:
        return float("nan")  # the file could not be read, which has been noted
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
    both = number(values, "FrictionCoefficient", 0.0)
    return Friction(
        transverse=number(values, "mu_kT", both),
        axial=number(values, "mu_kA", both),
        static_ratio=number(values, "StatDynFricScale", 1.0),
        model="saturated-damping",
        damping=number(values, "FricDamp", 200.0),
        source=named.source,
    )
