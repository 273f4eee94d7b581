"""The vector of coupled degrees of freedom: what a host moves, and what the mooring does to it.

A host gives position and Euler angles (intrinsic XYZ) of turbines, coupled bodies and rods, and positions of coupled
points: all turbines first, then bodies, rods, points, in the order of the file, six numbers each and three for points
and pinned ones. What is on a turbine goes with it and has no numbers of its own. Each row that the host drives (a
point, an end of a rod, a pin, the direction of a clamp, an axis of a body) sits in the axes of one of them.
"""

from __future__ import annotations

import numpy as np

from moorage.model import Attachment, Model, Rod
from moorage.model.motion import MOVED, rotation_matrices
from moorage.model.turbines import on_turbines
from moorage.solve.aboard import Driven, parts_of, with_turbines
from moorage.solve.host import HostMarch
from moorage.solve.reactions import point_load
from moorage.system.build import Built
from moorage.system.holders import Holders, holders_of
from moorage.system.objects import angles_of, rod_length


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
    carries : bool
        Whether there are rods or bodies among them.
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
        holder = {id: row for row, (kind, id, _, _) in enumerate(known) if kind == "point"}
        self._points = {id: (row, int(driven[row])) for id, row in holder.items()}
        self._carriers = {("body", body.id): k for k, body in enumerate(model.bodies) if body.kind in MOVED}
        self._carriers |= {("rod", r.id): k for k, r in enumerate(model.rods) if r.kind in MOVED and r.body is None}
        self.carries = bool(self._carriers)
        self._aboard = {id: parts_of(model, built, id, driven) for kind, id, _ in self.owners if kind == "turbine"}
        p = built.system.points
        self._loaded = (p.mass != 0.0) | (p.buoyancy != 0.0) | (p.drag != 0.0) | p.given.any(axis=(1, 2))

    def at(self, pose: np.ndarray, rate: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return positions and velocities (m, 3) of the driven rows, for the vector (size,) and its rate."""
        position, velocity = pose[self._place], rate[self._place]
        if self._turning:
            R, spin = self._rotations(pose, rate)
            arm = np.einsum("kij,kj->ki", R[self.owner], self.local)
            position = self.shifts * position + arm
            velocity = self.shifts * velocity + np.cross(spin[self.owner], arm)
        return position, velocity

    def forces(self, host: HostMarch, pulls: np.ndarray, pose: np.ndarray) -> np.ndarray:
        """Return the vector (size,) of forces, and moments about the origin of each object, on the objects, N and N m.

        Parameters
        ----------
        host : HostMarch
        pose : (size,) array
            Where the objects are now.
        pulls : (m, 3) array
            Forces of the lines on the coupled points, as it has just returned them; the weight, buoyancy, drag and
            inertia of the objects themselves are added, and of all that they carry.
        """
        out, now = np.zeros(self.size), np.array([host.time])
        loads = host.reactions() if self.carries else {}
        for (kind, id, width), first in zip(self.owners, self.starts[:-1], strict=True):
            if kind == "point":
                row, holder = self._points[id]
                out[first : first + 3] = self._on_point(host, pulls, row, holder, now)
            elif kind == "turbine":
                for part in self._aboard[id]:
                    load = np.zeros(6)
                    if part.kind == "point":
                        load[:3] = self._on_point(host, pulls, part.row, part.holder, now)
                    else:
                        load[: part.width] = loads[f"{part.kind}_force"][0, part.place, : part.width]
                    load[3:] += np.cross(host.motion_of(part.row)[0, :3] - pose[first : first + 3], load[:3])
                    out[first : first + 6] += load
            else:
                out[first : first + width] = loads[f"{kind}_force"][0, self._carriers[kind, id], :width]
        return out

    def _on_point(self, host: HostMarch, pulls: np.ndarray, row: int, holder: int, now: np.ndarray) -> np.ndarray:
        """Return the force (3,) of lines on a driven point, with its own weight, buoyancy, drag and inertia, N."""
        if not self._loaded[holder]:
            return pulls[row]
        return pulls[row] + point_load(host.march.built, holder, host.motion_of(row), now)[0]

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
    used = {thing.turbine for _, thing in on_turbines(model)}
    turbines = [("turbine", turbine.id, 6) for turbine in model.turbines if turbine.id in used]
    bodies = [(b.id, b.kind, b.turbine) for b in model.bodies if b.kind in MOVED]
    rods = [(r.id, r.kind, r.turbine) for r in model.rods if r.kind in MOVED and r.body is None]
    for what, things in (("body", bodies), ("rod", rods)):
        turbines += [(what, id, width[kind]) for id, kind, turbine in things if turbine is None]
    return turbines + [("point", point.id, 3) for point in model.coupled_points if point.turbine is None]


def described(model: Model) -> np.ndarray:
    """Return the vector (size,) of the coupled objects as the model describes them."""
    parts: list[np.ndarray] = []
    for kind, id, width in coupled_objects(model):
        if kind == "point":
            parts.append(np.array(model.point(id).position))
        elif kind == "turbine":
            turbine = next(turbine for turbine in model.turbines if turbine.id == id)
            parts.append(np.array([*turbine.position, 0.0, 0.0, 0.0]))
        elif kind == "body":
            body = next(body for body in model.bodies if body.id == id)
            parts.append(np.array([*body.position, *body.rotation])[:width])
        else:
            rod = next(rod for rod in model.rods if rod.id == id)
            parts.append(np.array([*rod.end_a, *angles_of(np.array(rod.direction))])[:width])
    return np.concatenate(parts) if parts else np.zeros(0)


def driven_rows(model: Model, built: Built) -> dict[int, Driven]:
    """Return what drives each track that moves."""
    holders = holders_of(model, None, None)
    moved = {body.id for body in model.bodies if body.kind == "coupled"}
    rows: dict[int, Driven] = {}
    for point in model.points:
        track = holders.number[Attachment("point", point.id)]
        if point.body in moved:
            rows[track] = Driven("body", point.body, np.array(point.position), 1.0)  # type: ignore[arg-type]
        elif point.kind == "coupled" and point.body is None:
            rows[track] = Driven("point", point.id, np.zeros(3), 1.0)
    axes = _drive_rods(model, holders, moved, rows)
    for k, line in enumerate(model.lines):
        for end, attachment in enumerate((line.end_a, line.end_b)):
            track = built.system.bending.direction[k, end]
            if track >= 0 and attachment.kind == "rod" and attachment.id in axes:
                kind, id, axis = axes[attachment.id]
                rows[int(track)] = Driven(kind, id, -axis if attachment.end == "A" else axis, 0.0)
    for o, (kind, id) in enumerate(holders.objects.names):
        thing = holders.objects.things[o]
        if thing.kind == "coupled-pinned":
            rows[int(holders.pin[o])] = Driven(kind, id, np.zeros(3), 1.0)
        elif isinstance(thing, Rod) and thing.body in moved:
            rows[int(holders.pin[o])] = Driven("body", thing.body, np.array(thing.end_a), 1.0)  # type: ignore[arg-type]
    for k, body in enumerate(model.bodies):
        if body.id in moved:
            rows[int(built.bodies.place[k])] = Driven("body", body.id, np.zeros(3), 1.0)
            for axis in range(2):
                rows[int(built.bodies.axes[k]) + axis] = Driven("body", body.id, np.eye(3)[axis], 0.0)
    return with_turbines(rows, model)


def _drive_rods(model: Model, holders: Holders, moved: set[int], rows: dict[int, Driven]) -> dict:
    """Add the ends of rods that are held by what a host moves; returns kind and id of that, and the axis there."""
    axes = {}
    for rod in model.rods:
        if ("rod", rod.id) in holders.objects.number:
            continue
        if rod.body in moved:
            kind, id, start, axis = "body", rod.body, np.array(rod.end_a), np.array(rod.direction)
        elif rod.kind in MOVED and rod.body is None:
            kind, id, start, axis = "rod", rod.id, np.zeros(3), np.array([0.0, 0.0, 1.0])
        else:
            continue
        axes[rod.id] = kind, id, axis
        length = rod_length(rod) if rod.segments else 0.0
        for end, arm in (("A", 0.0), ("B", length)):
            rows[holders.number[Attachment("rod", rod.id, end)]] = Driven(kind, id, start + arm * axis, 1.0)  # type: ignore[arg-type]
    return axes


def angular_velocity(angles: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """Return the angular velocity (n, 3) in global axes of intrinsic XYZ angles (n, 3) that change at `rates`."""
    roll, pitch = angles[:, 0], angles[:, 1]
    zero, one = np.zeros_like(roll), np.ones_like(roll)
    x = np.stack([one, zero, zero], axis=1)
    y = np.stack([zero, np.cos(roll), np.sin(roll)], axis=1)
    z = np.stack([np.sin(pitch), -np.sin(roll) * np.cos(pitch), np.cos(roll) * np.cos(pitch)], axis=1)
    return rates[:, :1] * x + rates[:, 1:2] * y + rates[:, 2:] * z
