"""MoorDyn's words for how things are held, and for what a line end is tied to."""

from __future__ import annotations

import difflib
import re
import warnings
from dataclasses import dataclass
from typing import cast

from moorage.errors import ModelWarning, Source
from moorage.io.text import Findings
from moorage.model import Attachment
from moorage.model.components import ObjectKind

FIXED = ("ANCHOR", "FIXED", "FIX")
COUPLED = ("COUPLED", "VESSEL", "CPLD", "VES", "FAIRLEAD")
COUPLED_PINNED = ("VESSELPINNED", "VESPIN", "COUPLEDPINNED", "CPLDPIN")
PINNED = ("PINNED", "PIN")
FREE = {
    "point": ("FREE", "POINT", "P", "CONNECT", "CON"),
    "rod": ("FREE", "ROD", "R", "POINT", "CON", "CONNECT"),
    "body": ("FREE",),
}
WORDS = {
    "point": "Fixed, Coupled, Free, Body1 or Turbine1",
    "rod": "Fixed, Pinned, Coupled, CoupledPinned, Free, Body1, Body1Pinned or Turbine1",
    "body": "Fixed, Coupled, CoupledPinned, Free or Turbine1",
}
TURBINE = ("TURBINE", "T")
POINT_PREFIX = ("", "P", "POINT", "C", "CON")
ROD_PREFIX = ("R", "ROD")


@dataclass(frozen=True)
class Hold:
    """How an object is held: its kind, and the body or turbine that carries it."""

    kind: ObjectKind
    body: int | None = None
    turbine: int | None = None


def decompose(word: str) -> tuple[str, str, str]:
    """Cut a word such as Body1Pinned into capital letters, digits and the capital letters that follow."""
    match = re.fullmatch(r"([A-Z_]*)(\d*)(.*)", word.upper())
    return match.groups() if match else (word.upper(), "", "")  # type: ignore[return-value]


def read_hold(word: str, what: str, found: Findings, source: Source) -> Hold:
    """Return how a point, rod or body ("point", "rod", "body") is held; note a problem for an unknown word."""
    letters, digits, rest = decompose(word)
    kinds: dict[str, ObjectKind] = dict.fromkeys(FIXED, cast(ObjectKind, "fixed"))
    kinds |= dict.fromkeys(COUPLED, cast(ObjectKind, "coupled"))
    kinds |= dict.fromkeys(FREE[what], cast(ObjectKind, "free"))
    if what != "point":
        kinds |= dict.fromkeys(COUPLED_PINNED, cast(ObjectKind, "coupled-pinned"))
    if what == "rod":
        kinds |= dict.fromkeys(PINNED, cast(ObjectKind, "pinned"))
    if letters in kinds and not rest:
        if digits:
            warnings.warn(f"{source}: the number in {word} means nothing, as in MoorDyn", ModelWarning, stacklevel=2)
        return Hold(kinds[letters])
    if letters == "BODY" and digits and what != "body":
        if not rest:
            return Hold("fixed", body=int(digits))
        if rest in PINNED and what == "rod":
            return Hold("pinned", body=int(digits))
    if letters in TURBINE and digits and not rest:
        return Hold("coupled", turbine=int(digits))
    if letters == "BODY" and digits and what == "body":
        message = "bodies do not ride on bodies, not on others and not on themselves"
        found.add(message, f"tie them with lines, or write {WORDS[what]}", source, word)
        return Hold("fixed")
    nearest = difflib.get_close_matches(word.upper(), [*kinds, "TURBINE1", "BODY1", "BODY1PINNED"], n=1)
    hint = f"did you mean {nearest[0].capitalize()}? " if nearest else ""
    found.add(f"attachment of a {what} is not known", f"{hint}write {WORDS[what]}", source, word)
    return Hold("fixed")


def read_attachment(word: str, what: str, found: Findings, source: Source) -> Attachment:
    """Return what a line end is tied to: a point (3, P3, Con3) or a rod's end (R1A)."""
    letters, digits, rest = decompose(word)
    if digits and letters in POINT_PREFIX and not rest:
        return Attachment("point", int(digits))
    if digits and letters in ROD_PREFIX and rest in ("A", "B"):
        return Attachment("rod", int(digits), "A" if rest == "A" else "B")
    found.add(f"{what} is not known", "write a point's number (3) or a rod's end (R1A or R1B)", source, word)
    return Attachment("point", 0)


def read_ids(word: str, what: str, found: Findings, source: Source) -> tuple[int, ...]:
    """Return the numbers in a list such as 1,2,3."""
    return tuple(found.integer(part, what, source) for part in word.strip(",").split(","))
