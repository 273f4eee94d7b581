"""The state of lines that winches have cut anew: rows that are kept, and where nodes that are made stand."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.layout import WITHOUT_ROWS, State, System
from moorage.physics import winch as at
from moorage.physics.bending import RIGID
from moorage.system.winches import Winch


def rows_kept(before: System, after: System, winches: tuple[Winch, ...]) -> np.ndarray:
    """Return for each row of a system the row that it had before; of a node that is made, that of the inner node."""
    end = {w.line: w.end for w in winches}
    rows, old, new = [], before.lines.node_ptr, after.lines.node_ptr
    for k in range(len(new) - 1):
        n, m = int(old[k + 1] - old[k]) - 1, int(new[k + 1] - new[k]) - 1  # segments
        count = np.arange(m + 1)
        from_fixed = np.minimum(count, n - 1)
        from_fixed[m] = n
        rows.append(old[k] + (from_fixed if end.get(k, 1) else n - from_fixed[::-1]))
    rows.append(np.arange(old[-1], old[-1] + len(after.points.mass) + 2 * len(after.riders.objects)))
    return np.concatenate(rows)


class Made(NamedTuple):
    """A node that a winch has made."""

    node: int  # row
    segment: int  # between it and the next node inside
    inner: int  # row of the last node that was there before
    held: int  # row of the end at the winch
    xi: float  # where it is between the two, in parts of the unstretched length
    length: float  # of that, m
    rate: float  # of the length, m/s


def carry_over(
    before: System, old: State, after: System, new: State, winches: tuple[Winch, ...]
) -> tuple[np.ndarray, list[Made]]:
    """Fill a state from one whose lines are cut in another way; return the rows kept, and the nodes that are made.

    These stand where their material is, in the segment at the winch, and move with it.
    """
    rows = rows_kept(before, after, winches)
    for name, target, source in zip(State._fields, new, old, strict=True):
        target[...] = source if name in WITHOUT_ROWS else source[rows]
    found = []
    for w in winches:
        first, last = int(before.lines.node_ptr[w.line]), int(before.lines.node_ptr[w.line + 1]) - 1
        held, inner, j = (last, last - 1, last - 1 - w.line) if w.end else (first, first + 1, first - w.line)
        a, b = int(after.lines.node_ptr[w.line]), int(after.lines.node_ptr[w.line + 1]) - 1
        made = (b - a) - (last - first)
        length, growth, gone = float(before.tension.length[j]), float(before.tension.growth[j]), 0.0
        inside, end = (b - made - 1, b) if w.end else (a + made + 1, a)
        for k in range(made):
            node = b - made + k if w.end else a + made - k
            segment = node - 1 - w.line if w.end else node - w.line
            gone += after.tension.length[segment]
            xi, u = gone / length, old.position[inner] - old.position[held]
            new.position[node] = old.position[inner] - xi * u
            new.velocity[node] = (1.0 - xi) * old.velocity[inner] + xi * (old.velocity[held] + growth * u)
            new.stuck[node] = new.position[node]
            found.append(Made(node, segment, inside, end, xi, length, growth * length))
    return rows, found


def leaving(system: System, state: State, line: int, end: int) -> np.ndarray:
    """Return the velocity of the material at a line end over that of what holds it, (3,), m/s: 0 without a winch."""
    place = system.winches.place
    for row in place[(place[:, at.LINE] == line) & (place[:, at.END] == end)]:
        u = state.position[row[at.INNER]] - state.position[row[at.HELD]]
        return system.tension.growth[row[at.SEGMENT]] * u
    return np.zeros(3)


def slide_into_balance(system: System, state: State, made: Made, surge: float) -> None:
    """Shift a new node until the material there is accelerated as it was before: one step of Newton's method.

    Along the line always: the tension on both sides was the same, now they differ by what the half segments beside the
    node weigh, and by their drag and inertia, and the forces on the inner node and on the winch stay what they were.
    Across it where the line bends, or a clamp at the winch would be bent by the angle of the whole segment at once; a
    line that does not bend falls into its sag by itself, and keeps its tension.
    """
    i, w, l = made.inner, made.held, made.length
    e, de = state.position[w] - state.position[i], state.velocity[w] - state.velocity[i]
    growth = made.rate / l
    was = (1.0 - made.xi) * state.acceleration[i] + made.xi * state.acceleration[w]
    was += made.xi * ((2.0 * growth**2 - surge / l) * e - 2.0 * growth * de)
    along = e / np.linalg.norm(e)
    normal, axial = system.morison.mass[made.node] + system.morison.node[made.node, :2]
    pair = np.array([made.segment, made.segment + (1 if w > made.node else -1)])
    missing = state.acceleration[made.node] - was
    ahead = missing @ along
    shift = axial * ahead / system.tension.spring[pair].sum() * along
    stiffness = sideways(system, made, pair, float(np.linalg.norm(e)) / l - 1.0)
    if stiffness > 0.0:
        shift += normal * (missing - ahead * along) / stiffness
    if np.linalg.norm(shift) < 0.2 * system.tension.length[pair].min():  # beyond that a segment is slack
        state.position[made.node] += shift
        state.stuck[made.node] = state.position[made.node]


def sideways(system: System, made: Made, pair: np.ndarray, strain: float) -> float:
    """Return the stiffness (N/m) of a new node across its line, from tension and bending; 0 without bending.

    pair: the segments beside it, first that inside.
    """
    p, (a, b) = system.bending, system.tension.length[pair]

    def hinge(i: int) -> float:
        k1, k2 = p.before[i], p.after[i]
        return k1 if k2 == RIGID else k1 * k2 / max(k1 + k2, 1e-300)

    inside = made.node - 1 if made.held > made.node else made.node + 1
    own, inner, clamp = hinge(made.node), hinge(inside), hinge(made.held)
    if own <= 0.0:
        return 0.0
    pull = max(strain, 0.0) * (system.tension.spring[pair] * system.tension.length[pair]).mean()
    return float((pull / a + pull / b) + own * (1.0 / a + 1.0 / b) ** 2 + inner / a**2 + clamp / b**2)
