"""The environment as MoorDyn's options, with the depth and current files that they name."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from moorage.io.moordyn.currents import DYNAMIC, GRID
from moorage.io.moordyn.layout import Flavour
from moorage.model import Bathymetry, Current, CurrentGrid, Environment, Waves

Pair = tuple[str, str]


def environment_options(environment: Environment, path: Path, flavour: Flavour, notes: list[str]) -> list[Pair]:
    """Return the options (value, name) that describe an environment; write the files beside `path`."""
    options = [
        (repr(environment.gravity), "g"),
        (repr(environment.water_density), "rho"),
        (repr(environment.seabed_stiffness), "kBot"),
        (repr(environment.seabed_damping), "cBot"),
    ]
    if environment.seabed_stiffness_map:
        notes.append("the map of the seabed's stiffness cannot be said: kBot is the same everywhere")
    if environment.soil:
        notes.append("soil with suction and a memory cannot be said: the bed is a spring of kBot")
    options += _depth(environment, path, flavour, notes)
    options += _friction(environment, flavour, notes)
    return options + _water(environment, path, flavour, notes)


def _depth(environment: Environment, path: Path, flavour: str, notes: list[str]) -> list[Pair]:
    grid = environment.bathymetry
    depth = (repr(environment.water_depth), "WtrDpth")
    if grid is None:
        return [depth]
    name = f"depth_{path.stem}.txt".replace(" ", "_").replace("---", "_")
    write = _write_list if flavour == "C" else _write_matrix
    write(grid, path.parent / name)
    if flavour == "C":
        notes.append("MoorDyn-C looks for the depth file in the folder that it is started from")
        return [depth, (name, "SeafloorFile")]
    if environment.water_depth != grid.depth_at(0.0, 0.0):
        notes.append("the reference depth has no place in the file: MoorDyn-F takes the depth at the origin")
    return [(name, "WtrDpth")]


def _write_list(grid: Bathymetry, path: Path) -> None:
    rows = [f"{len(grid.x)} {len(grid.y)}", _numbers(*grid.x), _numbers(*grid.y)]
    rows += [_numbers(x, y, -grid.depth[i][j]) for i, x in enumerate(grid.x) for j, y in enumerate(grid.y)]
    path.write_text("\n".join(rows) + "\n", "utf-8")


def _write_matrix(grid: Bathymetry, path: Path) -> None:
    rows = ["--- MoorDyn Bathymetry Input File ---", f"nGridX {len(grid.x)}", f"nGridY {len(grid.y)}"]
    rows.append(_numbers(*grid.x))
    rows += [_numbers(y, *(row[j] for row in grid.depth)) for j, y in enumerate(grid.y)]
    path.write_text("\n".join(rows) + "\n", "utf-8")


def _numbers(*values: float) -> str:
    """Return a row of all digits, of NumPy's numbers too."""
    return " ".join(repr(float(value)) for value in values)


def _friction(environment: Environment, flavour: str, notes: list[str]) -> list[Pair]:
    friction = environment.friction
    if friction is None:
        return []
    if friction.model != "saturated-damping":
        notes.append(f"friction by {friction.model} is written as saturated damping, the only law that MoorDyn has")
    if friction.map or friction.model == "soil-curves":
        what = "map of friction's coefficients" if friction.map else "curves of friction"
        notes.append(f"the {what} cannot be said: written without friction")
    ratio, damping = repr(friction.static_ratio), repr(friction.damping)
    if flavour == "F":
        pair = [(repr(friction.transverse), "mu_kT"), (repr(friction.axial), "mu_kA")]
        return [*pair, (ratio, "mc"), (damping, "cv")]
    if friction.axial != friction.transverse:
        notes.append("MoorDyn-C has one coefficient of friction: the transverse one was written")
    coefficient = (repr(friction.transverse), "FrictionCoefficient")
    return [coefficient, (ratio, "StatDynFricScale"), (damping, "FricDamp")]


def _water(environment: Environment, path: Path, flavour: str, notes: list[str]) -> list[Pair]:
    options = _waves(environment.waves, path, flavour, notes)
    if environment.host_waves:
        options += [("1", "WaveKin")] if flavour == "C" else []
        notes += ["waves of a host cannot be said for MoorDyn-F"] if flavour == "F" else []
    waves = environment.unread_water
    if waves is not None and (waves.option == "WaterKin") == (flavour == "F"):
        notes.append(f"files of {waves.option} {waves.value} are named as they were, not copied")
        options += [(waves.value, waves.option), *((value, name) for name, value in waves.settings)]
    elif waves is not None:
        notes.append(f"waves by {waves.option} cannot be said for MoorDyn-{flavour}")
    still = environment.current == Current()
    if still or any(name == "Currents" for _, name in options) or (waves and flavour == "F" and options):
        return options
    if isinstance(environment.current, CurrentGrid):
        return options + _grid(environment.current, path.parent, flavour, notes)
    if flavour == "C":
        _write_profile(environment.current, path.parent / "current_profile.txt")
        notes.append("the current is in current_profile.txt, the one name that MoorDyn-C reads in this folder")
        return [*options, ("1", "Currents")]
    if any(w for _, _, w in environment.current.velocity):
        notes.append("vertical currents cannot be said for MoorDyn-F")
    name = f"water_{path.stem}.txt".replace(" ", "_").replace("---", "_")
    _write_water_file(environment.current, path.parent / name)
    return [(name, "WaterKin")]


def _waves(waves: Waves | None, path: Path, flavour: str, notes: list[str]) -> list[Pair]:
    """Return the option of waves, and write the components for MoorDyn-C's sum of sines."""
    if waves is None:
        return []
    if flavour == "F":
        notes.append("waves cannot be said for MoorDyn-F, which takes an elevation and a grid")
        return []
    if waves.crests:
        notes.append("the harmonics of a steep wave cannot be said for MoorDyn-C, whose waves are free ones")
        return []
    for name, value in (("a ramp", waves.ramp), (f"{waves.stretching} stretching", waves.stretching != "wheeler")):
        if value:
            notes.append(f"{name} of the waves cannot be said for MoorDyn-C")
    parts = np.array(waves.amplitude) * np.exp(1j * (np.array(waves.phase) + 0.5 * np.pi))
    way = np.array(waves.direction)
    way = np.where(np.abs(way) > 2.0 * np.pi, np.angle(np.exp(1j * way)), way)  # MoorDyn-C takes no more than a turn
    columns = zip(waves.frequency, parts.real, parts.imag, way, strict=True)
    rows = [_numbers(0, 0, 0, 0), *(_numbers(*row) for row in columns)]
    (path.parent / "wave_frequencies.txt").write_text("\n".join(rows) + "\n", "utf-8")
    notes.append("the waves are in wave_frequencies.txt, the one name that MoorDyn-C reads in this folder")
    return [("7", "WaveKin")]


def _write_profile(current: Current, path: Path) -> None:
    rows = ["--- MoorDyn steady currents File ---", "Profile", "z (m) ux (m/s) uy (m/s) uz (m/s)"]
    rows += [" ".join(map(repr, (z, *v))) for z, v in zip(current.z, current.velocity, strict=True)]
    path.write_text("\n".join(rows) + "\n", "utf-8")


def _grid(current: CurrentGrid, folder: Path, flavour: str, notes: list[str]) -> list[Pair]:
    """Return the option of a current that changes, and write its file."""
    if flavour == "F" or current.turn:
        what = f"MoorDyn-{flavour}" if flavour == "F" else "MoorDyn-C: its grid is turned against the model's axes"
        notes.append(f"a current over time and place cannot be said for {what}")
        return []
    profile = current.shape[1:3] == (1, 1) and current.shape[0] > 1
    name, write, option = (DYNAMIC, _write_dynamic, "2") if profile else (GRID, _write_grid, "5")
    write(current, folder / name)
    notes.append(f"the current is in {name}, the one name that MoorDyn-C reads in this folder")
    notes.append("MoorDyn-C starts the times of a current again after the last one, here that goes on")
    return [(option, "Currents")]


def _write_dynamic(current: CurrentGrid, path: Path) -> None:
    rows = ["--- MoorDyn dynamic currents file ---", "levels (m), then time (s) and ux, uy, uz (m/s) at each", "", ""]
    rows += [_numbers(*current.z), "-"]
    rows += [_numbers(t, *v[0, 0].T.ravel()) for t, v in zip(current.t, current.velocity, strict=True)]
    path.write_text("\n".join(rows) + "\n", "utf-8")


def _write_grid(current: CurrentGrid, path: Path) -> None:
    nt, nx, ny, nz = current.shape
    axes = [*(_numbers(*axis) for axis in (current.x, current.y, current.z, current.t))]
    points = [
        _numbers(x, y, z, t, *current.velocity[a, i, j, k])
        for i, x in enumerate(current.x)
        for j, y in enumerate(current.y)
        for k, z in enumerate(current.z)
        for a, t in enumerate(current.t)
    ]
    # MoorDyn-C leaves out the first point, so that it comes twice
    path.write_text("\n".join([f"{nx} {ny} {nz} {nt}", *axes, points[0], *points]) + "\n", "utf-8")


def _write_water_file(current: Current, path: Path) -> None:
    grid = ["1 - input type", "0 - grid"] * 3
    rows = ["MoorDyn Waves and Currents input file", "-", "--- WAVES ---", "0 WaveKinMod"]
    rows += ['"" WaveKinFile', "0 dtWave", "0 WaveDir", *grid, "--- CURRENT ---", "1 CurrentMod"]
    rows += ["z-depth x-current y-current", "(m) (m/s) (m/s)"]
    rows += [" ".join(map(repr, (z, u, v))) for z, (u, v, _) in zip(current.z, current.velocity, strict=True)]
    path.write_text("\n".join([*rows, "--- need this line ---"]) + "\n", "utf-8")
