"""Forces on the nodes of rods, as channels and files give them, against closed forms and each other.

Verifies: weight, morison, contact

* A fixed rod that leans, in a current: every part of the force on every node in closed form, to rounding: dry weight;
  buoyancy as pressure, across the rod rho g V (e_z - (e_z.q) q) and on the faces rho g A z; drag on sides and faces.
* In a wave: Froude-Krylov and added mass, by the water's acceleration from the waves themselves.
* Parts add up to the net force; net forces of the nodes to the force on the rod, and under water their moments to its
  moment, whatever the rod does: hung on ropes by both ends, in the surface, on the bed with friction.
* The acceleration of a node is the rate of its velocity: differences of fourth order over 5 ms leave 1e-5 m/s2, those of
  second order 2e-3. The angular acceleration of a pendulum is m g L / 2 sin(angle) / J, to 1e-7.

The wrong variant leaves the engine's buoyancy upright at the nodes, which is the same in sum.
"""

from __future__ import annotations

import dataclasses
import warnings

import numpy as np
import pytest
from common import must_fail
from floats import AIR, WATER, floating, rod

import moorage
from moorage.model import (
    Attachment,
    Current,
    Friction,
    Line,
    LineType,
    OutputChannel,
    Point,
    RodType,
    Section,
    Waves,
)
from moorage.results.channels import watch_list
from moorage.results.rod_columns import ROD_COLUMNS, RodMoment
from moorage.results.rod_nodes import RodNodes, rod_nodes
from moorage.solve.control import Settings
from moorage.solve.march import March
from moorage.solve.statics import rest, solve
from moorage.system.build import build

RHO, G = 1025.0, 9.80665
KIND = RodType(
    name="spar", diameter=0.4, mass_per_length=50.0, transverse_drag=0.9, transverse_added_mass=1.0, end_drag=0.6,
    end_added_mass=0.7,
)  # fmt: skip
A, B, N = np.array([1.0, 2.0, -22.0]), np.array([4.0, 3.0, -17.0]), 4
L, AREA = np.linalg.norm(B - A), np.pi * 0.4**2 / 4.0
Q = (B - A) / L
HALF = np.array([0.5, 1.0, 1.0, 1.0, 0.5]) * L / N  # length that belongs to each node
FLOW = np.array([0.7, -0.4, 0.0])


def block_of(model, duration: float = 0.0, start=rest):
    """Return what a run gives at its end, and the nodes of its first rod."""
    built = build(model)
    start(built)
    march = March(built, Settings(dt_out=duration or 1.0, watch=watch_list(model)), duration)
    blocks = [march.first()] + ([march.advance(duration)] if duration else [])
    nodes = rod_nodes(model, built)[0]
    return RodMoment(march.built, {name: values[-1:] for name, values in blocks[-1].items()}, nodes, {})


def part(moment: RodMoment, letter: str, program: str = "C") -> np.ndarray:
    return ROD_COLUMNS[program][letter].values(moment)[0]


def leaning(**environment):
    env = WATER | environment
    return floating(rods=[rod(1, "fixed", A, B, N)], types=KIND, environment=env)


def check_in_current(moment: RodMoment) -> None:
    up, z = np.array([0.0, 0.0, 1.0]), np.linspace(A[2], B[2], N + 1)
    weight = -50.0 * G * HALF[:, None] * up
    pressure = RHO * G * AREA * HALF[:, None] * (up - Q[2] * Q)
    pressure[0] += -RHO * G * AREA * z[0] * Q
    pressure[-1] -= -RHO * G * AREA * z[-1] * Q
    along = (FLOW @ Q) * Q
    across = FLOW - along
    sides = 0.5 * RHO * 0.9 * 0.4 * HALF[:, None] * np.linalg.norm(across) * across
    faces = np.zeros((N + 1, 3))
    faces[[0, -1]] = 0.5 * RHO * 0.6 * AREA * np.linalg.norm(along) * along
    for letter, exact in (("W", weight), ("B", pressure), ("X", sides), ("Y", faces)):
        np.testing.assert_allclose(part(moment, letter), exact, rtol=1e-9, atol=1e-6, err_msg=letter)
    np.testing.assert_allclose(part(moment, "D", "F"), sides + faces, rtol=1e-9)
    np.testing.assert_allclose(part(moment, "U", "F"), np.tile(FLOW, (N + 1, 1)), rtol=1e-9)
    np.testing.assert_allclose(part(moment, "W", "F"), weight[:, 2:], rtol=1e-9)
    np.testing.assert_allclose(part(moment, "f"), weight + pressure + sides + faces, rtol=1e-9, atol=1e-6)
    np.testing.assert_allclose(part(moment, "p"), np.linspace(A, B, N + 1), rtol=1e-12)
    np.testing.assert_array_equal(part(moment, "v"), 0.0)
    np.testing.assert_array_equal(part(moment, "b"), 0.0)


class Upright(RodNodes):
    """The wrong variant."""

    def buoyancy(self, block):
        return self._lift(block)[..., None] * np.array([0.0, 0.0, 1.0])


def in_current() -> RodMoment:
    return block_of(leaning(current=Current((0.0,), (tuple(FLOW),))))


def test_every_part_in_a_current():
    check_in_current(in_current())


def test_buoyancy_that_is_no_pressure_fails():
    moment = in_current()
    must_fail(check_in_current, moment._replace(nodes=Upright(*moment.nodes)))


def test_the_water_accelerates():
    """In a regular wave at 3.1 s, by what the waves say of the water at the nodes."""
    waves = Waves.regular(2.0, 8.0, depth=300.0, direction=0.4)
    waves = dataclasses.replace(waves, exact=True)
    moment = block_of(leaning(waves=waves), 3.1)
    a = waves.kinematics(3.1, np.linspace(A, B, N + 1)).acceleration
    along = (a @ Q)[:, None] * Q
    displaced = RHO * AREA * HALF[:, None]
    np.testing.assert_allclose(part(moment, "A"), 2.0 * displaced * (a - along), rtol=1e-8)
    np.testing.assert_allclose(part(moment, "P"), displaced * along, rtol=1e-8, atol=1e-9)
    ends = np.zeros((N + 1, 1))
    ends[[0, -1]] = 0.7 * RHO * np.pi * 0.4**3 / 12.0
    np.testing.assert_allclose(part(moment, "a"), ends * along, rtol=1e-8, atol=1e-9)
    np.testing.assert_allclose(part(moment, "I", "F"), part(moment, "A") + part(moment, "a"), rtol=1e-9)
    check_sum(moment)


def check_sum(moment: RodMoment, turns: bool = True) -> None:
    """Parts make up the net force of the nodes, and these the force on the rod, and its moment about end A."""
    net = part(moment, "f")
    ends = moment.block["holder_load"][0, list(moment.nodes.ends)]
    parts = sum(part(moment, letter) for letter in "WBXYAaPb")
    parts[[0, -1]] += ends
    size = np.abs(net).max()
    np.testing.assert_allclose(parts, net, atol=2e-6 * size)
    np.testing.assert_allclose(net.sum(axis=0), moment.block["rod_force"][0, 0, :3], atol=1e-8 * size)
    if turns:
        arms = part(moment, "p") - part(moment, "p")[0]
        turn = np.cross(arms, net).sum(axis=0)
        np.testing.assert_allclose(turn, moment.block["rod_force"][0, 0, 3:], atol=1e-8 * L * size)


def hung(**environment):
    """A rod on two ropes, of unlike lengths."""
    thin = LineType(name="rope", diameter=0.05, mass_per_length=3.0, axial_stiffness=1e6)
    points = [Point(id=1, kind="fixed", position=(0, 0, -2)), Point(id=2, kind="fixed", position=(7, 1, -2))]
    ropes = [
        Line(
            id=k, end_a=Attachment("point", k), end_b=Attachment("rod", 1, end),
            sections=(Section(line_type="rope", length=length, segments=4),),
        )
        for k, end, length in ((1, "A", 21.0), (2, "B", 16.0))
    ]  # fmt: skip
    heavy = dataclasses.replace(KIND, mass_per_length=300.0)
    beam = rod(1, "free", A, B, N)
    return floating(
        rods=[beam], types=heavy, line_types=thin, points=points, lines=ropes, environment=WATER | environment
    )


def test_sums_of_a_rod_on_ropes():
    check_sum(block_of(hung(), 0.7))
    check_sum(block_of(hung(), start=solve))


@pytest.mark.parametrize("top", [0.7, 0.05, -0.4])
def test_sums_of_a_rod_in_the_surface(top):
    """The moment of the waterplane is not of the nodes."""
    it = floating(rods=[rod(1, "fixed", (0, 0, -6.0), (2, 1, top), 6)], types=KIND, environment=WATER)
    check_sum(block_of(it), turns=False)
    upside = floating(rods=[rod(1, "fixed", (2, 1, top), (0, 0, -6.0), 6)], types=KIND, environment=WATER)
    np.testing.assert_allclose(part(block_of(upside), "f")[::-1], part(block_of(it), "f"), atol=1e-6)


def test_a_rod_on_the_bed_with_friction():
    """b holds the normal force and the friction of what slides down; all else is zero there."""
    friction = Friction(axial=0.3, transverse=0.3)
    heavy = dataclasses.replace(KIND, mass_per_length=400.0)
    it = floating(
        rods=[rod(1, "free", (0, 0, -99.99), (4, 0, -99.99), N)], types=heavy,
        environment=WATER | {"water_depth": 100.0, "friction": friction, "current": Current((0.0,), ((0.0, 3.0, 0.0),))},
    )  # fmt: skip
    moment = block_of(it, 0.5)
    bed = part(moment, "b")
    assert (bed[:, 2] > 0.0).all()
    assert (bed[:, 1] < -10.0).all()  # against the current
    assert (np.hypot(bed[:, 0], bed[:, 1]) < 0.3001 * bed[:, 2]).all()
    check_sum(moment)


def test_acceleration_of_nodes():
    names = [f"ROD1N{i}{kind}{x}" for i in (0, 2, 4) for kind in "VA" for x in "XZ"] + ["ROD1RY", "R1N2RAY"]
    it = floating(rods=[rod(1, "pinned", (0, 0, -50), (1.5, 0, -51), 4)], environment=AIR)
    it = dataclasses.replace(it, outputs=tuple(OutputChannel(name=name) for name in names))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        ds = moorage.simulate(it, duration=1.0, dt_out=0.005, time_step=0.001, start="as-given")
    for i in (0, 2, 4):
        for x in "XZ":
            v = ds[f"ROD1N{i}V{x}"].values
            rate = (8.0 * (v[3:-1] - v[1:-3]) - (v[4:] - v[:-4])) / (12.0 * 0.005)
            np.testing.assert_allclose(ds[f"ROD1N{i}A{x}"].values[2:-2], rate, atol=5e-5)
    assert np.abs(ds["ROD1N4AX"].values).max() > 3.0
    length = np.hypot(1.5, 1.0)
    exact = 0.5 * G * length * np.sin(np.radians(ds["ROD1RY"].values)) / (length**2 / 3.0 + 0.4**2 / 16.0)
    np.testing.assert_allclose(np.radians(ds["R1N2RAY"].values), exact, atol=1e-6)
