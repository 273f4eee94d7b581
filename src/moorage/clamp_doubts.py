"""Cables that leave their clamps backwards, as far as can be seen before statics."""

from __future__ import annotations

import numpy as np

from moorage.errors import Problem
from moorage.model import Model
from moorage.solve.clamps import clamp_angles
from moorage.solve.statics import rest
from moorage.system.build import build

BACKWARDS = np.radians(120.0)  # of the limp first guess; stiff cables leave nearer to their clamps


def backward_clamps(model: Model) -> list[Problem]:
    """Return the ends at which the first guess of a line leaves its clamp backwards, in a model that can be run."""
    if not any(not rod.segments for rod in model.rods):
        return []
    built = build(model)
    rest(built)  # turns the clamps
    return [
        Problem(
            f"line {line} leaves the rod that clamps its end {end} at about {np.degrees(angle):.0f} degrees",
            "tie it to the other end of the rod, or turn the rod",
            model.line(line).source,
        )
        for line, end, angle in clamp_angles(built)
        if angle > BACKWARDS
    ]
