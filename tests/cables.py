"""Small cables for tests: beams between clamps, what they carry, and random ones that hang in water."""

from __future__ import annotations

from typing import Any

import numpy as np
from moorings import again, clamp, free, held, kind, line, mooring, nodes

from moorage.model import Line, LineType, Model, Section
from moorage.solve.march import Block, March, Settings
from moorage.system.build import Built

VACUUM = {"gravity": 0.0, "water_density": 0.0}
ROOT = (0.0, 0.0, 0.0)  # near the origin a small deflection keeps more of its digits

# three cables at a joint that is KIND; the paper's rule
JOINT = """three cables at a joint
---------------------- LINE TYPES ----
Name   Diam  MassDen  EA    BA/-zeta  EI   Cd  Ca  CdAx CaAx
(-)    (m)   (kg/m)   (N)   (N-s/-)   (N-m2) (-) (-) (-) (-)
cable  0.15  40       1e7   -0.8      5e3  1.2 1.0 0.1  0.0
---------------------- ROD TYPES ----
Name   Diam  MassDen  Cd  Ca  CdEnd CaEnd
(-)    (m)   (kg/m)   (-) (-) (-)  (-)
conn   0.1   0        0   0   0    0
---------------------- RODS ----
ID  RodType  Attachment  Xa  Ya  Za   Xb  Yb  Zb  NumSegs  RodOutputs
(#) (name)   (#/key)     (m) (m) (m)  (m) (m) (m) (-)      (-)
1   conn     KIND        0   0   -30  0   0   -30 0        p
---------------------- POINTS ----
ID  Type     X    Y   Z    M   V   CdA  CA
(#) (-)      (m)  (m) (m)  (kg) (m3) (m2) (-)
1   Fixed    -14  0   -22  0   0   0    0
2   Coupled   12  6   -24  0   0   0    0
3   Fixed    9   -9   -20  0   0   0    0
---------------------- LINES ----
ID  LineType AttachA AttachB UnstrLen NumSegs LineOutputs
(#) (name)   (#)     (#)     (m)      (-)     (-)
1   cable    1       R1A     18       9       -
2   cable    R1B     2       17       8       -
3   cable    R1B     3       17       7       -
---------------------- OPTIONS ----
60   WtrDpth
0.0  TmaxIC
1    disableOutput
---------------------- need this line ----
"""


def beam(EI: Any, name: str = "beam", **properties: Any) -> LineType:
    """Return a line type that pushes as well as it pulls, and hardly stretches under what bends it by little."""
    defaults = {"axial_stiffness": 1e6, "carries_compression": True}
    return kind(name, **(defaults | {"bending_stiffness": EI} | properties))


def sections(*parts: tuple[str, float, int] | tuple[str, float, int, float]) -> tuple[Section, ...]:
    """Return sections (type, length m, segments, grading)."""
    return tuple(Section(line_type=p[0], length=p[1], segments=p[2], grading=(*p, 1.0)[3]) for p in parts)


def cantilever(types, parts, force, environment=VACUUM, **of_line: Any) -> Model:
    """Return a cable from a clamp at ROOT, along x, to a free point that a force (N) pulls; parts: its sections."""
    root = clamp(1, ROOT, (1.0, 0.0, 0.0))
    length = sum(part.length for part in parts)
    end = free(1, length, 0.0, 0.0, external_force=tuple(map(float, force)))
    cable = Line(id=1, sections=parts, end_a=held(root, "B"), end_b=line(2, 1, 1).end_b, **of_line)
    return mooring(types, (end,), (cable,), (root,), **environment)


def between(types, parts, a, from_a, b, into_b, environment=VACUUM, **of_line: Any) -> Model:
    """Return a cable clamped at both ends: it leaves a in the direction from_a and comes to b in the direction into_b."""
    first, last = clamp(1, a, from_a), clamp(2, b, into_b)
    cable = Line(id=1, sections=parts, end_a=held(first, "B"), end_b=held(last, "A"), **of_line)
    return mooring(types, (), (cable,), (first, last), **environment)


def at_once(built: Built) -> Block:
    """Return everything that a run records, at time 0."""
    return March(again(built), Settings(dt_nodes=1.0), 0.0).first()


def deflection(built: Built) -> float:
    """Return how far the tip of a cantilever has sunk, m."""
    return float(ROOT[2] - nodes(built)[-1, 2])


def bending_moments(built: Built) -> np.ndarray:
    """Return the bending moments at all nodes, N m."""
    return at_once(built)["bending_moment"][0]


def curvatures(built: Built) -> np.ndarray:
    """Return the curvatures at all nodes, 1/m."""
    return at_once(built)["curvature"][0]


def turned(by: float, about) -> np.ndarray:
    """Return the matrix of a rotation (rad) about an axis (Rodrigues)."""
    x, y, z = np.array(about, dtype=float) / np.linalg.norm(about)
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(by) * K + (1.0 - np.cos(by)) * K @ K
