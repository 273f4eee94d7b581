"""What is on a turbine while a host moves it: how it sits there, and whose loads the turbine bears."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.model import Attachment, Body, Model, Rod
from moorage.model.motion import rotation_matrices
from moorage.model.turbines import on_turbines
from moorage.system.build import Built
from moorage.system.holders import holders_of
from moorage.system.objects import angles_of


class Driven(NamedTuple):
    """A row that a host drives."""

    kind: str  # of its owner
    id: int
    local: np.ndarray  # (3,) place or direction in its axes
    shifts: float  # 1: a place, which the owner shifts; 0: a direction


class Frame(NamedTuple):
    """How something sits on a turbine."""

    turbine: int
    place: np.ndarray  # (3,) of its origin, in the turbine's axes, from the turbine's reference point, m
    turn: np.ndarray  # (3, 3) from its axes to the turbine's


def frames_of(model: Model) -> dict[tuple[str, int], Frame]:
    """Return how the points, rods and bodies of turbines sit on them, by kind and id."""
    at, frames = {turbine.id: np.array(turbine.position) for turbine in model.turbines}, {}
    for kind, thing in on_turbines(model):
        place, angles = np.array(thing.end_a if isinstance(thing, Rod) else thing.position), np.zeros(3)
        if isinstance(thing, Rod):
            angles = angles_of(np.array(thing.direction))
        elif isinstance(thing, Body):
            angles = np.array(thing.rotation)
        turbine: int = thing.turbine  # type: ignore[assignment]
        frames[kind, thing.id] = Frame(turbine, place - at[turbine], rotation_matrices(angles[None])[0])
    return frames


def with_turbines(rows: dict[int, Driven], model: Model) -> dict[int, Driven]:
    """Return the rows with turbines as the owners of all that is on them."""
    frames = frames_of(model)

    def carried(row: Driven) -> Driven:
        frame = frames.get((row.kind, row.id))
        if frame is None:
            return row
        return Driven("turbine", frame.turbine, row.shifts * frame.place + frame.turn @ row.local, row.shifts)

    return {track: carried(row) for track, row in rows.items()}


class Part(NamedTuple):
    """Something on a turbine, whose load the turbine bears."""

    kind: str  # "point", "rod" or "body"
    place: int  # among the points, rods or bodies of the model
    row: int  # driven, of its origin
    holder: int
    width: int  # of its load: 6, or 3 without a moment


def parts_of(model: Model, built: Built, turbine: int, driven: np.ndarray) -> list[Part]:
    """Return what is on a turbine."""
    number, rows = holders_of(model, None, None), {int(track): row for row, track in enumerate(driven)}
    places = {("point", point.id): k for k, point in enumerate(model.points)}
    places |= {("rod", rod.id): k for k, rod in enumerate(model.rods)}
    places |= {("body", body.id): k for k, body in enumerate(model.bodies)}
    parts = []
    for kind, thing in on_turbines(model):
        if thing.turbine != turbine:
            continue
        place, o = places[kind, thing.id], number.objects.number.get((kind, thing.id))
        if o is not None:
            holder = int(number.pin[o])
        elif kind == "body":
            holder = int(built.bodies.place[place])
        else:
            holder = number.number[Attachment(kind, thing.id, "A" if kind == "rod" else "")]  # type: ignore[arg-type]
        parts.append(Part(kind, place, rows[holder], holder, 3 if thing.kind == "coupled-pinned" else 6))
    return parts
