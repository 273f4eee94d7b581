"""MoorDyn-C: the coupled points are moved one coupling step at a time."""

from __future__ import annotations

import os
import time

import moordyn
import numpy as np


def run(job):
    """Run a MoorDyn-C model, from its own stationary solution.

    Parameters
    ----------
    job : dict
        `model`: path. `time` (n,): ends of coupling steps, s. `position` (n, m, 3): coupled points, m. `budget`
        (optional): CPU seconds after which to give up.

    Returns
    -------
    dict
        `cpu`, `cpu_start` (s); `end_tension` (n, lines): of the last segment, N; `point_force` (n, m, 3), N; rows that
        were not reached are NaN. `node_position`, `node_force` (2, nodes, 3): first and last, m and N, no inertia;
        `line_node` (lines + 1,): where the nodes of each line begin.
    """
    model, at, position = str(job["model"]), job["time"], job["position"]
    budget = float(job.get("budget", np.inf))
    os.chdir(os.path.dirname(model))
    system = moordyn.Create(os.path.basename(model))
    points = position.reshape(len(at), -1)
    begin = time.process_time()
    moordyn.Init(system, points[0].tolist(), [0.0] * points.shape[1])
    cpu_start = time.process_time() - begin
    lines = [moordyn.GetLine(system, k + 1) for k in range(moordyn.GetNumberLines(system))]
    nodes = [moordyn.GetLineNumberNodes(line) for line in lines]
    first = _nodes(lines, nodes)
    # held over a coupling step, so the chord's: the path of the points is then continuous
    velocity = np.diff(points, axis=0) / np.diff(at)[:, None]
    tension, force = np.full((len(at), len(lines)), np.nan), np.full(points.shape, np.nan)
    tension[0] = [moordyn.GetLineFairTen(line) for line in lines]
    where, speed, when, steps = points.tolist(), velocity.tolist(), at.tolist(), np.diff(at).tolist()
    begin = time.process_time()
    for k, step in enumerate(steps):
        force[k + 1] = moordyn.Step(system, where[k], speed[k], when[k], step)
        tension[k + 1] = [moordyn.GetLineFairTen(line) for line in lines]
        if k % 256 == 0 and (time.process_time() - begin > budget or not np.isfinite(tension[k + 1]).all()):
            break
    cpu = time.process_time() - begin
    position_force = np.stack([first, _nodes(lines, nodes)])
    return {
        "cpu": cpu,
        "cpu_start": cpu_start,
        "end_tension": tension,
        "point_force": force.reshape(position.shape),
        "node_position": position_force[:, 0],
        "node_force": position_force[:, 1],
        "line_node": np.concatenate([[0], np.cumsum(nodes)]),
    }


def _nodes(lines, nodes):
    """Positions and net forces of all nodes, (2, nodes, 3)."""
    return np.array(
        [
            [read(line, i) for line, n in zip(lines, nodes, strict=True) for i in range(n)]
            for read in (moordyn.GetLineNodePos, moordyn.GetLineNodeForce)
        ]
    )
