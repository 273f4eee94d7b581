"""The pages build without a warning, and tell of everything that can be imported."""

import subprocess
import sys
from html import unescape
from pathlib import Path

import pytest

import moorage

ROOT = Path(__file__).parents[2]
NO_DOCSTRING = {"io", "plot", "results"}  # modules, whose functions have theirs


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    pytest.importorskip("sphinx", reason="Sphinx is not installed: pip install '.[docs]' builds the pages")
    pytest.importorskip("myst_parser", reason="MyST is not installed: pip install '.[docs]' builds the pages")
    pytest.importorskip("furo", reason="Furo is not installed: pip install '.[docs]' builds the pages")
    target = tmp_path_factory.mktemp("site")
    return target, build(ROOT / "docs", target)


def build(source, target):
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", source, target]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True)


def test_pages_build_without_a_warning(site):
    _, done = site
    assert done.returncode == 0, done.stderr
    assert not done.stderr


def test_every_page_is_in_the_contents(site):
    target, _ = site
    index = (target / "index.html").read_text("utf-8")
    for page in sorted((ROOT / "docs").rglob("*.md")):
        if page.name != "index.md":
            name = page.relative_to(ROOT / "docs").with_suffix(".html").as_posix()
            assert (target / name).is_file()
            assert f'href="{name}"' in index, f"docs/index.md does not list {page.name}"


def test_the_reference_names_everything_that_can_be_imported(site):
    target, _ = site
    page = unescape((target / "api.html").read_text("utf-8"))
    anchors = {name for name in moorage.__all__ if f'id="moorage.{name}"' in page}
    anchors |= {name for name in moorage.__all__ if f'id="moorage.errors.{name}"' in page}
    anchors |= {name for name in moorage.__all__ if f'id="moorage.model.{name}"' in page}
    assert set(moorage.__all__) - NO_DOCSTRING - anchors == set()


def test_nothing_is_fetched_to_lay_out_a_page(site):
    target, _ = site
    page = (target / "tutorial.html").read_text("utf-8")
    for tag in page.split("<")[1:]:
        name = tag.split(maxsplit=1)[0]
        if name in ("link", "script", "img"):
            assert "//" not in tag.split(">")[0], tag


def test_a_link_that_leads_nowhere_is_noticed(site, tmp_path):
    docs = tmp_path / "docs"
    docs.mkdir()
    (docs / "conf.py").write_text((ROOT / "docs" / "conf.py").read_text("utf-8").replace("DOCS.parent", repr_of(ROOT)))
    (docs / "index.md").write_text("# A page\n\nSee [another](nowhere.md).\n")
    done = build(docs, tmp_path / "out")
    assert done.returncode != 0
    assert "nowhere.md" in done.stderr


def repr_of(path):
    return f"Path({str(path)!r})"
