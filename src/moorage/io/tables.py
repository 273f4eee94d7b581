"""Tables that a model names: strain-tension and such curves, current profiles."""

from __future__ import annotations

from pathlib import Path

from moorage.errors import ModelError, Source
from moorage.io.text import Findings, is_number, read_text, rows
from moorage.model import Curve


def read_curve(folder: Path, name: str, what: str, found: Findings, source: Source) -> Curve:
    """Return the two columns of a table file, found relative to the model's folder.

    Three header rows and then x and y, as MoorDyn; rows before the first pair of numbers count as header.
    """
    nothing = Curve((), (), name)
    path = folder / name
    try:
        text = read_text(path, f"table of {what}", source=source)
    except ModelError as error:
        found.extend(error.problems)
        return nothing
    pairs: list[tuple[float, float]] = []
    for row in rows(text, str(path)):
        words = [word for word in " ".join(row.words).replace(",", " ").split()]
        if len(words) >= 2 and is_number(words[0]) and is_number(words[1]) and len(words) == 2:
            pairs.append((found.number(words[0], "x", row.source), found.number(words[1], "y", row.source)))
        elif words and pairs:
            found.add(f"row of the table of {what} is not two numbers", "write x and y", row.source, row.text.strip())
            return nothing
    if len(pairs) < 2:
        found.add(f"table of {what} has {len(pairs)} rows", "give at least two rows of x and y", Source(str(path)))
        return nothing
    return Curve(tuple(x for x, _ in pairs), tuple(y for _, y in pairs), name)
