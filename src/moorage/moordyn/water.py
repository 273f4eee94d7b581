"""Water and seabed: kinematics that the host gives, and what there is of waves and depth."""

from __future__ import annotations

import numpy as np

from moorage.moordyn import codes
from moorage.moordyn.handles import Seafloor, Waves, live, raising, to_tuple
from moorage.moordyn.system import System
from moorage.results.rod_nodes import rod_nodes
from moorage.solve.water_at import row_of_body, row_of_holder, water_at
from moorage.system.build import Built


def ExternalWaveKinInit(instance: System) -> int:
    """Return the number of places where the host may give the motion of the water (option WaveKin 1).

    They are those of MoorDyn: the nodes of all lines from end A to end B, those of all rods, the points, the ground and
    the bodies, each in the order of the file.
    """
    return len(water_rows(live(instance)))


def ExternalWaveKinGetN(instance: System) -> int:
    """Return the number of those places."""
    return ExternalWaveKinInit(instance)


def ExternalWaveKinGetCoordinates(instance: System) -> list[list[float]]:
    """Return those places, (n, 3), m."""
    system = live(instance)
    block, rods = system.block, rod_nodes(system.model, system.built)
    now = {name: values[None] for name, values in block.items()}
    places = [block["node_position"], *(nodes.position(now)[0] for nodes in rods), block["point_position"]]
    places += [np.zeros((1, 3)), block.get("body_position", np.zeros((0, 3)))]
    return np.concatenate(places).tolist()


def GetWaveKinCoordinates(instance: System) -> list[list[float]]:
    """Return the same as `ExternalWaveKinGetCoordinates`."""
    return ExternalWaveKinGetCoordinates(instance)


@raising
def ExternalWaveKinSet(instance: System, u, a, t: float) -> int:
    """Set velocity (m/s) and acceleration (m/s2) of the waves, (n, 3), from now on; return 0. A current is added."""
    system, values = live(instance), []
    if system.model.environment.waves is not None:
        raise RuntimeError("ExternalWaveKinSet: the model has waves of its own; remove them")
    rows = water_rows(system)
    nodes = len(rows)
    for name, given in (("velocities", u), ("accelerations", a)):
        array = np.array(given, dtype=float)
        if array.shape != (nodes, 3):
            raise ValueError(f"ExternalWaveKinSet: {name} must be {nodes} x 3 numbers, not of shape {array.shape}")
        if not np.isfinite(array).all():
            raise RuntimeError(f"ExternalWaveKinSet: NaN or inf among the {name}")
        values.append(array)
    known = rows >= 0
    system.set_water(*_with_ends(system.built, rows[known], np.hstack(values)[known]))
    return codes.ERRCODE_SUCCESS


def water_rows(system: System) -> np.ndarray:
    """Return the state row of each place, (n,); -1: the ground's, whose water moves nothing."""
    built, first = system.built, int(system.built.names.node_ptr[-1])
    rows = list(range(first))
    for ends, line in zip(built.rods.ends, built.rods.line, strict=True):
        rows += range(*built.system.lines.node_ptr[line : line + 2]) if line >= 0 else [row_of_holder(built, ends[0])]
    rows += [row_of_holder(built, k) for k in range(len(system.model.points))]
    return np.array(rows + [-1] + [row_of_body(built, k) for k in range(len(system.model.bodies))], dtype=np.int64)


def _with_ends(built: Built, rows: np.ndarray, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Add the rows of the ends of rods, where the water is that of their end nodes."""
    ends, nodes = [], []
    for holders, line in zip(built.rods.ends, built.rods.line, strict=True):
        if line >= 0:
            a, b = built.system.lines.node_ptr[line : line + 2]
            ends += [row_of_holder(built, holder) for holder in holders]
            nodes += [int(np.flatnonzero(rows == row)[0]) for row in (a, b - 1)]
    return np.concatenate([rows, np.array(ends, dtype=np.int64)]), np.concatenate([values, values[nodes]])


def SetWaveKin(instance: System, u, a, t: float) -> int:
    """Do the same as `ExternalWaveKinSet`."""
    return ExternalWaveKinSet(instance, u, a, t)


def GetWaves(instance: System) -> Waves:
    """Return the sea."""
    return Waves(live(instance))


def GetSeafloor(instance: System) -> Seafloor | None:
    """Return the seabed where it has a depth grid, else None."""
    system = live(instance)
    return Seafloor(system) if system.model.environment.bathymetry is not None else None


def GetWavesKin(instance: Waves, x: float, y: float, z: float, seafloor: Seafloor | None = None):
    """Return velocity (m/s) and acceleration (m/s2) of the water, elevation (m) and dynamic pressure (Pa) at a place.

    The pressure is that of linear waves, and 0 in still water.
    """
    system = live(instance.system)
    place = np.array([[x, y, z]], dtype=float)
    eta, *motion = water_at(system.built, np.array([system.time]), place)[0]
    waves = system.model.environment.waves
    pressure = 0.0 if waves is None else float(waves.kinematics(system.time, place[0]).pressure)
    return to_tuple(np.array(motion[:3])), to_tuple(np.array(motion[3:])), float(eta), pressure


def GetDepthAt(instance: Seafloor, x: float, y: float) -> float:
    """Return the z of the seabed at a place, m (negative: MoorDyn's word is depth, its number is a level)."""
    return -float(live(instance.system).model.environment.depth_at(x, y))


def GetAverageDepth(instance: Seafloor) -> float:
    """Return the mean z of the points of the depth grid, m."""
    return -float(np.mean(_grid(instance)))


def GetMinDepth(instance: Seafloor) -> float:
    """Return the z of the shallowest point of the depth grid, m."""
    return -float(np.min(_grid(instance)))


def _grid(instance: Seafloor) -> np.ndarray:
    bed = live(instance.system).model.environment.bathymetry
    assert bed is not None
    return np.array(bed.depth)
