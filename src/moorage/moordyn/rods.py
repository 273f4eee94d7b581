"""The functions of Rod.h. Rods that move by themselves come with the engine's; fixed and coupled ones are carried."""

from __future__ import annotations

import numpy as np

from moorage.model import Attachment
from moorage.moordyn.codes import ROD_TYPE_FIXED, ROD_TYPES
from moorage.moordyn.handles import Rod, Vector, live, node_index, raising, to_tuple
from moorage.system.holders import holders_of


def GetRodID(instance: Rod) -> int:
    """Return the id of a rod."""
    return _rod(instance).id


def GetRodType(instance: Rod) -> int:
    """Return ROD_TYPE_COUPLED, _CPLDPIN, _FREE, _PINNED or _FIXED (also on a body)."""
    rod = _rod(instance)
    return ROD_TYPE_FIXED if rod.body is not None and rod.kind != "pinned" else ROD_TYPES[rod.kind]


def GetRodForce(instance: Rod) -> tuple[float, ...]:
    """Return force and moment of the lines on a rod about its end A, N and N m; rods have no weight or drag yet."""
    system = live(instance.system)
    total, origin = np.zeros(6), system.point_motion(holder_of(instance, "A"))[0]
    for k, line in enumerate(system.model.lines):
        for end, attachment in enumerate((line.end_a, line.end_b)):
            if attachment.kind == "rod" and attachment.id == _rod(instance).id:
                force = system.block["end_load"][k, end]
                arm = system.point_motion(holder_of(instance, attachment.end))[0] - origin
                total[:3] += force
                total[3:] += np.cross(arm, force) + system.block["end_moment"][k, end]
    return to_tuple(total)


def GetRodM(instance: Rod):
    """Refuse: the mass of rods is not simulated yet."""
    _rod(instance)
    raise RuntimeError("GetRodM: rods are carried, or join lines; their mass is not simulated yet")


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


def holder_of(instance: Rod, end: str) -> int:
    """Return the number of an end among points and rod ends."""
    holders = holders_of(live(instance.system).model, None, None)
    return holders.number[Attachment("rod", _rod(instance).id, end)]  # type: ignore[arg-type]


def _rod(instance: Rod):
    return live(instance.system).model.rods[instance.place]


def _between(instance: Rod, i: int, which: int) -> np.ndarray:
    """Position (0) or velocity (1) of a node between the ends of a rod, (3,)."""
    node_index(i, GetRodNumberNodes(instance), f"rod {GetRodID(instance)}")
    share = i / max(GetRodN(instance), 1)
    a, b = (instance.system.point_motion(holder_of(instance, end))[which] for end in "AB")
    return (1.0 - share) * a + share * b
