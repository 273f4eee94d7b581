"""docs/theory.md names files and functions that exist, and every law of `moorage.physics`."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGE = ROOT / "src" / "moorage"
PAGE = (ROOT / "docs" / "theory.md").read_text("utf-8")
NAMED = sorted(set(re.findall(r"`([\w/.]+/[\w.]+\.py|\w+\.py)`", PAGE)))
CODE = re.findall(r"`([\w/.]+\.py)`: ((?:`\w+`(?:,\s+)?)+)", PAGE)


def place(name: str) -> Path:
    return (ROOT if name.startswith("tests/") else PACKAGE) / name


def names_of(path: Path) -> set[str]:
    """Functions, classes and constants of a file."""
    found = set()
    for node in ast.parse(path.read_text("utf-8")).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found |= {target.id for target in targets if isinstance(target, ast.Name)}
    return found


@pytest.mark.parametrize("name", NAMED)
def test_named_file_exists(name):
    assert place(name).is_file()


def test_every_law_is_named():
    laws = {f"physics/{path.name}" for path in (PACKAGE / "physics").glob("*.py")} - {"physics/__init__.py"}
    assert laws <= set(NAMED), "laws that the page does not name"


def test_every_law_has_its_functions_named():
    laws = {name for name in NAMED if name.startswith("physics/")}
    assert laws <= {name for name, _ in CODE}


@pytest.mark.parametrize(("name", "functions"), CODE)
def test_named_functions_exist(name, functions):
    assert set(re.findall(r"\w+", functions)) <= names_of(place(name))


def test_every_section_with_an_equation_names_its_source():
    sections = re.split(r"\n(?=#{2,3} )", PAGE.split("## Differences from MoorDyn")[0])[1:]
    with_equations = [part for part in sections if re.search(r"\n\n    \S", part)]
    assert len(with_equations) > 12
    assert [part.split("\n")[0] for part in with_equations if not re.search(r"\bSources?: ", part)] == []


def test_years_in_the_text_are_in_the_list_of_sources():
    text, listed = PAGE.split("\n## Sources\n")
    for name, year in re.findall(r"([A-Z][a-z]+)(?:,? (?:&|and) [A-Z]\w+)? \(?((?:19|20)\d\d)\b", text):
        assert re.search(rf"{name},[^*]*{year}", listed), (name, year)


def test_a_wrong_name_would_be_noticed():
    assert "no_such_law" not in names_of(PACKAGE / "physics" / "tension.py")
    assert not place("physics/no_such_law.py").is_file()
