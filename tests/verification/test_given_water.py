"""Water given from outside: by a function that `simulate` calls, and by a host at the nodes of a `Simulation`.

Verifies: sea

A sea that is also the model's own is sampled by a function. Between the samples it is linear, so that velocities of
the water are off by (w D)^2 / 8 of each component, and those of the nodes by no more: with w at most 2.2 rad/s and
mostly 0.63, an interval D = 0.1 s gives 5e-4 to 6e-3. Errors must fall with D^2. A host that sets the same values over
each coupling step must get the forces of the function to what its guess of the nodes' places differs. Water that varies
in space finds coupled bodies and rods where their motion has taken them, and pushes them.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail, rate, rms
from floats import WATER, body, floating, rod
from moorings import coupled, fixed, kind, single

import moorage
from moorage.errors import InputError, SimulationError, UnsupportedError
from moorage.model import Current, OutputChannel, RodType, Waves

SEA = Waves.irregular("jonswap", 3.0, 10.0, depth=60.0, components=60, ramp=5.0, seed=4)
ROPE = kind(
    diameter=0.15, mass_per_length=35.0, transverse_drag=1.2, transverse_added_mass=1.0, axial_damping_ratio=0.5
)
DURATION = 15.0


def model(**environment):
    ends = fixed(1, -40.0, 0.0, -60.0), coupled(2, 0.0, 0.0, -4.0)
    flow = Current((0.0,), ((0.3, 0.1, 0.0),))
    made = single(ROPE, 78.0, 12, *ends, water_depth=60.0, current=flow, **environment)
    return dataclasses.replace(made, outputs=(OutputChannel(name="POINT2FX"),))


def own():
    return moorage.simulate(model(waves=dataclasses.replace(SEA, exact=True)), duration=DURATION, time_step=0.02)


def by_function(interval, sea=SEA, **settings):
    return moorage.simulate(
        model(), duration=DURATION, time_step=0.02, water=sea.kinematics, water_interval=interval, **settings
    )


@pytest.fixture(scope="module")
def truth():
    return own()


def error(truth, interval, sea=SEA) -> float:
    found = by_function(interval, sea)
    return rms(found["node_velocity"] - truth["node_velocity"]) / rms(truth["node_velocity"])


def check(truth, sea=SEA) -> None:
    assert error(truth, 0.1, sea) < 6e-3


def test_function(truth):
    check(truth)


def test_another_sea_fails(truth):
    must_fail(check, truth, dataclasses.replace(SEA, phase=tuple(p + 0.1 for p in SEA.phase)))


def test_error_falls_with_the_square_of_the_interval(truth):
    intervals = (0.4, 0.2, 0.1)
    assert 1.7 < rate(intervals, [error(truth, interval) for interval in intervals]) < 2.3


def test_results_hold_its_elevation_and_name(truth):
    found = by_function(0.1)
    assert found["wave_elevation"].values == pytest.approx(truth["wave_elevation"].values, abs=1e-12)
    assert found.attrs["water"] == "Waves.kinematics"
    assert found.attrs["water_interval"] == 0.1


def test_channels_of_points_feel_it(truth):
    found = by_function(0.1)
    assert rms(found["POINT2FX"] - truth["POINT2FX"]) < 2e-3 * rms(truth["POINT2FX"])


def test_a_run_that_is_resumed_is_the_same(tmp_path):
    """Stopped by Ctrl-C after a block; the function is called again for nothing but what is to come."""
    whole = by_function(0.1)

    def stop(time, duration, wall):
        if time > 3.0:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        by_function(0.1, output=tmp_path / "run.nc", progress=stop)
    resumed = by_function(0.1, output=tmp_path / "run.nc", resume=True)
    assert np.array_equal(resumed["node_position"].values, whole["node_position"].values)


def test_host(truth):
    """Nodes are guessed by their last two places; times of 0.1 s as the function."""
    sim = moorage.Simulation(model(), host_waves=True, time_step=0.02)
    forces = [sim.initialize()[0]]
    nodes, place, still = sim.water_nodes(), sim.position, np.zeros_like(sim.position)
    before = nodes
    sim.set_water(*SEA.kinematics(0.0, nodes)[:3])
    for k in range(1, round(DURATION / 0.1) + 1):
        nodes = sim.water_nodes()
        water = SEA.kinematics(0.1 * k, 2.0 * nodes - before)
        before = nodes
        sim.set_water(water.elevation, water.velocity, water.acceleration, time=0.1 * k)
        forces.append(sim.step(0.1 * k, place, still)[0])
    expected = truth["point_force"].sel(point=2).values
    assert rms(np.array(forces) - expected) < 2e-3 * rms(expected - expected.mean(axis=0))


def test_water_stays_until_it_is_set_again():
    """Held water is a current: the mooring settles where a model with that current has its equilibrium."""
    still = moorage.solve_statics(dataclasses.replace(model(), environment=model().environment))
    plain = single(ROPE, 78.0, 12, fixed(1, -40.0, 0.0, -60.0), coupled(2, 0.0, 0.0, -4.0), water_depth=60.0)
    sim = moorage.Simulation(plain, host_waves=True)
    place = sim.position
    sim.initialize()
    n = len(sim.water_nodes())
    sim.set_water(None, np.tile([0.3, 0.1, 0.0], (n, 1)))
    saved = sim.save()
    forces = sim.step(150.0, place, 0.0 * place)
    assert forces[0] == pytest.approx(still["point_force"].sel(point=2).values[:], rel=1e-4, abs=0.2)
    sim.set_water(None, np.zeros((n, 3)))
    sim.restore(saved)  # with the water of that time
    assert sim.step(150.0, place, 0.0 * place) == pytest.approx(forces, rel=1e-12)


def test_nodes_are_those_of_lines_then_points():
    sim = moorage.Simulation(model(), host_waves=True)
    start = np.array([[1.0, 2.0, -3.0]])
    sim.initialize(start)
    nodes = sim.water_nodes()
    assert len(nodes) == 13 + 2
    assert nodes[0] == pytest.approx([-40.0, 0.0, -60.0])
    assert nodes[12] == pytest.approx(start[0])
    assert nodes[13:] == pytest.approx(np.array([[-40.0, 0.0, -60.0], start[0]]))


def test_what_does_not_fit_is_refused():
    waves = model(waves=SEA)
    with pytest.raises(InputError, match=r"the model has waves of its own, and water is given\n    -> remove them"):
        moorage.simulate(waves, duration=1.0, water=SEA.kinematics)
    with pytest.raises(UnsupportedError, match="the model has waves of its own"):
        moorage.Simulation(waves, host_waves=True)
    with pytest.raises(InputError, match="the model has its waves from a host, and there is none"):
        moorage.simulate(model(host_waves=True), duration=1.0)
    with pytest.raises(InputError, match=r"water_interval must be a positive number \(read: 0\)"):
        moorage.simulate(model(), duration=1.0, water=SEA.kinematics, water_interval=0)
    with pytest.raises(
        SimulationError, match=r"velocity of the water: expected 15 x 3 finite numbers, got .* \(15, 2\)"
    ):
        moorage.simulate(model(), duration=1.0, water=lambda t, r: (None, r[:, :2], None))
    sim = moorage.Simulation(model())
    with pytest.raises(UnsupportedError, match=r"takes no water from its host\n    -> make it with host_waves=True"):
        sim.set_water(None, np.zeros((15, 3)))
    sim = moorage.Simulation(model(host_waves=True))
    with pytest.raises(SimulationError, match="before initialize"):
        sim.set_water(None, np.zeros((15, 3)))
    sim.initialize()
    with pytest.raises(SimulationError, match="elevation of the water: expected 15 finite numbers"):
        sim.set_water(np.full(15, np.nan), np.zeros((15, 3)))
    with pytest.raises(SimulationError, match=r"set_water\(\) at -1.0 s, but the run is at 0 s"):
        sim.set_water(None, np.zeros((15, 3)), time=-1.0)


def swept(t: float, r) -> tuple:
    """Still water with an elevation, whose velocity grows with x: it tells where it was asked for."""
    flow = np.zeros_like(r)
    flow[:, 0], flow[:, 1] = 0.2 * r[:, 0], 0.5
    return np.full(len(r), 0.3), flow, np.zeros_like(r)


def platform(**environment) -> moorage.Model:
    """A coupled body with drag that carries a rod through the surface and an inclined one, and a line."""
    kind = RodType(name="spar", diameter=0.5, mass_per_length=100.0, transverse_drag=1.0, end_drag=0.5)
    bodies = [body(kind="coupled", position=(2.0, 0.0, -8.0), drag_area=(3.0, 3.0, 3.0, 0.0, 0.0, 0.0), volume=0.1)]
    rods = [
        rod(1, "fixed", (0, 0, 4), (0, 0, 10), 6, body=1),
        rod(2, "fixed", (1, 0, -1), (3, 1, -4), 3, body=1, outputs="pUD"),
    ]
    names = ("BODY1FX", "BODY1FY", "ROD1SUB", "ROD2N3FX", "ROD2FY")
    made = floating(bodies, rods, kind, environment=WATER | environment)
    return dataclasses.replace(made, outputs=tuple(OutputChannel(name=name) for name in names))


def check_platform(x: float = 5.0) -> None:
    """At x = 5 m, where a motion has taken it; held there from the start in the same water as a current is the truth."""
    t, path = np.linspace(0.0, 4.0, 201), np.zeros((201, 6))
    path[:, 0] = 1.5 * (1.0 - np.cos(0.5 * np.pi * np.minimum(t, 2.0)))
    there = moorage.Motion.from_platform(t, path)
    found = moorage.simulate(platform(), duration=4.0, motion=there, water=swept, time_step=0.05).isel(time=-1)
    moved = dataclasses.replace(platform(), bodies=(dataclasses.replace(platform().bodies[0], position=(x, 0, -8.0)),))
    held = moorage.simulate(moved, duration=0.1, water=swept, time_step=0.05).isel(time=-1)
    for name in ("BODY1FX", "BODY1FY", "ROD1SUB", "ROD2N3FX", "ROD2FY"):
        assert float(found[name]) == pytest.approx(float(held[name]), rel=1e-9, abs=1e-6), name
    drag = 0.5 * 1025.0 * 3.0 * np.hypot(0.2 * x, 0.5) * 0.2 * x  # of the body by itself
    assert float(held["BODY1FX"]) > drag
    assert float(held["ROD1SUB"]) == pytest.approx((4.0 + 0.3) / 6.0)


def test_water_reaches_what_a_motion_holds():
    check_platform()
    must_fail(check_platform, 2.0)


def test_water_of_a_host_pushes_a_coupled_body():
    """The drag on the body by itself: the difference that its drag area makes, in closed form."""
    flow, loads = np.array([0.8, -0.3, 0.1]), []
    for area in (3.0, 0.0):
        model = platform()
        drag = (area, area, area, 0.0, 0.0, 0.0)
        model = dataclasses.replace(model, bodies=(dataclasses.replace(model.bodies[0], drag_area=drag),))
        sim = moorage.Simulation(model, host_waves=True)
        sim.initialize()
        sim.set_water(None, np.tile(flow, (len(sim.water_nodes()), 1)))
        loads.append(sim.step(0.1, sim.position, np.zeros(6)))
    exact = 0.5 * 1025.0 * 3.0 * np.linalg.norm(flow) * flow
    np.testing.assert_allclose((loads[0] - loads[1])[:3], exact, rtol=1e-9)


def test_files_of_rods_tell_the_water_of_a_function(tmp_path):
    model = dataclasses.replace(platform(), flavour="MoorDyn-F")
    moorage.simulate(model, duration=0.5, dt_out=0.25, water=swept, time_step=0.05, moordyn_out=tmp_path / "run")
    names, _, *rows = (line.split() for line in (tmp_path / "run.MD.Rod2.out").read_text().splitlines())
    last = dict(zip(names, map(float, rows[-1]), strict=True))
    for i in range(4):
        assert last[f"Node{i}Ux"] == pytest.approx(0.2 * last[f"Node{i}px"], rel=1e-6)
        assert last[f"Node{i}Uy"] == pytest.approx(0.5)
