"""What a result holds of the seabed: contact, friction, uplift, touchdown, energy, in memory and on disk."""

import dataclasses
import signal

import numpy as np
import pytest
from moorings import CHAIN, coupled, fixed, free, kind, line, mooring, weight_in_water

import moorage
from moorage import streaming
from moorage.model import Bathymetry, Friction, Motion, Soil
from moorage.results import seabed_reports, static_report
from moorage.results.seabed import uplift
from moorage.system.build import build
from moorage.variables import VARIABLES

HISTORIES = ["seabed_gap", "seabed_force", "friction_force", "sticking", "friction_power", "touchdown_position"]
HISTORIES += ["touchdown_arc_length"]
OVER_TIME = ["anchor_uplift_force", "dissipated_energy"]
ANGLE = np.deg2rad(8.0)


def spread_of_one(**environment):
    points = [fixed(1, -600.0, 0.0, -120.0), coupled(2, 0.0, 0.0, -10.0)]
    return mooring(CHAIN, points, [line(1, 1, 2, ("chain", 640.0, 16))], water_depth=120.0, **environment)


def sloping(**environment):
    """One chain that hangs down to a plane that falls with x, and lies on it up to its anchor."""
    x = (-700.0, 100.0)
    depth = tuple((150.0 + value * np.tan(ANGLE),) * 2 for value in x)
    grid = Bathymetry(x, (-50.0, 50.0), depth)
    points = [fixed(1, -600.0, 0.0, -grid.depth_at(-600.0, 0.0)), coupled(2, 0.0, 0.0, -10.0)]
    return mooring(
        CHAIN, points, [line(1, 1, 2, ("chain", 640.0, 16))], water_depth=150.0, bathymetry=grid, **environment
    )


@pytest.fixture(scope="module")
def surge():
    return Motion.from_harmonics(12.0, ramp=3.0, surge=(3.0, 6.0))


@pytest.fixture(scope="module")
def rough(surge):
    """Recorded at the ends of all steps: between them the laws do not hold exactly."""
    model = spread_of_one(friction=Friction(axial=0.5, transverse=0.7))
    return moorage.simulate(model, motion=surge, duration=12.0, dt_out=0.025, time_step=0.025)


def test_plain_runs_stay_small(surge):
    ds = moorage.simulate(spread_of_one(), motion=surge, duration=0.5)
    assert not {*HISTORIES, *OVER_TIME} & {*ds.variables}


@pytest.mark.parametrize("model", [sloping(), spread_of_one(friction=Friction(axial=0.5))], ids=["bed", "friction"])
def test_only_what_is_sensible(model):
    static = moorage.solve_statics(model)
    assert ("friction_force" in static) == (model.environment.friction is not None)
    assert {"seabed_gap", "seabed_force", "touchdown_position", "anchor_uplift_force"} <= {*static}
    assert not {"friction_power", "dissipated_energy"} & {*static}


def test_soil_shows_its_suction(surge):
    ds = moorage.simulate(spread_of_one(soil=Soil(shear_strength=3e3)), motion=surge, duration=12.0, dt_out=0.25)
    assert {"seabed_gap", "seabed_force", "touchdown_position", "anchor_uplift_force"} <= {*ds}
    assert not {"friction_power", "dissipated_energy"} & {*ds}
    assert ds["seabed_force"].min() < -1e3
    assert ds["seabed_force"].values[ds["seabed_gap"].values > 0.0] == pytest.approx(0.0)
    assert ds.attrs["soil"] == "with a memory, s_u = 3 kPa"


def test_variables_have_their_dims(rough):
    for name in (*HISTORIES, *OVER_TIME):
        assert rough[name].dims == VARIABLES[name].dims
        assert rough[name].attrs["units"] == VARIABLES[name].unit


def test_normal_force_carries_the_chain_that_lies():
    static = moorage.solve_statics(spread_of_one(friction=Friction(axial=0.5)))
    gap, force = static["seabed_gap"].values, static["seabed_force"].values
    assert np.all((force > 0.0) == (gap < 0.0))
    weight = weight_in_water(CHAIN) * 40.0
    np.testing.assert_allclose(force[1:6], weight, rtol=1e-3)  # nodes that lie far from the touchdown
    lies = float(static["grounded_length"][0])
    assert lies - 40.0 < float(static["touchdown_arc_length"][0]) < lies + 40.0
    assert np.isclose(static["touchdown_position"].values[0, 2], -120.0)


def test_friction_stays_in_its_cone_and_sticks_inside_it(rough):
    normal = rough["seabed_force"].values
    size = np.linalg.norm(rough["friction_force"].values, axis=-1)
    assert np.all(size <= 0.7 * np.abs(normal) * (1.0 + 1e-6))
    assert np.all(rough["sticking"].values[normal == 0.0] == 0)
    slides = (normal > 100.0) & (rough["sticking"].values == 0)
    assert slides.any()
    np.testing.assert_allclose(size[slides], 0.5 * normal[slides], rtol=0.02)  # the chain moves along itself
    assert rough["sticking"].values[:, 1].all()  # beside the anchor nothing moves
    assert rough["sticking"].dtype == np.int8


def test_energy_is_the_work_of_the_friction(rough):
    """The springs of what sticks hold (mu N)^2 / 2 k at most of it; sums over records are good to half a percent here."""
    work = np.diff(rough["node_position"].values, axis=0)
    force = 0.5 * (rough["friction_force"].values[1:] + rough["friction_force"].values[:-1])
    energy = rough["dissipated_energy"].values[:, 0]
    assert np.all(np.diff(energy) >= 0.0)
    paid = -float((force * work).sum())
    spring = build(spread_of_one(friction=Friction(axial=0.5, transverse=0.7))).system.friction.spring[:17]
    stored = float(((0.5 * rough["seabed_force"].values[-1]) ** 2 / (2.0 * spring)).sum())
    assert 0.0 < stored < 0.02 * paid
    assert -0.005 * paid < paid - energy[-1] < stored + 0.005 * paid


@pytest.mark.parametrize("law", ["elastic-slip", "stick-slip"])
def test_energy_never_falls_and_holds_what_dampers_take(law):
    """On steps of 20 ms, on which nodes of stick-slip go back before their springs do; chains lie and let go."""
    friction = Friction(axial=0.5, transverse=0.7, model=law)
    points = [fixed(1, 0.0, 0.0, -100.0), coupled(2, 150.0, 0.0, 0.0)]
    rope = kind("chain", mass_per_length=100.0, axial_stiffness=5e7, axial_damping_ratio=0.3, transverse_drag=1.2)
    model = mooring(
        rope, points, [line(1, 1, 2, ("chain", 210.0, 21))], water_depth=100.0, seabed_stiffness=1e6, friction=friction
    )
    moved = Motion.from_harmonics(20.0, ramp=3.0, surge=(3.0, 8.0), sway=(2.0, 6.0))
    ds = moorage.simulate(model, motion=moved, duration=20.0, dt_out=0.02, time_step=0.02)
    energy = ds["dissipated_energy"].values[:, 0]
    assert np.all(np.diff(energy) >= 0.0)
    force, way = ds["friction_force"].values, np.diff(ds["node_position"].values, axis=0)
    held = (force[-1] ** 2).sum() / (2.0 * 1e6 * 0.1 * 10.0)  # what springs hold at the end, at most
    work = -(0.5 * (force[1:] + force[:-1]) * way).sum()
    assert work - held - 0.03 * work < energy[-1] < 1.03 * work
    assert ds.attrs["friction"] == f"{law}, 0.5 along and 0.7 across the line"


@pytest.mark.parametrize("dt_nodes", [None, 0.5])
def test_a_file_holds_what_memory_does(surge, tmp_path, dt_nodes):
    model = sloping(friction=Friction(axial=0.5, transverse=0.7, model="stick-slip", static_ratio=1.2))
    settings = {"motion": surge, "duration": 3.0, "dt_out": 0.25, "dt_nodes": dt_nodes}
    memory = moorage.simulate(model, **settings)
    with moorage.simulate(model, output=tmp_path / "run.nc", **settings) as file:
        for name in (*HISTORIES, *OVER_TIME, "anchor_uplift_angle"):
            np.testing.assert_array_equal(file[name].values, memory[name].values, err_msg=name)
            assert file[name].dtype == memory[name].dtype
        assert file["bed_level"].equals(memory["bed_level"])
        assert {*file.coords} == {*memory.coords}
        assert file.attrs.keys() == memory.attrs.keys()


def test_slope_of_touchdown_and_uplift():
    static = moorage.solve_statics(sloping())
    x, _, z = static["touchdown_position"].values[0]
    assert z == pytest.approx(-(150.0 + x * np.tan(ANGLE)), abs=0.05)
    assert static["anchor_uplift_force"].values[0] == 0.0
    assert static["anchor_uplift_angle"].values[0] == 0.0
    taut = sloping()
    short = dataclasses.replace(taut.lines[0].sections[0], length=600.0)
    taut = dataclasses.replace(taut, lines=(dataclasses.replace(taut.lines[0], sections=(short,)),))
    static = moorage.solve_statics(taut)
    force, normal = static["anchor_force"].values[0], np.array([np.sin(ANGLE), 0.0, np.cos(ANGLE)])
    assert static["grounded_length"].values[0] == pytest.approx(0.5 * 600.0 / 16)  # that of the anchor's node
    assert static["anchor_uplift_force"].values[0] == pytest.approx(force @ normal)
    assert static["anchor_uplift_angle"].values[0] == pytest.approx(np.arcsin(force @ normal / np.linalg.norm(force)))


@pytest.mark.parametrize("law", ["saturated-damping", "velocity-dependent"])
def test_laws_of_the_velocity_stick_below_their_peak(law):
    """A rope pulled at up to 0.3 m/s slides where it is pulled (its laws peak at 0.07 and 0.02 m/s) and sticks beside its anchor."""
    rope = kind(mass_per_length=100.0, axial_stiffness=1e6)
    points = [fixed(1, 0.0, 0.0, -50.0), coupled(2, 100.0, 0.0, -50.0)]
    moved = Motion.from_harmonics(4.0, ramp=1.0, surge=(0.2, 4.0))
    friction = Friction(axial=0.5, transverse=0.5, model=law, damping=1.6e5, velocity=0.02)
    model = mooring(rope, points, [line(1, 1, 2, ("rope", 100.0, 8))], water_depth=50.0, friction=friction)
    ds = moorage.simulate(model, motion=moved, duration=4.0, dt_out=0.1)
    sticks, along = ds["sticking"].values, np.abs(ds["node_velocity"].values[..., 0])
    peak = ds["seabed_force"].values / 1.6e5 if law == "saturated-damping" else 0.02
    lies = ds["seabed_force"].values > 0.0
    np.testing.assert_array_equal(sticks, lies & (along < peak))
    assert sticks[:, 1].all()
    assert not sticks[:, -2].all()


def test_uplift_in_the_axes_of_the_bed():
    normal = np.array([[0.0, 0.6, 0.8]])
    force = np.array([[[0.0, 8.0, -6.0]], [[0.0, 6.0, 8.0]], [[0.0, -6.0, -8.0]]])
    up, angle = uplift(force, normal, np.array([[0.0], [0.0], [5.0]]))
    np.testing.assert_allclose(up[:, 0], [0.0, 10.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(angle[:, 0], [0.0, np.pi / 2.0, 0.0], atol=1e-12)


def test_energy_of_a_dragged_rope():
    """Dragged along itself at one speed: mu w L a metre, and the force on its end is mu w L."""
    rope = kind(mass_per_length=100.0, axial_damping_ratio=1.0)
    rub, level = 0.5 * weight_in_water(rope) * 50.0, -50.0 - weight_in_water(rope) / (3e6 * 0.1)
    points = [free(1, 0.0, 0.0, level), coupled(2, 50.0, 0.0, level)]
    time = np.arange(0.0, 21.0, 0.1)
    way = 0.5 * np.where(time < 4.0, time**2 / 8.0, time - 2.0)
    moved = Motion.from_points(time, {2: np.stack([50.0 + way, 0.0 * time, level + 0.0 * time], axis=1)})
    friction = Friction(axial=0.5, transverse=0.7)
    model = mooring(rope, points, [line(1, 1, 2, ("rope", 50.0, 10))], water_depth=50.0, friction=friction)
    ds = moorage.simulate(model, motion=moved, duration=20.0, dt_out=0.1)
    energy = ds["dissipated_energy"].values[:, 0]
    middle = (ds["time"].values > 9.95) & (ds["time"].values < 18.05)
    spent, came = np.ptp(energy[middle]), np.ptp(ds["point_position"].values[middle, 1, 0])
    assert spent == pytest.approx(rub * came, rel=2e-3)
    assert not ds["sticking"].values[middle][:, 1:-1].any()
    np.testing.assert_allclose(
        np.linalg.norm(ds["friction_force"].values[middle][:, 1:-1], axis=-1), rub / 10, rtol=2e-3
    )


def test_touchdown_of_a_catenary():
    """Frictionless, on a level bed: what lies is L - V / w, with V what the fairlead carries."""
    static = moorage.solve_statics(spread_of_one(friction=Friction(axial=0.5)))
    lies = 640.0 - float(-static["fairlead_force"].values[0, 2]) / weight_in_water(CHAIN)
    assert float(static["touchdown_arc_length"][0]) == pytest.approx(lies, abs=20.0)  # half a segment
    along = float(static["touchdown_position"].values[0, 0]) + 600.0
    assert along == pytest.approx(float(static["touchdown_arc_length"][0]), rel=1e-3)


def test_touchdown_below_the_anchor():
    """A chain that lies down a slope meets the bed where it is lifted, though its anchor stands higher than that end."""
    depth = ((100.0, 100.0), (100.0 + 600.0 * np.tan(ANGLE),) * 2)
    grid = Bathymetry((0.0, 600.0), (-50.0, 50.0), depth)
    points = [fixed(1, 0.0, 0.0, -100.0), coupled(2, 385.0, 0.0, -140.0)]
    model = mooring(CHAIN, points, [line(1, 1, 2, ("chain", 400.0, 40))], water_depth=200.0, bathymetry=grid)
    static = moorage.solve_statics(model)
    gap = static["seabed_gap"].values
    lifted = int(np.flatnonzero(gap > 0.0)[0])
    assert gap[-1] > 10.0
    assert 10.0 * (lifted - 1) <= float(static["touchdown_arc_length"][0]) <= 10.0 * lifted
    place = static["touchdown_position"].values[0]
    assert place[2] == pytest.approx(-grid.depth_at(*place[:2]), abs=0.05)


def test_reports_for_people(rough):
    (row,) = seabed_reports(rough)
    assert row.line == 1
    assert row.dissipated_energy == rough["dissipated_energy"].values[-1, 0]
    start, least, largest = row.touchdown_arc_length
    assert 0.0 < least < start <= largest < 640.0
    assert row.uplift_force == 0.0
    static = moorage.solve_statics(sloping())
    (row,) = seabed_reports(static)
    assert np.isnan(row.dissipated_energy)
    assert row.touchdown_position == tuple(static["touchdown_position"].values[0])
    entry = static_report(static)["lines"][0]
    assert entry["touchdown_arc_length"] == row.touchdown_arc_length[0]
    assert entry["anchor_uplift_force"] == 0.0
    assert seabed_reports(moorage.solve_statics(spread_of_one())) == []


def test_resumed_run_goes_on_with_friction_and_its_energy(surge, tmp_path, monkeypatch):
    """The places where nodes stick are in the checkpoint, and the energy is that of the whole run."""
    monkeypatch.setattr(streaming, "BLOCK_SECONDS", 0.01)
    model = sloping(friction=Friction(axial=0.5, transverse=0.7))
    settings = {"motion": surge, "duration": 12.0, "dt_out": 0.1, "time_step": 0.01}
    whole = moorage.simulate(model, **settings)

    def progress(time, duration, wall):
        if time >= 5.0:
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(moorage.RunInterrupted):
        moorage.simulate(model, **settings, output=tmp_path / "run.nc", progress=progress)
    with moorage.simulate(model, **settings, output=tmp_path / "run.nc", resume=True) as resumed:
        for name in whole.variables:
            np.testing.assert_array_equal(resumed[name].values, whole[name].values, err_msg=name)
