"""One entry for every kind of model file."""

from __future__ import annotations

from pathlib import Path

from moorage.io.moordyn import is_driver, is_farm, read_driver, read_farm, read_moordyn
from moorage.io.native import read_native
from moorage.io.text import read_text
from moorage.model import Model


def read(path: str | Path, raise_to_seabed: bool = False) -> Model:
    """Read a model from a file: native (.yaml, .yml), MoorDyn v2 (C or F), v1, a driver file, FAST.Farm's .fstf.

    Parameters
    ----------
    raise_to_seabed : bool
        Put fixed points that stand below the seabed on it, instead of refusing them, and those that stand less than a
        tenth of the depth over a depth grid.
    """
    path = Path(path)
    if path.suffix.lower() in (".yaml", ".yml"):
        return read_native(path, raise_to_seabed)
    text = read_text(path, "model file")
    if is_driver(text):
        return read_driver(path, raise_to_seabed).model
    if is_farm(text):
        return read_farm(path, raise_to_seabed).model
    return read_moordyn(path, raise_to_seabed=raise_to_seabed)
