"""A mooring to look at, in a browser or in a notebook."""

from __future__ import annotations

import html
from dataclasses import dataclass
from pathlib import Path

import xarray as xr

from moorage.errors import Problem, ResultError
from moorage.io import read
from moorage.model import Model
from moorage.results import open_result
from moorage.run import solve_statics
from moorage.viewer import page, scene_of

HEIGHT = 620  # of the frame in a notebook, pixels


@dataclass(frozen=True, repr=False)
class View:
    """A page that shows a mooring; in a notebook it shows itself.

    Attributes
    ----------
    html : str
        The page, with all that it needs.
    """

    html: str

    def save(self, path: str | Path) -> Path:
        """Write the page, and return where it is."""
        path = Path(path)
        try:
            path.write_text(self.html, "utf-8")
        except OSError as error:
            why = error.strerror or error
            raise ResultError(Problem(f"cannot write {path}: {why}", "give another file (-o)")) from error
        return path

    def _repr_html_(self) -> str:
        size = f'width="100%" height="{HEIGHT}"'
        return f'<iframe srcdoc="{html.escape(self.html)}" {size} style="border: 0" title="The mooring"></iframe>'

    def __repr__(self) -> str:
        return f"<moorage.View: a page of {len(self.html) / 1e6:.1f} MB; save(path) writes it>"


def view(source: xr.Dataset | Model | str | Path, path: str | Path | None = None) -> View:
    """Show a mooring in three dimensions on one page of HTML that needs nothing else.

    Parameters
    ----------
    source : xarray.Dataset, Model, or path
        A result with histories of nodes, in motion; a static solution, or a model, which is solved for it; or the file
        of a result (.nc) or of a model.
    path : path, optional
        Where to write the page.

    Returns
    -------
    View
        Shows itself in a notebook; `save` writes it.

    Raises
    ------
    ResultError
        The result has no histories of nodes.
    """
    if isinstance(source, str | Path):
        source = open_result(source) if Path(source).suffix == ".nc" else read(source)
    model = source if isinstance(source, Model) else None
    ds = solve_statics(source) if isinstance(source, Model) else source
    shown = View(page(scene_of(ds, model)))
    if path is not None:
        shown.save(path)
    return shown
