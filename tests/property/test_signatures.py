"""One compiled version of every main kernel serves all models: another one would cost half a minute, unannounced."""

from __future__ import annotations

import numpy as np
import pytest
from floats import AIR, body, floating, rod
from moorings import CHAIN, coupled, curve, fixed, free, held, kind, line, mooring, run, single, spread

from moorage.model import (
    Bathymetry,
    Current,
    CurrentGrid,
    Friction,
    FrictionMap,
    Model,
    Motion,
    Point,
    Soil,
    StiffnessMap,
)
from moorage.solve.host import HostMarch
from moorage.solve.march_kernel import march_islands, start_islands
from moorage.solve.statics import solve
from moorage.solve.statics_kernel import relax_island
from moorage.solve.stiffness import condense_island, point_stiffness
from moorage.system.build import Built, build


def models() -> dict[str, tuple[Model, Motion | None]]:
    table = curve((0.0, 0.0), (0.05, 1e5), (0.1, 5e5))
    a, b = fixed(1, 0.0, 0.0, -20.0), coupled(2, 30.0, 0.0, -5.0)
    float_ = free(3, 10.0, 0.0, -10.0, mass=10.0, volume=0.1)
    buoy = free(3, 10.0, 0.0, -10.0, mass=10.0, volume=0.3)
    moved = Motion.from_harmonics(5.0, ramp=2.0, heave=(0.1, 3.0))
    bent = kind("rope", bending_stiffness=1e4)
    light = kind("rope", mass_per_length=8.0, bending_stiffness=1e3)
    sheared = Current((-20.0, -10.0, 0.0), ((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.5, 0.1, 0.0)))
    flow = CurrentGrid(t=(0.0, 5.0), x=(-9.0, 99.0), velocity=np.full((2, 2, 1, 1, 3), 0.2))
    x, rows = (0.0, 10.0), ((0.2, 0.3), (0.4, 0.5))
    mapped: dict = {
        "friction": Friction(map=FrictionMap(x, x, rows, rows)),
        "bathymetry": Bathymetry(x, x, ((20.0, 21.0), (22.0, 23.0))),
        "seabed_stiffness_map": StiffnessMap(x, x, ((1e6, 2e6), (3e6, 3e6))),
    }
    soil = Friction(model="soil-curves", axial_curve=table, transverse_curve=table)
    bridle = (line(1, 1, 3, ("rope", 15.0, 3)), line(2, 3, 2, ("rope", 22.0, 4)))
    hull = body(position=(10.0, 0.0, -10.0), volume=0.3)
    eye = Point(id=4, kind="fixed", position=(0.5, 0.0, 0.0), body=1)
    stick, pole = (
        rod(1, "free", (0.0, 0.0, -15.0), (0.2, 0.0, -13.0)),
        rod(1, "coupled-pinned", (0, 0, -9), (2, 0, -9)),
    )
    return {
        "three chains, moved": (spread(10), Motion.from_harmonics(5.0, ramp=2.0, surge=(1.0, 8.0))),
        "one segment": (single(CHAIN, 34.0, 1, a, b), None),
        "nothing is free, all is fixed": (single(CHAIN, 34.0, 5, a, fixed(2, 30.0, 0.0, -5.0)), None),
        "tables": (single(kind(axial_stiffness=table, axial_damping=table), 32.0, 4, a, b), moved),
        "free points, no tables": (mooring(kind(), (a, b, float_), bridle), moved),
        "a point without lines": (mooring(kind(), (a, b, float_), (line(1, 1, 2, ("rope", 32.0, 3)),)), None),
        "sheared current": (single(kind(transverse_drag=1.0), 34.0, 5, a, b, current=sheared), moved),
        "current over time and place": (single(kind(transverse_drag=1.0), 34.0, 5, a, b, current=flow), moved),
        "bending": (single(bent, 34.0, 9, a, b), None),
        "two segments, bent, held by a free point": (mooring(bent, (a, buoy), (line(1, 3, 1, ("rope", 12.0, 2)),)), None),
        "maps": (single(CHAIN, 34.0, 5, a, b, water_depth=20.0, **mapped), moved),
        "soil curves": (single(CHAIN, 34.0, 5, a, b, water_depth=20.0, friction=soil), moved),
        "soil with a memory": (single(CHAIN, 34.0, 5, a, b, water_depth=20.0, soil=Soil(shear_strength=3000)), moved),
        "a body alone, in air": (floating((body(kind="pinned"),), environment=AIR), None),
        "a rod alone": (floating(rods=(pole,)), moved),
        "a free body": (floating((hull,), line_types=kind(), points=(a, eye), lines=(line(1, 1, 4, ("rope", 20.0, 3)),)), None),
        "a free rod, bent lines": (floating(rods=(stick,), line_types=light, points=(a,),
                                            lines=(line(1, 1, held(stick, "A"), ("rope", 5.0, 3)),)), None),
        "a coupled-pinned rod": (floating(rods=(pole,), line_types=kind(), points=(fixed(1, 0.0, 0.0, -20.0),),
                                          lines=(line(1, 1, held(pole, "B"), ("rope", 20.0, 3)),)), moved),
        "no water, no weight": (single(kind(), 30.0, 3, a, b, water_density=0.0, gravity=0.0), moved),
    }  # fmt: skip


def shapes(built: Built) -> set:
    """What the compiler sees of a system: the types of all its leaves."""
    leaves = []

    def walk(value):
        if isinstance(value, tuple):
            for part in value:
                walk(part)
        elif isinstance(value, np.ndarray):
            leaves.append((value.dtype.str, value.ndim, value.flags.c_contiguous, value.flags.writeable))
        else:
            leaves.append(type(value).__name__)

    walk(built.system)
    walk(built.state)
    walk(built.work)
    return set(enumerate(leaves))


@pytest.mark.parametrize("name", models())
def test_every_model_looks_the_same_to_the_compiler(name):
    reference = shapes(build(*models()["three chains, moved"]))
    assert shapes(build(*models()[name])) == reference


def test_main_kernels_are_compiled_once():
    """All models are solved, run by every method and condensed; then each kernel has one signature."""
    for model, motion in models().values():
        built = build(model, motion)
        watch = ((0, 1),) if model.lines else ()
        solve(built)
        point_stiffness(built)
        for settings in ({}, {"time_step": 0.01}, {"method": "rk4", "time_step": 1e-5}):
            run(built, 0.02, dt_out=0.01, dt_nodes=0.02, watch=watch, **settings)
        host = HostMarch(built)
        host.initialize()
        host.step(0.02, host.position, host.velocity)
    for kernel in (march_islands, start_islands, relax_island, condense_island):
        assert len(kernel.signatures) == 1, f"{kernel.__name__}: {kernel.signatures}"


def test_an_integer_would_be_noticed():
    """The comparison sees a float parameter that became an int."""
    built = build(*models()["one segment"])
    wrong = built._replace(
        system=built.system._replace(points=built.system.points._replace(mass=built.system.points.mass.astype(int)))
    )
    assert shapes(wrong) != shapes(built)
