"""What a page shows, from a result: a description in plain words and numbers, and tables over time."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import xarray as xr

from moorage.errors import Problem, ResultError
from moorage.model import Model
from moorage.viewer.ground import ground, origin_of, region_of
from moorage.viewer.markers import bodies, line_reach, markers, platforms, rods
from moorage.viewer.quantities import count, line_starts, quantities
from moorage.viewer.times import end_tensions, node_dim, shown_frames, with_time
from moorage.viewer.water import sea


@dataclass(frozen=True)
class Scene:
    """A page without its program.

    Attributes
    ----------
    meta : dict
        What JSON can hold: names, units, the ranges of colours, the sea.
    arrays : dict of (rows, columns) arrays
        `position` (frames, 3 nodes), `markers` (frames, 3 markers), `rods` (frames, 6 rods),
        `bodies` (frames, 6 bodies), with x and y from the `origin` of `meta`; a table (frames, nodes) of each quantity,
        `bed` (places, 1) and `history` (rows, 2 lines).
    """

    meta: dict
    arrays: dict[str, np.ndarray]


def scene_of(result: xr.Dataset, model: Model | None = None) -> Scene:
    """Return the scene of a result; `model` adds the rods of a model that its static solution does not hold."""
    if "node_position" not in result:
        remedy = "run it again with --save all (save='all' in Python), which is the default"
        raise ResultError(Problem("the result has no histories of nodes: there is no shape to show", remedy))
    ds = with_time(result)
    whole = ds[node_dim(ds)].values
    if not len(whole):
        raise ResultError(Problem("the result holds no instant", "run it for longer"))
    if not any(ds.sizes.get(thing) for thing in ("node", "point", "rod", "body")):
        raise ResultError(Problem("the result holds no lines, points, rods or bodies", "give one that does"))
    frames, thinned = shown_frames(whole, (3 + count(ds)) * ds.sizes["node"] + 3 * ds.sizes["point"])
    time, position, starts = whole[frames], ds["node_position"][frames].values, line_starts(ds)
    colours = quantities(ds, frames, position)
    places, labels = markers(ds, position, time)
    rod_ends, rod_names = rods(ds, model, time)
    body_places, body_names = bodies(ds, time)
    seen = known([position, places, rod_ends, body_places, *(q.values for q in colours)])
    time, position, places, rod_ends, body_places = (v[seen] for v in (time, position, places, rod_ends, body_places))
    colours = [replace(q, values=q.values[seen]) for q in colours]
    unknown = f"{(~seen).sum()} of {len(seen)} instants hold values that are not numbers, and are left out."
    unknown = "" if seen.all() else unknown
    shown = np.concatenate([position, places, rod_ends, body_places[..., :3]], axis=1)
    region = region_of(shown)
    bed, level, beyond = ground(ds, region)
    origin = origin_of(region)
    for table in (position, places, rod_ends, body_places, shown):
        table[..., :2] -= origin
    water, short = sea(ds, region, origin)
    past_time, past = end_tensions(ds)
    tables = {"position": position, "markers": places, "rods": rod_ends, "bodies": body_places}
    arrays = {name: table.reshape(len(time), -1) for name, table in tables.items()}
    arrays |= {q.key: q.values for q in colours} | {"bed": level, "history": past}
    notes = (cut_short(ds), come_off(ds), thinned, unknown, beyond, short)
    meta = {
        "title": str(ds.attrs.get("title") or "Mooring"),
        "source": Path(str(ds.attrs.get("input_file", ""))).name,
        "version": str(ds.attrs.get("moorage_version", "")),
        "date": str(ds.attrs.get("date", ""))[:10],
        "notes": [text for text in notes if text],
        "moving": len(time) > 1,
        "time": _numbers(time),
        "depth": float(ds.attrs["water_depth"]),
        "origin": origin.tolist(),
        "region": _numbers(region - np.tile(origin, 2)),
        "low": _numbers(shown.min(axis=(0, 1))),
        "high": _numbers(shown.max(axis=(0, 1))),
        "lines": _lines(ds, starts),
        "quantities": [q.words for q in colours],
        "markers": labels,
        "platforms": platforms(places[0], labels, line_reach(position[0], starts)),
        "rods": rod_names,
        "bodies": body_names,
        "bed": bed,
        "sea": water,
        "historyTime": _numbers(past_time),
    }
    return Scene(meta, arrays)


def cut_short(ds: xr.Dataset) -> str:
    """Return a note on a run that did not come to its end, empty for others."""
    status = str(ds.attrs.get("status", "complete"))
    if status == "complete" or "duration" not in ds.attrs:
        return ""
    how = "killed" if status == "running" else status
    return f"The run is not complete: {how}; {float(ds['time'][-1]):g} s of {float(ds.attrs['duration']):g} s are here."


def come_off(ds: xr.Dataset) -> str:
    """Return a note on lines that come off during a run, empty when none do."""
    failures = str(ds.attrs.get("failures", ""))
    return f"Comes off: {failures}." if failures and ds.sizes["time"] > 1 else ""


def known(tables: list[np.ndarray]) -> np.ndarray:
    """Return at which of the instants (n,) all numbers of tables (n, ...) are numbers."""
    good = np.ones(len(tables[0]), bool)
    for table in tables:
        good &= np.isfinite(table.reshape(len(table), -1)).all(axis=1)
    if not good.any():
        remedy = "leave out what is not known, for instance with isel and dropna"
        raise ResultError(Problem("at no instant are all positions and tensions numbers", remedy))
    return good


def _lines(ds: xr.Dataset, starts: np.ndarray) -> list[dict]:
    """Return for every line its name, its rows of nodes, their arc lengths (m), and what the ends are called."""
    arc, stops = ds["arc_length"].values, np.append(starts, ds.sizes["node"])[1:]
    names = ds["line_name"].values if "line_name" in ds.coords else [""] * len(starts)
    return [
        {
            "name": f"line {int(id)}" + (f": {name}" if name and str(name) != str(id) else ""),
            "first": int(a),
            "last": int(b) - 1,
            "arc": _numbers(arc[a:b]),
            "ends": [f"{ds[f'{end}_kind'].values[k]} {int(ds[end].values[k])}" for end in ("end_a", "end_b")],
        }
        for k, (id, name, a, b) in enumerate(zip(ds["line"].values, names, starts, stops, strict=True))
    ]


def _numbers(values: np.ndarray) -> list[float]:
    """Return numbers with the digits that matter on a page."""
    return [float(f"{v:.7g}") for v in values]
