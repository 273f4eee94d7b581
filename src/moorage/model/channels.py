"""Output channels by MoorDyn's names: FAIRTEN1, LINE2N5PX, POINT3FZ, ROD1NBVX, BODY1RY."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

ChannelObject = Literal["line", "point", "rod", "body"]

_XYZ = ("X", "Y", "Z")
_TENSION = {"T": "TEN", "TEN": "TEN", "TA": "TENA", "TENA": "TENA", "TB": "TENB", "TENB": "TENB"}


def _vectors(*prefixes: str) -> dict[str, str]:
    return {prefix + axis: prefix + axis for prefix in prefixes for axis in _XYZ}


# What each object can give: every spelling, and the one that stands for it.
QUANTITIES: dict[str, dict[str, str]] = {
    "line": _vectors("P", "V", "F") | _TENSION,
    "point": _vectors("P", "V", "A", "F") | {"T": "TEN", "TEN": "TEN"},
    "rod": _vectors("P", "V", "RV", "A", "RA", "F", "M") | {"RX": "RX", "RY": "RY"} | _TENSION | {"SUB": "SUB"},
    "body": _vectors("P", "R", "V", "RV", "A", "RA", "F", "M") | {"T": "TEN", "TEN": "TEN"},
}
OF_ROD_ONLY = ("MX", "MY", "MZ", "SUB")  # not of a node of it
_WORDS = _vectors("P", "R", "V", "RV", "A", "RA", "F", "M") | _TENSION | {"SUB": "SUB"}  # that MoorDyn's readers take
_PREFIX: dict[str, ChannelObject] = {
    **dict.fromkeys(("L", "LINE"), "line"),
    **dict.fromkeys(("P", "POINT", "C", "CON", "CONNECT", "CONNECTION"), "point"),
    **dict.fromkeys(("R", "ROD"), "rod"),
    **dict.fromkeys(("B", "BODY"), "body"),
}
_NAME = re.compile(r"([A-Z]+?)(\d+)(?:N(\d+|A|B)(?=[A-Z]))?([A-Z]+)")


@dataclass(frozen=True)
class Channel:
    """A channel taken apart.

    `node` counts from end A; -1 is the last node (end B), None the object itself. `quantity` is PX, VX, FX, TEN, TENA,
    TENB, RX, RVX, AX, RAX, MX, SUB.
    """

    object: ChannelObject
    id: int
    node: int | None
    quantity: str


def parse_channel(name: str) -> Channel | None:
    """Return what a name asks for, None when it is not a channel's name. Case does not matter.

    A line without a node means its node 0 (MoorDyn's rule), FAIRTEN its last node and ANCHTEN its first. What a node of
    a rod gives beyond P, V and F (A, R, RV, RA, TEN) only Moorage computes.
    """
    name = name.upper()
    ends = re.fullmatch(r"(FAIR|ANCH)TEN(\d+)", name)
    if ends:
        return Channel("line", int(ends[2]), -1 if ends[1] == "FAIR" else 0, "TEN")
    match = _NAME.fullmatch(name)
    if match is None or match[1] not in _PREFIX:
        return None
    prefix, id, node, quantity = match.groups()
    what = _PREFIX[prefix]
    known = QUANTITIES[what].get(quantity)
    if known is None or (node is not None and (what in ("point", "body") or known in OF_ROD_ONLY)):
        return None
    return Channel(what, int(id), _node(what, node, known), known)


def why_not(name: str) -> str:
    """Return why a name asks for nothing: it is none, or one that MoorDyn's readers take and write zeros for."""
    match = _NAME.fullmatch(name.upper())
    if match is None or match[1] not in _PREFIX or match[4] not in _WORDS:
        return "output channel is not known"
    what = _PREFIX[match[1]]
    if match[3] is not None and what in ("point", "body"):
        return f"output channel is not known: a {what} has no nodes"
    node = "" if match[3] is None else "node of a "
    return f"neither MoorDyn-C nor MoorDyn-F computes {match[4]} of a {node}{what}; they write 0"


def _node(what: str, word: str | None, quantity: str) -> int | None:
    if quantity in ("TENA", "TENB"):
        return 0 if quantity == "TENA" else -1  # whatever node is said
    if word is None:
        return 0 if what == "line" else None
    return {"A": 0, "B": -1}.get(word) if not word.isdigit() else int(word)
