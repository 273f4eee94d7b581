"""The functions of Line.h."""

from __future__ import annotations

import numpy as np

from moorage.model import Curve
from moorage.moordyn.handles import Line, Vector, node_index, of, raising, to_tuple


def GetLineID(instance: Line) -> int:
    """Return the id of a line."""
    return _line(instance).id


def GetLineN(instance: Line) -> int:
    """Return the number of segments."""
    return _line(instance).segments


def GetLineNumberNodes(instance: Line) -> int:
    """Return the number of nodes."""
    return GetLineN(instance) + 1


def GetLineUnstretchedLength(instance: Line) -> float:
    """Return the unstretched length, m."""
    return _line(instance).length


@raising
def SetLineUnstretchedLength(instance: Line, l: float) -> None:
    """Give a line another unstretched length, m; its segments keep their proportions, its weight and mass follow."""
    if not 0.0 < l < np.inf:
        raise RuntimeError(f"SetLineUnstretchedLength: {l} is no length")
    instance.system.change_line(instance.place, length=float(l))


@raising
def SetLineUnstretchedLengthVel(instance: Line, v: float) -> None:
    """Let the unstretched length grow by v (m/s) from now on."""
    if not np.isfinite(v):
        raise RuntimeError(f"SetLineUnstretchedLengthVel: {v} is no speed")
    of(Line, instance).pay_out.pop(instance.place, None)
    if v:
        instance.system.pay_out[instance.place] = float(v)


def IsLineConstantEA(instance: Line) -> bool:
    """Return whether the axial stiffness is a number and not a table."""
    return not any(isinstance(value, Curve) for value in _stiffness(instance))


@raising
def GetLineConstantEA(instance: Line) -> float:
    """Return the axial stiffness at end A, N; of a table its first slope."""
    value = _stiffness(instance)[0]
    if isinstance(value, Curve):
        return float((value.y[1] - value.y[0]) / (value.x[1] - value.x[0]))
    return float(value)


@raising
def SetLineConstantEA(instance: Line, ea: float) -> None:
    """Give a line another axial stiffness, N."""
    if not 0.0 < ea < np.inf:
        raise RuntimeError(f"SetLineConstantEA: {ea} is no stiffness")
    instance.system.change_line(instance.place, stiffness=float(ea))


def IsLinePressBend(instance: Line) -> bool:
    """Return whether pressure bends the line: never here."""
    _line(instance)
    return False


def SetLinePressBend(instance: Line, b: bool) -> None:
    """Refuse to let pressure bend a line, which is not simulated."""
    _line(instance)
    if b:
        raise RuntimeError("SetLinePressBend: bending by pressure is not simulated")


def SetLinePressInt(instance: Line, p) -> None:
    """Check the internal pressures at the nodes, Pa, which have no effect unless pressure bends the line."""
    if len(list(p)) != GetLineNumberNodes(instance):
        raise RuntimeError(f"SetLinePressInt: {GetLineNumberNodes(instance)} pressures are wanted")


def GetLineNodePos(instance: Line, i: int) -> Vector:
    """Return the position of a node, m."""
    return to_tuple(instance.system.block["node_position"][_row(instance, i)])


def GetLineNodeVel(instance: Line, i: int) -> Vector:
    """Return the velocity of a node, m/s."""
    return to_tuple(instance.system.block["node_velocity"][_row(instance, i)])


def GetLineNodeForce(instance: Line, i: int) -> Vector:
    """Return the net force on a node without its inertia, N."""
    row, block = _row(instance, i), instance.system.block
    force = block["watch_force"][row]
    if instance.system.built.system.lines.bends[instance.place]:
        force = force + instance.system.part("bending")[row]
    return to_tuple(force)


def GetLineNodeTen(instance: Line, i: int) -> Vector:
    """Return the mean of the pulls of the segments at a node, from end A to end B, N; at an end that of its segment."""
    _row(instance, i)
    return to_tuple(_pulls(instance)[i])


def GetLineNodeBendStiff(instance: Line, i: int) -> Vector:
    """Return the force of bending on a node, N."""
    return to_tuple(instance.system.part("bending")[_row(instance, i)])


def GetLineNodeWeight(instance: Line, i: int) -> Vector:
    """Return weight and buoyancy of a node, N."""
    return to_tuple(instance.system.part("weight")[_row(instance, i)])


def GetLineNodeDrag(instance: Line, i: int) -> Vector:
    """Return the drag on a node, N."""
    return to_tuple(instance.system.part("drag")[_row(instance, i)])


def GetLineNodeFroudeKrilov(instance: Line, i: int) -> Vector:
    """Return the force of the water's acceleration on a node, Froude-Krylov and added mass, N."""
    return to_tuple(instance.system.part("swell")[_row(instance, i)])


def GetLineNodeSeabedForce(instance: Line, i: int) -> Vector:
    """Return contact and friction of the seabed on a node, N."""
    return to_tuple(instance.system.part("seabed")[_row(instance, i)])


def GetLineNodeCurv(instance: Line, i: int) -> float:
    """Return the curvature at a node of a line with bending stiffness, 1/m; 0 without."""
    return float(instance.system.block["curvature"][_row(instance, i)])


def GetLineNodeM(instance: Line, i: int) -> tuple[Vector, Vector, Vector]:
    """Return the mass matrix of a node with its added mass, kg."""
    return to_tuple(instance.system.masses[_row(instance, i)])  # type: ignore[return-value]


def GetLineFairTen(instance: Line) -> float:
    """Return the tension of the last segment, at end B, N."""
    return float(np.linalg.norm(_pulls(instance)[-1]))


def GetLineMaxTen(instance: Line) -> float:
    """Return the largest of the tensions at the nodes, N."""
    return float(np.linalg.norm(_pulls(instance), axis=1).max())


def _line(instance: Line):
    return of(Line, instance).model.lines[instance.place]


def _stiffness(instance: Line) -> list[float | Curve]:
    types = of(Line, instance).model.line_type
    return [types(section.line_type).axial_stiffness for section in _line(instance).sections]


def _row(instance: Line, i: int) -> int:
    return int(of(Line, instance).built.names.node_ptr[instance.place]) + node_index(
        i, GetLineNumberNodes(instance), f"line {GetLineID(instance)}"
    )


def _pulls(instance: Line) -> np.ndarray:
    """Return the mean pulls at the nodes of a line, (nodes, 3), N."""
    names, block = of(Line, instance).built.names, instance.system.block
    a, b = names.node_ptr[instance.place : instance.place + 2]
    r = block["node_position"][a:b]
    e = np.diff(r, axis=0)
    T = block["segment_tension"][slice(*names.segment_ptr[instance.place : instance.place + 2])]
    pull = T[:, None] * e / np.maximum(np.linalg.norm(e, axis=1), 1e-300)[:, None]
    return 0.5 * (np.concatenate([pull[:1], pull]) + np.concatenate([pull, pull[-1:]]))
