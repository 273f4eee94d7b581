"""Airy waves: the fields of the engine are those of linear theory, and what they do to a line is Morison's force.

Verifies: sea, current, morison

Fields. Elevation, velocity and acceleration of one wave have closed forms (phase speed w / k, profiles by depth, p at
the bed); a sea of 200 components in 20 directions is compared with a sum by NumPy's functions. Polynomials for sine,
cosine and exponential are good to 1e-10, so that sums of order 1 agree to 1e-8. Gradients are checked by central
differences with 1e-3 m: truncation (k d)^2 / 6 with k < 0.5 is below 1e-7. The water has neither rotation nor sources.

A vertical taut line without weight, held at both ends, in a small wave: its ends carry the integral of

    0.5 rho Cd d |u| u + rho A (1 + Ca) du/dt

over the span, weighted to the ends as a beam on two supports would, summed over the nodes just as lumping does. Tension
holds the pole to 0.1 mm. 1e-3 of the largest force is asked, 5.5e-4 measured (records every 0.25 s lie between steps of
0.02 s). An added mass of 0.8 instead of 1 must fail.

A node that floats and is small follows the particle of water: in a wave of small steepness its path over a period is
the ellipse A cosh k(z + h) / sinh kh by A sinh k(z + h) / sinh kh. Stokes' drift in a period, (k A)^2 c T exp(-2 k d),
is 7 mm here, 5 % of it: what is allowed.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import DENSITY, GRAVITY, fixed, free, kind, run, single

from moorage.model import Waves
from moorage.model.spectra import wavenumbers
from moorage.physics.sea import ETA, ETA_T, ETA_X, ETA_Y, GRAD_A, GRAD_U, RECORD, A, J, U, record_at, scratch_for
from moorage.solve.statics import rest, solve
from moorage.system.build import build
from moorage.system.sea import build_sea

DEPTH = 70.0
SEA = Waves.irregular("jonswap", 8.25, 14.5, depth=DEPTH, direction=0.4, spreading=8.0, components=200, seed=3)
PLACES = np.random.default_rng(0).uniform([-200.0, -200.0, -DEPTH], [200.0, 200.0, 3.0], (120, 3))
PLACES[:20, 2] = np.linspace(-1.0, 4.0, 20)  # in the crests too


def records(waves: Waves, places: np.ndarray, t: float) -> np.ndarray:
    sea = build_sea(waves)
    scratch, out = scratch_for(sea), np.zeros((len(places), RECORD))
    for r, row in zip(places, out, strict=True):
        record_at(sea, tuple(r), t, 1.0, scratch, row)
    return out


def check_fields(waves: Waves, reference: Waves) -> None:
    found, expected = records(waves, PLACES, 33.3), reference.kinematics(33.3, PLACES)
    wet = PLACES[:, 2] < expected.elevation
    assert (wet & (PLACES[:, 2] > 0.0)).any()
    assert np.abs(found[:, ETA] - expected.elevation).max() < 1e-8
    assert np.abs(found[:, U : U + 3] - expected.velocity)[wet].max() < 1e-8
    assert np.abs(found[:, A : A + 3] - expected.acceleration)[wet].max() < 1e-8


@pytest.mark.parametrize("stretching", ["wheeler", "vertical", "linear", "none"])
def test_fields_are_those_of_the_sum(stretching):
    given = SEA.__dict__ | {"stretching": stretching}
    check_fields(Waves(**given), Waves(**given))


def test_other_stretching_fails():
    must_fail(check_fields, SEA, Waves(**SEA.__dict__ | {"stretching": "vertical"}))


def test_linear_stretching_goes_on_with_the_slope_at_the_still_water():
    sea, place = Waves(**SEA.__dict__ | {"stretching": "linear"}), PLACES[:20] * [1.0, 1.0, 0.0]
    crests = place[sea.elevation(33.3, place[:, 0], place[:, 1]) > 1.0]
    here, below, above = (sea.kinematics(33.3, crests + np.array([0.0, 0.0, z])).velocity for z in (0.0, -1e-4, 1.0))
    assert np.abs(above - here - (here - below) / 1e-4).max() < 1e-5


@pytest.mark.parametrize("stretching", ["none", "linear"])
def test_gradients_are_derivatives(stretching):
    plain = Waves(**SEA.__dict__ | {"stretching": stretching})
    places, d = PLACES[PLACES[:, 2] < -1.0], 1e-3
    here = records(plain, places, 10.0)

    def along(axis: int) -> np.ndarray:
        step = np.eye(3)[axis] * d
        return (records(plain, places + step, 10.0) - records(plain, places - step, 10.0)) / (2.0 * d)

    dx, dy, dz = (along(axis) for axis in range(3))
    dt = (records(plain, places, 10.0 + d) - records(plain, places, 10.0 - d)) / (2.0 * d)
    for value, g in ((U, GRAD_U), (A, GRAD_A)):
        xx, xy, yy, xz, yz = here[:, g : g + 5].T
        for column, expected in zip(
            (*dx[:, value : value + 3].T, *dy[:, value : value + 3].T, *dz[:, value : value + 3].T),
            (xx, xy, xz, xy, yy, yz, xz, yz, -(xx + yy)),
            strict=True,
        ):
            assert np.abs(column - expected).max() < 1e-6
    assert np.abs(dt[:, U : U + 3] - here[:, A : A + 3]).max() < 1e-6
    assert np.abs(dt[:, A : A + 3] - here[:, J : J + 3]).max() < 1e-6
    for column, expected in ((dt[:, ETA], ETA_T), (dx[:, ETA], ETA_X), (dy[:, ETA], ETA_Y)):
        assert np.abs(column - here[:, expected]).max() < 1e-6


def check_field_is_free(stretching: str) -> None:
    """Divergence and rotation of what `kinematics` samples, by differences of 2 mm, good to (k d)^2 / 6 = 2e-7."""
    sea, d = Waves(**SEA.__dict__ | {"stretching": stretching}), 1e-3
    places = PLACES[PLACES[:, 2] < np.minimum(sea.elevation(33.3, PLACES[:, 0], PLACES[:, 1]), 0.0) - 0.1]

    def along(axis: int) -> np.ndarray:
        step = np.eye(3)[axis] * d
        return (sea.kinematics(33.3, places + step).velocity - sea.kinematics(33.3, places - step).velocity) / (2.0 * d)

    dx, dy, dz = (along(axis) for axis in range(3))
    assert np.abs(dx[:, 0] + dy[:, 1] + dz[:, 2]).max() < 1e-6
    for left, right in ((dz[:, 0], dx[:, 2]), (dz[:, 1], dy[:, 2]), (dy[:, 0], dx[:, 1])):
        assert np.abs(left - right).max() < 1e-6


@pytest.mark.parametrize("stretching", ["none", "linear", "vertical"])
def test_the_sampled_field_has_neither_sources_nor_rotation(stretching):
    check_field_is_free(stretching)


def test_a_stretched_field_is_not_free():
    """Wheeler's levels move with the surface, and the profile with them."""
    must_fail(check_field_is_free, "wheeler")


def test_one_wave():
    """Phase speed, amplitudes at the surface and at the bed, and pressure at the bed rho g A / cosh kh."""
    wave = Waves.regular(2.0, 9.0, depth=30.0, direction=0.7)
    w, k = 2.0 * np.pi / 9.0, float(wave.wavenumber[0])
    assert w**2 == pytest.approx(GRAVITY * k * np.tanh(k * 30.0), rel=1e-14)
    way = np.array([np.cos(0.7), np.sin(0.7)])
    times = np.linspace(0.0, 9.0, 37)
    moving = np.column_stack([np.outer(w / k * times, way), np.full(37, -5.0)])  # with the crest
    with_it = wave.kinematics(times, moving)
    assert with_it.elevation == pytest.approx(np.full(37, 1.0), abs=1e-12)
    bed = wave.kinematics(times, np.array([0.0, 0.0, -30.0]))
    assert np.abs(bed.velocity[:, 2]).max() < 1e-12
    assert bed.velocity[0, :2] == pytest.approx(w / np.sinh(k * 30.0) * way, rel=1e-12)
    assert bed.pressure[0] == pytest.approx(wave.density * wave.gravity / np.cosh(k * 30.0), rel=1e-12)
    assert bed.acceleration[9, :2] == pytest.approx(-w * w / np.sinh(k * 30.0) * np.sin(w * times[9]) * way, rel=1e-9)


def test_dispersion():
    """Newton's method to rounding, from shallow to deep water."""
    y = np.geomspace(1e-4, 100.0, 200)
    k = wavenumbers(np.sqrt(y * GRAVITY / 10.0), 10.0, GRAVITY) * 10.0
    assert np.abs(k * np.tanh(k) / y - 1.0).max() < 1e-13


def pole_forces(wave: Waves, ca: float) -> tuple[np.ndarray, np.ndarray]:
    """Forces across a pole on its lower and upper end in a wave, and those of the closed form, (n, 2)."""
    d, n, bottom, top = 0.5, 60, -55.0, -5.0
    pole = kind(
        diameter=d, mass_per_length=DENSITY * np.pi / 4.0 * d * d, axial_stiffness=1e11, transverse_drag=1.1,
        transverse_added_mass=ca, axial_damping_ratio=0.5,
    )  # fmt: skip
    # stretched by 1e-3, so that it hardly bends
    model = single(
        pole, (top - bottom) / 1.001, n, fixed(1, 0.0, 0.0, bottom), fixed(2, 0.0, 0.0, top), water_depth=60.0,
        waves=wave,
    )  # fmt: skip
    built = build(model)
    solve(built)
    block = run(built, 18.0, dt_out=0.25, time_step=0.02, tolerance=1e-6)
    z = np.linspace(bottom, top, n + 1)
    l = np.full(n + 1, (top - bottom) / n)
    l[[0, -1]] *= 0.5
    flow = wave.kinematics(block["time"][:, None], np.stack([0.0 * z, 0.0 * z, z], axis=-1))
    u, a = flow.velocity[..., 0], flow.acceleration[..., 0]
    load = l / 1.001 * (0.5 * DENSITY * 1.1 * d * np.abs(u) * u + DENSITY * np.pi / 4.0 * d * d * (1.0 + 1.0) * a)
    share = (z - bottom) / (top - bottom)
    closed = np.stack([(load * (1.0 - share)).sum(axis=1), (load * share).sum(axis=1)], axis=1)
    return block["end_force"][:, 0, :, 0], closed


def check_pole(ca: float) -> None:
    found, closed = pole_forces(Waves.regular(1.0, 9.0, depth=60.0, ramp=4.0), ca)
    late = slice(20, None)
    assert np.abs(found - closed)[late].max() < 1e-3 * np.abs(closed).max()


def test_force_on_a_pole():
    check_pole(1.0)


def test_other_added_mass_fails():
    must_fail(check_pole, 0.8)


def test_a_drifter_follows_the_water():
    """A small buoy of the water's density, on a slack weightless thread, goes round with the particle at its place."""
    wave = Waves.regular(0.5, 8.0, depth=40.0)
    k, depth = float(wave.wavenumber[0]), 10.0
    thread = kind(diameter=1e-3, mass_per_length=1e-3, axial_stiffness=1e3, transverse_drag=0.0)
    model = single(
        thread, 60.0, 4, fixed(1, 0.0, 0.0, -40.0), free(2, 0.0, 0.0, -depth, mass=DENSITY, volume=1.0, added_mass=0.5),
        water_depth=40.0, waves=wave, seabed_stiffness=0.0, seabed_damping=0.0,
    )  # fmt: skip
    built = build(model)
    built.state.position[-1] = 0.0, 0.0, -depth
    rest(built)
    start = wave.kinematics(0.0, np.array([0.0, 0.0, -depth])).velocity
    built.state.velocity[-1] = start
    block = run(built, 8.0, dt_out=0.1, time_step=0.02, tolerance=1e-8)
    path = block["point_position"][:, 1]
    across, up = (0.25 * f(k * 30.0) / np.sinh(k * 40.0) for f in (np.cosh, np.sinh))
    assert np.ptp(path[:, 0]) / 2.0 == pytest.approx(across, rel=0.05)
    assert np.ptp(path[:, 2]) / 2.0 == pytest.approx(up, rel=0.05)
