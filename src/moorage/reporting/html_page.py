"""A report as one page of HTML that needs nothing else."""

from __future__ import annotations

import base64
import io
from html import escape

import xarray as xr
from matplotlib.figure import Figure

from moorage.reporting.content import Block, Doubts, Facts, Table, figures, sections

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #22262a; max-width: 60rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.6rem } h2 { font-size: 1.15rem; margin-top: 2rem }
table { border-collapse: collapse; margin: .5rem 0 1rem } caption { text-align: left; color: #5a626a }
th, td { padding: .15rem .8rem .15rem 0; text-align: right; border-bottom: 1px solid #e3e5e8 }
th { font-weight: 600 } .facts th, .facts td, td:first-child, th:first-child { text-align: left }
img { max-width: 100% } pre { background: #f5f6f7; padding: .8rem; overflow: auto; font-size: 12px }
.doubt { border-left: 4px solid #d55e00; padding: .2rem .8rem; margin: .5rem 0; white-space: pre-wrap }
@media print { details { display: none } figure, table { break-inside: avoid } }
"""


def report_page(ds: xr.Dataset) -> str:
    """Return the report of a run as HTML."""
    title = escape(str(ds.attrs["title"]))
    parts = [f"<h1>{title}</h1>"]
    parts += [_section(name, "".join(map(_block, blocks))) for name, blocks in sections(ds).items()]
    parts += [_section("Figures", "".join(_figure(*shown) for shown in figures(ds))), _input(str(ds.attrs["input"]))]
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>{title}</title>'
    body = "\n".join(filter(None, parts))
    return (
        f'<!doctype html>\n<html lang="en"><head>{head}<style>{STYLE}</style></head>\n<body>\n{body}\n</body></html>\n'
    )


def _block(block: Block) -> str:
    if isinstance(block, Doubts):
        return "".join(f'<p class="doubt">{escape(text)}</p>' for text in block.texts)
    if isinstance(block, Facts):
        rows = "".join(f"<tr><th>{escape(k)}</th><td>{escape(v)}</td></tr>" for k, v in block.rows.items())
        return f'<table class="facts">{rows}</table>'
    return _table(block)


def _table(table: Table) -> str:
    head = "".join(f"<th>{escape(name)}</th>" for name in table.names)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in table.rows)
    return f"<table><caption>{escape(table.caption)}</caption><tr>{head}</tr>{body}</table>"


def _figure(caption: str, figure: Figure | str) -> str:
    """Return a figure as PNG in the page: lines of long runs would be megabytes as SVG."""
    words = escape(caption)
    if isinstance(figure, str):
        return f"<p>{words}: not drawn, {escape(figure)}</p>"
    with io.BytesIO() as buffer:
        figure.savefig(buffer, format="png", bbox_inches="tight")
        data = base64.b64encode(buffer.getvalue()).decode()
    return f'<figure><img alt="{words}" src="data:image/png;base64,{data}"><figcaption>{words}</figcaption></figure>'


def _input(text: str) -> str:
    return f"<details><summary>Input</summary><pre>{escape(text)}</pre></details>" if text else ""


def _section(title: str, body: str) -> str:
    return f"<h2>{title}</h2>\n{body}" if body else ""
