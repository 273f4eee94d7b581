"""A farm of two turbines beside MoorDyn-C, which knows no turbines: there every fairlead is a coupled point with a track.

The rope hangs between the turbines, which go opposite ways; all three lines within 1 % rms of MoorDyn-C, refined.
"""

import numpy as np
from beside import REFINED, moordyn_moved, needs, rms, simulate
from farms import shared, swaying

from moorage import Motion
from moorage.io import write_moordyn

pytestmark = needs("moordyn_c")


def test_tensions_of_a_farm(tmp_path, record_property):
    model, path, duration = shared(), tmp_path / "farm.dat", 30.0
    write_moordyn(model, path, "C")
    settings = "".join(f"{value} {name}\n" for name, value in REFINED.items())
    path.write_text(path.read_text().replace("WtrDpth\n", f"WtrDpth\n{settings}", 1))
    motion = Motion.from_turbines({1: swaying(duration), 2: swaying(duration, mirrored=True)})
    theirs = moordyn_moved(path, model, motion, duration)["end_tension"]
    ours = simulate(model, motion=motion, duration=duration, dt_out=0.0125, save="tensions")
    error = rms(np.abs(ours["fairlead_segment_tension"].values), theirs)
    record_property("rms", error.max())
    print(f"farm: rms {100 * error.max():.2f} %, {100 * error.round(5)}")
    assert error.max() < 0.01
