"""Axial tension of a segment: EA (L - l) / l when stretched, 0 when slack, plus BA d(L / l)/dt.

Hall & Goupee 2015, equations 6-9; Hall, Sirnivas & Yu 2020, equations 1-2. EA and BA may be tables: tension against
strain, and tension against strain rate.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage._vec3 import dot, isotropic_plus, scale
from moorage.physics.table import Tables, look_up


class Tension(NamedTuple):
    """Parameters of the segments."""

    length: np.ndarray  # (segments,) unstretched, m
    spring: np.ndarray  # (segments,) EA / l, N/m
    damper: np.ndarray  # (segments,) BA / l, N s/m
    slack: np.ndarray  # (segments,) least elastic tension, N: 0, or a large negative one that lets a segment push
    growth: np.ndarray  # (segments,) (dl/dt) / l, 1/s, of a segment at a winch
    spring_table: np.ndarray  # (segments,) table of tension against strain, -1: linear
    damper_table: np.ndarray  # (segments,) table of tension against strain rate, -1: linear
    tables: Tables


@inlined
def elastic(p, j, stretch):
    """Elastic tension of segment j (N) at a stretch L - l (m), and its slope (N/m)."""
    if p.spring_table[j] < 0:
        tension, slope = p.spring[j] * stretch, p.spring[j]
    else:
        tension, slope = look_up(p.tables, p.spring_table[j], stretch / p.length[j])
        slope /= p.length[j]
        if stretch <= 0.0:
            tension = slope * stretch
    if tension > p.slack[j]:
        return tension, slope
    return p.slack[j], 0.0


@inlined
def damping(p, j, rate):
    """Damping part of the tension of segment j (N) at a rate l d(L / l)/dt (m/s), and its slope (N s/m)."""
    if p.damper_table[j] < 0:
        return p.damper[j] * rate, p.damper[j]
    size, slope = look_up(p.tables, p.damper_table[j], abs(rate) / p.length[j])
    return (size if rate >= 0.0 else -size), slope / p.length[j]


@inlined
def tension_terms(p, j, e, de, c):
    """Pull of segment j on its first node (N), and its tangent block.

    e, de: vector between its nodes (m) and rate of change (m/s). The pull on the second node is opposite, and so are
    the couplings: the block B adds B to both nodes' own blocks and -B between them. Left out: how the damping part
    turns with the segment.
    """
    L = math.sqrt(dot(e, e))
    inverse = 1.0 / L
    s = scale(inverse, e)
    pull, slope = elastic(p, j, L - p.length[j])
    drag, drag_slope = damping(p, j, dot(s, de) - p.growth[j] * L)
    axial = c.stiffness * slope + c.damping * drag_slope
    lateral = c.stiffness * pull * inverse
    return scale(pull + drag, s), isotropic_plus(lateral, axial - lateral, s)


@inlined
def segment_tension(p, j, e, de):
    """Tension of segment j with its damping part, N."""
    L = math.sqrt(dot(e, e))
    return elastic(p, j, L - p.length[j])[0] + damping(p, j, dot(e, de) / L - p.growth[j] * L)[0]


@inlined
def tension_energy(p, j, e):
    """Elastic energy of a segment with constant EA, J."""
    stretch = math.sqrt(dot(e, e)) - p.length[j]
    tension = elastic(p, j, stretch)[0]
    return 0.5 * tension * stretch


def damping_from_ratio(ratio, length, axial_stiffness, mass_per_length):
    """Return BA (N s) for a fraction of the critical damping of a segment: ratio l sqrt(EA m)."""
    return ratio * length * np.sqrt(axial_stiffness * mass_per_length)
