"""Water and seabed: kinematics that the host gives, and what there is of waves and depth."""

from __future__ import annotations

import numpy as np

from moorage.moordyn import codes
from moorage.moordyn.handles import Seafloor, Waves, live, raising, to_tuple
from moorage.moordyn.system import System
from moorage.solve.water_at import water_at


def ExternalWaveKinInit(instance: System) -> int:
    """Return the number of places where the host may give the motion of the water (option WaveKin 1): the nodes."""
    system = live(instance)
    nodes = int(system.built.names.node_ptr[-1])
    if system.water is None:
        system.water = np.zeros((nodes, 6))
    return nodes


def ExternalWaveKinGetN(instance: System) -> int:
    """Return the number of those places."""
    return ExternalWaveKinInit(instance)


def ExternalWaveKinGetCoordinates(instance: System) -> list[list[float]]:
    """Return those places, (n, 3), m: the nodes of all lines from end A to end B, in the order of the file."""
    return live(instance).block["node_position"].tolist()


def GetWaveKinCoordinates(instance: System) -> list[list[float]]:
    """Return the same as `ExternalWaveKinGetCoordinates`."""
    return ExternalWaveKinGetCoordinates(instance)


@raising
def ExternalWaveKinSet(instance: System, u, a, t: float) -> int:
    """Set velocity (m/s) and acceleration (m/s2) of the water, (n, 3), from now on; return 0."""
    system, values = live(instance), []
    sea = system.built.system
    if sea.sea.parts.shape[1] or sea.current.flows:
        raise RuntimeError("ExternalWaveKinSet: the model has waves or a current of its own; remove them")
    nodes = ExternalWaveKinInit(instance)
    for name, given in (("velocities", u), ("accelerations", a)):
        array = np.array(given, dtype=float)
        if array.shape != (nodes, 3) or not np.isfinite(array).all():
            raise RuntimeError(f"ExternalWaveKinSet: {name} must be {nodes} x 3 finite numbers")
        values.append(array)
    system.water = np.hstack(values)
    return codes.ERRCODE_SUCCESS


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
