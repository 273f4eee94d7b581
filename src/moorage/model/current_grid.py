"""A current that changes with time or place."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field

import numpy as np

from moorage.errors import Source


@dataclass(frozen=True, kw_only=True, eq=False)
class CurrentGrid:
    """Velocities on a grid over time and place, linear between its points; outside the nearest one goes on.

    Parameters
    ----------
    t : (nt,) tuple
        s, increasing; the first time of the run is 0.
    x, y, z : (nx,), (ny,), (nz,) tuple
        m, increasing, z negative below the water. One value stands for all: the current does not change that way.
    velocity : (nt, nx, ny, nz, 3) array
        m/s, along the axes of the model.
    turn : float
        Angle of the grid's x axis against that of the model, rad, from x towards y; both have the same origin.
    """

    t: tuple[float, ...] = (0.0,)
    x: tuple[float, ...] = (0.0,)
    y: tuple[float, ...] = (0.0,)
    z: tuple[float, ...] = (0.0,)
    velocity: np.ndarray
    turn: float = 0.0
    file: str = ""
    source: Source | None = field(default=None, repr=False)

    @property
    def shape(self) -> tuple[int, int, int, int]:
        """Number of times, and of points in x, y and z."""
        return len(self.t), len(self.x), len(self.y), len(self.z)

    def at(self, t, xyz) -> np.ndarray:
        """Return the velocity (..., 3), m/s, at times (...) s and places (..., 3) m, which broadcast."""
        xyz = np.asarray(xyz, float)
        c, s = np.cos(self.turn), np.sin(self.turn)
        along, across = c * xyz[..., 0] + s * xyz[..., 1], c * xyz[..., 1] - s * xyz[..., 0]
        *coordinates, _ = np.broadcast_arrays(np.asarray(t, float), along, across, xyz[..., 2], along)
        axes = (self.t, self.x, self.y, self.z)
        places = [_between(axis, values) for axis, values in zip(axes, coordinates, strict=True)]
        low, high, share = zip(*places, strict=True)
        out = np.zeros((*coordinates[0].shape, 3))
        for corner in range(16):
            upper = [bool(corner >> axis & 1) for axis in range(4)]
            index = tuple(h if up else b for up, b, h in zip(upper, low, high, strict=True))
            weight = np.prod([f if up else 1.0 - f for up, f in zip(upper, share, strict=True)], axis=0)
            out += weight[..., None] * self.velocity[index]
        return out

    def _content(self) -> tuple:
        return self.t, self.x, self.y, self.z, self.turn, self.velocity.shape, self.velocity.tobytes()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, CurrentGrid) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash(self._content())

    def __repr__(self) -> str:  # stands for the numbers where runs are compared
        digest = hashlib.sha256(repr(self._content()).encode()).hexdigest()[:16]
        return f"CurrentGrid({' x '.join(map(str, self.shape))} in t, x, y, z: {digest})"


def _between(axis: tuple[float, ...], value: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the points of an axis on both sides of values and the fraction between them."""
    points = np.array(axis)
    low = np.clip(np.searchsorted(points, value, side="right") - 1, 0, max(len(points) - 2, 0))
    high = np.minimum(low + 1, len(points) - 1)
    gap = points[high] - points[low]
    share = np.where(gap > 0.0, (value - points[low]) / np.where(gap > 0.0, gap, 1.0), 0.0)
    return low, high, np.clip(share, 0.0, 1.0)
