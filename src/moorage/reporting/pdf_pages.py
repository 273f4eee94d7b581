"""A report as a PDF: pages of text and tables, then a page for every figure."""

from __future__ import annotations

import textwrap
from pathlib import Path

import xarray as xr
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure

from moorage.plot.style import COLOURS
from moorage.reporting.content import Block, Doubts, Facts, Table, figures, sections

WIDTH, HEIGHT = 595.0, 842.0  # A4, points
MARGIN = 54.0
SIZE, LEADING = 8.5, 12.5  # of text, points
GLYPH = 0.6  # width of a letter as a part of its size
USABLE = WIDTH - 2.0 * MARGIN
QUIET = "#5A626A"
NAMES = 150.0  # width of the names of facts
GAP = 14.0  # between columns


def write_pdf(ds: xr.Dataset, path: Path) -> None:
    """Write the report of a run as PDF."""
    with PdfPages(path, metadata={"Title": str(ds.attrs["title"])}) as pdf:
        pages = Pages(pdf)
        pages.lines(str(ds.attrs["title"]), size=14.0, weight="bold")
        for title, blocks in sections(ds).items():
            pages.heading(title)
            for block in blocks:
                _write(pages, block)
        drawn = list(figures(ds))
        for caption, figure in drawn:
            if isinstance(figure, str):
                pages.lines(f"{caption}: not drawn, {figure}")
        pages.end()
        for caption, figure in drawn:
            if isinstance(figure, Figure):
                figure.suptitle(caption, x=0.01, ha="left", fontsize=10)
                pdf.savefig(figure)


class Pages:
    """Text that flows down one page after the other."""

    def __init__(self, pdf: PdfPages):
        self.pdf = pdf
        self.figure = Figure(figsize=(WIDTH / 72.0, HEIGHT / 72.0))
        self.y = HEIGHT - MARGIN

    def room(self, height: float) -> None:
        """Begin a new page when so many points do not fit on this one."""
        if self.y - height < MARGIN:
            self.end()
            self.figure = Figure(figsize=(WIDTH / 72.0, HEIGHT / 72.0))
            self.y = HEIGHT - MARGIN

    def end(self) -> None:
        """Write the page."""
        self.pdf.savefig(self.figure)

    def text(self, x: float, words: str, size: float = SIZE, align: str = "left", **style: str) -> None:
        """Write on the present line, x points from the left margin."""
        place = (MARGIN + x) / WIDTH, self.y / HEIGHT
        words = words.replace("$", r"\$")  # no formula
        self.figure.text(*place, words, fontsize=size, ha=align, va="top", **style)  # type: ignore[arg-type]

    def down(self, points: float = LEADING) -> None:
        """Go down."""
        self.y -= points

    def lines(self, words: str, x: float = 0.0, size: float = SIZE, **style: str) -> None:
        """Write a paragraph."""
        for line in wrapped(words, int((USABLE - x) / (GLYPH * size))):
            self.room(1.5 * size)
            self.text(x, line, size, **style)
            self.down(1.5 * size)

    def heading(self, title: str) -> None:
        """Begin a section, not at the end of a page."""
        self.room(6.0 * LEADING)
        self.down(0.8 * LEADING)
        self.lines(title, size=11.0, weight="bold")
        self.down(2.0)


def wrapped(words: str, letters: int) -> list[str]:
    """Return lines of so many letters at most; words that are longer are cut."""
    return [line for part in words.splitlines() for line in textwrap.wrap(part, letters) or [""]]


def _write(pages: Pages, block: Block) -> None:
    if isinstance(block, Doubts):
        for words in block.texts:
            pages.lines(words, x=8.0, color=COLOURS[1])
    elif isinstance(block, Facts):
        for name, words in block.rows.items():
            pages.room(LEADING)
            pages.text(0.0, name, color=QUIET)
            pages.lines(words, x=NAMES)
    else:
        _table(pages, block)


def _table(pages: Pages, table: Table) -> None:
    """Write a table, its head again on every page; one that is too wide is smaller."""
    heads = [textwrap.wrap(name, 14) or [""] for name in table.names]
    longest = [max(map(len, [*head, *(row[k] for row in table.rows)])) for k, head in enumerate(heads)]
    size = min(SIZE, (USABLE - GAP * (len(longest) - 1)) / (GLYPH * max(sum(longest), 1)))
    widths = [GLYPH * size * n for n in longest]
    ends = [sum(widths[: k + 1]) + GAP * k for k in range(len(widths))]
    tall = max(map(len, heads))
    pages.down(4.0)
    pages.room((tall + 3) * LEADING)
    pages.lines(table.caption, color=QUIET)

    def head() -> None:
        for k in range(tall):
            _row(pages, [h[k - tall + len(h)] if k >= tall - len(h) else "" for h in heads], ends, size, weight="bold")

    head()
    for row in table.rows:
        if pages.y - LEADING < MARGIN:
            pages.room(LEADING)
            head()
        _row(pages, list(row), ends, size)
    pages.down(4.0)


def _row(pages: Pages, cells: list[str], ends: list[float], size: float, **style: str) -> None:
    """Write one line of a table: the first column from the left, numbers to the right."""
    for k, (cell, end) in enumerate(zip(cells, ends, strict=True)):
        pages.text(0.0 if k == 0 else end, cell, size, "left" if k == 0 else "right", **style)
    pages.down()
