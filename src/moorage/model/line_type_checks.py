"""What line types must fulfil: signs, and tables that have a slope everywhere."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from moorage.errors import Problem
from moorage.model.components import Curve, LineType
from moorage.model.model import Model
from moorage.model.signs import wrong_signs


def line_types_are_possible(model: Model) -> Iterator[Problem]:
    """Diameter and EA are positive, all else is not negative."""
    weak = (
        "mass_per_length axial_damping bending_stiffness bending_damping transverse_drag tangential_drag "
        "transverse_added_mass tangential_added_mass lift_coefficient viv_range viv_centre viscoelastic "
        "dynamic_damping axial_damping_ratio minimum_bend_radius minimum_breaking_load"
    )
    for line_type in model.line_types:
        name = f"line type {line_type.name}"
        strong = "diameter" if line_type.syrope else "diameter axial_stiffness"
        yield from wrong_signs(line_type, name, line_type.source, strong, weak)
        yield from _curves(line_type)
        if line_type.axial_damping_ratio is not None and line_type.axial_damping:
            remedy = "remove one of them: the ratio would count"
            yield Problem(f"{name} has an axial damping and its ratio", remedy, line_type.source)


def _curves(line_type: LineType) -> Iterator[Problem]:
    for field in ("axial_stiffness", "axial_damping", "bending_stiffness"):
        curve = getattr(line_type, field)
        if not isinstance(curve, Curve):
            continue
        what = f"table {curve.file or ''} of {field.replace('_', ' ')} of line type {line_type.name}".replace("  ", " ")
        if len(curve.x) < 2 or len(curve.x) != len(curve.y):
            yield Problem(f"{what} has {len(curve.x)} and {len(curve.y)} values", "give two or more", line_type.source)
        for k, (a, b) in enumerate(pairwise(curve.x)):
            if b <= a:
                remedy = f"the value after {a:g} must be larger"
                yield Problem(f"{what} does not increase at row {k + 2}", remedy, line_type.source, b)
        if field == "axial_stiffness" and any(b < a for a, b in pairwise(curve.y)):
            yield Problem(f"{what} has falling tension", "give tensions that do not fall", line_type.source)
        if field == "bending_stiffness" and not _is_zero_at_zero(curve):
            remedy = "add the row 0 0: a straight line has no moment"
            yield Problem(f"{what} does not start at 0, 0", remedy, line_type.source, (curve.x[:1], curve.y[:1]))
        if field == "bending_stiffness" and any(b <= a for a, b in pairwise(curve.y)):
            yield Problem(f"{what} has moments that do not increase", "give larger and larger ones", line_type.source)


def _is_zero_at_zero(curve: Curve) -> bool:
    """Return whether a curve starts at 0, 0, or goes through it; other checks tell rows that are none."""
    rows = list(zip(curve.x, curve.y, strict=False))
    return (0.0, 0.0) in rows and all(x >= 0.0 or y < 0.0 for x, y in rows)
