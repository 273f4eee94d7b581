"""From one kind of model file to another."""

from __future__ import annotations

from pathlib import Path

from moorage.errors import InputError, Problem
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

    Raises
    ------
    InputError
        The target is a file that was read: it would be lost.
    """
    model = read(source, raise_to_seabed)
    if any(_is_same(Path(target), Path(file)) for file in (source, model.file)):
        raise InputError(Problem(f"{target} is the model that is read", "give another file to write"))
    if Path(target).suffix.lower() in (".yaml", ".yml"):
        return write_native(model, target)
    return write_moordyn(model, target, flavour)


def _is_same(one: Path, other: Path) -> bool:
    return one.exists() and other.exists() and one.samefile(other)
