"""Run Moorage and MoorDyn-C on one file, moved by one motion."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from benchmarks.programs import call, is_installed
from scipy.interpolate import CubicSpline

import moorage

# MoorDyn-C by itself: fourth order, small steps, a stationary start that is given time
REFINED = {"dtM": 0.001, "tScheme": "rk4", "dtIC": 1.0, "TmaxIC": 600, "threshIC": 1e-6, "disableOutput": 1, "disableOutTime": 1}  # fmt: skip


def needs(program):
    """Skip a module's tests, saying so, where a program is not installed."""
    return [
        pytest.mark.peers,
        pytest.mark.skipif(not is_installed(program), reason=f"{program.split('_')[0]} is not installed"),
    ]


def read(path):
    """Read a model; which of MoorDyn's options mean nothing here is not of interest."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        return moorage.read(path)


def statics(model):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        return moorage.solve_statics(model)


def simulate(model, **settings):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        return moorage.simulate(model, **settings)


def moordyn_at_rest(path, model, duration=1.0):
    """Return MoorDyn-C's state after its points were held for some time (s)."""
    held = np.array([point.position for point in model.coupled_points])
    return call("moordyn_c", model=str(path), time=np.array([0.0, duration]), position=np.stack([held, held]))


def moordyn_moved(path, model, motion, duration, interval=0.0125):
    """Return MoorDyn-C's run with short coupling steps, along the path that Moorage's points take."""
    time = interval * np.arange(round(duration / interval) + 1)
    tracks = motion.resolve(model, duration).values()
    position = np.stack([CubicSpline(motion.time, track)(time) for track in tracks], axis=1)
    return call("moordyn_c", model=str(path), time=time, position=position)


def rms(values, reference):
    """Rms of the difference over the rms of the reference, along time."""
    return np.sqrt(np.mean((values - reference) ** 2, axis=0) / np.mean(reference**2, axis=0))
