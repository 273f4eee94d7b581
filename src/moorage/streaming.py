"""The loop of a run: march, hand over each block, stop where it is safe, and say how it ended."""

from __future__ import annotations

import signal
import threading
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
import xarray as xr

from moorage.errors import ModelWarning, RunInterrupted, SimulationError
from moorage.results import Layout, MemoryResult, MoordynOut, StreamWriter
from moorage.solve.blocks import Block
from moorage.solve.march import March

Progress = Callable[[float, float, float], None]

BLOCK_SECONDS = 0.2  # wall time between two writes: what a killed run can lose
BLOCK_ROWS = 5000  # most output times in one block, for its memory
SHOCK = 0.01  # m/s; a faster start of the imposed motion is worth a warning


def stream(
    march: March,
    result: MemoryResult | StreamWriter,
    layout: Layout,
    progress: Progress | None = None,
    keep: Callable[[], None] | None = None,
    resumed: bool = False,
    text: MoordynOut | None = None,
) -> xr.Dataset:
    """March to the end, hand every block to the result, and close it with the status of the run.

    Parameters
    ----------
    progress : callable, optional
        Called after each block with simulated time, duration and wall time since the first block, s.
    keep : callable, optional
        Called after each block is written, to save a checkpoint.
    resumed : bool
        The records of the present time are there already.
    text : MoordynOut, optional
        MoorDyn's files, which get every block before the result does: so a checkpoint never knows more than they hold.
    """
    begin: float | None = None
    status = f"interrupted at {march.time:g} s"
    try:
        with deferred_interrupt() as asked:
            for block in blocks(march, resumed):
                warn_of_shock(block)
                if text is not None:
                    text.append(block)
                result.append(layout.columns(block))
                if keep is not None:
                    keep()
                status = f"interrupted at {march.time:g} s"
                if begin is None:
                    begin = time.perf_counter()  # kernels may have been compiled for the first block
                if progress is not None:
                    progress(march.time, march.duration, time.perf_counter() - begin)
                if asked():
                    raise RunInterrupted(status, march.time)
            status = "complete"
    except RunInterrupted as error:
        error.dataset = result.dataset
        raise
    except SimulationError as error:
        status = f"failed at {error.time:g} s: {str(error).splitlines()[0]}"
        if text is not None:
            text.append(error.block)  # type: ignore[attr-defined]
        result.append(layout.columns(error.block))  # type: ignore[attr-defined]
        error.dataset = result.dataset
        raise
    finally:
        if text is not None:
            text.close()
        result.close({"status": status, **march.counters})
    return result.dataset()


def blocks(march: March, resumed: bool = False) -> Iterator[Block]:
    """Yield the records of a run in blocks of about `BLOCK_SECONDS` of wall time, from where the march stands."""
    dt = march.settings.dt_out
    done, last, count = round(march.time / dt), round(march.duration / dt), 1
    if not resumed:
        yield march.first()
    while done < last:
        begin = time.perf_counter()
        step = min(count, last - done)
        done += step
        block = march.advance(done * dt)
        pace = step / (time.perf_counter() - begin)
        count = int(np.clip(pace * BLOCK_SECONDS, 1, min(4 * count, BLOCK_ROWS)))
        yield block


@contextmanager
def deferred_interrupt() -> Iterator[Callable[[], bool]]:
    """Hold the first Ctrl-C back and give a function that tells whether there was one; a second one acts at once.

    Only the main thread can take signals; elsewhere nothing is held back.
    """
    asked = threading.Event()
    if threading.current_thread() is not threading.main_thread():
        yield asked.is_set
        return

    def note(number, frame):
        if asked.is_set():
            raise KeyboardInterrupt
        asked.set()

    before = signal.signal(signal.SIGINT, note)
    try:
        yield asked.is_set
    finally:
        signal.signal(signal.SIGINT, before)


def warn_of_shock(block: Block) -> None:
    """Warn when the first block shows an imposed motion that does not start from rest."""
    if len(block["time"]) and block["time"][0] == 0.0:
        speed = float(np.sqrt((block["point_velocity"][0] ** 2).sum(axis=-1)).max(initial=0.0))
        if speed > SHOCK:
            warnings.warn(
                f"the imposed motion starts with {speed:.2g} m/s while the lines start at rest, which sends a shock "
                "along them; let it come in over a ramp of some tens of seconds",
                ModelWarning,
                stacklevel=4,
            )
