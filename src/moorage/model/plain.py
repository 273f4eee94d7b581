"""Arrays given from Python become tuples of numbers, so that parts of a model can be compared."""

from __future__ import annotations

from typing import Any


def plain(values: Any) -> Any:
    """Return nested tuples of what arrays or lists hold; tuples of numbers, and of such, stay what they are."""
    if isinstance(values, tuple) and (not values or plain(values[0]) is values[0]):
        return values
    if hasattr(values, "tolist"):
        values = values.tolist()
    return tuple(plain(value) for value in values) if isinstance(values, list | tuple) else values


def keep_plain(part: object, *names: str) -> None:
    """Make these fields of a part of a model plain, while it is being made."""
    for name in names:
        object.__setattr__(part, name, plain(getattr(part, name)))
