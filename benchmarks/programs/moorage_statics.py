"""Moorage's statics, from the bare solver to the labelled result."""

from __future__ import annotations

import time

import numpy as np

from benchmarks.cases import chains
from moorage.run import solve_statics
from moorage.solve.statics import solve
from moorage.system.build import build


def run(job):
    """Solve chains again and again (`segments`, `lines`, `repeat`); returns CPU times (repeat,) of parts, s."""
    model = chains(int(job["segments"]), int(job["lines"]))
    solve_statics(model)
    times = []
    for _ in range(int(job["repeat"])):
        begin = time.process_time()
        built = build(model)
        between = time.process_time()
        solve(built)
        solved = time.process_time()
        solve_statics(model)
        times.append((solved - between, solved - begin, time.process_time() - solved))
    return dict(zip(("solver", "model to solver", "model to dataset"), np.array(times).T, strict=True))
