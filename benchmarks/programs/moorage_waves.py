"""Moorage's solver on the lazy-wave cable in a JONSWAP sea: the time loop without files and labels."""

from __future__ import annotations

import dataclasses
import time

import numpy as np

from benchmarks.cases import lazy_wave, swell
from moorage.layout import copy_of
from moorage.model import Waves
from moorage.solve.march import March, Settings
from moorage.solve.statics import solve
from moorage.system.build import build

HEIGHT, PERIOD, RAMP = 8.25, 14.5, 20.0  # m, s, s: the sea of Hall, Sirnivas & Yu 2020


def run(job):
    """Run the cable several times from its static state, its top moved in all seas alike.

    Parameters
    ----------
    job : dict
        `components` (0: still water), `exact` (1: sums at each evaluation); `duration`, `dt_out` s; `time_step` s
        (0: adaptive); `tolerance` m (0: default); `repeat`.

    Returns
    -------
    dict
        `cpu` (repeat,) of the time loop, s; `top_tension` (n,) of the last segment, N; `steps`, `rejected`,
        `iterations`.
    """
    duration, components = float(job["duration"]), int(job["components"])
    settings = Settings(
        time_step=float(job["time_step"]) or None,
        tolerance=float(job["tolerance"]) or None,
        dt_out=float(job["dt_out"]),
    )
    model = lazy_wave()
    if components:
        depth = model.environment.water_depth
        sea = Waves.irregular(
            "jonswap", HEIGHT, PERIOD, depth=depth, gamma=3.3, components=components, ramp=RAMP,
            exact=bool(job["exact"]),
        )  # fmt: skip
        model = dataclasses.replace(model, environment=dataclasses.replace(model.environment, waves=sea))
    built = build(model, swell(duration + 1.0), duration)
    solve(built)
    start = copy_of(built.state)
    March(built._replace(state=copy_of(start)), settings, 1.0).advance(1.0)
    cpu, block, counters = [], {}, {}
    for _ in range(int(job["repeat"])):
        fresh = built._replace(state=copy_of(start))
        begin = time.process_time()
        march = March(fresh, settings, duration)
        block = march.advance(duration)
        cpu.append(time.process_time() - begin)
        counters = march.counters
    return {"cpu": np.array(cpu), "top_tension": block["end_tension"][:, 0, 1], **counters}
