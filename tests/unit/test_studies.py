"""The pages of the studies are those of their templates, with pictures that are there and not too large."""

import re
from pathlib import Path

import pytest
from studies.parts import LARGEST, ROOT, table

PAGES = {"bending_2020": 9, "seabed_2022": 6}  # and their pictures
DOCS = ROOT / "docs" / "studies"


def page_of(study: str) -> Path:
    return DOCS / f"{study.replace('_', '-')}.md"


@pytest.mark.parametrize("study", PAGES)
def test_page_is_the_template_filled(study):
    """Text that was changed in one of the two only does not match; `python -m studies.NAME` writes the page."""
    template = (ROOT / "studies" / study / "page.md").read_text("utf-8")
    parts = re.split(r"\$\w+", template)
    assert re.fullmatch("(?s:.+?)".join(map(re.escape, parts)), page_of(study).read_text("utf-8"))


@pytest.mark.parametrize("study", PAGES)
def test_pictures(study):
    named = re.findall(r"!\[[^]]+\]\(([^)]+)\)", page_of(study).read_text("utf-8"))
    assert len(named) == PAGES[study]
    assert all((DOCS / name).stat().st_size <= LARGEST for name in named)
    there = {f"images/{path.name}" for path in (DOCS / "images").glob(f"{study.replace('_', '-')}-*")}
    assert there == set(named)


def test_table():
    assert table(("a", "b"), [(1, "x")]) == "| a | b |\n| --- | --- |\n| 1 | x |"
