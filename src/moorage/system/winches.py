"""Lines on winches: how many segments are out at a time, and what the compiled winches need.

The inner segments keep the lengths they are described with, those made later that of the last one; the segment at the
winch has the rest. It is cut in two when it is too long, and joined with its neighbour when it is too short.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from moorage.errors import ModelError, Problem, Source
from moorage.layout import System
from moorage.model import Model
from moorage.model.payout import Paid
from moorage.physics import winch as at
from moorage.physics.winch import COLUMNS, PLACES, Winches

FASTEST = 0.02  # s, in which a segment may pass a winch


class Winch(NamedTuple):
    """A line on a winch."""

    line: int  # place in the model
    end: int  # 0: A, 1: B
    control: int  # place in the model
    lengths: tuple[float, ...]  # of the segments of the section at the winch, towards it, m
    shortest: float  # of a segment as described
    longest: float
    what: str
    source: Source | None

    @property
    def described(self) -> float:
        """Length of the section as described, m."""
        return math.fsum(self.lengths)

    def nominal(self, k: int) -> float:
        """Length of the k-th segment of the section as an inner one, m."""
        return self.lengths[min(k, len(self.lengths) - 1)]

    def inner(self, count: int) -> list[float]:
        """Lengths of all but the last of so many segments, m."""
        return [self.nominal(k) for k in range(count - 1)]

    def bounds(self, count: int) -> tuple[float, float]:
        """Return the lengths paid out between which so many segments are right, m."""
        offset = math.fsum(self.inner(count)) - self.described
        return offset + self.shortest * self.nominal(max(count - 2, 0)), offset + self.longest * self.nominal(count - 1)

    def count_for(self, paid: float, count: int, time: float) -> int:
        """Return the number of segments for a length paid out (m) where there have been `count` so far.

        Raises
        ------
        ModelError
            There is not that much line to haul in.
        """
        while paid >= self.bounds(count)[1]:
            count += 1
        while paid <= self.bounds(count)[0] and (count > 1 or paid < self.bounds(1)[0]):
            count -= 1
            if count < 1:
                left = self.described + paid
                message = f"{self.what} would have {left:.4g} m left of the section at its winch at {time:.4g} s"
                least = self.shortest * self.nominal(0)
                raise ModelError(Problem(message, f"haul in less: {least:.4g} m must stay out", self.source))
        return count


class Reeled(NamedTuple):
    """How the lines on winches are cut."""

    segments: tuple[int, ...]  # of the section at each winch
    out: tuple[float, ...]  # length paid out when it was cut, m
    held: tuple[bool, ...]  # whether the line has not come off its winch


def winches_of(model: Model) -> tuple[Winch, ...]:
    """Return the lines of a model that are on winches."""
    place = {line.id: k for k, line in enumerate(model.lines)}
    found = []
    for c, control in enumerate(model.controls):
        for id in control.lines:
            end, line = "AB".index(control.end), model.lines[place[id]]
            lengths = line.sections[-1].segment_lengths if end else line.sections[0].segment_lengths[::-1]
            low, high = control.segment_range
            found.append(Winch(place[id], end, c, lengths, low, high, f"line {id}", control.source))
    return tuple(found)


def at_start(winches: tuple[Winch, ...], paid: list[Paid]) -> Reeled:
    """Return how lines are cut at time 0."""
    out = tuple(paid[w.control].at(0.0)[0] for w in winches)
    counts = tuple(w.count_for(length, len(w.lengths), 0.0) for w, length in zip(winches, out, strict=True))
    return Reeled(counts, out, (True,) * len(winches))


def paid_until(winches: tuple[Winch, ...], paid: list[Paid], now: Reeled, time: float) -> Reeled:
    """Return the same cut with the lengths paid out up to a time, s."""
    outs = zip(winches, now.out, now.held, strict=True)
    return now._replace(out=tuple(paid[w.control].at(time)[0] if held else out for w, out, held in outs))


def next_cut(winches: tuple[Winch, ...], paid: list[Paid], now: Reeled, after: float, until: float):
    """Return when the next segment is made or removed (s, infinity: not before `until`), and how lines are cut then.

    Raises
    ------
    ModelError
        A line is at its end.
    """
    times = [
        paid[w.control].first_outside(after, until, *w.bounds(count)) if held else math.inf
        for w, count, held in zip(winches, now.segments, now.held, strict=True)
    ]
    time = min(times, default=math.inf)
    if time == math.inf:
        return time, now
    counts = [
        recount(w, count, paid[w.control].at(time)[0], time) if at_time == time else count
        for w, count, at_time in zip(winches, now.segments, times, strict=True)
    ]
    return time, paid_until(winches, paid, now._replace(segments=tuple(counts)), time)


def recount(winch: Winch, count: int, paid: float, time: float) -> int:
    """Return the number of segments at a length paid out (m) that has just reached one of the bounds."""
    low, high = winch.bounds(count)
    return winch.count_for(
        max(paid, high) if paid - low > high - paid else min(paid, math.nextafter(low, -1e300)), count, time
    )


def longest_cut(winches: tuple[Winch, ...], paid: list[Paid], duration: float) -> Reeled:
    """Return how lines are cut when most segments are out in a run, each by itself.

    Raises
    ------
    ModelError
        More is hauled in than there is, or so fast that segments cannot follow.
    """
    now = at_start(winches, paid)
    most, time = list(now.segments), 0.0
    while True:
        time, now = next_cut(winches, paid, now, time, duration)
        if time == math.inf:
            return now._replace(segments=tuple(most))
        refuse_haste(winches, [p.at(time)[1] for p in paid], time)
        most = [max(pair) for pair in zip(most, now.segments, strict=True)]


def refuse_haste(winches: tuple[Winch, ...], rates: Sequence[float], time: float) -> None:
    """Refuse a winch whose segments pass so fast that a run would only cut lines; rates: of the controls, m/s."""
    for w in winches:
        rate, segment = abs(rates[w.control]), w.nominal(len(w.lengths) - 1)
        if rate * FASTEST > segment:
            message = f"{w.what}: a rate of {rate:.4g} m/s at {time:.4g} s makes a segment every {segment / rate:.2g} s"
            remedy = f"wind slower, or take segments that last {FASTEST:g} s"
            raise ModelError(Problem(message, remedy, w.source))


def as_cut(model: Model, winches: tuple[Winch, ...], reeled: Reeled) -> Model:
    """Return a model whose lines are as long, and cut, as they are at a time."""
    lengths = []
    for w, count, out in zip(winches, reeled.segments, reeled.out, strict=True):
        inner = w.inner(count)
        lengths.append([*inner, w.described + out - math.fsum(inner)])
    return with_lengths(model, winches, lengths)


def with_lengths(model: Model, winches: tuple[Winch, ...], lengths: list[list[float]]) -> Model:
    """Return a model with segments of other lengths (m, towards the winch) in the sections at the winches."""
    lines = list(model.lines)
    for w, own in zip(winches, lengths, strict=True):
        sections = lines[w.line].sections
        cut = [dataclasses.replace(sections[-w.end], length=l, segments=1, grading=1.0) for l in own]
        sections = (*sections[:-1], *cut) if w.end else (*cut[::-1], *sections[1:])
        lines[w.line] = dataclasses.replace(lines[w.line], sections=sections)
    return dataclasses.replace(model, lines=tuple(lines))


def laid_out(model: Model, winches: tuple[Winch, ...], most: Reeled) -> Model:
    """Return a model without winches whose lines have as many segments, all as long as inner ones."""
    lengths = [[w.nominal(k) for k in range(count)] for w, count in zip(winches, most.segments, strict=True)]
    return dataclasses.replace(with_lengths(model, winches, lengths), controls=())


def come_off(winches: tuple[Winch, ...], reeled: Reeled, ends: set[tuple[int, int]]) -> Reeled:
    """Return how lines are cut when some ends (line; 0: A, 1: B) come off."""
    still = [held and (w.line, w.end) not in ends for w, held in zip(winches, reeled.held, strict=True)]
    return reeled._replace(held=tuple(still))


def no_winches() -> Winches:
    """Return the parameters of a system without winches."""
    return Winches(np.zeros((0, PLACES), dtype=np.int64), np.zeros((0, COLUMNS)))


def build_winches(
    system: System, winches: tuple[Winch, ...], reeled: Reeled, first_track: int, island_of_line, ratio
) -> Winches:
    """Return the compiled winches of a system as it is built; ratio: (segments,) bool, damping by a ratio."""
    place, table = [], []
    for w, out, still in zip(winches, reeled.out, reeled.held, strict=True):
        if not still:
            continue
        first, last = int(system.lines.node_ptr[w.line]), int(system.lines.node_ptr[w.line + 1]) - 1
        held, inner, j = (last, last - 1, last - 1 - w.line) if w.end else (first, first + 1, first - w.line)
        after = int(w.end == 1 and inner != first)
        place.append((w.line, w.end, first_track + w.control, island_of_line[w.line], held, inner, j, after))
        table.append(_columns(system, held, inner, j, after, bool(ratio[j])))
        table[-1][at.OFFSET] = system.tension.length[j] - out
    return Winches(np.array(place, dtype=np.int64).reshape(-1, PLACES), np.array(table).reshape(-1, COLUMNS))


def _columns(system: System, held: int, inner: int, j: int, after: int, ratio: bool) -> np.ndarray:
    """Return the constants of a winch, from what its segment and nodes have in a system that is built."""
    x, l = np.zeros(COLUMNS), system.tension.length[j]
    x[at.LENGTH], x[at.SPRING] = l, system.tension.spring[j] * l
    if ratio:
        x[at.RATIO] = system.tension.damper[j]
    else:
        x[at.DAMPER] = system.tension.damper[j] * l
    x[at.LIFT] = system.weight.buoyancy[j] / l
    x[at.WATER : at.WATER + 5] = system.morison.segment[j] / l
    x[at.HINGE] = (system.bending.after if after else system.bending.before)[inner] * l
    x[at.CLAMP] = system.bending.before[held] * l
    share = _node(system, held) / l
    x[at.SHARE : at.SHARE + at.SHARES] = share
    x[at.REST : at.REST + at.SHARES] = _node(system, inner) - share * l
    return x


def _node(system: System, i: int) -> np.ndarray:
    """Return what a node has of its segments, in proportion to their lengths."""
    soil, contact, friction = system.contact.soil, system.contact, system.friction
    length, diameter = soil.size[i] if soil.on else (0.0, 0.0)
    return np.array(
        [
            system.weight.dry[i], system.morison.mass[i], *system.morison.node[i], contact.spring[i], contact.damper[i],
            length, length * diameter, friction.spring[i], friction.damper[i],
        ]
    )  # fmt: skip
