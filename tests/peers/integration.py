"""Integration in time for the equations that stand beside ours and the peers'."""

from __future__ import annotations

import numpy as np


def runge_kutta(slope, start: np.ndarray, duration: float, step: float) -> tuple[np.ndarray, np.ndarray]:
    """Return times (n,) and states (n, ...) from a rate of the state, by the classic method of fourth order."""
    states = [start]
    for _ in range(round(duration / step)):
        y = states[-1]
        k1 = slope(y)
        k2 = slope(y + 0.5 * step * k1)
        k3 = slope(y + 0.5 * step * k2)
        k4 = slope(y + step * k3)
        states.append(y + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4))
    return step * np.arange(len(states)), np.array(states)
