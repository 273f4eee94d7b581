"""MoorDyn-C with what is along its lines kept every few coupling steps, and its wall time."""

from __future__ import annotations

import os
import time

import moordyn
import numpy as np


def run(job):
    """Run a MoorDyn-C model from its own stationary solution, or as described where it has none (TmaxIC 0).

    Parameters
    ----------
    job : dict
        `model`: path. `time` (n,): ends of coupling steps, s. `position` (n, k): coordinates of the coupled objects, m
        and rad. `every`: keep a row each so many steps. `break_at`, optional: when line 1 comes off point 1, s.

    Returns
    -------
    dict
        `wall`, `wall_start` (s); for the rows kept `time` (m,), `node_position` (m, nodes, 3), `node_tension`
        (m, nodes, 3) vectors in N, `node_curvature` (m, nodes) 1/m, `end_tension` (m, lines) of the last segment, N.
    """
    model, at, position, every = str(job["model"]), job["time"], job["position"], int(job["every"])
    os.chdir(os.path.dirname(model))
    system = moordyn.Create(os.path.basename(model))
    begin = time.perf_counter()
    moordyn.Init(system, position[0].tolist(), [0.0] * position.shape[1])
    wall_start = time.perf_counter() - begin
    lines = [moordyn.GetLine(system, k + 1) for k in range(moordyn.GetNumberLines(system))]
    nodes = [(line, i) for line in lines for i in range(moordyn.GetLineNumberNodes(line))]
    velocity = np.diff(position, axis=0) / np.diff(at)[:, None]  # held over a coupling step, so the chord's
    break_at = float(job.get("break_at", np.inf))
    rows, wall = [_row(nodes, lines)], 0.0
    for k, step in enumerate(np.diff(at)):
        if at[k] >= break_at:
            moordyn.BreakLine(system, moordyn.GetPoint(system, 1), lines[0])
            break_at = np.inf
        begin = time.perf_counter()
        moordyn.Step(system, position[k].tolist(), velocity[k].tolist(), float(at[k]), float(step))
        wall += time.perf_counter() - begin
        if (k + 1) % every == 0:
            rows.append(_row(nodes, lines))
    kept = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    return kept | {"time": at[::every], "wall": wall, "wall_start": wall_start}


def _row(nodes, lines):
    return {
        "node_position": [moordyn.GetLineNodePos(*node) for node in nodes],
        "node_tension": [moordyn.GetLineNodeTen(*node) for node in nodes],
        "node_curvature": [moordyn.GetLineNodeCurv(*node) for node in nodes],
        "end_tension": [moordyn.GetLineFairTen(line) for line in lines],
    }
