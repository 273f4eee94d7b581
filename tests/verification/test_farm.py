"""Two turbines with anchor lines of their own and a rope between them, each with a motion of its own.

Verifies: motion, tension, weight

* Mirror: the farm is its own image in the plane between the turbines. Turbines that move as images of each other pull with
  images of each other's forces, to 1e-8: the equations are the same but for rounding.
* Apart: without the rope, each turbine is a mooring of one platform, wherever it stands: to 1e-8.
* On a turbine, points, rods, bodies and clamps move as what is coupled does with a platform about the origin: to 1e-9; and
  so do they about a reference elsewhere: to 1e-8.
* Stiffness: 12 x 12 against central differences of static loads, 2 cm and 1 mrad, whose second order is some 1e-3 of the
  largest entry of a row; blocks between turbines are transposes of each other. A turbine's own block is symmetric but for
  K - K^T = [M x], because its lines alone hold it with a moment M.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail, rms
from farms import SPAN, carrying, loads_of, shared, swaying, without_turbines

import moorage
from moorage import Motion
from moorage.model import Turbine

FAR = (1234.0, -567.0, 0.0)


def run(model, motion, duration=10.0):
    return moorage.simulate(model, motion=motion, duration=duration, dt_out=0.1, save="tensions")


def farm_run(mirrored=True):
    return run(shared(), Motion.from_turbines({1: swaying(), 2: swaying(mirrored=mirrored)}))


def check_mirror(ds):
    """Force, moment and tensions of turbine 2 are images of those of turbine 1."""
    force, moment = ds["turbine_force"].values, ds["turbine_moment"].values
    scale = np.abs(force).max()
    assert np.abs(force[:, 0] * [-1.0, 1.0, 1.0] - force[:, 1]).max() < 1e-8 * scale
    assert np.abs(moment[:, 0] * [1.0, -1.0, -1.0] - moment[:, 1]).max() < 1e-8 * np.abs(moment).max()
    tension = ds["fairlead_tension"].values
    assert np.abs(tension[:, 0] - tension[:, 2]).max() < 1e-8 * scale
    assert np.abs(tension[:, 1] - ds["anchor_tension"].values[:, 1]).max() < 1e-8 * scale


def test_a_farm_is_its_own_image():
    ds = farm_run()
    check_mirror(ds)
    place, turn = ds["turbine_position"].values, ds["turbine_rotation"].values
    np.testing.assert_allclose(place[:, 0, 0] + place[:, 1, 0], SPAN, atol=1e-9)
    np.testing.assert_allclose(turn[:, 0], turn[:, 1] * [1.0, -1.0, -1.0], atol=1e-9)


def apart(second):
    """Return the farm without its rope, with turbine 2 somewhere."""
    model = shared(second=second)
    return dataclasses.replace(model, lines=(model.lines[0], model.lines[2]))


def alone(turbine):
    """Return the mooring of a turbine as one of a platform at the origin."""
    model = shared(second=(0.0, 0.0, 0.0))
    keep = {1: (1, 2, 3), 2: (4, 5, 6)}[turbine]
    lines = tuple(x for x in model.lines if {x.end_a.id, x.end_b.id} <= set(keep))
    points = tuple(dataclasses.replace(p, turbine=None) for p in model.points if p.id in keep)
    return dataclasses.replace(model, points=points, lines=lines, turbines=())


OWN = {1: swaying(), 2: Motion.from_harmonics(20.0, ramp=5.0, interval=0.1, surge=(3.0, 10.0), roll=(0.1, 8.0))}


def check_apart(ds, motions):
    for k, motion in motions.items():
        single = run(alone(k), motion)
        pull, whole = single["fairlead_force"].values[:, 0], ds["fairlead_force"].values[:, k - 1]
        assert rms(pull - whole) < 1e-8 * rms(pull)


def test_turbines_that_share_nothing_are_moorings_of_their_own():
    check_apart(run(apart(FAR), Motion.from_turbines(OWN)), OWN)


def check_carried(ds, plain, bound):
    for name in ("fairlead_force", "fairlead_moment", "anchor_force", "rod_force", "body_force", "body_moment"):
        values, expected = ds[name].values, plain[name].values
        assert np.abs(values - expected).max() < bound * np.abs(expected).max(), name
    np.testing.assert_allclose(ds["body_rotation"].values, plain["body_rotation"].values, atol=1e-9)


def test_what_is_on_a_turbine_moves_as_what_is_coupled():
    """The platform of a plain motion turns about the origin, and so does a turbine there; and elsewhere about there."""
    model, motion = carrying(), swaying()
    plain = run(without_turbines(model), motion)
    check_carried(run(model, Motion.from_turbines({1: motion})), plain, 1e-9)
    there = run(carrying(FAR), Motion.from_turbines({1: motion}))
    check_carried(there, plain, 1e-8)
    np.testing.assert_allclose(there["body_position"].values - FAR, plain["body_position"].values, atol=1e-8)


def test_the_load_of_a_turbine_is_that_of_all_that_it_carries():
    ds = run(carrying(FAR), Motion.from_turbines({1: swaying()}))
    origin = ds["turbine_position"].values[:, 0]
    pull, rod, body = ds["point_force"].sel(point=4).values, ds["rod_force"].values[:, 0], ds["body_force"].values[:, 0]
    np.testing.assert_allclose(ds["turbine_force"].values[:, 0], pull + rod + body, rtol=1e-12)
    moment = (
        np.cross(ds["point_position"].sel(point=4).values - origin, pull)
        + np.cross(ds["rod_position"].values[:, 0, 0] - origin, rod)
        + ds["rod_moment"].values[:, 0]
        + np.cross(ds["body_position"].values[:, 0] - origin, body)
        + ds["body_moment"].values[:, 0]
    )
    np.testing.assert_allclose(ds["turbine_moment"].values[:, 0], moment, rtol=1e-9)


@pytest.fixture(scope="module")
def stiffness():
    return moorage.stiffness(shared())


def check_stiffness(K, model):
    rest = np.array([[*t.position, 0.0, 0.0, 0.0] for t in model.turbines])
    for turbine in range(2):
        for dof in range(6):
            step, ends = (0.02 if dof < 3 else 1e-3), []
            for sign in (1.0, -1.0):
                pose = rest.copy()
                pose[turbine, dof] += sign * step
                ends.append(loads_of(model, pose))
            expected = (ends[1] - ends[0]) / (2.0 * step)
            scale = np.abs(K).max(axis=(2, 3))
            assert (np.abs(K[:, :, turbine, dof] - expected) / scale).max() < 3e-3, (turbine, dof)


def test_the_full_stiffness_is_the_derivative_of_the_loads(stiffness):
    assert stiffness["platform"].values.tolist() == ["turbine 1", "turbine 2 (east)"]
    np.testing.assert_array_equal(stiffness["platform_origin"].values, [[0.0, 0.0, 0.0], [SPAN, 0.0, 0.0]])
    K = stiffness["platform_stiffness"].values
    check_stiffness(K, shared())


def test_the_full_stiffness_is_symmetric(stiffness):
    K = stiffness["platform_stiffness"].values
    scale = np.sqrt(np.outer(np.diag(K[0, :, 0]), np.diag(K[1, :, 1])))
    assert (np.abs(K[0, :, 1] - K[1, :, 0].T) / scale).max() < 1e-6
    loads = loads_of(shared(), [[0.0] * 6, [SPAN, *[0.0] * 5]])
    for k in range(2):
        mx, my, mz = loads[k, 3:]
        skew = np.zeros((6, 6))
        skew[3:, 3:] = [[0.0, -mz, my], [mz, 0.0, -mx], [-my, mx, 0.0]]
        own = K[k, :, k]
        assert (np.abs(own - own.T - skew) / np.sqrt(np.outer(np.diag(own), np.diag(own)))).max() < 1e-6


def test_a_moved_reference_moves_the_model():
    """All references and anchors by 1 km: the same loads; turbine 2 alone pulled 5 m away: the rope pulls more."""
    here, there = (moorage.solve_statics(shared(*places)) for places in (
        ((0.0, 0.0, 0.0), (SPAN, 0.0, 0.0)), ((1000.0, 500.0, 0.0), (1000.0 + SPAN, 500.0, 0.0))))  # fmt: skip
    scale = np.abs(here["turbine_force"].values).max()
    assert np.abs(here["turbine_force"].values - there["turbine_force"].values).max() < 1e-8 * scale
    model = shared()
    pulled = dataclasses.replace(model, turbines=(model.turbines[0], Turbine(id=2, position=(SPAN + 5.0, 0.0, 0.0))))
    assert moorage.solve_statics(pulled)["fairlead_tension"][1] > 1.05 * here["fairlead_tension"][1]


def test_wrong_farms_are_noticed(stiffness):
    """Turbines that move alike, that change motions, that turn about the origin, that do not feel each other."""
    must_fail(check_mirror, farm_run(mirrored=False))
    must_fail(check_apart, run(apart(FAR), Motion.from_turbines({1: OWN[2], 2: OWN[1]})), OWN)
    plain = run(without_turbines(carrying()), swaying())
    must_fail(check_carried, run(without_turbines(carrying(FAR), FAR), swaying()), plain, 1e-8)
    deaf = stiffness["platform_stiffness"].values.copy()
    deaf[0, :, 1] = 0.0
    must_fail(check_stiffness, deaf, shared())
