"""MoorDyn-C with all nodes of its lines kept, and the water at given places: for comparisons, not for timing."""

from __future__ import annotations

import os

import moordyn
import numpy as np


def run(job):
    """Run a MoorDyn-C model whose coupled points are moved one coupling step at a time.

    Parameters
    ----------
    job : dict
        `model`: path. `time` (n,): ends of coupling steps, s. `position` (n, m, 3): coupled points, m. `places` (k, 3),
        optional: where the water is asked for, m. `water` (n - 1, 2, 3), optional: velocity and acceleration of the
        water in each step, the same everywhere and held, m/s and m/s2 (for WaveKin 1).

    Returns
    -------
    dict
        `node_position`, `node_velocity` (n, nodes, 3), `end_force` (n, lines, 3) net force on the last node of each
        line, N; with places, `elevation` (n, k), `water_velocity` and `water_acceleration` (n, k, 3).
    """
    model, at, position = str(job["model"]), job["time"], job["position"]
    places = job.get("places", np.zeros((0, 3)))
    os.chdir(os.path.dirname(model))
    system = moordyn.Create(os.path.basename(model))
    points = position.reshape(len(at), -1)
    moordyn.Init(system, points[0].tolist(), [0.0] * points.shape[1])
    lines = [moordyn.GetLine(system, k + 1) for k in range(moordyn.GetNumberLines(system))]
    nodes = [(line, i) for line in lines for i in range(moordyn.GetLineNumberNodes(line))]
    last = [(line, moordyn.GetLineNumberNodes(line) - 1) for line in lines]
    waves = moordyn.GetWaves(system) if len(places) else None
    water = job.get("water", np.zeros((0, 2, 3)))
    if len(water):
        moordyn.ExternalWaveKinInit(system)
    # its GetN gives an error code
    count = len(moordyn.ExternalWaveKinGetCoordinates(system)) if len(water) else 0
    velocity = np.diff(points, axis=0) / np.diff(at)[:, None]
    rows = [_row(nodes, last, waves, places)]
    for k, step in enumerate(np.diff(at)):
        if len(water):
            moordyn.ExternalWaveKinSet(system, *(np.tile(values, (count, 1)).tolist() for values in water[k]), at[k])
        moordyn.Step(system, points[k].tolist(), velocity[k].tolist(), float(at[k]), float(step))
        rows.append(_row(nodes, last, waves, places))
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


def _row(nodes, last, waves, places):
    water = [moordyn.GetWavesKin(waves, *map(float, place)) for place in places]
    return {
        "node_position": [moordyn.GetLineNodePos(*node) for node in nodes],
        "node_velocity": [moordyn.GetLineNodeVel(*node) for node in nodes],
        "end_force": [moordyn.GetLineNodeForce(*node) for node in last],
        "elevation": [found[2] for found in water],
        "water_velocity": [found[0] for found in water],
        "water_acceleration": [found[1] for found in water],
    }
