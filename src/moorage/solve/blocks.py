"""From the buffers of a record to a block: named arrays of successive output times."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array

from moorage.physics.motion import sample_track
from moorage.solve import record as columns
from moorage.solve.carried import Block, carried
from moorage.solve.reactions import reactions
from moorage.solve.record import Record
from moorage.solve.reeling import Rows, in_rows, length_columns
from moorage.system.build import Built


def block_of(built: Built, record: Record, rows: int, node_rows: int | None, result_rows: Rows | None = None) -> Block:
    """Split the buffers of a record into named arrays of the first `rows` times; what can be a view is one.

    node_rows: times of node histories, None: without these; result_rows: where they stand in a result with winches.
    """
    c, named = columns, len(built.names.lines)
    lines = record.lines[:rows, :named]

    def at_ends(first: int, width: int) -> np.ndarray:
        """Columns of end A and then of end B, (rows, lines, 2, width)."""
        return lines[:, :, first : first + 2 * width].reshape(rows, lines.shape[1], 2, width)

    force = at_ends(c.FORCE_A, 3)
    points = record.points[:rows].copy()
    _fill_prescribed(built, record.time[:rows], points)
    load = at_ends(c.LOAD_A, 3)
    holder_force, holder_load = _on_holders(built, force, load)
    named = len(built.names.points)
    w = record.watch[:rows]
    block = {
        "time": record.time[:rows],
        "end_force": force,
        "end_load": load,
        "end_tension": at_ends(c.TENSION_A, 1)[..., 0],
        "end_moment": at_ends(c.MOMENT_A, 3),
        "lowest_tension": lines[:, :, c.LOWEST],
        "grounded_length": lines[:, :, c.GROUNDED],
        "dissipated_energy": lines[:, :, c.HEAT],
        "point_position": points[:, :named, 0:3],
        "point_velocity": points[:, :named, 3:6],
        "point_acceleration": points[:, :named, 6:9],
        "point_force": holder_force[:, :named],
        "holder_force": holder_force,
        "holder_load": holder_load,
        "holder_position": points[:, :, 0:3],
        **_carried(built, points, record, rows),
        "watch_position": w[:, :, c.POSITION : c.POSITION + 3],
        "watch_velocity": w[:, :, c.VELOCITY : c.VELOCITY + 3],
        "watch_force": w[:, :, c.FORCE : c.FORCE + 3],
        "watch_tension": w[:, :, c.TENSION],
        "watch_lift": w[:, :, c.LIFT],
        "watch_bed": w[:, :, c.BED : c.BED + 3],
    }
    if node_rows is not None:
        n, segments = int(built.names.node_ptr[-1]), int(built.names.segment_ptr[-1])
        histories = {
            "node_time": record.node_time[:node_rows],
            "node_position": record.node_position[:node_rows, :n],
            "node_velocity": record.node_velocity[:node_rows, :n],
            "segment_tension": record.segment_tension[:node_rows, :segments],
            "seabed_gap": record.contact[:node_rows, :n, columns.GAP],
            "seabed_force": record.contact[:node_rows, :n, columns.NORMAL],
            "friction_force": record.contact[:node_rows, :n, columns.RUB :],
            "curvature": record.curvature[:node_rows, :n],
            "bending_moment": record.moment[:node_rows, :n],
        }
        block |= histories if built.reeled is None else in_rows(histories, result_rows, built)
    return block if built.reeled is None else block | length_columns(built, block["time"])


def reactions_of(built: Built, record: Record) -> Block:
    """Return what rods and bodies (n, k, 6) do to what holds them, see `moorage.solve.reactions`."""
    points = record.points.copy()
    _fill_prescribed(built, record.time, points)
    block = _carried(built, points, record, len(record.time), inertia=True)
    return reactions(built, block, points, record.time) if block else {}


def _carried(built: Built, points: np.ndarray, record: Record, rows: int, inertia: bool = False) -> Block:
    """Return the columns of rods and bodies; inertia: that of lines and nodes of rods is in the forces."""
    if not len(built.rods.line) and not len(built.bodies.object):
        return {}
    c, named = columns, len(built.names.lines)
    rods, objects = record.lines[:rows, named:], record.objects[:rows]
    ends = record.lines[:rows, :named]
    force, moment = (c.FORCE_A, c.MOMENT_A) if inertia else (c.LOAD_A, c.MOMENT_B)
    loads = {
        "end_load": ends[:, :, force : force + 6].reshape(rows, named, 2, 3),
        "end_moment": ends[:, :, c.MOMENT_A : c.MOMENT_A + 6].reshape(rows, named, 2, 3),
        "rod_load": rods[:, :, force : force + 3],
        "rod_load_moment": rods[:, :, moment : moment + 3],
    }
    motion = {
        "object_position": objects[:, :, c.PLACE : c.PLACE + 3],
        "object_velocity": objects[:, :, c.SPEED : c.SPEED + 3],
        "object_acceleration": objects[:, :, c.RISE : c.RISE + 3],
        "object_rotation": objects[:, :, c.TURN : c.TURN + 9].reshape(*objects.shape[:2], 3, 3),
        "object_spin": objects[:, :, c.SPIN : c.SPIN + 3],
        "object_twist": objects[:, :, c.TWIST : c.TWIST + 3],
    }
    return carried(built, points, motion, loads, record.time[:rows])


def _fill_prescribed(built: Built, times, points) -> None:
    tracks = built.system.tracks
    held = np.setdiff1d(np.arange(points.shape[1]), built.system.islands.points)
    points[:, held, :3] = tracks.rest[held]
    for k in held[tracks.track[held] >= 0]:
        sample_track(tracks, k, times, points[:, k, 0:3], points[:, k, 3:6], points[:, k, 6:9])


def _on_holders(built: Built, *forces: np.ndarray) -> tuple[np.ndarray, ...]:
    """Sums (n, points, 3) of forces (n, lines, 2, 3) of all lines on each point and rod end."""
    ends = built.system.lines.end_point[: len(built.names.lines)].ravel()
    n, points = len(forces[0]), len(built.system.points.mass)
    holds = csr_array((np.ones(len(ends)), (ends, np.arange(len(ends)))), shape=(points, len(ends)))
    by_end = np.concatenate([f.reshape(n, len(ends), 3).swapaxes(0, 1) for f in forces], axis=1)
    sums = (holds @ by_end.reshape(len(ends), 3 * n * len(forces))).reshape(points, len(forces), n, 3)
    return tuple(sums[:, k].swapaxes(0, 1) for k in range(len(forces)))
