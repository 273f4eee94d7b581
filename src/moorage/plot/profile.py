"""Shape of a mooring: in the vertical plane through its ends, and from above."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from moorage.plot.moorings import held_ends
from moorage.plot.style import COLOURS, QUIET, SEABED, WATER, plain

SHADOWS = 200  # instants whose shapes make the envelope


def plot_profile(ds: xr.Dataset, lines: list[int], ax: Axes) -> Axes:
    """Draw a mooring of one or more lines: its shape at time 0 over the shapes that it takes during the run.

    The horizontal axis is the distance from the (moving) end at time 0 towards the other end, m.
    """
    origin, direction = _plane(ds, lines)
    start = "static" if ds.attrs["start"] == "static" else "at time 0"
    for k, id in enumerate(lines):
        nodes, colour = _shapes(ds, id), COLOURS[k % len(COLOURS)]
        shapes = np.stack([(nodes[..., :2] - origin) @ direction, nodes[..., 2]], axis=-1)
        if len(shapes) > 1:
            ax.add_collection(LineCollection(list(shapes), colors=colour, linewidths=0.8, alpha=0.12, zorder=2))
        x, z = shapes[0].T
        alone = len(lines) == 1
        ax.plot(x, z, color="black" if alone else colour, lw=1.3, zorder=3, label=start if alone else f"line {id}")
        ax.plot(x[[0, -1]], z[[0, -1]], "o", color="black", markersize=3, zorder=4)
    if len(shapes) > 1:
        ax.plot([], [], color=colour if alone else QUIET, linewidth=4, alpha=0.4, label="during the run")
    ax.autoscale_view()
    return _finish(ds, ax)


def plot_profiles(ds: xr.Dataset, groups: list[list[int]], ax: Axes) -> Axes:
    """Draw many moorings at time 0 over each other, each in the vertical plane of `plot_profile`."""
    nodes, shapes = _starts(ds), []
    for lines in groups:
        origin, direction = _plane(ds, lines)
        shapes += [np.stack([(nodes[id][:, :2] - origin) @ direction, nodes[id][:, 2]], axis=-1) for id in lines]
    ax.add_collection(LineCollection(shapes, colors=COLOURS[0], linewidths=0.8, alpha=0.6))
    ax.autoscale_view()
    return _finish(ds, ax)


def plot_plan(ds: xr.Dataset, ax: Axes) -> Axes:
    """Draw all lines at time 0 from above, x against y, in m."""
    plan = [nodes[:, :2] for nodes in _starts(ds).values()]
    ax.add_collection(LineCollection(plan, colors=COLOURS[0], linewidths=0.8))
    kinds = ds["point_kind"].values
    position = _at_start(ds["point_position"]).values
    for kind, marker, colour in (("fixed", "s", SEABED), ("coupled", "o", COLOURS[1]), ("free", ".", QUIET)):
        chosen = position[kinds == kind]
        if len(chosen):
            ax.plot(chosen[:, 0], chosen[:, 1], marker, color=colour, markersize=3, label=f"{kind} points")
    plain(ax)
    ax.set_aspect("equal", adjustable="datalim")
    ax.set_xlabel("x (m)", fontsize=9)
    ax.set_ylabel("y (m)", fontsize=9)
    return ax


def _plane(ds: xr.Dataset, lines: list[int]) -> tuple[np.ndarray, np.ndarray]:
    """Return a horizontal origin and unit vector: from the moving end to the end that is farthest from it."""
    position = _at_start(ds["point_position"])
    ends = [position.sel(point=end).values[:2] for end in held_ends(ds, lines)]
    if not ends:
        nodes = _starts(ds)[lines[0]]
        ends = [nodes[-1, :2], nodes[0, :2]]
    spans = [end - ends[0] for end in ends]
    span = max(spans, key=lambda s: float(np.hypot(*s)))
    length = float(np.hypot(*span))
    return ends[0], span / length if length > 0.0 else np.array([1.0, 0.0])


def _shapes(ds: xr.Dataset, id: int) -> np.ndarray:
    """Return shapes of a line (m, nodes, 3): the first, and at most `SHADOWS` later ones."""
    nodes = ds["node_position"].isel(node=np.flatnonzero(ds["node_line"].values == id))
    if nodes.ndim == 2:
        return nodes.values[None]
    step = max(1, -(-nodes.shape[0] // SHADOWS))
    return nodes[::step].values


def _starts(ds: xr.Dataset) -> dict[int, np.ndarray]:
    """Return the shape of every line at time 0, (nodes, 3), by id."""
    position = ds["node_position"]
    nodes = (position[0] if position.ndim == 3 else position).values
    owner = ds["node_line"].values  # the nodes of a line stand together
    cuts = np.flatnonzero(np.diff(owner)) + 1
    return {int(owner[part[0]]): nodes[part] for part in np.split(np.arange(len(owner)), cuts)}


def _at_start(values: xr.DataArray) -> xr.DataArray:
    return values.isel(time=0) if "time" in values.dims else values


def _finish(ds: xr.Dataset, ax: Axes) -> Axes:
    """Draw the still water level and the seabed, and label the axes."""
    depth = float(ds.attrs["water_depth"])
    ax.axhline(0.0, color=WATER, linewidth=1.2, zorder=1)
    ax.axhspan(-1.06 * depth, -depth, color=SEABED, alpha=0.35, linewidth=0, zorder=0)
    ax.axhline(-depth, color=SEABED, linewidth=1.2, zorder=1)
    ax.set_ylim(-1.06 * depth, max(0.08 * depth, ax.get_ylim()[1]))
    plain(ax)
    end = "fairlead" if "coupled" in ds["point_kind"].values else "end"
    ax.set_xlabel(f"distance from the {end} (m)", fontsize=9)
    ax.set_ylabel("z (m)", fontsize=9)
    return ax
