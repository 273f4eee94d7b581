"""The command line. Each command reads its files, calls one public function, and shows what came out.

Exit codes: 0 done, 2 wrong input, 3 a run or a static solution that failed, 130 interrupted.
"""

from __future__ import annotations

import json
import os
import warnings
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from typer.core import TyperGroup

import moorage  # its names are imported when they are used: --help must not wait for numba, xarray and matplotlib
from moorage import console
from moorage.case import read_case, read_payout

if TYPE_CHECKING:
    import xarray as xr


class Method(StrEnum):
    """How to integrate in time."""

    implicit = "implicit"
    rk2 = "rk2"
    rk4 = "rk4"


class Start(StrEnum):
    """State at time 0."""

    static = "static"
    as_given = "as-given"


class Save(StrEnum):
    """What is kept."""

    tensions = "tensions"
    all = "all"


class Flavour(StrEnum):
    """Whose dialect of MoorDyn's format."""

    C = "C"
    F = "F"


class Picture(StrEnum):
    """What to draw."""

    profile = "profile"
    history = "history"
    envelope = "envelope"
    spectrum = "spectrum"
    map = "map"


class Guarded(TyperGroup):
    """Commands whose errors are one readable message and an exit code."""

    def invoke(self, ctx):
        """Run a command."""
        with warnings.catch_warnings():
            warnings.simplefilter("once", moorage.ModelWarning)
            warnings.showwarning = console.show_warning
            try:
                return super().invoke(ctx)
            except moorage.InputError as error:
                raise stop(error, 2) from None
            except (moorage.ConvergenceError, moorage.SimulationError) as error:
                raise stop(error, 3) from None
            except KeyboardInterrupt as error:
                raise stop(str(error) or "interrupted", 130) from None
            except OSError as error:
                raise stop(error, 2) from None


def stop(message: object, code: int) -> typer.Exit:
    """Print why a command ends, and return the exit to raise."""
    console.say(f"error: {message}" if code != 130 else message, "red" if code != 130 else "yellow")
    return typer.Exit(code)


app = typer.Typer(
    cls=Guarded,
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="Dynamics of mooring lines and power cables: MoorDyn files in, labelled results out.",
)

ModelFile = Annotated[
    Path, typer.Argument(metavar="FILE", help="Model: MoorDyn v2 or v1, MoorDyn-F driver, FAST.Farm, or native YAML.")
]
ResultFile = Annotated[Path, typer.Argument(metavar="RESULT.nc", help="What a run wrote.")]
Raise = Annotated[
    bool,
    typer.Option(
        "--raise-to-seabed",
        help="Put anchors on the seabed: those below it, and those less than a tenth of the depth over a depth grid.",
    ),
]


def print_version(asked: bool) -> None:
    """Print the version and leave."""
    if asked:
        typer.echo(f"moorage {moorage.__version__}")
        raise typer.Exit


@app.callback()
def common(
    version: Annotated[
        bool, typer.Option("--version", callback=print_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    """Take the options of all commands."""


@app.command()
def run(
    file: ModelFile,
    motion: Annotated[
        Path | None, typer.Option(help="Motion of platforms or coupled points (CSV or MoorDyn-F).")
    ] = None,
    duration: Annotated[float | None, typer.Option(help="Time to simulate, s (default: that of the motion).")] = None,
    dt_out: Annotated[float | None, typer.Option(help="Interval of results, s (default: the file's, or 0.1).")] = None,
    tolerance: Annotated[float | None, typer.Option(help="Error of a step in position, m (default: ~0.002).")] = None,
    time_step: Annotated[float | None, typer.Option(help="Constant step, s, instead of the adaptive one.")] = None,
    method: Annotated[Method, typer.Option(help="Time integration; rk2 and rk4 need --time-step.")] = Method.implicit,
    start: Annotated[Start | None, typer.Option(help="State at time 0 (default: what the file says).")] = None,
    save: Annotated[Save, typer.Option(help="Keep tensions only, or node and segment histories too.")] = Save.all,
    dt_nodes: Annotated[float | None, typer.Option(help="Interval of node histories, s (default: --dt-out).")] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on where an interrupted run stopped.")] = False,
    output: Annotated[Path | None, typer.Option("-o", metavar="OUT.nc", help="Result (default: FILE's name).")] = None,
    moordyn_out: Annotated[bool, typer.Option("--moordyn-out", help="Write MoorDyn's .out files too.")] = False,
    payout: Annotated[
        Path | None, typer.Option(help="Time, and length paid out by each control channel (CSV).")
    ] = None,
    raise_to_seabed: Raise = False,
) -> None:
    """Simulate a mooring in time; write a NetCDF file and a figure, and print a table."""
    if tolerance is not None and time_step is not None:
        raise typer.BadParameter("give --tolerance or --time-step, not both")
    if output is not None and output.suffix != ".nc":
        raise typer.BadParameter(f"a result is a NetCDF file; write {output}.nc", param_hint="-o")
    case = read_case(file, motion, duration, raise_to_seabed)
    target = Path(f"{file.stem}.nc") if output is None else output
    announce_compiling()
    try:
        with console.progress_bar() as progress:
            ds = moorage.simulate(
                case.model,
                duration=case.duration,
                motion=case.motion,
                dt_out=case.dt_out if dt_out is None else dt_out,
                dt_nodes=dt_nodes,
                tolerance=tolerance,
                time_step=time_step,
                method=method.value,
                start=start.value if start else None,
                save=save.value,
                output=target,
                resume=resume,
                progress=progress,
                moordyn_out=target.with_suffix("") if moordyn_out else None,
                payout=read_payout(payout, case.model) if payout else None,
            )
    except moorage.RunInterrupted as error:
        message = f"stopped at {error.time:g} s of {case.duration:g} s; results up to there are in {target}\n"
        raise stop(message + "    -> go on with the same command and --resume", 130) from None
    except moorage.SimulationError as error:
        raise stop(f"{error}\nresults up to {error.time:g} s are in {target}", 3) from None
    show_run(ds)
    picture = target.with_suffix(".png")
    moorage.plot.save_figure(ds, picture)
    console.out.print(f"\nresults {target}\nfigure  {picture}", markup=False, soft_wrap=True)


@app.command()
def static(
    file: ModelFile,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, in N, m and rad.")] = False,
    raise_to_seabed: Raise = False,
) -> None:
    """Solve for static equilibrium; print tensions, cables, forces, and the stiffness as one platform feels it."""
    model = moorage.read(file, raise_to_seabed)
    announce_compiling()
    ds = moorage.solve_statics(model)
    if as_json:
        typer.echo(json.dumps(moorage.results.static_report(ds), indent=2, allow_nan=False))
    else:
        results = moorage.results
        console.static_tables(ds, results.cable_reports(ds), results.seabed_reports(ds), results.object_summaries(ds))


@app.command()
def modes(
    file: ModelFile,
    number: Annotated[int, typer.Option("--number", "-n", min=1, help="How many modes, the lowest first.")] = 10,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, in Hz and s.")] = False,
    output: Annotated[Path | None, typer.Option("-o", metavar="OUT.nc", help="Keep frequencies and shapes.")] = None,
    raise_to_seabed: Raise = False,
) -> None:
    """Find natural frequencies and shapes about static equilibrium, with the coupled points held."""
    model = moorage.read(file, raise_to_seabed)
    announce_compiling()
    ds = moorage.natural_modes(model, number)
    if output is not None:
        ds.to_netcdf(output)
    if as_json:
        typer.echo(json.dumps(moorage.results.modes_report(ds), indent=2, allow_nan=False))
    else:
        console.mode_table(moorage.results.modes_report(ds))


@app.command()
def stiffness(
    file: ModelFile,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, in N, m and rad.")] = False,
    output: Annotated[Path | None, typer.Option("-o", metavar="OUT.nc", help="Keep the matrix.")] = None,
    raise_to_seabed: Raise = False,
) -> None:
    """Find the 6x6 stiffness that each turbine, coupled body and the coupled points feel, and what couples them."""
    model = moorage.read(file, raise_to_seabed)
    announce_compiling()
    ds = moorage.stiffness(model)
    if output is not None:
        ds.to_netcdf(output)
    if as_json:
        typer.echo(json.dumps(moorage.results.stiffness_report(ds), indent=2, allow_nan=False))
    else:
        console.stiffness_tables(ds)


@app.command()
def check(file: ModelFile, raise_to_seabed: Raise = False) -> None:
    """Read a model and print what it holds, which options mean nothing here, and what is not simulated yet."""
    model = moorage.read(file, raise_to_seabed)
    console.model_summary(model, moorage.results.sea_attributes(model.environment.waves))
    if model.unused_options:
        console.out.print("\noptions that are not used here", style="bold")
        console.fact_table({f"{o.name} {o.value}": o.reason for o in model.unused_options})
    missing, lacking = moorage.unbuilt(model), moorage.lacking(model)
    doubts = [*moorage.suspicious(model), *([] if missing or lacking else moorage.backward_clamps(model))]
    console.problem_list("hardly meant", doubts, "bold yellow")
    console.problem_list("what it lacks", lacking)
    console.problem_list("not simulated yet", missing)
    if missing or lacking:
        raise typer.Exit(2)
    console.out.print("\nthis can be run" if doubts else "\nno problems: this can be run", style="green")


@app.command()
def info(result: ResultFile) -> None:
    """Print where a result comes from, and its statistics."""
    show_run(moorage.open_result(result))


@app.command()
def plot(
    result: ResultFile,
    output: Annotated[
        Path | None, typer.Option("-o", metavar="PNG", help="Picture (default: RESULT.png or RESULT-WHAT.png).")
    ] = None,
    what: Annotated[
        Picture | None,
        typer.Option(help="One picture: of the shapes, of tension over time, along lines, by frequency."),
    ] = None,
) -> None:
    """Draw tensions over time, the profile of each mooring, and tension and curvature along each cable."""
    ds = moorage.open_result(result)
    picture = result.with_name(f"{result.stem}-{what.value}.png" if what else f"{result.stem}.png")
    picture = picture if output is None else output
    if what:
        moorage.plot.save_picture(ds, what.value, picture)
    else:
        moorage.plot.save_figure(ds, picture)
    console.out.print(f"figure {picture}", markup=False, soft_wrap=True)


@app.command()
def report(
    result: ResultFile,
    output: Annotated[
        Path | None, typer.Option("-o", metavar="HTML|PDF", help="Report (default: RESULT-report.html).")
    ] = None,
) -> None:
    """Write one page about a run, as HTML or PDF: model, surroundings, tables, figures and warnings."""
    page = moorage.report(result, output)
    console.out.print(f"page {page}", markup=False, soft_wrap=True)


@app.command()
def view(
    file: Annotated[
        Path, typer.Argument(metavar="FILE|RESULT.nc", help="What a run wrote, or a model: its static shape.")
    ],
    output: Annotated[Path | None, typer.Option("-o", metavar="PAGE.html", help="Page (default: FILE.html).")] = None,
    no_open: Annotated[bool, typer.Option("--no-open", help="Write the page, and do not open it.")] = False,
    raise_to_seabed: Raise = False,
) -> None:
    """Show a mooring in three dimensions: write one HTML page that needs nothing else, and open it in the browser."""
    target = Path(f"{file.stem}.html") if output is None else output
    if file.suffix == ".nc":
        page = moorage.view(moorage.open_result(file))
    else:
        model = moorage.read(file, raise_to_seabed)
        announce_compiling()
        page = moorage.view(model)
    page.save(target)
    opened = not no_open and console.open_page(target)
    console.out.print(f"page {target}{' (opened in the browser)' if opened else ''}", markup=False, soft_wrap=True)


@app.command()
def animate(
    result: ResultFile,
    output: Annotated[Path | None, typer.Option("-o", metavar="MP4|GIF", help="Film (default: RESULT.mp4.)")] = None,
    speed: Annotated[float, typer.Option(help="Seconds of the run in one second of the film.")] = 5.0,
    fps: Annotated[int, typer.Option(help="Pictures a second.")] = 15,
) -> None:
    """Draw a run as a film: the mooring from the side and its tensions over time."""
    with console.work_bar("frames") as progress:
        made = moorage.plot.animate(moorage.open_result(result), output, speed=speed, fps=fps, progress=progress)
    console.out.print(f"film {made}", markup=False, soft_wrap=True)


@app.command()
def vtk(
    result: ResultFile,
    output: Annotated[Path | None, typer.Option("-o", metavar="FOLDER", help="Folder (default: RESULT-vtk).")] = None,
    every: Annotated[int, typer.Option(min=1, help="Write each so many instants of the node histories.")] = 1,
) -> None:
    """Write a result as VTK files with a series that ParaView opens."""
    folder = result.with_name(f"{result.stem}-vtk") if output is None else output
    series = moorage.write_vtk(moorage.open_result(result), folder, every)
    console.out.print(f"series {series}", markup=False, soft_wrap=True)


@app.command()
def convert(
    file: ModelFile,
    out: Annotated[Path, typer.Argument(metavar="OUT", help="Native when it ends in .yaml or .yml, else MoorDyn v2.")],
    flavour: Annotated[Flavour, typer.Option(help="Dialect of a MoorDyn file.")] = Flavour.C,
    raise_to_seabed: Raise = False,
) -> None:
    """Write a model in the other format, and list what that cannot say."""
    notes = moorage.convert(file, out, flavour.value, raise_to_seabed)
    for note in notes:
        console.out.print(f"note: {note}", markup=False, soft_wrap=True)
    console.out.print(f"wrote {out}", markup=False, soft_wrap=True)


@app.command()
def warmup() -> None:
    """Compile the kernels now, so that the next run starts at once."""
    announce_compiling()
    console.out.print(f"kernels are ready ({moorage.warmup():.1f} s)")


def announce_compiling() -> None:
    """Say why the first run takes long."""
    if moorage.is_cold():
        console.say("compiling the kernels for this machine, once (about two minutes) ...")


def show_run(ds: xr.Dataset) -> None:
    """Print what a result says of its run, and the tables of its lines and the seabed."""
    console.run_summary(ds.attrs)
    console.line_table(moorage.results.line_summaries(ds), moorage.results.has_static_tensions(ds))
    if seabed := moorage.results.seabed_reports(ds):
        console.seabed_table(seabed)
    if objects := moorage.results.object_summaries(ds):
        console.object_table(objects, run=True)


def main() -> None:
    """Run the command line; a bug shows its traceback only with MOORAGE_DEBUG=1."""
    try:
        app()
    except Exception as error:
        if os.environ.get("MOORAGE_DEBUG") == "1":
            raise
        message = f"this is a bug, not your input: {type(error).__name__}: {error}"
        console.say(f"error: {message}\n    -> please report it with the output of MOORAGE_DEBUG=1", "red")
        raise SystemExit(1) from None


if __name__ == "__main__":
    main()
