"""Natural modes, and the stiffness of several platforms, as labelled datasets."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from moorage.model import Model
from moorage.results.index import DOF, XYZ, Index
from moorage.solve.given_water import places_ahead
from moorage.solve.modes import Modes
from moorage.solve.platforms import Platform
from moorage.solve.water_at import row_of_body
from moorage.system.build import Built
from moorage.variables import VARIABLES, attributes


def modes_dataset(model: Model, index: Index, built: Built, modes: Modes, attrs: Mapping[str, object]) -> xr.Dataset:
    """Return frequencies and shapes with the static state that they are about."""
    nodes, points = int(built.names.node_ptr[-1]), len(built.names.points)
    first = int(built.system.lines.node_ptr[-1])  # row of the first point
    things = object_shapes(model, built, modes)
    rate = np.sqrt(np.where(modes.squares >= 0.0, modes.squares, np.nan))
    values = {
        "mode": np.arange(1, len(rate) + 1),
        "frequency": rate / (2.0 * np.pi),
        "period": 2.0 * np.pi / np.where(rate > 0.0, rate, np.nan),
        "mode_shape": modes.shapes[:, :nodes],
        "point_shape": modes.shapes[:, first : first + points],
        "line_energy": np.add.reduceat(modes.energy[:, :nodes], built.names.node_ptr[:-1], axis=1),
        "node_position": built.state.position[:nodes],
        **things,
    }
    at_rest = {name: VARIABLES[name].dims[1:] for name in ("node_position", "rod_position")}
    ds = xr.Dataset(
        {n: (at_rest.get(n, VARIABLES[n].dims), v, attributes(n)) for n, v in values.items()}, attrs=dict(attrs)
    )
    labels = {"line": index.line, "point": index.point, "node_line": index.node_line, "arc_length": index.arc_length}
    labels |= {"point_kind": index.point_kind, "xyz": np.array(XYZ, dtype=object)}
    if "rod_shape" in things:
        labels |= {"rod": np.array([rod.id for rod in model.rods]), "rod_end": np.array(["A", "B"], dtype=object)}
    if "body_shape" in things:
        labels["body"] = np.array([body.id for body in model.bodies])
    return ds.assign_coords({n: (VARIABLES[n].dims, v, attributes(n)) for n, v in labels.items()})


def object_shapes(model: Model, built: Built, modes: Modes) -> dict[str, np.ndarray]:
    """Return how rods and bodies move in each mode, and their shares of the energy; nothing without them.

    What rides on a body counts as it, rods that are fixed to it too.
    """
    first, riders = int(built.system.lines.node_ptr[-1]), built.system.riders
    number = {name: o for o, name in enumerate(built.names.objects)}
    found: dict[str, np.ndarray] = {}

    def energy(o: int, holders: np.ndarray) -> np.ndarray:
        own = [riders.row[o], riders.row[o] + 1] if o >= 0 else []
        carried = np.flatnonzero(riders.points == o) if o >= 0 else np.unique(holders[riders.points[holders] < 0])
        return modes.energy[:, np.concatenate([own, first + carried]).astype(int)].sum(axis=1)

    if model.rods:
        rows = first + built.rods.ends
        parts = [energy(number.get(("rod", rod.id), -1), built.rods.ends[k]) for k, rod in enumerate(model.rods)]
        found |= {"rod_shape": modes.shapes[:, rows], "rod_energy": np.stack(parts, axis=1)}
        found["rod_position"] = places_ahead(built, 0.0, 0.0)[rows]
    if model.bodies:
        objects = [number.get(("body", body.id), -1) for body in model.bodies]
        rows = np.array([row_of_body(built, k) for k in range(len(objects))])
        turns, moves = np.zeros((len(modes.shapes), len(rows), 3)), np.array(objects) >= 0
        turns[:, moves] = modes.shapes[:, rows[moves] + 1]
        found |= {"body_shape": modes.shapes[:, rows], "body_turn": turns}
        found["body_energy"] = np.stack([energy(o, np.zeros(0, dtype=int)) for o in objects], axis=1)
    return found


def platforms_dataset(
    platforms: tuple[Platform, ...], stiffness: np.ndarray, attrs: Mapping[str, object]
) -> xr.Dataset:
    """Return the stiffness (p, 6, p, 6) with its labels."""
    names = np.array([platform.name for platform in platforms], dtype=object)
    values = {
        "platform_stiffness": stiffness,
        "platform_origin": np.array([platform.origin for platform in platforms]).reshape(-1, 3),
    }
    labels = {"platform": names, "platform_": names, "xyz": np.array(XYZ, dtype=object)}
    labels |= dict.fromkeys(("dof", "dof_"), np.array(DOF, dtype=object))
    return xr.Dataset(
        {n: (VARIABLES[n].dims, v, attributes(n)) for n, v in values.items()},
        coords={n: (VARIABLES[n].dims, v, attributes(n)) for n, v in labels.items()},
        attrs=dict(attrs),
    )


def modes_report(ds: xr.Dataset) -> list[dict[str, str | float | None]]:
    """Return frequency (Hz), period (s), what moves most and how, of each mode; None where not stable.

    "x" is along x; "about x" is said of a body or rod that turns more than it is displaced.
    """
    report: list[dict[str, str | float | None]] = []
    for k, number in enumerate(ds["mode"].values):
        mode = ds.isel(mode=k)
        shares = {(kind, i): v for kind in KINDS for i, v in enumerate(mode.get(f"{kind}_energy", _NONE).values)}
        kind, place = max(shares, key=lambda part: shares[part], default=("", 0))
        alone = bool(shares) and shares[kind, place] > 0.5
        report.append(
            {
                "mode": int(number),
                "frequency": _number(mode["frequency"]),
                "period": _number(mode["period"]),
                "moves": f"{kind} {ds[kind].values[place]}" if alone else "several",
                "along": (_turns(mode, kind, place) if alone else "") or _along(mode),
            }
        )
    return report


KINDS = ("line", "rod", "body")
_NONE = xr.DataArray(np.zeros(0))


def _along(mode: xr.Dataset) -> str:
    """Return the axis along which most is displaced."""
    names = [name for name in ("mode_shape", "point_shape", "rod_shape", "body_shape") if name in mode]
    shapes = [mode[name].values.reshape(-1, 3) for name in names]
    motion = (np.concatenate(shapes) ** 2).sum(axis=0)
    return XYZ[int(np.argmax(motion))] if motion.any() else ""


def _turns(mode: xr.Dataset, kind: str, place: int) -> str:
    """Return the axis about which a body or rod turns, where the largest displacement is mostly by that; else ""."""
    if kind == "body":
        centre, turn, much = mode["body_shape"].values[place], mode["body_turn"].values[place], 0.5
    elif kind == "rod":
        a, b = mode["rod_shape"].values[place]
        turn = np.cross(np.subtract(*mode["rod_position"].values[place, ::-1]), b - a)
        centre, much = 0.5 * (a + b), 0.501 * float(np.linalg.norm(b - a))  # so that a rod on a pin turns
    else:
        return ""
    return f"about {XYZ[int(np.argmax(np.abs(turn)))]}" if turn.any() and np.linalg.norm(centre) < much else ""


def stiffness_report(ds: xr.Dataset) -> dict[str, object]:
    """Return the stiffness as lists: a 6x6 matrix for each pair of load and motion, and the origins."""
    names = [str(name) for name in ds["platform"].values]
    K = ds["platform_stiffness"].values
    return {
        "dof": list(DOF),
        "origin": {name: ds["platform_origin"].values[k].tolist() for k, name in enumerate(names)},
        "stiffness": {a: {b: K[i, :, j].tolist() for j, b in enumerate(names)} for i, a in enumerate(names)},
    }


def _number(value: xr.DataArray) -> float | None:
    return float(value) if np.isfinite(value) else None
