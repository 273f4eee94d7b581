"""Wave files that cannot be used: one error each, with file, line, value and remedy."""

from __future__ import annotations

import warnings

import pytest
from moorings import spread
from native_text import CHAIN as TEXT

from moorage.errors import ModelError, ModelWarning, UnsupportedError
from moorage.io import read
from moorage.model import Waves
from moorage.model.checks import problems_of, suspicious
from moorage.model.unbuilt import refuse_unbuilt

GOOD = {
    "wave_frequencies.txt": "0 0 0\n0.35 1 0\n0.4 0 0\n",
    "wave_elevation.txt": "0 0\n1 1\n2 0\n3 -1\n4 0\n",
    "water_grid.txt": "a\nb\nc\n2\n-900 900 10\n0\n0\n2\n-200 0 20\n",
    "w.dat": "a\n-\n--- WAVES ---\n1 mod\nwave_elevation.txt f\n0.5 dt\n0 dir\n2\n-900, 900, 9\n0\n0\n2\n-200, 0, 9\n"
    "--- CURRENT ---\n0 CurrentMod\n--- end ---\n",
}
CASES = {
    "negative frequency": (
        "7 WaveKin", "wave_frequencies.txt", ("0.35 1 0", "-0.35 1 0"),
        r"wave_frequencies.txt:2: frequency of a wave component is negative \(read: -0.35\)\n    -> make it positive",
    ),
    "not a number": ("7 WaveKin", "wave_frequencies.txt", ("0.35 1 0", "0.35 one 0"), r"wave_frequencies.txt:2: row of"),
    "first row not a number": ("7 WaveKin", "wave_frequencies.txt", ("0 0 0", "0 x 0"), r"wave_frequencies.txt:1: row of"),
    "two columns": ("2 WaveKin", "wave_frequencies.txt", ("0.35 1 0", "0.35 1"), r"frequencies.txt:2: .* 3 or 4 numbers"),
    "direction in degrees": (
        "7 WaveKin", "wave_frequencies.txt", ("0.35 1 0", "0.35 1 0 90"), r"txt:2: direction .* not in rad \(read: 90",
    ),
    "unsorted for a transform": ("2 WaveKin", "wave_frequencies.txt", ("0.4 0 0", "0.3 0 0"), "do not increase"),
    "too fine for a transform": ("2 WaveKin", "wave_frequencies.txt", ("0.4 0 0", "0.3500001 0 0"), "smallest step"),
    "time not from 0": ("3 WaveKin", "wave_elevation.txt", ("0 0\n", "0.5 0\n"), r"elevation.txt:1: .* start at 0 s"),
    "time not increasing": ("3 WaveKin", "wave_elevation.txt", ("3 -1", "2 -1"), r"elevation.txt:4: times"),
    "wide steps": ("3 WaveKin\n2 dtWave", "wave_elevation.txt", None, "dtWave leaves fewer than 4"),
    "no step": ("3 WaveKin\n0 dtWave", "wave_elevation.txt", None, r"model.dat:21: dtWave must be positive \(read: '0'"),
    "short grid file": ("3 WaveKin", "water_grid.txt", ("2\n-200 0 20\n", ""), "wave grid has 7 lines, not 9"),
    "kind of axis": ("3 WaveKin", "water_grid.txt", ("10\n0\n0", "10\n5\n0"), r"water_grid.txt:6: type of the wave grid's y"),
    "no axis": ("2 WaveKin", "water_grid.txt", ("-900 900 10", "wide"), r"water_grid.txt:5: x of the wave grid"),
    "axis backwards": ("2 WaveKin", "water_grid.txt", ("-900 900 10", "900 -900 10"), r"water_grid.txt:5: x of the"),
    "no elevation file": ("w.dat WaterKin", "w.dat", ("wave_elevation.txt", '""'), r"w.dat:5: WaveKinFile is empty"),
    "missing elevation file": ("w.dat WaterKin", "w.dat", ("elevation.txt", "x.txt"), r"w.dat:5: .*not found: tried"),
    "few rows": ("w.dat WaterKin", "w.dat", ("0\n0\n2\n-200, 0, 9\n", ""), r"w.dat:4: section WAVES has 6 rows, not 10"),
    "heading": ("w.dat WaterKin", "w.dat", ("0 dir", "east dir"), r"w.dat:7: WaveDir is not a number \(read: 'east'"),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_wave_error(deck, tmp_path, name):
    option, file, change, message = CASES[name]
    for other, text in GOOD.items():
        (tmp_path / other).write_text(text)
    model = deck(("0.001    dtM       time step", f"0.001    dtM       time step\n{option}"))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        if change:
            read(model)  # as it stands it is well
            assert change[0] in GOOD[file]
            (tmp_path / file).write_text(GOOD[file].replace(*change, 1))
        with pytest.raises(ModelError, match=message) as raised:
            read(model)
    assert len(raised.value.problems) == 1


@pytest.mark.parametrize(
    ("mode", "file"), [(2, "wave_frequencies.txt"), (3, "wave_elevation.txt"), (7, "wave_frequencies.txt")]
)
def test_missing_files(deck, mode, file):
    with pytest.raises(ModelError, match=rf"model.dat:20: table of wave \w+ not found: tried .*{file}"):
        read(deck(("0.001    dtM       time step", f"0.001    dtM       time step\n{mode} WaveKin")))


@pytest.mark.parametrize("mode", [4, 5, 6])
def test_modes_without_files_are_refused_by_name(deck, mode):
    model = read(deck(("0.001    dtM       time step", f"0.001    dtM       time step\n{mode} WaveKin")))
    with pytest.raises(
        UnsupportedError, match=rf"model.dat:20: waves of WaveKin {mode} are not simulated yet \(read: '{mode}'"
    ):
        refuse_unbuilt(model)


def test_a_current_below_the_seabed_is_told(deck, tmp_path):
    (tmp_path / "current_profile.txt").write_text("a\nb\nc\n-230 0.1\n0 1\n")
    with pytest.warns(ModelWarning, match=r"current_profile.txt: the current's lowest level, -230 m, is 30 m below"):
        read(deck(("0.001    dtM       time step", "0.001    dtM       time step\n1 Currents")))
    (tmp_path / "current_profile.txt").write_text("a\nb\nc\n-200 0.1\n0 1\n")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read(deck(("0.001    dtM       time step", "0.001    dtM       time step\n1 Currents")))


TABLE = "waves: {{density: {{x: [{x}], y: [{y}]}}}}"
WAVES = "waves: {{frequency: [{w}], amplitude: [1], phase: [0], direction: [0]{more}}}"
NATIVE = {
    "negative frequency": (WAVES.format(w="-0.5", more=""), r"yaml:4: frequency of a wave component must be positive .*-0.5"),
    "no direction": ("waves: {frequency: [1], amplitude: [1], phase: [0]}", r"yaml:4: direction of waves .* is missing"),
    "fewer directions": (WAVES.format(w="0.5, 0.6", more=""), r"do not have one of each .*2 of frequency, 1 of amplitude"),
    "half a steep wave": (WAVES.format(w="0.5", more=", crests: [1]"), "need wavenumbers and crests"),
    "harmonics": (WAVES.format(w="0.5", more=", crests: [1, 2], wavenumbers: [1]"), "2 of crests, 1 of frequency"),
    "negative in a table": (TABLE.format(x="-0.1, 0.5", y="0, 1"), r"yaml:4: frequency of the spectrum must .*read: -0.1"),
    "unsorted table": (TABLE.format(x="0.5, 0.4", y="0, 1"), "frequencies of the spectrum do not increase"),
    "negative density": (TABLE.format(x="0.4, 0.5", y="-1, 1"), r"densities of the spectrum .*read: -1.0"),
    "a number": ("waves: {density: 3}", r"spectrum is not a table \(read: 3.0\)\n    -> give x, frequencies in rad/s"),
    "steep table": (TABLE.format(x="1.0, 1.1, 1.2", y="0, 90, 0"), r"waves of 12 m and 5.71\d* s would break"),
    "breaking": ("waves: {spectrum: jonswap, height: 9, period: 5}", r"waves of 9 m and 5 s would break: they are 39 m"),
}  # fmt: skip


def native(tmp_path, what):
    path = tmp_path / "model.yaml"
    path.write_text(TEXT.format(what=what))
    return read(path)


@pytest.mark.parametrize("name", NATIVE)
def test_native_wave_error(tmp_path, name):
    what, message = NATIVE[name]
    with pytest.raises(ModelError, match=message) as raised:
        native(tmp_path, what)
    assert len(raised.value.problems) == 1


@pytest.mark.parametrize(("height", "steep"), [(6.2, False), (6.5, True)])
def test_a_sea_that_is_too_steep_is_doubted(tmp_path, height, steep):
    """At 8 s a fifteenth of 1.56 Tp^2 is 6.66 m; at 7.5 s 5.85 m, and waves break above 12.5 m."""
    model = native(tmp_path, f"waves: {{spectrum: jonswap, height: {height}, period: {7.8}}}")
    doubts = [str(problem) for problem in suspicious(model)]
    assert any("steeper than seas are" in doubt for doubt in doubts) is steep
    if steep:
        assert any(
            "model.yaml:4: a sea of Hs 6.5 m and Tp 7.8 s" in doubt and "at most 6.33 m" in doubt for doubt in doubts
        )


def test_waves_made_in_python_are_checked_too():
    waves = Waves(frequency=(0.5, -0.6), amplitude=(1.0,), phase=(0.0, 0.0), direction=(0.0, 0.0), depth=-5.0)
    messages = [problem.message for problem in problems_of(spread(5, waves=waves, host_waves=True))]
    assert [m for m in messages if "wave" in m] == [
        "waves are given by the model and by a host",
        "components of the waves do not have one of each",
        "frequency of a wave component must be positive",
        "depth of the waves must be positive",
    ]
