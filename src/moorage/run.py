"""The pipeline, composed once: a model in, a labelled result out."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Literal

import numpy as np
import xarray as xr

from moorage._jit import mark_warm
from moorage.accept import accept, check_settings, check_water, warn_of_idle_winches
from moorage.at_rest import records_at_rest, static_tensions
from moorage.errors import ModelWarning, SimulationError
from moorage.model import Curve, Model, Motion
from moorage.model.payout import driven
from moorage.results import (
    Checkpoint,
    Layout,
    MemoryResult,
    MoordynOut,
    StreamWriter,
    bending_of,
    fingerprint,
    lines_off_the_grid_now,
    load_checkpoint,
    make_index,
    plan_outputs,
    remove_checkpoint,
    run_attributes,
    save_checkpoint,
    seabed_of,
    static_dataset,
    warn_of_lines_off_the_grid,
    warn_of_overloads,
    warn_of_repetition,
    warn_of_short_current,
    warn_of_tight_bends,
    watch_list,
)
from moorage.results.carried import carried_of
from moorage.results.turbines import turbines_of
from moorage.solve.clamps import warn_of_clamps
from moorage.solve.control import Settings, default_tolerance
from moorage.solve.given_water import WaterFeed, WaterFunction
from moorage.solve.march import March
from moorage.solve.peeling import warn_of_peeling
from moorage.solve.platforms import Platform, measured
from moorage.solve.statics import rest, solve
from moorage.solve.stiffness import platform_stiffness
from moorage.streaming import Progress, stream
from moorage.system.build import Built, build, releases_of
from moorage.system.winches import as_cut, laid_out

VERSION = version("moorage")


def solve_statics(model: Model) -> xr.Dataset:
    """Solve for static equilibrium, with the coupled points where the model describes them.

    Returns
    -------
    xarray.Dataset
        One instant: `node_position`, `segment_tension`, the end tensions and forces, `point_position`, `point_force`,
        and `stiffness` of the dimensions `(dof, dof_)`, the 6x6 matrix of the coupled points moved as one rigid
        platform about the origin, with the verdict `residual` (N) and `iterations`.

    Raises
    ------
    ModelError, UnsupportedError
        The model is wrong, or asks for what is not simulated yet.
    ConvergenceError
        No equilibrium was found.
    """
    model = accept(model)
    built = build(model)
    equilibrium = solve(built)
    warn_of_clamps(built)
    warn_of_peeling(built)
    block = records_at_rest(built, Settings(dt_nodes=1.0, watch=watch_list(model)))
    stiffness = _stiffness(built, block["holder_force"][0][built.coupled])
    attrs = run_attributes(model, None, {"start": "static", **friction_in_statics(model)}, VERSION) | {
        "where": equilibrium.where
    }
    shown = model if built.reeled is None else as_cut(model, built.winches, built.reeled)
    ds = static_dataset(
        _layout(model, shown, built, "time"), block, stiffness, equilibrium.residual, equilibrium.iterations, attrs
    )
    warn_of_tight_bends(ds)
    warn_of_overloads(ds)
    warn_of_lines_off_the_grid(lines_off_the_grid_now(built))
    return ds


def _stiffness(built: Built, forces: np.ndarray) -> np.ndarray:
    """Return the 6x6 stiffness of the coupled points as one; not a number where they hold pinned rods and bodies."""
    if not len(built.system.riders.row):
        return platform_stiffness(built, forces)
    if np.isin(built.system.riders.pin, built.coupled).any():
        return np.full((6, 6), np.nan)
    platform = Platform("coupled points", built.coupled, np.zeros(3))
    return measured(built, (platform,))[0, :, 0] if len(built.coupled) else np.zeros((6, 6))


def simulate(
    model: Model,
    *,
    duration: float,
    motion: Motion | None = None,
    dt_out: float | None = None,
    dt_nodes: float | None = None,
    tolerance: float | None = None,
    time_step: float | None = None,
    method: Literal["implicit", "rk2", "rk4"] = "implicit",
    start: Literal["static", "as-given"] | None = None,
    save: Literal["all", "tensions"] = "all",
    water: WaterFunction | None = None,
    water_interval: float = 0.1,
    output: str | Path | None = None,
    resume: bool = False,
    progress: Progress | None = None,
    moordyn_out: str | Path | None = None,
    payout: Mapping[int, Curve] | None = None,
) -> xr.Dataset:
    """Simulate a mooring in time.

    Parameters
    ----------
    model : Model
    duration : float
        s.
    motion : Motion, optional
        Motion of the coupled points; without it they stay where they are described.
    dt_out : float, optional
        Interval of the results, s; by default what the file asks for (dtOut), or 0.1 s.
    dt_nodes : float, optional
        Interval of node positions, velocities and segment tensions, s; by default `dt_out`.
    tolerance : float, optional
        Accepted local error of a step in the positions, m; by default 0.002 for segments of 1 to 20 m, more for longer
        ones and less for shorter ones: about 1 % rms of tension or better.
    time_step : float, optional
        A constant step, s, instead of the adaptive one; rk2 and rk4 need it.
    method : {"implicit", "rk2", "rk4"}
    start : {"static", "as-given"}, optional
        State at time 0: static equilibrium, or lines at rest on their first catenary; by default what the model says.
    save : {"all", "tensions"}
        Whether node and segment histories are kept.
    water : callable, optional
        Gives the waves, in place of those of the model: of a time (s) and places (n, 3) m it returns elevation (n,) m,
        velocity (n, 3) m/s and local acceleration (n, 3) m/s2. The current of the model is added.
    water_interval : float
        Between the times at which `water` is called, s; between them the water is linear in time. It is called for
        where the nodes will be then.
    output : path, optional
        A NetCDF file that grows while the run goes on; the dataset returned is then read from it when used.
    resume : bool
        Go on from the checkpoint beside `output`; the numbers are those of a run that was not interrupted.
    progress : callable, optional
        Called after each block with simulated time, duration and wall time, s.
    moordyn_out : path, optional
        Root of MoorDyn's text files, which are written too: root.out with the channels of the model, and root_Line1.out
        and so on for the lines and rods that ask (root.MD.out and root.MD.Line1.out for a file of MoorDyn-F).
    payout : mapping of int to Curve, optional
        By control channel, the length (m) that winches pay out over time (s), in place of what the model says; see
        `Control`.

    Returns
    -------
    xarray.Dataset
        See `moorage.variables`; `attrs["status"]` says how the run ended.

    Raises
    ------
    InputError
        The model, the motion or a setting is wrong, or is not simulated yet.
    SimulationError
        The run could not go on; what was before is in `output`, and the error's `dataset()` gives it.
    RunInterrupted
        Ctrl-C; as before, and `resume` goes on from there.
    """
    chosen: dict[str, object] = {
        "duration": duration,
        "dt_out": (model.output_interval or 0.1) if dt_out is None else dt_out,
        "dt_nodes": dt_nodes,
        "tolerance": tolerance,
        "time_step": time_step,
        "method": method,
        "start": model.start if start is None else start,
        "save": save,
    }
    if water is not None:
        chosen |= {"water": getattr(water, "__qualname__", type(water).__qualname__), "water_interval": water_interval}
    check_settings(chosen, resume, output)
    model = accept(driven(model, payout))
    warn_of_idle_winches(model)
    check_water(model, water, water_interval)
    warn_of_repetition(model.environment.waves, duration)
    warn_of_short_current(model.environment.current, duration)
    settings = _settings(model, chosen)
    rows = _rows(duration, settings)
    _warn_of_rest(duration, (rows["time"] - 1) * settings.dt_out, settings.dt_out)
    built = build(model, motion, duration)
    mark = fingerprint(model, motion, chosen)
    saved = load_checkpoint(Path(output), mark, VERSION) if resume and output else None
    static = {}
    if saved is None:
        (solve if chosen["start"] == "static" else rest)(built)
        static = static_tensions(built) if chosen["start"] == "static" else {}
        warn_of_clamps(built)
        warn_of_peeling(built)
    feed = None if water is None else WaterFeed(water, float(water_interval), len(built.state.position))
    releases = releases_of(model, motion, duration)
    shown, room = model, built
    if releases.most is not None:  # results have room for all segments that will be out
        shown = laid_out(model, built.winches, releases.most)
        room = build(shown, motion, duration)
    layout = _layout(model, shown, room, _node_dimension(settings), motion, static, feed)
    march = March(built, settings, (rows["time"] - 1) * settings.dt_out, releases, feed)
    if saved is not None:
        march.restore(saved.state)
    words = {
        "tolerance": default_tolerance(built) if tolerance is None else tolerance,
        "time_step": time_step or "adaptive",
        "dt_nodes": settings.dt_nodes or "none",
    }
    attrs = run_attributes(model, motion, chosen | words | friction_in_statics(model), VERSION)
    text = None
    if moordyn_out is not None:
        rows_written = _rows_written(saved.rows, layout.node_time) if saved else None
        nodes = settings.dt_nodes is not None
        text = MoordynOut(Path(moordyn_out), shown, room, layout.outputs, nodes, rows_written, VERSION, feed)
        _warn_of_no_text(text)
    if output is None:
        result = stream(march, MemoryResult(layout, attrs), layout, progress, text=text)
    else:
        writer = StreamWriter(Path(output), layout, rows, attrs, saved.rows if saved else None)

        def keep() -> None:
            save_checkpoint(writer.path, Checkpoint(march.checkpoint(), dict(writer.written), mark, VERSION))

        try:
            result = stream(march, writer, layout, progress, keep, saved is not None, text)
        except SimulationError:
            remove_checkpoint(writer.path)
            raise
        remove_checkpoint(writer.path)
    mark_warm()
    warn_of_tight_bends(result)
    warn_of_overloads(result)
    warn_of_lines_off_the_grid(lines_off_the_grid_now(march.built))
    return result


def friction_in_statics(model: Model) -> dict[str, str]:
    """Return what statics know of friction, for the record; nothing where there is none."""
    friction = model.environment.friction
    return {} if friction is None else {"friction_in_statics": "as laid" if friction.laid else "off"}


def _settings(model: Model, chosen: dict) -> Settings:
    dt_nodes = (chosen["dt_nodes"] or chosen["dt_out"]) if chosen["save"] == "all" else None
    return Settings(
        method=chosen["method"],
        tolerance=chosen["tolerance"],
        time_step=chosen["time_step"],
        dt_out=float(chosen["dt_out"]),
        dt_nodes=dt_nodes and float(dt_nodes),
        watch=watch_list(model),
    )


def _rows(duration: float, settings: Settings) -> dict[str, int]:
    """Return the number of output times and of node histories of a whole run."""
    rows = int(np.floor(duration / settings.dt_out + 1e-6)) + 1
    end = (rows - 1) * settings.dt_out
    return {
        "time": rows,
        "node_time": int(np.floor(end / settings.dt_nodes + 1e-6)) + 1 if settings.dt_nodes else 0,
    }


def _rows_written(rows: Mapping[str, int], node_time: str) -> dict[str, int]:
    """Return the numbers of times and of node histories in a result."""
    return {"time": rows["time"], "node_time": rows["node_time" if node_time == "node_time" else "time"]}


def _warn_of_no_text(text: MoordynOut) -> None:
    """Warn where MoorDyn's files were asked for and a model asks for none of them."""
    if not text.files:
        warnings.warn(
            "no .out file is written: the model has no output channel, and no line, rod or body that asks for a file\n"
            "    -> Name channels (OUTPUTS of MoorDyn's files, outputs of native ones), or letters of lines' outputs",
            ModelWarning,
            stacklevel=3,
        )


def _warn_of_rest(duration: float, end: float, dt_out: float) -> None:
    """Warn of a duration that is no multiple of the interval of results."""
    if duration - end > 1e-6 * dt_out:
        warnings.warn(
            f"results end at {end:g} s: the duration of {duration:g} s is no multiple of their interval "
            f"of {dt_out:g} s (--dt-out, dt_out)",
            ModelWarning,
            stacklevel=3,
        )


def _node_dimension(settings: Settings) -> str:
    if settings.dt_nodes is None:
        return ""
    return "time" if settings.dt_nodes == settings.dt_out else "node_time"


def _layout(
    model: Model,
    shown: Model,
    built: Built,
    node_time: str,
    motion: Motion | None = None,
    static: Mapping[str, np.ndarray] | None = None,
    water: WaterFeed | None = None,
) -> Layout:
    """Return what results have; `shown` is the model with its lines cut as `built`."""
    index = make_index(shown, built.names)
    bending = bending_of(shown, built, index.allowed_bend_radius)
    outputs = plan_outputs(model, built, water)
    seabed, sea = seabed_of(shown, built), water or model.environment.waves
    carried, turbines = carried_of(model, built, bool(node_time)), turbines_of(model, motion)
    return Layout(
        index, outputs, node_time, bending, seabed, sea, carried, turbines, static or {}, bool(model.controls)
    )  # fmt: skip
