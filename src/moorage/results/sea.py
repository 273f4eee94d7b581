"""The sea in a result: its elevation over time, what it was made from, and what came out."""

from __future__ import annotations

import warnings

import numpy as np

from moorage.errors import ModelWarning
from moorage.model import Current, CurrentGrid, Waves
from moorage.solve.given_water import WaterFeed

ELEVATION = ("wave_elevation",)


def sea_attributes(waves: Waves | None) -> dict[str, object]:
    """Return the attributes that describe a sea; none for still water."""
    if waves is None:
        return {}
    return {
        "wave_asked": waves.words,
        "wave_components": len(waves.frequency),
        "wave_seed": "none" if waves.seed is None else waves.seed,
        "wave_stretching": waves.stretching,
        "wave_significant_height": waves.significant_height,
        "wave_peak_period": waves.peak_period,
    }


def sea_columns(waves: Waves | WaterFeed, time: np.ndarray) -> dict[str, np.ndarray]:
    """Return the columns of a sea at times (n,) s."""
    return {"wave_elevation": waves.elevation(time)}


def warn_of_repetition(waves: Waves | None, duration: float) -> None:
    """Warn of a sea of equally spaced frequencies that comes round again within a run."""
    if waves is not None and waves.repeats_after < duration:
        warnings.warn(
            f"{f'{waves.source}: ' if waves.source else ''}the waves repeat after {waves.repeats_after:.4g} s, the run "
            f"is {duration:g} s long: their frequencies are equally spaced (method random does not repeat)",
            ModelWarning,
            stacklevel=3,
        )


def warn_of_short_current(current: Current | CurrentGrid, duration: float) -> None:
    """Warn of a current whose times end before a run does."""
    if isinstance(current, CurrentGrid) and len(current.t) > 1 and current.t[-1] < duration:
        warnings.warn(
            f"{f'{current.source}: ' if current.source else ''}the current is given up to {current.t[-1]:g} s, the run "
            f"is {duration:g} s long: its last values go on",
            ModelWarning,
            stacklevel=3,
        )
