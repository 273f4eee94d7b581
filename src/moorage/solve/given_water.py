"""Water that is given from outside: by a host at the rows of the state, or by a function of time and place."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from moorage.errors import SimulationError
from moorage.physics.motion import sample_track
from moorage.physics.sea import WATER, given_at, no_sea
from moorage.system.build import Built

WaterFunction = Callable[[float, np.ndarray], Any]


def takes_water(built: Built, given: np.ndarray | None = None) -> Built:
    """Return a system whose water is given, still until it is set; `given` is shared with another one."""
    given = given_at(len(built.state.position)) if given is None else given
    return built._replace(system=built.system._replace(sea=no_sea()._replace(given=given)))


def times_of(given: np.ndarray) -> np.ndarray:
    """Return the two times (2,) of given water, s, as a view."""
    return given[:, -1, 0]


def set_given(given: np.ndarray, now: float, values: np.ndarray, time: float) -> None:
    """Set the water (rows, 7) at a time (s), to which it goes linearly from what it is now; at once if that is now."""
    a, b = times_of(given)
    s = min(max((now - a) / (b - a), 0.0), 1.0) if b > a else 1.0
    given[0, :-1] = values if time <= now else (1.0 - s) * given[0, :-1] + s * given[1, :-1]
    given[1, :-1] = values
    times_of(given)[...] = now, time


def as_water(time: float, count: int, elevation, velocity, acceleration) -> np.ndarray:
    """Return elevation (n,) m, velocity and acceleration (n, 3) m/s and m/s2 as one array (n, 7), checked.

    An elevation or acceleration of None is zero.
    """
    parts = []
    for name, values, width in (
        ("elevation", elevation, 1),
        ("velocity", velocity, 3),
        ("acceleration", acceleration, 3),
    ):
        part = np.zeros((count, width)) if values is None else np.asarray(values, float)
        shapes = ((count, width), (count,)) if width == 1 else ((count, width),)
        if part.shape not in shapes or not np.isfinite(part).all():
            wrong = "" if np.isfinite(part).all() else " with NaN or inf in it"
            size = f"{count} x {width}" if width > 1 else str(count)
            raise SimulationError(
                f"{name} of the water: expected {size} finite numbers, got an array of shape {part.shape}{wrong}", time
            )
        parts.append(part.reshape(count, width))
    water = np.concatenate(parts, axis=1)
    assert water.shape[1] == WATER
    return water


def places_ahead(built: Built, time: float, ahead: float) -> np.ndarray:
    """Return where all rows of the state, which is that of a time (s), will be a while later, (rows, 3), m.

    Held points, bodies and ends of rods are where their motion takes them; rows of rotation stand with their object.
    """
    system, state = built.system, built.state
    places, tracks = state.position + ahead * state.velocity, system.tracks
    places[system.riders.row + 1] = places[system.riders.row]
    held = np.setdiff1d(np.arange(len(system.points.mass)), system.islands.points)
    now = np.zeros((3, len(held), 1, 3))  # position, velocity, acceleration
    now[0, :, 0] = tracks.rest[held]
    for k in np.flatnonzero(tracks.track[held] >= 0):
        sample_track(tracks, held[k], np.array([time + ahead]), *now[:, k])
    places[int(system.lines.node_ptr[-1]) + held] = now[0, :, 0]
    return places


class WaterFeed:
    """A function that gives the water, sampled where the nodes will be at the end of each interval.

    Parameters
    ----------
    function : callable
        Of a time (s) and places (n, 3) m; gives elevation (n,) m, velocity (n, 3) m/s and acceleration (n, 3) m/s2, as
        `Waves.kinematics` does. Without current, which is added.
    interval : float
        s.
    rows : int
        Rows of the state.
    """

    def __init__(self, function: WaterFunction, interval: float, rows: int):
        self.function, self.interval = function, interval
        self.given = given_at(rows)

    @property
    def end(self) -> float:
        """Time at which the present interval ends, s."""
        return float(times_of(self.given)[1])

    def start(self, built: Built, time: float) -> None:
        """Fill the interval that begins at a time, s."""
        set_given(self.given, time, self.sample(time, places_ahead(built, time, 0.0)), time)
        self.go_on(built)

    def go_on(self, built: Built) -> None:
        """Fill the next interval."""
        time = self.end + self.interval
        set_given(self.given, self.end, self.sample(time, places_ahead(built, self.end, self.interval)), time)

    def elevation(self, times: np.ndarray) -> np.ndarray:
        """Return the elevation at the origin (n,), m, at times (n,) s."""
        return np.array([self.sample(time, np.zeros((1, 3)))[0, 0] for time in times.tolist()])

    def sample(self, time: float, places: np.ndarray) -> np.ndarray:
        """Return the water (n, 7) at a time and places (n, 3)."""
        elevation, velocity, acceleration = tuple(self.function(time, places.copy()))[:3]
        return as_water(time, len(places), elevation, velocity, acceleration)
