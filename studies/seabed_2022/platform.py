"""How the wind moves the platform: one degree of freedom, sway, on the mooring's own force."""

from __future__ import annotations

import dataclasses

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

from moorage.model import Model, Motion
from studies.peers import at_rest

WIND, AIR, ROTOR, THRUST_COEFFICIENT = 9.0, 1.225, 240.0, 0.8  # m/s, kg/m3, m, -: the paper gives the speed
THRUST = 0.5 * AIR * np.pi / 4.0 * ROTOR**2 * WIND**2 * THRUST_COEFFICIENT  # N, 1.80 MN
MASS, LINEAR, QUADRATIC = (
    3.0e7,
    2.0 * THRUST / WIND,
    9.0e5,
)  # kg with added mass; N s/m of the rotor; N s2/m2 of the hull


def pushed(model: Model, sway: float) -> Model:
    """Return the mooring with its fairleads moved along y, m."""
    points = tuple(
        dataclasses.replace(p, position=(p.position[0], p.position[1] + sway, p.position[2]))
        if p.kind == "coupled"
        else p
        for p in model.points
    )
    return dataclasses.replace(model, points=points)


def restoring(model: Model, sways: np.ndarray) -> np.ndarray:
    """Return the force of the mooring along y (n,), N, where the platform is moved by sways (m)."""
    return np.array([at_rest(pushed(model, float(y)))["fairlead_force"].values[:, 1].sum() for y in sways])


def in_wind(model: Model, duration: float, thrust: float = THRUST) -> Motion:
    """Return the sway of a platform at rest on which a steady wind begins to blow, over 60 s.

    M y'' = F(t) - c y' - q |y'| y' + R(y), R the static force of the mooring. Surge, roll and yaw are left out.
    """
    sways = np.linspace(-100.0, 300.0, 41)
    mooring = CubicSpline(sways, restoring(model, sways))

    def rates(t, u):
        push = thrust * (0.5 - 0.5 * np.cos(np.pi * min(t / 60.0, 1.0)))
        return u[1], (push - LINEAR * u[1] - QUADRATIC * abs(u[1]) * u[1] + mooring(u[0])) / MASS

    time = np.arange(0.0, duration + 0.5, 0.5)
    path = solve_ivp(rates, (0.0, time[-1]), (0.0, 0.0), t_eval=time, rtol=1e-8, atol=1e-6).y[0]
    moved = np.zeros((len(time), 6))
    moved[:, 1] = path
    return Motion.from_platform(time, moved)
