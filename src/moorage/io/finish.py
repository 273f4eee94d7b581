"""The last step of reading a model: points on the seabed, then the checks, and one error with all that is wrong."""

from __future__ import annotations

from moorage.io.text import Findings
from moorage.model import Model
from moorage.model.checks import problems_of
from moorage.model.seabed import place_on_seabed
from moorage.model.seabed import raise_to_seabed as raised


def checked(model: Model, found: Findings, raise_to_seabed: bool = False) -> Model:
    """Return a model as read, or raise a `ModelError` with the problems of its text and of the model.

    A place whose text was wrong is not blamed again, and nothing is checked when parts of the model are missing.
    """
    if not found.problems:
        model = place_on_seabed(model)
        model = raised(model) if raise_to_seabed else model
    bad_places = {problem.source for problem in found.problems}
    if not found.lost_rows:
        found.extend(problem for problem in problems_of(model) if problem.source not in bad_places)
    found.raise_any()
    return model
