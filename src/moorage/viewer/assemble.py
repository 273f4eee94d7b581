"""One HTML file from a scene: the page's sources, three.js and the numbers, with nothing to load from anywhere."""

from __future__ import annotations

import html
import json
import re
from functools import cache
from importlib.resources import files
from string import Template

from moorage.viewer.packing import pack
from moorage.viewer.scene import Scene

MODULES = (  # each needs only those before it
    "data", "colours", "numbers", "lines", "seabed", "sea", "markers",
    "stage", "scales", "legend", "plot", "panel", "pick", "picture", "words", "app", "controls", "main",
)  # fmt: skip


def page(scene: Scene) -> str:
    """Return a self-contained page."""
    parts = {
        "title": html.escape(scene.meta["title"]),
        "version": html.escape(scene.meta["version"]),
        "date": html.escape(scene.meta["date"]),
        "meta": _json_in_script(scene.meta),
        "data": pack(scene.arrays),
        "style": source("page/style.css"),
        "three": _in_script(source("vendor/three.min.js")),
        "program": program(),
    }
    return Template(source("page/page.html")).substitute(parts)


@cache
def program() -> str:
    """Return the modules of the page as one script, each in a scope of its own."""
    return "\n".join(_scoped(name, source(f"page/{name}.js")) for name in MODULES)


def _scoped(name: str, text: str) -> str:
    """Return a module as a function that is called: imports take from the modules before, exports are returned."""
    body = re.sub(r"^import (\{[^}]*\}) from \"\./(\w+)\.js\";$", r"const \1 = $\2;", text, flags=re.MULTILINE)
    given = re.findall(r"^export (?:async )?(?:const|function|class) (\w+)", body, flags=re.MULTILINE)
    body = re.sub(r"^export ", "", body, flags=re.MULTILINE)
    return f"// {name}.js\nconst ${name} = (() => {{\n{body}\nreturn {{ {', '.join(given)} }};\n}})();\n"


@cache
def source(name: str) -> str:
    """Return the text of a file of the viewer."""
    return files("moorage.viewer").joinpath(name).read_text("utf-8")


def _json_in_script(meta: dict) -> str:
    """Return JSON without a `<`: in a script element, names with `</script` or `<!--` would mean something."""
    return json.dumps(meta, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def _in_script(text: str) -> str:
    """Return text that does not end the script element that holds it."""
    return text.replace("</", "<\\/")
