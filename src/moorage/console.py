"""What a terminal shows: tables, the progress bar and messages. Takes plain rows and datasets, computes nothing."""

from __future__ import annotations

import os
import sys
import warnings
import webbrowser
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from math import degrees, isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from moorage.errors import ModelWarning
from moorage.words import current_words, sea_words, seabed_words, turbine_words

if TYPE_CHECKING:  # xarray is heavy, and --help must be light
    import xarray as xr

    from moorage.model import Model
    from moorage.results import CableReport, LineSummary, ObjectSummary, SeabedReport

out, err = Console(highlight=False), Console(stderr=True, highlight=False)


def say(text: object, style: str = "") -> None:
    """Print a message for people on stderr, as it is."""
    err.print(str(text), style=style, markup=False, soft_wrap=True)


def show_warning(message, category, filename, lineno, file=None, line=None) -> None:
    """Print warnings of the model as one readable line, others as Python does."""
    if issubclass(category, ModelWarning):
        say(f"warning: {message}", "yellow")
    else:
        say(warnings.formatwarning(message, category, filename, lineno, line).strip())


@contextmanager
def progress_bar() -> Iterator:
    """Give a function (time, duration, wall time) that moves a bar with time, speed and what remains."""
    columns = (
        TextColumn("{task.completed:8.1f} of {task.total:g} s"),
        BarColumn(),
        TextColumn("{task.fields[speed]} x real time"),
        TimeRemainingColumn(compact=True),
    )
    with Progress(*columns, console=err) as bar:
        task = bar.add_task("run", total=None, visible=False, speed="")

        def move(time: float, duration: float, wall: float) -> None:
            ratio = time / max(wall, 1e-9)
            speed = f"{ratio:.0f}" if ratio > 10.0 else f"{ratio:.2g}"
            bar.update(task, completed=time, total=duration, speed=speed, visible=True)

        yield move


@contextmanager
def work_bar(what: str) -> Iterator:
    """Give a function (done, all) that moves a bar."""
    with Progress(TextColumn("{task.completed} of {task.total} " + what), BarColumn(), console=err) as bar:
        task = bar.add_task(what, total=None, visible=False)
        yield lambda done, total: bar.update(task, completed=done, total=total, visible=True)


def open_page(path: Path) -> bool:
    """Open a page in the browser of a desktop; return whether there is one."""
    if sys.platform.startswith("linux") and not {"DISPLAY", "WAYLAND_DISPLAY"} & {*os.environ}:
        return False
    return webbrowser.open(path.resolve().as_uri())


def problem_list(title: str, problems: Sequence[object], style: str = "bold") -> None:
    """Print problems under a title; nothing where there are none."""
    if problems:
        out.print(f"\n{title}", style=style)
    for problem in problems:
        out.print(str(problem), markup=False, soft_wrap=True)


def run_summary(attrs: Mapping[str, Any]) -> None:
    """Print where a result comes from and how its run went, from its attributes."""
    step = attrs["time_step"]
    stepping = f"tolerance {attrs['tolerance']:g} m" if step == "adaptive" else f"step {step:g} s"
    fact_table(
        {
            "title": attrs["title"],
            "input": f"{attrs['input_file']} ({attrs['input_format']})",
            "motion": attrs["motion"],
            "run": f"{attrs['duration']:g} s, results every {attrs['dt_out']:g} s, start {attrs['start']}",
            "method": f"{attrs['method']}, {stepping}"
            + (f": {attrs['steps']} steps, {attrs['rejected']} rejected" if "steps" in attrs else ""),
            "waves": sea_words(attrs),
            "seabed": attrs.get("bathymetry", ""),
            "friction": attrs.get("friction", ""),
            "friction in statics": attrs.get("friction_in_statics", "") if attrs["start"] == "static" else "",
            "moorage": f"{attrs['moorage_version']}, {attrs['date']}",
            "status": "killed before it was complete" if attrs["status"] == "running" else attrs["status"],
        }
    )


def line_table(rows: Iterable[LineSummary], static: bool) -> None:
    """Print the statistics of every line; `static`: they start with the static tension, not with that at time 0."""
    rows = list(rows)
    unit, scale = tension_unit(max((max(r.fairlead.maximum, r.anchor.maximum) for r in rows), default=0.0))
    first = "static" if static else "at 0 s"
    table = _table(
        f"\nTension at the ends and lowest tension in the line ({unit}),\n"
        "largest uplift at the anchor (deg), shortest grounded length (m)",
        ["line", "end", first, "min", "mean", "max", "std", "lowest", "uplift", "grounded"],
    )
    for row in rows:
        table.add_row(str(row.line), "fairlead", *(f"{v / scale:.1f}" for v in row.fairlead))
        rest = (f"{row.lowest_tension / scale:.1f}", f"{degrees(row.uplift):.1f}", f"{row.grounded:.1f}")
        table.add_row("", "anchor", *(f"{v / scale:.1f}" for v in row.anchor), *rest)
    _print(table)


def seabed_table(reports: Sequence[SeabedReport], run: bool = True) -> None:
    """Print what the seabed does to every line, of a run or of statics."""
    unit, scale = tension_unit(max((r.uplift_force for r in reports), default=0.0))
    least = ["least", "largest"] if run else []
    table = _table(
        f"\nTouchdown and its arc length from end A (m),\nlargest uplift force at end A ({unit})"
        + (", friction's energy (kJ)" if run else ""),
        ["line", "x", "y", "z", "arc", *least, "uplift", *(["friction"] if run else [])],
    )
    for r in reports:
        arcs = r.touchdown_arc_length if run else r.touchdown_arc_length[:1]
        energy = [_number(r.dissipated_energy / 1e3, 2)] if run else []
        places = [_number(value, 1) for value in (*r.touchdown_position, *arcs)]
        table.add_row(str(r.line), *places, _number(r.uplift_force / scale, 2), *energy)
    _print(table)


def cable_table(reports: Sequence[CableReport]) -> None:
    """Print the static reports of cables, a column each: there are few cables and many numbers."""
    unit, scale = tension_unit(max(max(r.hang_off_tension, r.anchor_tension) for r in reports))
    table = _table(f"\nCables ({unit}, {unit} m, deg, m)", ["", *map(_cable, reports)])
    rows: dict[str, Callable[[CableReport], str]] = {
        "hang-off tension": lambda r: _number(r.hang_off_tension / scale, 2),
        "  angle of the pull from straight down": lambda r: _number(degrees(r.hang_off_angle), 1),
        "  moment on the clamp": lambda r: _number(r.hang_off_moment / scale, 2),
        "lowest sag over the seabed": lambda r: _number(r.sag_height, 2),
        "highest hog over the seabed": lambda r: _number(r.hog_height, 2),
        "peak curvature (1/m)": lambda r: _number(r.peak_curvature, 4),
        "  bend radius": lambda r: _number(r.minimum_bend_radius, 2),
        "  where, from the hang-off": lambda r: _number(r.peak_curvature_distance, 1),
        "  where, line and node": lambda r: f"{r.peak_curvature_line}, {r.peak_curvature_node}",
        "allowed bend radius over actual": lambda r: _number(r.bend_utilisation, 2),
        "touchdown x": lambda r: _number(r.touchdown_position[0], 2),
        "  y": lambda r: _number(r.touchdown_position[1], 2),
        "  z": lambda r: _number(r.touchdown_position[2], 2),
        "  distance from the hang-off": lambda r: _number(r.touchdown_distance, 1),
        "anchor tension": lambda r: _number(r.anchor_tension / scale, 2),
    }
    for name, value in rows.items():
        table.add_row(name, *map(value, reports))
    _print(table)


def _cable(report: CableReport) -> str:
    first, last = report.lines[0], report.lines[-1]
    return f"line {first}" if first == last else f"lines {first} to {last}"


def _number(value: float, digits: int) -> str:
    return f"{round(value, digits) + 0.0:.{digits}f}" if isfinite(value) else "-"  # no minus before zeros


def static_tables(
    ds: xr.Dataset,
    cables: Sequence[CableReport] = (),
    seabed: Sequence[SeabedReport] = (),
    objects: Sequence[ObjectSummary] = (),
) -> None:
    """Print a static solution: lines, seabed, cables, points, bodies and rods, stiffness, verdict."""
    unit, scale = tension_unit(float(ds["fairlead_tension"].max()) if ds.sizes["line"] else 0.0)
    table = _table(
        f"Static equilibrium ({unit}, deg, m)",
        ["line", "fairlead B", "anchor A", "lowest", "uplift", "grounded"],
    )
    columns = ("fairlead_tension", "anchor_tension", "minimum_tension")
    for k, id in enumerate(ds["line"].values):
        tensions = [f"{float(ds[name][k]) / scale:.2f}" for name in columns]
        uplift, grounded = degrees(float(ds["anchor_uplift_angle"][k])), float(ds["grounded_length"][k])
        table.add_row(str(id), *tensions, f"{uplift:.1f}", f"{grounded:.1f}")
    _print(table)
    if seabed:
        seabed_table(seabed, run=False)
    if cables:
        cable_table(cables)
    table = _table(f"\nForce of the lines on each point ({unit})", ["point", "kind", "x", "y", "z", "Fx", "Fy", "Fz"])
    for k, id in enumerate(ds["point"].values):
        position = [f"{v:.2f}" for v in ds["point_position"].values[k]]
        force = [f"{v / scale:.2f}" for v in ds["point_force"].values[k]]
        table.add_row(str(id), str(ds["point_kind"].values[k]), *position, *force)
    _print(table)
    if "turbine_force" in ds:
        turbine_table(ds)
    if objects:
        object_table(objects, run=False)
    if "turbine_force" in ds:
        out.print("\nthe stiffness that each turbine feels is printed by the command stiffness")
    elif ds["stiffness"].isnull().any():
        out.print("\nthe stiffness of the coupled points is not computed: rods or bodies hang from a coupled pin")
    elif ds["stiffness"].values.any():
        table = _table(
            "\nStiffness of the coupled points as one platform (N, m, rad)", ["", *map(str, ds["dof"].values)]
        )
        for name, row in zip(ds["dof"].values, ds["stiffness"].values, strict=True):
            table.add_row(str(name), *(f"{v:.3e}" for v in row))
        _print(table)
    out.print(f"\nlargest out-of-balance force {float(ds['residual']):.2e} N after {int(ds['iterations'])} iterations")


def turbine_table(ds: xr.Dataset) -> None:
    """Print what a mooring does to each turbine, at rest."""
    unit, scale = tension_unit(float(abs(ds["turbine_force"]).max()))
    axes = ["Fx", "Fy", "Fz", "Mx", "My", "Mz"]
    table = _table(f"\nLoad of the mooring on each turbine ({unit}, {unit} m)", ["turbine", *axes])
    for k, id in enumerate(ds["turbine"].values):
        load = [*ds["turbine_force"].values[k], *ds["turbine_moment"].values[k]]
        table.add_row(str(id), *(_number(float(v) / scale, 2) for v in load))
    _print(table)


def object_table(rows: Sequence[ObjectSummary], run: bool) -> None:
    """Print where turbines, bodies and ends of rods are: at rest, or in a run."""
    columns = ["start", "end", "lowest", "highest"] if run else ["at rest"]
    kinds = {row.name.split()[0] for row in rows}
    title = "Turbines, bodies, rods" if "turbine" in kinds else "Bodies, rods"
    table = _table(f"\n{title} (m, deg)", ["", "", *columns])
    before = ""
    for row in rows:
        values = (row.start, row.end, row.lowest, row.highest) if run else (row.start,)
        table.add_row("" if row.name == before else row.name, row.coordinate, *(_number(v, 2) for v in values))
        before = row.name
    _print(table)


def mode_table(modes: Sequence[Mapping[str, Any]]) -> None:
    """Print natural modes: frequency, period, and what moves where to."""
    table = _table("Natural modes about static equilibrium", ["mode", "Hz", "period s", "mostly", "along"])
    for mode in modes:
        period = "" if mode["period"] is None else f"{mode['period']:.3f}"
        frequency = "not stable" if mode["frequency"] is None else f"{mode['frequency']:.5f}"
        table.add_row(str(mode["mode"]), frequency, period, str(mode["moves"]), str(mode["along"]))
    _print(table)


def stiffness_tables(ds: xr.Dataset) -> None:
    """Print the stiffness of each platform, and what couples each two."""
    for name in ds["platform"].values:
        for other in ds["platform_"].values:
            part = ds["platform_stiffness"].sel(platform=name, platform_=other)
            where = ", ".join(f"{v:g}" for v in ds["platform_origin"].sel(platform=name).values)
            title = f"Stiffness of {name} about ({where})" if name == other else f"Load on {name} by motion of {other}"
            table = _table(f"\n{title} (N, m, rad)", ["", *map(str, ds["dof"].values)])
            for dof, row in zip(ds["dof"].values, part.values, strict=True):
                table.add_row(str(dof), *(f"{v:.3e}" for v in row))
            _print(table)


def model_summary(model: Model, sea: Mapping[str, Any]) -> None:
    """Print what a model holds; `sea` holds the attributes of its waves."""
    kinds = [point.kind for point in model.points]
    counts = ", ".join(f"{kinds.count(kind)} {kind}" for kind in ("fixed", "coupled", "free") if kind in kinds)
    facts = {
        "format": model.flavour,
        "title": model.title,
        "water": f"depth {model.environment.water_depth:g} m, density {model.environment.water_density:g} kg/m3, "
        f"gravity {model.environment.gravity:g} m/s2",
        "waves": "from a host, or a function" if model.environment.host_waves else sea_words(sea),
        "current": current_words(model.environment.current),
        "seabed": seabed_words(model.environment),
        "lines": f"{len(model.lines)}, {sum(line.segments for line in model.lines)} segments, "
        f"{sum(line.length for line in model.lines):g} m",
        "line types": ", ".join(t.name for t in model.line_types),
        "points": f"{len(model.points)} ({counts})",
        "rods": str(len(model.rods) or ""),
        "bodies": str(len(model.bodies) or ""),
        "turbines": turbine_words(model.turbines),
        "start": model.start,
        "channels": ", ".join(output.name for output in model.outputs),
    }
    fact_table(facts)


def fact_table(facts: dict[str, str]) -> None:
    """Print names and what they are, leaving out the empty ones."""
    table = Table(box=None, show_header=False, pad_edge=False)
    table.add_column(style="bold", no_wrap=True)
    table.add_column(overflow="fold")
    for name, text in facts.items():
        if text:
            table.add_row(name, _plain(text))
    out.print(table)


def tension_unit(largest: float) -> tuple[str, float]:
    """Return kN for large forces and N for small ones, with the factor to N."""
    return ("kN", 1e3) if largest > 1e4 else ("N", 1.0)


def _plain(text: str) -> str:
    return text.replace("[", r"\[")


def _table(title: str, columns: list[str]) -> Table:
    table = Table(
        title=title,
        title_justify="left",
        title_style="bold",
        box=None,
        padding=(0, 1),
        collapse_padding=True,
        pad_edge=False,
    )
    for column in columns:
        words = column in ("line", "end", "point", "kind", "")
        table.add_column(column, justify="left" if words else "right", no_wrap=True)
    return table


def _print(table: Table) -> None:
    """Print a table as wide as its numbers need: a narrow terminal must not cut them."""
    out.print(
        table, width=max(out.width, out.measure(table, options=out.options.update(width=1000)).maximum), crop=False
    )
