"""States in files: those of MoorDyn (positions and velocities), and whole ones of our own, bit for bit.

MoorDyn's binary layout, all little-endian: "MoorDyn", two bytes of version, the number of 8-byte words that follow, the
number of objects, then for each body, rod, point and line the numbers of rows and columns (integers) and the rows:
position and velocity, zeros for what is not free. A line gives its inner nodes. Bodies and rods have one row of 13:
position, quaternion (x, y, z, w; of a rod from where it is described), velocity, angular velocity; a pinned one has no
position and velocity. MoorDyn has no rotation for a rod of no length: where there is none, the cables on it turn it.
Older files leave out what is not free.
"""

from __future__ import annotations

import io
import struct
from itertools import pairwise
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from moorage.errors import MoorageError
from moorage.layout import State, copy_of
from moorage.moordyn.handles import live, raising
from moorage.moordyn.system import System
from moorage.solve.statics import solve
from moorage.system.build import Built
from moorage.system.joints import turn_joints
from moorage.system.objects import objects_of

HEAD = b"MoorDyn" + bytes([2, 7])
UNTURNED = (0.0, 0.0, 0.0, 1.0)  # quaternion


@raising
def SaveState(instance: System, filepath: str) -> None:
    """Write positions and velocities in MoorDyn's format."""
    system = live(instance)
    state = system.built.state
    parts = [carrier_row(system, *thing) for thing in carriers(system)]
    for rows, moves in rows_of(system):
        parts.append(moves * np.hstack([state.position[rows], state.velocity[rows]]))
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


def carriers(system: System) -> list[tuple[str, int, int]]:
    """Return kind, place and object (-1: not one) of all bodies, then of all rods."""
    number, model = {name: o for o, name in enumerate(system.built.names.objects)}, system.model
    things = (("body", model.bodies), ("rod", model.rods))
    return [(kind, k, number.get((kind, x.id), -1)) for kind, group in things for k, x in enumerate(group)]  # type: ignore[attr-defined]


def carrier_row(system: System, kind: str, place: int, o: int) -> np.ndarray:
    """Return the row (1, 13) of a body or rod."""
    out, state, built = np.zeros((1, 13)), system.built.state, system.built
    if o >= 0:
        row, R = int(built.system.riders.row[o]), state.attitude[o].reshape(3, 3)
        if built.system.riders.pin[o] < 0:
            out[0, :3], out[0, 7:10] = state.position[row], state.velocity[row]
        out[0, 3:7] = Rotation.from_matrix(R @ described_turn(system, o).T).as_quat()
        out[0, 10:] = R @ state.velocity[row + 1]
    elif kind == "rod" and (row := joint_row(built, place)) >= 0:
        out[0, :3], out[0, 6], out[0, 7:10] = state.position[row], 1.0, state.velocity[row]
    return out


def put_carrier(system: System, state: State, kind: str, place: int, o: int, values: np.ndarray) -> None:
    """Set the motion of a body or rod from its row (13,)."""
    built = system.built
    if o >= 0:
        row = int(built.system.riders.row[o])
        if built.system.riders.pin[o] < 0:
            state.position[row], state.velocity[row] = values[:3], values[7:10]
        R = Rotation.from_quat(values[3:7]).as_matrix() @ described_turn(system, o)
        state.frames[:, o] = R.ravel()
        state.position[row + 1], state.velocity[row + 1] = 0.0, R.T @ values[10:]
    elif kind == "rod" and (row := joint_row(built, place)) >= 0:
        state.position[row], state.velocity[row] = values[:3], values[7:10]


def joint_row(built: Built, place: int) -> int:
    """Return the state row of a free rod of no length, which joins lines; -1: the rod is none."""
    holder = int(built.rods.ends[place, 0])
    joins = holder in built.system.islands.points and built.system.riders.points[holder] < 0
    return int(built.system.lines.node_ptr[-1]) + holder if joins else -1


def is_turned_joint(system: System, kind: str, place: int, o: int) -> bool:
    """Return whether a thing is a rod of no length that cables turn."""
    return kind == "rod" and o >= 0 and not system.model.rods[place].segments


def described_turn(system: System, o: int) -> np.ndarray:
    """Return the rotation (3, 3) from which MoorDyn's file counts that of an object: of rods, as they are described."""
    kind, _ = system.built.names.objects[o]
    return objects_of(system.model).rotation[o] if kind == "rod" else np.eye(3)


def rows_of(system: System) -> list[tuple[np.ndarray, bool]]:
    """Return the state rows of each point, and of the inner nodes of each line; and whether they are free."""
    built = system.built
    first, free, riding = int(built.system.lines.node_ptr[-1]), built.system.islands.points, built.system.riders.points
    points = [(np.array([first + k]), k in free and riding[k] < 0) for k in range(len(system.model.points))]
    return points + [(np.arange(a + 1, b - 1), True) for a, b in pairwise(built.names.node_ptr)]


def read_state(system: System, path: Path) -> None:
    """Set positions and velocities from a file of MoorDyn."""
    parts, things, rows = unpack(path.read_bytes(), path), carriers(system), rows_of(system)
    moves = [carrier_row(system, *thing).any() for thing in things] + [free for _, free in rows]
    if len(parts) == sum(moves) < len(moves):  # older files
        left = iter(parts)
        parts = [next(left) if free else np.zeros((0, 0)) for free in moves]
    wanted = [(1, 13)] * len(things) + [(len(r), 6) for r, _ in rows]
    if len(parts) != len(moves) or any(
        free and part.shape != shape for free, part, shape in zip(moves, parts, wanted, strict=True)
    ):
        shapes = ", ".join(f"{len(p)} x {p.shape[1]}" for p in parts)
        raise MoorageError(f"{path}: the state is of another system: its objects have {shapes} numbers")
    if not all(np.isfinite(part).all() for part in parts):
        raise MoorageError(f"{path}: the state has numbers that are not finite")
    state = copy_of(system.built.state)
    for thing, part, free in zip(things, parts, moves, strict=False):
        if free and not (thing[2] >= 0 and not part[0, 3:7].any()):
            put_carrier(system, state, *thing, part[0])
    for (where, free), part in zip(rows, parts[len(things) :], strict=True):
        if free:
            state.position[where], state.velocity[where] = part[:, :3], part[:, 3:]
    joints = [part[0] for thing, part in zip(things, parts, strict=False) if is_turned_joint(system, *thing)]
    if any(tuple(values[3:7]) == UNTURNED for values in joints):
        turn_joints(system.built.system, state)
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
