"""The functions of Rod.h."""

from __future__ import annotations

import numpy as np

from moorage.moordyn.codes import ROD_TYPE_FIXED, ROD_TYPES
from moorage.moordyn.handles import Rod, Vector, node_index, of, raising, to_tuple
from moorage.solve.masses import rod_mass


def GetRodID(instance: Rod) -> int:
    """Return the id of a rod."""
    return _rod(instance).id


def GetRodType(instance: Rod) -> int:
    """Return ROD_TYPE_COUPLED, _CPLDPIN, _FREE, _PINNED or _FIXED (also on a body)."""
    rod = _rod(instance)
    return ROD_TYPE_FIXED if rod.body is not None and rod.kind != "pinned" else ROD_TYPES[rod.kind]


@raising
def GetRodForce(instance: Rod) -> tuple[float, ...]:
    """Return force and moment about its end A of a rod and the lines on it, N and N m, without inertia."""
    return to_tuple(of(Rod, instance).block["rod_force"][instance.place])


@raising
def GetRodM(instance: Rod) -> tuple[tuple[float, ...], ...]:
    """Return the mass matrix (6, 6) about end A in global axes, with added mass."""
    system = of(Rod, instance)
    return to_tuple(rod_mass(system.built, system.masses, system.block, instance.place, system.time))  # type: ignore[return-value]


def GetRodN(instance: Rod) -> int:
    """Return the number of segments."""
    return _rod(instance).segments


def GetRodNumberNodes(instance: Rod) -> int:
    """Return the number of nodes."""
    return GetRodN(instance) + 1


@raising
def GetRodNodePos(instance: Rod, i: int) -> Vector:
    """Return the position of a node, m."""
    return to_tuple(_between(instance, i, 0))


@raising
def GetRodNodeVel(instance: Rod, i: int) -> Vector:
    """Return the velocity of a node, m/s."""
    return to_tuple(_between(instance, i, 1))


def _rod(instance: Rod):
    return of(Rod, instance).model.rods[instance.place]


def _between(instance: Rod, i: int, which: int) -> np.ndarray:
    """Position (0) or velocity (1) of a node between the ends of a rod, (3,)."""
    node_index(i, GetRodNumberNodes(instance), f"rod {GetRodID(instance)}")
    share = i / max(GetRodN(instance), 1)
    a, b = of(Rod, instance).rod_motion(instance.place)[which]
    return (1.0 - share) * a + share * b
