"""Winches in the system: what the length of a segment changes is written into the parameters for a time."""

from __future__ import annotations

from moorage._jit import inlined, part
from moorage._vec3 import accumulate, get, sub
from moorage.physics.motion import follow
from moorage.physics.winch import (
    AFTER,
    BED,
    CLAMP,
    DAMPER,
    DRY,
    END,
    HELD,
    HINGE,
    INNER,
    ISLAND,
    LENGTH,
    LIFT,
    LINE,
    MASS,
    OFFSET,
    RATE,
    RATIO,
    REST,
    RUB,
    SEGMENT,
    SHARE,
    SOIL,
    SPRING,
    SURGE,
    TRACK,
    WATER,
    WET,
    winch_pull,
)


@part
def reel(system, island, t):
    """Give the end segments at the winches of an island the lengths of time t."""
    for k in range(len(system.winches.place)):
        if system.winches.place[k, ISLAND] == island:
            wind(system, k, t)


@inlined
def wind(system, k, t):
    """Set the parameters of the segment at winch k and of its two nodes."""
    place, x = system.winches.place, system.winches.table
    paid, rate, surge = follow(system.tracks, place[k, TRACK], t)
    l = x[k, OFFSET] + paid[0]
    x[k, LENGTH], x[k, RATE], x[k, SURGE] = l, rate[0], surge[0]
    j, tension = place[k, SEGMENT], system.tension
    tension.length[j], tension.growth[j] = l, rate[0] / l
    tension.spring[j], tension.damper[j] = x[k, SPRING] / l, x[k, RATIO] + x[k, DAMPER] / l
    system.weight.buoyancy[j] = x[k, LIFT] * l
    for c in range(5):
        system.morison.segment[j, c] = x[k, WATER + c] * l
    for side in range(2):
        i = place[k, HELD + side]
        set_node(system, x[k], i, l, 1.0 if side == 1 else 0.0)
    if place[k, AFTER] == 1:
        system.bending.after[place[k, INNER]] = x[k, HINGE] / l
    else:
        system.bending.before[place[k, INNER]] = x[k, HINGE] / l
    if x[k, CLAMP] > 0.0:
        system.bending.before[place[k, HELD]] = x[k, CLAMP] / l


@inlined
def set_node(system, x, i, l, inside):
    """Set what a node has of half a segment of length l, and of what else is beside it when it is inside."""
    system.weight.dry[i] = share(x, DRY, l, inside)
    system.morison.mass[i] = share(x, MASS, l, inside)
    for c in range(5):
        system.morison.node[i, c] = share(x, WET + c, l, inside)
    system.contact.spring[i], system.contact.damper[i] = share(x, BED, l, inside), share(x, BED + 1, l, inside)
    if system.contact.soil.on:
        length = share(x, SOIL, l, inside)
        system.contact.soil.size[i, 0] = length
        system.contact.soil.size[i, 1] = share(x, SOIL + 1, l, inside) / length
    system.friction.spring[i], system.friction.damper[i] = share(x, RUB, l, inside), share(x, RUB + 1, l, inside)


@inlined
def share(x, column, l, inside):
    return x[SHARE + column] * l + inside * x[REST + column]


@inlined
def pull_of(system, state, k):
    """Force on what holds winch k beside the tension, N."""
    place, x = system.winches.place, system.winches.table
    held, inner = place[k, HELD], place[k, INNER]
    u = sub(get(state.position, inner), get(state.position, held))
    du = sub(get(state.velocity, inner), get(state.velocity, held))
    return winch_pull(x[k, SHARE + MASS], x[k, RATE], x[k, SURGE], u, du)


@part
def add_winches(system, state, force, island):
    """Add what the winches of an island do to the nodes there; the matrix leaves it out, small as it is."""
    for k in range(len(system.winches.place)):
        if system.winches.place[k, ISLAND] == island:
            accumulate(force, system.winches.place[k, HELD], pull_of(system, state, k))


@part
def sample_winches(system, state, island, sample, column):
    """Add the same to the columns of the force on both ends of the lines, which begin at `column`."""
    for k in range(len(system.winches.place)):
        if system.winches.place[k, ISLAND] == island:
            pull, at = pull_of(system, state, k), column + 3 * system.winches.place[k, END]
            for c in range(3):
                sample[system.winches.place[k, LINE], at + c] += pull[c]
