"""Moorage inside another program that moves its points, one coupling step at a time."""

from __future__ import annotations

import time

import numpy as np

from benchmarks.cases import chains
from moorage.simulation import Simulation


def run(job):
    """Step chains along a path.

    Parameters
    ----------
    job : dict
        `segments`, `lines`; `time` (n,) s; `position`, `velocity` (n, m, 3) of the coupled points, m and m/s.

    Returns
    -------
    dict
        `cpu` of all steps, s; `load` (n, m, 3): forces on the points, N.
    """
    simulation = Simulation(chains(int(job["segments"]), int(job["lines"])))
    at, position, velocity = job["time"].tolist(), job["position"], job["velocity"]
    load = np.zeros(position.shape)
    load[0] = simulation.initialize(position[0])
    begin = time.process_time()
    for k in range(1, len(at)):
        load[k] = simulation.step(at[k], position[k], velocity[k])
    return {"cpu": time.process_time() - begin, "load": load}
