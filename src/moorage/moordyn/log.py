"""Messages of a system: to the screen and to a file, each from a level of its own on."""

from __future__ import annotations

import sys
from pathlib import Path

from moorage.moordyn.codes import LEVEL_DBG, LEVEL_ERR, LEVEL_MSG, LEVEL_NONE, LEVEL_WRN

HEADS = {LEVEL_DBG: "DBG", LEVEL_MSG: "MSG", LEVEL_WRN: "WRN", LEVEL_ERR: "ERR"}


class Log:
    """Levels of the screen (standard error) and of a file."""

    def __init__(self) -> None:
        self.screen = LEVEL_WRN
        self.level = LEVEL_NONE
        self.file: Path | None = None

    def open(self, path: str) -> None:
        """Begin a log file."""
        Path(path).write_text("")
        self.file = Path(path)

    def write(self, level: int, message: str) -> None:
        """Write a message where its level is asked for."""
        text = message.rstrip("\n") + "\n"
        if level >= self.screen:
            sys.stderr.write(text)
        if self.file is not None and level >= self.level:
            with self.file.open("a") as out:
                out.write(text)

    def say(self, level: int, message: str) -> None:
        """Write a message of the program itself, with its level in front."""
        self.write(level, f"{HEADS[level]} {message}")
