"""How Sphinx builds these pages: `sphinx-build -W -b html docs build/docs`. It needs no network.

The pages are written to be read on a code host as well. So `index.md` lists them in tables, from which the contents are
made here, and links lead to files of the project, which become links between pages here. Four pages are files from
outside of this folder.
"""

import os
import re
import sys
from pathlib import Path

DOCS = Path(__file__).parent.resolve()
ROOT = DOCS.parent
sys.path.insert(0, str(ROOT / "src"))

import moorage  # noqa: E402, RUF100  the package of this folder, not an installed one

project = "Moorage"
author = copyright = "The Moorage developers"
version = release = moorage.__version__

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon"]
exclude_patterns = ["images", "studies/*.json"]
myst_heading_anchors = 4
suppress_warnings = ["misc.highlighting_failure"]
default_role = "literal"  # docstrings put names in single backticks
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # the docstrings say types and units
napoleon_google_docstring = False
napoleon_use_rtype = False
autosummary_generate = False

html_theme = "furo"
html_title = f"Moorage {release}"
html_copy_source = False
html_show_sphinx = False

OUTSIDE = {  # pages, and the files that they are
    "changelog": ROOT / "CHANGELOG.md",
    "contributing": ROOT / "CONTRIBUTING.md",
    "examples": ROOT / "examples" / "README.md",
    "lazy-wave": ROOT / "examples" / "lazy_wave" / "README.md",
}
PAGES = {path: page for page, path in OUTSIDE.items()} | {ROOT / "README.md": "index"}
LINK = re.compile(r"\]\(([^)#:\s]+)(#[^)\s]*)?\)")
SECTION = re.compile(r"^\*\*(.+?)\*\*$(.*?)(?=^\*\*|\Z)", re.MULTILINE | re.DOTALL)


def settle(app, page, source):
    """Take the text of a page from where it is, and lead its links to pages, or to files as downloads."""
    home = OUTSIDE.get(page, DOCS / f"{page}.md")
    text = home.read_text("utf-8")
    here = (DOCS / page).parent

    def lead(match):
        target = (home.parent / match[1]).resolve()
        target = DOCS / f"{PAGES[target]}.md" if target in PAGES else target
        return f"]({os.path.relpath(target, here)}{match[2] or ''})".replace(os.sep, "/")

    text = LINK.sub(lead, text)
    source[0] = text + contents(text) if page == "index" else text


def contents(index):
    """Return the hidden contents of the pages in the tables of the index, a part for each table."""
    parts = []
    for caption, table in SECTION.findall(index):
        pages = [link.removesuffix(".md") for link, _ in LINK.findall(table) if link.endswith(".md")]
        listed = "\n".join(dict.fromkeys(pages))
        parts.append(f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n{listed}\n```\n")
    return "".join(parts)


def setup(app):
    """Join Sphinx."""
    app.connect("source-read", settle)
