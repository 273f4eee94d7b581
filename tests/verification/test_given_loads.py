"""External loads on a body in empty space: accelerations F / m, decay exp(-c t / m), moments r x F.

Verifies: rigid

A body of 1000 kg without weight or water is turned by 90 degrees about z: its own x axis is the global y axis. Its way in
2 s must be within 1e-4 m, ten times the tolerance of a step, for steps follow a constant acceleration exactly.
"""

import numpy as np
import pytest
from common import must_fail
from scipy.integrate import solve_ivp

import moorage
from moorage.model import Body, Environment, ExternalLoad, Model, Rod, RodType

SPACE = Environment(water_depth=100.0, water_density=1e-9, gravity=0.0)
ROD = RodType(name="rod", diameter=0.1, mass_per_length=1e-6)
MASS, TURN = 1000.0, 2000.0  # kg, kg m2
SECONDS = 2.0


def load(id: int, target: str = "body", **values) -> ExternalLoad:
    return ExternalLoad(id=id, target=target, target_id=1, **values)  # type: ignore[arg-type]


def moved(*loads: ExternalLoad, segments: int = 2, kind: str = "fixed"):
    """Way (3,), m, and angles (3,), rad, of the body at the end."""
    body = Body(id=1, kind="free", position=(0.0, 0.0, -20.0), rotation=(0.0, 0.0, np.pi / 2.0), mass=MASS,
                inertia=(TURN, TURN, TURN))  # fmt: skip
    rod = Rod(id=1, kind=kind, body=1, rod_type="rod", end_a=(0.5, 0.0, 0.0), end_b=(1.5, 0.0, 0.0), segments=segments)
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


def test_taking_all_loads_in_the_axes_of_one_fails():
    way, _ = moved(load(1, force=(500.0, 0.0, 0.0)), load(2, force=(500.0, 0.0, 100.0), local=True))
    must_fail(check, way, [1000.0, 0.0, 100.0])
    must_fail(check, way, [0.0, 1000.0, 100.0])


@pytest.mark.parametrize("order", [1, -1])
def test_dampers_in_both_axes_add_up(order):
    """x: m v' = F - c v with c of both; y: with that of the body's own x axis alone."""
    dampers = (load(1, linear_damping=(100.0, 0.0, 0.0)), load(2, linear_damping=(300.0, 200.0, 0.0), local=True))
    way, _ = moved(*dampers[::order], load(3, force=(500.0, 500.0, 0.0)))
    rate = np.array([300.0, 300.0]) / MASS  # 100 and 200 N s/m along x, 300 along y
    x = 500.0 / MASS / rate * (SECONDS - (1.0 - np.exp(-rate * SECONDS)) / rate)
    np.testing.assert_allclose(way, [*x, 0.0], atol=1e-4)


@pytest.mark.parametrize(("segments", "kind"), [(0, "fixed"), (2, "fixed"), (0, "pinned")])
def test_a_load_on_a_rod_moves_the_body_that_carries_it(segments, kind):
    """At end A, 0.5 m out along the global y axis: it moves along z by F, and rolls by F r / J about the global x axis."""
    way, angles = moved(load(1, "rod", force=(0.0, 0.0, 20.0)), segments=segments, kind=kind)
    check(way, [0.0, 0.0, 20.0])
    roll = 0.5 * 20.0 * 0.5 / TURN * SECONDS**2
    np.testing.assert_allclose(angles, [roll, 0.0, np.pi / 2.0], atol=1e-3 * roll)


@pytest.mark.parametrize("segments", [0, 2])
@pytest.mark.parametrize("kind", ["fixed", "pinned"])
@pytest.mark.parametrize(("target", "pitch"), [("rod", -10.0), ("body", 0.0)])
def test_a_load_on_a_rod_is_felt_by_the_host_of_its_body(segments, kind, target, pitch):
    body = Body(id=1, kind="coupled", position=(0.0, 0.0, -20.0), mass=MASS, inertia=(TURN,) * 3)
    rod = Rod(id=1, kind=kind, body=1, rod_type="rod", end_a=(0.5, 0, 0), end_b=(1.5, 0, 0), segments=segments)
    pull = load(1, target, force=(0.0, 0.0, 20.0))
    model = Model(environment=SPACE, rod_types=(ROD,), rods=(rod,), bodies=(body,), external_loads=(pull,))
    force = moorage.Simulation(model).initialize()
    np.testing.assert_allclose(force, [0.0, 0.0, 20.0, 0.0, pitch, 0.0], atol=1e-3)


@pytest.mark.parametrize("segments", [0, 2])
@pytest.mark.parametrize("kind", ["coupled", "coupled-pinned"])
def test_a_load_on_a_coupled_rod_is_felt_by_its_host(segments, kind):
    """F - c v - C v |v| for each axis, at rest and at a constant 2 m/s."""
    rod = Rod(id=1, kind=kind, rod_type="rod", end_a=(0, 0, -20.0), end_b=(1.0, 0, -20.0), segments=segments)
    damped = load(1, "rod", force=(0.0, 0.0, 20.0), linear_damping=(3.0,) * 3, quadratic_damping=(5.0,) * 3)
    model = Model(environment=SPACE, rod_types=(ROD,), rods=(rod,), external_loads=(damped,))
    sim = moorage.Simulation(model)
    np.testing.assert_allclose(sim.initialize()[:3], [0.0, 0.0, 20.0], atol=1e-3)
    rate = np.zeros(len(sim.position))
    rate[1] = 2.0
    begun = sim.initialize(velocity=rate)
    np.testing.assert_allclose(begun[:3], [0.0, -(3.0 * 2.0 + 5.0 * 4.0), 20.0], atol=1e-3)


LONG = RodType(name="long", diameter=0.1, mass_per_length=100.0)
ACROSS, ALONG, PULL, LENGTH = 300.0, 60.0, 400.0, 4.0  # N s/m, N s/m, N, m


def damped_rod(segments: int, quadratic: float = 0.0):
    """End A and end B (2, 3), m, of a free rod that is pulled up at end A, and damped along and across itself."""
    rod = Rod(
        id=1, kind="free", rod_type="long", end_a=(0.0, 0.0, -20.0), end_b=(LENGTH, 0.0, -20.0), segments=segments
    )
    damper = {"linear_damping": (ACROSS, ALONG), "quadratic_damping": (quadratic, 0.0), "local": True}
    loads = (load(1, "rod", force=(0.0, 0.0, PULL)), load(2, "rod", **damper))
    model = Model(environment=SPACE, rod_types=(LONG,), rods=(rod,), external_loads=loads)
    return moorage.simulate(model, duration=3.0, start="as-given", tolerance=1e-5)["rod_position"].values[-1, 0]


def planar_rod(segments: int, quadratic: float = 0.0, at_end: bool = False) -> np.ndarray:
    """The same from the equations of a rigid rod in a plane, its damping on its nodes, or all at end A."""
    share = np.array([1.0, *np.zeros(segments)]) if at_end else np.array([0.5, *np.ones(segments - 1), 0.5]) / segments
    places, m = LENGTH * (np.arange(segments + 1) / segments - 0.5), 100.0 * LENGTH
    J = m * (LENGTH**2 / 12.0 + 0.1**2 / 16.0)

    def rates(_, y):
        along, across = (np.array([np.cos(y[2]), np.sin(y[2])]), np.array([-np.sin(y[2]), np.cos(y[2])]))
        speed = y[3:5] @ across + y[5] * places
        push = -share * (ACROSS + quadratic * abs(speed)) * speed
        force = push.sum() * across - ALONG * (y[3:5] @ along) * along + [0.0, PULL]
        turn = push @ places - 0.5 * LENGTH * (PULL * np.cos(y[2]))
        return [*y[3:], *(force / m), turn / J]

    x, z, angle = solve_ivp(rates, (0.0, 3.0), [0.5 * LENGTH, -20.0, 0, 0, 0, 0], rtol=1e-10, atol=1e-10).y[:3, -1]
    arm = 0.5 * LENGTH * np.array([np.cos(angle), 0.0, np.sin(angle)])
    middle = np.array([x, 0.0, z])
    return np.stack([middle - arm, middle + arm])


@pytest.mark.parametrize(("segments", "quadratic"), [(2, 0.0), (8, 0.0), (8, 200.0)])
def test_damping_of_a_rod_is_shared_out_along_it(segments, quadratic):
    """As in MoorDyn-F. It turns by 97 to 117 degrees; with all of it at end A the ends are more than a metre off."""
    found = damped_rod(segments, quadratic)
    np.testing.assert_allclose(found, planar_rod(segments, quadratic), atol=5e-4)  # measured: 1.2e-4
    assert np.abs(found - planar_rod(segments, quadratic, at_end=True)).max() > 1.0
