"""Minimum breaking loads: in results, in warnings, on the page, and in the native file."""

import dataclasses
import warnings

import numpy as np
import pytest
from moorings import CHAIN, coupled, fixed, single

import moorage
from moorage.results import overloads
from moorage.viewer.quantities import quantities


def hung(strength):
    """Return a chain between two points 60 m apart, 50 m long."""
    kind = dataclasses.replace(CHAIN, minimum_breaking_load=strength)
    return single(kind, 34.0, 5, fixed(1, 0.0, 0.0, -10.0), coupled(2, 30.0, 0.0, -10.0), water_depth=50.0)


def test_a_line_that_bears_too_much_is_told():
    highest = float(moorage.solve_statics(hung(None))["segment_tension"].max())
    with pytest.warns(moorage.ModelWarning, match=r"line 1 bears .* kN, more than its minimum breaking load of"):
        ds = moorage.solve_statics(hung(0.9 * highest))
    assert len(overloads(ds)) == 1
    with pytest.warns(moorage.ModelWarning, match=r"from end A at 0(\.1)? s"):
        moorage.simulate(hung(0.9 * highest), duration=0.1)


def test_a_line_that_bears_less_is_not():
    highest = float(moorage.solve_statics(hung(None))["segment_tension"].max())
    with warnings.catch_warnings():
        warnings.simplefilter("error", moorage.ModelWarning)
        ds = moorage.solve_statics(hung(1.1 * highest))
    assert overloads(ds) == []
    ds = ds.expand_dims("time", 0)
    used = next(q for q in quantities(ds, slice(0, 1), ds["node_position"].values) if q.key == "load")
    assert used.values.max() == pytest.approx(1.0 / 1.1, rel=1e-12)
    assert used.words["high"] == 1.0


def test_without_a_load_nothing_is_said():
    ds = moorage.solve_statics(hung(None))
    assert "breaking_load" not in ds.coords
    assert overloads(ds) == []


def test_round_trip(tmp_path):
    moorage.io.write_native(hung(2.5e6), tmp_path / "a.yaml")
    back = moorage.read(tmp_path / "a.yaml")
    assert back.line_types[0].minimum_breaking_load == 2.5e6
    np.testing.assert_array_equal(moorage.solve_statics(back)["breaking_load"].values, 2.5e6)


def test_a_negative_load_is_refused():
    with pytest.raises(moorage.ModelError, match=r"minimum breaking load of line type .* must not be negative"):
        moorage.solve_statics(hung(-1.0))
