"""Splines of imposed motion against SciPy's."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from moorage.physics.motion import spline


@pytest.mark.parametrize("n", [2, 3, 4, 5, 50])
def test_same_as_scipy(n):
    rng = np.random.default_rng(n)
    t = np.cumsum(rng.uniform(0.02, 1.0, n))
    y = rng.normal(size=(n, 3))
    expected = CubicSpline(t, y, bc_type="not-a-knot" if n > 3 else "natural").c.transpose(1, 2, 0)
    np.testing.assert_allclose(spline(t, y), expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())
