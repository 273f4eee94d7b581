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
    ):
        chosen = {"tolerance": tolerance, "time_step": time_step}
        check_settings({**chosen, "method": method}, False, None)
        accept(model)
        _only_points_are_coupled(model)
        if model.failures:
            raise UnsupportedError(Problem("failures come in simulate() only", "remove them", model.failures[0].source))
        self.model = model
        built = build(model)
        self.points = built.names.points[built.coupled]
        self._host = HostMarch(built, Settings(method=method, **chosen))  # type: ignore[arg-type]

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
