"""MoorDyn-C's wave grids beside the components that are read from the same files: WaveKin 2 and 3.

At the points and times of its grid MoorDyn-C does not interpolate the elevation, which must agree to 1e-6 of its largest
(its dispersion relation is good to 1.2e-7, and k x is up to 8). Velocities it interpolates in z, at the stretched level:
linear on steps of d they are good to (k d)^2 / 8, with k = 0.25 and d = 0.5 m that is 2e-3. A sum of sines instead must
not agree.
"""

from __future__ import annotations

import dataclasses

import decks
import numpy as np
import pytest
from benchmarks.programs import call
from beside import needs, read

pytestmark = needs("moordyn_c_nodes")

ROPE = decks.ROPE_IN_WAVES
OUT, PERIOD, DURATION = 0.1, 40.0, 6.0
PLACES = np.array([[x, y, z] for x in (-30.0, 0.0, 10.0) for y in (0.0, 10.0) for z in (-40.0, -12.0)])
GRID = "a\nb\nc\n1\n-40 -30 -20 -10 0 10\n1\n-10 0 10\n2\n-60 0 121\n"


def frequencies(folder):
    """Write steps of 2 pi / 40 s up to the rate that makes MoorDyn-C's own interval 0.1 s."""
    step, count = 2.0 * np.pi / PERIOD, round(PERIOD / OUT / 2)
    parts = {3: (0.5, 0.2, 0.0), 4: (0.9, -0.8, 0.4), 5: (0.3, 0.1, 0.8), 9: (0.0, 0.2, 0.0)}
    rows = [(0.0, 0.0, 0.0, 0.0)] + [(step * k, *parts.get(k, (0.0, 0.0, 0.0))) for k in (*range(1, 12), count)]
    (folder / "wave_frequencies.txt").write_text("".join(" ".join(f"{x:.17g}" for x in row) + "\n" for row in rows))


def elevation(folder):
    time = OUT * np.arange(round(PERIOD / OUT) + 1)
    eta = np.cos(2.0 * np.pi * 4.0 / PERIOD * time + 0.3) + 0.4 * np.sin(2.0 * np.pi * 7.0 / PERIOD * time)
    np.savetxt(folder / "wave_elevation.txt", np.column_stack([time, eta]), fmt="%.15f")


def water(folder, mode):
    """Return the sea that is read from a mode's files, and what MoorDyn-C makes of them at PLACES over time."""
    {2: frequencies, 3: elevation}[mode](folder)
    (folder / "water_grid.txt").write_text(GRID)
    options = {"dtM": 0.001, "TmaxIC": 0, "disableOutput": 1, "disableOutTime": 1}
    path = decks.write(ROPE, folder, WaveKin=mode, dtWave=OUT, **options)
    time = OUT * np.arange(round(DURATION / OUT) + 1)
    held = np.tile([0.0, 0.0, -6.0], (len(time), 1, 1))
    theirs = call("moordyn_c_nodes", model=str(path), time=time, position=held, places=PLACES)
    return read(path).environment.waves, time, theirs


def check(waves, time, theirs) -> None:
    ours = waves.kinematics(time[1:, None], PLACES)
    eta, velocity = theirs["elevation"][1:], theirs["water_velocity"][1:]
    off = np.abs(ours.elevation - eta).max() / np.abs(eta).max()
    print(
        f"elevation differs by {off:.1e}, velocity by {np.abs(ours.velocity - velocity).max() / np.abs(velocity).max():.1e}"
    )
    assert off < 1e-6
    assert np.abs(ours.velocity - velocity).max() < 2e-3 * np.abs(velocity).max()


@pytest.mark.parametrize("mode", [2, 3])
def test_grid(tmp_path, mode):
    waves, time, theirs = water(tmp_path, mode)
    check(waves, time, theirs)
    sines = dataclasses.replace(waves, phase=tuple(np.array(waves.phase) - 0.5 * np.pi))
    with pytest.raises(AssertionError):
        check(sines, time, theirs)
