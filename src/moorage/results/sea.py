"""The sea in a result: its elevation over time, its components, what it was made from, and what came out."""

from __future__ import annotations

import warnings

import numpy as np
import xarray as xr

from moorage.errors import ModelWarning
from moorage.model import Current, CurrentGrid, Waves
from moorage.solve.given_water import WaterFeed

ELEVATION = ("wave_elevation",)
COMPONENT = "wave_component"
WORDS = ("amplitude", "frequency", "phase", "direction", "number")  # of the components, wave_...


def sea_attributes(waves: Waves | None) -> dict[str, object]:
    """Return the attributes that describe a sea; none for still water."""
    if waves is None:
        return {}
    return {
        "wave_asked": waves.words,
        "wave_components": len(waves.frequency),
        "wave_seed": "none" if waves.seed is None else waves.seed,
        "wave_stretching": waves.stretching,
        "wave_ramp": float(waves.ramp),
        "wave_significant_height": waves.significant_height,
        "wave_peak_period": waves.peak_period,
    }


def sea_coordinates(waves: Waves) -> dict[str, np.ndarray]:
    """Return the components of a sea, each (n,), so that a result can give the water anywhere again."""
    return {
        "wave_frequency": np.array(waves.frequency),
        "wave_amplitude": np.array(waves.amplitude),
        "wave_phase": np.array(waves.phase),
        "wave_direction": np.array(waves.direction),
        "wave_number": waves.wavenumber,
    }


def sea_columns(waves: Waves | WaterFeed, time: np.ndarray) -> dict[str, np.ndarray]:
    """Return the columns of a sea at times (n,) s."""
    return {"wave_elevation": waves.elevation(time)}


def surface_elevation(ds: xr.Dataset, t: float, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return the elevation (m) of the sea of a result at a time (s) and places (n,); 0 of still water."""
    if "wave_frequency" not in ds.coords or "wave_elevation" not in ds:
        return np.zeros(np.shape(x))
    a, w, phase, b, k = (ds[f"wave_{name}"].values for name in WORDS)
    ramp = float(ds.attrs.get("wave_ramp", 0.0))
    grown = 0.5 * (1.0 - np.cos(np.pi * min(max(t / ramp, 0.0), 1.0))) if ramp > 0.0 else 1.0
    way = np.multiply.outer(x, k * np.cos(b)) + np.multiply.outer(y, k * np.sin(b))
    return grown * (a * np.cos(w * t + phase - way)).sum(axis=-1)


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
