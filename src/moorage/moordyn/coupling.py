"""The vector of coupled degrees of freedom: what a host moves, and what the mooring does to it.

A host gives position and Euler angles (intrinsic XYZ) of coupled bodies and rods, and positions of coupled points: all
bodies first, then rods, then points, in the order of the file, six numbers each and three for points and pinned ones.
Each row that the host drives (a point, an end of a rod, the direction of a clamp) sits in the axes of one of them.
"""

from __future__ import annotations

import numpy as np

from moorage.model import Model
from moorage.model.motion import MOVED, rotation_matrices
from moorage.system.build import Built
from moorage.system.holders import holders_of


class Coupling:
    """How the coupled degrees of freedom move the driven rows.

    Parameters
    ----------
    model : Model
    built : Built
    driven : (m,) int
        As of `HostMarch`.

    Attributes
    ----------
    owners : tuple of (kind, id, width)
        The coupled objects in the order of the vector.
    size : int
        Number of degrees of freedom.
    """

    def __init__(self, model: Model, built: Built, driven: np.ndarray):
        self.owners = tuple(coupled_objects(model))
        self.starts = np.cumsum([0, *(width for _, _, width in self.owners)])
        self.size = int(self.starts[-1])
        rows = driven_rows(model, built)
        number = {(kind, id): k for k, (kind, id, _) in enumerate(self.owners)}
        known = [rows[track] for track in driven]
        self.owner = np.array([number[kind, id] for kind, id, _, _ in known], dtype=int)
        self.local = np.array([local for _, _, local, _ in known], dtype=float).reshape(-1, 3)
        self.shifts = np.array([shifts for _, _, _, shifts in known], dtype=float)[:, None]
        self._place = (self.starts[:-1, None] + np.arange(3))[self.owner]
        self._turning = [k for k, (_, _, width) in enumerate(self.owners) if width == 6]
        self._angles = self.starts[self._turning, None] + np.arange(3, 6)
        self._turned = np.isin(self.owner, self._turning)

    def at(self, pose: np.ndarray, rate: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return positions and velocities (m, 3) of the driven rows, for the vector (size,) and its rate."""
        position, velocity = pose[self._place], rate[self._place]
        if self._turning:
            R, spin = self._rotations(pose, rate)
            arm = np.einsum("kij,kj->ki", R[self.owner], self.local)
            position = self.shifts * position + arm
            velocity = self.shifts * velocity + np.cross(spin[self.owner], arm)
        return position, velocity

    def gather(self, pose: np.ndarray, force: np.ndarray, moment: np.ndarray) -> np.ndarray:
        """Return the vector (size,) of forces, and moments about the origin of each object, from those on the rows."""
        out = np.zeros(self.size)
        n = len(force)
        np.add.at(out, self._place[:n].ravel(), force.ravel())
        if self._turning:
            R, _ = self._rotations(pose, np.zeros_like(pose))
            arm = np.einsum("kij,kj->ki", R[self.owner[:n]], self.local[:n])
            turned = self._turned[:n]
            total = (np.cross(arm, force) + moment)[turned]
            np.add.at(out, (self._place[:n][turned] + 3).ravel(), total.ravel())
        return out

    def _rotations(self, pose, rate) -> tuple[np.ndarray, np.ndarray]:
        """Rotation matrices (owners, 3, 3) and angular velocities (owners, 3), rad/s, in global axes."""
        R = np.tile(np.eye(3), (len(self.owners), 1, 1))
        spin = np.zeros((len(self.owners), 3))
        angles, rates = pose[self._angles], rate[self._angles]
        R[self._turning] = rotation_matrices(angles)
        spin[self._turning] = angular_velocity(angles, rates)
        return R, spin


def coupled_objects(model: Model) -> list[tuple[str, int, int]]:
    """Return (kind, id, number of degrees of freedom) of the coupled objects, in the order of the vector."""
    width = {"coupled": 6, "coupled-pinned": 3}
    bodies = [("body", body.id, width[body.kind]) for body in model.bodies if body.kind in MOVED]
    rods = [("rod", rod.id, width[rod.kind]) for rod in model.rods if rod.kind in MOVED and rod.body is None]
    return bodies + rods + [("point", point.id, 3) for point in model.coupled_points]


def described(model: Model) -> np.ndarray:
    """Return the vector (size,) of the coupled objects as the model describes them."""
    parts: list[np.ndarray] = []
    for kind, id, width in coupled_objects(model):
        if kind == "point":
            parts.append(np.array(model.point(id).position))
        elif kind == "body":
            body = next(body for body in model.bodies if body.id == id)
            parts.append(np.array([*body.position, *body.rotation])[:width])
        else:
            rod = next(rod for rod in model.rods if rod.id == id)
            parts.append(np.array([*rod.end_a, *angles_of(np.array(rod.direction))])[:width])
    return np.concatenate(parts) if parts else np.zeros(0)


def driven_rows(model: Model, built: Built) -> dict[int, tuple[str, int, np.ndarray, float]]:
    """Return (kind and id of the owner, place in its axes, 1 or 0 for a direction) of each track that moves."""
    holders, rows = holders_of(model, None, None), {}
    moved = {body.id for body in model.bodies if body.kind in MOVED}
    axes = {}  # of each coupled rod or rod on a coupled body: its owner and its axis there
    for point in model.points:
        track = next(k for a, k in holders.number.items() if a.kind == "point" and a.id == point.id)
        if point.body in moved:
            rows[track] = ("body", point.body, np.array(point.position), 1.0)
        elif point.kind == "coupled" and point.body is None:
            rows[track] = ("point", point.id, np.zeros(3), 1.0)
    for rod in model.rods:
        length = float(np.linalg.norm(np.subtract(rod.end_b, rod.end_a))) if rod.segments else 0.0
        if rod.body in moved:
            owner, start, axis = ("body", rod.body), np.array(rod.end_a), np.array(rod.direction)
        elif rod.kind in MOVED and rod.body is None:
            owner, start, axis = ("rod", rod.id), np.zeros(3), np.array([0.0, 0.0, 1.0])
        else:
            continue
        axes[rod.id] = owner, axis
        for attachment, track in holders.number.items():
            if attachment.kind == "rod" and attachment.id == rod.id:
                rows[track] = (*owner, start + (length * axis if attachment.end == "B" else 0.0), 1.0)
    for k, line in enumerate(model.lines):
        for end, attachment in enumerate((line.end_a, line.end_b)):
            track = built.system.bending.direction[k, end]
            if track >= 0 and attachment.kind == "rod" and attachment.id in axes:
                owner, axis = axes[attachment.id]
                rows[int(track)] = (*owner, -axis if attachment.end == "A" else axis, 0.0)
    return rows  # type: ignore[return-value]


def angular_velocity(angles: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """Return the angular velocity (n, 3) in global axes of intrinsic XYZ angles (n, 3) that change at `rates`."""
    roll, pitch = angles[:, 0], angles[:, 1]
    zero, one = np.zeros_like(roll), np.ones_like(roll)
    x = np.stack([one, zero, zero], axis=1)
    y = np.stack([zero, np.cos(roll), np.sin(roll)], axis=1)
    z = np.stack([np.sin(pitch), -np.sin(roll) * np.cos(pitch), np.cos(roll) * np.cos(pitch)], axis=1)
    return rates[:, :1] * x + rates[:, 1:2] * y + rates[:, 2:] * z


def angles_of(axis: np.ndarray) -> np.ndarray:
    """Return roll and pitch (and no yaw) that turn the vertical into a unit vector; the inverse of R e_z."""
    if not axis.any():
        return np.zeros(3)
    pitch = np.arcsin(np.clip(axis[0], -1.0, 1.0))
    return np.array([np.arctan2(-axis[1], axis[2]), pitch, 0.0])
