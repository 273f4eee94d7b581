"""Compiling before it is waited for: a small model that takes every way through the kernels."""

from __future__ import annotations

import time
import warnings
from dataclasses import replace

import numpy as np

from moorage._jit import mark_warm
from moorage.about_rest import natural_modes, stiffness
from moorage.errors import ModelWarning
from moorage.model import (
    Attachment,
    Body,
    Environment,
    Friction,
    Line,
    LineType,
    Model,
    Motion,
    OutputChannel,
    Point,
    Section,
)
from moorage.run import simulate, solve_statics
from moorage.simulation import Simulation
from moorage.solve.parts import node_force_part
from moorage.solve.statics import take_every_way
from moorage.system.build import build


def warmup() -> float:
    """Compile all kernels, so that the next process starts at once; return the wall time, s."""
    begin, model = time.perf_counter(), buoy_and_chain()
    motion = Motion.from_harmonics(1.0, ramp=0.5, surge=(0.1, 1.0))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelWarning)
        solve_statics(model)
        solve_statics(replace(model, points=model.points[:3], lines=model.lines[:1], bodies=()))
        built = build(model)
        take_every_way(built)
        for part in ("weight", "bending"):
            node_force_part(built, part)
        for method in ("implicit", "rk2", "rk4"):
            simulate(model, motion=motion, duration=0.01, dt_out=0.01, time_step=1e-4, method=method)  # type: ignore[arg-type]
        simulation = Simulation(model)
        simulation.initialize()
        simulation.step(0.1, simulation.position, np.zeros_like(simulation.position))
        natural_modes(model, 1)
        stiffness(model)
    mark_warm()
    return time.perf_counter() - begin


def buoy_and_chain() -> Model:
    """Return a chain on a rough seabed, and a buoy that a cable holds down."""
    chain = LineType(name="chain", diameter=0.05, mass_per_length=50.0, axial_stiffness=1e8)
    cable = replace(chain, name="cable", bending_stiffness=100.0)

    def line(id: int, kind: str, ends: tuple[int, int], length: float) -> Line:
        a, b = (Attachment("point", end) for end in ends)
        return Line(id=id, end_a=a, end_b=b, sections=(Section(line_type=kind, length=length, segments=3),))

    return Model(
        environment=Environment(water_depth=50.0, friction=Friction(axial=0.5, transverse=0.7)),
        line_types=(chain, cable),
        points=(
            Point(id=1, kind="fixed", position=(0.0, 0.0, -50.0)),
            Point(id=2, kind="coupled", position=(30.0, 0.0, 0.0)),
            Point(id=3, kind="fixed", position=(0.0, 90.0, -50.0)),
            Point(id=4, kind="fixed", position=(0.0, 0.0, -1.0), body=1),
        ),
        lines=(line(1, "chain", (1, 2), 60.0), line(2, "cable", (3, 4), 20.0)),
        bodies=(Body(id=1, kind="free", position=(0.0, 90.0, -29.0), mass=500.0, inertia=(500.0,) * 3, volume=3.0),),
        outputs=(OutputChannel(name="LINE1N1TEN"), OutputChannel(name="POINT2FX")),
    )
