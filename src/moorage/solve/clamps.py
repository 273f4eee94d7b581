"""How far lines stand off the direction of the rods that clamp them."""

from __future__ import annotations

import warnings
from typing import NamedTuple

import numpy as np

from moorage.errors import ModelWarning
from moorage.physics.bending import PINNED
from moorage.system.build import Built

STEEP = np.radians(60.0)  # a clamp's moment grows with the sine of the angle, and falls beyond 90 degrees


class ClampAngle(NamedTuple):
    """Angle (rad) between the first segment at a clamped end and the direction in which its rod points there."""

    line: int  # id
    end: str  # "A" or "B"
    angle: float


def clamp_angles(built: Built) -> list[ClampAngle]:
    """Return the angles at all clamped ends in the present state, at time 0."""
    bending, position, rows = built.system.bending, built.state.position, built.system.lines.node_ptr
    found = []
    for line, end in np.argwhere(bending.rule != PINNED):
        node, beside = (rows[line], rows[line] + 1) if end == 0 else (rows[line + 1] - 1, rows[line + 1] - 2)
        e, d = position[beside] - position[node], built.work.direction[line, end]
        cosine = float(e @ d / np.sqrt((e @ e) * (d @ d)))
        found.append(ClampAngle(int(built.names.lines[line]), "AB"[end], float(np.arccos(np.clip(cosine, -1.0, 1.0)))))
    return found


def warn_of_clamps(built: Built) -> None:
    """Warn of lines that leave their clamps far off their direction, where a clamp is no spring any more."""
    for line, end, angle in clamp_angles(built):
        if angle > STEEP:
            warnings.warn(
                f"line {line} leaves the rod that clamps its end {end} at {np.degrees(angle):.0f} degrees: it is tied "
                "to the wrong end of the rod, or its segments are too long there",
                ModelWarning,
                stacklevel=3,
            )
