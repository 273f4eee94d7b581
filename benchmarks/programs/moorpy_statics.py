"""MoorPy: quasi-static catenaries that hold one body."""

from __future__ import annotations

import time

import moorpy
import numpy as np


def run(job):
    """Solve a mooring of equal lines at a body that is held at the origin.

    Parameters
    ----------
    job : dict
        `depth`, `gravity`, `density`; `anchor` and `fairlead` (lines, 3), m; `length` m, `diameter` m, `mass` kg/m,
        `stiffness` N of all lines.

    Returns
    -------
    dict
        `anchor_tension`, `fairlead_tension` (lines,), N; `stiffness` (6, 6) of the body, N, m, rad; `force` (6,) on it;
        `cpu`, s, with setting up.
    """
    begin = time.process_time()
    system = moorpy.System(depth=float(job["depth"]), rho=float(job["density"]), g=float(job["gravity"]))
    diameter, mass = float(job["diameter"]), float(job["mass"])
    weight = (mass - np.pi / 4.0 * diameter**2 * system.rho) * system.g
    kind = {"name": "main", "d_vol": diameter, "w": weight, "m": mass, "EA": float(job["stiffness"])}
    system.lineTypes["main"] = kind
    system.addBody(1, np.zeros(6))
    body = system.bodyList[0]
    for anchor, fairlead in zip(job["anchor"], job["fairlead"], strict=True):
        system.addPoint(1, anchor)
        system.addPoint(1, fairlead)
        body.attachPoint(len(system.pointList), fairlead)
        system.addLine(float(job["length"]), "main", pointA=len(system.pointList) - 1, pointB=len(system.pointList))
    system.initialize()
    cpu = time.process_time() - begin
    lines = system.lineList
    return {
        "anchor_tension": np.array([line.TA for line in lines]),
        "fairlead_tension": np.array([line.TB for line in lines]),
        "stiffness": body.getStiffnessA(lines_only=True),
        "force": body.getForces(lines_only=True),
        "cpu": cpu,
    }
