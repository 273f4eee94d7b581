"""The last step of reading a model: points on the seabed, then the checks, and one error with all that is wrong."""

from __future__ import annotations

from moorage.io.current import warn_of_deep_levels
from moorage.io.text import Findings
from moorage.model import Model
from moorage.model.bed_checks import depths_are_positive
from moorage.model.checks import check, problems_of
from moorage.model.seabed import place_on_seabed
from moorage.model.seabed import raise_to_seabed as raised


def checked(model: Model, found: Findings, raise_to_seabed: bool = False) -> Model:
    """Return a model as read, or raise a `ModelError` with the problems of its text and of the model.

    A place whose text was wrong is not blamed again, and nothing is checked when parts of the model are missing.
    """
    if not found.problems and not any(depths_are_positive(model)):
        model = place_on_seabed(model)
        model = raised(model) if raise_to_seabed else model
    if found.problems:
        blamed = {problem.source for problem in found.problems}
        later = () if found.lost_rows else problems_of(model)
        # a value that could not be read is nan in the model, which has been said
        found.extend(p for p in later if p.source not in blamed and p.value == p.value)
        found.problems.sort(key=lambda p: (p.source.file, p.source.line) if p.source else ("", 0))
        found.raise_any()
    check(model)
    warn_of_deep_levels(model.environment)
    return model
