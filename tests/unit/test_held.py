"""Tuples of arrays that kernels take by address, and copies of arrays to go back to."""

from __future__ import annotations

import copy
import subprocess
import sys

import numpy as np
import pytest

from moorage._held import Held, Snapshot, held_values
from moorage._jit import kernel
from moorage.layout import Weights


@kernel
def total(held, k):
    """Add to a table what the inner tuple says, and return it."""
    table, inner, factor = held_values(held)
    table[k, 0] += factor * inner.mass[k] * inner.damping
    return table[k, 0]


def outer(factor: float = 2.0) -> Weights:
    """Tuples of the package: the cache of compiled code names their classes, and must be read without this test."""
    return Weights(np.zeros((3, 2)), Weights(np.array([1.0, 10.0, 100.0]), 3, 0.0), factor)


def test_arrays_are_shared():
    values = outer()
    held = Held(values)
    assert total(held, 1) == 60.0
    values.damping.mass[1] = 1.0
    assert total(held, 1) == values.mass[1, 0] == 66.0
    assert not values.mass[[0, 2]].any()


def test_numbers_are_those_of_the_time_it_was_made():
    values = outer()
    held, other = Held(values), Held(values._replace(stiffness=-2.0))
    assert total(held, 0) == 6.0
    assert total(other, 0) == 0.0
    assert len(total.signatures) == 1


def test_another_layout_is_another_type():
    held = Held(Weights(np.zeros((3, 2)).T[:, :2], Weights(np.arange(4.0)[::2], 3, 0.0), 2.0))  # strided
    assert total(held, 1) == 12.0
    assert Held(outer())._numba_type_ != held._numba_type_
    assert total(Held(outer()), 1) == 60.0


def test_arrays_live_as_long_as_what_holds_them():
    helds = [Held(outer(float(k))) for k in range(200)]
    assert [total(held, 2) for held in helds] == [300.0 * k for k in range(200)]


@pytest.mark.parametrize("counted", ["0", "1"])
def test_with_and_without_reference_counts(counted, tmp_path):
    """numba may lose the switch that leaves them out; then kernels take over references."""
    code = (
        "import gc, sys; sys.path.insert(0, 'tests/unit'); from test_held import *\n"
        "values = outer(); before = sys.getrefcount(values.mass); held = Held(values)\n"
        "for _ in range(100): total(held, 1)\n"
        "gc.collect(); assert values.mass[1, 0] == 6000.0; assert sys.getrefcount(values.mass) == before\n"
        "assert total(held, 2) == 600.0"
    )
    environment = {"MOORAGE_NRT": counted, "MOORAGE_CACHE": str(tmp_path), "PATH": "", "HOME": str(tmp_path)}
    environment["PYTHONPATH"] = ":".join(sys.path)
    subprocess.run([sys.executable, "-c", code], check=True, env=environment)


def test_snapshot_goes_back():
    rng = np.random.default_rng(1)
    arrays = [rng.normal(size=(5, 3)), np.arange(7), np.zeros((0, 2)), rng.normal(size=1)]
    snapshot = Snapshot(arrays)
    for array in arrays:
        array += 1
    kept = [array.copy() for array in arrays]
    snapshot.keep()
    for array in arrays:
        array *= 3
    snapshot.go_back()
    for array, before in zip(arrays, kept, strict=True):
        np.testing.assert_array_equal(array, before)


def test_copies_have_arrays_of_their_own():
    held = Held(outer())
    other = copy.deepcopy(held)
    assert total(other, 1) == 60.0
    assert other.values.mass[1, 0] == 60.0
    assert held.values.mass[1, 0] == 0.0
    array = np.arange(3.0)
    snapshot = copy.deepcopy(Snapshot([array]))
    snapshot.arrays[0][:] = 7.0
    snapshot.keep()
    snapshot.arrays[0][:] = 8.0
    snapshot.go_back()
    assert snapshot.arrays[0].tolist() == [7.0] * 3
    assert array.tolist() == [0.0, 1.0, 2.0]


def test_strided_arrays_are_no_blocks_of_memory():
    with pytest.raises(AssertionError):
        Snapshot([np.zeros((4, 4))[:, :2]])
