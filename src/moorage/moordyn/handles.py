"""What the functions of the API take: a system, or one of its objects by its place in the file."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from operator import index
from typing import NamedTuple, TypeVar

import numpy as np

from moorage.errors import MoorageError
from moorage.moordyn.system import System

Vector = tuple[float, float, float]
F = TypeVar("F", bound=Callable)


class Line(NamedTuple):
    """A line of a system."""

    system: System
    place: int


class Point(NamedTuple):
    """A point of a system."""

    system: System
    place: int


class Rod(NamedTuple):
    """A rod of a system."""

    system: System
    place: int


class Body(NamedTuple):
    """A body of a system."""

    system: System
    place: int


class Waves(NamedTuple):
    """The sea of a system."""

    system: System


class Seafloor(NamedTuple):
    """The seabed of a system that has a depth grid."""

    system: System


def raising(function: F) -> F:
    """Turn errors of the mooring into RuntimeError, which is what MoorDyn's module raises."""

    @functools.wraps(function)
    def guarded(*args, **keywords):
        try:
            return function(*args, **keywords)
        except (MoorageError, OSError) as error:
            raise RuntimeError(str(error)) from error

    return guarded  # type: ignore[return-value]


def live(system: System) -> System:
    """Return the system, if it is one and has not been closed."""
    if not isinstance(system, System):
        raise TypeError(f"a system from Create() is wanted, not {type(system).__name__}")
    if system.closed:
        raise RuntimeError("this system has been closed")
    return system


def of(kind: type[Line | Point | Rod | Body], handle: object) -> System:
    """Return the system of a handle, if that is of a kind."""
    if not isinstance(handle, kind):
        raise TypeError(f"a {kind.__name__.lower()} is wanted, not {type(handle).__name__}")
    return live(handle.system)


def pick(kind: type, system: System, number: int, things: Sequence):
    """Return the handle of an object, whose numbers start at 1."""
    if not 1 <= index(number) <= len(things):
        raise RuntimeError(f"there is no {kind.__name__.lower()} {number}: there are {len(things)}")
    return kind(live(system), number - 1)


def dof_vector(which: str, values, size: int) -> np.ndarray:
    """Return coupled degrees of freedom as an array (size,); which: "1st" or "2nd", as in MoorDyn's message."""
    array = np.array(list(values), dtype=float)
    if array.shape != (size,):
        raise ValueError(f"{which} argument must have {size} components")
    return array


def node_index(i: int, count: int, what: str) -> int:
    """Return the index of a node, counted from end A."""
    if not 0 <= i < count:
        raise RuntimeError(f"{what} has nodes 0 to {count - 1}, not {i}")
    return i


def to_tuple(values: np.ndarray) -> tuple:
    """Return an array as nested tuples of floats."""
    return tuple(float(v) if np.ndim(v) == 0 else to_tuple(v) for v in values)
