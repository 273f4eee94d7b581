"""Text files as rows of words, each row with its place: what every reader starts from."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from moorage.errors import ModelError, Problem, Source

COMMENT = re.compile(r"[#!%].*")
NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d+)?", re.ASCII)
QUOTED_OR_WORD = re.compile(r"\"([^\"]*)\"|'([^']*)'|(\S+)")


@dataclass(frozen=True)
class Row:
    """The words of one line of a file, without its comment; `text` is the line as it stands."""

    words: tuple[str, ...]
    text: str
    source: Source


def read_text(path: Path, what: str, error: type[Exception] = ModelError, source: Source | None = None) -> str:
    """Return the text of a file; an error says which path was tried, or that the file is empty or not text.

    Parameters
    ----------
    what : str
        What the file should hold, for the message.
    source : Source, optional
        Where the file was named.
    """
    place = source or Source(str(path))
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise error(
            Problem(f"{what} not found: tried {path}", "correct the name, or put the file there", place)
        ) from None
    except (OSError, ValueError) as reason:
        why = "it is a folder" if os.path.isdir(path) else reason  # unlike Path.is_dir, takes any name
        raise error(Problem(f"{what} {path} cannot be read: {why}", "give a readable file", place)) from None
    if not data.strip():
        raise error(Problem(f"{what} {path} is empty", "give a file with content", place))
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise error(Problem(f"{what} {path} is in UTF-16", "save it as UTF-8", place))
    if _is_binary(data):
        raise error(Problem(f"{what} {path} is not a text file", "give a text file", place))
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:  # units such as m³ come in any encoding; they stand in rows that are not read
        return data.decode("latin-1")


def _is_binary(data: bytes) -> bool:
    head = data[:65536]
    control = sum(byte < 32 and byte not in b"\t\n\r\f\x1a" for byte in head)
    return b"\0" in head or control > len(head) // 50


def rows(text: str, file: str) -> list[Row]:
    """Cut a text into rows, blank ones and comments included (they have no words)."""
    return [
        Row(tuple(_words(COMMENT.sub("", line))), line, Source(file, k + 1)) for k, line in enumerate(text.splitlines())
    ]


def _words(line: str) -> Iterator[str]:
    for match in QUOTED_OR_WORD.finditer(line):
        yield next(group for group in match.groups() if group is not None)


def is_number(word: str) -> bool:
    """Return whether a word is a decimal number, as C and Fortran write them."""
    return NUMBER.fullmatch(word) is not None


def to_float(word: str) -> float:
    """Return the value of a word that `is_number`."""
    return float(word.lower().replace("d", "e"))


class Findings:
    """The problems found while a file is read, and the conversions that find them.

    `lost_rows` says that something could not be read at all, so that what refers to it is not to be blamed.
    """

    def __init__(self) -> None:
        self.problems: list[Problem] = []
        self.lost_rows = False

    def add(self, message: str, remedy: str, source: Source | None, value: object = None) -> None:
        """Note one problem."""
        self.problems.append(Problem(message, remedy, source, value))

    def extend(self, problems: Iterable[Problem]) -> None:
        """Note the problems of another reader."""
        self.problems.extend(problems)

    def number(self, word: str, what: str, source: Source) -> float:
        """Return the number in a word; nan, and a problem noted, when there is none."""
        if is_number(word) and abs(value := to_float(word)) < float("inf"):
            return value
        self.add(f"{what} is not a number", "write a finite decimal number", source, word)
        return float("nan")

    def integer(self, word: str, what: str, source: Source) -> int:
        """Return the whole number in a word; 0, and a problem noted, when there is none."""
        if is_number(word) and abs(value := to_float(word)) < 1e15 and value == int(value):
            return int(value)
        self.add(f"{what} is not a whole number", "write a whole number", source, word)
        return 0

    def numbers(self, words: Iterable[str], what: str, source: Source) -> tuple[float, ...]:
        """Return the numbers in several words."""
        return tuple(self.number(word, what, source) for word in words)

    def raise_any(self, error: type[Exception] = ModelError) -> None:
        """Raise all problems as one error, if there are any."""
        if self.problems:
            raise error(tuple(self.problems))
