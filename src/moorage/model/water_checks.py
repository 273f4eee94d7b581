"""What waves and current of a model must fulfil."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from moorage.errors import Problem
from moorage.model.current_grid import CurrentGrid
from moorage.model.model import Model
from moorage.model.waves import Waves

GROWTH = 1.5  # of velocities to the crests that is worth a word
LONELY = 0.5  # of the energy in one component that is worth a word
LOST = 0.05  # of the energy
FASTEST = 10.0  # m/s of a current; the fastest tidal streams
SHARPEST = 10.0  # gamma, of the narrowest swell
REGULAR = ("regular", "stokes", "stream-function")


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
    if not model.flavour.startswith("MoorDyn"):
        yield from _short_grid(model, current)


def _short_grid(model: Model, current: CurrentGrid) -> Iterator[Problem]:
    """A grid reaches as far as the model; MoorDyn lets its edges go on, which is a doubt in files of MoorDyn."""
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
        remedy = "give velocities as far as the model reaches; beyond, those at the edge hold"
        yield Problem(what, remedy, current.source)


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
    if not waves.frequency:
        yield Problem("there is no wave component", "give some, or remove waves", waves.source)
        return
    values = (
        *waves.frequency,
        *waves.amplitude,
        *waves.phase,
        *waves.direction,
        waves.depth,
        waves.gravity,
        waves.ramp,
    )
    if not np.isfinite(values).all():
        yield Problem("a value of the waves is not finite", "give numbers", waves.source)
        return
    if not waves.gravity > 0.0:
        yield Problem("waves need gravity", "give gravity, or remove waves", waves.source, waves.gravity)
    if waves.ramp < 0.0:
        yield Problem("ramp of the waves must not be negative", "correct it", waves.source, waves.ramp)
    lowest = min(waves.frequency)
    if not lowest > 0.0:
        yield Problem("frequency of a wave component must be positive", "correct or remove it", waves.source, lowest)
    if not waves.depth > 0.0:
        yield Problem("depth of the waves must be positive", "give that of the water", waves.source, waves.depth)


def steep_waves(model: Model) -> list[Problem]:
    """Return doubts about a sea that is steeper, or more peaked, than seas are.

    2 pi Hs / (g Tp^2) is at most 1/15 for Tp up to 8 s and 1/25 from 15 s on, linear between (DNV-RP-C205); a
    regular wave breaks at 0.142 of its length times tanh(k d) (Miche).
    """
    waves = model.environment.waves
    if waves is None:
        return []
    if waves.is_regular:
        if waves.wavenumbers:
            return []  # a steep theory has looked at that
        return _breaking(waves)
    asked = dict(waves.asked)
    peak, doubts = asked.get("gamma", 1.0), []
    if isinstance(peak, float | int) and not 1.0 <= peak <= SHARPEST:
        what = f"gamma of the sea is {peak:.3g}; seas have 1 to 7"
        doubts.append(Problem(what, "correct it, or leave it out", waves.source))
    height, period = asked.get("height", waves.significant_height), asked.get("period", waves.peak_period)
    assert isinstance(height, float | int)
    assert isinstance(period, float | int)
    limit = float(np.interp(period, [8.0, 15.0], [1.0 / 15.0, 1.0 / 25.0]))
    highest = limit * waves.gravity * period**2 / (2.0 * np.pi)
    if height <= highest:
        return doubts
    what = f"a sea of Hs {height:.3g} m and Tp {period:.3g} s is steeper than seas are"
    return [*doubts, Problem(what, f"Hs is at most {highest:.3g} m there (DNV-RP-C205)", waves.source)]


def _breaking(waves: Waves) -> list[Problem]:
    k, height = float(waves.wavenumber[0]), 2.0 * abs(waves.amplitude[0])
    highest = 0.142 * 2.0 * np.pi / k * float(np.tanh(k * waves.depth))
    if height <= highest:
        return []
    what = f"a wave of {height:.3g} m would break: it is {2.0 * np.pi / k:.3g} m long"
    return [Problem(what, f"it breaks at {highest:.3g} m (Miche)", waves.source)]


def growing_profiles(model: Model) -> list[Problem]:
    """Return a doubt about a sea whose profiles go on to the crests, where the shortest waves take over.

    Unstretched, a component grows by exp(k z) above the still water; the spread of the velocity (its rms) is looked at
    as high as the highest crests of some hours, which is Hs. Steep regular waves are made to go on so.
    """
    waves = model.environment.waves
    if waves is None or waves.is_regular or waves.stretching != "none":
        return []
    height, k = waves.significant_height, waves.wavenumber
    still = np.square(waves.elevations * np.array(waves.frequency) / np.tanh(k * waves.depth))
    with np.errstate(over="ignore"):
        growth = float(np.sqrt((still * np.exp(2.0 * k * height)).sum() / still.sum()))
    if growth <= GROWTH:
        return []
    what = f"without stretching velocities at crests of {height:.3g} m are {growth:.3g} times those at the still water"
    remedy = (
        "write stretching: wheeler, vertical or linear; short waves ride on the long ones, they are no part of them"
    )
    return [Problem(what, remedy, waves.source)]


def crowded_energy(model: Model) -> list[Problem]:
    """Return doubts about a spectrum that its components do not stand for: a lone one, or energy left outside."""
    waves = model.environment.waves
    asked = dict(waves.asked) if waves else {}
    if waves is None or "height" not in asked or asked.get("spectrum") in REGULAR:
        return []
    energy, doubts, count = np.square(waves.elevations), [], len(waves.frequency)
    share, m0 = float(energy.max() / energy.sum()), float(0.5 * energy.sum())
    if share > LONELY:
        what = f"one of the {count} components of the sea" if count > 1 else "the only component of the sea"
        what = f"{what} has {share:.2g} of its energy (m0), at {2.0 * np.pi / waves.frequency[energy.argmax()]:.3g} s"
        doubts.append(Problem(what, "give more components (200 by default), or spectrum: regular", waves.source, count))
    asked_m0 = float(asked["height"]) ** 2 / 16.0
    lost = 1.0 - m0 / asked_m0
    if asked.get("spectrum") != "a function" and lost > LOST:
        what = f"{lost:.2g} of the energy of the spectrum (m0) is lost: Hs {waves.significant_height:.3g} m instead of "
        what += f"{asked['height']:.3g} m; components are cut where they begin and end, from 0.5 to 3.5 of the peak"
        doubts.append(Problem(what, "give a table of the spectrum (density) over all of it", waves.source))
    return doubts


def doubtful_current(model: Model) -> list[Problem]:
    """Return doubts about levels above the water, and about a grid that begins late or stops short in depth."""
    current = model.environment.current
    doubts = []
    fastest = float(np.abs(np.asarray(current.velocity, float)).max(initial=0.0))
    if fastest > FASTEST:
        doubts.append(Problem(f"the current runs at {fastest:.3g} m/s", "give m/s", current.source))
    if max(current.z, default=0.0) > 0.0:
        what = f"the current has a level {max(current.z):g} m above the water"
        doubts.append(Problem(what, "levels are z: negative below the water", current.source))
    if isinstance(current, CurrentGrid):
        if model.flavour.startswith("MoorDyn"):
            doubts += _short_grid(model, current)
        if current.t[0] > 0.0:
            what = f"the current begins at {current.t[0]:g} s; before, its first values hold"
            doubts.append(Problem(what, "give values from time 0 s", current.source))
        lowest = min((point.position[2] for point in model.points if point.body is None), default=0.0)
        if len(current.z) > 1 and lowest < current.z[0] - 1e-6:
            what = f"the grid of the current ends {current.z[0] - lowest:.4g} m above the lowest point of the model"
            doubts.append(Problem(what, "give levels down to there; below, the lowest values hold", current.source))
    return doubts


def doubtful_directions(model: Model) -> list[Problem]:
    """Return a doubt about directions of components that are no angles in radians."""
    waves = model.environment.waves
    far = max((abs(d) for d in waves.direction), default=0.0) if waves else 0.0
    if waves is None or far <= 2.0 * np.pi + 1e-6:
        return []
    return [Problem(f"a wave component has the direction {far:g} rad", "give radians, or check it", waves.source)]
