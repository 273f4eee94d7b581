"""What samples of a motion must fulfil."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from moorage.errors import MotionError, Problem, Source


def check_samples(time: np.ndarray, tables: Iterable[tuple[str, np.ndarray, int]], source: Source | None) -> None:
    """Raise a `MotionError` for times (n,) that do not increase, or tables that do not go with them.

    Parameters
    ----------
    tables : iterable of (what moves, (n, k) array, k)
        k is 0 where any number of columns goes.
    """
    for name, values, width in tables:
        if values.ndim != 2 or len(values) != len(time):
            message = f"motion of {name} has shape {values.shape} for {len(time)} times"
            raise MotionError(Problem(message, "give one row of coordinates for each time", source))
        if width and values.shape[1] != width:
            message = f"motion of {name} has {values.shape[1]} columns, not {width}"
            columns = "surge, sway, heave, roll, pitch, yaw" if width == 6 else "x, y, z"
            raise MotionError(Problem(message, f"give {columns}", source))
        bad = np.flatnonzero(~np.isfinite(values).all(axis=1))
        if len(bad):
            message = f"motion of {name} is not a number at {time[bad[0]]:g} s"
            raise MotionError(Problem(message, "give finite values", source))
    if time.ndim != 1 or len(time) < 2 or not np.isfinite(time).all():
        raise MotionError(Problem("motion needs at least two finite times", "add samples", source))
    back = np.flatnonzero(np.diff(time) <= 0.0)
    if len(back):
        k = int(back[0]) + 1
        message = f"time does not increase at sample {k + 1}"
        raise MotionError(Problem(message, f"the time after {time[k - 1]:g} s must be larger", source, float(time[k])))
