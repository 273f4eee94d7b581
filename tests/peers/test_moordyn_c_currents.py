"""MoorDyn-C live in the same currents that change, Currents 2 and 5, and with the same water of a host, WaveKin 1.

Both are linear between the same points, so that velocities must agree to rounding (1e-9), at any place and time within the
file's times; the levels here are whole, because it reads them in single precision. The first row of a grid, which
MoorDyn-C leaves out, is written twice. A current whose rows are in another order must not agree.

Forces on a rope in a current that changes must agree as they do at rest, and nodes in water that a host sets at each
step of 0.1 s: both programs hold it over the step. A current half a second late, and water that does not accelerate,
must not.
"""

from __future__ import annotations

import dataclasses
import warnings

import decks
import numpy as np
import pytest
from benchmarks.programs import call
from beside import needs, read

import moorage
from moorage.io import convert
from moorage.model import CurrentGrid
from moorage.solve.march import March, Settings
from moorage.solve.statics import solve
from moorage.system.build import build

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


# --- what the water does to a line -----------------------------------------------------------------------------------

FINE = {"dtM": 0.002, "tScheme": "rk4", "dtIC": 1.0, "TmaxIC": 60, "disableOutput": 1, "disableOutTime": 1}


def tidal(folder) -> None:
    """Write a current that comes and goes in 40 s, along and across the line."""
    rows = ["-60 -30 0", ""]
    for t in np.arange(0.0, 61.0, 2.0).tolist():
        along, across = 0.8 * np.sin(2.0 * np.pi * t / 40.0) ** 2, 0.5 * np.sin(2.0 * np.pi * t / 40.0)
        rows.append(
            " ".join(map(str, (t, *(along * s for s in (0.3, 0.6, 1.0)), *(across * s for s in (0.2, 0.6, 1.0)))))
        )
    (folder / "current_profile_dynamic.txt").write_text("a\nb\nc\nd\n" + "\n".join(rows) + "\n")


@pytest.fixture(scope="module")
def swayed(tmp_path_factory):
    """The model, and MoorDyn-C's force on the top in that current every 0.1 s for 50 s."""
    folder = tmp_path_factory.mktemp("tidal")
    tidal(folder)
    path = decks.write(decks.ROPE_IN_WAVES, folder, Currents=2, **FINE)
    time = OUT * np.arange(501)
    held = np.tile([0.0, 0.0, -6.0], (len(time), 1, 1))
    return read(path), call("moordyn_c_nodes", model=str(path), time=time, position=held)["end_force"][:, 0]


def check_force(swayed, later: float = 0.0) -> None:
    """Once the starts are over, within 1e-4 of 20 kN (4e-5 measured), which is 2e-3 of what the current changes."""
    model, other = swayed
    current = model.environment.current
    current = dataclasses.replace(current, t=tuple(t + later for t in current.t))
    built = build(dataclasses.replace(model, environment=dataclasses.replace(model.environment, current=current)))
    solve(built)
    march = March(built, Settings(tolerance=1e-4, dt_out=OUT), 50.0)
    ours = np.concatenate([march.first()["end_load"], march.advance(50.0)["end_load"]])[:, 0, 1]
    off = np.abs(np.abs(ours) - np.abs(other)).max(axis=1)[300:]
    print(f"force on the top differs by {off.max():.2f} N of {np.linalg.norm(other, axis=1).mean():.0f} N")
    assert off.max() < 1e-4 * np.linalg.norm(other, axis=1).mean()


def test_force_in_a_current_that_changes(swayed):
    check_force(swayed)


def test_a_current_half_a_second_late_fails(swayed):
    with pytest.raises(AssertionError):
        check_force(swayed, 0.5)


def held_water(steps: int) -> np.ndarray:
    """Velocity and acceleration of the water in each step of OUT, (steps, 2, 3)."""
    t = OUT * np.arange(steps)[:, None]
    w, way = 2.0 * np.pi / 8.0, np.array([0.6, 1.0, 0.2])
    return np.stack([np.sin(w * t) * way, w * np.cos(w * t) * way], axis=1)


@pytest.fixture(scope="module")
def hosted(tmp_path_factory):
    """A model of WaveKin 1, and MoorDyn-C's nodes over 20 s in water that is held over each step."""
    path = decks.write(decks.ROPE_IN_WAVES, tmp_path_factory.mktemp("hosted"), WaveKin=1, **FINE)
    time = OUT * np.arange(201)
    held = np.tile([0.0, 0.0, -6.0], (len(time), 1, 1))
    job = {"model": str(path), "time": time, "position": held, "water": held_water(200)}
    return read(path), call("moordyn_c_nodes", **job)["node_position"]


def check_nodes(hosted, accelerates: bool = True) -> None:
    """Nodes within 1 mm of a motion of 3 m (0.44 mm measured, of steps that start with a jump)."""
    model, other = hosted
    sim = moorage.Simulation(model, tolerance=1e-4)
    sim.initialize()
    found = []
    for k, (velocity, acceleration) in enumerate(held_water(200)):
        n = len(sim.water_nodes())
        sim.set_water(None, np.tile(velocity, (n, 1)), np.tile(acceleration, (n, 1)) if accelerates else None)
        sim.step(OUT * (k + 1), sim.position, 0.0 * sim.position)
        found.append(sim.water_nodes()[: other.shape[1]])
    off = np.abs(np.array(found) - other[1:])
    print(f"nodes differ by {1e3 * off.max():.2f} mm, having moved by {np.ptp(other, axis=0).max():.2f} m")
    assert off.max() < 1e-3


def test_water_of_a_host(hosted):
    check_nodes(hosted)


def test_water_without_its_acceleration_fails(hosted):
    with pytest.raises(AssertionError):
        check_nodes(hosted, accelerates=False)
