"""OUTPUTS: the channels asked for, up to the word END or the next line of dashes."""

from __future__ import annotations

from moorage.io.moordyn.sections import Table
from moorage.io.text import Findings
from moorage.model import OutputChannel
from moorage.model.channels import QUANTITIES, parse_channel, why_not


def read_outputs(table: Table, found: Findings) -> tuple[OutputChannel, ...]:
    """Return the channels of the section, in capital letters."""
    channels: list[OutputChannel] = []
    for row in table.rows:
        for word in " ".join(row.words).replace(",", " ").split():
            if word.upper() == "END":
                return tuple(channels)
            channels.append(OutputChannel(name=word.upper(), source=row.source))
            if parse_channel(word) is None:
                found.add(why_not(word), _remedy(word), row.source, word)
    return tuple(channels)


def _remedy(word: str) -> str:
    first = word[:1].upper()
    what = {"L": "line", "P": "point", "C": "point", "R": "rod", "B": "body"}.get(first)
    if what is None:
        return "write FAIRTEN1, ANCHTEN1, LINE1N5PX, POINT1FZ, ROD1PX or BODY1RX"
    form = {"line": "LINE1N5", "point": "POINT1", "rod": "ROD1N5 or ROD1", "body": "BODY1"}[what]
    return f"write {form} and one of {', '.join(dict.fromkeys(QUANTITIES[what].values()))}"
