"""The cantilever of figures 3 to 6, and what it should do: linear beam, elastica, frequency of small swings.

Of the paper: 10 m (20 m in figure 5), EI 2 MN m2, 100 kg/m, diameter 0.3525 m, a mass at the tip. Chosen here: EA,
drag, added mass, damping, density of the water (which makes the cable neutral to 0.03 %) and gravity.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from moorage.model import Attachment, Environment, Line, LineType, Model, Point, Rod, RodType, Section

EI, EA, MASS, DIAMETER = 2e6, 1e8, 100.0, 0.3525
GRAVITY, DENSITY, DEPTH = 9.80665, 1025.0, 40.0
ADDED_MASS = DENSITY * np.pi / 4.0 * DIAMETER**2  # kg/m, with Ca 1
CABLE = LineType(
    name="cable",
    diameter=DIAMETER,
    mass_per_length=MASS,
    axial_stiffness=EA,
    axial_damping_ratio=0.8,
    bending_stiffness=EI,
    transverse_drag=1.2,
    tangential_drag=0.05,
    transverse_added_mass=1.0,
)


def cantilever(length: float, mass: float, segments: int, gravity: float = GRAVITY, flavour: str = "native") -> Model:
    """Return a cable (m) from a clamp along x to a free tip with a mass (kg), 40 m under water.

    `flavour` "MoorDyn-C" takes the paper's rule for clamps (equation 10), "native" the exact one.
    """
    rod = Rod(id=1, rod_type="clamp", kind="fixed", end_a=(-1.0, 0.0, -DEPTH), end_b=(0.0, 0.0, -DEPTH), segments=1)
    cable = Line(
        id=1,
        sections=(Section(line_type="cable", length=length, segments=segments),),
        end_a=Attachment("rod", 1, "B"),
        end_b=Attachment("point", 1),
    )
    return Model(
        environment=Environment(water_depth=100.0, gravity=gravity, water_density=DENSITY),
        line_types=(CABLE,),
        rod_types=(RodType(name="clamp", diameter=DIAMETER, mass_per_length=0.0),),
        rods=(rod,),
        points=(Point(id=1, kind="free", position=(length, 0.0, -DEPTH), mass=mass),),
        lines=(cable,),
        flavour=flavour,
    )


def linear_beam(length: float, mass: float, x: ArrayLike) -> np.ndarray:
    """Return the deflection (m, down) of the linear beam: P x^2 (3 L - x) / 6 EI."""
    x = np.asarray(x)
    return mass * GRAVITY * x**2 * (3.0 * length - x) / (6.0 * EI)


def elastica(length: float, mass: float, at: ArrayLike) -> np.ndarray:
    """Return exact places (n, 2), x and z (m) from the clamp, at arc lengths (m) of the beam that bends and stretches.

    With its weight in water w and a load P at the tip, theta down from the horizontal,

        EI theta'' = -(P + w (L - s)) (1 + e) cos theta,   e = (P + w (L - s)) sin theta / EA

    solved by shooting from the tip, where theta' = 0.
    """
    w, P = GRAVITY * (MASS - ADDED_MASS), mass * GRAVITY

    def slopes(s, u):  # s, x and z from the tip; theta, theta', x, z
        load = P + w * s
        stretch = 1.0 + load * np.sin(u[0]) / EA
        return u[1], -load * stretch * np.cos(u[0]) / EI, stretch * np.cos(u[0]), -stretch * np.sin(u[0])

    def shoot(angle):
        start = (angle, 0.0, 0.0, 0.0)
        return solve_ivp(slopes, (0.0, length), start, rtol=1e-11, atol=1e-12, method="DOP853", dense_output=True).sol

    shot = shoot(brentq(lambda angle: shoot(angle)(length)[0], 0.0, 0.5 * np.pi, xtol=1e-14))
    return (shot(length)[2:, None] - shot(length - np.asarray(at, float))[2:]).T


def small_period(length: float, mass: float) -> float:
    """Return the period (s) of small swings of the Euler-Bernoulli beam in water with a mass at its tip.

    1 + cos b cosh b + r b (cos b sinh b - sin b cosh b) = 0 with r the mass over that of the beam, added mass included,
    and omega = b^2 sqrt(EI / m L^4).
    """
    m = MASS + ADDED_MASS
    r = mass / (m * length)

    def condition(b):
        return 1.0 + np.cos(b) * np.cosh(b) + r * b * (np.cos(b) * np.sinh(b) - np.sin(b) * np.cosh(b))

    b = brentq(condition, 0.1, 1.8751)
    return float(2.0 * np.pi / (b**2 * np.sqrt(EI / (m * length**4))))
