"""Currents of a native file: in words, a speed, a direction and how it falls towards the seabed; or on a grid."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from moorage.errors import ModelWarning
from moorage.io.text import Findings
from moorage.model import Current, CurrentGrid, Environment

STEPS = 64  # of the speed between seabed and surface
LOWEST = 1e-6  # depth over water depth, below which a profile needs no more levels
EXPONENT = 1.0 / 7.0
Values = dict[str, Any]


def current_of(asked: Values, depth: float, found: Findings) -> Current:
    """Return the current of words; a still one, with problems noted, when they have no sense.

    A power law is U (1 + z/h)^n, at levels of equal steps of speed: linear between them, and above a hundredth of
    the depth, it is good to 1e-3 U for exponents of 1/20 to 1.
    """
    speed, profile, exponent = asked["speed"], asked.get("profile", "uniform"), asked.get("exponent", EXPONENT)
    if not speed >= 0.0:
        found.add("speed of the current is negative", "turn its direction by 180 deg", asked["source"], speed)
    if profile == "uniform" and "exponent" in asked:
        found.add("exponent means nothing for a uniform current", "remove it", asked["source"], exponent)
    if not exponent > 0.0:
        found.add("exponent of the current must be positive", "correct it, or write uniform", asked["source"], exponent)
    if found.problems or not depth > 0.0:
        return Current()
    way = np.deg2rad(asked.get("direction", 0.0))
    share, z = np.ones(1), np.zeros(1)
    if profile == "power":
        share = np.linspace(0.0, 1.0, STEPS + 1)
        height = share ** (1.0 / exponent)  # above the seabed, over the depth
        kept = (height > LOWEST) | (share == 0.0)
        share, z = share[kept], (height[kept] - 1.0) * depth
    u, v = speed * share * np.cos(way), speed * share * np.sin(way)
    return Current(tuple(z.tolist()), tuple(zip(u.tolist(), v.tolist(), [0.0] * len(z), strict=True)), asked["source"])


def current_grid(asked: Values, found: Findings) -> Current | CurrentGrid:
    """Return the current of a grid's points; a still one, with a problem noted, when they do not fit."""
    axes = {name: asked.get(name, (0.0,)) for name in "txyz"}
    counts = tuple(len(axis) for axis in axes.values())
    rows, points = asked["velocity"], int(np.prod(counts))
    if len(rows) != points or any(len(row) != 3 for row in rows):
        given = f"{len(rows)} rows of {len(rows[0]) if rows else 0}"
        found.add("velocities of the current do not fit its grid", f"give {points} rows of 3", asked["source"], given)
        return Current()
    velocity = np.array(rows, float).reshape(*counts, 3)
    return CurrentGrid(**axes, velocity=velocity, turn=asked.get("turn", 0.0), source=asked["source"])


def grid_as_plain(current: CurrentGrid) -> dict[str, Any]:
    """Return a grid by the native schema, without the axes along which it does not change."""
    tree: dict[str, Any] = {name: list(getattr(current, name)) for name in "txyz"}
    tree = {name: axis for name, axis in tree.items() if len(axis) > 1 or name == "t"}
    tree["velocity"] = current.velocity.reshape(-1, 3).tolist()
    return tree | ({"turn": current.turn} if current.turn else {})


def warn_of_deep_levels(environment: Environment) -> None:
    """Warn of a profile whose lowest level is below the deepest seabed: its z may be depths, or of another place.

    Ocean models have the same levels at all places.
    """
    grid, current = environment.bathymetry, environment.current
    if isinstance(current, CurrentGrid) and max(current.shape[1:3]) > 1:
        return
    depth = max(map(max, grid.depth)) if grid else environment.water_depth
    below = -current.z[0] - depth if current.z else 0.0
    if below > 1e-3 * depth:
        where = f"{current.source}: " if current.source else ""
        message = f"the current's lowest level, {current.z[0]:g} m, is {below:.4g} m below the seabed at {-depth:g} m"
        warnings.warn(f"{where}{message}", ModelWarning, stacklevel=2)
