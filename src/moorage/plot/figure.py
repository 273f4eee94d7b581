"""The figure of a run: tensions over time, how each mooring hangs, and what acts along each cable."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.gridspec import SubplotSpec

from moorage.errors import Problem, ResultError
from moorage.plot.along import plot_along
from moorage.plot.moorings import moorings, name_of, strands
from moorage.plot.profile import plot_plan, plot_profile, plot_profiles
from moorage.plot.style import new_figure, save
from moorage.plot.tension import plot_tension
from moorage.plot.travel import plot_travel, ways
from moorage.plot.waves import plot_elevation
from moorage.results.cables import cables

COLUMNS = 3
MOST = 6  # more moorings than this are drawn together
WIDTH, TALL, LOW, WAVES = 10.0, 3.4, 3.0, 1.6  # inches

Band = tuple[float, Callable[[Figure, SubplotSpec], object]]  # a height, and what draws there


def result_figure(ds: xr.Dataset) -> Figure:
    """Return the figure of a result: what it holds of tensions and motion over time, of profiles, and along cables.

    Raises
    ------
    ResultError
        It holds none of these.
    """
    bands = list(_bands(ds))
    if not bands:
        raise ResultError(Problem("the result has no lines, bodies or rods to draw", "look at it with view"))
    heights = [height for height, _ in bands]
    figure = new_figure(WIDTH, sum(heights))
    grid = figure.add_gridspec(len(bands), 1, height_ratios=heights)
    for k, (_, draw) in enumerate(bands):
        draw(figure, grid[k, 0])
    return figure


def profiles_figure(ds: xr.Dataset) -> Figure:
    """Return a figure of how each mooring hangs; of many, all of them together."""
    groups = moorings(ds)
    rows = 1 if len(groups) > MOST else -(-len(groups) // COLUMNS)
    figure = new_figure(WIDTH, rows * LOW)
    cell = figure.add_gridspec(1, 1)[0, 0]
    (_together if len(groups) > MOST else _grid)(ds, groups, figure, cell)
    return figure


def save_figure(ds: xr.Dataset, path: str | Path) -> None:
    """Write the figure of a result; the ending of the name chooses the format (png, pdf, svg)."""
    save(result_figure(ds), path)


def _bands(ds: xr.Dataset) -> Iterator[Band]:
    """Yield what a figure shows, from its top to its bottom."""
    groups = moorings(ds) if "node_position" in ds else []
    if "wave_elevation" in ds:
        yield WAVES, lambda figure, cell: plot_elevation(ds, figure.add_subplot(cell))
    if ds.sizes["line"] and "time" in ds["fairlead_tension"].dims:
        yield TALL, lambda figure, cell: plot_tension(ds, figure.add_subplot(cell))
    if not ds.sizes["line"] and ways(ds):
        yield LOW, lambda figure, cell: plot_travel(ds, figure.add_subplot(cell))
    if len(groups) > MOST:
        yield LOW, partial(_together, ds, groups)
        return
    stiff = [list(cable.lines) for cable in cables(ds)] if groups else []
    for group in groups:
        own = [lines for lines in stiff if set(lines) <= set(group)]
        if own:
            yield LOW, partial(_grid, ds, [group])
        for lines in own:
            yield LOW, partial(_along, ds, lines)
    plain = [group for group in groups if not any(set(lines) <= set(group) for lines in stiff)]
    if plain:
        yield -(-len(plain) // COLUMNS) * LOW, partial(_grid, ds, plain)


def _together(ds: xr.Dataset, groups: list[list[int]], figure: Figure, cell: SubplotSpec) -> None:
    """Draw many moorings at time 0, from the side and from above."""
    grid = cell.subgridspec(1, 2)
    plot_profiles(ds, groups, figure.add_subplot(grid[0, 0])).set_title("at time 0", fontsize=9, loc="left")
    _legend(plot_plan(ds, figure.add_subplot(grid[0, 1])))


def _grid(ds: xr.Dataset, groups: list[list[int]], figure: Figure, cell: SubplotSpec) -> None:
    """Draw the profiles of moorings to one scale."""
    columns = min(COLUMNS, len(groups))
    grid, first = cell.subgridspec(-(-len(groups) // columns), columns), None
    for k, group in enumerate(groups):
        ax = figure.add_subplot(grid[k // columns, k % columns], sharex=first, sharey=first)
        plot_profile(ds, group, ax)
        if len(strands(ds, group)) == 1:  # otherwise the legend names the lines, and is as wide as the axes
            ax.set_title(name_of(group), fontsize=9, loc="left")
        ax.label_outer()
        if k == 0 or len(group) > 1:
            _legend(ax)
        first = first or ax


def _along(ds: xr.Dataset, lines: list[int], figure: Figure, cell: SubplotSpec) -> None:
    """Draw tension and curvature along a cable."""
    grid = cell.subgridspec(1, 2)
    for k, variable in enumerate(("segment_tension", "curvature")):
        ax = plot_along(ds, lines, figure.add_subplot(grid[0, k]), variable)
        ax.set_title(f"along {name_of(lines)}", fontsize=9, loc="left")
        _legend(ax)


def _legend(ax: Axes) -> None:
    """Put the legend above the axes, where it covers nothing."""
    ax.legend(loc="lower right", bbox_to_anchor=(1.02, 1.0), ncols=4, frameon=False, fontsize=8, borderpad=0.2)
