"""YAML nodes into values by the schema's kinds, each problem with file and line."""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import yaml

from moorage.errors import Source
from moorage.io.schema import BY_KEY, SCHEMA, Key
from moorage.io.tables import read_curve
from moorage.io.text import Findings
from moorage.model import Curve

Values = dict[str, Any]
PLACED = ("model", "environment")


class NodeReader:
    """Reads nodes of one file; `folder` is where the files that it names are found."""

    def __init__(self, file: str, folder: Path, found: Findings):
        self.file, self.folder, self.found = file, folder, found

    def source(self, node: yaml.Node) -> Source:
        """Return the place of a node."""
        return Source(self.file, node.start_mark.line + 1)

    def read_object(self, node: yaml.Node, name: str, what: str) -> Values | None:
        """Return the values of an object of the schema, with its source; None when it cannot be made.

        Those that are no components have `places` beside, the source of each key.
        """
        if not isinstance(node, yaml.MappingNode):
            self._refuse(node, f"{what} is not an object", f"write keys such as {', '.join(list(SCHEMA[name])[:3])}")
            return None
        keys = SCHEMA[name]
        values: Values = {"source": self.source(node)}
        places: dict[str, Source] = {}
        before = len(self.found.problems)
        for key_node, value_node in node.value:
            key = str(key_node.value)
            if not isinstance(key_node, yaml.ScalarNode):
                self._refuse(key_node, f"a key of {what} is not a word", f"use {', '.join(keys)}")
            elif key not in keys:
                near = difflib.get_close_matches(key, keys, n=1)
                remedy = f"did you mean {near[0]}?" if near else f"use {', '.join(keys)}"
                self._refuse(key_node, f"key of {what} is not known", remedy, key)
            elif key in values:
                self._refuse(key_node, f"key {key} of {what} is given twice", "remove one")
            else:
                values[key] = self.value(value_node, keys[key], f"{key} of {what}")
                places[key] = self.source(key_node)
        for key, entry in keys.items():
            if entry.required and key not in values:
                self._refuse(node, f"{key} of {what} is missing", f"add {key} ({entry.text}, {entry.unit})")
        if name in PLACED:
            values["places"] = places
        return values if len(self.found.problems) == before else None

    def value(self, node: yaml.Node, key: Key, what: str) -> Any:
        """Return the value of a node of a kind; a problem is noted when it is not of that kind."""
        kind = key.kind
        if kind.startswith("one of "):
            return self._choice(node, kind[len("one of ") :].split(", "), what)
        if kind.startswith("list of "):
            name = kind[len("list of ") :]
            items = self._items(node, what)
            return [self.read_object(item, name, f"{name} {k + 1}" + _id(item)) for k, item in enumerate(items)]
        if kind.startswith("map of "):
            return self._map(node, kind[len("map of ") :], what)
        kind = next((name for word, name in BY_KEY.get(kind, {}).items() if _has_key(node, word)), kind)
        if kind in SCHEMA:
            return self.read_object(node, kind, what)
        readers: dict[str, Callable[[yaml.Node, str], Any]] = {
            "number": self._number,
            "number or nearest": lambda n, w: n.value if n.value == "nearest" else self._number(n, w),
            "integer": self._integer,
            "text": self._text,
            "flag": self._flag,
            "numbers": self._numbers,
            "vector": self._vector,
            "position": self._position,
            "curve": self._curve,
            "table": self._table,
            "integers": lambda n, w: tuple(self._integer(item, w) for item in self._items(n, w)),
            "texts": lambda n, w: [(self._text(item, w), self.source(item)) for item in self._items(n, w)],
            "pairs": self._pairs,
            "end": lambda n, w: (self._text(n, w), self.source(n)),
            "owner": lambda n, w: (self._text(n, w), self.source(n)),
        }
        return readers[kind](node, what)

    def _refuse(self, node: yaml.Node, message: str, remedy: str, value: object = None) -> None:
        self.found.add(message, remedy, self.source(node), value)
        self.found.lost_rows = True

    def _text(self, node: yaml.Node, what: str) -> str:
        if isinstance(node, yaml.ScalarNode) and node.tag != "tag:yaml.org,2002:null":
            return str(node.value)
        self._refuse(node, f"{what} is not a word", "write a word or a number")
        return ""

    def _number(self, node: yaml.Node, what: str) -> float:
        return self.found.number(self._text(node, what), what, self.source(node))

    def _integer(self, node: yaml.Node, what: str) -> int:
        return self.found.integer(self._text(node, what), what, self.source(node))

    def _flag(self, node: yaml.Node, what: str) -> bool:
        word = self._text(node, what).lower()
        if word not in ("true", "false"):
            self._refuse(node, f"{what} is neither true nor false", "write true or false", word)
        return word == "true"

    def _choice(self, node: yaml.Node, words: list[str], what: str) -> str:
        word = self._text(node, what)
        if word not in words:
            near = difflib.get_close_matches(word, words, n=1)
            hint = f"did you mean {near[0]}? " if near else ""
            self._refuse(node, f"{what} is not known", f"{hint}write {' or '.join(words)}", word)
            return words[0]
        return word

    def _items(self, node: yaml.Node, what: str) -> list[yaml.Node]:
        if isinstance(node, yaml.SequenceNode):
            return node.value
        self._refuse(node, f"{what} is not a list", "write [a, b, c], or one item a line after dashes")
        return []

    def _map(self, node: yaml.Node, name: str, what: str) -> dict[str, Values | None]:
        if not isinstance(node, yaml.MappingNode):
            self._refuse(node, f"{what} is not a set of names", f"write the name of each {name} with its properties")
            return {}
        entries: dict[str, Values | None] = {}
        for key_node, value_node in node.value:
            key = str(key_node.value)
            if key in entries:
                self._refuse(key_node, f"{name} {key} is described twice", "rename one")
            entries[key] = self.read_object(value_node, name, f"{name} {key}")
        return entries

    def _numbers(self, node: yaml.Node, what: str) -> tuple[float, ...]:
        return tuple(self._number(item, what) for item in self._items(node, what))

    def _vector(self, node: yaml.Node, what: str) -> tuple[float, ...]:
        values = self._numbers(node, what)
        if len(values) != 3:
            self._refuse(node, f"{what} has {len(values)} values", "give three")
            return (0.0, 0.0, 0.0)
        return values

    def _position(self, node: yaml.Node, what: str) -> tuple[tuple[float, ...], bool]:
        """Return x, y, z and whether z is said to be the seabed."""
        items = self._items(node, what)
        if len(items) == 3 and isinstance(items[2], yaml.ScalarNode) and items[2].value.lower() == "seabed":
            return (self._number(items[0], what), self._number(items[1], what), 0.0), True
        return self._vector(node, what), False

    def _table(self, node: yaml.Node, what: str) -> tuple[tuple[float, ...], ...]:
        table = tuple(self._numbers(item, what) for item in self._items(node, what))
        if len({len(row) for row in table}) > 1:
            self._refuse(node, f"rows of {what} differ in length", "give rows of one length")
        return table

    def _pairs(self, node: yaml.Node, what: str) -> tuple[tuple[str, str], ...]:
        if not isinstance(node, yaml.MappingNode):
            self._refuse(node, f"{what} is not a set of names", "write name: value")
            return ()
        if len({str(k.value) for k, _ in node.value}) < len(node.value):
            self._refuse(node, f"a key of {what} is given twice", "remove one")
        return tuple((str(k.value), self._text(v, what)) for k, v in node.value)

    def _curve(self, node: yaml.Node, what: str) -> float | Curve:
        """Return a number, a curve of x and y, or the curve in a file."""
        if not isinstance(node, yaml.MappingNode):
            return self._number(node, what)
        parts = {str(k.value): v for k, v in node.value}
        if len(parts) < len(node.value):
            self._refuse(node, f"a key of {what} is given twice", "remove one", [str(k.value) for k, _ in node.value])
            return 0.0
        if parts.keys() == {"file"}:
            return read_curve(self.folder, self._text(parts["file"], what), what, self.found, self.source(node))
        if parts.keys() != {"x", "y"}:
            self._refuse(node, f"{what} is not a table", "write a number, {x: [...], y: [...]} or {file: name}")
            return 0.0
        x, y = (self._numbers(parts[axis], what) for axis in "xy")
        if len(x) != len(y):
            self._refuse(node, f"{what} has {len(x)} x and {len(y)} y", "give as many of both")
        return Curve(x, y)


def _has_key(node: yaml.Node, name: str) -> bool:
    return isinstance(node, yaml.MappingNode) and any(key.value == name for key, _ in node.value)


def _id(node: yaml.Node) -> str:
    """Return the id of an object for messages, as " (id 3)"."""
    if isinstance(node, yaml.MappingNode):
        for key, value in node.value:
            if key.value in ("id", "channel"):
                return f" ({key.value} {value.value})"
    return ""


def tagged(node: yaml.Node | None) -> yaml.Node | None:
    """Return the first node with a tag of a kind that YAML does not have itself, such as !!python/tuple."""
    seen: set[int] = set()
    left = [node] if node is not None else []
    while left:
        here = left.pop(0)
        if id(here) in seen:
            continue
        seen.add(id(here))
        if not re.fullmatch(r"tag:yaml\.org,2002:[a-z]+", here.tag):
            return here
        if isinstance(here, yaml.MappingNode):
            left += [part for pair in here.value for part in pair]
        elif isinstance(here, yaml.SequenceNode):
            left += here.value
    return None
