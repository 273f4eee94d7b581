"""A soil that gives way, holds back by suction and is softer where it was pressed before (Randolph & Quiggin 2009).

Resistance P (N for a metre of line, upwards along the normal of the bed) at the penetration z > 0, with P_u(z) what the
soil can bear, f of that its suction, K = k_max / D and z0, P0 where the motion turned round last:

    P_u = N_c (s_u0 + rho z) D,   N_c = a (z / D)^b,   below z / D = 0.1 N_c = N_c(0.1) sqrt(10 z / D)
    first penetration    P = P_u K z / (1 + K z)
    uplift               P = S + Q,   S = -f P_u exp(-(z0 - z) / (l_suc z_max))
    re-penetration       P = T + Q,   T = P_u exp(min(0, (z - z_max - l_rep (z_max - z0)) / z_max))
    Q = R |R| / (|R| + P_u(max(z, z0)) K |z - z0|),   R = P0 - S or P0 - T

and always -f P_u <= P <= P of first penetration. All three are hyperbolas that leave (z0, P0) with the stiffness K P_u.
First penetration is re-penetration with z0 = P0 = z_max = 0.

The soil remembers at every node: the penetration and resistance at the end of the last step, those at the last turn,
the greatest penetration at which it turned upwards, and whether it moves upwards (-1).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, part

SHALLOW = 0.1  # z / D below which the bearing factor is a square root
FRESH = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)  # never touched; (z, P, z0, P0, z_max, sense)


class Law(NamedTuple):
    """Numbers of a soil."""

    bearing: float  # a
    power: float  # b
    strength: float  # s_u0, undrained, at the mudline, Pa
    gradient: float  # rho, Pa/m
    stiffness: float  # k_max
    suction: float  # f
    release: float  # l_suc
    recovery: float  # l_rep
    lift: float  # weight of soil above that of water, with its factor, which buoys what is in it, N/m3


class Soil(NamedTuple):
    """Parameters; few of them, because every kernel that knows a system unpacks all."""

    on: bool
    size: np.ndarray  # (nodes, 2) length of line that a node stands for and its diameter, m
    law: np.ndarray  # (9,) see `Law`


def no_soil() -> Soil:
    """Return the parameters of a bed without such a soil."""
    return Soil(False, np.zeros((0, 2)), np.zeros(9))


def soil_under(length, diameter, law: Law) -> Soil:
    """Return a soil under nodes that stand for lengths (nodes,) of line of diameters (nodes,), m."""
    return Soil(True, np.column_stack([length, diameter]), np.array(law, float))


@inlined
def law_of(p):
    """Numbers of a soil by name."""
    n = p.law
    return Law(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8])


@inlined
def bearing(p, D, z):
    """Most that the soil can bear at a penetration (N/m), and its slope."""
    ratio, power = z / D, p.power
    factor = p.bearing * max(ratio, SHALLOW) ** power * D
    if ratio < SHALLOW:
        factor, power = factor * math.sqrt(ratio / SHALLOW), 0.5
    strength = p.strength + p.gradient * z
    return factor * strength, factor * (power / z * strength + p.gradient)


@inlined
def turned(memory, z):
    """Where the motion turned last (m, N/m), the deepest turn before, and the sense, for a step that ends at z."""
    last, force, z0, P0, deepest, sense = memory
    if sense < 0.0:
        if z <= last:
            return z0, P0, deepest, -1.0
        return last, force, deepest, 1.0
    if z >= last:
        return z0, P0, deepest, 1.0
    return last, force, max(deepest, last), -1.0


@part
def resistance(p, i, memory, z):
    """Resistance of the soil on node i (N) at the penetration z (m), with its slope (N/m); memory: before the step."""
    if z <= 0.0:
        return 0.0, 0.0
    l, D, law = p.size[i, 0], p.size[i, 1], law_of(p)
    P, slope = branch(law, D, turned(memory, z), z)
    area, width = sunk_part(D, z)
    return l * (P + law.lift * area), l * (slope + law.lift * width)


@inlined
def branch(p, D, turn, z):
    """Resistance (N/m) and slope on the way from the last turn, without the lift of displaced soil."""
    z0, P0, deepest, sense = turn
    K = p.stiffness / D
    most, rise = bearing(p, D, z)
    if sense < 0.0:
        fall = 1.0 / (p.release * deepest)
        share = p.suction * math.exp(-fall * (z0 - z))
        aim, aim_slope = -share * most, -share * (rise + fall * most)
        stiff, stiff_slope = bearing(p, D, z0)[0], 0.0
    else:
        below = z - deepest - p.recovery * (deepest - z0)
        share, grow = (math.exp(below / deepest), 1.0 / deepest) if below < 0.0 else (1.0, 0.0)
        aim, aim_slope = share * most, share * (rise + grow * most)
        stiff, stiff_slope = most, rise
    P, slope = hyperbola(P0, aim, aim_slope, stiff * K * abs(z - z0), K * (stiff_slope * abs(z - z0) + stiff * sense))
    first = most * K * z / (1.0 + K * z)
    if first < P:
        return first, rise * K * z / (1.0 + K * z) + most * K / ((1.0 + K * z) * (1.0 + K * z))
    if -p.suction * most > P:
        return -p.suction * most, -p.suction * rise
    return P, slope


@inlined
def hyperbola(P0, aim, aim_slope, way, way_slope):
    """Force that goes from P0 to an aim over a way (N/m, what the first stiffness would make of it), and its slope."""
    R = P0 - aim
    size, sign = abs(R), 1.0 if R >= 0.0 else -1.0
    below = size + way + 1e-300
    fall = -size * (2.0 * aim_slope * below - size * (aim_slope - sign * way_slope)) / (below * below)
    return aim + R * size / below, aim_slope + fall


@inlined
def sunk_part(D, z):
    """Area (m2) of a circle of diameter D below a surface that it is sunk under by z, and the slope of that (m)."""
    if z >= D:
        return 0.25 * math.pi * D * D, 0.0
    half = 0.5 * D
    width = 2.0 * math.sqrt(z * (D - z))
    return half * half * math.acos(1.0 - z / half) - 0.5 * (half - z) * width, width


@part
def remember(p, i, memory, z):
    """Memory after a step that ends at the penetration z (m)."""
    if z <= 0.0:
        return 0.0, 0.0, 0.0, 0.0, max(memory[4], memory[0]), 0.0
    turn = turned(memory, z)
    return z, branch(law_of(p), p.size[i, 1], turn, z)[0], turn[0], turn[1], turn[2], turn[3]
