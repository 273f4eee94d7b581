"""Names of rows for people: which line and node, or which point."""

from __future__ import annotations

import numpy as np

from moorage.system.build import Built


def place_name(built: Built, row: int) -> str:
    """Return "node 3 of 50 of line 2" or "point 4" for a row of the state arrays."""
    names = built.names
    if row < 0:
        return "an unknown place"
    if row >= names.node_ptr[-1]:
        number = row - names.node_ptr[-1]
        return f"point {names.points[number]}" if number < len(names.points) else "a free rod or a released line end"
    line = int(np.searchsorted(names.node_ptr, row, side="right")) - 1
    node = row - names.node_ptr[line]
    return f"node {node} of {names.node_ptr[line + 1] - names.node_ptr[line] - 1} of line {names.lines[line]}"
