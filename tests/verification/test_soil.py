"""A soil with suction and a memory: its curves, the energy of closed ways, and lines that are pulled off it.

Verifies: soil, contact

Curves (docs/theory.md, after Randolph & Quiggin 2009). Of a node, moved by hand:

* the bearing factor is a (z / D)^b from z / D = 0.1 on and N_c(0.1) sqrt(10 z / D) below that (OrcaFlex's manual), to
  rounding, with no jump between; a power up to the mudline must fail;
* first penetration is P_u K z / (1 + K z), K = k_max / D, to rounding;
* every turn of the motion meets the stiffness K P_u: over a way d the difference is off in first order (rate 1), and below
  1 % at d = 1e-6 D;
* the way up is its formula, to 1e-9; of a stiff soil that does not let go (k_max = 1e6, l_suc = 1e3) uplift goes to -f P_u within 1e-3 of it;
* the way down after an uplift is its formula, to 1e-9, from the water (z0 = P0 = 0: a second contact is no first one) and
  from a turn in the soil; bounded by the first curve it meets that without a jump;
* what is lifted off and pressed again meets less resistance until it is l_rep z_max deeper than before, and from there on
  that of first penetration, to 1e-9.

Energy. Whatever the way, the soil has taken more than it gave when the line is off it again; a steady cycle takes the
area between its two hyperbolas.

Pull. A line of one segment on its two ends (both moved), pressed in and lifted slowly: the ends carry its weight and the
soil's -P, by the curve, to 2e-3 of the weight (turns are noticed at ends of steps of 50 ms); over the bed the weight
only, to 1e-4.

A chain lifted off. At rest a chain lies where P is its weight, to 1e-6. The fairlead of a hanging one is lifted slowly. What
this costs more where the soil sucks is what the soil takes more, by the curves, of each metre on the way from rest to the
water, times the metres that leave the bed: within 2 % (length on the bed is counted in halves of segments of 0.125 m, 0.7 %
of 18 m, at both ends; the tolerance of 0.05 mm leaves 1 %). Let down again, it costs the same, to 2 % of that. Segments must be
shorter than the way along which a chain peels off, sqrt(2 H u / (f w)), 0.1 to 0.5 m here with u the way in which suction
dies out: nodes further apart jump off, and on 1 m the chain takes ten times as much.

A soil with another suction must be noticed.
"""

from __future__ import annotations

import dataclasses
from itertools import pairwise

import numpy as np
import pytest
from common import must_fail, rate
from moorings import at_rest, coupled, fixed, kind, nodes, run, single, statics, weight_in_water
from scipy.optimize import brentq

from moorage.model import Environment, Motion, Soil
from moorage.physics.soil import FRESH, remember, resistance
from moorage.system.bed import build_soil

SOIL = Soil(shear_strength=5e3, strength_gradient=1.5e3)
D = 0.1
NODE = np.uintp(0)


def soil_of(soil: Soil):
    """The soil's parameters of one node that stands for 1 m of a line."""
    return build_soil(Environment(water_depth=100.0, soil=soil), np.array([D]), np.array([1.0]))


def bearing(soil: Soil, z):
    z = np.asarray(z, float)
    return bearing_factor(soil, z / D) * (soil.shear_strength + soil.strength_gradient * z) * D


def bearing_factor(soil: Soil, ratio):
    """N_c of OrcaFlex's manual."""
    power = soil.bearing_factor * np.maximum(ratio, 0.1) ** soil.bearing_exponent
    return power * np.sqrt(np.minimum(10.0 * ratio, 1.0))


def first(soil: Soil, z):
    Kz = soil.maximum_stiffness / D * np.asarray(z, float)
    return bearing(soil, z) * Kz / (1.0 + Kz)


def led(soil: Soil, way) -> np.ndarray:
    """Resistance (N/m) along a way of penetrations (m), remembered after every one of them."""
    p, memory, out = soil_of(soil), FRESH, []
    for z in way:
        out.append(resistance(p, NODE, memory, float(z))[0])
        memory = remember(p, NODE, memory, float(z))
    return np.array(out)


def path(*turns: float, points: int = 400) -> np.ndarray:
    """Penetrations from turn to turn (m)."""
    return np.concatenate([np.linspace(a, b, points) for a, b in pairwise(turns)])


def borne(soil: Soil, ratio) -> np.ndarray:
    """N_c at parts of the diameter, from the resistance that a node meets there for the first time."""
    z = D * np.asarray(ratio)
    Kz = soil.maximum_stiffness / D * z
    met = np.array([resistance(soil_of(soil), NODE, FRESH, float(depth))[0] for depth in z])
    return met * (1.0 + Kz) / Kz / (soil.shear_strength + soil.strength_gradient * z) / D


def check_bearing(exponent_of_shallow: float) -> None:
    """Values by hand: 6 x 0.1^0.25 = 3.374048; a quarter of the depth halves it."""
    assert borne(SOIL, [0.1, 0.4, 1.6]) == pytest.approx([3.374048, 4.771624, 6.748097], rel=1e-6)
    shallow = 3.374048 * np.array([0.25, 0.5]) ** exponent_of_shallow
    assert borne(SOIL, [0.025, 0.05]) == pytest.approx(shallow, rel=1e-6)
    assert borne(SOIL, [0.1 - 1e-9]) == pytest.approx(borne(SOIL, [0.1 + 1e-9]), rel=1e-7)


def test_bearing_factor():
    check_bearing(0.5)


def test_a_power_up_to_the_mudline_fails():
    must_fail(check_bearing, SOIL.bearing_exponent)


def test_first_penetration():
    z = np.linspace(1e-6, 0.2, 500)
    assert led(SOIL, z) == pytest.approx(first(SOIL, z), rel=1e-12)


@pytest.mark.parametrize("turns", [(0.0, 0.05), (0.0, 0.05, 0.01), (0.0, 0.05, 0.04, 0.045)])
def test_every_turn_meets_the_greatest_stiffness(turns):
    """Going up, down after uplift, and up after re-penetration."""
    soil, errors, sizes = SOIL, [], [4e-6 * D, 2e-6 * D, 1e-6 * D]
    z = turns[-1]
    for d in sizes:
        back = z - d if z > turns[-2] else z + d
        P = led(soil, np.append(path(*turns), back))
        stiffness = (P[-1] - P[-2]) / (back - z)
        errors.append(abs(stiffness / (soil.maximum_stiffness / D * float(bearing(soil, z))) - 1.0))
    assert errors[-1] < 1e-2
    assert rate(sizes, errors) == pytest.approx(1.0, abs=0.1)


def test_uplift_goes_to_the_suction():
    soil = Soil(shear_strength=5e3, maximum_stiffness=1e6, suction_decay=1e3)
    z = path(0.0, 0.1, 0.05)
    assert led(soil, z)[-1] == pytest.approx(-0.7 * float(bearing(soil, 0.05)), rel=1e-3)


def uplift(soil: Soil, z0: float, P0: float, z):
    """Resistance (N/m) on the way up from z0, P0, the deepest place there was."""
    suction = -soil.suction_ratio * bearing(soil, z) * np.exp(-(z0 - z) / (soil.suction_decay * z0))
    range_ = P0 - suction
    return suction + range_**2 / (range_ + bearing(soil, z0) * soil.maximum_stiffness / D * (z0 - z))


def test_suction_comes_and_goes():
    """The whole way out of the soil, without the last tenth of a millimetre, where first penetration is the bound."""
    deep = 0.05
    z = path(0.0, deep, 1e-4)[400:]
    P = led(SOIL, path(0.0, deep, 1e-4))[400:]
    assert pytest.approx(uplift(SOIL, deep, float(first(SOIL, deep)), z), rel=1e-9, abs=1e-9) == P
    assert P.argmin() in range(50, 350)
    assert led(SOIL, path(0.0, deep, 0.0))[-1] == 0.0


def pressed_again(soil: Soil, z0: float, P0: float, deepest: float, z):
    """Resistance (N/m) on the way down from z0, P0, without the bound of the first curve."""
    below = z - deepest - soil.repenetration_offset * (deepest - z0)
    aim = bearing(soil, z) * np.exp(np.minimum(0.0, below / deepest))
    way = bearing(soil, z) * soil.maximum_stiffness / D * (z - z0)
    return aim + (P0 - aim) * np.abs(P0 - aim) / (np.abs(P0 - aim) + way)


@pytest.mark.parametrize(("turn", "z0"), [(-0.01, 0.0), (0.03, 0.03), (0.049, 0.049)])
def test_way_down_after_an_uplift(turn, z0):
    """From the water, where nothing is left of the uplift, and from turns in the soil."""
    deep = 0.05
    way = path(0.0, deep, turn, 2.0 * deep)
    P, z = led(SOIL, way), way[800:]
    P0 = float(P[799]) if z0 else 0.0
    inside = z > z0 + 1e-9
    expected = np.minimum(pressed_again(SOIL, z0, P0, deep, z[inside]), first(SOIL, z[inside]))
    assert P[800:][inside] == pytest.approx(expected, rel=1e-9)


def test_soil_is_softer_where_it_was_pressed_before():
    deep = 0.05
    z = path(0.0, deep, -0.01, 2.0 * deep, points=2000)
    P, again = led(SOIL, z)[-2000:], z[-2000:]
    inside = (again > 1e-3 * deep) & (again < deep)
    assert np.all(P[inside] < first(SOIL, again[inside]))
    at = float(np.interp(deep, again, P)) / float(first(SOIL, deep))
    assert 0.7 < at < 0.8  # exp(-l_rep) of what it was
    beyond = again > (1.0 + SOIL.repenetration_offset) * deep
    assert P[beyond] == pytest.approx(first(SOIL, again[beyond]), rel=1e-9)


def work(soil: Soil, z: np.ndarray) -> float:
    """Work that a way costs, J/m."""
    return float(np.trapezoid(led(soil, z), z))


@pytest.mark.parametrize("seed", range(20))
def test_no_energy_is_gained_on_any_way_back_to_the_water(seed):
    """In tenths of the time the way stays within the first hyperbola's range, D / k_max."""
    random = np.random.default_rng(seed)
    turns = random.uniform(-0.02, 0.15, random.integers(2, 10)) * (0.02 if seed % 3 == 0 else 1.0)
    assert work(SOIL, path(0.0, *turns, -0.01)) > -1e-9


def test_steady_cycle_takes_energy():
    cycles = [0.05, 0.04] * 30
    z = path(0.0, *cycles, 0.05, points=200)
    P = led(SOIL, z)[-400:]
    assert P[0] == pytest.approx(P[-1], rel=1e-3)  # it has become steady
    taken = np.trapezoid(P, z[-400:])
    assert 0.1 < taken / (0.01 * np.ptp(P)) < 1.0


ROPE = kind(diameter=D, mass_per_length=100.0, axial_stiffness=1e8, axial_damping_ratio=1.0)
W, DEPTH, LONG = weight_in_water(ROPE), 100.0, 10.0


def lifted(soil: Soil) -> tuple[np.ndarray, np.ndarray]:
    """Penetration (m) and pull of both ends (N/m) of a line that is pressed in, lifted out, and pressed in again."""
    time = np.arange(0.0, 301.0, 0.5)
    s = np.clip(time / 100.0, 0.0, 3.0)
    z = 0.04 * (1.0 - np.cos(np.pi * s)) - 0.005
    ends = {k: np.column_stack([0.0 * z + x, 0.0 * z, -DEPTH - z]) for k, x in ((1, 0.0), (2, LONG))}
    hold = [coupled(k, *ends[k][0]) for k in (1, 2)]
    built = at_rest(single(ROPE, LONG, 1, *hold, water_depth=DEPTH, soil=soil), Motion.from_points(time, ends))
    block = run(built, 300.0, dt_out=0.5, time_step=0.05)
    # the force of the line on its ends: its weight less what the soil bears
    return -DEPTH - block["point_position"][:, 0, 2], -block["point_force"][:, :2, 2].sum(axis=1) / LONG


def check_pull(soil: Soil) -> None:
    z, pull = lifted(soil)
    fine = np.interp(np.arange(0.0, 300.01, 0.05), np.arange(0.0, 300.1, 0.5), z)
    expected = W - led(SOIL, fine)[::10]
    assert pull == pytest.approx(expected, abs=2e-3 * W)


def test_line_is_held_back_and_let_go():
    check_pull(SOIL)
    z, pull = lifted(SOIL)
    assert pull.max() > W + 0.4 * float(bearing(SOIL, 0.05))
    assert pull[z < 0.0] == pytest.approx(W, rel=1e-4)


def test_other_suction_fails():
    must_fail(check_pull, Soil(shear_strength=5e3, strength_gradient=1.5e3, suction_ratio=0.6))


def test_chain_at_rest_sinks_in_until_the_soil_bears_it():
    """And soil buoys it, by 1.5 times what it displaces."""
    for density in (None, 1500.0):
        soil = Soil(shear_strength=2.5e3, strength_gradient=1.5e3, density=density)
        ends = fixed(1, 0.0, 0.0, -DEPTH), fixed(2, 20.0, 0.0, -DEPTH)
        built = statics(single(ROPE, 20.5, 40, *ends, water_depth=DEPTH, soil=soil), tolerance=1e-9)
        z = -DEPTH - nodes(built)[15:26, 2]
        half = 0.5 * D
        area = half**2 * np.arccos(1.0 - z / half) - (half - z) * np.sqrt(z * (D - z))
        lift = 0.0 if density is None else 1.5 * (density - 1025.0) * 9.80665 * area
        assert first(soil, z) + lift == pytest.approx(W, rel=1e-6)


CHAIN = kind(
    diameter=D, mass_per_length=100.0, axial_stiffness=1e7, axial_damping_ratio=1.0, transverse_drag=2.0,
    tangential_drag=0.4, transverse_added_mass=1.0,
)  # fmt: skip


def lifted_chain(suction: float, segments: int, tolerance: float | None = None):
    """Work of lifting a chain's fairlead and of letting it down again (J), and the length that left the bed (m)."""
    time = np.arange(0.0, 201.0, 0.5)
    up = 4.0 * (1.0 - np.cos(2.0 * np.pi * np.clip(time / 200.0, 0.0, 1.0)))
    top = np.column_stack([0.0 * up + 62.0, 0.0 * up, up - 90.0])
    ends = fixed(1, 0.0, 0.0, -DEPTH), coupled(2, *top[0])
    chain = single(
        CHAIN, 70.0, segments, *ends, water_depth=DEPTH, soil=dataclasses.replace(CLAY, suction_ratio=suction)
    )
    block = run(statics(chain, Motion.from_points(time, {2: top})), 200.0, dt_out=0.1, tolerance=tolerance)
    height = 4.0 * (1.0 - np.cos(2.0 * np.pi * block["time"] / 200.0))
    force, grounded, way = -block["end_force"][:, 0, 1, 2], block["grounded_length"][:, 0], block["time"] <= 100.0
    works = [float(np.trapezoid(force[part], height[part])) for part in (way, ~way)]
    return *works, grounded[0] - grounded[way][-1]


CLAY = Soil(shear_strength=3e3)


def taken(suction: float) -> float:
    """What a soil takes more than one without suction, of a metre of the chain that rests on it and is lifted, J."""
    rest = brentq(lambda z: float(first(CLAY, z)) - W, 1e-4, 0.1)
    way = path(0.0, rest, 0.0, points=4000)
    return work(dataclasses.replace(CLAY, suction_ratio=suction), way) - work(
        dataclasses.replace(CLAY, suction_ratio=0.0), way
    )


def check_chain(strong: float) -> None:
    up, down, length = lifted_chain(strong, 560, 5e-5)
    loose_up, loose_down, _ = lifted_chain(0.0, 560, 5e-5)
    expected = taken(0.7) * length
    assert up - loose_up == pytest.approx(expected, rel=0.02)
    assert down - loose_down == pytest.approx(0.0, abs=0.02 * expected)


def test_lifted_chain_pays_what_the_soil_takes():
    check_chain(0.7)


@pytest.mark.parametrize("suction", [0.0, 0.6])
def test_chain_on_soil_of_another_suction_fails(suction):
    must_fail(check_chain, suction)


def test_long_segments_take_more():
    """Ten times as much on 1 m, as docs/seabed.md warns, and less on shorter ones."""
    expected = [taken(0.7) * 17.8 * part for part in (10.0, 5.0)]
    found = [lifted_chain(0.7, n)[0] - lifted_chain(0.0, n)[0] for n in (70, 140)]
    assert found == pytest.approx(expected, rel=0.1)
