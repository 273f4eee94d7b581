"""Waves and current of a model, in the arrays of the engine."""

from __future__ import annotations

import numpy as np

from moorage.model import Current, CurrentGrid
from moorage.model.waves import Waves
from moorage.physics import current as flow
from moorage.physics import sea as law

STRETCHINGS = {"wheeler": law.WHEELER, "vertical": law.VERTICAL, "linear": law.LINEAR, "none": law.NONE}
INTERVALS = 20.0  # of the table in a peak period


def build_sea(waves: Waves | None) -> law.Sea:
    """Return the components of a sea, with the interval of the table from its peak period."""
    if waves is None or not np.any(waves.amplitude):
        return law.no_sea()
    return law.sea_of(
        waves.amplitude, waves.elevations, waves.frequency, waves.phase, waves.wavenumber, np.array(waves.direction),
        waves.depth, STRETCHINGS[waves.stretching], waves.ramp, 0.0 if waves.exact else waves.peak_period / INTERVALS,
    )  # fmt: skip


def build_current(current: Current | CurrentGrid) -> flow.Current:
    """Return the velocities of a current, as a grid of one column where it is a profile."""
    grid = current
    if isinstance(current, Current):
        grid = CurrentGrid(z=current.z, velocity=np.array(current.velocity, float))
    assert isinstance(grid, CurrentGrid)
    return flow.current_of(grid.t, grid.x, grid.y, grid.z, grid.velocity, grid.turn)


def with_interval(sea: law.Sea, step: float | None) -> law.Sea:
    """Return the sea with an interval of the table of whole constant steps; with fewer than two, a sum a step."""
    if step is None or sea.interval == 0.0:
        return sea
    steps = int(sea.interval / step + 1e-6)
    return sea._replace(interval=steps * step if steps >= 2 else 0.0)
