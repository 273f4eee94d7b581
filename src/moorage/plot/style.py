"""Colours and a bare figure: Okabe and Ito's palette, told apart by the colour-blind and in print."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from moorage.errors import Problem, ResultError

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
WATER, SEABED, QUIET = "#56B4E9", "#8C7B6B", "#9AA0A6"


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure, in inches, that needs no display and no pyplot."""
    figure = Figure(figsize=(width, height), layout="constrained", dpi=150)
    FigureCanvasAgg(figure)
    return figure


def plain(ax: Axes) -> None:
    """Take away what carries nothing."""
    ax.spines[["top", "right"]].set_visible(False)
    ax.grid(True, color="#E3E5E8", linewidth=0.6)
    ax.set_axisbelow(True)
    ax.tick_params(labelsize=8)


def loudest(peaks: np.ndarray) -> np.ndarray:
    """Return which of many curves stand out by their peaks (n,): all there are colours for, or the highest three."""
    return np.sort(np.argsort(peaks)[::-1][: len(COLOURS) if len(peaks) <= len(COLOURS) else 3])


def draw_curves(ax: Axes, x: np.ndarray, names: list[str], values: np.ndarray, others: str) -> None:
    """Draw curves (n, k) over x (n,); of many, those with the highest peaks stand out, and `others` names the rest.

    Later ones are thinner, so that an equal one under them shows.
    """
    chosen = loudest(values.max(axis=0))
    rest = np.setdiff1d(np.arange(values.shape[1]), chosen)
    for k in rest:
        ax.plot(x, values[:, k], color=QUIET, linewidth=0.5, alpha=0.5, label=others if k == rest[0] else None)
    for colour, k, width in zip(COLOURS, chosen, np.linspace(1.8, 0.8, len(chosen)), strict=False):
        ax.plot(x, values[:, k], color=colour, linewidth=width, label=names[k])
    plain(ax)


def save(figure: Figure, path: str | Path, **options: Any) -> None:
    """Write a figure; the ending of the name chooses the format."""
    known = FigureCanvasAgg.get_supported_filetypes()
    if Path(path).suffix.lower().removeprefix(".") not in known:
        raise ResultError(
            Problem("pictures are not written in this format", "end in .png, .pdf or .svg", value=str(path))
        )
    try:
        figure.savefig(path, **options)
    except OSError as error:
        why = error.strerror or error
        raise ResultError(Problem(f"cannot write {path}: {why}", "give another file (-o)")) from error
