"""Moorage's public `simulate`, in memory or to a file: what a user waits for after the program has started."""

from __future__ import annotations

import os
import sys
import tempfile
import time

import numpy as np

from benchmarks.cases import chains, surge_and_heave
from moorage.run import simulate
from moorage.solve import march


def run(job):
    """Run chains once.

    Parameters
    ----------
    job : dict
        `segments`, `lines`; `duration`, `dt_out` s; `save` ("tensions" or "all"); `to_file` and `threaded` (0 or 1).

    Returns
    -------
    dict
        `cpu`, `wall`, s; `memory`: largest of the process, bytes (NaN where unknown); `size` of the file, bytes.
    """
    duration = float(job["duration"])
    if not job["threaded"]:
        march.THREAD_NODES = 10**12
    model, motion = chains(int(job["segments"]), int(job["lines"])), surge_and_heave(duration + 1.0)
    simulate(chains(3), motion=motion, duration=1.0)
    with tempfile.TemporaryDirectory() as folder:
        output = os.path.join(folder, "run.nc") if job["to_file"] else None
        begin, clock = time.process_time(), time.perf_counter()
        result = simulate(
            model, motion=motion, duration=duration, dt_out=float(job["dt_out"]), save=str(job["save"]), output=output
        )
        cpu, wall = time.process_time() - begin, time.perf_counter() - clock
        result.close()
        size = os.path.getsize(output) if output else 0
    return {"cpu": cpu, "wall": wall, "memory": _largest_memory(), "size": size}


def _largest_memory() -> float:
    if sys.platform == "win32":
        return np.nan
    import resource  # noqa: PLC0415 - not on Windows

    unit = 1 if sys.platform == "darwin" else 1024
    return float(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit)
