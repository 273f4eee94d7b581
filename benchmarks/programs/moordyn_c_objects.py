"""MoorDyn-C's rods and bodies, free or held, without a host: for comparisons, not for timing."""

from __future__ import annotations

import os

import moordyn
import numpy as np


def run(job):
    """Run a MoorDyn-C model with everything coupled held where it is described.

    Parameters
    ----------
    job : dict
        `model`: path. `time` (n,): ends of coupling steps, s. `held` (m,): places and angles of what is coupled.

    Returns
    -------
    dict
        `rod_position` (n, rods, 2, 3) ends A and B, m; `body_state` (n, bodies, 6) position, m, and angles, rad.
    """
    model, at, held = str(job["model"]), job["time"], job["held"].tolist()
    os.chdir(os.path.dirname(model))
    system = moordyn.Create(os.path.basename(model))
    moordyn.Init(system, held, [0.0] * len(held))
    rods = [moordyn.GetRod(system, k + 1) for k in range(moordyn.GetNumberRods(system))]
    bodies = [moordyn.GetBody(system, k + 1) for k in range(moordyn.GetNumberBodies(system))]
    rows = [_row(rods, bodies)]
    for k, step in enumerate(np.diff(at)):
        moordyn.Step(system, held, [0.0] * len(held), float(at[k]), float(step))
        rows.append(_row(rods, bodies))
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


def _row(rods, bodies):
    ends = [[moordyn.GetRodNodePos(rod, i) for i in (0, moordyn.GetRodN(rod))] for rod in rods]
    return {"rod_position": ends, "body_state": [moordyn.GetBodyState(body)[0] for body in bodies]}
