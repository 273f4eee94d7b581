"""Joints that cables turn: rods of no length to which the ends of cables are clamped.

They are objects (see `system.objects`) like any other rod: a place, which they have from their body or motion or find
by the forces of the lines, and a direction, in which the moments of the clamps balance. A joint of two cables alone is
a hinge between these and needs no rotation (`system.bends`).
"""

from __future__ import annotations

import numpy as np

from moorage.layout import CARRIER, CLAMP, TOWARD, State, System
from moorage.physics.rigid import SLENDER
from moorage.system.objects import frame_along


def turn_joints(system: System, state: State) -> None:
    """Turn joints to where the moments of their cables balance, in place.

    A clamp of stiffness k turns a joint of direction d towards the first segment q of its line by k d x q, so that d
    is along the sum of k q, those at end A turned round.
    """
    riders, rows = system.riders, system.lines.node_ptr
    nodes = set(riders.lines[:, CARRIER].tolist())
    for o in range(len(riders.objects)):
        if o in nodes or not system.rigid.table[o, SLENDER]:
            continue
        total = np.zeros(3)
        for line, end in np.argwhere(riders.lines[:, CLAMP:] == o):
            node, beside = (rows[line], rows[line] + 1) if end == 0 else (rows[line + 1] - 1, rows[line + 1] - 2)
            e = state.position[beside] - state.position[node]
            side = riders.places[line, TOWARD + end, 0]
            total += side * system.bending.before[node] * e / np.linalg.norm(e)
        size = np.linalg.norm(total)
        if size > 0.0:
            state.frames[:, o] = frame_along(total / size).ravel()
