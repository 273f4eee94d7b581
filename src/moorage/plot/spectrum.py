"""Spectra of tensions."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from scipy.signal import welch

from moorage.errors import Problem, ResultError
from moorage.plot.style import draw_curves, new_figure
from moorage.plot.tension import series

LEAST = 32  # values of which a spectrum is made
PARTS = 4  # a series is cut into, half over each other, to average their spectra
ENERGY = 0.999  # of the variance that the axis covers


def plot_spectrum(
    ds: xr.Dataset, ax: Axes | None = None, variable: str = "fairlead_tension", start: float = 0.0
) -> Axes:
    """Draw the one-sided spectral density of a tension, kN2/Hz, of every line.

    The area below a curve is the variance of the tension (Welch 1967, Hann windows on parts a quarter as long as the
    run, half over each other, each without its mean).

    Parameters
    ----------
    ds : xarray.Dataset
        A run.
    ax : matplotlib Axes, optional
        Where to draw; by default a new figure, `ax.figure`.
    variable : str
        fairlead_tension or anchor_tension.
    start : float
        Leave out what was before that time, s.

    Raises
    ------
    ResultError
        There are too few instants.
    """
    frequency, names, density = spectra(ds, variable, start)
    ax = new_figure(8.0, 4.0).add_subplot() if ax is None else ax
    draw_curves(ax, frequency, names, density.T, "other lines")
    held = np.cumsum(density, axis=1) / np.maximum(density.sum(axis=1, keepdims=True), 1e-300)
    last = max(int(np.searchsorted(row, ENERGY)) for row in held)
    ax.set_xlim(0.0, frequency[min(last + 1, len(frequency) - 1)])
    ax.set_ylim(bottom=0.0)
    ax.set_xlabel("frequency (Hz)", fontsize=9)
    ax.set_ylabel(f"spectrum of the {variable.replace('_', ' ')} (kN²/Hz)", fontsize=9)
    ax.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=6, frameon=False, fontsize=8, borderaxespad=0.2)
    return ax


def spectra(ds: xr.Dataset, variable: str, start: float = 0.0) -> tuple[np.ndarray, list[str], np.ndarray]:
    """Return frequencies (n,) in Hz, names of lines and cables, and their spectral densities (lines, n) in kN2/Hz."""
    if "time" not in ds[variable].dims:
        raise ResultError(Problem("a static solution has no spectrum", "take a result of `run`"))
    later = ds.isel(time=ds["time"].values >= start)
    names, values = series(later, variable)
    if len(values) < LEAST:
        problem = f"a spectrum needs {LEAST} instants, there are {len(values)}"
        raise ResultError(Problem(problem, "run longer, save more often (--dt-out), or start earlier"))
    interval = float(np.diff(later["time"].values[:2])[0])
    frequency, density = welch(values, 1.0 / interval, nperseg=max(LEAST // 2, len(values) // PARTS), axis=0)
    return frequency, names, density.T
