"""Numbers in what describes a model, and their signs."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from numbers import Real

from moorage.errors import Problem, Source
from moorage.model.components import Curve
from moorage.model.current_grid import CurrentGrid
from moorage.model.environment import Bathymetry, FrictionMap, StiffnessMap

OWN_CHECK = Source | Bathymetry | CurrentGrid | FrictionMap | StiffnessMap  # grids are looked through elsewhere


def floats_of(thing: object, field: str = "") -> Iterator[tuple[str, float]]:
    """Yield every number in a value, with the field that it stands in."""
    if isinstance(thing, Real):
        yield field, float(thing)
    elif isinstance(thing, list | tuple) or type(thing).__name__ == "ndarray":
        for item in thing:  # type: ignore[attr-defined]
            yield from floats_of(item, field)
    elif dataclasses.is_dataclass(thing) and not isinstance(thing, OWN_CHECK):
        for part in dataclasses.fields(thing):
            yield from floats_of(getattr(thing, part.name), part.name)


def wrong_signs(thing: object, name: str, source: Source | None, positive: str, not_negative: str) -> Iterator[Problem]:
    """Yield the fields (listed with blanks between) that are not positive, or negative; nan is another check's."""
    for fields, fails, word in (
        (positive, lambda v: v <= 0.0, "must be positive"),
        (not_negative, lambda v: v < 0.0, "must not be negative"),
    ):
        for field in fields.split():
            value = getattr(thing, field)
            values = [value] if isinstance(value, Curve) else [v for _, v in floats_of(value)]
            if any(isinstance(v, Real) and fails(v) for v in values):
                yield Problem(f"{field.replace('_', ' ')} of {name} {word}", "correct the value", source, value)
