"""MoorDyn's .out files of a system that a host steps: beside its input file, at the interval dtOut or at every step."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from moorage.model import Model
from moorage.results import MoordynOut, plan_outputs, watch_list
from moorage.solve.host import HostMarch
from moorage.solve.record import new_record
from moorage.system.build import Built


class Text:
    """The files of one system; none where the model asks for nothing."""

    def __init__(self, path: Path, model: Model, built: Built, rows: int | None = None):
        outputs = plan_outputs(model, built)
        count = None if rows is None else {"time": rows, "node_time": rows}
        self.out = MoordynOut(path.with_suffix(""), model, built, outputs, True, count)
        self.rows, self.interval = rows or 0, model.output_interval or 0.0
        watched = np.array(watch_list(model), dtype=np.int64).reshape(-1, 2)
        self._record = new_record(built.system, np.zeros(1), np.zeros(1), watched)

    def write(self, host: HostMarch, dt: float) -> None:
        """Write the present time, if its turn has come in the step of dt (s)."""
        t = host.time
        due = self.interval == 0.0 or t + 1e-9 >= (math.floor((t - dt + 1e-9) / self.interval) + 1.0) * self.interval
        if self.out.files and (due or not self.rows):
            self.out.append(host.fill(self._record))
            self.rows += 1

    def close(self) -> None:
        """Close the files."""
        self.out.close()
