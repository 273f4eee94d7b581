"""How a run marches: settings in words, and the constants of the time loop that follow from them and the system."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.physics.soil import Law
from moorage.solve.march_kernel import Control
from moorage.system.build import Built


class Settings(NamedTuple):
    """How to march.

    Parameters
    ----------
    method : {"implicit", "rk2", "rk4"}
    tolerance : float or None
        Accepted error h^2 |a1 - a0| of a step in the position of the nodes (rms over an island), m; also scales the
        velocity increment at which Newton's method stops. None: see `default_tolerance`.
    time_step : float or None
        Constant step, s; None: adaptive (implicit only).
    dt_out : float
        Interval of the records, s.
    dt_nodes : float or None
        Interval of the node histories, s; None: none.
    watch : tuple of (line index, node index)
        Nodes recorded at `dt_out`.
    """

    method: str = "implicit"
    tolerance: float | None = None
    time_step: float | None = None
    dt_out: float = 0.1
    dt_nodes: float | None = None
    watch: tuple[tuple[int, int], ...] = ()


def default_tolerance(built: Built) -> float:
    """Return the tolerance (m) that gives tensions to 1 % rms or better: 2 mm for segments of 1 to 20 m.

    An error in position stands for EA / l times as much tension, so that long segments bear more; and what is small
    for a mooring at sea is not for one in a basin. Soil with a memory gives way within D / k_max.
    """
    shortest = float(built.names.segment_length.min(initial=np.inf))
    tolerance = max(1e-4 * shortest, min(2e-3, 2e-3 * shortest)) if np.isfinite(shortest) else 2e-3
    soil = built.system.contact.soil
    return min(tolerance, float(soil.size[:, 1].min()) / Law(*soil.law.tolist()).stiffness) if soil.on else tolerance


def control_of(settings: Settings, built: Built) -> Control:
    """Translate settings into the constants of the time loop; `built` stands where the run starts."""
    orders = {"implicit": 0, "rk2": 2, "rk4": 4}
    if settings.method not in orders:
        raise ValueError(f"method is one of {', '.join(orders)}, not {settings.method!r}")
    order, adaptive = orders[settings.method], settings.time_step is None
    tolerance = default_tolerance(built) if settings.tolerance is None else settings.tolerance
    if order and adaptive:
        raise ValueError(f"method {settings.method!r} needs a time step: it does not control its own")
    return Control(
        order=order,
        adaptive=int(adaptive),
        step=0.02 if settings.time_step is None else float(settings.time_step),
        step_min=1e-7,
        step_max=0.15,
        error=tolerance if adaptive else 1e30,
        rho=0.7,
        newton=25.0 * tolerance,
        # the error estimate of adaptive steps sees what is left behind as well; a constant step has nothing else
        leftover=(0.25 if adaptive else 0.1) * tolerance * force_scales(built),
        stretch=stretch_scales(built),
        iterations=10,
        breaks=1,
    )


def over_islands(built: Built, values) -> np.ndarray:
    """Return the largest of values (segments, ...) over the lines of each island."""
    ptr = built.system.lines.node_ptr
    out = np.zeros((len(built.system.islands.line_ptr) - 1, *np.shape(values)[1:]))
    if len(ptr) == 1:
        return out
    lines = np.maximum.reduceat(values, (ptr - np.arange(len(ptr)))[:-1])
    np.maximum.at(out, built.island_of_line, lines)
    return out


def force_scales(built: Built) -> np.ndarray:
    """Return the size of the forces in each island, N: its largest tension now, the weight of a line, or 1e-6 EA."""
    system, length = built.system, built.system.tension.length
    if not len(length):
        return np.zeros(len(system.islands.line_ptr) - 1)
    ptr = system.lines.node_ptr - np.arange(len(system.lines.node_ptr))
    first = np.arange(len(length)) + np.repeat(np.arange(len(ptr) - 1), np.diff(ptr))
    span = np.linalg.norm(built.state.position[first + 1] - built.state.position[first], axis=1)
    tension = system.tension.spring * np.maximum(span - length, 0.0)
    dry = -0.5 * (system.weight.dry[first] + system.weight.dry[first + 1])
    weight = np.add.reduceat(np.abs(dry - system.weight.buoyancy), ptr[:-1])
    least = 1e-6 * system.tension.spring * length  # nothing may pull or weigh at the start
    return over_islands(built, np.maximum(np.maximum(tension, least), np.repeat(weight, np.diff(ptr))))


def stretch_scales(built: Built) -> np.ndarray:
    """Return the largest EA / (2 l^2) and BA / l^2 in each island."""
    tension = built.system.tension
    return over_islands(built, np.stack([0.5 * tension.spring, tension.damper], axis=1) / tension.length[:, None])
