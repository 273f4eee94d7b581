"""Shape of a mooring: in the vertical plane through its ends, and from above."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from moorage.plot.moorings import held_ends, name_of, only_cables, strands
from moorage.plot.seabed import Plane, draw_sections
from moorage.plot.style import COLOURS, QUIET, SEABED, WATER, plain
from moorage.results.cables import Cable, cables, strand

SHADOWS = 200  # instants whose shapes make the envelope
THIN, THICK = 1.3, 4.5  # points; the thickest segments of a cable are drawn as wide as that


def plot_profile(ds: xr.Dataset, lines: list[int], ax: Axes) -> Axes:
    """Draw a mooring of one or more lines: its shape at time 0 over the shapes that it takes during the run.

    The horizontal axis is the distance from the (moving) end at time 0 towards the other end, m. Lines that are one
    cable are drawn as one, wider where modules and stiffeners are.
    """
    origin, direction = _plane(ds, lines)
    start = "static" if ds.attrs["start"] == "static" else "at time 0"
    parts = strands(ds, lines)
    alone = len(parts) == 1
    for k, part in enumerate(parts):
        cable, colour = strand(ds, part), COLOURS[k % len(COLOURS)]
        nodes = _shapes(ds, cable.nodes[::-1])
        shapes = np.stack([(nodes[..., :2] - origin) @ direction, nodes[..., 2]], axis=-1)
        if len(shapes) > 1:
            ax.add_collection(LineCollection(list(shapes), colors=colour, linewidths=0.8, alpha=0.12, zorder=2))
        x, z = shapes[0].T
        ink = "black" if alone else colour
        ax.plot(x, z, color=ink, lw=THIN, zorder=3, label=start if alone else name_of(part))
        _thicken(ds, ax, cable, shapes[0][::-1], ink)
        ax.plot(x[[0, -1]], z[[0, -1]], "o", color="black", markersize=3, zorder=4)
    if len(shapes) > 1:
        ax.plot([], [], color=colour if alone else QUIET, linewidth=4, alpha=0.4, label="during the run")
    _mark_touchdown(ds, lines, ax, origin, direction)
    ax.autoscale_view()
    return _finish(ds, ax, [(origin, direction)], "hang-off" if only_cables(ds, lines) else None)


def plot_profiles(ds: xr.Dataset, groups: list[list[int]], ax: Axes) -> Axes:
    """Draw many moorings at time 0 over each other, each in the vertical plane of `plot_profile`."""
    nodes, shapes, planes = _starts(ds), [], [_plane(ds, lines) for lines in groups]
    for lines, (origin, direction) in zip(groups, planes, strict=True):
        shapes += [np.stack([(nodes[id][:, :2] - origin) @ direction, nodes[id][:, 2]], axis=-1) for id in lines]
    ax.add_collection(LineCollection(shapes, colors=COLOURS[0], linewidths=0.8, alpha=0.6))
    ax.autoscale_view()
    return _finish(ds, ax, planes)


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
    ax.ticklabel_format(style="plain", useOffset=False)
    ax.set_xlabel("x (m)", fontsize=9)
    ax.set_ylabel("y (m)", fontsize=9)
    return ax


def _thicken(ds: xr.Dataset, ax: Axes, cable: Cable, shape: np.ndarray, colour: str) -> None:
    """Draw the segments of a cable (nodes, 2) that are thicker than others as wide as they are."""
    if "outer_diameter" not in ds.coords:
        return
    diameter = ds["outer_diameter"].values[cable.segments]
    spans = np.stack([shape[:-1], shape[1:]], axis=1)[np.diff(cable.distance) > 0.0]  # joints have two nodes
    excess = (diameter - diameter.min()) / max(float(np.ptp(diameter)), 1e-9)
    thick = excess > 0.02
    widths = THIN + (THICK - THIN) * excess[thick]
    ax.add_collection(LineCollection(list(spans[thick]), colors=colour, linewidths=widths, capstyle="round", zorder=3))


def _mark_touchdown(ds: xr.Dataset, lines: list[int], ax: Axes, origin: np.ndarray, direction: np.ndarray) -> None:
    """Mark where cables meet the bed at time 0."""
    stiff = [id for cable in cables(ds) for id in cable.lines if id in lines]
    if not stiff:
        return
    history = ds["touchdown_position"].sel(line=stiff)
    spots = (history[0] if history.ndim == 3 else history).values
    spots = spots[np.isfinite(spots[:, 0])]
    if len(spots):
        x = (spots[:, :2] - origin) @ direction
        ax.plot(x, spots[:, 2], "^", color="black", markersize=5, zorder=4, label="touchdown")


def _plane(ds: xr.Dataset, lines: list[int]) -> tuple[np.ndarray, np.ndarray]:
    """Return a horizontal origin and unit vector: from the moving end to the end that is farthest from it.

    Where a mooring is held at one end only, or none, what floats is the moving end.
    """
    starts, ids = _starts(ds), ds["line"].values
    chosen = np.flatnonzero(np.isin(ids, lines))
    ends = {(int(k), end): starts[int(ids[k])][-1 if end else 0, :2] for end in (1, 0) for k in chosen}
    held = [ends[key] for key in held_ends(ds, lines)]
    if len(held) < 2:
        held = [_farthest(list(ends.values()), held[0] if held else ends[int(chosen[0]), 1]), *held, *ends.values()]
    span = _farthest(held, held[0]) - held[0]
    length = float(np.hypot(*span))
    return held[0], span / length if length > 0.0 else np.array([1.0, 0.0])


def _farthest(places: list[np.ndarray], place: np.ndarray) -> np.ndarray:
    return max(places, key=lambda other: float(np.hypot(*(other - place))))


def _shapes(ds: xr.Dataset, rows: np.ndarray) -> np.ndarray:
    """Return shapes of nodes (m, nodes, 3): the first, and at most `SHADOWS` later ones."""
    nodes = ds["node_position"].isel(node=rows)
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


def _finish(ds: xr.Dataset, ax: Axes, planes: list[Plane], end: str | None = None) -> Axes:
    """Draw the still water level and the seabed in the planes of the moorings, and label the axes."""
    floor = min(draw_sections(ds, planes, ax), ax.get_ylim()[0] / 1.06)  # axes that share their limits may be deeper
    ax.axhline(0.0, color=WATER, linewidth=1.2, zorder=1)
    ax.set_ylim(1.06 * floor, max(-0.08 * floor, ax.get_ylim()[1]))
    plain(ax)
    kinds = [*ds["end_a_kind"].values, *ds["end_b_kind"].values]
    end = end or ("fairlead" if any(kind.startswith("coupled") for kind in kinds) else "end")
    ax.set_xlabel(f"distance from the {end} (m)", fontsize=9)
    ax.set_ylabel("z (m)", fontsize=9)
    return ax
