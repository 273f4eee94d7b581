"""A load that a winch lowers and hoists: force, momentum, energy, and what happens when a segment is made or removed.

Verifies: winch

A load M hangs on a rope of mass m (kg/m) from a winch that has L(t) of it out. Both move with L' and L''. What leaves
the winch takes its momentum along, so that the winch, with what is still in it, bears

    F = (M + m L)(g - L'') - m L'^2                                                                     (1)

The rope gives way by (M g L + m g L^2 / 2) / EA, whose second derivative is the acceleration that (1) leaves out: with
EA = 1e7 N and L' = 1 m/s it is m g L'^2 / EA = 1e-5 m/s2 at a constant rate, 0.02 N of M + m L, and with L'' < 0.14 m/s2
(M + m L) g L'' / EA = 3e-4 m/s2, 0.6 N. A tolerance of 1e-3 m in position leaves waves of less than 2 N behind, for
these are 1e-4 of what the accelerations L'' would do at once. The thrust m L'^2 is 10 N.

Energy: at the winch the tension T = F + m L'^2 works on line that goes out with (1 + T / EA) L', and that line brings
along its elastic and kinetic energy, so that without damping

    dE/dt = L' [-T (1 + T / EA) + T^2 / (2 EA) + m L'^2 / 2]                                            (2)

with E of the rope and the load (heights from the winch). It is checked to 1e-5 of the work done: trapezoids of 0.02 s
leave h^2 / 12 of the change of the power's slope, 1e-6, and steps in time damp waves of 2 N only.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail
from winches import GRAVITY, chain_to_anchor, load_on_rope, smooth_rate, winch

import moorage
from moorage.model import Curve
from moorage.solve import march

LOAD, MASS, EA = 1000.0, 10.0, 1e7


def out(ds):
    """Length (m), rate and its slope (m/s, m/s2) at the times of a result, from the result alone."""
    length, rate = ds["line_length"].values[:, 0], ds["payout_rate"].values[:, 0]
    return length, rate, np.gradient(rate, ds["time"].values, edge_order=2)


def force_of_equation_1(ds, thrust=1.0):
    length, rate, surge = out(ds)
    return (LOAD + MASS * length) * (GRAVITY - surge) - thrust * MASS * rate**2


def check_force(ds, thrust=1.0):
    error = -ds["fairlead_force"].values[:, 0, 2] - force_of_equation_1(ds, thrust)
    assert np.abs(error).max() < 4.0, f"{np.abs(error).max():.2f} N"
    steady = np.abs(ds["payout_rate"].values[:, 0]) > 0.999
    assert abs(error[steady].mean()) < 0.5, f"{error[steady].mean():.2f} N while the rate is constant"


@pytest.fixture(scope="module", params=[1.0, -1.0], ids=["lowered", "hoisted"])
def run(request):
    model = load_on_rope(winch(smooth_rate(request.param, ramp=20.0, stop=60.0)), axial_damping_ratio=0.0)
    return moorage.simulate(model, duration=62.0, dt_out=0.02, tolerance=1e-3)


def test_the_winch_bears_weight_inertia_and_thrust(run):
    check_force(run)


def test_without_the_thrust_the_check_fails(run):
    must_fail(check_force, run, thrust=0.0)


def test_segments_come_and_go(run):
    count = (run["segment_length"].values > 0.0).sum(axis=1)
    lowered = float(run["payout_rate"].max()) > 0.5
    assert (count[0], count[-1]) == ((10, 14) if lowered else (10, 6))
    assert np.abs(np.diff(count)).max() == 1


def test_length_is_conserved_to_round_off(run):
    """The segments are L0 and the integral of the rate: a sum of 14 numbers of up to 140 m, each good to 1.5e-14."""
    length = run["line_length"].values[:, 0]
    assert np.abs(run["segment_length"].values.sum(axis=1) - length).max() < 1e-12
    t, r = run["time"].values, run["payout_rate"].values[:, 0]
    integral = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(t) * (r[1:] + r[:-1]))])
    assert np.abs(100.0 + integral - length).max() < 1e-5  # trapezoids of 0.02 s: h^2 r' / 12 = 4e-6 m
    assert abs(length[-1] - 100.0) == pytest.approx(40.0, abs=1e-12)  # of 1 m/s over 60 s less two halves of 20 s


def energy(ds):
    """Kinetic and elastic energy and height of rope and load, J, from positions, velocities and lengths of a result."""
    z, v = ds["node_position"].values[..., 2], ds["node_velocity"].values[..., 2].copy()
    l, rate = ds["segment_length"].values, ds["payout_rate"].values[:, 0]
    L = np.abs(np.diff(z, axis=1))
    last = (l > 0.0).sum(axis=1)  # the node at the winch, where the line moves with its own velocity
    row = np.arange(len(l))
    v[row, last] = -rate * L[row, last - 1] / l[row, last - 1]
    half = 0.5 * MASS * l
    mass = np.pad(half, ((0, 0), (0, 1))) + np.pad(half, ((0, 0), (1, 0)))
    mass[:, 0] += LOAD
    stretch = np.divide((L - l) ** 2, l, out=np.zeros_like(l), where=l > 0.0)
    return (0.5 * mass * v**2 + mass * GRAVITY * z).sum(axis=1) + 0.5 * EA * stretch.sum(axis=1)


def check_energy(ds, thrust=1.0):
    rate = ds["payout_rate"].values[:, 0]
    T = -ds["fairlead_force"].values[:, 0, 2] + thrust * MASS * rate**2
    power = rate * (-T * (1.0 + T / EA) + 0.5 * T**2 / EA + 0.5 * MASS * rate**2)
    work = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(ds["time"].values) * (power[1:] + power[:-1]))])
    E = energy(ds)
    assert np.abs(E - E[0] - work).max() < 1e-5 * np.abs(work).max()


def test_energy_changes_by_the_work_of_the_winch(run):
    check_energy(run)


def test_the_energy_without_the_thrust_fails(run):
    must_fail(check_energy, run, thrust=0.0)


def check_jumps(ds, bound):
    """No change of the force on the winch from one time to the next, 1 ms later, is larger where lines are cut."""
    force = np.linalg.norm(ds["fairlead_force"].values[:, 0], axis=1)
    cuts = np.flatnonzero(np.diff((ds["segment_length"].values > 0.0).sum(axis=1)))
    assert len(cuts)
    assert np.abs(np.diff(force)[cuts]).max() < bound


def over_a_cut(monkeypatch=None):
    """A load that is lowered at 1 m/s, from 0.5 s before the first segment is made to 0.5 s after, in steps of 1 ms."""
    if monkeypatch is not None:
        monkeypatch.setattr(march, "slide_into_balance", lambda *_: None)
    rate = Curve((0.0, 3.0, 100.0), (0.0, 1.0, 1.0))  # 1 m are out after 2.45 s
    return moorage.simulate(load_on_rope(winch(rate)), duration=3.0, dt_out=1e-3, tolerance=2e-4)


def test_a_hanging_load_does_not_feel_that_a_segment_is_made():
    """A node is put where its material keeps its acceleration, and then all forces are those of before.

    Waves of the start go on: the load of 1000 kg on 100 m of 1e7 N swings with 10 rad/s, and up to (M + m L) L'' = 670 N
    start with the rate, so that in 1 ms the force changes by up to 6.7 N.
    """
    check_jumps(over_a_cut(), 6.7)


def test_a_node_that_is_left_where_it_is_made_fails(monkeypatch):
    """Half of a segment's weight, m g l0 / 2 = 490 N, goes through the rope as a wave."""
    must_fail(check_jumps, over_a_cut(monkeypatch), 6.7)


def test_a_chain_jumps_less_than_its_kink_when_a_segment_is_removed():
    """A node at b from the winch and a from the next one hangs w a b / 2T below the straight line, so that the line is
    w^2 a b (a + b) / 8T^2 shorter without it: the tension falls by EA w^2 a b / 8T^2 at most, less what both ends give
    way. w: the part of the weight across the chain. Here 3 to 18 kN of 113 to 167 kN.
    """
    rate = Curve((0.0, 5.0, 65.0, 70.0), (0.0, -0.5, -0.5, 0.0))
    ds = moorage.simulate(chain_to_anchor(winch(rate), length=225.0, segments=22), duration=70.0, dt_out=0.01)
    force = ds["fairlead_tension"].values[:, 0]
    length = ds["segment_length"].values
    count = (length > 0.0).sum(axis=1)
    weight = (100.0 - 1025.0 * np.pi / 400.0) * GRAVITY
    cuts = np.flatnonzero(np.diff(count))
    assert len(cuts) == 3
    for k in cuts:
        a, b = length[k, count[k] - 2], length[k, count[k] - 1]
        e = ds["node_position"].values[k, count[k]] - ds["node_position"].values[k, count[k] - 2]
        across = weight * np.hypot(e[0], e[1]) / np.linalg.norm(e)
        bound = 5e8 * across**2 * a * b / (8.0 * force[k] ** 2)
        assert np.abs(np.diff(force)[k - 5 : k + 20]).max() < min(bound, 0.02 * force[k])


def test_a_chain_that_is_paid_out_ends_in_the_statics_of_its_length():
    """Slowly paid out and left alone, a chain hangs as one of that length; segments of other lengths make 0.5 %."""
    rate = smooth_rate(0.5, ramp=10.0, stop=70.0)
    ds = moorage.simulate(chain_to_anchor(winch(rate), length=200.0, segments=40), duration=110.0)
    length = float(ds["line_length"][-1, 0])
    assert length == pytest.approx(230.0)
    still = moorage.solve_statics(chain_to_anchor(None, length=length, segments=46))
    assert float(ds["fairlead_tension"][-1, 0]) == pytest.approx(float(still["fairlead_tension"][0]), rel=5e-3)


def test_a_winch_at_end_a_does_the_same_as_one_at_end_b():
    rate = smooth_rate(0.5, ramp=5.0, stop=30.0)
    model = chain_to_anchor(winch(rate))
    turned = chain_to_anchor(dataclasses.replace(winch(rate), end="A"), turned=True)
    b, a = (moorage.simulate(m, duration=32.0) for m in (model, turned))
    assert np.allclose(b["node_position"], a["node_position"].values[:, ::-1], atol=1e-8)
    assert np.allclose(b["fairlead_tension"], a["anchor_tension"], rtol=1e-8)
