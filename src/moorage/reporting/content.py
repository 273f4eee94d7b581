"""What a report of a run says: what was simulated, in what surroundings, what came out, and what to doubt."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from math import degrees, isfinite
from typing import NamedTuple

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from moorage.errors import ModelWarning, MoorageError
from moorage.plot import picture, result_figure
from moorage.results import (
    Cable,
    cables,
    envelope,
    has_static_tensions,
    line_summaries,
    lines_off_the_grid,
    object_summaries,
    seabed_reports,
    warn_of_lines_off_the_grid,
    warn_of_overloads,
    warn_of_tight_bends,
)
from moorage.results.cables import end_value
from moorage.words import sea_words

PICTURES = {
    "envelope": "Lowest, mean and highest tension along the lines",
    "spectrum": "Spectra of the fairlead tensions",
    "map": "From above, with the depth of the water",
}


class Doubts(NamedTuple):
    """What a reader should know before the numbers are used."""

    texts: Sequence[str]


class Facts(NamedTuple):
    """Names and what is said of each."""

    rows: Mapping[str, str]


class Table(NamedTuple):
    """A table under a caption."""

    caption: str
    names: Sequence[str]
    rows: Sequence[Sequence[str]]


Block = Doubts | Facts | Table


def sections(ds: xr.Dataset) -> dict[str, list[Block]]:
    """Return what a report says of a run, by the titles of its sections; one of nothing is left out."""
    found = doubts(ds)
    parts: dict[str, list[Block]] = {
        "Warnings": [Doubts(found)] if found else [],
        "Run": [_facts(_run(ds.attrs))],
        "Environment": [_facts(_environment(ds.attrs))],
        "Model": [_facts(_model(ds)), *_lines(ds)],
        "Tensions": [*_tensions(ds)],
        "Turbines": [*_turbines(ds)],
        "Seabed": [*_seabed(ds)],
        "Cables": [*_cables(ds)],
        "Bodies and rods": [*_objects(ds)],
    }
    return {title: blocks for title, blocks in parts.items() if blocks}


def doubts(ds: xr.Dataset) -> list[str]:
    """Return what a reader of the numbers of a run should know before they are used."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        warn_of_tight_bends(ds)
        warn_of_overloads(ds)
        warn_of_lines_off_the_grid(lines_off_the_grid(ds))
    texts = [str(w.message) for w in caught if issubclass(w.category, ModelWarning)]
    status = str(ds.attrs["status"])
    if status != "complete":
        last, asked = float(ds["time"][-1]), float(ds.attrs["duration"])
        texts.insert(0, f"the run is not complete: status {status}, {last:g} s of {asked:g} s")
    slack = [str(row.line) for row in line_summaries(ds) if row.lowest_tension <= 0.0]
    if slack:
        texts.append(f"lines that went slack: {', '.join(slack)}")
    return texts


def _run(attrs: Mapping[str, object]) -> dict[str, str]:
    step = attrs["time_step"]
    stepping = f"tolerance {attrs['tolerance']:g} m" if step == "adaptive" else f"step {step:g} s"
    counts = f": {attrs['steps']} steps, {attrs['rejected']} rejected" if "steps" in attrs else ""
    return {
        "input": f"{attrs['input_file'] or 'made in Python'} ({attrs['input_format']})",
        "SHA-256 of the input": str(attrs["input_sha256"]) if attrs["input"] else "",
        "motion": str(attrs["motion"]),
        "time": f"{attrs['duration']:g} s, results every {attrs['dt_out']:g} s, start {attrs['start']}",
        "method": f"{attrs['method']}, {stepping}{counts}",
        "status": str(attrs["status"]),
        "moorage": f"{attrs['moorage_version']}, {attrs['date']}",
        "options that are not used": str(attrs.get("unused_options", "")),
    }


def _environment(attrs: Mapping[str, object]) -> dict[str, str]:
    return {
        "water": f"depth {attrs['water_depth']:g} m, density {attrs['water_density']:g} kg/m3",
        "gravity": f"{attrs['gravity']:g} m/s2",
        "waves": sea_words(attrs),
        "current": str(attrs.get("current", "")),
        "seabed": str(attrs.get("bathymetry", "")),
        "soil": str(attrs.get("soil", "")),
        "friction": str(attrs.get("friction", "")),
        "friction in statics": str(attrs.get("friction_in_statics", "")),
    }


def _model(ds: xr.Dataset) -> dict[str, str]:
    kinds = [str(kind) for kind in ds["point_kind"].values]
    counts = ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds))
    return {
        "points": f"{len(kinds)} ({counts})",
        "rods": str(ds.sizes.get("rod", "") or ""),
        "bodies": str(ds.sizes.get("body", "") or ""),
        "turbines": str(ds.sizes.get("turbine", "") or ""),
        "comes off": str(ds.attrs.get("failures", "")),
    }


def _lines(ds: xr.Dataset) -> list[Table]:
    if "segment_line" not in ds.coords:
        return []
    owner, length = ds["segment_line"].values, ds["unstretched_length"].values
    lengths = {int(id): f"{length[owner == id].sum():.6g}" for id in ds["line"].values}
    if "line_length" in ds:  # of lines on winches
        first, last = ds["line_length"][0].values, ds["line_length"][-1].values
        lengths = {
            int(id): f"{a:.6g}" if a == b else f"{a:.6g} to {b:.6g}"
            for id, a, b in zip(ds["line"].values, first, last, strict=True)
        }
    rows = [
        (str(int(id)), lengths[int(id)], str(int((owner == id).sum())), str(a), str(b))
        for id, a, b in zip(ds["line"].values, ds["end_a_kind"].values, ds["end_b_kind"].values, strict=True)
    ]
    return [Table("Lines", ("line", "length (m)", "segments", "end A", "end B"), rows)]


def _tensions(ds: xr.Dataset) -> list[Table]:
    first = "static" if has_static_tensions(ds) else "at 0 s"
    summaries = line_summaries(ds)
    of_ends = [
        (str(row.line), end, *(f"{v / 1e3:.1f}" for v in summary))
        for row in summaries
        for end, summary in (("fairlead", row.fairlead), ("anchor", row.anchor))
    ]
    of_lines = [
        (str(row.line), f"{row.lowest_tension / 1e3:.1f}", f"{degrees(row.uplift):.1f}", f"{row.grounded:.1f}")
        for row in summaries
    ]
    names = ("line", "end", first, "min", "mean", "max", "std")
    rest = ("line", "lowest tension (kN)", "largest uplift at end A (deg)", "shortest grounded length (m)")
    return [Table("Tension at the ends (kN)", names, of_ends), Table("In the lines", rest, of_lines)]


def _turbines(ds: xr.Dataset) -> list[Table]:
    """Return how far each turbine went, and the largest load of the mooring on it."""
    if "turbine_force" not in ds:
        return []
    rows = []
    for k, id in enumerate(ds["turbine"].values):
        places, turns, force = (ds[f"turbine_{name}"].values[:, k] for name in ("position", "rotation", "force"))
        away = np.linalg.norm(places[:, :2] - places[0, :2], axis=1).max()
        level, down = np.linalg.norm(force[:, :2], axis=1).max() / 1e3, -force[:, 2].min() / 1e3
        start = ", ".join(f"{x:g}" for x in places[0])
        numbers = (f"{away:.2f}", f"{np.degrees(abs(turns)).max():.2f}", f"{level:.1f}", f"{down:.1f}")
        rows.append((f"{id} {ds['turbine_name'].values[k]}".rstrip(), start, *numbers))
    names = ("turbine", "x, y, z at 0 s (m)", "offset (m)", "angle (deg)", "horizontal (kN)", "downward (kN)")
    return [Table("Largest offset and angle, and largest force of the mooring", names, rows)]


def _seabed(ds: xr.Dataset) -> list[Table]:
    names = ("line", "x", "y", "z", "at rest", "least", "largest", "uplift (kN)", "friction (kJ)")
    rows = [
        (
            str(r.line),
            *(_number(v, 1) for v in (*r.touchdown_position, *r.touchdown_arc_length)),
            _number(r.uplift_force / 1e3, 2),
            _number(r.dissipated_energy / 1e3, 2),
        )
        for r in seabed_reports(ds)
    ]
    caption = "Touchdown, its arc length from end A (m), largest uplift force at end A, energy of friction"
    return [Table(caption, names, rows)] if rows else []


def _cables(ds: xr.Dataset) -> list[Table]:
    """Return the largest tension at the hang-off and the tightest bend of every cable during the run."""
    if "curvature" not in ds:
        return []
    names = (
        "lines",
        "hang-off tension (kN)",
        "curvature (1/m)",
        "bend radius (m)",
        "from the hang-off (m)",
        "allowed (m)",
    )
    highest = envelope(ds, "curvature")["maximum"].values
    rows = [_cable(ds, cable, highest[cable.nodes]) for cable in cables(ds)]
    return [Table("Largest during the run", names, rows)]


def _objects(ds: xr.Dataset) -> list[Table]:
    names = ("", "", "start", "end", "lowest", "highest")
    rows = [
        (r.name, f"{r.coordinate} ({r.unit})", *(_number(v, 2) for v in (r.start, r.end, r.lowest, r.highest)))
        for r in object_summaries(ds)
    ]
    return [Table("Where they were", names, rows)] if rows else []


def _cable(ds: xr.Dataset, cable: Cable, curvature: np.ndarray) -> tuple[str, ...]:
    tension = float(end_value(ds, "tension", cable.hang_off).max())
    k = int(np.nanargmax(curvature))
    allowed = float(ds["allowed_bend_radius"].values[cable.nodes][k]) if "allowed_bend_radius" in ds.coords else 0.0
    return (
        ", ".join(map(str, cable.lines)),
        f"{tension / 1e3:.1f}",
        f"{curvature[k]:.4f}",
        f"{1.0 / max(curvature[k], 1e-12):.2f}",
        f"{cable.distance[k]:.1f}",
        f"{allowed:g}" if allowed > 0.0 else "-",
    )


def figures(ds: xr.Dataset) -> Iterator[tuple[str, Figure | str]]:
    """Yield captions and figures of a run, or why one is not drawn."""
    drawn: dict[str, Callable[[], Figure]] = {"Over time, from the side, along cables": lambda: result_figure(ds)}
    drawn |= {caption: (lambda what=what: picture(ds, what)) for what, caption in PICTURES.items()}  # type: ignore[misc]
    for caption, draw in drawn.items():
        try:
            yield caption, draw()
        except MoorageError as error:
            yield caption, str(error)


def _facts(facts: Mapping[str, str]) -> Facts:
    return Facts({name: value for name, value in facts.items() if value})


def _number(value: float, digits: int) -> str:
    return f"{round(value, digits) + 0.0:.{digits}f}" if isfinite(value) else "-"  # + 0.0: no "-0.00"
