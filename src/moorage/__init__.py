"""Moorage: dynamics of mooring lines and power cables, from MoorDyn files to labelled results.

>>> import moorage
>>> model = moorage.read("lines.dat")                    # doctest: +SKIP
>>> ds = moorage.simulate(model, duration=300.0)         # doctest: +SKIP

Everything is imported when it is first used, so that `import moorage` is instant.
"""

from __future__ import annotations

from importlib import import_module
from importlib.metadata import version
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from moorage import io, plot, results
    from moorage._jit import is_cold
    from moorage.about_rest import natural_modes, stiffness
    from moorage.clamp_doubts import backward_clamps
    from moorage.errors import (
        ConvergenceError,
        InputError,
        ModelError,
        ModelWarning,
        MoorageError,
        MotionError,
        ResultError,
        RunInterrupted,
        SimulationError,
        UnsupportedError,
    )
    from moorage.io import convert, read, read_bathymetry, read_friction_map, read_stiffness_map
    from moorage.io.motion import Motion
    from moorage.model import Model
    from moorage.model.checks import lacking, suspicious
    from moorage.model.unbuilt import unbuilt
    from moorage.reporting import report
    from moorage.results import envelope, line, open_result, write_vtk
    from moorage.run import simulate, solve_statics
    from moorage.show import view
    from moorage.simulation import Simulation

    __version__: str

_ERRORS = (
    "ConvergenceError",
    "InputError",
    "ModelError",
    "ModelWarning",
    "MoorageError",
    "MotionError",
    "ResultError",
    "RunInterrupted",
    "SimulationError",
    "UnsupportedError",
)
_MODULES = ("io", "plot", "results")
_HOMES = {
    **dict.fromkeys(_ERRORS, "errors"),
    "Model": "model",
    "Motion": "io.motion",  # this module gives Motion its reader
    "Simulation": "simulation",
    "backward_clamps": "clamp_doubts",
    "convert": "io",
    "envelope": "results",
    "is_cold": "_jit",
    "lacking": "model.checks",
    "line": "results",
    "natural_modes": "about_rest",
    "open_result": "results",
    "read": "io",
    "read_bathymetry": "io",
    "read_friction_map": "io",
    "read_stiffness_map": "io",
    "report": "reporting",
    "simulate": "run",
    "solve_statics": "run",
    "stiffness": "about_rest",
    "suspicious": "model.checks",
    "unbuilt": "model.unbuilt",
    "view": "show",
    "warmup": "warm",
    "write_vtk": "results",
}

__all__ = [
    "ConvergenceError",
    "InputError",
    "Model",
    "ModelError",
    "ModelWarning",
    "MoorageError",
    "Motion",
    "MotionError",
    "ResultError",
    "RunInterrupted",
    "Simulation",
    "SimulationError",
    "UnsupportedError",
    "backward_clamps",
    "convert",
    "envelope",
    "io",
    "is_cold",
    "lacking",
    "line",
    "natural_modes",
    "open_result",
    "plot",
    "read",
    "read_bathymetry",
    "read_friction_map",
    "read_stiffness_map",
    "report",
    "results",
    "simulate",
    "solve_statics",
    "stiffness",
    "suspicious",
    "unbuilt",
    "view",
    "warmup",
    "write_vtk",
]


def __getattr__(name: str):
    if name == "__version__":
        return version("moorage")
    if name in _MODULES:
        return import_module(f"moorage.{name}")
    if name in _HOMES:
        return getattr(import_module(f"moorage.{_HOMES[name]}"), name)
    raise AttributeError(f"module 'moorage' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
