"""Natural modes, and the stiffness of several platforms, as labelled datasets."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from moorage.results.index import DOF, XYZ, Index
from moorage.solve.modes import Modes
from moorage.solve.platforms import Platform
from moorage.system.build import Built
from moorage.variables import VARIABLES, attributes


def modes_dataset(index: Index, built: Built, modes: Modes, attrs: Mapping[str, object]) -> xr.Dataset:
    """Return frequencies and shapes with the static state that they are about."""
    nodes, points = int(built.names.node_ptr[-1]), len(built.names.points)
    first = int(built.system.lines.node_ptr[-1])  # row of the first point
    rate = np.sqrt(np.where(modes.squares >= 0.0, modes.squares, np.nan))
    values = {
        "mode": np.arange(1, len(rate) + 1),
        "frequency": rate / (2.0 * np.pi),
        "period": 2.0 * np.pi / np.where(rate > 0.0, rate, np.nan),
        "mode_shape": modes.shapes[:, :nodes],
        "point_shape": modes.shapes[:, first : first + points],
        "line_energy": np.add.reduceat(modes.energy[:, :nodes], built.names.node_ptr[:-1], axis=1),
        "node_position": built.state.position[:nodes],
    }
    at_rest = {"node_position": ("node", "xyz")}
    ds = xr.Dataset(
        {n: (at_rest.get(n, VARIABLES[n].dims), v, attributes(n)) for n, v in values.items()}, attrs=dict(attrs)
    )
    labels = {"line": index.line, "point": index.point, "node_line": index.node_line, "arc_length": index.arc_length}
    labels |= {"point_kind": index.point_kind, "xyz": np.array(XYZ, dtype=object)}
    return ds.assign_coords({n: (VARIABLES[n].dims, v, attributes(n)) for n, v in labels.items()})


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
    """Return frequency (Hz), period (s), what moves most and along which axis, of each mode; None where not stable."""
    report: list[dict[str, str | float | None]] = []
    for k, number in enumerate(ds["mode"].values):
        motion = (ds["mode_shape"].values[k] ** 2).sum(axis=0) + (ds["point_shape"].values[k] ** 2).sum(axis=0)
        share = ds["line_energy"].values[k]
        moves = f"line {ds['line'].values[np.argmax(share)]}" if share.size and share.max() > 0.5 else "several"
        report.append(
            {
                "mode": int(number),
                "frequency": _number(ds["frequency"][k]),
                "period": _number(ds["period"][k]),
                "moves": moves,
                "along": XYZ[int(np.argmax(motion))] if motion.any() else "",  # nothing but rods and bodies moves
            }
        )
    return report


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
