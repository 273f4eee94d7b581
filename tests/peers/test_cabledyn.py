"""CableDyn, finite elements without bending, on the three chains: the same statics, and the same dynamics as both refine.

Its mass is consistent, with a third of each element's coupled to the next node, where ours is lumped at the nodes: in
motion the two models differ by the segment length. Its fairlead load has no inertia of the end node in it either.
"""

import decks
import numpy as np
from benchmarks.programs import call
from beside import needs, read, rms, simulate, statics
from scipy.interpolate import CubicSpline

from moorage import Motion

pytestmark = needs("cabledyn_fem")

STEP, DURATION = 0.025, 60.0


def cabledyn_file(path):
    """Write the deck as CableDyn wants it: with the duration, without an option that it does not know."""
    rows = [row for row in path.read_text().splitlines() if not row.endswith("Currents")]
    at = next(k for k, row in enumerate(rows) if "OPTIONS" in row)
    rows[at + 1 : at + 1] = [f"{STEP} dtM", f"{DURATION} TMax"]
    ours = path.with_name("cabledyn.dat")
    ours.write_text("\n".join(rows) + "\n")
    return ours


def chains(segments, folder):
    lines = tuple(row.replace(" 20", f" {segments}") for row in decks.CHAINS.lines)
    return decks.write(decks.CHAINS._replace(lines=lines), folder)


def run(path, model, motion):
    time = STEP * np.arange(round(DURATION / STEP) + 1)
    tracks = [CubicSpline(motion.time, track) for track in motion.resolve(model, DURATION).values()]
    position, velocity, acceleration = (np.stack([track(time, k) for track in tracks], axis=1) for k in range(3))
    return call(
        "cabledyn_fem",
        model=str(cabledyn_file(path)), time=time, position=position, velocity=velocity, acceleration=acceleration,
    )  # fmt: skip


def test_chains(tmp_path):
    motion = Motion.from_harmonics(DURATION, ramp=20.0, interval=0.05, surge=(5.0, 12.0), heave=(2.0, 9.0))
    errors = {}
    for segments in (20, 100):
        path = chains(segments, tmp_path)
        model = read(path)
        theirs, still = run(path, model, motion), statics(model)
        np.testing.assert_allclose(still["fairlead_tension"], theirs["static_fairlead_tension"], rtol=1e-6)
        np.testing.assert_allclose(still["anchor_tension"], theirs["static_anchor_tension"], rtol=1e-6)
        ours = simulate(model, motion=motion, duration=DURATION, dt_out=STEP, tolerance=5e-4, save="tensions")
        load = np.linalg.norm(theirs["load"], axis=-1)
        errors[segments] = rms(ours["fairlead_tension"].values[1:], load[1:])
        print(f"CableDyn, {segments} segments: rms {100 * errors[segments]} %")
    assert errors[20].max() < 0.03
    assert errors[100].max() < 0.015  # windward; its own step of 0.025 s is half of that
    assert errors[100][1:].max() < 0.002
    assert (errors[100] < 0.6 * errors[20]).all()
