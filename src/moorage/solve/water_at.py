"""The water at places and times: waves and current, or what is given at the rows of the state."""

from __future__ import annotations

import numpy as np

from moorage.physics.sea import RECORD, scratch_for
from moorage.physics.sea_table import FIELDS
from moorage.solve.given_water import WaterFeed
from moorage.system.build import Built
from moorage.system.water import sample_water


def water_at(built: Built, time: np.ndarray, position: np.ndarray, rows: np.ndarray | None = None) -> np.ndarray:
    """Return elevation, velocity and acceleration of the water (n, 7) at times (n,) and places (n, 3).

    rows: (n,) state rows that are at these places; only by them water that is given is known.
    """
    out, place = np.empty((len(time), FIELDS)), np.ascontiguousarray(position)
    sample_water(built.system, np.ascontiguousarray(time), place, scratch_for(built.system.sea), np.zeros(RECORD), out)
    given = built.system.sea.given
    return out if rows is None or given.shape[1] == 1 else out + given_at_rows(given, rows, time)


def water_along(
    built: Built, time: np.ndarray, position: np.ndarray, rows: np.ndarray, feed: WaterFeed | None = None
) -> np.ndarray:
    """Return the water (n, k, 7) at times (n,) and places (n, k, 3), which are those of state rows (k,).

    feed: what gives the waves of a run in place of the model.
    """
    n, k = position.shape[:2]
    flat = water_at(built, np.repeat(time, k), position.reshape(-1, 3), np.tile(rows, n)).reshape(n, k, -1)
    if feed is not None:
        flat += [feed.sample(t, places) for t, places in zip(time.tolist(), position, strict=True)]
    return flat


def given_at_rows(given: np.ndarray, rows: np.ndarray, time: np.ndarray) -> np.ndarray:
    """Return given water (n, 7) at state rows (n,) and times (n,): linear between two times and held outside."""
    a, b = given[:, -1, 0]
    s = np.clip((time - a) / (b - a), 0.0, 1.0)[:, None] if b > a else np.ones((len(time), 1))
    return (1.0 - s) * given[0, rows] + s * given[1, rows]


def row_of_holder(built: Built, holder: int) -> int:
    """Return the state row of a point or end of a rod."""
    return int(built.system.lines.node_ptr[-1]) + int(holder)


def row_of_body(built: Built, k: int) -> int:
    """Return the state row of the reference point of a body."""
    o = built.bodies.object[k]
    return int(built.system.riders.row[o]) if o >= 0 else row_of_holder(built, built.bodies.place[k])
