"""What a winch pays out over time, as pieces of cubics."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from moorage.errors import ModelError, Problem
from moorage.model.components import Control, Curve
from moorage.model.model import Model


class Paid(NamedTuple):
    """A length over time: sum of coefficient s^power, s from the last knot; the end pieces go on."""

    knots: np.ndarray  # (n + 1,) s
    pieces: np.ndarray  # (n, 4) highest power first

    def at(self, time: float) -> tuple[float, float]:
        """Return the length (m) and its rate (m/s) at a time, s."""
        length, rate = self.over(np.array([time]))
        return float(length[0]), float(rate[0])

    def over(self, time: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the lengths (n,), m, and their rates, m/s, at times (n,), s."""
        k = np.clip(np.searchsorted(self.knots, time, side="right") - 1, 0, len(self.pieces) - 1)
        s = time - self.knots[k]
        a, b, c, d = self.pieces[k].T
        return ((a * s + b) * s + c) * s + d, (3.0 * a * s + 2.0 * b) * s + c

    def first_outside(self, after: float, until: float, low: float, high: float) -> float:
        """Return the first time from `after` to `until` (s) at which the length leaves low..high; infinity if never."""
        if not low <= self.at(after)[0] <= high:
            return after
        begin = np.concatenate([[-np.inf], self.knots[1:-1]])
        end = np.concatenate([self.knots[1:-1], [np.inf]])
        for k in np.flatnonzero((end > after) & (begin < until)):
            s0, s1 = max(begin[k], after) - self.knots[k], min(end[k], until) - self.knots[k]
            if s1 < s0 or not self._may_leave(int(k), s0, s1, low, high):
                continue
            times = [s for bound in (low, high) for s in _crossings(self.pieces[k], bound, s0, s1)]
            if times:
                return float(self.knots[k] + min(times))
        return math.inf

    def _may_leave(self, k: int, s0: float, s1: float, low: float, high: float) -> bool:
        """Whether the control points of a part of a piece, which hold it, are not all within low..high."""
        a, b, c, d = self.pieces[k]
        h = s1 - s0
        a, b, c, d = a, b + 3.0 * a * s0, c + (2.0 * b + 3.0 * a * s0) * s0, ((a * s0 + b) * s0 + c) * s0 + d
        points = np.array([d, d + c * h / 3.0, d + 2.0 * c * h / 3.0 + b * h * h / 3.0, d + h * (c + h * (b + h * a))])
        return bool(points.min() < low or points.max() > high)


def _crossings(piece: np.ndarray, bound: float, s0: float, s1: float) -> list[float]:
    """Return where a cubic that starts within its bounds passes one of them, between s0 and s1."""
    roots = np.roots(piece - [0.0, 0.0, 0.0, bound])
    real = roots.real[np.abs(roots.imag) < 1e-9 * (1.0 + np.abs(roots.real))]
    slope = np.polyder(piece)
    inside = [float(np.clip(s, s0, s1)) for s in real if s0 - 1e-9 <= s <= s1 + 1e-9]
    return [s for s in inside if s > s0 or np.polyval(slope, s) != 0.0]


def paid_out(control: Control) -> Paid:
    """Return what a control pays out."""
    if control.length is not None:
        t, y = np.array(control.length.x, float), np.array(control.length.y, float)
        return _held(t, _hermite(t, y, gentle_slopes(t, y)), y[0], 0.0, y[-1], 0.0)
    if isinstance(control.rate, Curve):
        t, r = np.array(control.rate.x, float), np.array(control.rate.y, float)
        h = np.diff(t)
        length = np.concatenate([[0.0], np.cumsum(0.5 * h * (r[1:] + r[:-1]))])
        pieces = np.stack([np.zeros(len(h)), 0.5 * np.diff(r) / h, r[:-1], length[:-1]], axis=1)
        paid = _held(t, pieces, 0.0, r[0], length[-1], r[-1])
        paid.pieces[:, 3] -= paid.at(0.0)[0]  # nothing at time 0
        return paid
    return Paid(np.array([0.0, 1.0]), np.array([[0.0, 0.0, float(control.rate or 0.0), 0.0]]))


def _held(t: np.ndarray, pieces: np.ndarray, y0: float, r0: float, y1: float, r1: float) -> Paid:
    """Add straight pieces before and after."""
    before, after = [[0.0, 0.0, r0, y0 - r0]], [[0.0, 0.0, r1, y1]]
    return Paid(np.concatenate([[t[0] - 1.0], t, [t[-1] + 1.0]]), np.concatenate([before, pieces, after]))


def _hermite(t: np.ndarray, y: np.ndarray, slope: np.ndarray) -> np.ndarray:
    h = np.diff(t)
    d = np.diff(y) / h
    bend = (slope[:-1] + slope[1:] - 2.0 * d) / h
    return np.stack([bend / h, (d - slope[:-1]) / h - bend, slope[:-1], y[:-1]], axis=1)


def gentle_slopes(t: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Return slopes (n,) at the rows of a table with which cubics never overshoot; zero at both ends.

    The weighted harmonic mean of the slopes on both sides, zero where these differ in sign (Fritsch & Butland 1984).
    """
    h = np.diff(t)
    d = np.diff(y) / h
    slope = np.zeros(len(t))
    same = d[1:] * d[:-1] > 0.0
    w1, w2 = 2.0 * h[1:] + h[:-1], h[1:] + 2.0 * h[:-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        slope[1:-1] = np.where(same, (w1 + w2) / (w1 / d[:-1] + w2 / d[1:]), 0.0)
    return slope


def driven(model: Model, payout: Mapping[int, Curve] | None) -> Model:
    """Return the model with the lengths (m over s) of some channels in place of what it says.

    Raises
    ------
    ModelError
        There is no such channel.
    """
    if not payout:
        return model
    known = [control.channel for control in model.controls]
    listed = f"its channels are {', '.join(map(str, known))}" if known else "it has none; describe them under controls"
    if unknown := [channel for channel in payout if channel not in known]:
        raise ModelError([Problem(f"the model has no control channel {channel}", listed) for channel in unknown])
    controls = tuple(
        dataclasses.replace(control, length=payout[control.channel], rate=None)
        if control.channel in payout
        else control
        for control in model.controls
    )
    return dataclasses.replace(model, controls=controls)
