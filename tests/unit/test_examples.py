"""The shipped example: its motion is what its script makes, and it is small."""

import runpy
from pathlib import Path

import numpy as np

import moorage

FOLDER = Path(__file__).parents[2] / "examples" / "oc4"


def test_the_motion_is_what_the_script_makes(tmp_path, monkeypatch):
    script = tmp_path / "make_motion.py"
    script.write_text((FOLDER / "make_motion.py").read_text("utf-8"))
    runpy.run_path(str(script), run_name="__main__")
    made = np.loadtxt(tmp_path / "motion.csv", delimiter=",", skiprows=1)
    shipped = np.loadtxt(FOLDER / "motion.csv", delimiter=",", skiprows=1)
    np.testing.assert_allclose(made, shipped, atol=2e-6)  # one unit of the last digit, whoever computes the cosines
    assert (FOLDER / "motion.csv").stat().st_size < 400e3


def test_the_motion_starts_from_rest_and_lasts():
    motion = moorage.Motion.read(FOLDER / "motion.csv", moorage.read(FOLDER / "oc4.dat"))
    assert motion.duration == 300.0
    assert np.abs(motion.platform[:2]).max() < 1e-6
    surge, heave, pitch = (np.ptp(motion.platform[:, k]) for k in (0, 2, 4))
    assert 5.0 < surge < 15.0
    assert 1.0 < heave < 10.0
    assert np.radians(1.0) < pitch < np.radians(10.0)
