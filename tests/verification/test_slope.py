"""A line on an inclined bed: it slides, or sticks, as a block on a plane.

Verifies: bathymetry, contact, friction, weight

A straight line without ends tied lies on a plane of 10 degrees, in water, along the slope or across it. Without
friction it slides down with a = g' sin(10 deg), g' = g (m - rho A) / (m + added mass); with friction mu of its
direction of sliding (axial or transverse)

    a = g' (sin(10 deg) - mu cos(10 deg))

while mu < tan(10 deg) = 0.176. It is put at its depth, w cos / (k d) along the normal, so that nothing bounces, and
starts at rest; once it slips, its speed must grow at the rate of a within 2e-4, by every law.

Above that it sticks. Let the friction's spring give D = w sin / (k_s d) under the line's weight, and r = mu / tan.
Without damping ("elastic-slip" with `shear_damping` 0) the line falls into the spring with the energy x - x^2 / 2 (in D w sin), slips from
x = r on, and stops at r + (r - r^2 / 2) / (r - 1); then it swings by r - 1 about the place r - 1 above, for ever but
for the loss of the scheme, which needs a step of 5 ms to tell this so closely. "stick-slip" damps the spring and comes to
rest before 2 D. The law of MoorDyn, a damper, creeps for ever. (MoorDyn-C's contact is vertical and lets a
frictionless line stay put.)
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail
from moorings import DENSITY, GRAVITY, at_rest, free, kind, run, single

from moorage.model import Bathymetry, Friction

SLOPE = np.deg2rad(10.0)
DEPTH, LENGTH, STIFFNESS = 100.0, 20.0, 1e5
ROPE = kind(diameter=0.1, mass_per_length=40.0, tangential_added_mass=0.3, transverse_added_mass=0.3)
DISPLACED = DENSITY * np.pi / 4.0 * 0.1**2
PULL = GRAVITY * (40.0 - DISPLACED) / (40.0 + 0.3 * DISPLACED)


def bed() -> Bathymetry:
    """A plane that falls with x: depth 100 m at x = 0."""
    x = (-500.0, 500.0)
    depths = tuple(tuple(DEPTH + np.tan(SLOPE) * xi for _ in (0, 1)) for xi in x)
    return Bathymetry(x, (-500.0, 500.0), depths)


def sliding(direction: str, friction: Friction | None, duration: float = 10.0, step: float = 0.02):
    """Times and speed of a line along its way down, m/s, and how far it came, m."""
    down = np.array([np.cos(SLOPE), 0.0, -np.sin(SLOPE)])
    normal = np.array([np.sin(SLOPE), 0.0, np.cos(SLOPE)])
    along = down if direction == "along" else np.array([0.0, 1.0, 0.0])
    sink = GRAVITY * (40.0 - DISPLACED) * np.cos(SLOPE) / (STIFFNESS * 0.1)
    begin = np.array([0.0, 0.0, -DEPTH]) - sink * normal
    ends = free(1, *begin), free(2, *(begin + LENGTH * along))
    model = single(
        ROPE, LENGTH, 4, *ends, water_depth=DEPTH, seabed_stiffness=STIFFNESS, seabed_damping=1e4, bathymetry=bed(),
        friction=friction,
    )  # fmt: skip
    built = at_rest(model)
    built.state.position[:5] = built.state.stuck[:5] = np.linspace(begin, begin + LENGTH * along, 5)
    start = built.state.position[2].copy()
    block = run(built, duration, dt_out=0.5, time_step=step, dt_nodes=0.5, tolerance=1e-8)
    return block["time"], block["node_velocity"][:, 2] @ down, (block["node_position"][-1, 2] - start) @ down


def check_slides(direction: str, friction: Friction | None, mu: float) -> None:
    time, speed, _ = sliding(direction, friction)
    late = time >= 2.0
    found = np.polyfit(time[late], speed[late], 1)[0]
    assert found == pytest.approx(PULL * (np.sin(SLOPE) - mu * np.cos(SLOPE)), rel=2e-4)


def check_sticks(direction: str, friction: Friction) -> None:
    _, speed, way = sliding(direction, friction, 20.0, 0.005)
    way *= STIFFNESS * 0.1 / (GRAVITY * (40.0 - DISPLACED) * np.sin(SLOPE))
    if friction.model == "elastic-slip":
        r = friction.axial / np.tan(SLOPE)
        stops = r + (r - 0.5 * r**2) / (r - 1.0)
        assert way == pytest.approx(stops - (r - 1.0), abs=1.05 * (r - 1.0))
    else:
        assert way < 2.0
        assert abs(speed[-1]) < 1e-9


@pytest.mark.parametrize("direction", ["along", "across"])
def test_line_slides_without_friction(direction):
    check_slides(direction, None, 0.0)


@pytest.mark.parametrize(("direction", "mu"), [("along", 0.1), ("across", 0.15)])
@pytest.mark.parametrize("law", ["elastic-slip", "stick-slip", "velocity-dependent", "saturated-damping"])
def test_line_slides_against_friction(direction, mu, law):
    check_slides(direction, Friction(axial=0.1, transverse=0.15, model=law, damping=1e5), mu)


@pytest.mark.parametrize("direction", ["along", "across"])
@pytest.mark.parametrize("law", ["elastic-slip", "stick-slip"])
def test_line_sticks(direction, law):
    check_sticks(direction, Friction(axial=0.2, transverse=0.2, model=law, shear_damping=0.0))


@pytest.mark.parametrize("direction", ["along", "across"])
def test_damped_spring_of_elastic_slip_comes_to_rest(direction):
    """With its default damping: where a mass on a spring and a damper stops that slip together, integrated here."""
    _, speed, way = sliding(direction, Friction(axial=0.2, transverse=0.2), 20.0, 0.005)
    assert way == pytest.approx(way_of_slider(0.1), rel=3e-3)  # measured: 4e-4, of second order in the step
    assert way != pytest.approx(way_of_slider(0.09), rel=3e-3)
    assert abs(speed[-1]) < 1e-9


def way_of_slider(zeta: float, dt: float = 2e-5) -> float:
    """Return how far a metre of the line comes on friction of 0.2 whose spring has a damping ratio, m."""
    k, mass, pull = STIFFNESS * 0.1, 40.0 + 0.3 * DISPLACED, GRAVITY * (40.0 - DISPLACED) * np.sin(SLOPE)
    c, limit = 2.0 * zeta * np.sqrt(k * 40.0), 0.2 * pull / np.tan(SLOPE)
    x = v = d = 0.0
    for _ in range(round(3.0 / dt)):
        if k * d + c * v > limit:
            d = (limit - c * v) / k
        v += dt * (pull - k * d - c * v) / mass
        x, d = x + dt * v, d + dt * v
    return x


def test_wrong_variants_fail():
    """The coefficients exchanged, and MoorDyn's law where a line must stick."""
    must_fail(check_slides, "along", Friction(axial=0.15, transverse=0.1), 0.1)
    must_fail(check_sticks, "along", Friction(axial=0.2, transverse=0.2, model="saturated-damping"))
