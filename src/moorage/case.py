"""A run as the command line names it: a model or a driver file, and what was asked for beside it."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from moorage.errors import InputError, Problem, Source
from moorage.io import is_driver, is_farm, motion_of_turbines, read, read_driver, read_farm, read_motion
from moorage.io.tables import read_columns
from moorage.io.text import Findings

if TYPE_CHECKING:
    from moorage.model import Curve, Model, Motion


class Case(NamedTuple):
    """A model with what a driver file or the command line says about its run; times in s."""

    model: Model
    motion: Motion | None
    duration: float
    dt_out: float | None


def read_case(file: Path, motion: Path | None, duration: float | None, raise_to_seabed: bool) -> Case:
    """Read a model, a driver file or FAST.Farm's; what the command line says comes first.

    Raises
    ------
    InputError
        The files are wrong, or nothing says how long the run is.
    """
    text = file.read_text(errors="replace") if file.is_file() else ""
    if is_driver(text):
        driver = read_driver(file, raise_to_seabed)
        case = Case(driver.model, driver.motion, driver.duration, driver.interval)
    elif is_farm(text):
        farm = read_farm(file, raise_to_seabed)
        case = Case(farm.model, None, farm.duration, None)
    else:
        case = Case(read(file, raise_to_seabed), None, 0.0, None)
        if motion is None and (moved := motion_of_turbines(case.model)):
            case = case._replace(motion=moved, duration=moved.duration)
    if motion is not None:
        moved = read_motion(motion, case.model)
        case = case._replace(motion=moved, duration=moved.duration)
    if duration is None and not case.duration:
        raise InputError(Problem("there is no motion that says how long the run is", "give seconds (--duration)"))
    return case._replace(
        duration=case.duration if duration is None else duration, dt_out=case.model.output_interval or case.dt_out
    )


def read_payout(file: Path, model: Model) -> dict[int, Curve]:
    """Read what winches pay out: time (s), and a length (m) for each control channel in the order of the model.

    Raises
    ------
    InputError
        The file has other columns.
    """
    from moorage.model import Curve  # noqa: PLC0415

    channels, found = [control.channel for control in model.controls], Findings()
    if not channels:
        raise InputError(Problem("the model has no control channels", "leave --payout out", Source(str(file))))
    width = 1 + len(channels)
    table = read_columns(file, "payout", range(width, width + 1), found, Source(str(file)))
    found.raise_any()
    time, *lengths = zip(*table, strict=True)
    return {channel: Curve(time, length, file.name) for channel, length in zip(channels, lengths, strict=True)}
