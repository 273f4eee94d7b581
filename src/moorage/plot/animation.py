"""A run as a film: the mooring, coloured by tension, and the tensions at its fairleads over time."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, PillowWriter
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure

from moorage.errors import Problem, ResultError
from moorage.plot.style import QUIET, SEABED, WATER, new_figure
from moorage.plot.tension import plot_tension
from moorage.results.bed_level import bed_level
from moorage.results.sea import surface_elevation

Progress = Callable[[int, int], None]

WIDTH, HEIGHT, DPI = 9.6, 5.4, 100  # 960 x 540 pixels; video needs even numbers
TILT, TURN = np.radians(20.0), np.radians(-25.0)  # of the look at a mooring that spreads, and none at one in a plane
PLANAR = 0.02  # a mooring is in a plane when it is no wider than this part of its length
MARGIN = 0.06
STEEL, BODY = "#47525C", "#E8B54A"  # rods and bodies, as on the page of `moorage view`
GRID = 8  # lines of the seabed's grid along its longer side
FINE = 60  # places along each


def animate(
    ds: xr.Dataset,
    path: str | Path | None = None,
    *,
    speed: float = 5.0,
    fps: int = 15,
    progress: Progress | None = None,
) -> Path:
    """Write a film of a run.

    Parameters
    ----------
    ds : xarray.Dataset
        A run with histories of nodes.
    path : path, optional
        MP4, which needs ffmpeg, or GIF; by default the name of the result, MP4 where ffmpeg is installed.
    speed : float
        Seconds of the run in one second of the film.
    fps : int
        Pictures a second.
    progress : callable, optional
        Called after each picture with its number and that of all.

    Returns
    -------
    Path
        The film.

    Raises
    ------
    ResultError
        The result has no histories of nodes or no time, or the film cannot be written.
    """
    target = film_path(ds, path)
    writer = _writer(target, fps)
    _check(ds, speed, fps)
    film = Film(ds)
    time = ds[film.dim].values
    count = max(2, round((time[-1] - time[0]) / speed * fps) + 1)
    with writer.saving(film.figure, str(target), DPI):
        for k, t in enumerate(np.linspace(time[0], time[-1], count)):
            film.show(t)
            writer.grab_frame()
            if progress:
                progress(k + 1, count)
    return target


def film_path(ds: xr.Dataset, path: str | Path | None) -> Path:
    """Return where a film goes: by default beside the result, or under the name of its input."""
    if path is not None:
        return Path(path)
    source = Path(ds.encoding.get("source") or Path(str(ds.attrs.get("input_file", ""))).name or "mooring")
    return source.with_suffix(".mp4" if FFMpegWriter.isAvailable() else ".gif")


def _writer(path: Path, fps: int) -> AbstractMovieWriter:
    if path.suffix.lower() == ".gif":
        return PillowWriter(fps=fps)
    if path.suffix.lower() != ".mp4":
        raise ResultError(Problem("a film is an .mp4 or a .gif", "give a name that ends so", value=str(path)))
    if not FFMpegWriter.isAvailable():
        raise ResultError(
            Problem("MP4 needs the program ffmpeg, which is not found", "install ffmpeg, or give a name ending in .gif")
        )
    return FFMpegWriter(fps=fps, bitrate=2500)


def _check(ds: xr.Dataset, speed: float, fps: int) -> None:
    if not (speed > 0.0 and fps > 0):
        raise ResultError(Problem("speed and fps must be positive", "correct them", value=(speed, fps)))
    if not ds.sizes["line"]:
        raise ResultError(Problem("a result without lines has no film", "look at it with view"))
    if "node_position" not in ds:
        raise ResultError(Problem("the result has no histories of nodes", "run it again with --save all (save='all')"))
    if ds["node_position"].ndim < 3 or len(ds["node_position"]) < 2:
        raise ResultError(Problem("the result has no motion over time", "animate what `run` wrote"))


@dataclass(frozen=True)
class Look:
    """An orthographic look at a mooring: unit vectors (3,) to the right and up in the picture."""

    right: np.ndarray
    up: np.ndarray
    planar: bool

    def __call__(self, xyz: np.ndarray) -> np.ndarray:
        """Return places (..., 2) in the picture of places (..., 3), m."""
        return np.stack([xyz @ self.right, xyz @ self.up], axis=-1)


def look_at(nodes: np.ndarray) -> Look:
    """Return a look at nodes (n, 3): square to their plane, or down on a mooring that spreads."""
    flat = nodes[:, :2] - nodes[:, :2].mean(axis=0)
    _, size, ways = np.linalg.svd(flat, full_matrices=False)
    along = ways[0] * (1.0 if ways[0][np.argmax(np.abs(ways[0]))] > 0.0 else -1.0)
    planar = bool(size[-1] <= PLANAR * size[0]) if len(size) > 1 else True
    if planar:
        return Look(np.array([*along, 0.0]), np.array([0.0, 0.0, 1.0]), True)
    away = np.array([np.sin(TURN), np.cos(TURN)])  # horizontal, into the picture
    return Look(np.array([away[1], -away[0], 0.0]), np.array([*(np.sin(TILT) * away), np.cos(TILT)]), False)


class Film:
    """A figure that shows any instant of a run."""

    def __init__(self, ds: xr.Dataset):
        self.ds, self.dim = ds, str(ds["node_position"].dims[0])
        self.time = ds[self.dim].values
        self.nodes, self.tension = ds["node_position"], ds["segment_tension"]
        owner = ds["node_line"].values
        self.spans = np.flatnonzero(owner[1:] == owner[:-1])  # a segment follows these nodes
        shapes = self.nodes[:: max(1, len(self.time) // 100)].values
        self.look = look_at(shapes[0])
        self.figure: Figure = new_figure(WIDTH, HEIGHT)
        grid = self.figure.add_gridspec(2, 1, height_ratios=[2.6, 1.0])
        self.scene, below = self.figure.add_subplot(grid[0]), self.figure.add_subplot(grid[1])
        places = shapes.reshape(-1, 3)
        low, high = places.min(axis=0), places.max(axis=0)
        margin = MARGIN * float((high - low).max())
        self.low, self.high = low - margin, high + margin
        self.border = self._border()
        self.bottom = self._on_bed(*self.border.T)
        self._ground()
        self.sea = PolyCollection([], facecolors=WATER, edgecolors="none", alpha=0.22, zorder=2)
        values = self.tension.values / 1e3
        self.lines = LineCollection([], cmap="viridis", linewidths=2.2, zorder=3, capstyle="round")
        self.lines.set_clim(float(values.min()), max(float(values.max()), float(values.min()) + 1e-6))
        self.rods = LineCollection([], colors=STEEL, linewidths=4.0, zorder=4, capstyle="round")
        for artist in (self.sea, self.lines, self.rods):
            self.scene.add_collection(artist)
        (self.bodies,) = self.scene.plot([], [], "s", color=BODY, markeredgecolor=STEEL, markersize=7, zorder=5)
        bar = self.figure.colorbar(self.lines, ax=self.scene, shrink=0.8)
        bar.set_label("tension (kN)", fontsize=9)
        bar.ax.tick_params(labelsize=8)
        plot_tension(ds, below)
        self.cursor = below.axvline(self.time[0], color="black", linewidth=0.9)
        self._frame()
        self.show(self.time[0])
        self.figure.draw_without_rendering()
        self.figure.set_layout_engine("none")  # the layout of the first picture stays

    def show(self, t: float) -> None:
        """Show the instant t (s), between those that were saved."""
        k = int(np.clip(np.searchsorted(self.time, t, side="right") - 1, 0, len(self.time) - 2))
        share = float(np.clip((t - self.time[k]) / (self.time[k + 1] - self.time[k]), 0.0, 1.0))
        nodes, tension = (a[k].values + share * (a[k + 1].values - a[k].values) for a in (self.nodes, self.tension))
        places = self.look(nodes)
        self.lines.set_segments(list(np.stack([places[self.spans], places[self.spans + 1]], axis=1)))
        self.lines.set_array(tension / 1e3)
        self.rods.set_segments(list(self.look(self._at("rod_position", t))))
        self.bodies.set_data(*self.look(self._at("body_position", t)).T)
        self._sea(t)
        self.cursor.set_xdata([t, t])
        self.scene.set_title(f"{self.ds.attrs.get('title', '')}\nt = {t:.1f} s", fontsize=9, loc="left")

    def _at(self, name: str, t: float) -> np.ndarray:
        """Return where rods (n, 2, 3) or bodies (n, 3) are at an instant; none when there are none."""
        if name not in self.ds:
            return np.empty((0, 2, 3)) if name == "rod_position" else np.empty((0, 3))
        now, values = self.ds["time"].values, self.ds[name]
        k = int(np.clip(np.searchsorted(now, t, side="right") - 1, 0, len(now) - 2))
        share = float(np.clip((t - now[k]) / (now[k + 1] - now[k]), 0.0, 1.0))
        return values[k].values + share * (values[k + 1].values - values[k].values)

    def _sea(self, t: float) -> None:
        """Draw the surface of the water, or its section down to the seabed."""
        level = surface_elevation(self.ds, t, *self.border.T)
        outline = self.look(np.column_stack([self.border, level]))
        self.sea.set_verts([np.concatenate([outline, self.bottom[::-1]]) if self.look.planar else outline])

    def _border(self) -> np.ndarray:
        """Return places (n, 2) at the edge of the drawn sea, or along the plane of a planar mooring."""
        if self.look.planar:
            middle = 0.5 * (self.low + self.high)[:2]
            reach = 0.5 * float(np.hypot(*(self.high - self.low)[:2]))
            return middle + np.linspace(-reach, reach, 2 * FINE)[:, None] * self.look.right[:2]
        (x0, y0), (x1, y1) = self.low[:2], self.high[:2]
        corners = np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1], [x0, y0]])
        s = np.linspace(0.0, 1.0, FINE)[:, None]
        return np.concatenate([a + s * (b - a) for a, b in pairwise(corners)])

    def _ground(self) -> None:
        """Draw the seabed: its section with the plane of the mooring, or a grid of round distances on it."""
        if self.look.planar:
            self.scene.add_collection(LineCollection([self.bottom], colors=SEABED, linewidths=1.4, zorder=1))
            return
        (x0, y0), (x1, y1) = self.low[:2], self.high[:2]
        step = float(f"{max(x1 - x0, y1 - y0) / GRID:.0e}")
        x, y = (np.unique([a, *np.arange(np.ceil(a / step), b / step) * step, b]) for a, b in ((x0, x1), (y0, y1)))
        along_x, along_y = np.linspace(x0, x1, FINE), np.linspace(y0, y1, FINE)
        rows = [self._on_bed(np.full(FINE, v), along_y) for v in x]
        rows += [self._on_bed(along_x, np.full(FINE, v)) for v in y]
        self.scene.add_collection(LineCollection(rows, colors=SEABED, linewidths=0.6, alpha=0.6, zorder=1))
        words = f"grid on the seabed: {step:g} m"
        self.scene.text(0.0, 0.0, words, transform=self.scene.transAxes, fontsize=8, color=QUIET)

    def _on_bed(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return places on the seabed in the picture, (n, 2)."""
        return self.look(np.column_stack([x, y, bed_level(self.ds, x, y)]))

    def _frame(self) -> None:
        """Set what the axes show: the water over the seabed."""
        ax: Axes = self.scene
        ax.set_aspect("equal", adjustable="datalim")
        surface = self.look(np.column_stack([self.border, np.zeros(len(self.border))]))
        ax.update_datalim(np.concatenate([surface, self.bottom]))
        ax.autoscale_view()
        ax.tick_params(labelsize=8)
        ax.spines[["top", "right"]].set_visible(False)
        if self.look.planar:
            ax.set_xlabel("along the mooring (m)", fontsize=9)
            ax.set_ylabel("z (m)", fontsize=9)
        else:
            ax.set_axis_off()
