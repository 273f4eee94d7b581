"""One script for MoorDyn-C's module and for ours: a deck, the way of what is coupled, and what is seen after each step."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
from beside import read
from moorings import at_rest, run

from moorage.model.motion import rotation_matrices


class Scene(NamedTuple):
    """A deck of MoorDyn-C's tests, and what is done with it.

    `drop`: options that are left out; `swap`: texts and what stands for them. `way`: places of what is coupled over time.
    `static`: both start from statics of their own. Otherwise MoorDyn-C starts from our state, or both from `state`.
    `step`: our longest step, s; `rk4`: our step with MoorDyn-C's own method.
    """

    deck: str
    duration: float  # s
    interval: float = 0.1  # coupling step, s
    drop: Sequence[str] = ()
    swap: Sequence[tuple[str, str]] = ()
    files: Sequence[tuple[str, str]] = ()
    way: Callable[[float], Sequence[float]] = lambda t: ()
    static: bool = False
    state: bytes | None = None
    step: float | None = None
    rk4: float | None = None


Seen = dict[str, np.ndarray]


def write(scene: Scene, folder: Path) -> str:
    """Write the deck of a scene, with its changes, into the present folder; return its name."""
    text = (folder / scene.deck).read_text("utf-8", errors="replace")
    for option in scene.drop:
        text, count = re.subn(rf"(?mi)^\S+\s+{option}\b.*\n", "", text)
        assert count == 1, option
    for old, new in scene.swap:
        assert old in text, old
        text = text.replace(old, new)
    for name, content in (("deck.txt", text), *scene.files):
        Path(name).write_text(content, "utf-8")
    return "deck.txt"


def watch(m, scene: Scene, folder: Path, state: bytes | None = None) -> tuple[Seen, bytes]:
    """Play a scene with a module; return what was seen, by channel with time first, and the first state of ours.

    Channels: `tension` of end B, N; `position` of points, ends of rods, middles of lines and bodies, m; `attitude` of
    bodies, their matrices; `force` on what is coupled, N.
    """
    system, x = m.Create(write(scene, folder)), list(map(float, scene.way(0.0)))
    m.SetVerbosity(system, m.LEVEL_ERR)
    assert (m.Init if scene.static else m.Init_NoIC)(system, x, [0.0] * len(x)) == 0
    first = b""
    if m.__name__ != "moordyn":
        m.SaveState(system, "first.ic")
        first = Path("first.ic").read_bytes()
    if state is not None:
        Path("state.ic").write_bytes(state)
        m.LoadState(system, "state.ic")
    if scene.step and m.__name__ != "moordyn":
        m.SetDt(system, scene.step)
    kinds = ("Line", "Point", "Rod", "Body")
    numbers = [getattr(m, f"GetNumber{name.replace('Body', 'Bodie')}s")(system) for name in kinds]
    things = [[getattr(m, f"Get{k}")(system, i + 1) for i in range(n)] for k, n in zip(kinds, numbers, strict=True)]
    rows = []
    for k in range(round(scene.duration / scene.interval)):
        begin, end = (np.array(scene.way(j * scene.interval), float) for j in (k, k + 1))
        force = m.Step(
            system, begin.tolist(), ((end - begin) / scene.interval).tolist(), k * scene.interval, scene.interval
        )
        rows.append({"force": force, **_look(m, *things)})
    m.Close(system)
    return {name: np.array([row[name] for row in rows]) for name in rows[0] if np.size(rows[0][name])}, first


def _look(m, lines, points, rods, bodies) -> Seen:
    poses = np.array([m.GetBodyState(body)[0] for body in bodies]).reshape(-1, 6)
    middles = [m.GetLineNodePos(line, m.GetLineNumberNodes(line) // 2) for line in lines]
    ends = [m.GetRodNodePos(rod, i) for rod in rods for i in (0, m.GetRodN(rod))]
    return {
        "tension": np.array([m.GetLineFairTen(line) for line in lines]),
        "position": np.array([*(m.GetPointPos(point) for point in points), *ends, *middles, *poses[:, :3]]),
        "attitude": rotation_matrices(poses[:, 3:]),
    }


def by_runge_kutta(scene: Scene, folder: Path) -> Seen:
    """Play a scene without a host by our engine with MoorDyn-C's method and step."""
    built = at_rest(read(write(scene, folder)))
    out = scene.interval
    block = run(built, scene.duration, dt_out=out, dt_nodes=out, method="rk4", time_step=scene.rk4)
    ptr = built.names.node_ptr
    middles = [int(a + (b - a) // 2) for a, b in pairwise(ptr)]
    n = len(block["time"])
    ends = block["rod_position"].reshape(n, -1, 3) if "rod_position" in block else np.zeros((n, 0, 3))
    place = np.concatenate([block["point_position"], ends, block["node_position"][:, middles]], axis=1)
    return {"tension": np.linalg.norm(block["end_load"][1:, :, 1], axis=-1), "position": place[1:]}


def off(mine: np.ndarray, other: np.ndarray) -> float:
    """Rms of the difference over the rms deviation of the other from its mean."""
    return float(np.sqrt(np.mean((mine - other) ** 2) / np.mean((other - other.mean(axis=0)) ** 2)))


def packed(*parts: np.ndarray) -> bytes:
    """Return a state in MoorDyn's format: rows of bodies, rods (13 numbers), points and lines (6)."""
    data = struct.pack("<Q", len(parts))
    data += b"".join(struct.pack("<QQ", *p.shape) + p.astype("<f8").tobytes() for p in parts)
    return b"MoorDyn" + bytes([2, 7]) + struct.pack("<Q", len(data) // 8) + data
