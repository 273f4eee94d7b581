"""Results as VTK files for ParaView: lines, points, rods and the seabed, a file of each an instant, and one series."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import xarray as xr

from moorage.errors import Problem, ResultError
from moorage.results.vtk_file import collection, polydata

SERIES = "mooring.pvd"
PLACES = ("node_position", "point_position", "rod_position", "body_position")
MARGIN = 0.1  # of the extent of the nodes, around a flat seabed
AT_NODES = ("curvature", "bending_moment", "seabed_gap", "node_velocity")  # with nodes, and where a result has them


def write_vtk(ds: xr.Dataset, folder: str | Path, every: int = 1) -> Path:
    """Write a result as `.vtp` files with a `.pvd` series that ParaView opens; return the series.

    Lines are polylines with tension (mean of the neighbour segments), arc length, velocity and, of cables, curvature
    and bending moment; points have their force; rods are lines from end A to end B. The seabed is one file.

    Parameters
    ----------
    every : int
        Write each so many instants of the node histories.
    """
    if "node_position" not in ds:
        raise ResultError(
            Problem(
                "the result has no node histories", "run it with save='all' (--save all)", value=ds.attrs.get("title")
            )
        )
    time = "node_time" if "node_time" in ds.dims else "time"
    if time not in ds.dims:
        ds = ds.expand_dims(time=[0.0])
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "seabed.vtp").write_text(seabed_file(ds))
    files: list[tuple[float, str, Path]] = []
    for k in range(0, ds.sizes[time], every):
        t = float(ds[time][k])
        files.append((t, "seabed", Path("seabed.vtp")))
        at = ds.isel({time: k})
        now = at if time == "time" else at.sel(time=t, method="nearest")
        for name, text in instant(at, now):
            file = f"{name}_{k:06d}.vtp"
            (folder / file).write_text(text)
            files.append((t, name, Path(file)))
    series = folder / SERIES
    series.write_text(collection(files))
    return series


def instant(nodes: xr.Dataset, now: xr.Dataset) -> Iterator[tuple[str, str]]:
    """Yield name and text of the files of one instant: of nodes, and of what is recorded more often."""
    yield "lines", lines_file(nodes)
    yield "points", points_file(now)
    if "rod_position" in now:
        yield "rods", rods_file(now)


def lines_file(ds: xr.Dataset) -> str:
    """Return the lines at one instant."""
    owner = ds["node_line"].values
    cells = [np.flatnonzero(owner == id) for id in ds["line"].values]
    data = {
        "tension": (node_tensions(ds["segment_tension"].values, cells), "N"),
        "arc_length": (ds["arc_length"].values, "m"),
        "line": (owner.astype(np.int64), ""),
    }
    data |= {name: (ds[name].values, str(ds[name].attrs["units"])) for name in AT_NODES if name in ds}
    return polydata(ds["node_position"].values, {"Lines": cells}, data)


def node_tensions(tension: np.ndarray, cells: list[np.ndarray]) -> np.ndarray:
    """Return the mean tensions (nodes,) of the segments (segments,) on either side; at ends that of the one there."""
    out = np.zeros(sum(map(len, cells)))
    for k, cell in enumerate(cells):
        T = tension[cell[:-1] - k]  # lines before have one segment less than nodes each
        out[cell] = 0.5 * (np.concatenate([T[:1], T]) + np.concatenate([T, T[-1:]]))
    return out


def points_file(ds: xr.Dataset) -> str:
    """Return the points at one instant, with the force of their lines."""
    r = ds["point_position"].values
    data = {"force": (ds["point_force"].values, "N"), "point": (ds["point"].values.astype(np.int64), "")}
    return polydata(r, {"Verts": [np.array([k]) for k in range(len(r))]}, data)


def rods_file(ds: xr.Dataset) -> str:
    """Return the rods at one instant, from end A to end B."""
    r = ds["rod_position"].values
    cells = [np.array([2 * k, 2 * k + 1]) for k in range(len(r))]
    ids = ds["rod"].values.astype(np.int64) if "rod" in ds else np.arange(1, len(r) + 1)
    return polydata(r.reshape(-1, 3), {"Lines": cells}, {}, {"rod": (ids, "")})


def seabed_file(ds: xr.Dataset) -> str:
    """Return the seabed: its depth grid, or a flat rectangle under the nodes."""
    if "bed_level" in ds:
        x, y, z = ds["bed_x"].values, ds["bed_y"].values, ds["bed_level"].values
    else:
        r = np.concatenate([ds[name].values.reshape(-1, 3) for name in PLACES if name in ds])
        low, high = np.nanmin(r[:, :2], axis=0), np.nanmax(r[:, :2], axis=0)
        reach = MARGIN * max(float((high - low).max()), 1.0)
        x, y = (np.array([a - reach, b + reach]) for a, b in zip(low, high, strict=True))
        z = np.full((2, 2), -float(ds.attrs.get("water_depth", -np.nanmin(r[:, 2]))))
    grid = np.stack([*np.meshgrid(x, y, indexing="ij"), z], axis=-1).reshape(-1, 3)
    first = (np.arange(len(x) - 1)[:, None] * len(y) + np.arange(len(y) - 1)).ravel()
    cells = list(first[:, None] + np.array([0, len(y), len(y) + 1, 1]))
    return polydata(grid, {"Polys": cells}, {"depth": (-grid[:, 2], "m")})
