"""What a study is made of: parts with figures, tables and numbers, put into a page of documentation.

The text of a page is written by hand in `page.md` beside the study; `$name` stands there for a table or a number.
"""

from __future__ import annotations

import argparse
import json
import string
import tempfile
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.report import conditions
from matplotlib.figure import Figure

ROOT = Path(__file__).resolve().parents[1]
LARGEST, DOTS = 200_000, (150, 120, 100)  # bytes of a picture, and dots an inch: fewer where that would be more


class Part(NamedTuple):
    """A part of a study.

    Attributes
    ----------
    numbers : dict
        What tests compare with, as JSON.
    words : dict
        Tables and numbers of the page, by the name that stands for them.
    figures : dict
        Figures by the name of their file.
    """

    numbers: dict[str, Any]
    words: dict[str, str]
    figures: dict[str, Figure]


class Effort(NamedTuple):
    """How much is done: all of it, or what shows in seconds that everything works."""

    quick: bool
    peers: bool


def table(header: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Return a table in Markdown."""
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def arguments(study: str) -> tuple[Effort, Path]:
    """Return how much is asked for and the folder to write to."""
    parser = argparse.ArgumentParser(prog=f"python -m studies.{study}")
    parser.add_argument("--quick", action="store_true", help="short runs without other programs, into a new folder")
    parser.add_argument("--no-peers", action="store_true", help="leave out other programs")
    parser.add_argument("--out", type=Path, help="folder of the page, its numbers and images/ (docs/studies)")
    chosen = parser.parse_args()
    folder = chosen.out or (Path(tempfile.mkdtemp(prefix=study)) if chosen.quick else ROOT / "docs" / "studies")
    return Effort(chosen.quick, not (chosen.quick or chosen.no_peers)), folder


def write(study: str, parts: Iterable[Part], folder: Path) -> None:
    """Write page, numbers and pictures of a study."""
    parts, name = list(parts), study.replace("_", "-")
    (folder / "images").mkdir(parents=True, exist_ok=True)
    words = {"conditions": ", ".join(f"{k} {v}" for k, v in conditions().items())}
    numbers: dict[str, Any] = {}
    for part in parts:
        words |= part.words
        numbers |= part.numbers
        for title, figure in part.figures.items():
            _save(figure, folder / "images" / f"{name}-{title}.png")
    page = string.Template((ROOT / "studies" / study / "page.md").read_text("utf-8")).substitute(words)
    (folder / f"{name}.md").write_text(page, "utf-8")
    (folder / f"{name}.json").write_text(json.dumps(numbers, indent=1) + "\n", "utf-8")
    print(f"wrote {folder / name}.md")


def _save(figure: Figure, path: Path) -> None:
    for dots in DOTS:
        figure.savefig(path, dpi=dots, pil_kwargs={"optimize": True})
        if path.stat().st_size <= LARGEST:
            return
    raise ValueError(f"{path.name} has more than {LARGEST} bytes: draw less, or smaller")
