"""Lines in waves beside MoorDyn-C live, with the same `wave_frequencies.txt` (its WaveKin 7).

The water. Its dispersion relation is Newman's, good to 1.2e-7: 100 m off, where kx is up to 17, that is 2e-6 of a wave.
Elevation, velocity and acceleration at wet places must agree within 2e-6 of their largest.

The nodes. A rope that is held at both ends swings in the sea. MoorDyn-C's statics are other than ours, so that the two
start apart; drag ends that within half a minute. Both programs then make the same steps of fourth order in the same
sums: velocities of all nodes must agree to 1e-6 of twice their standard deviation. With vertical stretching in the
place of Wheeler's they must not.
"""

from __future__ import annotations

import dataclasses

import decks
import numpy as np
import pytest
from benchmarks.programs import call
from beside import needs, read

from moorage.model import Waves
from moorage.solve.march import March, Settings
from moorage.solve.statics import solve
from moorage.system.build import build

pytestmark = needs("moordyn_c_nodes")

ROPE = decks.ROPE_IN_WAVES
STEP, OUT, DURATION, SETTLED = 0.001, 0.1, 50.0, 30.0
SEA = np.array([[0.45, 0.5, 0.7, 0.0], [0.6, 1.2, -1.1, 0.3], [0.83, -0.8, 0.4, -0.5], [1.3, 0.2, 0.3, 1.2]])


def sea(**water) -> Waves:
    w, real, imaginary, heading = SEA.T
    return Waves(
        frequency=tuple(w), amplitude=tuple(np.hypot(real, imaginary)), direction=tuple(heading),
        phase=tuple(np.arctan2(imaginary, real) - 0.5 * np.pi), depth=ROPE.depth, exact=True, **water,
    )  # fmt: skip


def write(folder):
    rows = np.vstack([np.zeros(4), SEA])
    (folder / "wave_frequencies.txt").write_text("".join(" ".join(f"{x:.17g}" for x in row) + "\n" for row in rows))
    return decks.write(ROPE, folder, WaveKin=7, dtM=STEP, tScheme="rk4", TmaxIC=0, disableOutput=1, disableOutTime=1)


def moordyn_c(path, places, duration):
    time = OUT * np.arange(round(duration / OUT) + 1)
    held = np.tile([0.0, 0.0, -6.0], (len(time), 1, 1))
    return time, call("moordyn_c_nodes", model=str(path), time=time, position=held, places=places)


def test_water(tmp_path):
    places = np.random.default_rng(1).uniform([-100.0, -100.0, -60.0], [100.0, 100.0, -5.0], (30, 3))
    time, theirs = moordyn_c(write(tmp_path), places, 3.0)
    ours = sea().kinematics(time[1:, None], places)
    for name in ("elevation", "water_velocity", "water_acceleration"):
        mine, other = getattr(ours, name.removeprefix("water_")), theirs[name][1:]
        print(f"{name}: differs by {np.abs(mine - other).max() / np.abs(other).max():.1e} of its largest")
        assert np.abs(mine - other).max() < 2e-6 * np.abs(other).max()


@pytest.fixture(scope="module")
def theirs(tmp_path_factory):
    path = write(tmp_path_factory.mktemp("rope"))
    return path, moordyn_c(path, np.zeros((0, 3)), DURATION)[1]["node_velocity"]


def check_velocities(theirs, **water) -> None:
    path, other = theirs
    model = read(path)
    model = dataclasses.replace(
        model, environment=dataclasses.replace(model.environment, unread_water=None, waves=sea(**water))
    )
    built = build(model)
    solve(built)
    march = March(built, Settings(method="rk4", time_step=STEP, dt_out=OUT, dt_nodes=OUT), DURATION)
    ours = np.concatenate([march.first()["node_velocity"], march.advance(DURATION)["node_velocity"]])
    late, inner = slice(round(SETTLED / OUT), None), slice(1, -1)
    off = np.abs(ours - other)[late, inner].max(axis=0)
    twice = 2.0 * other[late, inner].std(axis=0)
    print(f"velocities differ by {np.max(off / twice):.1e} of twice their standard deviation")
    assert (off < 1e-6 * twice).all()


def test_velocities_of_the_nodes(theirs):
    check_velocities(theirs)


def test_other_stretching_fails(theirs):
    with pytest.raises(AssertionError):
        check_velocities(theirs, stretching="vertical")
