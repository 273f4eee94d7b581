"""Parts of a model that hold tables take NumPy arrays and lists as well as tuples."""

from __future__ import annotations

import numpy as np
import pytest

from moorage.model import Bathymetry, Current, Curve, FrictionMap, StiffnessMap
from moorage.model.plain import plain

X, ROWS = (0.0, 10.0), ((0.2, 0.3), (0.4, 0.5))
PARTS = {
    "bathymetry": (Bathymetry, (X, X, ROWS)),
    "friction map": (FrictionMap, (X, X, ROWS, ROWS)),
    "stiffness map": (StiffnessMap, (X, X, ROWS)),
    "current": (Current, ((-10.0, 0.0), ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)))),
    "curve": (Curve, (X, X)),
}


@pytest.mark.parametrize("name", PARTS)
@pytest.mark.parametrize(
    "kind", [np.array, list, lambda table: [*map(list, table)] if isinstance(table[0], tuple) else table]
)
def test_arrays_and_lists_make_the_same_part(name, kind):
    part, tables = PARTS[name]
    made = part(*map(kind, tables))
    assert made == part(*tables)
    assert hash(made) == hash(part(*tables))


def test_tuples_are_not_copied():
    big = ((1.0,) * 1000,) * 1000
    assert plain(big) is big


def test_single_values_stay_what_they_are():
    assert plain(3.0) == 3.0
    assert plain("a word") == "a word"
    assert plain(np.float64(2.0)) == 2.0
