"""Airy waves at a point, summed over components: what the water does there, and how that changes.

One pass over the components gives the elevation, a second the profile at the level that stretching puts in the place
of z. Both are written so that the compiler does several components at once: sine, cosine and exponential are
polynomials without branches (1e-11 and 2e-10), arrays are sorted by wavenumber and padded with components of no
amplitude. Components that do not reach down to a point are left out (e^-20).

The water is free of rotation and of sources: w_x = u_z, w_y = v_z, w_z = -(u_x + v_y).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, summed

NONE, WHEELER, VERTICAL, LINEAR = 0, 1, 2, 3
PAD = 16
REACH = 20.0  # components with k |z'| above this are left out
BELOW = 1e-3  # of the shortest wave's 1/k: the second level from which linear stretching goes on
# columns of a record: elevation and its derivatives; velocity; acceleration; its time derivative; gradients of both
ETA, ETA_T, ETA_X, ETA_Y, U, A, J, GRAD_U, GRAD_A, RECORD = 0, 1, 2, 3, 4, 7, 10, 13, 18, 23
WATER = 7  # elevation, velocity and acceleration
# rows of a sea's parts: amplitudes of the velocity over w and of the surface, m, the same for free waves; rad/s; rad;
# k and its parts along x and y, rad/m; exp(-2 k h)
AMPLITUDE, ELEVATION, FREQUENCY, PHASE, K, KX, KY, DEEP, PARTS = 0, 1, 2, 3, 4, 5, 6, 7, 8


class Sea(NamedTuple):
    """Components (padded) of the waves, and how they are used; or water that is given.

    Few arrays hold all, because each field of a system makes all kernels longer to compile.
    """

    parts: np.ndarray  # (PARTS, n) of the components, in the order of k; n = 0: no waves
    given: (
        np.ndarray
    )  # (2, rows + 1, WATER) at two times, which stand in the last row: see `given_water`; rows = 0: none
    depth: float  # m
    stretching: int
    ramp: float  # s
    interval: float  # s between the times of the table; 0: a sum at each evaluation


def no_sea() -> Sea:
    """Return still water."""
    return Sea(np.zeros((PARTS, 0)), given_at(0), 1.0, WHEELER, 0.0, 0.0)


def given_at(rows) -> np.ndarray:
    """Return still water that can be set at rows of the state."""
    return np.zeros((2, rows + 1, WATER))


def scratch_for(sea: Sea, *shape) -> np.ndarray:
    """Return scratch space for sums, (*shape, 3, ...): of all components, and a record."""
    n = sea.parts.shape[1]
    return np.zeros((*shape, 3, max(n, RECORD) if n else 0))


def sea_of(amplitude, elevation, frequency, phase, k, direction, depth, stretching, ramp, interval) -> Sea:
    """Return waves of components (n,), sorted and padded."""
    order = np.argsort(k, kind="stable")

    def padded(values, fill=None):
        values = np.asarray(values, float)[order]
        more = -len(values) % PAD
        return np.concatenate([values, np.full(more, values[-1] if fill is None else fill)])

    k = np.asarray(k, float)
    parts = [padded(amplitude, 0.0), padded(elevation, 0.0)]
    parts += map(padded, (frequency, phase, k, k * np.cos(direction), k * np.sin(direction), np.exp(-2.0 * k * depth)))
    return Sea(np.stack(parts), given_at(0), float(depth), stretching, float(ramp), float(interval))


@inlined
def count(p):
    """Number of components."""
    return p.parts.shape[1]


@inlined
def largest_k(p):
    """Wavenumber of the shortest component, rad/m."""
    return p.parts[K, p.parts.shape[1] - 1]


@inlined
def is_given(p):
    """Whether the water is given."""
    return p.given.shape[1] > 1


@inlined
def given_water(p, i, t, out):
    """Set the water of a row as it is given: linear between two times and held outside."""
    a, b = p.given[0, p.given.shape[1] - 1, 0], p.given[1, p.given.shape[1] - 1, 0]
    s = (t - a) / (b - a) if a < t < b else (0.0 if t < b else 1.0)
    for c in range(WATER):
        out[c] = (1.0 - s) * p.given[0, i, c] + s * p.given[1, i, c]


@inlined
def grown(p, t):
    """Share of the sea that has grown by time t, and its rate (1/s)."""
    if p.ramp <= 0.0 or t >= p.ramp:
        return 1.0, 0.0
    if t <= 0.0:
        return 0.0, 0.0
    angle = math.pi * t / p.ramp
    return 0.5 - 0.5 * math.cos(angle), 0.5 * math.pi / p.ramp * math.sin(angle)


@inlined
def fast_sincos(x):
    """Sine and cosine of any angle: reduced to half an angle within +-pi/2, a polynomial, and the double angle."""
    turns = np.rint(x * 0.15915494309189535)
    y = 0.5 * ((x - turns * 6.28125) - turns * 0.0019353071795864769)
    t = y * y
    s = y * (1.0 + t * (SINE[0] + t * (SINE[1] + t * (SINE[2] + t * (SINE[3] + t * (SINE[4] + t * SINE[5]))))))
    c = 1.0 + t * (COSINE[0] + t * (COSINE[1] + t * (COSINE[2] + t * (COSINE[3] + t * (COSINE[4] + t * COSINE[5])))))
    return 2.0 * s * c, 1.0 - 2.0 * s * s


def _minimax(function, odd: bool) -> tuple[float, ...]:
    """Coefficients of t, t^2, ... of sin(y)/y or cos(y) in t = y^2 up to (pi/2)^2; the first one is 1."""
    y = np.cos(np.pi * (np.arange(400) + 0.5) / 400.0) * 0.5 * np.pi
    t = y * y
    rest = ((function(y) / y if odd else function(y)) - 1.0) / t
    fit = np.polynomial.chebyshev.Chebyshev.fit(t, rest, 5, domain=[0.0, 0.25 * np.pi**2])
    return tuple(map(float, fit.convert(kind=np.polynomial.Polynomial).coef))


SINE, COSINE = _minimax(np.sin, True), _minimax(np.cos, False)


@inlined
def fast_exp(y):
    """Exponential of y <= 0 or little more: a Taylor polynomial of y / 64, squared six times; 0 below e^-64."""
    x = max(y * 0.015625, -1.0)
    p = 1.0 / 24.0 + x * (1.0 / 120.0 + x * (1.0 / 720.0 + x * (1.0 / 5040.0 + x / 40320.0)))
    p = 1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * p)))
    p = p * p
    p = p * p
    p = p * p
    p = p * p
    p = p * p
    return p * p


@summed
def elevation_sum(p, x, y, t, c, s):
    """Elevation at a place with its derivatives to t, x and y; A cos and A sin of the components go to c and s."""
    eta, eta_t, eta_x, eta_y = 0.0, 0.0, 0.0, 0.0
    for j in range(count(p)):
        sine, cosine = fast_sincos(
            p.parts[FREQUENCY, j] * t + p.parts[PHASE, j] - p.parts[KX, j] * x - p.parts[KY, j] * y
        )
        c[j], s[j] = p.parts[AMPLITUDE, j] * cosine, p.parts[AMPLITUDE, j] * sine
        cosine *= p.parts[ELEVATION, j]
        sine *= p.parts[ELEVATION, j]
        eta += cosine
        eta_t -= p.parts[FREQUENCY, j] * sine
        eta_x += p.parts[KX, j] * sine
        eta_y += p.parts[KY, j] * sine
    return eta, eta_t, eta_x, eta_y


@summed
def profile_sum(p, level, reach, c, s, out):
    """Write velocity, acceleration, its time derivative and the gradients at a level into a record."""
    u, v, w, ax, ay, az, jx, jy, jz = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    uxx, uxy, uyy, uxz, uyz = 0.0, 0.0, 0.0, 0.0, 0.0
    axx, axy, ayy, axz, ayz = 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(reach):
        E = fast_exp(p.parts[K, j] * level)
        F = p.parts[DEEP, j] / E
        both, f = 1.0 / (1.0 - p.parts[DEEP, j]), p.parts[FREQUENCY, j]
        side, up = (E + F) * both * f / p.parts[K, j], (E - F) * both * f  # side / k: directions come with kx, ky
        X, Y, P, Q = side * c[j], side * s[j], up * c[j], up * s[j]
        hx, hy = p.parts[KX, j], p.parts[KY, j]
        Xx, Xy, Yx, Yy = X * hx, X * hy, Y * hx, Y * hy
        u += Xx
        v += Xy
        w -= Q
        uxx += hx * Yx
        uxy += hx * Yy
        uyy += hy * Yy
        uxz += hx * P
        uyz += hy * P
        ax -= f * Yx
        ay -= f * Yy
        az -= f * P
        axx += f * hx * Xx
        axy += f * hx * Xy
        ayy += f * hy * Xy
        axz -= f * hx * Q
        ayz -= f * hy * Q
        jx -= f * f * Xx
        jy -= f * f * Xy
        jz += f * f * Q
    out[U], out[U + 1], out[U + 2] = u, v, w
    out[A], out[A + 1], out[A + 2] = ax, ay, az
    out[J], out[J + 1], out[J + 2] = jx, jy, jz
    out[GRAD_U], out[GRAD_U + 1], out[GRAD_U + 2], out[GRAD_U + 3], out[GRAD_U + 4] = uxx, uxy, uyy, uxz, uyz
    out[GRAD_A], out[GRAD_A + 1], out[GRAD_A + 2], out[GRAD_A + 3], out[GRAD_A + 4] = axx, axy, ayy, axz, ayz


@inlined
def stretched(p, z, eta):
    """Level z' (m) that stands for z, and its derivatives to z and to the elevation.

    Above the surface, where only partly wet segments look, z' tends smoothly to 1/k of the shortest component: a
    corner there would spoil the interpolation in time. Vertical stretching has its own corner at the still water.
    """
    if p.stretching == VERTICAL:
        return (0.0, 0.0, 0.0) if z > 0.0 else (max(z, -p.depth), 1.0, 0.0)
    level, to_z, to_eta, surface = z, 1.0, 0.0, eta
    if p.stretching == WHEELER:
        to_z = p.depth / (p.depth + eta)
        level = to_z * (z + p.depth) - p.depth
        to_eta = -(z + p.depth) * to_z / (p.depth + eta)
        surface = 0.0
    if level > surface:
        q = (level - surface) * largest_k(p)
        q = q * q * q * q
        factor = (1.0 + q) ** -1.25
        level = surface + (level - surface) * (1.0 + q) ** -0.25
        to_z *= factor
        to_eta = factor * to_eta if p.stretching == WHEELER else 1.0 - factor
    return max(level, -p.depth), to_z, to_eta


@inlined
def within_reach(p, level):
    """Number of components, a multiple of PAD, that reach down to a level."""
    n = count(p)
    if -level * largest_k(p) <= REACH:
        return n
    return min(n, (np.searchsorted(p.parts[K], -REACH / level) // PAD + 1) * PAD)


@inlined
def record_at(p, r, t, share, scratch, out):
    """Fill a record (RECORD,) for the place r and time t, without the ramp; share: of the sea that has grown by t.

    scratch, see `scratch_for`, is overwritten.
    """
    c, s = scratch[0], scratch[1]
    eta, eta_t, eta_x, eta_y = elevation_sum(p, r[0], r[1], t, c, s)
    level, _, _ = stretched(p, r[2], share * eta)
    out[ETA], out[ETA_T], out[ETA_X], out[ETA_Y] = eta, eta_t, eta_x, eta_y
    beyond = max(level, 0.0) if p.stretching == LINEAR else 0.0
    below, reach = BELOW / largest_k(p), within_reach(p, level)
    for n in range(2 if beyond > 0.0 else 1):  # one call in a loop, because it is long
        profile_sum(p, level - beyond - n * below, reach, c, s, out if n == 0 else scratch[2])
    if beyond > 0.0:
        go_beyond(beyond, below, scratch[2], out)


@inlined
def go_beyond(height, below, lower, out):
    """Continue a record of the still water level up to a height (m), by its slopes and a record a little below."""
    for side in range(2):
        value, g = (U, GRAD_U) if side == 0 else (A, GRAD_A)
        out[value] += height * out[g + 3]
        out[value + 1] += height * out[g + 4]
        out[value + 2] -= height * (out[g] + out[g + 2])
    # of the rest the slope is not in the record; it serves the interpolation only
    for m in range(3):
        out[J + m] += height / below * (out[J + m] - lower[J + m])
        out[GRAD_U + m] += height / below * (out[GRAD_U + m] - lower[GRAD_U + m])
        out[GRAD_A + m] += height / below * (out[GRAD_A + m] - lower[GRAD_A + m])
