"""No force law without a verification: every file of `moorage.physics` is named by a file of tests/verification.

A verification says so on a line "Verifies: tension, weight" of its docstring, names the formula and its source above
or below that line, and holds a test of a wrong variant ("fail" in its name) beside those that must pass.
"""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

import moorage.physics

TERMS = {path.stem for path in Path(moorage.physics.__file__).parent.glob("*.py")} - {"__init__"}
FILES = sorted((Path(__file__).parents[1] / "verification").glob("test_*.py"))


def docstring(path: Path) -> str:
    return ast.get_docstring(ast.parse(path.read_text("utf-8"))) or ""


def verified(path: Path) -> set[str]:
    """What a file says that it verifies."""
    found = re.search(r"^Verifies: (.+)$", docstring(path), re.MULTILINE)
    return set(found[1].split(", ")) if found else set()


def test_every_term_is_verified():
    named = set().union(*(verified(path) for path in FILES))
    assert TERMS - named == set(), "laws without a verification"


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_verification_says_what_it_verifies_and_what_must_fail(path):
    assert verified(path), "no line 'Verifies: ...'"
    assert verified(path) <= TERMS, "there is no such law"
    tests = [node.name for node in ast.walk(ast.parse(path.read_text("utf-8"))) if isinstance(node, ast.FunctionDef)]
    assert any(re.match(r"test_.*(fail|notice|is_not)", name) for name in tests), "no wrong variant"
