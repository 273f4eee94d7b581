"""Files into models and back."""

from __future__ import annotations

from pathlib import Path

from moorage.io.moordyn import read_moordyn
from moorage.model import Model

__all__ = ["read", "read_moordyn"]


def read(path: str | Path) -> Model:
    """Read a model from a file: MoorDyn v2 (C or F), v1."""
    return read_moordyn(path)
