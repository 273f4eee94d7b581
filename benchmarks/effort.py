"""How much is measured: everything, or just enough to see that the benchmarks work."""

from __future__ import annotations

from typing import NamedTuple


class Effort(NamedTuple):
    """Sizes of the measurements."""

    turns: int  # how often the programs take turns
    repeat: int  # timed runs in each process
    duration: float  # of a run of chains, s
    hour: float  # of the long run, s
    segments: tuple[int, ...]  # of the chains, each
    lines: int  # of the large mooring
    spread: float  # duration of the large mooring's run, s
    starts: int  # processes that are started for each kind of start
    cold: bool  # whether the kernels are compiled anew
    prototype: bool  # whether the prototype is run


FULL = Effort(4, 3, 300.0, 3600.0, (20, 50, 100), 1000, 60.0, 20, True, True)
QUICK = Effort(1, 1, 3.0, 6.0, (20,), 12, 2.0, 1, False, False)
