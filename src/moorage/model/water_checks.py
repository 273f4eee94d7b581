"""What waves and current of a model must fulfil."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from moorage.errors import Problem
from moorage.model.current_grid import CurrentGrid
from moorage.model.model import Model


def current_is_possible(model: Model) -> Iterator[Problem]:
    """Levels of the current increase, each with a velocity, and a grid of it reaches as far as the model."""
    current = model.environment.current
    if isinstance(current, CurrentGrid):
        yield from _grid_of_current(model, current)
        return
    if len(current.z) != len(current.velocity) or not current.z:
        yield Problem("current has not one velocity for each level", "give both for each level", current.source)
    if any(b <= a for a, b in pairwise(current.z)):
        yield Problem("levels of the current do not increase", "sort them, each once", current.source, current.z)


def _grid_of_current(model: Model, current: CurrentGrid) -> Iterator[Problem]:
    """Axes increase, each point has a velocity, and the grid reaches as far as the model."""
    if current.velocity.shape != (*current.shape, 3):
        what = f"{current.velocity.shape}, not {(*current.shape, 3)}"
        yield Problem(
            "velocities of the current do not fit its grid", "give three for each point", current.source, what
        )
        return
    if not np.isfinite(current.velocity).all():
        yield Problem("velocities of the current are not all finite", "correct them", current.source)
    for name in "txyz":
        axis = getattr(current, name)
        if any(b <= a for a, b in pairwise(axis)):
            what = {"t": "times", "z": "levels"}.get(name, name)
            yield Problem(f"{what} of the current do not increase", "sort them, each once", current.source, axis)
            return
    held = [point.position for point in model.points if point.body is None]
    if not held:
        return
    c, s, r = np.cos(current.turn), np.sin(current.turn), np.array(held)
    short = []
    for name, axis, reach in (
        ("x", current.x, c * r[:, 0] + s * r[:, 1]),
        ("y", current.y, c * r[:, 1] - s * r[:, 0]),
    ):
        gap = max(axis[0] - reach.min(), reach.max() - axis[-1])
        if len(axis) > 1 and gap > 1e-6:
            span = f"grid {axis[0]:g} to {axis[-1]:g} m, model {reach.min():g} to {reach.max():g} m"
            short.append(f"{name} by {gap:.4g} m ({span})")
    if short:
        what = f"the grid of the current does not cover the model in {', in '.join(short)}"
        yield Problem(what, "give velocities as far as the model reaches", current.source)


def waves_are_given_once(model: Model) -> Iterator[Problem]:
    """Waves come from the model or from a host, not from both."""
    environment = model.environment
    if environment.host_waves and environment.waves is not None:
        where = model.source_of("host_waves")
        yield Problem("waves are given by the model and by a host", "remove waves, or host_waves", where)


def waves_are_possible(model: Model) -> Iterator[Problem]:
    """Components have one of each, positive frequencies, and water under them."""
    waves = model.environment.waves
    if waves is None:
        return
    names = ("frequency", "amplitude", "phase", "direction", "wavenumbers", "crests")
    counts = {name: len(getattr(waves, name)) for name in names}
    counts = {name: count for name, count in counts.items() if count or name in names[:4]}
    if len(set(counts.values())) > 1:
        given = ", ".join(f"{count} of {name}" for name, count in counts.items())
        yield Problem("components of the waves do not have one of each", "give as many of each", waves.source, given)
    lowest = min(waves.frequency, default=1.0)
    if not lowest > 0.0:
        yield Problem("frequency of a wave component must be positive", "correct or remove it", waves.source, lowest)
    if not waves.depth > 0.0:
        yield Problem("depth of the waves must be positive", "give that of the water", waves.source, waves.depth)


def steep_waves(model: Model) -> list[Problem]:
    """Return a doubt about a sea that is steeper than seas are.

    2 pi Hs / (g Tp^2) is at most 1/15 for Tp up to 8 s and 1/25 from 15 s on, linear between (DNV-RP-C205, 3.5.4).
    """
    waves = model.environment.waves
    if waves is None or waves.is_regular:
        return []
    asked = dict(waves.asked)
    height, period = asked.get("height", waves.significant_height), asked.get("period", waves.peak_period)
    assert isinstance(height, float | int)
    assert isinstance(period, float | int)
    limit = float(np.interp(period, [8.0, 15.0], [1.0 / 15.0, 1.0 / 25.0]))
    highest = limit * waves.gravity * period**2 / (2.0 * np.pi)
    if height <= highest:
        return []
    what = f"a sea of Hs {height:.3g} m and Tp {period:.3g} s is steeper than seas are"
    return [Problem(what, f"Hs is at most {highest:.3g} m there (DNV-RP-C205)", waves.source)]
