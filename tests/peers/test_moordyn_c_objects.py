"""Rods and bodies beside MoorDyn-C itself, on the decks of its own tests.

AddedMass: a buoyant rod without drag rises under a constant force: z = a t^2 / 2, to rounding in both. bodyDrag: a body on a
spring, turned by 90 degrees about y, falls with a CdA of 0.1 m2: MoorDyn-C's step of 2 ms (RK2) leaves 1e-4. RodHanging is
not compared: MoorDyn-C gives a free rod its first attitude by the place of end B alone, so that a rod that hangs
between two equal ropes leans there; ours stays level, as the symmetry has it.
"""

from __future__ import annotations

import dataclasses
import shutil

import numpy as np
from benchmarks.programs import call
from beside import needs, read
from moorings import at_rest, run

pytestmark = needs("moordyn_c_objects")


def beside(reference, tmp_path, deck: str, duration: float):
    """MoorDyn-C's motion of rods and bodies, and ours, each 0.1 s from time 0."""
    path = tmp_path / "model.txt"
    shutil.copy(reference / "moordyn-c-tests" / deck, path)
    time = 0.1 * np.arange(round(duration / 0.1) + 1)
    theirs = call("moordyn_c_objects", model=str(path), time=time, held=np.zeros(0))
    model = dataclasses.replace(read(path), outputs=())
    block = run(at_rest(model), duration, dt_out=0.1, tolerance=1e-5)
    assert np.abs(block["time"] - time).max() < 1e-9
    return theirs, block


def test_rising_rod(reference, tmp_path):
    theirs, block = beside(reference, tmp_path, "rod_tests/AddedMass.txt", 2.0)
    # until its first step MoorDyn-C has end B elsewhere
    assert np.abs(block["rod_position"][1:, 0] - theirs["rod_position"][1:, 0]).max() < 1e-9
    mass, water = 100.0, 1025.0 * np.pi / 4.0 * 0.5**2
    expected = -10.0 + 0.5 * 9.80665 * (water - mass) / (water + mass) * block["time"] ** 2
    assert np.abs(block["rod_position"][:, 0, 0, 2] - expected).max() < 1e-9


def test_body_with_drag(reference, tmp_path):
    theirs, block = beside(reference, tmp_path, "body_tests/bodyDrag.txt", 3.0)
    z, expected = block["body_position"][:, 0, 2], theirs["body_state"][:, 0, 2]
    assert np.sqrt(np.mean((z - expected) ** 2) / np.mean(expected**2)) < 5e-3


def test_hanging_rod_stays_level(reference, tmp_path):
    path = tmp_path / "model.txt"
    shutil.copy(reference / "moordyn-c-tests" / "RodHanging.txt", path)
    block = run(at_rest(read(path)), 10.0, dt_out=1.0, tolerance=1e-3)
    r = block["rod_position"][:, 0]
    assert np.abs(r[:, 0] * [-1.0, 1.0, 1.0] - r[:, 1]).max() < 1e-6
    assert np.abs(r[:, 1, 0] - 10.0).max() < 1e-6
