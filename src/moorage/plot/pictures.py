"""One kind of picture of a result as a figure of its own, by name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import xarray as xr
from matplotlib.figure import Figure

from moorage.errors import Problem, ResultError
from moorage.plot.envelope import plot_envelope
from moorage.plot.figure import profiles_figure
from moorage.plot.seabed import seabed_map
from moorage.plot.spectrum import plot_spectrum
from moorage.plot.style import new_figure, save
from moorage.plot.tension import plot_tension


def picture(ds: xr.Dataset, what: str) -> Figure:
    """Return one picture of a result.

    Parameters
    ----------
    ds : xarray.Dataset
        A run or a static solution.
    what : str
        profile (each mooring from the side), history (tensions over time), envelope (extremes of tension along the
        lines), spectrum (of tensions) or map (depth and the mooring's footprint).

    Raises
    ------
    ResultError
        There is no such picture, or the result does not hold what it needs.
    """
    if what not in PICTURES:
        raise ResultError(Problem("there is no such picture", f"choose from {', '.join(PICTURES)}", value=what))
    if not ds.sizes["line"]:
        raise ResultError(
            Problem(f"a result without lines has no {what}", "draw its figure (plot), or look at it with view")
        )
    if what in OVER_TIME and "time" not in ds["fairlead_tension"].dims:
        raise ResultError(Problem(f"a static solution has no {what}", "take a result of `run`"))
    if what not in OVER_TIME and "node_position" not in ds:
        raise ResultError(Problem("the result has no histories of nodes", "run it again with --save all (save='all')"))
    return PICTURES[what](ds)


def save_picture(ds: xr.Dataset, what: str, path: str | Path) -> None:
    """Write one picture of a result; the ending of the name chooses the format (png, pdf, svg)."""
    save(picture(ds, what), path, bbox_inches="tight")


def _history(ds: xr.Dataset) -> Figure:
    figure = new_figure(8.0, 6.0)
    above, below = figure.subplots(2, 1, sharex=True)
    plot_tension(ds, above)
    plot_tension(ds, below, "anchor_tension")
    above.set_xlabel("")
    below.get_legend().remove()
    return figure


def _envelope(ds: xr.Dataset) -> Figure:
    figure = new_figure(8.0, 4.0)
    plot_envelope(ds, figure.add_subplot())
    return figure


def _spectrum(ds: xr.Dataset) -> Figure:
    figure = new_figure(8.0, 4.0)
    plot_spectrum(ds, figure.add_subplot())
    return figure


def _map(ds: xr.Dataset) -> Figure:
    figure = new_figure(7.0, 6.0)
    seabed_map(ds, figure.add_subplot())
    return figure


OVER_TIME = ("history", "spectrum")
PICTURES: dict[str, Callable[[xr.Dataset], Figure]] = {
    "profile": profiles_figure,
    "history": _history,
    "envelope": _envelope,
    "spectrum": _spectrum,
    "map": _map,
}
