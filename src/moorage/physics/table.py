"""Tables y(x) for kernels: piecewise linear, continued with the slope of their end intervals."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined


class Tables(NamedTuple):
    """All tables of a system, one after the other."""

    ptr: np.ndarray  # (tables + 1,)
    x: np.ndarray  # (rows,) increasing within a table
    y: np.ndarray  # (rows,)


def build_tables(curves) -> Tables:
    """Stack curves (with fields x and y) into one set of arrays."""
    ptr = np.concatenate([[0], np.cumsum([len(c.x) for c in curves])]).astype(np.int64)
    stack = [np.array(c.x, dtype=float) for c in curves], [np.array(c.y, dtype=float) for c in curves]
    x, y = (np.concatenate(s) if s else np.zeros(0) for s in stack)
    return Tables(ptr, x, y)


@inlined
def interval(x, begin, end, value):
    """Index k in begin..end-2 with x[k] <= value < x[k+1], or the nearest interval.

    A regular table is hit by the first guess, any other is searched by bisection.
    """
    low, high = begin, end - 1
    guess = low + int((value - x[low]) / (x[high] - x[low]) * (high - low))
    guess = min(max(guess, low), high - 1)
    if x[guess] <= value < x[guess + 1]:
        return guess
    return bisect(x, low, high, value)


@inlined
def bisect(x, low, high, value):
    """Index k in low..high-1 with x[k] <= value < x[k+1], or the nearest."""
    while high - low > 1:
        middle = (low + high) // 2
        if x[middle] <= value:
            low = middle
        else:
            high = middle
    return low


@inlined
def look_up(tables, table, value):
    """Value and slope of a table."""
    k = interval(tables.x, tables.ptr[table], tables.ptr[table + 1], value)
    slope = (tables.y[k + 1] - tables.y[k]) / (tables.x[k + 1] - tables.x[k])
    return tables.y[k] + slope * (value - tables.x[k]), slope
