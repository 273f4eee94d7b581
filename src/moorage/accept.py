"""What a run looks at before it begins: the model and the settings."""

from __future__ import annotations

import warnings

import numpy as np

from moorage.errors import InputError, ModelError, ModelWarning, Problem
from moorage.model import Model
from moorage.model.checks import check, lacking, suspicious
from moorage.model.turbines import placed
from moorage.model.unbuilt import refuse_unbuilt


def accept(model: Model) -> Model:
    """Refuse a model that is wrong or asks for what is not built, and warn of what looks like a mistake.

    Returns
    -------
    Model
        The same, with what is on turbines in global coordinates.
    """
    check(model)
    refuse_unbuilt(model)
    if problems := lacking(model):
        raise ModelError(problems)
    if model.unused_options:
        names = ", ".join(option.name for option in model.unused_options)
        warnings.warn(f"{model.file}: options that are not used here: {names}", ModelWarning, stacklevel=3)
    for problem in suspicious(model):
        warnings.warn(str(problem), ModelWarning, stacklevel=3)
    return placed(model)


def warn_of_idle_winches(model: Model) -> None:
    """Warn of winches that nothing drives."""
    for control in model.controls:
        if control.length is None and control.rate is None:
            what = f"nothing drives control channel {control.channel}: its lines keep their length"
            remedy = "give length or rate with the control, payout to simulate(), or --payout"
            warnings.warn(str(Problem(what, remedy, control.source)), ModelWarning, stacklevel=3)


def check_water(model: Model, water: object, interval: float) -> None:
    """Refuse waves that are given twice, or that nobody gives."""
    environment, problems = model.environment, []
    if water is not None and environment.waves is not None:
        remedy = "remove them from the model, or leave water out"
        problems.append(Problem("the model has waves of its own, and water is given", remedy, environment.waves.source))
    if water is not None and not (isinstance(interval, int | float) and 0.0 < interval < np.inf):
        problems.append(Problem("water_interval must be a positive number", "correct it", value=interval))
    if water is None and environment.host_waves:
        remedy = "give simulate() a function as water, or use Simulation with set_water()"
        where = model.source_of("host_waves")
        problems.append(Problem("the model has its waves from a host, and there is none", remedy, where))
    if problems:
        raise InputError(problems)


def check_settings(chosen: dict[str, object], resume: bool, output: object) -> None:
    """Refuse settings of a run that mean nothing, all in one error."""
    problems = []
    for name in ("duration", "dt_out", "dt_nodes", "tolerance", "time_step"):
        value = chosen.get(name)
        if value is not None and not (isinstance(value, int | float) and 0.0 < value < np.inf):
            problems.append(Problem(f"{name} must be a positive number", "correct it", value=value))
    for name, words in (
        ("method", ("implicit", "rk2", "rk4")),
        ("start", ("static", "as-given")),
        ("save", ("all", "tensions")),
    ):
        if name in chosen and chosen[name] not in words:
            problems.append(Problem(f"{name} is not known", f"use {' or '.join(words)}", value=chosen[name]))
    if chosen["method"] in ("rk2", "rk4") and chosen["time_step"] is None:
        remedy = "give time_step (--time-step), or use the implicit method"
        problems.append(Problem(f"method {chosen['method']} needs a time step", remedy))
    if resume and output is None:
        problems.append(Problem("there is nothing to resume without a result file", "give output (-o)"))
    if problems:
        raise InputError(problems)
