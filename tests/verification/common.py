"""What the verifications share: how a rate is measured, how a wrong variant must fail, and exact catenaries."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pytest
from scipy.optimize import fsolve


def rate(sizes, errors) -> float:
    """Return the slope p of error ~ size^p, fitted to all pairs in logarithms."""
    return float(np.polyfit(np.log(sizes), np.log(np.maximum(errors, 1e-300)), 1)[0])


def must_fail(check: Callable[..., None], *arguments, **named) -> None:
    """Run a check on a deliberately wrong variant, and fail if it does not notice."""
    with pytest.raises(AssertionError):
        check(*arguments, **named)


def rms(values) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def frequency(samples, interval: float) -> float:
    """Return the frequency (rad/s) of one damped oscillation about any mean, from samples y.

    Such samples fulfil y[n+1] = 2 r cos(w dt) y[n] - r^2 y[n-1] + c; least squares give the three coefficients.
    """
    y = np.asarray(samples)
    (a, b, _), *_ = np.linalg.lstsq(np.stack([y[1:-1], y[:-2], np.ones(len(y) - 2)], axis=1), y[2:], rcond=None)
    return float(np.abs(np.angle(np.roots([1.0, -a, -b])[0])) / interval)


class Catenary(NamedTuple):
    """An elastic line from a lower to an upper point, solved on its own: nothing of Moorage is used.

    Irvine (1981), Cable Structures, chapter 2, with V0 = V - wL the vertical force at the lower end and s the
    unstretched arc length from there:

        x = H s / EA + H / w [asinh((V0 + w s) / H) - asinh(V0 / H)]
        z = (s / EA)(V0 + w s / 2) + H / w [sqrt(1 + ((V0 + w s) / H)^2) - sqrt(1 + (V0 / H)^2)]

    Where the lower part lies on a smooth rigid bed (Jonkman 2007, equations 2-37 and 2-38), V0 = 0 and s counts from
    the point of touch-down at L - V / w.
    """

    length: float  # m, unstretched
    stiffness: float  # EA, N
    weight: float  # N/m
    grounded: bool

    def shape(self, H, V, s):
        """Position (m) at arc lengths s (m) from the lower end, for tension components (N) at the upper end."""
        EA, w = self.stiffness, self.weight
        lying = self.length - V / w if self.grounded else 0.0
        V0 = V - w * (self.length - lying)
        up = np.maximum(s - lying, 0.0)
        x = np.minimum(s, lying) + H * s / EA + H / w * (np.arcsinh((V0 + w * up) / H) - np.arcsinh(V0 / H))
        z = up / EA * (V0 + 0.5 * w * up) + H / w * (np.hypot(1.0, (V0 + w * up) / H) - np.hypot(1.0, V0 / H))
        return x, z

    def solve(self, span: float, rise: float) -> tuple[float, float]:
        """Return the tension components (H, V) at the upper end, N."""

        def miss(u):
            x, z = self.shape(np.exp(u[0]), u[1], self.length)
            return (x - span) / self.length, (z - rise) / self.length

        w, L = self.weight, self.length
        if self.grounded:
            guess = [np.log(w * rise), 1.5 * w * rise]
        else:
            slack = np.sqrt(max(L**2 - rise**2, 1e-6)) / span
            guess = [np.log(0.5 * w * span / np.sqrt(max(6.0 * (slack - 1.0), 0.05))), 0.6 * w * L]
        u = fsolve(miss, guess, xtol=1e-13)
        assert np.abs(miss(u)).max() < 1e-10, "the reference itself did not converge"
        return float(np.exp(u[0])), float(u[1])

    def end_tensions(self, span: float, rise: float) -> np.ndarray:
        """Return the tensions at the lower and the upper end, N."""
        H, V = self.solve(span, rise)
        return np.hypot(H, [0.0 if self.grounded else V - self.weight * self.length, V])

    def jacobian(self, H: float, V: float) -> np.ndarray:
        """Return d(x, z) / d(H, V) of the upper end, by central differences."""
        columns = []
        for d in (np.array([1e-5 * H, 0.0]), np.array([0.0, 1e-5 * V])):
            ahead, behind = (np.array(self.shape(H + k * d[0], V + k * d[1], self.length)) for k in (1.0, -1.0))
            columns.append((ahead - behind) / (2.0 * d.sum()))
        return np.array(columns).T

    def lumping(self, span: float, rise: float, segments: int) -> np.ndarray:
        """Return the relative errors of both end tensions when the line is cut into lumped segments, to order h^2.

        A segment has the slope of the force at its middle, so that the position of the upper end is a midpoint sum of
        the line's direction t(s) = (H, V) / T: its error is -(h^2 / 24)[t'] between the ends, t' = (w / T^3)(-H V, H^2).
        On a bed, the first segment off it has its middle 0 < p < h behind the point of touch-down, and its half on the
        bed adds -(w / 2H)(p - h / 2)^2 to z: between 2 and -1 times the other term there. (H, V) must make up for it.
        The anchor on a bed holds half a segment's weight beside H.
        """
        H, V = self.solve(span, rise)
        lower, h = 0.0 if self.grounded else V - self.weight * self.length, self.length / segments

        def slope(v):
            return self.weight / np.hypot(H, v) ** 3 * np.array([-H * v, H**2])

        miss = -(h**2) / 24.0 * (slope(V) - slope(lower))
        if self.grounded:
            touch = (self.length - V / self.weight) / h
            p = (np.ceil(touch - 0.5) + 0.5 - touch) * h
            miss[1] -= 0.5 * self.weight / H * (p - 0.5 * h) ** 2
        dH, dV = -np.linalg.solve(self.jacobian(H, V), miss)
        upper = (H * dH + V * dV) / np.hypot(H, V) ** 2
        if self.grounded:
            return np.array([dH / H + 0.125 * (self.weight * h / H) ** 2, upper])
        return np.array([(H * dH + lower * dV) / np.hypot(H, lower) ** 2, upper])

    def stiffness_of_ends(
        self, span: float, rise: float, segments: int | None = None, phase: float | None = None
    ) -> np.ndarray:
        """Return d(H, V) / d(x, z) of the upper end, N/m, of the continuous line or of lumped segments to order h.

        The line cannot roll off a node of the bed as it does off a bed: between two lift-offs the first segment off the
        bed turns about a node at rest. That changes dz / dV by -(p - h / 2) / H, with 0 < p < h the distance of its
        middle from the point of touch-down (`phase` = p / h; by default where it falls on this grid).
        """
        H, V = self.solve(span, rise)
        J = self.jacobian(H, V)
        if segments is not None:
            h = self.length / segments
            if phase is None:
                touch = (self.length - V / self.weight) / h
                phase = np.ceil(touch - 0.5) + 0.5 - touch
            J[1, 1] -= (phase - 0.5) * h / H
        return np.linalg.inv(J)
