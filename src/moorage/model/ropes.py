"""Checks of what Syrope ropes start from."""

from __future__ import annotations

from collections.abc import Iterator

from moorage.errors import Problem
from moorage.model.model import Model


def rope_tensions_are_possible(model: Model) -> Iterator[Problem]:
    """Highest and mean tension at the start belong to lines of a Syrope type, and the mean is not above the highest."""
    ropes = {line_type.name.lower() for line_type in model.line_types if line_type.syrope}
    for line in model.lines:
        tensions = line.syrope_tensions
        if tensions is None:
            continue
        what = f"Syrope tensions of line {line.id}"
        if not any(section.line_type.lower() in ropes for section in line.sections):
            remedy = "remove them, or name its file of working curves (syrope) in the line type"
            yield Problem(f"{what} are given, but its line type is not a Syrope one", remedy, line.source, tensions)
        if len(tensions) != 2:
            yield Problem(f"{what} are {len(tensions)} values", "give two", line.source, tensions)
        elif tensions[1] < 0.0 or tensions[0] < tensions[1]:
            remedy = "give the highest first, then the present mean, neither negative"
            yield Problem(f"{what} are not possible", remedy, line.source, tensions)
