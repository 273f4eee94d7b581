"""What a model shows of itself in a notebook."""

from __future__ import annotations

from collections import Counter
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from moorage.model.components import Line
    from moorage.model.model import Model

CELL = 'style="text-align: left; padding: 2px 12px 2px 0"'


def model_html(model: Model) -> str:
    """Return a model as HTML: what it holds, and a table of its lines."""
    rows = "".join(_row(_line_words(line)) for line in model.lines)
    head = _row(("line", "from end A", "to end B", "length (m)", "segments", "line types"), "th")
    facts = "".join(_row(fact) for fact in _facts(model))
    title = escape(model.title or "Mooring")
    return f"<div><b>{title}</b><table>{facts}</table><table><thead>{head}</thead><tbody>{rows}</tbody></table></div>"


def _facts(model: Model) -> list[tuple[str, str]]:
    water, kinds = model.environment, Counter(point.kind for point in model.points)
    depth = f"{water.water_depth:g} m" + (", depth grid" if water.bathymetry else "")
    parts = [("points", ", ".join(f"{n} {kind}" for kind, n in sorted(kinds.items())))]
    parts += [(name, str(len(things))) for name, things in (("rods", model.rods), ("bodies", model.bodies)) if things]
    seen = [("input", f"{model.file} ({model.flavour})" if model.file else model.flavour), ("water depth", depth)]
    return seen + ([("waves", water.waves.words)] if water.waves else []) + [fact for fact in parts if fact[1]]


def _line_words(line: Line) -> tuple[str, ...]:
    types = list(dict.fromkeys(section.line_type for section in line.sections))
    name = f"{line.id} {line.name}" if line.name and line.name != str(line.id) else str(line.id)
    return name, str(line.end_a), str(line.end_b), f"{line.length:.6g}", str(line.segments), ", ".join(types)


def _row(cells: tuple[str, ...], tag: str = "td") -> str:
    return "<tr>" + "".join(f"<{tag} {CELL}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"
