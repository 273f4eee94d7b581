"""The seabed in pictures: under the profile of a mooring, and as a map with the mooring's footprint."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patheffects import withStroke

from moorage.model import Attachment, Model
from moorage.model.turbines import placed
from moorage.plot.style import COLOURS, QUIET, SEABED, new_figure, plain
from moorage.results.bed_level import bed_level
from moorage.results.bending import touchdown

SAMPLES = 400  # places of a section
MARGIN = 0.25  # of a map around the mooring, as a part of its size
LEVELS = 12  # colours of a map

Plane = tuple[np.ndarray, np.ndarray]  # a horizontal origin and unit vector


def draw_sections(ds: xr.Dataset, planes: Iterable[Plane], ax: Axes) -> float:
    """Draw the seabed in vertical planes, filled when there is one of them; return the lowest z of them, m.

    It goes on beyond the axes, which may share their limits with others, and does not change their limits.
    """
    low, high = ax.get_xlim()
    distance = np.linspace(2.0 * low - high, 2.0 * high - low, 3 * SAMPLES)
    seen = (distance >= low) & (distance <= high)
    planes = list(planes) if "bed_level" in ds.coords else list(planes)[:1]  # a flat seabed is the same in all
    sections = [bed_level(ds, *(o[:, None] + d[:, None] * distance)) for o, d in planes]
    floor = min(float(z[seen].min()) for z in sections)
    lines = [np.stack([distance, z], axis=-1) for z in sections]
    weak = 1.0 if len(lines) == 1 else 0.5
    ax.add_collection(LineCollection(lines, colors=SEABED, linewidths=1.2 * weak, zorder=1), autolim=False)
    if len(lines) == 1:
        deep = 2.0 * floor - max(float(sections[0].max()), 0.0)
        ground = np.concatenate([lines[0], [[distance[-1], deep], [distance[0], deep]]])
        fill = PolyCollection([ground], facecolors=SEABED, alpha=0.35, linewidths=0, zorder=0)
        ax.add_collection(fill, autolim=False)
    return floor


class Footprint(NamedTuple):
    """What a map shows."""

    x: np.ndarray  # (nx,) depth grid, m; empty: flat
    y: np.ndarray  # (ny,)
    depth: np.ndarray  # (nx, ny) m
    flat: float  # depth without a grid, m
    lines: list[np.ndarray]  # (n, 2) from above
    points: dict[str, np.ndarray]  # (n, 2) by kind
    touchdown: np.ndarray  # (n, 2)


def seabed_map(source: xr.Dataset | Model, ax: Axes | None = None) -> Axes:
    """Draw the depth of the water with the footprint of a mooring on it.

    Parameters
    ----------
    source : xarray.Dataset or Model
        A result, with its lines at time 0 and where they meet the seabed, or a model, with straight lines between their
        ends.
    ax : matplotlib Axes, optional
        Where to draw; by default a new figure, `ax.figure`.
    """
    shown = _of_model(source) if isinstance(source, Model) else _of_result(source)
    ax = new_figure(7.0, 6.0).add_subplot() if ax is None else ax
    low, high = _limits(shown)
    _draw_depth(shown, ax, low, high)
    ax.add_collection(LineCollection(shown.lines, colors="black", linewidths=1.0, zorder=3))
    marks = (("fixed", "s", "black"), ("coupled", "o", COLOURS[1]), ("free", ".", QUIET))
    for kind, marker, colour in marks:
        if len(shown.points.get(kind, ())):
            x, y = shown.points[kind].T
            ax.plot(x, y, marker, color=colour, markersize=4, zorder=4, label=f"{kind} points")
    if len(shown.touchdown):
        x, y = shown.touchdown.T
        ax.plot(x, y, "^", color=COLOURS[4], markersize=5, zorder=4, label="touchdown")
    plain(ax)
    ax.set_axisbelow(False)
    ax.grid(False)
    ax.set_aspect("equal", adjustable="box")
    ax.ticklabel_format(style="plain", useOffset=False)  # coordinates of a survey are read whole
    ax.set_xlim(low[0], high[0])
    ax.set_ylim(low[1], high[1])
    ax.set_xlabel("x (m)", fontsize=9)
    ax.set_ylabel("y (m)", fontsize=9)
    ax.legend(loc="lower right", bbox_to_anchor=(1.02, 1.0), ncols=4, frameon=False, fontsize=8, borderpad=0.2)
    return ax


def _limits(shown: Footprint) -> tuple[np.ndarray, np.ndarray]:
    """Return the lower left and upper right corner of a map around the mooring."""
    places = np.concatenate([*shown.lines, *shown.points.values()])
    low, high = places.min(axis=0), places.max(axis=0)
    margin = MARGIN * max(float((high - low).max()), 1.0)
    return low - margin, high + margin


def _draw_depth(shown: Footprint, ax: Axes, low: np.ndarray, high: np.ndarray) -> None:
    """Fill the map with colours by depth, with contours; outside the grid it stays white."""
    if min(len(shown.x), len(shown.y)) < 2:
        ax.set_title(f"water depth {shown.flat:g} m", fontsize=9, loc="left")
        return
    i, j = (_around(axis, a, b) for axis, a, b in zip((shown.x, shown.y), low, high, strict=True))
    depth = shown.depth[i, j]
    if np.ptp(depth) < 1e-6 * np.abs(depth).max():
        depth = depth + np.linspace(0.0, 1e-3, depth.shape[0])[:, None]  # a level one has no contours
    ink = ax.contourf(shown.x[i], shown.y[j], depth.T, LEVELS, cmap="Blues", alpha=0.9, zorder=0)
    lines = ax.contour(shown.x[i], shown.y[j], depth.T, ink.levels, colors="white", linewidths=0.5, zorder=1)
    for label in ax.clabel(lines, fontsize=7, colors="#3A3F44"):
        label.set_path_effects([withStroke(linewidth=2.0, foreground="white", alpha=0.8)])
    bar = ax.figure.colorbar(ink, ax=ax, shrink=0.85)
    bar.set_label("water depth (m)", fontsize=9)
    bar.ax.tick_params(labelsize=8)
    bar.ax.invert_yaxis()


def _around(axis: np.ndarray, low: float, high: float) -> slice:
    """Return the part of an axis that covers an interval, of two values at least."""
    first = max(int(np.searchsorted(axis, low, side="right")) - 1, 0)
    last = min(int(np.searchsorted(axis, high)), len(axis) - 1)
    return slice(min(first, len(axis) - 2), max(last, first + 1) + 1)


def _of_result(ds: xr.Dataset) -> Footprint:
    def start(name: str) -> np.ndarray:
        values = ds[name]
        return (values[0] if {"time", "node_time"} & {*values.dims} else values).values[..., :2]

    owner, nodes = ds["node_line"].values, start("node_position")
    points, kinds = start("point_position"), ds["point_kind"].values
    spots = start("touchdown_position") if "touchdown_position" in ds else _touchdowns(ds)
    grid = [ds[name].values for name in ("bed_x", "bed_y", "bed_level")] if "bed_level" in ds.coords else _NO_GRID
    return Footprint(
        grid[0],
        grid[1],
        -grid[2],
        float(ds.attrs["water_depth"]),
        [nodes[owner == id] for id in ds["line"].values],
        {kind: points[kinds == kind] for kind in ("fixed", "coupled", "free")},
        spots[np.isfinite(spots).all(axis=-1)],
    )


def _touchdowns(ds: xr.Dataset) -> np.ndarray:
    """Return where the lines (n, 2) meet a flat bed at time 0; NaN where they do not."""
    nodes = ds["node_position"].values[0] if ds["node_position"].ndim == 3 else ds["node_position"].values
    gap, owner, arc = (
        nodes[:, 2] - bed_level(ds, nodes[:, 0], nodes[:, 1]),
        ds["node_line"].values,
        ds["arc_length"].values,
    )
    own = [owner == id for id in ds["line"].values]
    return np.array([touchdown(nodes[None, k], gap[None, k], arc[k])[0][0, :2] for k in own]).reshape(-1, 2)


def _of_model(model: Model) -> Footprint:
    grid = model.environment.bathymetry
    x, y, depth = map(np.array, (grid.x, grid.y, grid.depth)) if grid else _NO_GRID
    model = placed(model)
    places = [(p.kind, _place(model, Attachment("point", p.id))) for p in model.points]
    kinds = {kind for kind, _ in places}
    return Footprint(
        x,
        y,
        depth,
        model.environment.water_depth,
        [np.array([_place(model, end) for end in (line.end_a, line.end_b)]) for line in model.lines],
        {kind: np.array([place for k, place in places if k == kind]) for kind in kinds},
        np.empty((0, 2)),
    )


def _place(model: Model, end: Attachment) -> np.ndarray:
    """Return x and y of a point or rod end; on a body, as if that were not turned."""
    thing = model.point(end.id) if end.kind == "point" else next(rod for rod in model.rods if rod.id == end.id)
    where = thing.position if end.kind == "point" else (thing.end_b if end.end == "B" else thing.end_a)  # type: ignore[union-attr]
    carrier = next((body for body in model.bodies if body.id == thing.body), None)
    return np.array(where[:2]) + (np.array(carrier.position[:2]) if carrier else 0.0)


_NO_GRID = (np.empty(0), np.empty(0), np.empty((0, 0)))
