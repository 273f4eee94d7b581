"""The functions of Body.h. Bodies that move by themselves come with the engine's; fixed and coupled ones only carry."""

from __future__ import annotations

import numpy as np

from moorage.moordyn.codes import BODY_TYPES
from moorage.moordyn.coupling import angular_velocity
from moorage.moordyn.handles import Body, Rod, Vector, live, raising, to_tuple
from moorage.moordyn.points import GetPointForce, Point
from moorage.moordyn.rods import GetRodForce, holder_of


def GetBodyID(instance: Body) -> int:
    """Return the id of a body."""
    return _body(instance).id


def GetBodyType(instance: Body) -> int:
    """Return BODY_TYPE_COUPLED, BODY_TYPE_FREE, BODY_TYPE_FIXED or BODY_TYPE_CPLDPIN."""
    return BODY_TYPES[_body(instance).kind]


@raising
def GetBodyState(instance: Body) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return position with Euler angles (m, rad; intrinsic XYZ) and their rates, six numbers each."""
    pose, rate = _motion(instance)
    return to_tuple(pose), to_tuple(rate)


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
    pose, rate = _motion(instance)
    return to_tuple(angular_velocity(pose[None, 3:], rate[None, 3:])[0])


@raising
def GetBodyForce(instance: Body) -> tuple[float, ...]:
    """Return force and moment about its origin of what a body carries, N and N m, without inertia.

    Weight, buoyancy and drag of the body itself come with the engine's bodies.
    """
    system, body = live(instance.system), _body(instance)
    total, origin = np.zeros(6), _motion(instance)[0][:3]
    for k, point in enumerate(system.model.points):
        if point.body == body.id:
            force = np.array(GetPointForce(Point(system, k)))
            total += [*force, *np.cross(system.point_motion(k)[0] - origin, force)]
    for k, rod in enumerate(system.model.rods):
        if rod.body == body.id:
            load = np.array(GetRodForce(Rod(system, k)))
            arm = system.point_motion(holder_of(Rod(system, k), "A"))[0] - origin
            total += [*load[:3], *(load[3:] + np.cross(arm, load[:3]))]
    return to_tuple(total)


def GetBodyM(instance: Body):
    """Refuse: the mass of bodies is not simulated yet."""
    _body(instance)
    raise RuntimeError("GetBodyM: bodies are carried; their mass is not simulated yet")


def _body(instance: Body):
    return live(instance.system).model.bodies[instance.place]


def _motion(instance: Body) -> tuple[np.ndarray, np.ndarray]:
    """Position with angles and their rates, (6,) each."""
    return live(instance.system).body_motion(instance.place)
