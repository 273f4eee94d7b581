"""The functions of Body.h."""

from __future__ import annotations

import numpy as np

from moorage.moordyn.codes import BODY_TYPES
from moorage.moordyn.handles import Body, Vector, of, raising, to_tuple
from moorage.solve.masses import body_mass


def GetBodyID(instance: Body) -> int:
    """Return the id of a body."""
    return _body(instance).id


def GetBodyType(instance: Body) -> int:
    """Return BODY_TYPE_COUPLED, BODY_TYPE_FREE, BODY_TYPE_FIXED or BODY_TYPE_CPLDPIN."""
    return BODY_TYPES[_body(instance).kind]


@raising
def GetBodyState(instance: Body) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return position with Euler angles (m, rad; intrinsic XYZ), and velocity with that of rotation, global (rad/s)."""
    pose, velocity = _motion(instance)
    return to_tuple(pose), to_tuple(velocity)


@raising
def GetBodyPos(instance: Body) -> Vector:
    """Return the position, m."""
    return to_tuple(_motion(instance)[0][:3])


@raising
def GetBodyAngle(instance: Body) -> Vector:
    """Return the Euler angles, rad, intrinsic XYZ."""
    return to_tuple(_motion(instance)[0][3:])


@raising
def GetBodyVel(instance: Body) -> Vector:
    """Return the velocity, m/s."""
    return to_tuple(_motion(instance)[1][:3])


@raising
def GetBodyAngVel(instance: Body) -> Vector:
    """Return the angular velocity in global axes, rad/s."""
    return to_tuple(_motion(instance)[1][3:])


@raising
def GetBodyForce(instance: Body) -> tuple[float, ...]:
    """Return force and moment about its origin of a body and of what it carries, N and N m, without inertia."""
    system, k = of(Body, instance), instance.place
    total, origin = system.block["body_force"][k].copy(), system.block["body_position"][k]
    for holder in system.built.bodies.holders[k]:
        force = system.own_load(int(holder))
        total += [*force, *np.cross(system.point_motion(int(holder))[0] - origin, force)]
    return to_tuple(total)


@raising
def GetBodyM(instance: Body) -> tuple[tuple[float, ...], ...]:
    """Return the mass matrix (6, 6) about its origin in global axes, with added mass and the points and rods on it."""
    system = of(Body, instance)
    return to_tuple(body_mass(system.built, system.masses, system.block, instance.place, system.time))  # type: ignore[return-value]


def _body(instance: Body):
    return of(Body, instance).model.bodies[instance.place]


def _motion(instance: Body) -> tuple[np.ndarray, np.ndarray]:
    """Position with angles, and velocity with that of rotation, (6,) each."""
    return of(Body, instance).body_motion(instance.place)
