"""CableDyn: finite elements and implicit steps; one step for each interval of the motion."""

from __future__ import annotations

import time

import numpy as np
from cabledyn import CableDyn


def run(job):
    """Run a CableDyn deck, from its static solution.

    Parameters
    ----------
    job : dict
        `model`: path of a deck with dtM and TMax. `time` (n,): ends of steps, s. `position`, `velocity`, `acceleration`
        (n, m, 3): coupled points, m, m/s, m/s2.

    Returns
    -------
    dict
        `cpu`, `cpu_start` (s); `fairlead_tension`, `anchor_tension` (n, lines): at the end nodes, N; `iterations`.
    """
    begin = time.process_time()
    system = CableDyn(str(job["model"]))
    cpu_start = time.process_time() - begin
    at = job["time"]
    moved = system.host_dofs()
    q, v, a = (
        np.tile(held, (len(at), 1))
        for held in (system.get_coupled_motion()[0], np.zeros(system.n_coupled_dof), np.zeros(system.n_coupled_dof))
    )
    for target, name in ((q, "position"), (v, "velocity"), (a, "acceleration")):
        target[:, moved] = job[name].reshape(len(at), -1)
    lines = [line.id for line in system.lines]
    fairlead, anchor = np.zeros((len(at), len(lines))), np.zeros((len(at), len(lines)))
    fairlead[0] = system.channels([f"FairTen{id}" for id in lines])
    anchor[0] = system.channels([f"AnchTen{id}" for id in lines])
    loads = np.zeros(q.shape)
    iterations, step, solve, sample = 0, np.diff(at), system.step, system.calc_output
    begin = time.process_time()
    for k in range(len(at) - 1):
        iterations += solve(step[k], q[k + 1], v[k + 1], a[k + 1])
        loads[k + 1] = sample()
    cpu = time.process_time() - begin
    return {
        "cpu": cpu,
        "cpu_start": cpu_start,
        "static_fairlead_tension": fairlead[0],
        "static_anchor_tension": anchor[0],
        "load": loads[:, moved].reshape(job["position"].shape),
        "iterations": iterations,
    }
