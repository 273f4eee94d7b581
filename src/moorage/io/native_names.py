"""What words of a native file call: points and turbines by number or name, ends of rods.

Names are labels too, so that two may be equal; only a word that could mean either is refused. A word that is a number
means the thing of that number, if there is one, as the writer has it.
"""

from __future__ import annotations

import re
import warnings
from collections.abc import Sequence

from moorage.errors import ModelWarning, Source
from moorage.io.text import Findings
from moorage.model import Attachment, Point, Turbine

Word = tuple[str, Source]


def turbine_called(called: Word, turbines: Sequence[Turbine], found: Findings) -> int:
    """Return the number of a turbine that is called by its number or name."""
    word, source = called
    id = _called(word, word, turbines, "turbine", found, source)
    if id is not None:
        return id
    if re.fullmatch(r"\d+", word):
        return int(word)  # it may be in another file
    known = ", ".join(turbine.name for turbine in turbines if turbine.name) or "no turbine has a name"
    found.add("turbine is not known", f"write its number, or a name ({known})", source, word)
    found.lost_rows = True
    return 0


def end_called(called: Word, points: Sequence[Point], found: Findings) -> Attachment:
    """Return what an end is tied to: a point's number or name, or `rod 1 A`."""
    word, source = called
    rod = re.fullmatch(r"(?i)rod\s*(\d+)\s*([AB])", word)
    if rod:
        if any(point.name == word for point in points):
            _warn(f"{word} is taken for an end of rod {rod[1]}, not for the point of that name", source)
        return Attachment("rod", int(rod[1]), "A" if rod[2].upper() == "A" else "B")
    number = re.fullmatch(r"(?i)(?:point\s*)?(\d+)", word)
    id = _called(word, number[1] if number else "", points, "point", found, source)
    if id is not None:
        return Attachment("point", id)
    if number:
        return Attachment("point", int(number[1]))
    known = ", ".join(point.name for point in points if point.name) or "no point has a name"
    found.add("end is neither a point nor a rod's end", f"write 1, rod 1 A, or a name ({known})", source, word)
    found.lost_rows = True
    return Attachment("point", 0)


def _called(
    word: str, digits: str, things: Sequence[Point | Turbine], kind: str, found: Findings, source: Source
) -> int | None:
    """Return the number of the thing that a word (its number is in `digits`) calls; None when there is none."""
    named = [thing.id for thing in things if thing.name == word]
    number = int(digits) if re.fullmatch(r"\d+", digits) else None
    if number is not None and any(thing.id == number for thing in things):
        if set(named) - {number}:
            _warn(f"{word} is taken for the number of a {kind}, not for the name of {kind} {named[0]}", source)
        return number
    if len(named) > 1:
        several = " and ".join(map(str, named))
        found.add(f"{kind}s {several} have the same name", "write a number here, or rename one", source, word)
        found.lost_rows = True
    return named[0] if named else None


def _warn(what: str, source: Source) -> None:
    warnings.warn(f"{source}: {what}; rename it", ModelWarning, stacklevel=2)
