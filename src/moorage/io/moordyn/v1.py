"""What tells a MoorDyn v1 file from a v2 file.

v1's line types have no bending stiffness and give added mass before drag, its lines give length and segments before
their ends, its points have constant forces. Since columns are found by their names, conversion needs no more than that.
"""

from __future__ import annotations

from moorage.io.moordyn.sections import Table


def is_v1(tables: dict[str, Table]) -> bool:
    """Return whether the sections are those of a v1 file."""
    types, lines = tables.get("line types"), tables.get("lines")
    if types is None or lines is None or types.header is None or lines.header is None:
        return False
    line_names = [name.lower() for name in lines.header.words]
    return "ei" not in map(str.lower, types.header.words) and line_names[2:3] == ["unstrlen"]
