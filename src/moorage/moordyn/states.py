"""States in files: those of MoorDyn (positions and velocities), and whole ones of our own, bit for bit.

MoorDyn's binary layout, all little-endian: "MoorDyn", two bytes of version, the number of 8-byte words that follow, the
number of objects, then for each free body, free rod, free point and line the numbers of rows and columns (integers) and
the rows: position and velocity. A line gives its inner nodes. MoorPy's exporter writes all points, not only free ones.
"""

from __future__ import annotations

import io
import struct
from itertools import pairwise
from pathlib import Path

import numpy as np

from moorage.errors import MoorageError
from moorage.layout import copy_of
from moorage.moordyn.handles import live, raising
from moorage.moordyn.system import System
from moorage.solve.statics import solve

HEAD = b"MoorDyn" + bytes([2, 7])


@raising
def SaveState(instance: System, filepath: str) -> None:
    """Write positions and velocities in MoorDyn's format."""
    system = live(instance)
    state = system.built.state
    parts = [np.hstack([state.position[rows], state.velocity[rows]]) for rows in rows_of(system)]
    data = struct.pack("<Q", len(parts))
    data += b"".join(struct.pack("<QQ", *part.shape) + part.astype("<f8").tobytes() for part in parts)
    Path(filepath).write_bytes(HEAD + struct.pack("<Q", len(data) // 8) + data)


@raising
def LoadState(instance: System, filepath: str) -> None:
    """Read positions and velocities in MoorDyn's format and go on from them at the present time."""
    system = live(instance)
    if not system.started:
        raise RuntimeError("LoadState before Init: call Init_NoIC first")
    read_state(system, Path(filepath))


@raising
def Serialize(instance: System) -> bytes:
    """Return the whole state as bytes."""
    if not live(instance).started:
        raise RuntimeError("Serialize before Init: call Init first")
    buffer = io.BytesIO()
    np.savez(buffer, **live(instance).save())  # type: ignore[arg-type]
    return buffer.getvalue()


@raising
def Deserialize(instance: System, data: bytes) -> None:
    """Go back to a state from `Serialize`, bit for bit."""
    try:
        with np.load(io.BytesIO(data), allow_pickle=False) as saved:
            arrays = dict(saved)
    except (ValueError, OSError, EOFError) as error:
        raise RuntimeError(f"these bytes are no saved state: {error}") from error
    live(instance).restore(arrays)


@raising
def Save(instance: System, filepath: str) -> None:
    """Write the whole state into a file."""
    Path(filepath).write_bytes(Serialize(instance))


@raising
def Load(instance: System, filepath: str) -> None:
    """Go back to a state from `Save`; the system is one of the same file after `Init_NoIC`."""
    Deserialize(instance, Path(filepath).read_bytes())


def rows_of(system: System) -> list[np.ndarray]:
    """Return the state rows of each free point and of the inner nodes of each line."""
    ptr = system.built.names.node_ptr
    named = [k for k in sorted(system.built.system.islands.points) if k < len(system.model.points)]
    return [np.array([ptr[-1] + k]) for k in named] + [np.arange(a + 1, b - 1) for a, b in pairwise(ptr)]


def read_state(system: System, path: Path) -> None:
    """Set positions and velocities from a file of MoorDyn."""
    parts, rows = unpack(path.read_bytes(), path), rows_of(system)
    extra = len(parts) - len(rows)
    if extra == len(system.model.points) - (len(rows) - len(system.model.lines)) > 0:  # MoorPy's: all points
        free = system.built.system.islands.points
        lines = len(system.model.lines)
        points = parts[: len(parts) - lines]
        parts = [part for k, part in enumerate(points) if k in free] + parts[len(parts) - lines :]
    if [part.shape for part in parts] != [(len(r), 6) for r in rows]:
        shapes = ", ".join(f"{len(p)} x {p.shape[1]}" for p in parts)
        raise MoorageError(f"{path}: the state is of another system: its objects have {shapes} numbers")
    state = copy_of(system.built.state)
    for where, part in zip(rows, parts, strict=True):
        state.position[where], state.velocity[where] = part[:, :3], part[:, 3:]
    state.stuck[...] = state.position
    system.set_state(state)


def unpack(data: bytes, path: Path) -> list[np.ndarray]:
    """Return the rows of each object in a file of MoorDyn."""
    if data[:7] != b"MoorDyn" or len(data) < 25 or 8 * struct.unpack("<Q", data[9:17])[0] != len(data) - 17:
        raise MoorageError(f"{path} is no state of MoorDyn")
    words, at, parts = data[17:], 8, []
    for _ in range(struct.unpack("<Q", words[:8])[0]):
        rows, columns = struct.unpack("<QQ", words[at : at + 16])
        count = rows * columns
        if at + 16 + 8 * count > len(words):
            raise MoorageError(f"{path}: the state ends early")
        parts.append(np.frombuffer(words, "<f8", count, at + 16).reshape(rows, columns))
        at += 16 + 8 * count
    return parts


def load_initial(system: System, path: Path, static: bool) -> None:
    """Start from a file of MoorDyn (its option fileIC), and from there go to equilibrium."""
    read_state(system, path)
    if static:
        state = copy_of(system.built.state)
        for values in (state.velocity, state.acceleration, state.auxiliary):
            values[...] = 0.0
        solved = system.host.built
        for target, source in zip(solved.state, state, strict=True):
            target[...] = source
        solve(solved)
        system.set_state(copy_of(solved.state))
