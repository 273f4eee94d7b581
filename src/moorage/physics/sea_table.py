"""What the water does along the path of a node, between two times at which the sum over the components is made.

The path is straight, from where the node was expected at the first time to where it is expected at the second. Along
it elevation, velocity and acceleration are cubic in time, from values and derivatives along the path at both ends,

    D f / D t = f_t + V . grad f + z'_t f_z',    z'_t = z'_z V_z + z'_eta (eta_t + V . grad eta)

and off it they change with their gradients, which are linear in time. Errors go with the fourth power of the interval,
((w + k V) D)^4 / 384 of each component, and with the square of k times the distance from the path.
"""

from __future__ import annotations

from moorage._jit import inlined
from moorage._vec3 import get, put, scale, sub
from moorage.physics.sea import ETA, ETA_T, ETA_X, ETA_Y, GRAD_A, GRAD_U, WATER, A, J, U, stretched

FIELDS = WATER
TERMS = 10  # cubic in time (4), and for x, y and z a gradient and its change


@inlined
def set_row(p, row, before, after, start, end, grown0, grown1, interval):
    """Fill the coefficients (FIELDS, TERMS) of a node from two records; grown: share of the sea and its rate (1/s).

    start, end: of the path, m. Records are without the ramp, which only moves the level here.
    """
    velocity = scale(1.0 / interval, sub(end, start))
    for side in range(2):
        record, r = (before, start) if side == 0 else (after, end)
        share, rate = grown0 if side == 0 else grown1
        _, to_z, to_eta = stretched(p, r[2], share * record[ETA])
        along = record[ETA_T] + velocity[0] * record[ETA_X] + velocity[1] * record[ETA_Y]
        lift = to_z * velocity[2] + to_eta * (share * along + rate * record[ETA])
        tilt_x, tilt_y = to_eta * share * record[ETA_X], to_eta * share * record[ETA_Y]
        row[0, side] = record[ETA]
        row[0, 2 + side] = along
        row[0, 4 + side], row[0, 6 + side], row[0, 8 + side] = record[ETA_X], record[ETA_Y], 0.0
        for kind in range(2):
            value, change = (U, A) if kind == 0 else (A, J)
            g = GRAD_U if kind == 0 else GRAD_A
            xx, xy, yy, xz, yz = record[g], record[g + 1], record[g + 2], record[g + 3], record[g + 4]
            for c in range(3):
                # gradient of component c at constant level; free of rotation and of sources
                fx = xx if c == 0 else (xy if c == 1 else xz)
                fy = xy if c == 0 else (yy if c == 1 else yz)
                fz = xz if c == 0 else (yz if c == 1 else -(xx + yy))
                m = 1 + 3 * kind + c
                row[m, side] = record[value + c]
                row[m, 2 + side] = record[change + c] + velocity[0] * fx + velocity[1] * fy + lift * fz
                row[m, 4 + side] = fx + tilt_x * fz
                row[m, 6 + side] = fy + tilt_y * fz
                row[m, 8 + side] = to_z * fz
    for m in range(FIELDS):
        a, b, d, e = row[m, 0], row[m, 1], interval * row[m, 2], interval * row[m, 3]
        row[m, 1], row[m, 2], row[m, 3] = d, 3.0 * (b - a) - 2.0 * d - e, 2.0 * (a - b) + d + e
        row[m, 5] -= row[m, 4]
        row[m, 7] -= row[m, 6]
        row[m, 9] -= row[m, 8]


@inlined
def look_up(row, s, dx, dy, dz, m):
    """Field m at the fraction s of the interval, (dx, dy, dz) off the path."""
    value = row[m, 0] + s * (row[m, 1] + s * (row[m, 2] + s * row[m, 3]))
    value += (row[m, 4] + s * row[m, 5]) * dx + (row[m, 6] + s * row[m, 7]) * dy
    return value + (row[m, 8] + s * row[m, 9]) * dz


@inlined
def step_path(start, end, i, position, velocity, left):
    """Move the path of node i on: it starts where it ended, and ends where the node will be after `left` seconds."""
    put(start, i, get(end, i))
    r, v = get(position, i), get(velocity, i)
    put(end, i, (r[0] + left * v[0], r[1] + left * v[1], r[2] + left * v[2]))
