"""Joints that cables turn: rods of no length to which the ends of cables are clamped.

They are objects (see `system.objects`) like any other rod: a place, which they have from their body or motion or find
by the forces of the lines, and a direction, in which the moments of the clamps balance. A joint of two cables alone is
a hinge between these and needs no rotation (`system.bends`).
"""

from __future__ import annotations

import numpy as np
from numpy.linalg import norm

from moorage.layout import CARRIER, CLAMP, TOWARD, State, System
from moorage.physics.bending import end_hinge
from moorage.physics.rigid import SLENDER
from moorage.system.objects import frame_along

ROUNDS = 100  # until the direction stays, beyond which what is left does not matter


def turn_joints(system: System, state: State) -> None:
    """Turn joints to where the moments of their cables balance, in place."""
    carried = set(system.riders.lines[:, CARRIER].tolist())
    for o in range(len(system.riders.objects)):
        if o not in carried and system.rigid.table[o, SLENDER]:
            direction = balanced(system, state, o)
            if direction is not None:
                state.frames[:, o] = frame_along(direction).ravel()


def balanced(system: System, state: State, o: int) -> np.ndarray | None:
    """Return the unit vector of a joint on which the moments of its clamps balance; none where cables leave none.

    A clamp turns the joint's direction d towards the first segment q of its line, by G d x q, so that d is along the
    sum of G q, those at end A turned round. G is the clamp's stiffness by the exact rule; by others it depends on d.
    """
    rows, clamps = system.lines.node_ptr, []
    for line, end in np.argwhere(system.riders.lines[:, CLAMP:] == o):
        node, beside = (rows[line], rows[line] + 1) if end == 0 else (rows[line + 1] - 1, rows[line + 1] - 2)
        e = state.position[beside] - state.position[node]
        clamps.append((node, system.bending.rule[line, end], system.riders.places[line, TOWARD + end, 0] * e / norm(e)))
    d = np.zeros(3)
    for _ in range(ROUNDS):
        total = sum(
            (end_hinge(system.bending, node, rule, d @ q if d.any() else 1.0)[0] * q for node, rule, q in clamps)
        )
        if not norm(total) > 0.0:
            return None
        before, d = d, total / norm(total)
        if norm(d - before) < 1e-14:
            break
    return d
