"""Whether the values of a model are of the types that its dataclasses say: what is built in Python may hold anything.

Lists and arrays pass for tuples, NumPy's numbers for Python's. The other checks rely on this one.
"""

from __future__ import annotations

import dataclasses
import types
from collections.abc import Iterator, Sequence
from functools import lru_cache
from numbers import Integral, Real
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

from moorage.errors import Problem, Source
from moorage.model.model import Model

WORDS = {float: "number", int: "whole number", str: "text", bool: "True or False"}


def values_have_types(model: Model) -> Iterator[Problem]:
    """Values are numbers, texts or objects where these are wanted, and vectors have as many as they should."""
    yield from _of_object(model, "the model", Source(str(model.file)) if model.file else None)


@lru_cache(maxsize=64)
def _hints(kind: type) -> tuple[tuple[str, Any], ...]:
    hints = get_type_hints(kind)
    return tuple((field.name, hints[field.name]) for field in dataclasses.fields(kind) if field.name != "source")


def _of_object(thing: Any, name: str, place: Source | None) -> Iterator[Problem]:
    """Yield what is wrong with the fields of a dataclass."""
    source = getattr(thing, "source", None) or place
    for field, hint in _hints(type(thing)):  # type: ignore[arg-type]
        value = getattr(thing, field)
        if _fits(value, hint):
            for part in _parts(value):
                yield from _of_object(part, _name(part, name), source)
            continue
        what, count = f"{field.replace('_', ' ')} of {name}", _count(hint)
        if count and _fits(value, tuple[get_args(hint)[0], ...]):  # type: ignore[misc]
            yield Problem(f"{what} has {len(value)} values", f"give {count}", source, value)
        else:
            yield Problem(f"{what} is not {_wanted(hint)}", "correct it", source, value)


def _count(hint: Any) -> int:
    """Return how many values a vector has; 0 for what is none, or for any number of them."""
    inner = get_args(hint) if get_origin(hint) is tuple else ()
    return 0 if Ellipsis in inner else len(inner)


def _parts(value: Any) -> Iterator[Any]:
    """Yield the dataclasses in a value that fits."""
    if dataclasses.is_dataclass(value):
        yield value
    elif isinstance(value, list | tuple) and value and dataclasses.is_dataclass(value[0]):
        yield from value


def _name(thing: Any, owner: str) -> str:
    """Return what a part goes by in messages, as "line 1" or "section of line 1"."""
    word = "".join(f" {c.lower()}" if c.isupper() else c for c in type(thing).__name__).strip()
    for key in ("id", "channel", "name"):
        if hasattr(thing, key):
            return f"{word} {getattr(thing, key)}"
    return f"the {word}" if owner == "the model" else f"{word} of {owner.removeprefix('the ')}"


def _fits(value: Any, hint: Any) -> bool:
    """Return whether a value is of a type, its items included (of dataclasses only the class)."""
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, types.UnionType):
        return any(_fits(value, option) for option in inner)
    if origin is Literal:
        return isinstance(value, str | int) and value in inner
    if origin is tuple:
        return _fits_tuple(value, inner)
    if hint is type(None):
        return value is None
    if hint in (float, int):
        wanted = Real if hint is float else Integral
        return type(value) is hint or (isinstance(value, wanted) and not isinstance(value, bool))
    if hint is bool:
        return isinstance(value, bool) or type(value).__name__ == "bool"  # NumPy's
    return not isinstance(hint, type) or isinstance(value, hint)


def _fits_tuple(value: Any, inner: tuple[Any, ...]) -> bool:
    array = type(value).__name__ == "ndarray"
    if not (array or isinstance(value, Sequence)) or isinstance(value, str | bytes):
        return False
    if array and value.ndim == 0:
        return False
    if len(inner) == 2 and inner[1] is Ellipsis:
        return all(_fits(item, inner[0]) for item in value)
    return len(value) == len(inner) and all(map(_fits, value, inner))


def _wanted(hint: Any) -> str:
    """Return in words what a type takes."""
    origin, inner = get_origin(hint), get_args(hint)
    if origin in (Union, types.UnionType):
        return " or ".join(_wanted(option) for option in inner if option is not type(None))
    if origin is Literal:
        return f"one of {', '.join(map(str, inner))}"
    if origin is tuple:
        return (
            f"{_count(hint)} of them, each {_wanted(inner[0])}" if _count(hint) else f"a list, each {_wanted(inner[0])}"
        )
    word = WORDS.get(hint, getattr(hint, "__name__", str(hint)))
    return f"an {word}" if word[0] in "AEIO" else f"a {word}"
