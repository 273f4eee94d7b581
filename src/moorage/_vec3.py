"""Vectors as 3-tuples and 3x3 blocks as tuples of scalars: they live in registers and cost nothing.

Rows are indexed by unsigned integers, which spares numba's test for negative ones. A symmetric block is
(xx, xy, xz, yy, yz, zz); a general block is its nine entries row by row.
"""

import math

import numpy as np

from moorage._jit import inlined


@inlined
def get(a, i):
    i = np.uintp(i)
    return a[i, 0], a[i, 1], a[i, 2]


@inlined
def put(a, i, u):
    i = np.uintp(i)
    a[i, 0], a[i, 1], a[i, 2] = u


@inlined
def accumulate(a, i, u):
    i = np.uintp(i)
    a[i, 0] += u[0]
    a[i, 1] += u[1]
    a[i, 2] += u[2]


@inlined
def add(u, v):
    return u[0] + v[0], u[1] + v[1], u[2] + v[2]


@inlined
def sub(u, v):
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


@inlined
def scale(c, u):
    return c * u[0], c * u[1], c * u[2]


@inlined
def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


@inlined
def cross(u, v):
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


@inlined
def unit(u):
    return scale(1.0 / math.sqrt(dot(u, u)), u)


# --- symmetric 3x3 blocks -------------------------------------------------------------------------------------------


@inlined
def sym_get(a, i):
    i = np.uintp(i)
    return a[i, 0], a[i, 1], a[i, 2], a[i, 3], a[i, 4], a[i, 5]


@inlined
def sym_put(a, i, s):
    i = np.uintp(i)
    a[i, 0], a[i, 1], a[i, 2], a[i, 3], a[i, 4], a[i, 5] = s


@inlined
def sym_accumulate(a, i, s):
    i = np.uintp(i)
    a[i, 0] += s[0]
    a[i, 1] += s[1]
    a[i, 2] += s[2]
    a[i, 3] += s[3]
    a[i, 4] += s[4]
    a[i, 5] += s[5]


@inlined
def sym_add(s, t):
    return s[0] + t[0], s[1] + t[1], s[2] + t[2], s[3] + t[3], s[4] + t[4], s[5] + t[5]


@inlined
def sym_sub(s, t):
    return s[0] - t[0], s[1] - t[1], s[2] - t[2], s[3] - t[3], s[4] - t[4], s[5] - t[5]


@inlined
def sym_scale(c, s):
    return c * s[0], c * s[1], c * s[2], c * s[3], c * s[4], c * s[5]


@inlined
def isotropic_plus(c, d, u):
    """c I + d u u^T."""
    x, y, z = u
    return c + d * x * x, d * x * y, d * x * z, c + d * y * y, d * y * z, c + d * z * z


@inlined
def sym_outer(u, v):
    """u v^T + v u^T."""
    return (
        2.0 * u[0] * v[0],
        u[0] * v[1] + u[1] * v[0],
        u[0] * v[2] + u[2] * v[0],
        2.0 * u[1] * v[1],
        u[1] * v[2] + u[2] * v[1],
        2.0 * u[2] * v[2],
    )


@inlined
def outer(u, v):
    """u v^T, a general 3x3 matrix."""
    return (
        u[0] * v[0], u[0] * v[1], u[0] * v[2],
        u[1] * v[0], u[1] * v[1], u[1] * v[2],
        u[2] * v[0], u[2] * v[1], u[2] * v[2],
    )  # fmt: skip


@inlined
def sym_inverse(s):
    a, b, c, d, e, f = s
    A, B, C = d * f - e * e, c * e - b * f, b * e - c * d
    g = 1.0 / (a * A + b * B + c * C)
    return A * g, B * g, C * g, (a * f - c * c) * g, (b * c - a * e) * g, (a * d - b * b) * g


@inlined
def sym_times(s, u):
    """S u."""
    a, b, c, d, e, f = s
    x, y, z = u
    return a * x + b * y + c * z, b * x + d * y + e * z, c * x + e * y + f * z


@inlined
def sym_to_general(s):
    a, b, c, d, e, f = s
    return a, b, c, b, d, e, c, e, f


# --- general 3x3 blocks ---------------------------------------------------------------------------------------------


@inlined
def mat_get(a, i):
    i = np.uintp(i)
    return a[i, 0], a[i, 1], a[i, 2], a[i, 3], a[i, 4], a[i, 5], a[i, 6], a[i, 7], a[i, 8]


@inlined
def mat_put(a, i, m):
    i = np.uintp(i)
    a[i, 0], a[i, 1], a[i, 2], a[i, 3], a[i, 4], a[i, 5], a[i, 6], a[i, 7], a[i, 8] = m


@inlined
def mat_accumulate(a, i, m):
    i = np.uintp(i)
    a[i, 0] += m[0]
    a[i, 1] += m[1]
    a[i, 2] += m[2]
    a[i, 3] += m[3]
    a[i, 4] += m[4]
    a[i, 5] += m[5]
    a[i, 6] += m[6]
    a[i, 7] += m[7]
    a[i, 8] += m[8]


@inlined
def mat_scale(c, m):
    return c * m[0], c * m[1], c * m[2], c * m[3], c * m[4], c * m[5], c * m[6], c * m[7], c * m[8]


@inlined
def mat_sub(m, n):
    return (
        m[0] - n[0], m[1] - n[1], m[2] - n[2],
        m[3] - n[3], m[4] - n[4], m[5] - n[5],
        m[6] - n[6], m[7] - n[7], m[8] - n[8],
    )  # fmt: skip


@inlined
def mat_times(m, u):
    """M u."""
    return (
        m[0] * u[0] + m[1] * u[1] + m[2] * u[2],
        m[3] * u[0] + m[4] * u[1] + m[5] * u[2],
        m[6] * u[0] + m[7] * u[1] + m[8] * u[2],
    )


@inlined
def mat_t_times(m, u):
    """M^T u."""
    return (
        m[0] * u[0] + m[3] * u[1] + m[6] * u[2],
        m[1] * u[0] + m[4] * u[1] + m[7] * u[2],
        m[2] * u[0] + m[5] * u[1] + m[8] * u[2],
    )


@inlined
def mat_sym(m, s):
    """M S with S symmetric."""
    x = sym_times(s, (m[0], m[1], m[2]))
    y = sym_times(s, (m[3], m[4], m[5]))
    z = sym_times(s, (m[6], m[7], m[8]))
    return x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]


@inlined
def mat_mat_t(m, n):
    """M N^T."""
    x = mat_times(n, (m[0], m[1], m[2]))
    y = mat_times(n, (m[3], m[4], m[5]))
    z = mat_times(n, (m[6], m[7], m[8]))
    return x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]


@inlined
def mat_mat_t_sym(m, n):
    """M N^T when the product is known to be symmetric."""
    return (
        m[0] * n[0] + m[1] * n[1] + m[2] * n[2],
        m[0] * n[3] + m[1] * n[4] + m[2] * n[5],
        m[0] * n[6] + m[1] * n[7] + m[2] * n[8],
        m[3] * n[3] + m[4] * n[4] + m[5] * n[5],
        m[3] * n[6] + m[4] * n[7] + m[5] * n[8],
        m[6] * n[6] + m[7] * n[7] + m[8] * n[8],
    )


@inlined
def mat_transpose(m):
    return m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]


@inlined
def mat_t_mat(m, n):
    """M^T N."""
    return mat_mat_t(mat_transpose(m), mat_transpose(n))


@inlined
def mat_mat(m, n):
    """M N."""
    return mat_mat_t(m, mat_transpose(n))


@inlined
def sym_sym(s, t):
    """S T of two symmetric blocks, a general one."""
    x = sym_times(t, (s[0], s[1], s[2]))
    y = sym_times(t, (s[1], s[3], s[4]))
    z = sym_times(t, (s[2], s[4], s[5]))
    return x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]


@inlined
def mat_sym_sym(m, s):
    """M S with S symmetric, when the product is known to be symmetric."""
    x = sym_times(s, (m[0], m[1], m[2]))
    y = sym_times(s, (m[3], m[4], m[5]))
    z = sym_times(s, (m[6], m[7], m[8]))
    return x[0], x[1], x[2], y[1], y[2], z[2]


@inlined
def sym_mat(s, m):
    """S M."""
    return mat_mat(sym_to_general(s), m)


@inlined
def mat_t_mat_sym(m, n):
    """M^T N when the product is known to be symmetric."""
    p = mat_t_mat(m, n)
    return p[0], p[1], p[2], p[4], p[5], p[8]
