"""What a mooring does about its static state: natural modes, and the stiffness that platforms feel."""

from __future__ import annotations

import warnings
from importlib.metadata import version

import xarray as xr

from moorage.accept import accept
from moorage.errors import InputError, ModelWarning, Problem, UnsupportedError
from moorage.model import Model
from moorage.model.cables import turns
from moorage.results import make_index, run_attributes
from moorage.results.modes import modes_dataset, platforms_dataset
from moorage.solve.modes import modes_at_rest
from moorage.solve.platforms import platforms_of, stiffness_of
from moorage.solve.statics import solve
from moorage.system.build import Built, build


def natural_modes(model: Model, number: int = 10) -> xr.Dataset:
    """Return the lowest natural frequencies and shapes of a mooring about its static equilibrium.

    Coupled points are held. Added mass takes part; drag, damping, waves and friction do not, and contact with the
    seabed is that of the static state.

    Parameters
    ----------
    model : Model
    number : int
        Of modes.

    Returns
    -------
    xarray.Dataset
        `frequency` (Hz), `period` (s), `mode_shape`, `point_shape`, `line_energy`, by `mode`; `node_position` at rest.
        With rods and bodies `rod_shape`, `body_shape`, `body_turn`, `rod_energy`, `body_energy`.
    """
    if not (isinstance(number, int) and number > 0):
        raise InputError(Problem("the number of modes must be positive", "give 1 or more", value=number))
    model = accept(model)
    built, attrs = _at_rest(model)
    ds = modes_dataset(model, make_index(model, built.names), built, modes_at_rest(built, number), attrs)
    unstable = int(ds["frequency"].isnull().sum())
    if unstable:
        warnings.warn(f"the static state is not stable in {unstable} of the modes", ModelWarning, stacklevel=2)
    return ds


def stiffness(model: Model) -> xr.Dataset:
    """Return the stiffness of a mooring to its platforms: turbines, coupled bodies, and the coupled points as one.

    Returns
    -------
    xarray.Dataset
        `platform_stiffness` of the dimensions `(platform, dof, platform_, dof_)`, N/m, N/rad, N m/rad: minus the load
        on a platform by the motion of one, about `platform_origin`.
    """
    model = accept(model)
    _refuse_pinned(model)
    platforms = platforms_of(model)
    if not platforms:
        remedy = "make a body, rod or point coupled"
        raise InputError(Problem("nothing is coupled, so that there is nothing to be stiff against", remedy))
    built, attrs = _at_rest(model)
    return platforms_dataset(platforms, stiffness_of(built, platforms), attrs)


def _refuse_pinned(model: Model) -> None:
    """Raise for what hangs from a coupled pin: the pin's force is not among those that stiffness is taken from."""
    coupled = {body.id for body in model.bodies if body.kind == "coupled"}
    pinned = [("body", b) for b in model.bodies if b.kind == "coupled-pinned"]
    rods = [rod for rod in model.rods if rod.segments or turns(model, rod)]
    pinned += [("rod", r) for r in rods if r.kind == "coupled-pinned"]  # type: ignore[misc]
    pinned += [("rod", r) for r in rods if r.kind == "pinned" and r.body in coupled]  # type: ignore[misc]
    problems = [
        Problem(
            f"{kind} {thing.id} hangs from a coupled pin, whose stiffness is not computed",
            "make it fixed",
            thing.source,
        )
        for kind, thing in pinned
    ]
    if problems:
        raise UnsupportedError(problems)


def _at_rest(model: Model) -> tuple[Built, dict]:
    """Return the solved system and what a result says of where it comes from."""
    built = build(model)
    equilibrium = solve(built)
    attrs = run_attributes(model, None, {"start": "static"}, version("moorage"))
    return built, attrs | {"residual": equilibrium.residual, "where": equilibrium.where}
