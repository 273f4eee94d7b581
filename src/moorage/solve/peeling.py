"""Whether segments are short enough for a line to peel off a soil with suction, not to jump off node by node."""

from __future__ import annotations

import warnings
from typing import NamedTuple

import numpy as np

from moorage.errors import ModelWarning
from moorage.physics.bathymetry import bed_at
from moorage.physics.soil import Law
from moorage.system.build import Built

LONG = 2.0  # of the way of peeling: there suction takes some five times its energy (tests/verification/test_soil.py)


class Peeling(NamedTuple):
    """How a line would come off where it leaves the seabed."""

    line: int  # id
    way: float  # m
    segment: float  # length there, m


def peeling(built: Built) -> list[Peeling]:
    """Return this for every touchdown of the present state on a soil with suction.

    What a line of the weight w bears on holds it back by f w, until it is lifted by u = lambda_suc z, z how far it is
    sunk in. With the tension T it comes off along a parabola, u = f w x^2 / (2 T).
    """
    soil, system, names = built.system.contact.soil, built.system, built.names
    law = Law(*soil.law.tolist())
    if not soil.on or law.suction <= 0.0:
        return []
    found = []
    for k, id in enumerate(names.lines):
        a, first = names.node_ptr[k], names.segment_ptr[k]
        r = built.state.position[a : names.node_ptr[k + 1]]
        sunk = np.array([bed_at(system.contact.bed, x, y)[0] - z for x, y, z in r])
        on = sunk > -1e-6  # anchors too
        for j in np.flatnonzero(on[1:] != on[:-1]):
            s = first + j
            length = float(system.tension.length[s])
            tension = system.tension.spring[s] * max(float(np.linalg.norm(r[j + 1] - r[j])) - length, 0.0)
            dry = -0.5 * (system.weight.dry[a + j] + system.weight.dry[a + j + 1])
            weight = max(float(dry - system.weight.buoyancy[s]), 1e-300) / length
            u = law.release * float(np.median(sunk[on]))
            found.append(Peeling(int(id), float(np.sqrt(2.0 * tension * u / (law.suction * weight))), length))
    return found


def warn_of_peeling(built: Built) -> None:
    """Warn of the line whose segments are longest beside the way along which it peels off."""
    worst = max(peeling(built), key=lambda p: p.segment / (p.way + 1e-300), default=None)
    if worst is None or worst.segment <= LONG * worst.way:
        return
    warnings.warn(
        f"suction of the soil holds line {worst.line} too much: its segments of {worst.segment:.3g} m jump off one by "
        f"one where it would peel off along {worst.way:.2g} m. Give sections of segments no longer than that where it "
        "is lifted, or take what comes as an upper bound (suction_ratio: 0 leaves suction out)",
        ModelWarning,
        stacklevel=3,
    )
