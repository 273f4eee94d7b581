"""Records of lines on winches: nodes come and go in a run, results have rows of one number.

Rows that are not out of the winch yet stand at it: they have the position of the end, and the tension of the segment
there, so that a line in a result always ends in its last row. No force acts on them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.model.payout import Paid
from moorage.physics.winch import DAMPER, HELD, LINE, OFFSET, RATIO, SEGMENT, SURGE, TRACK
from moorage.system.build import Built
from moorage.system.winches import Reeled

FORCES = ("seabed_force", "friction_force")


class Rows(NamedTuple):
    """Where the rows of a result are in a system, and which of them are still in a winch."""

    nodes: np.ndarray  # (rows of nodes,)
    segments: np.ndarray  # (rows of segments,)
    no_node: np.ndarray  # (rows of nodes,) bool
    no_segment: np.ndarray  # (rows of segments,) bool


def paid_by(built: Built) -> list[Paid]:
    """Return what each control pays out, as the tracks of a system have it."""
    tracks, found = built.system.tracks, []
    for row in built.paid:
        k = tracks.track[row]
        still = np.array([[0.0, 0.0, 0.0, tracks.rest[row, 0]]])
        found.append(Paid(tracks.knots, tracks.coefficients[k, :, 0]) if k >= 0 else Paid(np.array([0.0, 1.0]), still))
    return found


def surge_at(built: Built, held: int) -> float:
    """Return the second derivative (m/s2) of the length at a winch, by the row of the end; 0 where the line is off."""
    winches = built.system.winches
    return float(winches.table[winches.place[:, HELD] == held, SURGE].sum())


def result_rows(built: Built, most: Reeled | None) -> Rows | None:
    """Return the rows of results that have room for lines cut as in `most`; None where they are those of the system."""
    if built.reeled is None or most is None:
        return None
    names, extra, end = built.names, np.zeros(len(built.names.lines), dtype=np.int64), {}
    for w, count, room in zip(built.winches, built.reeled.segments, most.segments, strict=True):
        extra[w.line], end[w.line] = room - count, w.end
    parts = []
    for k, more in enumerate(extra):
        n = int(names.segment_ptr[k + 1] - names.segment_ptr[k])
        hidden = 0 if end.get(k, 1) else more  # rows before the first that is out
        nodes, segments = np.arange(n + more + 1) - hidden, np.arange(n + more) - hidden
        parts.append(
            Rows(
                names.node_ptr[k] + np.clip(nodes, 0, n),
                names.segment_ptr[k] + np.clip(segments, 0, n - 1),
                (nodes < 0) | (nodes > n),
                (segments < 0) | (segments > n - 1),
            )
        )
    return Rows(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def watched_now(watch: tuple[tuple[int, int], ...], built: Built) -> np.ndarray:
    """Return the nodes to record, (n, 2): line and node, of nodes numbered as the lines are described.

    Numbers are those of the material, from the end that is not on the winch; the last is always the end at the winch.
    """
    nodes = np.array(watch, dtype=np.int64).reshape(-1, 2)
    for w, count in zip(built.winches, built.reeled.segments if built.reeled else (), strict=True):
        made = count - len(w.lengths)
        last = int(built.names.segment_ptr[w.line + 1] - built.names.segment_ptr[w.line])
        mine = nodes[:, 0] == w.line
        node = nodes[mine, 1]
        if w.end:
            nodes[mine, 1] = np.where(node == last - made, last, np.minimum(node, last))
        else:
            nodes[mine, 1] = np.where(node == 0, 0, np.maximum(node + made, 0))
    return nodes


def in_rows(histories: dict[str, np.ndarray], rows: Rows | None, built: Built) -> dict[str, np.ndarray]:
    """Return the histories of a system, and what winches change of the segments, in the rows of a result.

    The latter are the unstretched length (m), its rate over it (1/s), and the damper BA / l (N s/m).
    """
    time = histories["node_time"]
    segments = len(built.names.segment_length)
    length = np.tile(built.names.segment_length, (len(time), 1))
    damper, growth = np.tile(built.system.tension.damper[:segments], (len(time), 1)), np.zeros_like(length)
    paid, winches = paid_by(built), built.system.winches
    for place, table in zip(winches.place, winches.table, strict=True):
        j, (out, rate) = place[SEGMENT], paid[place[TRACK] - built.paid[0]].over(time)
        length[:, j] = table[OFFSET] + out
        growth[:, j], damper[:, j] = rate / length[:, j], table[RATIO] + table[DAMPER] / length[:, j]
    histories = histories | {"segment_length": length, "segment_growth": growth, "segment_damper": damper}
    if rows is None:
        return histories
    out = {"node_time": time}
    for name, values in histories.items():
        if name.startswith("segment_"):
            out[name] = values[:, rows.segments]
        elif name != "node_time":
            out[name] = values[:, rows.nodes]
    out["segment_length"][:, rows.no_segment] = 0.0
    for name in FORCES:
        out[name][:, rows.no_node] = 0.0
    return out


def length_columns(built: Built, time: np.ndarray) -> dict[str, np.ndarray]:
    """Return the unstretched lengths of the lines (m) and their rates (m/s) at times (n,), (n, lines)."""
    names, n = built.names, len(built.names.lines)
    length = np.tile(np.add.reduceat(names.segment_length, names.segment_ptr[:-1]), (len(time), 1))
    rate, paid = np.zeros((len(time), n)), paid_by(built)
    for place, table in zip(built.system.winches.place, built.system.winches.table, strict=True):
        line, j = place[LINE], place[SEGMENT]
        out, speed = paid[place[TRACK] - built.paid[0]].over(time)
        length[:, line] += table[OFFSET] + out - names.segment_length[j]
        rate[:, line] = speed
    return {"line_length": length, "payout_rate": rate}
