"""What the paper leaves open, and how much each choice moves line 1."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from itertools import islice

import numpy as np

from moorage.model import LineType, Model, Motion, Waves
from studies.parts import Effort, Part, table
from studies.peers import with_environment, with_types
from studies.seabed_2022.mooring import (
    CHAIN,
    DAMPED,
    HEIGHT,
    PERIOD,
    STATIC,
    STICKING,
    in_waves,
    semi_taut,
)
from studies.seabed_2022.platform import THRUST, in_wind
from studies.seabed_2022.runs import fairlead, node_tension, node_time, ours

DURATION, STARTED = 120.0, 45.0
WIND, WIND_STARTED = 1200.0, 1000.0
GROUNDED = (3, 9, 15)  # nodes of the chain


def with_type(model: Model, name: str, **changed) -> Model:
    """Return a model with properties of one line type changed."""

    def change(t: LineType) -> LineType:
        return dataclasses.replace(t, **changed) if t.name == name else t

    return dataclasses.replace(model, line_types=tuple(map(change, model.line_types)))


def of_the_mooring() -> Iterator[tuple[str, Callable[[], Model], Motion]]:
    """Yield what was chosen of mooring, water and platform, and what else it could be."""
    waves = in_waves(DURATION)
    base = semi_taut()
    yield "as chosen", semi_taut, waves
    yield "EA of the rope 55 MN instead of 110", lambda: with_type(base, "polyester", axial_stiffness=0.55e8), waves
    yield "EA of the rope 220 MN", lambda: with_type(base, "polyester", axial_stiffness=2.2e8), waves
    yield "chain 5 % heavier", lambda: with_type(base, "chain", mass_per_length=1.05 * CHAIN.mass_per_length), waves
    yield "EA of the chain halved", lambda: with_type(base, "chain", axial_stiffness=0.5 * CHAIN.axial_stiffness), waves
    yield "axial damping 0.1 of critical instead of 1", lambda: with_types(base, axial_damping_ratio=0.1), waves
    yield "Ca of the chain 1.0 instead of 0.8", lambda: with_type(base, "chain", transverse_added_mass=1.0), waves
    yield "Cd of the chain 2.4 instead of 2.0", lambda: with_type(base, "chain", transverse_drag=2.4), waves
    yield (
        "seabed 0.3 MPa/m instead of 3",
        lambda: with_environment(base, seabed_stiffness=3e5, seabed_damping=1e4),
        waves,
    )
    yield "seabed 30 MPa/m", lambda: with_environment(base, seabed_stiffness=3e7), waves
    yield "seabed 0.01 MPa s/m instead of 0.1", lambda: with_environment(base, seabed_damping=1e4), waves
    yield "twice the segments", lambda: semi_taut(refine=2), waves
    yield "fairleads 10 m higher, at -4 m", raised, waves
    yield "waves act on the lines too", lambda: with_environment(base, waves=sea()), waves
    yield "responses 20 % larger", semi_taut, scaled(waves, 1.2)
    yield "without roll", semi_taut, without_roll(waves)


def raised() -> Model:
    """Return the mooring with its fairleads 10 m higher."""
    model = semi_taut()
    points = tuple(
        dataclasses.replace(p, position=(*p.position[:2], p.position[2] + 10.0)) if p.kind == "coupled" else p
        for p in model.points
    )
    return dataclasses.replace(model, points=points)


def sea() -> Waves:
    """Return the regular waves that move the platform."""
    return Waves.regular(HEIGHT, PERIOD, depth=850.0, direction=0.5 * np.pi, ramp=30.0)


def scaled(motion: Motion, factor: float) -> Motion:
    """Return a platform motion times a factor."""
    return Motion.from_platform(motion.time, factor * motion.platform)


def without_roll(motion: Motion) -> Motion:
    """Return a platform motion that does not roll."""
    moved = motion.platform.copy()
    moved[:, 3] = 0.0
    return Motion.from_platform(motion.time, moved)


def of_friction() -> Iterator[tuple[str, object, dict]]:
    """Yield what was chosen of friction, and what else it could be."""
    yield "no friction", None, {}
    yield "saturated damping, c_v 1e6", DAMPED, {}
    yield "c_v 1e4", dataclasses.replace(DAMPED, damping=1e4), {}
    yield "c_v 1e5", dataclasses.replace(DAMPED, damping=1e5), {}
    yield "c_v 1e7", dataclasses.replace(DAMPED, damping=1e7), {}
    yield "static = kinetic", dataclasses.replace(DAMPED, static_ratio=1.0), {}
    yield "twice the segments", DAMPED, {"refine": 2}
    yield "sticking, as laid", STICKING, {}
    static = {"axial": STATIC * STICKING.axial, "transverse": STATIC * STICKING.transverse}
    yield "with the static coefficients, 0.92 and 1.33", dataclasses.replace(STICKING, **static), {}
    yield "its spring ten times as stiff", dataclasses.replace(STICKING, shear_stiffness=3e7), {}
    yield "its spring ten times as soft", dataclasses.replace(STICKING, shear_stiffness=3e5), {}
    yield "twice the segments, sticking", STICKING, {"refine": 2}


def open_values(effort: Effort) -> Part:
    """Return both tables."""
    mooring, rows = {}, []
    some = 3 if effort.quick else None
    for what, model, motion in islice(of_the_mooring(), some):
        ds, _ = ours(model(), motion, DURATION)
        tension = fairlead(ds)[ds["time"].values >= STARTED]
        found = {"mean": tension.mean(), "std": tension.std(), "min": tension.min(), "max": tension.max()}
        mooring[what] = {key: float(value) for key, value in found.items()}
        rows.append((what, *(f"{value:.1f}" for value in found.values())))
    words = {"mooring_open": table(("changed", "mean, kN", "std", "lowest", "highest"), rows)}
    friction, rows = {}, []
    wind, waves = {1.0: in_wind(semi_taut(), WIND), 0.5: in_wind(semi_taut(), WIND, 0.5 * THRUST)}, in_waves(DURATION)
    for what, law, of_model in islice(of_friction(), some):
        model = semi_taut(friction=law, **of_model)
        found = {f"wind {share:g}": late_mean(model, motion) for share, motion in wind.items()}
        refine = of_model.get("refine", 1)
        ds, _ = ours(model, waves, DURATION)
        late = node_time(ds) >= STARTED
        nodes = node_tension(ds, [refine * n for n in GROUNDED])[late].mean(axis=0)
        found["waves std"] = float(fairlead(ds)[ds["time"].values >= STARTED].std())
        friction[what] = found | {f"node {n}": float(v) for n, v in zip(GROUNDED, nodes, strict=True)}
        rows.append((what, *(f"{value:.1f}" for value in friction[what].values())))
    header = ("friction", "wind, mean, kN", "half of the thrust", "waves, std", *(f"node {n}" for n in GROUNDED))
    words["friction_open"] = table(header, rows)
    words["half_sway"] = f"{wind[0.5].platform[-1, 1]:.0f}"
    return Part({"mooring_open": mooring, "friction_open": friction}, words, {})


def late_mean(model: Model, motion: Motion) -> float:
    """Return line 1's mean tension at the end of a run in wind, kN."""
    ds, _ = ours(model, motion, WIND, 0.5, dt_nodes=5.0)
    return float(fairlead(ds)[ds["time"].values >= WIND_STARTED].mean())
