"""The whole description of a mooring system, as a user gives it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from moorage.errors import Source
from moorage.model.components import (
    Body,
    Control,
    ExternalLoad,
    Failure,
    Line,
    LineType,
    Point,
    Rod,
    RodType,
)
from moorage.model.environment import Environment
from moorage.model.notebook import model_html
from moorage.model.turbines import Turbine


@dataclass(frozen=True, kw_only=True)
class UnusedOption:
    """An option of another program that was read and checked, and that means nothing here."""

    name: str
    value: str
    reason: str
    source: Source | None = field(default=None, compare=False)


@dataclass(frozen=True, kw_only=True)
class OutputChannel:
    """A channel asked for in a MoorDyn OUTPUTS section, in capital letters (FAIRTEN1, LINE2N5PX, ...)."""

    name: str
    source: Source | None = field(default=None, compare=False)


@dataclass(frozen=True, kw_only=True)
class Model:
    """Lines, points and what else a mooring has, with its environment; see `moorage.read`.

    Parameters
    ----------
    start : {"static", "as-given"}
        State at time 0: static equilibrium, or as described (lines on a first catenary, at rest).
    output_interval : float or None
        Time between results that the file asks for (MoorDyn's dtOut), s; None when it does not say.
    flavour : str
        "native", "MoorDyn-C", "MoorDyn-F", "MoorDyn v2" (either) or "MoorDyn v1": what the input was read as.
    turbines : tuple of Turbine
        The platforms of a farm, with their places; empty for a file of MoorDyn that was read by itself.
    in_place : bool
        Whether what is on turbines has global coordinates already (`moorage.model.turbines.placed`).
    text : str
        The input as read, kept for the record of a run.
    sources : tuple of (str, Source)
        Where the values are given that are not of a component: those of the environment, and `output_interval`.
    """

    environment: Environment
    line_types: tuple[LineType, ...] = ()
    lines: tuple[Line, ...] = ()
    points: tuple[Point, ...] = ()
    rod_types: tuple[RodType, ...] = ()
    rods: tuple[Rod, ...] = ()
    bodies: tuple[Body, ...] = ()
    turbines: tuple[Turbine, ...] = ()
    failures: tuple[Failure, ...] = ()
    controls: tuple[Control, ...] = ()
    external_loads: tuple[ExternalLoad, ...] = ()
    outputs: tuple[OutputChannel, ...] = ()
    start: Literal["static", "as-given"] = "static"
    output_interval: float | None = None
    title: str = ""
    flavour: str = "native"
    in_place: bool = field(default=False, repr=False)
    file: str = field(default="", compare=False)
    text: str = field(default="", compare=False, repr=False)
    unused_options: tuple[UnusedOption, ...] = field(default=(), compare=False)
    sources: tuple[tuple[str, Source], ...] = field(default=(), compare=False, repr=False)

    def source_of(self, name: str) -> Source | None:
        """Return where a value of the environment, or `output_interval`, is given; the file where no line is known."""
        return dict(self.sources).get(name, Source(self.file) if self.file else None)

    def line_type(self, name: str) -> LineType:
        """Return the line type of that name (case-insensitive)."""
        return next(t for t in self.line_types if t.name.lower() == name.lower())

    def point(self, id: int) -> Point:
        """Return the point with that id."""
        return next(p for p in self.points if p.id == id)

    def line(self, id: int) -> Line:
        """Return the line with that id."""
        return next(line for line in self.lines if line.id == id)

    @property
    def coupled_points(self) -> tuple[Point, ...]:
        """Points that prescribed motion moves, in the order of the file."""
        return tuple(p for p in self.points if p.kind == "coupled" and p.body is None)

    def _repr_html_(self) -> str:
        return model_html(self)
