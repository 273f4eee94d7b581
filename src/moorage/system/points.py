"""Points of a model: their weight, water and given loads."""

from __future__ import annotations

import numpy as np

from moorage.model import Attachment, Model
from moorage.physics.point import PointLoads
from moorage.system.holders import Holders
from moorage.system.objects import three


def build_points(model: Model, holders: Holders) -> PointLoads:
    """Return the loads of points by themselves; given ones also of short rods, and at ends A of those on bodies."""
    env, count = model.environment, len(holders.rest)

    def column(values):
        out = np.zeros(count)
        out[: len(model.points)] = values
        return out

    mass = column([p.mass for p in model.points])
    volume = column([p.volume for p in model.points])
    given = np.zeros((count, 3, 3))
    given[: len(model.points), 0] = np.array([p.external_force for p in model.points], dtype=float).reshape(-1, 3)
    place = {("point", point.id): k for k, point in enumerate(model.points)}
    place |= {
        ("rod", rod.id): holders.number[Attachment("rod", rod.id, "A")]
        for rod in model.rods
        if not rod.segments or (rod.body is not None and rod.kind == "fixed")
    }
    for load in model.external_loads:
        if (at := place.get((load.target, load.target_id))) is not None:
            given[at] += [
                load.force, three(load.linear_damping), three(load.quadratic_damping),
            ]  # fmt: skip
    return PointLoads(
        mass,
        env.water_density * volume * column([p.added_mass for p in model.points]),
        -env.gravity * mass,
        env.water_density * volume,
        env.gravity * env.water_density * volume,
        0.5 * env.water_density * column([p.drag_area for p in model.points]),
        np.maximum((0.75 * volume / np.pi) ** (1.0 / 3.0), 1e-3),
        given,
    )
