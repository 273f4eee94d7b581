"""What MoorDyn-C's contact leaves out: it pushes upwards, whatever the slope, so that nothing slides down.

A chain of 100 m lies straight down a frictionless plane of 10 degrees, held at its upper end. The tension there is
w L sin(10 deg) = 15.7 kN, and half a segment more that weighs on the hold; in MoorDyn-C it is that of a chain on level
ground, none. On the paper's sideslope the chain of line 1, which lies across the slope, stays where it is put in MoorDyn-C, with the
tension of flat ground; it comes down by 80 m in ours, and pulls 1.7 times as much.
"""

import re

import numpy as np
import pytest
from benchmarks.programs import is_installed
from beside import moordyn_at_rest, read, statics
from housner import case
from moorings import coupled, free, kind, single, weight_in_water

from moorage.io import write_moordyn
from moorage.model import Bathymetry

SLOPE, X = np.deg2rad(10.0), (-300.0, 300.0)
CHAIN = kind(
    diameter=0.1, mass_per_length=100.0, axial_damping_ratio=0.8, transverse_drag=1.0, tangential_drag=0.2,
    transverse_added_mass=1.0, tangential_added_mass=0.5,
)  # fmt: skip


@pytest.mark.peers
@pytest.mark.skipif(not is_installed("moordyn_c"), reason="moordyn is not installed")
def test_chain_down_a_slope(tmp_path):
    bed = Bathymetry(X, X, tuple((100.0 + x * np.tan(SLOPE),) * 2 for x in X))
    half = 50.0 * np.array([np.cos(SLOPE), 0.0, -np.sin(SLOPE)])
    middle = np.array([0.0, 0.0, -100.0])
    ends = free(1, *(middle + half), mass=1.0), coupled(2, *(middle - half))
    path = tmp_path / "chain.dat"
    write_moordyn(single(CHAIN, 100.0, 20, *ends, water_depth=100.0, bathymetry=bed), path)
    settings = "1e-3 dtM\nrk4 tScheme\n0.0 TmaxIC\n--- need"
    path.write_text(re.sub(r"(?m)^-+ need", settings, path.read_text()))
    model = read(path)
    ours, theirs = statics(model), moordyn_at_rest(path, model, 20.0)
    pull = weight_in_water(CHAIN) * 100.0 * np.sin(SLOPE)
    print(
        f"tension at the top: {float(ours['fairlead_segment_tension'][0]):.0f} N, MoorDyn-C {theirs['end_tension'][-1, 0]:.0f} N"
    )
    assert float(ours["fairlead_segment_tension"][0]) == pytest.approx(pull * (1.0 - 0.5 / 20.0), rel=2e-3)
    assert theirs["end_tension"][-1, 0] < 0.01 * pull


@pytest.mark.peers
def test_chain_across_a_slope(reference):
    slope, flat = (case(reference, f"wave_{name}_nofriction", "C") for name in ("sideslope", "flat"))
    theirs, level = (float(given.channels["LINE2TENB"].mean()) for given in (slope, flat))
    ours = float(statics(slope.model)["fairlead_tension"].sel(line=2))
    print(
        f"line 1 on the sideslope: {ours / 1e3:.0f} kN, MoorDyn-C {theirs / 1e3:.0f} kN, on flat ground {level / 1e3:.0f} kN"
    )
    assert theirs == pytest.approx(level, rel=1e-3)
    assert ours > 1.5 * theirs
