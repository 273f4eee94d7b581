"""External loads on a body in empty space: accelerations F / m, decay exp(-c t / m), moments r x F.

A body of 1000 kg without weight or water is turned by 90 degrees about z: its own x axis is the global y axis. Way
within 1e-4 m: ten times the tolerance of a step, for steps follow a constant acceleration exactly.
"""

import numpy as np
import pytest
from common import must_fail

import moorage
from moorage.model import Body, Environment, ExternalLoad, Model, Rod, RodType

SPACE = Environment(water_depth=100.0, water_density=1e-9, gravity=0.0)
ROD = RodType(name="rod", diameter=0.1, mass_per_length=1e-6)
MASS, TURN = 1000.0, 2000.0  # kg, kg m2
SECONDS = 2.0


def load(id: int, target: str = "body", **values) -> ExternalLoad:
    return ExternalLoad(id=id, target=target, target_id=1, **values)  # type: ignore[arg-type]


def moved(*loads: ExternalLoad, segments: int = 2):
    """Way (3,), m, and angles (3,), rad, of the body at the end."""
    body = Body(id=1, kind="free", position=(0.0, 0.0, -20.0), rotation=(0.0, 0.0, np.pi / 2.0), mass=MASS,
                inertia=(TURN, TURN, TURN))  # fmt: skip
    rod = Rod(
        id=1, kind="fixed", body=1, rod_type="rod", end_a=(0.5, 0.0, 0.0), end_b=(1.5, 0.0, 0.0), segments=segments
    )
    model = Model(environment=SPACE, rod_types=(ROD,), rods=(rod,), bodies=(body,), external_loads=loads)
    run = moorage.simulate(model, duration=SECONDS, start="as-given", tolerance=1e-5)
    assert np.allclose(run["body_position"].values[0, 0], body.position)
    return run["body_position"].values[-1, 0] - run["body_position"].values[0, 0], run["body_rotation"].values[-1, 0]


def check(way, force):
    np.testing.assert_allclose(way, np.multiply(0.5 * SECONDS**2 / MASS, force), atol=1e-4)


@pytest.mark.parametrize("order", [1, -1])
def test_loads_in_both_axes_add_up(order):
    loads = (load(1, force=(500.0, 0.0, 0.0)), load(2, force=(500.0, 0.0, 100.0), local=True))[::order]
    way, angles = moved(*loads)
    check(way, [500.0, 500.0, 100.0])
    np.testing.assert_allclose(angles, [0.0, 0.0, np.pi / 2.0], atol=1e-9)
    must_fail(check, way, [1000.0, 0.0, 100.0])  # all in global axes
    must_fail(check, way, [0.0, 1000.0, 100.0])  # all in its own


@pytest.mark.parametrize("order", [1, -1])
def test_dampers_in_both_axes_add_up(order):
    """x: m v' = F - c v with c of both; y: with that of the body's own x axis alone."""
    dampers = (load(1, linear_damping=(100.0, 0.0, 0.0)), load(2, linear_damping=(300.0, 200.0, 0.0), local=True))
    way, _ = moved(*dampers[::order], load(3, force=(500.0, 500.0, 0.0)))
    rate = np.array([300.0, 300.0]) / MASS  # 100 and 200 N s/m along x, 300 along y
    x = 500.0 / MASS / rate * (SECONDS - (1.0 - np.exp(-rate * SECONDS)) / rate)
    np.testing.assert_allclose(way, [*x, 0.0], atol=1e-4)


@pytest.mark.parametrize("segments", [0, 2])
def test_a_load_on_a_rod_moves_the_body_that_carries_it(segments):
    """At end A, 0.5 m out along the global y axis: it moves along z by F, and rolls by F r / J about the global x axis."""
    way, angles = moved(load(1, "rod", force=(0.0, 0.0, 20.0)), segments=segments)
    check(way, [0.0, 0.0, 20.0])
    roll = 0.5 * 20.0 * 0.5 / TURN * SECONDS**2
    np.testing.assert_allclose(angles, [roll, 0.0, np.pi / 2.0], atol=1e-3 * roll)


def test_a_load_on_a_rod_is_felt_by_the_host_of_its_body():
    for target, pitch in (("rod", -10.0), ("body", 0.0)):
        body = Body(id=1, kind="coupled", position=(0.0, 0.0, -20.0), mass=MASS, inertia=(TURN,) * 3)
        rod = Rod(id=1, kind="fixed", body=1, rod_type="rod", end_a=(0.5, 0, 0), end_b=(1.5, 0, 0), segments=2)
        pull = load(1, target, force=(0.0, 0.0, 20.0))
        model = Model(environment=SPACE, rod_types=(ROD,), rods=(rod,), bodies=(body,), external_loads=(pull,))
        force = moorage.Simulation(model).initialize()
        np.testing.assert_allclose(force, [0.0, 0.0, 20.0, 0.0, pitch, 0.0], atol=1e-3)
