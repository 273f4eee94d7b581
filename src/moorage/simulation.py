"""A mooring inside another program, step by step."""

from __future__ import annotations

from typing import Literal

import numpy as np

from moorage.accept import accept, check_settings
from moorage.errors import Problem, UnsupportedError
from moorage.model import Model
from moorage.solve.host import HostMarch
from moorage.solve.march import Block, Settings
from moorage.system.build import build


class Simulation:
    """A mooring inside another program, which moves the coupled points and receives the forces on them.

    Parameters
    ----------
    model : Model
    tolerance, time_step, method
        As for `simulate`.
    host_waves : bool
        The host says what the water does (`set_water`); so it is without asking when the model says so.

    Attributes
    ----------
    points : (m,) int
        Ids of the coupled points, in the order of all arrays here.

    Examples
    --------
    >>> sim = moorage.Simulation(model)                      # doctest: +SKIP
    >>> forces = sim.initialize()                            # doctest: +SKIP
    >>> state = sim.save()                                   # doctest: +SKIP
    >>> forces = sim.step(0.1, position, velocity)           # doctest: +SKIP
    >>> sim.restore(state)  # to try the step again          # doctest: +SKIP
    """

    def __init__(
        self,
        model: Model,
        *,
        tolerance: float | None = None,
        time_step: float | None = None,
        method: Literal["implicit", "rk2", "rk4"] = "implicit",
        host_waves: bool = False,
    ):
        chosen = {"tolerance": tolerance, "time_step": time_step}
        check_settings({**chosen, "method": method}, False, None)
        accept(model)
        _only_points_are_coupled(model)
        self._hosts_water = model.environment.host_waves or host_waves
        if self._hosts_water and model.environment.waves is not None:
            remedy = "remove them from the model, or leave host_waves out"
            raise UnsupportedError(Problem("the model has waves of its own", remedy, model.environment.waves.source))
        if model.failures:
            raise UnsupportedError(Problem("failures come in simulate() only", "remove them", model.failures[0].source))
        self.model = model
        built = build(model)
        self.points = built.names.points[built.coupled]
        self._host = HostMarch(built, Settings(method=method, **chosen), self._hosts_water)  # type: ignore[arg-type]

    @property
    def time(self) -> float:
        """Time of the state, s."""
        return self._host.time

    @property
    def position(self) -> np.ndarray:
        """Positions of the coupled points, (m, 3), m."""
        return self._host.position.copy()

    def initialize(self, position=None, velocity=None) -> np.ndarray:
        """Start at time 0 and return the forces of the mooring on the coupled points, (m, 3), N.

        Parameters
        ----------
        position, velocity : (m, 3) array, optional
            Of the coupled points, m and m/s; by default as described, at rest.
        """
        return self._host.initialize(position, velocity, self.model.start == "static")

    def step(self, time: float, position, velocity) -> np.ndarray:
        """Advance to `time` (s), where the coupled points are at `position` with `velocity`; return the forces.

        Parameters
        ----------
        position, velocity : (m, 3) array
            m and m/s; on the way the points follow the cubic between the two ends.
        """
        return self._host.step(time, position, velocity)

    def water_nodes(self) -> np.ndarray:
        """Return where the water acts, (n, 3), m: nodes of the lines in the order of the file, points, ends of rods.

        The nodes of a line go from end A to end B and include both.
        """
        return self._host.water_nodes()

    def set_water(self, elevation, velocity, acceleration=None, time: float | None = None) -> None:
        """Say what the waves do at the nodes; the current of the model is added.

        Parameters
        ----------
        elevation : (n,) array or None
            Of the surface above each node, m; None: still.
        velocity : (n, 3) array
            m/s.
        acceleration : (n, 3) array or None
            m/s2, local; None: zero.
        time : float, optional
            At which they are so, s: the water goes there linearly from what it is now, and then stays. By default it is
            so at once, and stays so until it is set again.
        """
        if not self._hosts_water:
            remedy = "make it with host_waves=True, or let the model say host_waves: true"
            raise UnsupportedError(Problem("this simulation takes no water from its host", remedy))
        self._host.set_water(elevation, velocity, acceleration, time)

    def save(self) -> Block:
        """Return the whole state as arrays."""
        return self._host.save()

    def restore(self, saved: Block) -> None:
        """Go back to a saved state, bit for bit."""
        self._host.restore(saved)


def _only_points_are_coupled(model: Model) -> None:
    things = [("body", body) for body in model.bodies if body.kind == "coupled"]
    things += [("rod", rod) for rod in model.rods if rod.kind == "coupled"]  # type: ignore[misc]
    problems = [
        Problem(f"{kind} {thing.id} is coupled; hosts move points only", "use simulate() with a motion", thing.source)
        for kind, thing in things
    ]
    if problems:
        raise UnsupportedError(problems)
