"""A run on one page for people: what was simulated, in what surroundings, what came out, and what to doubt."""

from __future__ import annotations

import base64
import io
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from html import escape
from math import degrees, isfinite
from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from moorage.errors import ModelWarning, MoorageError, Problem, ResultError
from moorage.plot import picture, result_figure
from moorage.results import (
    Cable,
    cables,
    envelope,
    has_static_tensions,
    line_summaries,
    open_result,
    seabed_reports,
    warn_of_lines_off_the_grid,
    warn_of_tight_bends,
)
from moorage.results.cables import end_value
from moorage.words import sea_words

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #22262a; max-width: 60rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.6rem } h2 { font-size: 1.15rem; margin-top: 2rem }
table { border-collapse: collapse; margin: .5rem 0 1rem } caption { text-align: left; color: #5a626a }
th, td { padding: .15rem .8rem .15rem 0; text-align: right; border-bottom: 1px solid #e3e5e8 }
th { font-weight: 600 } .facts th, .facts td, td:first-child, th:first-child { text-align: left }
img { max-width: 100% } pre { background: #f5f6f7; padding: .8rem; overflow: auto; font-size: 12px }
.doubt { border-left: 4px solid #d55e00; padding: .2rem .8rem; margin: .5rem 0; white-space: pre-wrap }
@media print { details { display: none } figure, table { break-inside: avoid } }
"""
PICTURES = {
    "envelope": "Lowest, mean and highest tension along the lines",
    "spectrum": "Spectra of the fairlead tensions",
    "map": "From above, with the depth of the water",
}


def report(source: xr.Dataset | str | Path, path: str | Path | None = None) -> Path:
    """Write one HTML page about a run, which needs nothing else and can be printed.

    Parameters
    ----------
    source : xarray.Dataset or path
        What a run returned or wrote.
    path : path, optional
        Where to write; by default beside the result, ending in `-report.html`.

    Returns
    -------
    Path
        The page.

    Raises
    ------
    ResultError
        It is no run, or the page cannot be written.
    """
    ds = source if isinstance(source, xr.Dataset) else open_result(source)
    if "time" not in ds["fairlead_tension"].dims:
        raise ResultError(Problem("a report is about a run, and this is a static solution", "take a result of `run`"))
    beside = Path(ds.encoding.get("source") or Path(str(ds.attrs.get("input_file", ""))).name or "mooring")
    target = beside.with_name(f"{beside.stem}-report.html") if path is None else Path(path)
    try:
        target.write_text(report_page(ds), "utf-8")
    except OSError as error:
        why = error.strerror or error
        raise ResultError(Problem(f"cannot write {target}: {why}", "give another file (-o)")) from error
    return target


def report_page(ds: xr.Dataset) -> str:
    """Return the report of a run as HTML."""
    title = escape(str(ds.attrs["title"]))
    parts = [
        f"<h1>{title}</h1>",
        _section("Warnings", "".join(f'<p class="doubt">{escape(text)}</p>' for text in doubts(ds))),
        _section("Run", _facts(_run(ds.attrs))),
        _section("Environment", _facts(_environment(ds.attrs))),
        _section("Model", _facts(_model(ds)) + _lines(ds)),
        _section("Tensions", _tensions(ds)),
        _section("Seabed", _seabed(ds)),
        _section("Cables", _cables(ds)),
        _section("Figures", "".join(_figures(ds))),
        _input(ds.attrs),
    ]
    head = f'<meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>{title}</title>'
    body = "\n".join(filter(None, parts))
    return (
        f'<!doctype html>\n<html lang="en"><head>{head}<style>{STYLE}</style></head>\n<body>\n{body}\n</body></html>\n'
    )


def doubts(ds: xr.Dataset) -> list[str]:
    """Return what a reader of the numbers of a run should know before they are used."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        warn_of_tight_bends(ds)
        warn_of_lines_off_the_grid(ds)
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
        "friction in statics": str(attrs.get("friction_in_statics", "")),
    }


def _model(ds: xr.Dataset) -> dict[str, str]:
    kinds = [str(kind) for kind in ds["point_kind"].values]
    counts = ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds))
    return {
        "points": f"{len(kinds)} ({counts})",
        "rods": str(ds.sizes.get("rod", "") or ""),
        "bodies": str(ds.sizes.get("body", "") or ""),
    }


def _lines(ds: xr.Dataset) -> str:
    if "segment_line" not in ds.coords:
        return ""
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
    return _table("Lines", ("line", "length (m)", "segments", "end A", "end B"), rows)


def _tensions(ds: xr.Dataset) -> str:
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
    return _table("Tension at the ends (kN)", names, of_ends) + _table("In the lines", rest, of_lines)


def _seabed(ds: xr.Dataset) -> str:
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
    return _table(caption, names, rows)


def _cables(ds: xr.Dataset) -> str:
    """Return the largest tension at the hang-off and the tightest bend of every cable during the run."""
    if "curvature" not in ds:
        return ""
    names = (
        "lines",
        "hang-off tension (kN)",
        "curvature (1/m)",
        "bend radius (m)",
        "from the hang-off (m)",
        "allowed (m)",
    )
    highest = envelope(ds, "curvature")["maximum"].values
    return _table("Largest during the run", names, [_cable(ds, cable, highest[cable.nodes]) for cable in cables(ds)])


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


def _figures(ds: xr.Dataset) -> Iterable[str]:
    drawn: dict[str, Callable[[], Figure]] = {"Over time, from the side, along cables": lambda: result_figure(ds)}
    drawn |= {caption: (lambda what=what: picture(ds, what)) for what, caption in PICTURES.items()}  # type: ignore[misc]
    for caption, draw in drawn.items():
        try:
            yield _figure(draw(), caption)
        except MoorageError as error:
            yield f"<p>{escape(caption)}: not drawn, {escape(str(error))}</p>"


def _figure(figure: Figure, caption: str) -> str:
    """Return a figure as PNG in the page: lines of long runs would be megabytes as SVG."""
    with io.BytesIO() as buffer:
        figure.savefig(buffer, format="png", bbox_inches="tight")
        data = base64.b64encode(buffer.getvalue()).decode()
    words = escape(caption)
    return f'<figure><img alt="{words}" src="data:image/png;base64,{data}"><figcaption>{words}</figcaption></figure>'


def _input(attrs: Mapping[str, object]) -> str:
    text = escape(str(attrs["input"]))
    return f"<details><summary>Input</summary><pre>{text}</pre></details>" if text else ""


def _section(title: str, body: str) -> str:
    return f"<h2>{title}</h2>\n{body}" if body else ""


def _facts(facts: Mapping[str, str]) -> str:
    rows = "".join(f"<tr><th>{escape(k)}</th><td>{escape(v)}</td></tr>" for k, v in facts.items() if v)
    return f'<table class="facts">{rows}</table>'


def _table(caption: str, names: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    if not rows:
        return ""
    head = "".join(f"<th>{escape(name)}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><caption>{escape(caption)}</caption><tr>{head}</tr>{body}</table>"


def _number(value: float, digits: int) -> str:
    return f"{value:.{digits}f}" if isfinite(value) else "-"
