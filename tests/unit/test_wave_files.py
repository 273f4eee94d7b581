"""MoorDyn's wave files become components: its conventions, its grids' extents, and what is written back."""

from __future__ import annotations

import dataclasses
import warnings

import numpy as np
import pytest

from moorage.errors import ModelWarning
from moorage.io import read
from moorage.io.moordyn.writer import write_moordyn
from moorage.model import Waves

TIME = np.linspace(0.0, 120.0, 481)
ROWS = "0.0 0.0 0.0\n0.35 1.0 0.0 0.0\n0.4 0.5 1.0 1.57\n0.6 0.0 0.0\n"
GRID = "grid\nof\npoints\n{x}\n1\n-2 -1 0 1 2\n2\n-200 0 41\n"
EVERYWHERE = "1\n-900 0 100"


def waves_of(deck, *options):
    given = "\n".join(("", *options))
    return read(deck(("0.001    dtM       time step", "0.001    dtM       time step" + given))).environment.waves


def test_components_are_sines(deck, tmp_path):
    """WaveKin 7: eta = sum |A| sin(w t - k x + arg A), so that a real amplitude starts at 0."""
    (tmp_path / "wave_frequencies.txt").write_text(ROWS)
    waves = waves_of(deck, "7 WaveKin")
    expected = np.sin(0.35 * TIME) + np.hypot(0.5, 1.0) * np.sin(0.4 * TIME + np.arctan2(1.0, 0.5))
    assert np.allclose(waves.elevation(TIME), expected, atol=1e-12)
    assert waves.direction == (0.0, 1.57)
    assert waves.source.file.endswith("wave_frequencies.txt")
    assert (waves.depth, waves.gravity, waves.stretching) == (200.0, 9.80665, "wheeler")


def test_a_transform_is_of_cosines_and_linear_between_rows(deck, tmp_path):
    """WaveKin 2: steps of 0.05 rad/s, with complex amplitudes and directions linear between the rows."""
    (tmp_path / "wave_frequencies.txt").write_text(ROWS)
    waves = waves_of(deck, "2 WaveKin")
    even = 0.05 * np.arange(1, 13)
    amplitude = np.interp(even, [0.0, 0.35, 0.4, 0.6], [0.0, 1.0, 0.5 + 1.0j, 0.0])
    expected = (amplitude * np.exp(1j * TIME[:, None] * even)).real.sum(axis=1)
    assert np.allclose(waves.elevation(TIME), expected, atol=1e-12)
    assert waves.direction == pytest.approx(np.interp(even[:-1], [0.35, 0.4, 0.6], [0.0, 1.57, 0.0]))


def elevation_file(tmp_path, mean=0.0, step=0.25):
    """Write two waves of 12 and 8 s over their common period, and return their elevation over time."""
    time = step * np.arange(int(120.0 / step) + 1)

    def elevation(t):
        return np.cos(2 * np.pi / 12.0 * t + 0.3) + 0.4 * np.sin(2 * np.pi / 8.0 * t)

    np.savetxt(tmp_path / "wave_elevation.txt", np.column_stack([time, elevation(time) + mean]), fmt="%.12f")
    return elevation


def test_an_elevation_becomes_its_components(deck, tmp_path):
    elevation = elevation_file(tmp_path)
    waves = waves_of(deck, "3 WaveKin", "0.25 dtWave")
    assert 2.0 * np.pi / np.array(waves.frequency) == pytest.approx([12.0, 8.0])
    later = TIME + 1234.5  # it repeats
    assert np.allclose(waves.elevation(later), elevation(later), atol=1e-10)


@pytest.mark.parametrize(
    ("step", "interval", "period", "warning"),
    [
        (
            0.25,
            "2.5",
            4.0,
            r"1 of the energy of the waves \(m0\) is faster than dtWave 2.5 s can tell; give dtWave 1 s",
        ),
        (0.5, "0.5", 1.25, "0.99 of the energy of the waves .* is faster than 0.5 Hz and left out.*WaveKin 7"),
        (2.0, "0.25", 6.0, r"0.5 of the energy .* is lost between the rows of the file, 2 s apart.*or dtWave 2 s"),
    ],
)
def test_lost_energy_is_told(deck, tmp_path, step, interval, period, warning):
    """Between rows h apart a linear elevation keeps (2 + cos w h) / 3 of the energy: half of it of 6 s at 2 s."""
    time = step * np.arange(int(120.0 / step) + 1)
    np.savetxt(tmp_path / "wave_elevation.txt", np.column_stack([time, np.cos(2 * np.pi / period * time)]))
    with pytest.warns(ModelWarning, match=f"wave_elevation.txt: {warning}"):
        waves_of(deck, "3 WaveKin", f"{interval} dtWave")


def test_no_energy_is_lost_at_the_own_interval_of_a_file(deck, tmp_path):
    elevation_file(tmp_path)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for interval in ("0.25", "0.5", "1"):
            waves_of(deck, "3 WaveKin", f"{interval} dtWave")


def test_a_mean_level_is_left_out(deck, tmp_path):
    elevation = elevation_file(tmp_path, mean=0.5)
    with pytest.warns(ModelWarning, match=r"mean level of the waves, 0\.5 m, is left out"):
        waves = waves_of(deck, "3 WaveKin")
    assert np.allclose(waves.elevation(TIME), elevation(TIME), atol=1e-10)


def test_waves_of_f(deck, tmp_path):
    """WaveKinMod 1, which older files call 3, with a heading in degrees."""
    elevation = elevation_file(tmp_path)
    grid = "2 - x\n-900, 0, 37 - data\n2 - y\n-900, 900, 2\n2 - z\n-200, 0, 36 - data"
    water = f"a\n-\n--- WAVES ---\n{{}} mod\nwave_elevation.txt file\n0.25 dtWave\n30 WaveDir\n{grid}\n"
    for mode in (1, 3):
        (tmp_path / "w.dat").write_text(water.format(mode) + "--- CURRENT ---\n0 CurrentMod\n--- end ---\n")
        waves = waves_of(deck, "w.dat WaterKin")
        assert np.allclose(waves.elevation(TIME), elevation(TIME), atol=1e-10)
        assert set(waves.direction) == {np.pi / 6}
        assert waves.asked == (("spectrum", f"wave_elevation.txt by WaveKinMod {mode}"),)


def test_a_grid_is_only_measured(deck, tmp_path):
    (tmp_path / "wave_frequencies.txt").write_text("0 0 0\n0.35 1 0\n0.4 0 0\n")
    (tmp_path / "water_grid.txt").write_text(GRID.format(x=EVERYWHERE))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        covered = waves_of(deck, "2 WaveKin")
    (tmp_path / "water_grid.txt").write_text(GRID.format(x="2\n-800 -50.0 76"))
    with pytest.warns(ModelWarning, match=r"x by 37\.6 m \(grid -800 to -50 m, model -837\.6 to -40\.868 m\)"):
        short = waves_of(deck, "2 WaveKin")
    assert covered == short


def test_what_only_a_grid_needs_is_not_used(deck, tmp_path):
    (tmp_path / "wave_frequencies.txt").write_text(ROWS)
    elevation_file(tmp_path)
    for mode, unused in ((7, True), (2, True), (3, False)):
        options = f"0.001    dtM       time step\n{mode} WaveKin\n0.25 dtWave\n1 UnifyCurrentGrid"
        names = [option.name for option in read(deck(("0.001    dtM       time step", options))).unused_options]
        assert ("dtWave" in names) == unused
        assert "UnifyCurrentGrid" in names


def test_waves_without_any_amplitude_are_none(deck, tmp_path):
    (tmp_path / "wave_frequencies.txt").write_text("0 0 0\n0.35 0 0\n")
    assert waves_of(deck, "7 WaveKin") is None


def test_waves_are_written_for_c(deck, tmp_path):
    (tmp_path / "wave_frequencies.txt").write_text(ROWS)
    model = read(deck(("0.001    dtM       time step", "0.001    dtM       time step\n2 WaveKin")))
    folder = tmp_path / "out"
    folder.mkdir()
    notes = write_moordyn(model, folder / "c.dat", "C")
    assert any("wave_frequencies.txt" in note for note in notes)
    again = read(folder / "c.dat").environment.waves
    assert np.allclose(again.elevation(TIME), model.environment.waves.elevation(TIME), atol=1e-12)
    assert again.direction == model.environment.waves.direction
    assert any("waves cannot be said for MoorDyn-F" in note for note in write_moordyn(model, folder / "f.dat", "F"))


def test_directions_beyond_a_turn_are_written_within_it(deck, tmp_path):
    waves = Waves.regular(2.0, 8.0, depth=200.0, direction=7.0)
    model = read(deck())
    model = dataclasses.replace(model, environment=dataclasses.replace(model.environment, waves=waves))
    write_moordyn(model, tmp_path / "c.dat", "C")
    assert read(tmp_path / "c.dat").environment.waves.direction == pytest.approx((7.0 - 2.0 * np.pi,))


def test_both_flavours_of_the_umbilical_have_one_sea(reference):
    """The files of the reference runs: MoorDyn-C's sines and MoorDyn-F's elevation, written with 12 digits and 1e-9 m."""
    folder = reference / "rm3_umbilical" / "jonswap"
    time, elevation = np.loadtxt(folder / "wave_elevation.txt").T
    for name in ("moordyn_C.dat", "moordyn_F.dat"):
        waves = read(folder / name).environment.waves
        assert len(waves.frequency) == 26
        assert waves.significant_height == pytest.approx(8.25, abs=1e-3)
        assert np.abs(waves.elevation(time) - elevation).max() < 26 * 0.5e-9 + 1e-9
