"""Level and slope of the seabed at a place: flat, bilinear on a rectangular grid, or smooth (bicubic) on it.

Bilinear depth is that of Housner et al. 2022, section 2.1: continuous, but its normal jumps from cell to cell. With a
jump a node in a crease, where a chain without friction ends up, has no equilibrium: the bed pushes it to and fro. So
the slopes change from one cell's to the next over a hundredth of the cell on each side of an edge; the depth stays
bilinear. The smooth surface passes through the same grid points with slopes from central differences, so that its
normal is continuous everywhere. Outside the grid the nearest edge goes on, level, as in MoorDyn.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from moorage._jit import inlined, part
from moorage.physics.grid import Axis, build_axis, locate

EASE = 0.01  # of a cell, beside its edges, where the slopes of two cells meet


class Bathymetry(NamedTuple):
    """Parameters of the surface z_b(x, y)."""

    x: Axis  # nx points; none: a flat bed
    y: Axis  # ny points
    level: np.ndarray  # (nx, ny) z of the bed, m
    patch: (
        np.ndarray
    )  # (nx, ny, 4) z_x, z_y, z_xy at the points of a smooth surface, and nothing; or of a bilinear one on
    # even spacing (nx - 1, ny - 1, 4) a, b, c, d of its cells, a + b u + c v + d u v
    flat: float  # z of a flat bed, m
    highest: float  # no part of the bed is above this, m
    smooth: bool


def flat_bed(level: float) -> Bathymetry:
    """Return a level bed at z = level (m)."""
    none = build_axis(())
    return Bathymetry(none, build_axis(()), np.zeros((0, 0)), np.zeros((0, 0, 4)), float(level), float(level), False)


def grid_bed(x, y, depth, smooth: bool = False) -> Bathymetry:
    """Return a bed through depths (nx, ny), m positive down, at x (nx,) and y (ny,), m."""
    x, y, level = np.array(x, float), np.array(y, float), -np.array(depth, float)
    patch, highest = np.zeros((0, 0, 4)), float(level.max())
    if smooth:
        patch = slopes_of(x, y, level)
        # a bicubic may overshoot its grid points by an eighth of a cell's slopes
        steps = max(np.diff(x).max(initial=0.0), np.diff(y).max(initial=0.0))
        highest += 0.25 * steps * float(np.abs(patch[:, :, :2]).max(initial=0.0))
    elif is_even(x) and is_even(y):
        patch = cells_of(level)
    return Bathymetry(build_axis(x), build_axis(y), np.ascontiguousarray(level), patch, 0.0, highest, smooth)


def slopes_of(x, y, level) -> np.ndarray:
    """Return z_x, z_y and z_xy (nx, ny, 4; the last is nothing) at the points of a grid by central differences."""
    zx = np.gradient(level, x, axis=0) if len(x) > 1 else np.zeros_like(level)
    zy = np.gradient(level, y, axis=1) if len(y) > 1 else np.zeros_like(level)
    zxy = np.gradient(zx, y, axis=1) if len(y) > 1 else np.zeros_like(level)
    return np.ascontiguousarray(np.stack([zx, zy, zxy, np.zeros_like(level)], axis=2))


def is_even(axis) -> bool:
    """Return whether an axis has two points or more, in even spacing to rounding."""
    return len(axis) > 1 and float(np.ptp(np.diff(axis))) <= 1e-14 * float(np.abs(axis).max()) * len(axis)


def cells_of(level) -> np.ndarray:
    """Return a, b, c, d of the levels a + b u + c v + d u v in the cells of a grid (nx, ny)."""
    a, b, c = level[:-1, :-1], level[1:, :-1] - level[:-1, :-1], level[:-1, 1:] - level[:-1, :-1]
    return np.ascontiguousarray(np.stack([a, b, c, level[1:, 1:] - level[1:, :-1] - c], axis=2))


@inlined
def bed_at(p, x, y):
    """Level (m), slopes z_x and z_y (-), and z_xx, z_xy, z_yy (1/m) of the bed at a place."""
    if len(p.x.at) == 0:
        return p.flat, 0.0, 0.0, 0.0, 0.0, 0.0
    # the way of nearly all nodes, for which a search of the cell costs as much as all other terms of the bed
    s, t = (x - p.x.at[0]) * p.x.rate, (y - p.y.at[0]) * p.y.rate
    if not p.smooth and 0.0 <= s < p.patch.shape[0] and 0.0 <= t < p.patch.shape[1]:
        k, m = int(s), int(t)
        u, v = s - k, t - m
        if EASE <= u <= 1.0 - EASE and EASE <= v <= 1.0 - EASE:
            i, j = np.uintp(k), np.uintp(m)
            a, b, c, d = p.patch[i, j, 0], p.patch[i, j, 1], p.patch[i, j, 2], p.patch[i, j, 3]
            zu, zv = b + d * v, c + d * u
            return a + b * u + zv * v, zu * p.x.rate, zv * p.y.rate, 0.0, d * p.x.rate * p.y.rate, 0.0
    return searched_bed_at(p, x, y)


@part
def searched_bed_at(p, x, y):
    """Same at any place of any grid."""
    i, i1, u, per_x = locate(p.x, x)
    j, j1, v, per_y = locate(p.y, y)
    dx, dy = p.x.at[i1] - p.x.at[i], p.y.at[j1] - p.y.at[j]
    if p.smooth:
        z, zu, zv, zuu, zuv, zvv = bicubic(p, i, i1, j, j1, dx, dy, u, v)
    else:
        z, zu, zv, zuv = bilinear(p, i, i1, j, j1, u, v)
        zuu, zvv = 0.0, 0.0
        if u < EASE or u > 1.0 - EASE:
            other, share = slope_x_beyond(p, int(i) - 1 if u < 0.5 else int(i) + 1, dx, j, j1, v)
            zu, zuu = eased(zu, other, share, u)
        if v < EASE or v > 1.0 - EASE:
            other, share = slope_y_beyond(p, int(j) - 1 if v < 0.5 else int(j) + 1, dy, i, i1, u)
            zv, zvv = eased(zv, other, share, v)
    return z, zu * per_x, zv * per_y, zuu * per_x * per_x, zuv * per_x * per_y, zvv * per_y * per_y


@inlined
def bilinear(p, i, i1, j, j1, u, v):
    """Value of the bilinear surface in a cell, its derivatives to u and v, and the mixed one."""
    a, b, c = p.level[i, j], p.level[i1, j] - p.level[i, j], p.level[i, j1] - p.level[i, j]
    d = p.level[i1, j1] - p.level[i1, j] - c
    return a + b * u + c * v + d * u * v, b + d * v, c + d * u, d


@inlined
def slope_x_beyond(p, i, dx, j, j1, v):
    """Rise along x of the neighbour cell i over a length dx, and its share at the edge: all where the grid ends."""
    if i < 0 or i > len(p.x.at) - 2:
        return 0.0, 1.0
    low, high = p.level[i + 1, j] - p.level[i, j], p.level[i + 1, j1] - p.level[i, j1]
    return (low + v * (high - low)) * dx / (p.x.at[i + 1] - p.x.at[i]), 0.5


@inlined
def slope_y_beyond(p, j, dy, i, i1, u):
    """Same along y of the neighbour cell j."""
    if j < 0 or j > len(p.y.at) - 2:
        return 0.0, 1.0
    low, high = p.level[i, j + 1] - p.level[i, j], p.level[i1, j + 1] - p.level[i1, j]
    return (low + u * (high - low)) * dy / (p.y.at[j + 1] - p.y.at[j]), 0.5


@inlined
def eased(slope, other, share, s):
    """Slope at s within a cell (0 to 1), on its way to `other` beyond the near edge, and its derivative to s."""
    far = min(s, 1.0 - s) / EASE
    turn = share * (other - slope)
    return slope + turn * (1.0 - far), (-turn if s < 0.5 else turn) / EASE


@inlined
def hermite_basis(s):
    """Basis functions of a cubic by values and slopes at 0 and 1, with first and second derivatives."""
    return (
        (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), s * (1.0 - s) * (1.0 - s), s * s * (3.0 - 2.0 * s), s * s * (s - 1.0),
        6.0 * s * (s - 1.0), (1.0 - s) * (1.0 - 3.0 * s), 6.0 * s * (1.0 - s), s * (3.0 * s - 2.0),
        12.0 * s - 6.0, 6.0 * s - 4.0, 6.0 - 12.0 * s, 6.0 * s - 2.0,
    )  # fmt: skip


@inlined
def bicubic(p, i, i1, j, j1, dx, dy, u, v):
    """Value and derivatives to u and v of the smooth surface in a cell."""
    U, V = hermite_basis(u), hermite_basis(v)
    out = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    for a in range(2):
        ii = i if a == 0 else i1
        f, g = (U[0], U[1] * dx) if a == 0 else (U[2], U[3] * dx)
        f1, g1 = (U[4], U[5] * dx) if a == 0 else (U[6], U[7] * dx)
        f2, g2 = (U[8], U[9] * dx) if a == 0 else (U[10], U[11] * dx)
        for b in range(2):
            jj = j if b == 0 else j1
            h, k = (V[0], V[1] * dy) if b == 0 else (V[2], V[3] * dy)
            h1, k1 = (V[4], V[5] * dy) if b == 0 else (V[6], V[7] * dy)
            h2, k2 = (V[8], V[9] * dy) if b == 0 else (V[10], V[11] * dy)
            z, zx, zy, zxy = p.level[ii, jj], p.patch[ii, jj, 0], p.patch[ii, jj, 1], p.patch[ii, jj, 2]
            out = (
                out[0] + f * (h * z + k * zy) + g * (h * zx + k * zxy),
                out[1] + f1 * (h * z + k * zy) + g1 * (h * zx + k * zxy),
                out[2] + f * (h1 * z + k1 * zy) + g * (h1 * zx + k1 * zxy),
                out[3] + f2 * (h * z + k * zy) + g2 * (h * zx + k * zxy),
                out[4] + f1 * (h1 * z + k1 * zy) + g1 * (h1 * zx + k1 * zxy),
                out[5] + f * (h2 * z + k2 * zy) + g * (h2 * zx + k2 * zxy),
            )
    return out


@inlined
def normal_of(zx, zy):
    """Unit normal of a bed with these slopes, upwards."""
    if zx == 0.0 and zy == 0.0:
        return 0.0, 0.0, 1.0
    nz = 1.0 / math.sqrt(1.0 + zx * zx + zy * zy)
    return -zx * nz, -zy * nz, nz
