"""Winches as a user meets them: files, the command line, Python, a host; resumed runs, failures, cables, channels."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from winches import chain_to_anchor, load_on_rope, smooth_rate, winch

import moorage
import moorage.moordyn as moordyn
from moorage.io import write_native
from moorage.model import Attachment, Curve, Failure, OutputChannel, Rod, RodType
from moorage.model.payout import gentle_slopes, paid_out
from moorage.results.vtk import write_vtk
from moorage.solve.march_kernel import march_islands

OUT = Curve((0.0, 2.0, 20.0), (0.0, 0.5, 0.5))


# --- tables ----------------------------------------------------------------------------------------------------------


def test_a_table_of_lengths_is_smooth_and_never_overshoots():
    table = Curve((0.0, 10.0, 20.0, 60.0, 80.0), (0.0, 0.0, 1.0, 30.0, 30.0))
    paid = paid_out(winch(length=table))
    t = np.linspace(-5.0, 90.0, 9501)
    length, rate = paid.over(t)
    assert np.allclose(paid.over(np.array(table.x))[0], table.y, atol=1e-12)
    assert rate.min() >= -1e-12
    assert length.max() <= 30.0 + 1e-12
    assert np.abs(np.diff(rate)).max() < 1e-2  # no jump of the rate
    assert (length[0], rate[0], length[-1], rate[-1]) == pytest.approx((0.0, 0.0, 30.0, 0.0))


def test_slopes_are_zero_where_a_table_turns():
    assert gentle_slopes(np.arange(4.0), np.array([0.0, 1.0, 0.0, 1.0])).tolist() == [0.0] * 4


def test_a_table_of_rates_is_integrated_from_time_0():
    paid = paid_out(winch(Curve((-2.0, 2.0, 4.0), (0.0, 4.0, 0.0))))
    t = np.array([0.0, 1.0, 2.0, 3.0, 9.0])
    assert np.allclose(paid.over(t)[0], [0.0, 2.5, 6.0, 9.0, 10.0])  # of 2 + t, then 8 - 2 t m/s
    assert np.allclose(paid.over(t)[1], [2.0, 3.0, 4.0, 2.0, 0.0])


def test_a_constant_rate_goes_on():
    assert paid_out(winch(0.5)).at(100.0) == pytest.approx((50.0, 0.5))


@pytest.mark.parametrize(("low", "high", "expected"), [(-1.0, 10.0, 18.0), (1.0, 99.0, 0.0), (-1.0, 99.0, np.inf)])
def test_the_time_at_which_a_length_leaves_its_bounds(low, high, expected):
    paid = paid_out(winch(Curve((0.0, 20.0), (0.0, 20.0 / 18.0))))
    at = paid.first_outside(0.0, 20.0, low, high)
    assert at == expected or paid.at(at)[0] == pytest.approx(high)


# --- runs ------------------------------------------------------------------------------------------------------------


def test_statics_have_the_length_of_time_0():
    paid = moorage.solve_statics(chain_to_anchor(winch(length=Curve((0.0, 10.0), (30.0, 30.0))), length=210.0))
    still = moorage.solve_statics(chain_to_anchor(None, length=240.0, segments=24))
    assert float(paid["line_length"][0]) == pytest.approx(240.0)
    assert paid.sizes["segment"] == 24
    assert float(paid["fairlead_tension"][0]) == pytest.approx(float(still["fairlead_tension"][0]), rel=1e-9)


def test_rows_in_the_winch_stand_at_it():
    ds = moorage.simulate(load_on_rope(winch(smooth_rate(1.0, ramp=2.0))), duration=16.0)
    assert ds.sizes["segment"] == 12
    assert np.allclose(ds["node_position"][0, 10:], 0.0)
    assert np.allclose(ds["segment_length"][0, 10:], 0.0)
    assert np.allclose(ds["segment_tension"][0, 10:], ds["segment_tension"][0, 9])
    assert float(ds["line_length"][-1, 0]) == pytest.approx(115.0)


def test_a_resumed_run_is_the_same_to_the_bit(tmp_path):
    model, path = load_on_rope(winch(smooth_rate(1.0, ramp=2.0))), tmp_path / "run.nc"
    whole = moorage.simulate(model, duration=16.0, dt_out=0.5)

    def stop(time, duration, wall):
        if time > 6.0:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        moorage.simulate(model, duration=16.0, dt_out=0.5, output=path, progress=stop)
    ds = moorage.simulate(model, duration=16.0, dt_out=0.5, output=path, resume=True)
    for name in ("node_position", "segment_tension", "fairlead_force", "segment_length", "line_length"):
        assert np.array_equal(ds[name].values, whole[name].values), name


def test_a_line_that_comes_off_its_winch_keeps_its_length():
    model = load_on_rope(winch(smooth_rate(1.0, ramp=2.0)))
    failure = Failure(id=1, attachment=Attachment("point", 2), lines=(1,), time=5.0)
    ds = moorage.simulate(dataclasses.replace(model, failures=(failure,)), duration=8.0, dt_out=0.5)
    length = ds["line_length"].values[:, 0]
    assert np.ptp(length[10:]) == 0.0
    assert length[10] == pytest.approx(104.0)
    assert float(ds["payout_rate"][-1, 0]) == 0.0
    half = 5.0 * ds["segment_length"].values[10]  # kg of half segments; all goes on with 1 m/s
    mass = np.pad(half, (0, 1)) + np.pad(half, (1, 0))
    mass[0] += 1000.0
    centre = (ds["node_position"].values[..., 2] * mass).sum(axis=1) / mass.sum()
    assert centre[-1] - centre[10] == pytest.approx(-3.0 * 1.0 - 0.5 * 9.80665 * 9.0, abs=0.01)


def test_a_line_that_breaks_at_a_tension_goes_back_over_cuts():
    model = load_on_rope(winch(smooth_rate(1.0, ramp=2.0)))
    heavy = Failure(id=1, attachment=Attachment("point", 2), lines=(1,), tension=(1000.0 + 10.0 * 112.0) * 9.80665)
    ds = moorage.simulate(dataclasses.replace(model, failures=(heavy,)), duration=16.0, dt_out=0.5)
    assert 110.0 < float(ds["line_length"][-1, 0]) < 112.5
    assert ds.attrs["status"] == "complete"


def test_methods_agree():
    model = load_on_rope(winch(smooth_rate(1.0, ramp=2.0)), length=20.0, segments=4, place=(0.0, 0.0, -20.0))
    implicit = moorage.simulate(model, duration=4.0, tolerance=1e-5)
    explicit = moorage.simulate(model, duration=4.0, method="rk4", time_step=2e-4)
    assert np.allclose(implicit["node_position"], explicit["node_position"], atol=1e-4)


def test_a_cable_that_bends_goes_through_its_winch():
    """A cable that is clamped 6 degrees off hangs in the end as one of that length, cut in the same way."""
    model = load_on_rope(winch(smooth_rate(1.0, ramp=5.0, stop=30.0)), 100.0, 20, bending_stiffness=1e6)
    rod = Rod(id=1, rod_type="hang-off", kind="fixed", end_a=(0.0, 0.0, 0.0), end_b=(-0.1, 0.0, 1.0), segments=0)
    line = dataclasses.replace(model.lines[0], end_b=Attachment("rod", 1, "A"))
    kind = RodType(name="hang-off", diameter=0.1, mass_per_length=1.0)
    load = dataclasses.replace(model.points[0], drag_area=5.0)  # which stops its swing
    water = dataclasses.replace(model.environment, water_density=1000.0)
    model = dataclasses.replace(model, environment=water, lines=(line,), rods=(rod,), rod_types=(kind,), points=(load,))
    ds = moorage.simulate(model, duration=60.0)
    (section,) = line.sections
    cut = tuple(dataclasses.replace(section, length=l, segments=n) for l, n in ((120.0, 24), (5.0, 1)))
    line = dataclasses.replace(line, sections=cut)
    still = moorage.solve_statics(dataclasses.replace(model, controls=(), lines=(line,)))
    assert ds["line_length"].values[-1, 0] == pytest.approx(125.0)
    assert np.allclose(ds["fairlead_moment"][-1, 0], still["fairlead_moment"][0], rtol=0.02, atol=1.0)
    moment = ds["fairlead_moment"].values[80:250, 0, 1]  # segments of 0.5 to 5.5 m at the clamp
    assert np.ptp(moment) < 0.1 * moment.mean()
    assert np.isfinite(ds["curvature"].values).all()


def test_channels_follow_the_material():
    names = ("LINE1N3PZ", "LINE1N10PZ", "FAIRTEN1")
    model = load_on_rope(winch(smooth_rate(1.0, ramp=2.0)))
    model = dataclasses.replace(model, outputs=tuple(OutputChannel(name=name) for name in names))
    ds = moorage.simulate(model, duration=16.0)
    assert np.allclose(ds["LINE1N3PZ"], ds["node_position"][:, 3, 2])
    assert np.allclose(ds["LINE1N10PZ"], 0.0)  # the end at the winch
    assert float(ds["LINE1N3PZ"][-1] - ds["LINE1N3PZ"][0]) == pytest.approx(-15.0, abs=0.1)


def test_moordyn_files_have_strains_of_the_lengths_that_are_out(tmp_path):
    model = load_on_rope(winch(smooth_rate(1.0, ramp=2.0)))
    model = dataclasses.replace(model, lines=(dataclasses.replace(model.lines[0], outputs="tsc"),))
    ds = moorage.simulate(model, duration=16.0, dt_out=1.0, moordyn_out=tmp_path / "run")
    text = (tmp_path / "run_Line1.out").read_text().splitlines()
    columns = [word.upper() for word in text[0].split()]
    row = np.array([float(word) for word in text[-1].split()])
    strain = row[columns.index("SEG12ST")]
    assert strain == pytest.approx(float(ds["segment_tension"][-1, 11]) / 1e7, rel=0.05)
    first = np.array([float(word) for word in text[2].split()])
    assert np.isnan(first[columns.index("SEG12ST")])


# --- hosts -----------------------------------------------------------------------------------------------------------


def test_a_host_winds_as_a_table_does():
    table = smooth_rate(0.5, ramp=5.0)
    ds = moorage.simulate(chain_to_anchor(winch(table)), duration=12.0, tolerance=2e-4)
    sim, paid = moorage.Simulation(chain_to_anchor(winch()), tolerance=2e-4), paid_out(winch(table))
    sim.initialize()
    for step in range(1, 121):
        sim.set_payout(1, *paid.at(0.1 * step))
        force = sim.step(0.1 * step, sim.position, np.zeros((1, 3)))
    assert sim.line_lengths[0] == pytest.approx(210.0 + paid.at(12.0)[0])
    assert np.allclose(force[0], ds["fairlead_force"].values[-1, 0], rtol=2e-3, atol=100.0)


def test_a_simulation_follows_the_table_of_its_model():
    sim = moorage.Simulation(load_on_rope(winch(OUT)))
    sim.initialize()
    sim.step(4.0, sim.position, np.zeros((0, 3)))
    assert sim.line_lengths[0] == pytest.approx(101.5)
    with pytest.raises(moorage.SimulationError, match="channel 1 follows the table"):
        sim.set_payout(1, 0.0)


def test_a_host_tries_a_step_again_over_a_cut():
    sim = moorage.Simulation(load_on_rope(winch()))
    sim.initialize()
    sim.set_payout(1, 0.5, 0.5)
    sim.step(1.0, sim.position, np.zeros((0, 3)))
    state, found = sim.save(), []
    for _ in range(2):
        sim.restore(state)
        sim.set_payout(1, 12.5, 0.5)  # a segment is made on the way, and another
        sim.step(25.0, sim.position, np.zeros((0, 3)))
        found.append((sim.line_lengths[0], sim.save()["now_position"]))
    assert found[0][0] == pytest.approx(112.5)
    assert np.array_equal(found[0][1], found[1][1])


def test_a_host_that_asks_for_too_much_leaves_the_state_as_it_was():
    sim = moorage.Simulation(load_on_rope(winch()))
    sim.initialize()
    before = sim.save()
    with pytest.raises(moorage.SimulationError, match="no control channel 9"):
        sim.set_payout(9, 1.0)
    with pytest.raises(moorage.SimulationError, match="must be finite"):
        sim.set_payout(1, np.nan)
    sim.set_payout(1, -120.0)
    with pytest.raises(moorage.MoorageError, match="line 1 would have"):
        sim.step(200.0, sim.position, np.zeros((0, 3)))
    sim.set_payout(1, 10000.0)
    with pytest.raises(moorage.MoorageError, match=r"line 1: a rate of 1e\+05 m/s at 0 s makes a segment every"):
        sim.step(0.1, sim.position, np.zeros((0, 3)))
    after = sim.save()
    assert all(np.array_equal(after[name], before[name]) for name in before if name != "host_paid")


# --- what is made of results ----------------------------------------------------------------------------------------


def test_pictures_pages_and_files_take_lines_that_grow(tmp_path):
    ds = moorage.simulate(chain_to_anchor(winch(smooth_rate(0.5, ramp=5.0, stop=40.0))), duration=42.0, dt_out=1.0)
    moorage.plot.save_figure(ds, tmp_path / "run.png")
    moorage.view(ds).save(tmp_path / "view.html")
    moorage.report(ds, tmp_path / "report.html")
    write_vtk(ds, tmp_path / "vtk", every=10)
    assert "210 to 227.5" in (tmp_path / "report.html").read_text()
    (line,) = moorage.results.line_summaries(ds)
    assert line.fairlead.maximum == pytest.approx(float(ds["fairlead_tension"].max()))


def test_water_from_a_function_is_taken_over_a_cut():
    def still(time, places):
        return np.zeros(len(places)), np.zeros_like(places), np.zeros_like(places)

    model = chain_to_anchor(winch(smooth_rate(0.5, ramp=5.0, stop=40.0)))
    plain = moorage.simulate(model, duration=20.0, dt_out=1.0)
    compiled = len(march_islands.signatures)
    given = moorage.simulate(model, duration=20.0, dt_out=1.0, water=still)
    assert len(march_islands.signatures) == compiled  # another layout of the water would compile all anew
    assert plain.sizes["segment"] > 21
    error = plain["fairlead_tension"].values - given["fairlead_tension"].values
    assert np.sqrt(np.mean(error**2)) < 1e-2 * float(plain["fairlead_tension"].mean())  # nodes land at other steps


def test_the_module_of_moordyn_says_that_it_has_no_channels(tmp_path, capsys):
    write_native(load_on_rope(winch(0.5)), tmp_path / "rope.yaml")
    moordyn.Create(str(tmp_path / "rope.yaml"))
    assert "control channels are not used here (1): hosts set lengths" in capsys.readouterr().err
