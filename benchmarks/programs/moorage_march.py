"""Moorage's solver: the time loop without files and labels, tensions at both ends of all lines kept."""

from __future__ import annotations

import time

import numpy as np

from benchmarks.cases import chains, lazy_wave, surge_and_heave, swell
from moorage.layout import copy_of
from moorage.solve import march
from moorage.solve.march import March, Settings
from moorage.solve.statics import solve
from moorage.system.build import build


def run(job):
    """Run chains, or the cable, several times from the same static state.

    Parameters
    ----------
    job : dict
        `segments`, `lines` (0: the cable); `duration`, `dt_out` s; `time_step` s (0: adaptive); `tolerance` m (0:
        default); `repeat`; `threaded` (0: one thread).

    Returns
    -------
    dict
        `cpu`, `wall` (repeat,) of the time loop, s; `cpu_build`, `cpu_statics`, s; `end_tension` (n, lines) of the last
        segments, N; `steps`, `rejected`, `iterations`.
    """
    duration, tolerance = float(job["duration"]), float(job["tolerance"]) or None
    settings = Settings(time_step=float(job["time_step"]) or None, tolerance=tolerance, dt_out=float(job["dt_out"]))
    if not job["threaded"]:
        march.THREAD_NODES = 10**12
    lines = int(job["lines"])
    model = chains(int(job["segments"]), lines) if lines else lazy_wave()
    motion = (surge_and_heave if lines else swell)(duration + 1.0)
    warm = build(chains(3), motion, 1.0)
    solve(warm)
    March(warm, settings, 1.0).advance(1.0)
    begin = time.process_time()
    built = build(model, motion, duration)
    cpu_build = time.process_time() - begin
    begin = time.process_time()
    solve(built)
    cpu_statics = time.process_time() - begin
    start = copy_of(built.state)
    cpu, wall, block, counters = [], [], {}, {}
    for _ in range(int(job["repeat"])):
        fresh = built._replace(state=copy_of(start))
        begin, clock = time.process_time(), time.perf_counter()
        run = March(fresh, settings, duration)
        block = run.advance(duration)
        cpu.append(time.process_time() - begin)
        wall.append(time.perf_counter() - clock)
        counters = run.counters
    return {
        "cpu": np.array(cpu),
        "wall": np.array(wall),
        "cpu_build": cpu_build,
        "cpu_statics": cpu_statics,
        "end_tension": block["end_tension"][:, :, 1],
        **counters,
    }
