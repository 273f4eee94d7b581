"""From one kind of model file to another."""

from __future__ import annotations

from pathlib import Path

from moorage.io.moordyn import write_moordyn
from moorage.io.moordyn.layout import Flavour
from moorage.io.native import write_native
from moorage.io.read import read


def convert(source: str | Path, target: str | Path, flavour: Flavour = "C", raise_to_seabed: bool = False) -> list[str]:
    """Read a model file and write it as another kind: native for .yaml and .yml, else MoorDyn v2.

    Returns
    -------
    list of str
        What the target says otherwise, or cannot say.
    """
    model = read(source, raise_to_seabed)
    if Path(target).suffix.lower() in (".yaml", ".yml"):
        return write_native(model, target)
    return write_moordyn(model, target, flavour)
