"""Seas from spectra: energy, peak and direction are those asked for.

Verifies: sea

A spectrum's components carry the energy of the band that they are cut from, whatever the way of cutting: its significant
height over that band is theirs to rounding. JONSWAP between 0.5 and 3.5 peak frequencies holds more than 98.5 % of the
height that was asked for. Of N seeds of a sea with random directions by cos^2s, the mean direction is that asked for
within 4 standard errors, and the spread is 1 - s / (s + 1) (first circular moment s / (s + 1)).

The elevation in time has zero mean, a variance of sum A^2 / 2 within what M independent half periods allow (4 sigma), and
comes back with its seed. Over 60 seeds of 1024 s, significant height, mean period between zero crossings and peak period
of the elevation must be those of the spectrum within limits that hold with 99.9 % confidence. Equal frequencies repeat after 2 pi / bin; random ones do not.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail

from moorage.model import Waves
from moorage.model.spectra import gamma_by_rule, jonswap, ochi_hubble, pierson_moskowitz

HEIGHT, PERIOD, DEPTH = 8.25, 14.5, 200.0


def moment(density, low: float, high: float, order: int = 0) -> float:
    w = np.linspace(low, high, 200_001)
    return float(np.trapezoid(density(w) * w**order, w))


def test_spectra_have_their_height_and_peak():
    peak = 2.0 * np.pi / PERIOD
    for density in (
        lambda w: jonswap(w, HEIGHT, PERIOD, 3.3),
        lambda w: jonswap(w, HEIGHT, PERIOD, 1.0),
        lambda w: pierson_moskowitz(w, HEIGHT, PERIOD),
        lambda w: ochi_hubble(w, ((HEIGHT, PERIOD, 3.0),)),
    ):
        assert 4.0 * np.sqrt(moment(density, 0.2 * peak, 20.0 * peak)) == pytest.approx(HEIGHT, rel=1e-3)
        w = np.linspace(0.5 * peak, 2.0 * peak, 20_001)
        assert w[np.argmax(density(w))] == pytest.approx(peak, rel=1e-3)


def test_jonswap_without_a_bump_is_pierson_moskowitz():
    w = np.linspace(0.25, 2.0, 50)
    assert jonswap(w, HEIGHT, PERIOD, 1.0) == pytest.approx(pierson_moskowitz(w, HEIGHT, PERIOD), rel=1e-3)


def test_two_parts_of_ochi_and_hubble_add_up():
    w = np.linspace(0.2, 3.0, 50)
    parts = (6.0, 15.0, 3.0), (2.0, 7.0, 1.0)
    assert ochi_hubble(w, parts) == pytest.approx(sum(ochi_hubble(w, (part,)) for part in parts))


def test_peakedness_by_rule():
    """DNV-RP-C205: 5 for steep seas, 1 for gentle ones."""
    assert gamma_by_rule(16.0, 3.5 * 4.0) == 5.0
    assert gamma_by_rule(16.0, 5.1 * 4.0) == 1.0
    assert gamma_by_rule(16.0, 4.3 * 4.0) == pytest.approx(np.exp(5.75 - 1.15 * 4.3))


def check_energy(method: str, count: int, height: float) -> None:
    sea = Waves.irregular("jonswap", HEIGHT, PERIOD, depth=DEPTH, method=method, components=count, gamma=3.3)
    peak = 2.0 * np.pi / PERIOD
    band = 4.0 * np.sqrt(moment(lambda w: jonswap(w, height, PERIOD, 3.3), 0.5 * peak, 3.5 * peak))
    assert sea.significant_height == pytest.approx(band, rel=1e-6)
    assert band > 0.985 * height


@pytest.mark.parametrize("method", ["random", "equal-energy", "equal-frequency"])
@pytest.mark.parametrize("count", [26, 200])
def test_components_carry_the_energy(method, count):
    check_energy(method, count, HEIGHT)


def test_other_height_fails():
    must_fail(check_energy, "random", 200, 1.01 * HEIGHT)


def test_achieved_peak():
    for seed in range(5):
        sea = Waves.irregular("jonswap", HEIGHT, PERIOD, depth=DEPTH, gamma=3.3, components=400, seed=seed)
        assert sea.peak_period == pytest.approx(PERIOD, rel=0.03)


def check_spreading(s: float, mean: float, stated: float) -> None:
    seas = [
        Waves.irregular("jonswap", HEIGHT, PERIOD, depth=DEPTH, direction=mean, spreading=s, seed=seed)
        for seed in range(40)
    ]
    first = np.array([np.mean(np.exp(1j * (np.array(sea.direction) - stated))) for sea in seas])
    error = first.std() / np.sqrt(len(first))
    assert abs(first.mean().imag) < 4.0 * max(error, 1e-3)
    assert first.mean().real == pytest.approx(s / (s + 1.0), abs=4.0 * max(error, 1e-3))


@pytest.mark.parametrize("s", [2.0, 10.0, 50.0])
def test_spreading(s):
    check_spreading(s, 1.0, 1.0)


def test_other_direction_fails():
    must_fail(check_spreading, 10.0, 1.0, 1.1)


SEEDS, INTERVAL, SAMPLES = 60, 1.0, 1024


def check_statistics(height: float, period: float) -> None:
    """Hs, Tz = 2 pi sqrt(m0 / m2) and Tp from time series, each mean within t(59) = 3.5 standard errors.

    The sampling of 1 s takes off (w dt)^2 / 24 of the crossings' frequency and the band misses 1 % of the height: both
    are taken from the same band of the spectrum. The peak of the mean periodogram is found to half of a
    bin and to what 60 seeds leave of its scatter, 4 %.
    """
    time = INTERVAL * np.arange(SAMPLES)
    heights, crossings, powers = [], [], []
    for seed in range(SEEDS):
        eta = Waves.irregular("jonswap", HEIGHT, PERIOD, depth=DEPTH, gamma=3.3, seed=seed).elevation(time)
        heights.append(4.0 * eta.std())
        up = np.count_nonzero((eta[:-1] < 0.0) & (eta[1:] >= 0.0))
        crossings.append(SAMPLES * INTERVAL / up)
        powers.append(np.abs(np.fft.rfft(eta)) ** 2)
    peak = 2.0 * np.pi / period
    band = [moment(lambda w: jonswap(w, height, period, 3.3), 0.5 * peak, 3.5 * peak, order) for order in (0, 2)]
    for found, expected in ((heights, 4.0 * np.sqrt(band[0])), (crossings, 2.0 * np.pi * np.sqrt(band[0] / band[1]))):
        error = np.std(found, ddof=1) / np.sqrt(SEEDS)
        print(f"{np.mean(found):.3f} +- {3.5 * error:.3f}, expected {expected:.3f}")
        assert abs(np.mean(found) - expected) < 3.5 * error + 0.002 * expected
    smooth = np.convolve(np.mean(powers, axis=0), np.hanning(9), "same")
    frequency = np.fft.rfftfreq(SAMPLES, INTERVAL)[np.argmax(smooth)]
    assert 1.0 / frequency == pytest.approx(period, rel=0.04)


def test_statistics_of_many_seeds():
    check_statistics(HEIGHT, PERIOD)


@pytest.mark.parametrize(("height", "period"), [(1.03 * HEIGHT, PERIOD), (HEIGHT, 1.05 * PERIOD)])
def test_another_sea_fails(height, period):
    must_fail(check_statistics, height, period)


def test_elevation_in_time():
    heights = []
    for seed in range(8):
        sea = Waves.irregular("jonswap", HEIGHT, PERIOD, depth=DEPTH, gamma=3.3, seed=seed)
        eta = sea.elevation(np.arange(0.0, 3600.0, 1.0))
        heights.append(4.0 * eta.std())
        assert abs(eta.mean()) < 0.1
    # some 2 * 3600 / PERIOD independent half periods in each
    error = HEIGHT / np.sqrt(2.0 * 8 * 2.0 * 3600.0 / PERIOD)
    assert abs(np.mean(heights) - sea.significant_height) < 4.0 * error
    again = Waves.irregular("jonswap", HEIGHT, PERIOD, depth=DEPTH, gamma=3.3, seed=7)
    assert again == sea
    assert again.amplitude == sea.amplitude


@pytest.mark.parametrize(("method", "repeats"), [("equal-frequency", True), ("random", False)])
def test_equal_frequencies_repeat_and_random_ones_do_not(method, repeats):
    """Bins from 0.5 to 3.5 peaks, with the middle of each: all frequencies are multiples of peak / 100."""
    t = np.arange(0.0, 60.0, 1.0)
    sea = Waves.irregular("jonswap", HEIGHT, PERIOD, depth=DEPTH, components=50, method=method)
    change = np.abs(sea.elevation(t + 100.0 * PERIOD) - sea.elevation(t)).max()
    assert (change < 1e-6 * HEIGHT) == repeats


def test_ramp():
    sea = Waves.regular(2.0, 8.0, depth=50.0, ramp=20.0)
    full = Waves.regular(2.0, 8.0, depth=50.0)
    assert sea.elevation(0.0) == 0.0
    assert sea.elevation(10.0) == pytest.approx(0.5 * full.elevation(10.0))
    assert sea.elevation(25.0) == pytest.approx(full.elevation(25.0))
