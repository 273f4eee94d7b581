"""Names of rows for people: which line and node, or which point."""

from __future__ import annotations

import numpy as np

from moorage.system.build import Built


def place_name(built: Built, row: int) -> str:
    """Return "node 3 of 50 of line 2" or "point 4" for a row of the state arrays."""
    names = built.names
    if row < 0:
        return "an unknown place"
    ptr = built.system.lines.node_ptr
    number = row - int(ptr[-1]) - len(built.system.points.mass)
    if number >= 0:
        kind, id = names.objects[number // 2]
        return f"{kind} {id}"
    if row >= ptr[-1]:
        number = row - int(ptr[-1])
        return f"point {names.points[number]}" if number < len(names.points) else "a free rod or a released line end"
    line = int(np.searchsorted(ptr, row, side="right")) - 1
    node, last, lines = row - ptr[line], ptr[line + 1] - ptr[line] - 1, len(names.lines)
    what = f"line {names.lines[line]}" if line < lines else f"rod {names.rods[line - lines]}"
    return f"node {node} of {last} of {what}"
