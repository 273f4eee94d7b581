"""Runs of the moorings, here and by MoorDyn-C, and what is taken from them."""

from __future__ import annotations

import dataclasses

import numpy as np
import xarray as xr
from scipy.interpolate import CubicSpline

from moorage.io.moordyn.flatten import flatten
from moorage.model import Friction, Model, Motion
from studies.peers import at_rest, moordyn_c, timed, with_environment

COUPLING, KEEP = 0.025, 10  # s, and every how many coupling steps MoorDyn-C's rows are kept
OPTIONS = {"dtM": 0.0025, "TmaxIC": 300, "dtIC": 5.0, "threshIC": 1e-5, "CdScaleIC": 4.0, "ICgenDynamic": 1}


def ours(model: Model, motion: Motion, duration: float, dt: float = 0.25, **settings) -> tuple[xr.Dataset, float]:
    """Return a run and its wall time, s."""
    return timed(model, duration=duration, motion=motion, dt_out=dt, **({"dt_nodes": 1.0} | settings))


def theirs(model: Model, motion: Motion, duration: float):
    """Return MoorDyn-C's run; each line of two sections is two lines there.

    Their joints are put where they hang without friction, for with friction its start does not find that. It is told
    of a failure when it is time: what its file says of failures did nothing.
    """
    time = COUPLING * np.arange(round(duration / COUPLING) + 1)
    tracks = [CubicSpline(motion.time, track)(time) for track in motion.resolve(model, duration).values()]
    break_at = min((failure.time for failure in model.failures), default=np.inf)
    unbroken = dataclasses.replace(settled(model), failures=())
    return moordyn_c(unbroken, time, np.concatenate(tracks, axis=1), KEEP, break_at, **OPTIONS)


def settled(model: Model) -> Model:
    """Return the model with a line for each section, joined by free points where they hang without friction."""
    rest = at_rest(dataclasses.replace(with_environment(model, friction=None), failures=()))
    joints = iter(
        rest["node_position"].values[(rest["node_line"] == line.id).values][line.sections[0].segments]
        for line in model.lines
    )
    flat = flatten(model).model
    points = tuple(
        dataclasses.replace(point, position=tuple(map(float, next(joints)))) if point.kind == "free" else point
        for point in flat.points
    )
    return dataclasses.replace(flat, points=points)


def isotropic(friction: Friction, coefficient: float) -> Friction:
    """Return friction with one coefficient, which is all that MoorDyn-C has."""
    return dataclasses.replace(friction, axial=coefficient, transverse=coefficient)


def fairlead(ds: xr.Dataset, line: int = 1) -> np.ndarray:
    """Return the tension at the fairlead of a line (n,), kN."""
    return ds["fairlead_tension"].sel(line=line).values / 1e3


def node_tension(ds: xr.Dataset, nodes, line: int = 1) -> np.ndarray:
    """Return the mean tension of the two segments beside nodes of a line (m, k), kN."""
    tension = ds["segment_tension"].values[:, (ds["segment_line"] == line).values] / 1e3
    nodes = np.asarray(nodes)
    return 0.5 * (tension[:, nodes - 1] + tension[:, nodes])


def node_place(ds: xr.Dataset, nodes, line: int = 1) -> np.ndarray:
    """Return places of nodes of a line (m, k, 3), m."""
    return ds["node_position"].values[:, (ds["node_line"] == line).values][:, np.asarray(nodes)]


def node_time(ds: xr.Dataset) -> np.ndarray:
    """Return the times of the histories of nodes, s."""
    return ds["node_time" if "node_time" in ds.coords else "time"].values


def rms(values: np.ndarray) -> float:
    """Return the root of the mean square."""
    return float(np.sqrt(np.mean(np.square(values))))
