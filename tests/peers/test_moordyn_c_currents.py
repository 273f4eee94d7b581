"""MoorDyn-C's water beside the currents that are read from the same files: Currents 2 and 5.

Both are linear between the same points, so that velocities must agree to rounding (1e-9), at any place and time within the
file's times; the levels here are whole, because it reads them in single precision. The first row of a grid, which
MoorDyn-C leaves out, is written twice. A current whose rows are in another order must not agree.
"""

from __future__ import annotations

import dataclasses
import warnings

import decks
import numpy as np
import pytest
from benchmarks.programs import call
from beside import needs, read

from moorage.io import convert
from moorage.model import CurrentGrid

pytestmark = needs("moordyn_c_nodes")

DURATION, OUT = 6.0, 0.1
PLACES = np.array([[x, y, z] for x in (-33.0, 0.0, 14.2) for y in (0.0, 7.0) for z in (-50.0, -37.3, -12.0, -1.0)])
RANDOM = np.random.default_rng(5)
Z, T = np.array([-40.0, -25.0, -10.0, 0.0]), np.array([0.0, 2.0, 4.0, 6.0, 8.0])


def profile(folder):
    """Write levels at uneven distances and five times, with two components."""
    flow = RANDOM.normal(size=(len(T), 2 * len(Z)))
    rows = [
        " ".join(map(str, Z)),
        "",
        *(" ".join(map(repr, [t, *row])) for t, row in zip(T.tolist(), flow.tolist(), strict=True)),
    ]
    (folder / "current_profile_dynamic.txt").write_text("a\nb\nc\nd\n" + "\n".join(rows) + "\n")


def grid(folder):
    axes = [-60.0, -10.0, 20.0], [-5.0, 10.0], Z.tolist(), [0.0, 3.0, 9.0]
    rows = [
        " ".join(map(repr, [x, y, z, t, *RANDOM.normal(size=3).tolist()]))
        for x in axes[0] for y in axes[1] for z in axes[2] for t in axes[3]
    ]  # fmt: skip
    head = [" ".join(str(len(axis)) for axis in axes), *(" ".join(map(repr, axis)) for axis in axes)]
    (folder / "current_profile_4d.txt").write_text("\n".join([*head, rows[0], *rows]) + "\n")


def water(folder, mode):
    """Return the current that is read from a mode's file, and MoorDyn-C's velocities at PLACES over time."""
    {2: profile, 5: grid}[mode](folder)
    options = {"dtM": 0.01, "TmaxIC": 0, "disableOutput": 1, "disableOutTime": 1}
    path = decks.write(decks.ROPE_IN_WAVES, folder, Currents=mode, **options)
    return read(path).environment.current, *theirs(path)


def theirs(path):
    time = OUT * np.arange(round(DURATION / OUT) + 1)
    held = np.tile([0.0, 0.0, -6.0], (len(time), 1, 1))
    return time, call("moordyn_c_nodes", model=str(path), time=time, position=held, places=PLACES)["water_velocity"]


def check(current, time, velocity) -> None:
    off = np.abs(current.at(time[1:, None], PLACES) - velocity[1:]).max()
    print(f"velocities differ by {off:.1e} m/s")
    assert off < 1e-9


@pytest.mark.parametrize("mode", [2, 5])
def test_current(tmp_path, mode):
    current, time, velocity = water(tmp_path, mode)
    assert isinstance(current, CurrentGrid)
    check(current, time, velocity)
    turned = dataclasses.replace(current, velocity=current.velocity[::-1])
    with pytest.raises(AssertionError):
        check(turned, time, velocity)


@pytest.mark.parametrize("mode", [2, 5])
def test_current_that_is_written(tmp_path, mode):
    {2: profile, 5: grid}[mode](tmp_path)
    path = decks.write(decks.ROPE_IN_WAVES, tmp_path, Currents=mode, dtM=0.01, TmaxIC=0, disableOutTime=1)
    other = tmp_path / "other"
    other.mkdir()
    current = read(path).environment.current
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        convert(path, other / "model.yaml")
        assert read(other / "model.yaml").environment.current == dataclasses.replace(current, file="")
        convert(other / "model.yaml", other / "model.dat")
    name = {2: "current_profile_dynamic.txt", 5: "current_profile_4d.txt"}[mode]
    (other / name).replace(tmp_path / name)
    check(current, *theirs(path))
