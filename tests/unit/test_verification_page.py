"""The page of verifications is what its script makes, and the tests say what it needs."""

import runpy
from pathlib import Path

SCRIPT = Path(__file__).parents[2] / "docs" / "verification_page.py"


def test_the_page_is_what_the_tests_say():
    made = runpy.run_path(str(SCRIPT))
    assert made["PAGE"].read_text("utf-8") == made["page"](), "run python docs/verification_page.py"


def test_every_case_says_what_it_compares():
    made = runpy.run_path(str(SCRIPT))
    for name, text in made["cases"]():
        what, _, _ = made["parts"](text)
        assert what.endswith((".", ":")), name
        assert len(what) > 20, name


def test_marks_by_accident_are_escaped():
    escaped = runpy.run_path(str(SCRIPT))["escaped"]
    assert escaped("a_b * c [1] `d_e`") == "a\\_b \\* c \\[1\\] `d_e`"


def test_the_sentence_on_how_near_has_a_number():
    near = runpy.run_path(str(SCRIPT))["near"]
    rest = ["It falls. Errors must be below 1e-3 of it. More within 2 m.", "    x = within 3"]
    assert near(rest) == "Errors must be below 1e-3 of it."
    assert near(["Nothing is said of within what."]) == ""
