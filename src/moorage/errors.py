"""What can go wrong: one exception tree, and the status codes that kernels return instead of raising."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Source:
    """Where something was described: a file and a line of it (1-based; 0 when the whole file is meant)."""

    file: str
    line: int = 0

    def __str__(self) -> str:
        return f"{self.file}:{self.line}" if self.line else self.file


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong: where, what was read, and what to write instead."""

    message: str
    remedy: str
    source: Source | None = None
    value: object = field(default=None, compare=False)

    def __str__(self) -> str:
        where = f"{self.source}: " if self.source else ""
        read = f" (read: {self.value!r})" if self.value is not None else ""
        return f"{where}{self.message}{read}\n    -> {self.remedy}"


class MoorageError(Exception):
    """Every error that Moorage raises on purpose."""


class InputError(MoorageError):
    """Input that cannot be used; carries every problem that was found, each with file, line and remedy."""

    def __init__(self, problems: Problem | Iterable[Problem]):
        self.problems: tuple[Problem, ...] = (problems,) if isinstance(problems, Problem) else tuple(problems)
        super().__init__("\n".join(map(str, self.problems)))


class ModelError(InputError):
    """A model that is wrong or incomplete."""


class UnsupportedError(InputError):
    """A feature that was understood but that this version does not simulate."""


class MotionError(InputError):
    """Prescribed motion that cannot be used."""


class ResultError(InputError):
    """A result file that cannot be read, written or resumed."""


class ConvergenceError(MoorageError):
    """Statics that found no equilibrium.

    Attributes
    ----------
    residual : float
        Largest out-of-balance force, N.
    """

    def __init__(self, message: str, residual: float = float("nan")):
        self.residual = residual
        super().__init__(message)


class SimulationError(MoorageError):
    """A run that could not go on at `time` (s).

    Attributes
    ----------
    dataset : callable or None
        Gives the records before the failure.
    """

    def __init__(self, message: str, time: float = float("nan")):
        self.time = time
        self.dataset: Callable[[], Any] | None = None
        super().__init__(message)


class RunInterrupted(KeyboardInterrupt):
    """A run that was stopped with Ctrl-C between two blocks, at `time` (s).

    Attributes
    ----------
    dataset : callable or None
        Gives the records up to then.
    """

    def __init__(self, message: str, time: float):
        self.time = time
        self.dataset: Callable[[], Any] | None = None
        super().__init__(message)


class ModelWarning(UserWarning):
    """Suspicious but runnable input; reported once."""
