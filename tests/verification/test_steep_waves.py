"""Steep regular waves: what makes them waves, without the package that their harmonics come from.

Verifies: sea

A wave in water free of rotation fulfils two conditions at its surface: particles stay in it, w = eta_t + u eta_x, and
the pressure there is that of the air, phi_t + (u^2 + w^2) / 2 + g eta = constant. A stream function of 12 harmonics of
a wave of 9.3 m and 14.9 s in 70 m must fulfil both to 1e-8 of the largest vertical velocity and of g H; Stokes' fifth order to
the sixth power of its steepness k H / 2 = 0.094, times a constant of some hundreds: 2e-4. A linear wave of that height
must not. Of a wave of 2 cm nothing but the linear one may be left, to 1e-3, where k H / 2 is 2e-4, and the engine's sums must be those of
NumPy up to the crests.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail
from native_text import CHAIN

from moorage.errors import ModelError
from moorage.io import convert, read
from moorage.model import Waves
from moorage.physics.sea import RECORD, A, U, record_at, scratch_for
from moorage.system.sea import build_sea

pytest.importorskip("raschii")

HEIGHT, PERIOD, DEPTH = 9.3, 14.9, 70.0
G = 9.80665


def steep(theory: str, height: float = HEIGHT, **more) -> Waves:
    return Waves.steep(theory, height, PERIOD, depth=DEPTH, gravity=G, **more)  # type: ignore[arg-type]


def surface_conditions(waves: Waves) -> tuple[float, float]:
    """Largest faults of both conditions along a wave, over the vertical velocity and over g H."""
    k, d = float(waves.wavenumber[0]), 1e-4
    x = np.linspace(0.0, 2.0 * np.pi / k, 61)
    eta = waves.elevation(3.0, x)
    slope = (waves.elevation(3.0, x + d) - waves.elevation(3.0, x - d)) / (2.0 * d)
    rate = (waves.elevation(3.0 + d, x) - waves.elevation(3.0 - d, x)) / (2.0 * d)
    there = waves.kinematics(3.0, np.stack([x, 0.0 * x, eta], axis=-1))
    u, w = there.velocity[:, 0], there.velocity[:, 2]
    kinematic = np.abs(w - rate - u * slope).max() / np.abs(w).max()
    # the dynamic pressure is - rho (phi_t + speed^2 / 2): with rho g eta it must come to a constant
    dynamic = np.ptp(there.pressure / waves.density - G * eta) / (G * HEIGHT)
    return float(kinematic), float(dynamic)


@pytest.mark.parametrize(("theory", "allowed"), [("stream-function", 1e-8), ("stokes", 2e-4)])
def test_surface(theory, allowed):
    waves = steep(theory)
    assert max(surface_conditions(waves)) < allowed
    crest, trough = waves.elevation(0.0), waves.elevation(0.5 * PERIOD)
    assert crest - trough == pytest.approx(HEIGHT, rel=max(allowed, 1e-7))  # where the package's iteration stops
    assert crest > 1.07 * -trough


def check_linear(waves: Waves) -> None:
    assert max(surface_conditions(waves)) < 2e-4


def test_a_linear_wave_of_that_height_fails():
    must_fail(check_linear, Waves.regular(HEIGHT, PERIOD, depth=DEPTH, gravity=G, stretching="none"))


def test_a_low_wave_is_linear():
    low, plain = steep("stream-function", 0.02), Waves.regular(0.02, PERIOD, depth=DEPTH, gravity=G)
    places = np.array([[10.0, 0.0, -5.0], [-40.0, 3.0, -60.0]])
    for found, expected in zip(low.kinematics(2.0, places), plain.kinematics(2.0, places), strict=True):
        assert found == pytest.approx(expected, abs=1e-3 * np.abs(expected).max())


def test_the_water_is_at_rest_on_average():
    """Below the troughs; and phase and direction move the whole wave."""
    waves = steep("stream-function", direction=0.7, phase=0.5)
    t = np.linspace(0.0, PERIOD, 64, endpoint=False)
    assert np.abs(waves.kinematics(t, [3.0, 4.0, -20.0]).velocity.mean(axis=0)).max() < 1e-12
    along = 0.5 / float(waves.wavenumber[0]) * np.array([np.cos(0.7), np.sin(0.7)])
    assert waves.elevation(0.0, *along) == pytest.approx(steep("stream-function").elevation(0.0), rel=1e-12)


def test_the_engine_has_the_same_wave():
    waves = dataclasses.replace(steep("stream-function", direction=0.3))
    sea, out = build_sea(waves), np.zeros(RECORD)
    scratch = scratch_for(sea)
    for t, place in ((0.0, (0.0, 0.0, 4.9)), (1.0, (20.0, 5.0, -3.0)), (7.0, (60.0, -9.0, -60.0))):
        record_at(sea, place, t, 1.0, scratch, out)
        expected = waves.kinematics(t, place)
        assert place[2] < expected.elevation
        assert out[0] == pytest.approx(expected.elevation, abs=1e-8)
        assert out[U : U + 3] == pytest.approx(expected.velocity, abs=1e-8)
        assert out[A : A + 3] == pytest.approx(expected.acceleration, abs=1e-8)


TEXT = CHAIN.replace("depth: 100", "depth: 70").replace("{what}", "waves: {{spectrum: {what}}}")


def test_native_file(tmp_path):
    path = tmp_path / "model.yaml"
    path.write_text(TEXT.format(what="stream-function, height: 9.3, period: 14.9, direction: 90, order: 15"))
    waves = read(path).environment.waves
    assert len(waves.frequency) == 15
    assert waves.words == "stream-function, height 9.3 m, period 14.9 s, order 15"
    convert(path, tmp_path / "again.yaml")
    again = read(tmp_path / "again.yaml").environment.waves
    assert again == waves
    assert again.words == waves.words
    assert any("harmonics of a steep wave" in note for note in convert(path, tmp_path / "model.dat"))


@pytest.mark.parametrize(
    ("what", "message"),
    [
        ("stream-function, height: 21, period: 8", r"yaml:4: waves of 21 m and 8 s would break"),
        ("stokes, height: 9, period: 14.9, order: -1", "order of the waves must be positive"),
        ("stokes, height: 9, period: 14.9, gamma: 2", "gamma means nothing for stokes waves"),
        ("stream-function, height: 13.9, period: 8", r"yaml:4: there is no stream-function wave of 13.9 m and 8 s: "),
    ],
)
def test_bad_input(tmp_path, what, message):
    path = tmp_path / "model.yaml"
    path.write_text(TEXT.format(what=what))
    with pytest.raises(ModelError, match=message):
        read(path)


def test_without_the_package(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "raschii", None)
    path = tmp_path / "model.yaml"
    path.write_text(TEXT.format(what="stokes, height: 9.3, period: 14.9"))
    with pytest.raises(
        ModelError, match=r"stokes waves need the package raschii .*\n    -> pip install 'moorage\[waves\]'"
    ):
        read(path)
