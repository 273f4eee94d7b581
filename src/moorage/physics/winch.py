"""A winch at the end of a line: material comes in or goes out there, and the segment there grows or shrinks.

Nodes stay with the material, but for the one at the winch. In the end segment, of unstretched length l(t), the place s
from the inner node moves with the material velocity

    v(s) = v_i + (s / l)(v_w - v_i) + (s / l)(l' / l) u,     u = r_i - r_w

(i the inner node, w the winch, ' = d/dt), so that line leaves the winch at l' u / l. Strain and strain rate are those
of the material: T = EA (L / l - 1) + BA d(L / l)/dt. Half of the segment stands at either node, with mass m l / 2 of
the line that is there now: what joins the inner node has its velocity already, so that M(t) a = F holds without a term
in dM/dt. The half at the winch moves with the material that is there, and the momentum of the line that leaves the
winch is taken from what holds it. Both together are, exactly for the momentum of the whole line,

    force on the holder  += -m l' u' - m l'' u / 2

On a taut line that is paid out at a constant rate, u' = l' u / l and the force is the thrust -m l'^2. Added mass is
left out: water does not come out of a winch.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage._vec3 import add, scale

# columns of Winches.place: line; end, 0: A, 1: B; row of the tracks whose x is the length paid out, m; island; rows of
# the nodes at the winch and inside; segment; 1: it comes after the inner node's hinge, 0: before
LINE, END, TRACK, ISLAND, HELD, INNER, SEGMENT, AFTER, PLACES = 0, 1, 2, 3, 4, 5, 6, 7, 8
# columns of Winches.table: now the unstretched length (m), its rate and that of its rate; what is fixed: length at a
# track of 0; EA; BA (N s), and a damper (N s/m) of any length; buoyancy and water (5) for each metre; 2 EI at the inner
# hinge and at a clamp; what half a metre adds to a node, and what the inner node has from elsewhere
LENGTH, RATE, SURGE, OFFSET, SPRING, DAMPER, RATIO, LIFT, WATER, HINGE, CLAMP = 0, 1, 2, 3, 4, 5, 6, 7, 8, 13, 14
SHARE, REST, COLUMNS = 15, 28, 41
# and within the last two: weight, mass, water (5), spring and damper of the bed, length and area on soil, spring and
# damper of friction
DRY, MASS, WET, BED, SOIL, RUB, SHARES = 0, 1, 2, 7, 9, 11, 13


class Winches(NamedTuple):
    """Parameters of the winches."""

    place: np.ndarray  # (winches, PLACES) int
    table: np.ndarray  # (winches, COLUMNS)


@inlined
def winch_pull(half, rate, surge, u, du):
    """Force on what holds a winch beside the tension, N.

    half: mass of half a metre, kg; rate, surge: of the length, m/s and m/s2; u, du: vector from the winch to the inner
    node and its rate of change.
    """
    return add(scale(-2.0 * half * rate, du), scale(-half * surge, u))
