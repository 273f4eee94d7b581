"""MoorDyn-C beside Moorage, and what both cost."""

from __future__ import annotations

import dataclasses
import tempfile
import time
import warnings
from functools import cache
from pathlib import Path

import numpy as np
import xarray as xr
from benchmarks.cases import write_deck
from benchmarks.programs import Arrays, call, is_installed
from numpy.typing import ArrayLike

import moorage
from moorage.model import Model

PROGRAM = "moordyn_c_along"
QUIET = {"disableOutput": 1, "disableOutTime": 1, "writeLog": 0}


def has_moordyn() -> bool:
    """Whether MoorDyn-C can be run."""
    return is_installed(PROGRAM)


def moordyn_c(
    model: Model, time: ArrayLike, position: ArrayLike, every: int, break_at: float = np.inf, **options: float
) -> Arrays:
    """Run MoorDyn-C on a model written for it; see `benchmarks.programs.moordyn_c_along`.

    Parameters
    ----------
    time, position : (n,), (n, k) array
        Ends of the coupling steps, s, and the coordinates of the coupled objects there, m and rad.
    every : int
        A row is kept each so many coupling steps.
    break_at : float
        When line 1 comes off point 1, s.
    options
        MoorDyn's options by name.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = write_deck(Path(folder) / "model.dat", model, *(f"{v} {k}" for k, v in (QUIET | options).items()))
        job = {"time": np.asarray(time), "position": np.asarray(position), "every": every, "break_at": break_at}
        return call(PROGRAM, model=str(path), **job)


def timed(model: Model, **settings) -> tuple[xr.Dataset, float]:
    """Simulate, and return the wall time (s) too, without that of loading what is compiled."""
    load_kernels()
    begin = time.perf_counter()
    ds = quietly(model, **settings)
    return ds, time.perf_counter() - begin


@cache
def load_kernels() -> None:
    """Load what is compiled, once."""
    moorage.warmup()


def quietly(model: Model, **settings) -> xr.Dataset:
    """Simulate without its warnings, which the pages speak of."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        return moorage.simulate(model, **settings)


def at_rest(model: Model) -> xr.Dataset:
    """Solve for equilibrium without warnings."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        return moorage.solve_statics(model)


def with_environment(model: Model, **changed) -> Model:
    """Return a model in other surroundings."""
    return dataclasses.replace(model, environment=dataclasses.replace(model.environment, **changed))


def with_types(model: Model, **changed) -> Model:
    """Return a model with properties of all its line types changed; a function is applied to the old value."""
    types = tuple(
        dataclasses.replace(t, **{k: v(getattr(t, k)) if callable(v) else v for k, v in changed.items()})
        for t in model.line_types
    )
    return dataclasses.replace(model, line_types=types)
