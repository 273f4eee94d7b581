"""Turbines of a farm: platforms that carry points, rods and bodies, each with a place and a motion of its own."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import TYPE_CHECKING

from moorage.errors import Problem, Source

if TYPE_CHECKING:
    from moorage.model.components import Body, Point, Rod
    from moorage.model.model import Model


@dataclasses.dataclass(frozen=True, kw_only=True)
class Turbine:
    """A platform, as FAST.Farm numbers them.

    Parameters
    ----------
    position : tuple of float
        Its reference point, m, global. What is on the turbine is described from there, in axes that are parallel to the
        global ones (MoorDyn-F's TurbineRefPos), and its motion turns about there.
    motion : str
        A file with its motion for `moorage run`: time, surge, sway, heave, roll, pitch, yaw.
    """

    id: int
    position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    motion: str = ""
    name: str = ""
    source: Source | None = dataclasses.field(default=None, compare=False, repr=False)


def placed(model: Model) -> Model:
    """Return the model with what is on turbines in global coordinates; the solvers see no others."""
    if model.in_place:
        return model
    at = {turbine.id: turbine.position for turbine in model.turbines}

    def moved(place: tuple[float, float, float], turbine: int | None) -> tuple[float, float, float]:
        x, y, z = at.get(turbine, (0.0, 0.0, 0.0))  # type: ignore[arg-type]
        return place[0] + x, place[1] + y, place[2] + z

    def moved_rod(rod: Rod) -> Rod:
        ends = {"end_a": moved(rod.end_a, rod.turbine), "end_b": moved(rod.end_b, rod.turbine)}
        return dataclasses.replace(rod, **ends)  # type: ignore[arg-type]

    def moved_to(thing, turbine: int | None):
        return dataclasses.replace(thing, position=moved(thing.position, turbine))

    return dataclasses.replace(
        model,
        points=tuple(p if p.turbine is None else moved_to(p, p.turbine) for p in model.points),
        rods=tuple(r if r.turbine is None else moved_rod(r) for r in model.rods),
        bodies=tuple(b if b.turbine is None else moved_to(b, b.turbine) for b in model.bodies),
        in_place=True,
    )


def on_turbines(model: Model) -> Iterator[tuple[str, Point | Rod | Body]]:
    """Yield "point", "rod" or "body" with everything that is on a turbine."""
    for kind, things in (("point", model.points), ("rod", model.rods), ("body", model.bodies)):
        yield from ((kind, thing) for thing in things if thing.turbine is not None)  # type: ignore[attr-defined]


def turbines_have_places(model: Model) -> Iterator[Problem]:
    """Every turbine that something is on has a reference position."""
    known = {turbine.id for turbine in model.turbines}
    listed = f"the turbines are {', '.join(map(str, sorted(known)))}"
    remedy = (
        "read it through a driver file (NumTurbines) or FAST.Farm's .fstf, or list turbines with their positions in a "
        "native file"
    )
    for kind, thing in on_turbines(model):
        if thing.turbine not in known:
            message = f"{kind} {thing.id} is on turbine {thing.turbine}, whose reference position is not known"
            yield Problem(message, listed if known else remedy, thing.source, thing.turbine)


def listed_turbines_exist(model: Model) -> Iterator[Problem]:
    """Where turbines are listed, all that are named are among them; a MoorDyn file by itself lists none."""
    if model.turbines:
        yield from turbines_have_places(model)


def turbines_carry_what_is_coupled(model: Model) -> Iterator[Problem]:
    """What is on a turbine moves with it, and is on nothing else."""
    for kind, thing in on_turbines(model):
        if not thing.kind.startswith("coupled"):
            message = f"{kind} {thing.id} is on turbine {thing.turbine}, and {thing.kind}"
            yield Problem(message, "write coupled, or leave the turbine out", thing.source, thing.kind)
        if getattr(thing, "body", None) is not None:
            message = f"{kind} {thing.id} is on turbine {thing.turbine} and on body {thing.body}"  # type: ignore[union-attr]
            yield Problem(message, "leave the turbine out: it goes with the body", thing.source)


def turbines_at_one_place(model: Model) -> Iterator[Problem]:
    """Two turbines hardly stand at the same place."""
    seen: dict[tuple[float, float, float], int] = {}
    for turbine in model.turbines:
        if turbine.position in seen:
            message = f"turbines {seen[turbine.position]} and {turbine.id} have the same reference position"
            yield Problem(message, "correct one of them", turbine.source, turbine.position)
        seen.setdefault(turbine.position, turbine.id)
