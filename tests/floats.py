"""Small models of rods and bodies for tests of all kinds."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from moorage.model import Body, Environment, LineType, Model, Rod, RodType
from moorage.system.build import Built

AIR = {"water_density": 0.0, "water_depth": 100.0}
VACUUM = AIR | {"gravity": 0.0}
WATER = {"water_depth": 300.0}

SPAR = RodType(name="spar", diameter=0.4, mass_per_length=50.0)


def body(id: int = 1, kind: str = "free", position=(0.0, 0.0, -50.0), **properties: Any) -> Body:
    return Body(id=id, kind=kind, position=position, **({"mass": 100.0, "inertia": (10.0, 20.0, 35.0)} | properties))  # type: ignore[arg-type]


def rod(id: int, kind: str, end_a, end_b, segments: int = 4, type: str = "spar", **properties: Any) -> Rod:
    ends = {"end_a": tuple(map(float, end_a)), "end_b": tuple(map(float, end_b))}
    return Rod(id=id, rod_type=type, kind=kind, segments=segments, **ends, **properties)  # type: ignore[arg-type]


def floating(
    bodies: Iterable[Body] = (),
    rods: Iterable[Rod] = (),
    types: RodType | Iterable[RodType] = SPAR,
    line_types: LineType | Iterable[LineType] = (),
    environment: dict[str, float] = WATER,
    **parts: Any,
) -> Model:
    """Return a model of bodies and rods, with whatever else `parts` has."""
    return Model(
        environment=Environment(**environment),
        bodies=tuple(bodies),
        rods=tuple(rods),
        rod_types=(types,) if isinstance(types, RodType) else tuple(types),
        line_types=(line_types,) if isinstance(line_types, LineType) else tuple(line_types),
        **{name: part if isinstance(part, str) else tuple(part) for name, part in parts.items()},
    )


def throw(built: Built, velocity=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), object: int = 0) -> Built:
    """Give an object its first velocity (global axes, m/s) and spin (its own axes, rad/s), in place."""
    row = built.system.riders.row[object]
    built.state.velocity[row], built.state.velocity[row + 1] = velocity, spin
    return built


def world(axes, tensor) -> np.ndarray:
    """Return a tensor (3, 3) of a body's axes in global ones: R J R^T for every R of axes (n, 3, 3)."""
    return np.einsum("nij,jk,nlk->nil", axes, tensor, axes)


def momenta(block, mass, body_mass: float, inertia, origin) -> tuple[np.ndarray, np.ndarray]:
    """Momentum and angular momentum about a place (rows in time) of two like bodies and of nodes (n,) between them."""
    p = np.einsum("i,nij->nj", mass, block["node_velocity"])
    H = np.einsum("i,nij->nj", mass, np.cross(block["node_position"] - origin, block["node_velocity"]))
    for k in range(2):
        R, u, w = block["body_axes"][:, k], block["body_velocity"][:, k, :3], block["body_velocity"][:, k, 3:]
        p = p + body_mass * u
        H = H + body_mass * np.cross(block["body_position"][:, k] - origin, u)
        H = H + np.einsum("nij,jk,nlk,nl->ni", R, np.diag(inertia), R, w)
    return p, H
