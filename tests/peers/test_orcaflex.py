"""OrcaFlex's series of a chain in 200 m, top moved 2 m up and down, without friction and with one that sticks.

Fairlead: static within 0.5 %, 1 % rms in motion, which is also what MoorDyn-C is from OrcaFlex on this case, with and
without friction. Anchor: static within 0.5 %; in motion 7 % rms without friction, because all of the tension's variation
passes along the bed then, and less with friction that sticks.
"""

import re

import numpy as np
import pytest
from benchmarks.accuracy import orcaflex_chain
from benchmarks.programs import is_installed
from beside import moordyn_moved, read, rms, simulate

from moorage import Motion
from moorage.model import Friction


@pytest.mark.peers
@pytest.mark.parametrize(
    ("friction", "at_anchor"),
    [(None, 0.08), (Friction(axial=0.5, transverse=0.5), 0.055)],
    ids=["none", "elastic slip"],
)
def test_chain_in_200_m(friction, at_anchor, reference, record_property):
    errors = orcaflex_chain(reference, friction)
    for name, value in errors.items():
        record_property(name, value)
        print(f"OrcaFlex, 200 m: {name} {100 * value:.2f} %")
    assert abs(errors["static fairlead"]) < 0.005
    assert abs(errors["static anchor"]) < 0.005
    assert errors["rms fairlead"] < 0.0125
    assert errors["rms anchor"] < at_anchor


@pytest.mark.peers
@pytest.mark.skipif(not is_installed("moordyn_c"), reason="moordyn is not installed")
def test_moordyn_c_agrees_without_friction(reference, tmp_path):
    """So the difference at the anchor is the missing friction; the motion comes in over a ramp here."""
    text = (reference / "moordyn-c-tests" / "QuasiStatic" / "inputs" / "WD0200_Chain.txt").read_text()
    for option in ("fileIC", "FrictionCoefficient", "cfl"):  # the first names a file that is not there
        text = re.sub(rf"(?m)^\S+\s+{option}\b.*\n", "", text)
    path = tmp_path / "chain.dat"
    path.write_text(re.sub(r"(?m)^-+ need", "5e-4 dtM\nrk2 tScheme\n--- need", text))
    model = read(path)
    motion = Motion.from_harmonics(30.0, ramp=10.0, interval=0.05, heave=(2.0, 10.0))
    theirs = moordyn_moved(path, model, motion, 30.0)["end_tension"]
    ours = simulate(model, motion=motion, duration=30.0, dt_out=0.0125, save="tensions")
    assert rms(np.abs(ours["fairlead_segment_tension"].values), theirs).max() < 0.01
