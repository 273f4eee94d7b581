"""Labelled datasets, and the selection of one line from them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
import xarray as xr

from moorage.errors import Problem, ResultError
from moorage.results.bend_check import bend_attributes, has_limits
from moorage.results.columns import Layout
from moorage.results.index import DOF
from moorage.solve.blocks import Block
from moorage.variables import VARIABLES, attributes

OVER_TIME = ("friction_power", "dissipated_energy", "wave_elevation")  # nothing of them at rest


def to_dataset(layout: Layout, blocks: Iterable[Block], attrs: Mapping[str, object]) -> xr.Dataset:
    """Return the records of a run as a dataset; see `moorage.variables` for what is in it."""
    return join_columns(layout, [layout.columns(block) for block in blocks], attrs)


def join_columns(layout: Layout, parts: Sequence[Mapping[str, np.ndarray]], attrs: Mapping[str, object]) -> xr.Dataset:
    """Return a dataset of the columns of successive blocks."""
    times = [name for name in ("time", "node_time") if name in layout.names]
    values = {name: np.concatenate([part[name] for part in parts]) for name in layout.names}
    joined = {name: (layout.dims(name), values[name], layout.attributes(name)) for name in layout.names}
    coords = coordinates(layout) | {name: joined.pop(name) for name in times}
    return xr.Dataset(joined, coords, dict(attrs))


def coordinates(layout: Layout) -> dict[str, tuple]:
    """Return the coordinates of the rows as (dims, values, attributes)."""
    return {name: (VARIABLES[name].dims, values, attributes(name)) for name, values in layout.coordinates().items()}


def static_dataset(
    layout: Layout, block: Block, stiffness: np.ndarray, residual: float, iterations: int, attrs: Mapping[str, object]
) -> xr.Dataset:
    """Return the records of one instant, without time, with the stiffness (6, 6) and the verdict of the solver."""
    ds = to_dataset(layout, [block], attrs).isel(time=0, drop=True).drop_vars(OVER_TIME, errors="ignore")
    ds["stiffness"] = (("dof", "dof_"), stiffness, attributes("stiffness"))
    for name in ("dof", "dof_"):
        ds.coords[name] = ((name,), np.array(DOF, dtype=object), attributes(name))
    ds["residual"] = ((), residual, attributes("residual"))
    ds["iterations"] = ((), iterations, attributes("iterations"))
    ds.attrs |= bend_attributes(ds) if has_limits(layout) else {}
    return ds


def line(ds: xr.Dataset, id: int) -> xr.Dataset:
    """Return the part of a result that belongs to one line: its nodes, its segments and its end values.

    Examples
    --------
    >>> moorage.line(ds, 1)["node_position"].plot()  # doctest: +SKIP
    """
    if id not in ds["line"].values:
        known = ", ".join(map(str, ds["line"].values))
        raise ResultError(Problem(f"the result has no line {id}", f"its lines are {known}"))
    owners = {"node": "node_line", "segment": "segment_line"}
    return ds.sel(line=id).isel(
        {dim: np.flatnonzero(ds[owner].values == id) for dim, owner in owners.items() if dim in ds.dims}
    )
