"""Every force term by itself: its tangent is the derivative of its force, its force the gradient of its energy.

Tangents are compared with central differences. With a step h of 1e-5 to 1e-6 of the variable's size, truncation and
rounding both stay below 1e-8 of the largest entry; TIGHT allows ten times that.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from dense import DAMPING, MASS, STIFFNESS, full
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from moorings import curve
from scipy.interpolate import RegularGridInterpolator

from moorage.layout import Weights
from moorage.physics import friction as law
from moorage.physics.bathymetry import EASE, bed_at, flat_bed, grid_bed, normal_of
from moorage.physics.bending import (
    EXACT,
    PAPER,
    RIGID,
    Bending,
    bend,
    bending_terms,
    clamp_terms,
    end_hinge,
    half_hinge,
    hinge,
    hinge_energy,
    node_blocks,
    node_hinge,
)
from moorage.physics.contact import Contact, contact_energy, contact_fraction, contact_terms
from moorage.physics.current import current_at, current_of
from moorage.physics.friction import Friction, friction_terms, stuck_after
from moorage.physics.grid import build_grid, no_grid, values_at
from moorage.physics.morison import (
    Morison,
    drag_terms,
    drag_turn,
    hydro_block,
    inertia_terms,
    wet_node,
    wet_part,
)
from moorage.physics.motion import follow, spline_tracks
from moorage.physics.point import PointLoads, point_terms, wet_fraction
from moorage.physics.soil import FRESH, Law, no_soil, remember, resistance, soil_under
from moorage.physics.table import build_tables, interval, look_up
from moorage.physics.tension import Tension, damping, elastic, segment_tension, tension_energy, tension_terms
from moorage.physics.weight import wet_shares

TIGHT = 1e-7
FEW = settings(max_examples=25, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
UNIT = st.floats(-1.0, 1.0)
VECTORS = st.tuples(UNIT, UNIT, UNIT).filter(lambda v: np.linalg.norm(v) > 0.1)


def derivative(function, x, h=1e-6):
    """Central differences of a function of a vector: d f_i / d x_k."""
    x = np.array(x, float)
    columns = []
    for k in range(len(x)):
        d = np.zeros(len(x))
        d[k] = h
        columns.append((np.array(function(*(x + d))) - np.array(function(*(x - d)))) / (2.0 * h))
    return np.array(columns).T


def agree(a, b, tolerance=TIGHT, scale=None):
    a, b = np.asarray(a), np.asarray(b)
    size = np.abs(b).max() if scale is None else scale
    assert np.abs(a - b).max() <= tolerance * max(size, 1e-300), f"{a} is not {b}"


# --- tension --------------------------------------------------------------------------------------------------------

SPRING = curve((0.0, 0.0), (0.01, 2e4), (0.03, 5e4), (0.2, 1e6))
DAMPER = curve((0.0, 0.0), (0.1, 1e3), (1.0, 4e3))
# 0: linear, 1: tabulated spring, 2: tabulated damper, 3: a segment that can push
SEGMENTS = Tension(
    np.full(4, 2.0),
    np.array([1e6, 1e6, 1e6, 1e6]),
    np.array([3e3, 3e3, 0.0, 3e3]),
    np.array([0.0, 0.0, 0.0, -1e30]),
    np.zeros(4),
    np.array([-1, 0, -1, -1]),
    np.array([-1, -1, 1, -1]),
    build_tables([SPRING, DAMPER]),
)
STRETCHES = st.sampled_from([-0.05, 0.004, 0.015, 0.041, 0.3])  # relative to 2 m; none on a corner of the table


def spanning(direction, stretch):
    e = np.array(direction) / np.linalg.norm(direction)
    return tuple(2.0 * (1.0 + stretch) * e)


@FEW
@given(st.integers(0, 3), VECTORS, STRETCHES)
def test_tension_tangent_is_the_derivative_of_the_pull(j, direction, stretch):
    j, e, still = np.uintp(j), spanning(direction, stretch), (0.0, 0.0, 0.0)
    block = full(tension_terms(SEGMENTS, j, e, still, STIFFNESS)[1])
    agree(block, derivative(lambda *x: tension_terms(SEGMENTS, j, x, still, STIFFNESS)[0], e), 1e-6)


@FEW
@given(st.integers(0, 3), VECTORS, STRETCHES, VECTORS)
def test_tension_damping_block_is_the_derivative_to_the_rate(j, direction, stretch, rate):
    j, e = np.uintp(j), spanning(direction, stretch)
    block = full(tension_terms(SEGMENTS, j, e, rate, DAMPING)[1])
    agree(block, derivative(lambda *x: tension_terms(SEGMENTS, j, e, x, DAMPING)[0], rate), 1e-6)


@FEW
@given(VECTORS, STRETCHES)
def test_pull_is_the_gradient_of_the_elastic_energy(direction, stretch):
    """The pull on the first node is +dU/de: U falls when the first node moves along e."""
    j, e = np.uintp(0), spanning(direction, stretch)
    pull = tension_terms(SEGMENTS, j, e, (0.0, 0.0, 0.0), STIFFNESS)[0]
    gradient = derivative(lambda *x: [tension_energy(SEGMENTS, j, x)], e)[0]
    agree(pull, gradient, 1e-6, max(np.linalg.norm(gradient), 1.0))


@FEW
@given(VECTORS, STRETCHES, VECTORS)
def test_damping_never_feeds_energy(direction, stretch, rate):
    e = spanning(direction, stretch)
    along = np.dot(e, rate) / np.linalg.norm(e)
    for j in (0, 2):
        assert damping(SEGMENTS, np.uintp(j), along)[0] * along >= 0.0


def test_slack_segment_has_no_elastic_pull_and_a_table_starts_at_zero():
    assert elastic(SEGMENTS, np.uintp(0), -0.3) == (0.0, 0.0)
    assert elastic(SEGMENTS, np.uintp(1), -0.3) == (0.0, 0.0)
    assert elastic(SEGMENTS, np.uintp(3), -0.3)[0] == pytest.approx(-3e5)
    assert segment_tension(SEGMENTS, np.uintp(1), (2.04, 0.0, 0.0), (0.0, 0.0, 0.0)) == pytest.approx(3.5e4)


# --- tables ---------------------------------------------------------------------------------------------------------


@FEW
@given(st.lists(st.floats(-5.0, 5.0), min_size=2, max_size=8, unique=True), st.floats(-6.0, 6.0))
def test_table_is_linear_between_rows_and_goes_on_with_the_slope_of_its_ends(x, value):
    x = np.sort(np.round(x, 3))
    if np.diff(x).min() <= 0.0:
        return
    y = np.sin(3.0 * x)
    tables = build_tables([curve((0.0, 0.0), (1.0, 1.0)), curve(*zip(x, y, strict=True))])
    found, slope = look_up(tables, 1, value)
    k = int(np.clip(np.searchsorted(x, value, side="right") - 1, 0, len(x) - 2))
    expected = (y[k + 1] - y[k]) / (x[k + 1] - x[k])
    assert slope == pytest.approx(expected, rel=1e-12, abs=1e-12)
    assert found == pytest.approx(y[k] + expected * (value - x[k]), rel=1e-9, abs=1e-12)
    assert interval(tables.x, 2, 2 + len(x), value) == 2 + k


# --- bending --------------------------------------------------------------------------------------------------------

HALF = 8e3  # 2 EI / l of a half segment, N m/rad
MOMENTS = build_tables([curve((0.0, 0.0), (0.3, 2e3), (0.8, 4e3), (3.0, 9e3))])
BEND = Bending(
    np.array([HALF, HALF, HALF]), np.array([HALF, 3e3, RIGID]), np.array([-1, -1, 0]), np.zeros((0, 2)),
    np.zeros((0, 2)), MOMENTS,
)  # fmt: skip


def bend_law(law, c):
    """-dE/dc and d2E/dc2 of every hinge: interior nodes, unequal halves, the paper's joint, tables, clamps, springs."""
    if law in ("equal", "unequal", "table"):
        return node_hinge(BEND, np.uintp(("equal", "unequal", "table").index(law)), c)
    if law == "joint of the paper":
        return half_hinge(HALF, 3e3, c)
    i, rule = {
        "clamp": (2, EXACT), "clamp of the paper": (2, PAPER), "spring": (1, EXACT), "table at a clamp": (2, EXACT),
    }[law]  # fmt: skip
    held = BEND if law == "table at a clamp" else BEND._replace(table=np.array([-1, -1, -1]))
    return end_hinge(held, np.uintp(i), rule, c)


LAWS = ("equal", "unequal", "table", "joint of the paper", "clamp", "clamp of the paper", "spring", "table at a clamp")


@pytest.mark.parametrize("law", LAWS)
def test_second_derivative_of_a_hinge_is_that_of_its_first(law):
    """Central differences of -dE/dc over turns of up to 2 rad (1 rad at a clamp), off the corners of the table."""
    for angle in np.linspace(0.06, 1.0 if "clamp" in law else 2.0, 23):
        c, h = np.cos(angle), 1e-6
        U = bend_law(law, c)[1]
        difference = -(bend_law(law, c + h)[0] - bend_law(law, c - h)[0]) / (2.0 * h)
        assert pytest.approx(difference, rel=1e-5, abs=1e-4 * HALF) == U


def test_hinge_of_equal_halves_has_the_moment_of_the_papers_curvature():
    """M = EI kappa with kappa = (2 / l) sin(a / 2) (equation 7), and at a clamp kappa = (4 / l) sin(a / 2) (10)."""
    for angle in (0.1, 0.5, 1.0, 2.0):
        c, s = np.cos(angle), np.sin(angle)
        assert bend_law("equal", c)[0] * s == pytest.approx(HALF * np.sin(angle / 2.0), rel=1e-12)
        assert bend_law("clamp of the paper", c)[0] * s == pytest.approx(2.0 * HALF * np.sin(angle / 2.0), rel=1e-12)
        assert bend_law("clamp", c)[0] * s == pytest.approx(HALF * s, rel=1e-12)
        joint = half_hinge(HALF, HALF, c)[0] / hinge(HALF, HALF, c)[0]
        assert joint == pytest.approx(1.0 / np.cos(angle / 4.0), rel=1e-12)


def test_hinge_is_the_least_energy_over_the_direction_between_its_halves():
    k1, k2, angle = 8e3, 3e3, 1.3
    between = np.linspace(0.0, angle, 200001)
    least = np.min(k1 * (1.0 - np.cos(between)) + k2 * (1.0 - np.cos(angle - between)))
    assert hinge_energy(k1, k2, np.cos(angle)) == pytest.approx(least, rel=1e-9)


def terms(law, e1, e2):
    bent = bend(e1, e2)
    return bending_terms(bent, *bend_law(law, bent[4]), 1.0)


@FEW
@given(VECTORS, VECTORS, st.sampled_from(("equal", "unequal", "joint of the paper")))
def test_bending_is_gradient_and_hessian_of_its_energy(e1, turn, law):
    e2 = tuple(np.array(e1) * 1.3 + 0.5 * np.array(turn))
    if np.dot(e1, e2) < -0.9 * np.linalg.norm(e1) * np.linalg.norm(e2):
        return  # folded back: the energy has a corner there

    def energy(x, y):
        c = np.dot(x, y) / np.linalg.norm(x) / np.linalg.norm(y)
        if law == "joint of the paper":
            return 4.0 * hinge_energy(HALF, 3e3, np.sqrt(0.5 * (1.0 + c)))
        return hinge_energy(HALF, HALF if law == "equal" else 3e3, c)

    d1, d2, H11, H22, H12 = terms(law, e1, e2)
    scale = HALF / min(np.linalg.norm(e1), np.linalg.norm(e2)) ** 2
    agree(d1, derivative(lambda *x: [energy(x, e2)], e1)[0], 1e-6, scale)
    agree(d2, derivative(lambda *x: [energy(e1, x)], e2)[0], 1e-6, scale)
    agree(full(H11), derivative(lambda *x: terms(law, x, e2)[0], e1), 1e-6, scale)
    agree(full(H22), derivative(lambda *x: terms(law, e1, x)[1], e2), 1e-6, scale)
    agree(np.reshape(H12, (3, 3)), derivative(lambda *x: terms(law, e1, x)[0], e2), 1e-6, scale)


@FEW
@given(VECTORS)
def test_clamp_block_is_the_derivative_of_its_gradient(e):
    d = (0.8, 0.6, 0.0)

    def terms_at(*e):
        u = 1.0 / np.linalg.norm(e)
        q = tuple(u * np.array(e))
        c = float(np.dot(q, d))
        return clamp_terms(*bend_law("spring", c), u, q, d, c, 1.0)

    if np.dot(e, d) < -0.9 * np.linalg.norm(e):
        return
    agree(full(terms_at(*e)[1]), derivative(lambda *x: terms_at(*x)[0], e), 1e-6, HALF / np.linalg.norm(e) ** 2)


def test_straight_node_does_not_bend_and_a_folded_one_stays_finite():
    d1, d2, *_ = terms("equal", (1.0, 0.0, 0.0), (2.0, 0.0, 0.0))
    assert np.abs([d1, d2]).max() == 0.0
    for name in LAWS[:4]:
        folded = terms(name, (1.0, 0.0, 0.0), (-1.0, 0.0, 0.0))
        assert all(np.isfinite(part).all() for part in folded)


def test_bending_blocks_of_the_nodes_add_up_to_zero():
    """A translation of all three nodes costs nothing: every row of the blocks sums to zero."""
    _, _, H11, H22, H12 = terms("unequal", (1.0, 0.2, -0.1), (0.9, -0.3, 0.4))
    middle, before, after, H21 = node_blocks(H11, H22, H12)
    A, B, C = full(H11), full(middle), full(H22)
    P, Q, R = (np.reshape(m, (3, 3)) for m in (before, after, H21))
    for row in (A + P.T - R.T, P + B + Q.T, -R + Q + C):
        agree(row, np.zeros((3, 3)), 1e-12, np.abs(B).max())


# --- weight and buoyancy --------------------------------------------------------------------------------------------

LEVELS = st.floats(-1.5, 1.5)


@FEW
@given(LEVELS, LEVELS)
def test_wet_shares_derive_from_a_potential(z0, z1):
    """Their derivatives are those stated; that they are symmetric makes buoyancy the gradient of an energy."""
    radius = 0.3
    if min(abs(abs(z) - radius) for z in (z0, z1)) < 1e-5:
        return  # the wet fraction has corners there
    share0, share1, d00, d01, d11 = wet_shares(radius, z0, z1)
    D = derivative(lambda *z: wet_shares(radius, *z)[:2], (z0, z1), 1e-7)
    flat = abs(z1 - z0) < 1e-5  # there the stated derivatives belong to a slightly sloping segment
    agree([[d00, d01], [d01, d11]], D, 1e-3 if flat else 1e-6, 1.0 / radius)
    assert 0.0 <= share0 <= 0.5 + 1e-12
    assert 0.0 <= share1 <= 0.5 + 1e-12


@FEW
@given(LEVELS, LEVELS)
def test_wet_shares_are_the_integral_of_the_wet_fraction(z0, z1):
    """Against the midpoint rule with 20000 points (error below 1e-8) of N(t) phi(z(t))."""
    radius, n = 0.3, 20000
    t = (np.arange(n) + 0.5) / n
    phi = np.clip(0.5 - 0.5 * (z0 + t * (z1 - z0)) / radius, 0.0, 1.0)
    agree(wet_shares(radius, z0, z1)[:2], [np.mean((1.0 - t) * phi), np.mean(t * phi)], 1e-6, 1.0)


@pytest.mark.parametrize("z", [-0.31, -0.3, -0.1, 0.0, 0.2, 0.3, 0.31])
def test_level_segment_has_equal_shares(z):
    share0, share1, *_ = wet_shares(0.3, z, z)
    assert share0 == pytest.approx(share1, abs=1e-7)
    assert share0 + share1 == pytest.approx(np.clip(0.5 - 0.5 * z / 0.3, 0.0, 1.0), abs=1e-8)


# --- inertia and drag -----------------------------------------------------------------------------------------------


@FEW
@given(VECTORS, VECTORS)
def test_inertia_block_is_minus_the_derivative_to_the_acceleration(direction, a):
    q = tuple(np.array(direction) / np.linalg.norm(direction))
    still = drag_terms(0.0, 0.0, q, (0.0, 0.0, 0.0), MASS)[1]
    block = hydro_block(inertia_terms(120.0, 50.0, q, a, MASS)[1], still, q)
    agree(full(block), -derivative(lambda *x: inertia_terms(120.0, 50.0, q, x, MASS)[0], a), TIGHT)


@FEW
@given(VECTORS, VECTORS)
def test_drag_block_is_minus_the_derivative_to_the_velocity(direction, u):
    q = tuple(np.array(direction) / np.linalg.norm(direction))
    if min(abs(np.dot(q, u)), np.linalg.norm(np.cross(q, u))) < 1e-2:
        return  # |u| u has a corner of its second derivative at zero
    none = inertia_terms(0.0, 0.0, q, u, DAMPING)[1]
    block = hydro_block(none, drag_terms(300.0, 40.0, q, u, DAMPING)[1], q)
    agree(full(block), -derivative(lambda *x: drag_terms(300.0, 40.0, q, x, DAMPING)[0], u), 1e-6)


@FEW
@given(VECTORS, VECTORS)
def test_turn_of_drag_is_the_derivative_to_the_direction(direction, u):
    q = np.array(direction) / np.linalg.norm(direction)
    if min(abs(np.dot(q, u)), np.linalg.norm(np.cross(q, u))) < 1e-2:
        return
    found = np.array(drag_turn(300.0, 40.0, tuple(q), u)).reshape(3, 3)
    across = np.eye(3) - np.outer(q, q)
    expected = derivative(lambda *x: drag_terms(300.0, 40.0, tuple(x / np.linalg.norm(x)), u, DAMPING)[0], q)
    agree(found @ across, expected, 1e-6)


@FEW
@given(VECTORS, VECTORS)
def test_drag_opposes_the_motion_and_is_made_of_its_two_parts(direction, u):
    q = np.array(direction) / np.linalg.norm(direction)
    force = np.array(drag_terms(300.0, 40.0, tuple(q), u, DAMPING)[0])
    uq = np.dot(u, q) * q
    ut = np.array(u) - uq
    agree(force, -300.0 * np.linalg.norm(ut) * ut - 40.0 * np.linalg.norm(uq) * uq, 1e-12)
    assert np.dot(force, u) <= 0.0


def test_still_water_gives_no_drag_and_a_finite_block():
    force, block = drag_terms(300.0, 40.0, (1.0, 0.0, 0.0), (0.0, 0.0, 0.0), DAMPING)
    assert force == (0.0, 0.0, 0.0)
    assert np.isfinite(np.array(block[:3])).all()


def test_wet_parts_of_a_node_lie_between_dry_and_wet():
    segment = np.array([[2.0, 1.0, 6.0, 3.0, 9.0], [4.0, 2.0, 8.0, 5.0, 7.0]])
    p = Morison(np.array([10.0]), 0.5 * segment.sum(axis=0)[None], segment)
    i, j0, j1 = np.uintp(0), np.uintp(0), np.uintp(1)
    assert wet_part(p, i, j0, 0.5, j1, 0.5) == wet_node(p, i)
    assert wet_part(p, i, j0, 0.0, j1, 0.0) == (0.0, 0.0, 0.0, 0.0, 0.0)
    assert wet_part(p, i, j0, 0.5, j1, 0.25) == pytest.approx(tuple(0.5 * segment[0] + 0.25 * segment[1]))


# --- seabed ---------------------------------------------------------------------------------------------------------


def slope_grid(smooth=False, curved=False):
    x, y = np.linspace(-40.0, 40.0, 9), np.linspace(-30.0, 30.0, 5)
    X, Y = np.meshgrid(x, y, indexing="ij")
    return grid_bed(x, y, 20.0 + 0.2 * X - 0.1 * Y + (2e-3 * X * Y + 1e-3 * X * X if curved else 0.0), smooth)


BEDS = {"flat": flat_bed(-20.0), "plane": slope_grid(), "twisted": slope_grid(curved=True),
        "smooth": slope_grid(True, True)}  # fmt: skip
PENETRATIONS = st.floats(-0.5, 0.5).filter(lambda d: abs(d) > 1e-3)
PLACES = st.tuples(st.floats(-35.0, 35.0), st.floats(-25.0, 25.0))


@FEW
@given(PLACES)
def test_map_is_bilinear_and_goes_on_outside(place):
    x, y = np.array([-40.0, -12.0, 5.0, 40.0]), np.array([-30.0, 2.0, 30.0])
    first, second = np.sin(x[:, None] + 2.0 * y), 3.0 + x[:, None] * y
    p = build_grid(x, y, first, second)
    for scaled in (place, tuple(2.0 * np.array(place))):
        held = np.clip(scaled, [x[0], y[0]], [x[-1], y[-1]])
        expected = [RegularGridInterpolator((x, y), value)(held)[0] for value in (first, second)]
        assert values_at(p, *scaled) == pytest.approx(expected, rel=1e-9, abs=1e-9)


def test_contact_and_friction_take_their_map_at_the_place_of_the_node():
    r, i, zero = (3.0, -7.0, -20.1), np.uintp(0), (0.0, 0.0, 0.0)
    grid = build_grid([0.0, 10.0], [-10.0, 0.0], [[1.0, 2.0], [3.0, 4.0]], [[0.2, 0.4], [0.6, 0.8]])
    soft = contact_on("flat")._replace(stiffness=grid, spring=np.array([100.0]))
    assert contact_terms(soft, i, r, r, zero, FRESH, STIFFNESS)[0] == pytest.approx(100.0 * 1.9 * 0.1)
    rough = rubbing("elastic", 1.0, 1.0)._replace(map=grid)
    far = (4.0, -7.0, -20.1)
    assert friction_terms(rough, i, 50.0, UP, (1.0, 0.0, 0.0), r, zero, far, STIFFNESS)[0][0] == pytest.approx(95.0)
    assert friction_terms(rough, i, 50.0, UP, (0.0, 1.0, 0.0), r, zero, far, STIFFNESS)[0][0] == pytest.approx(19.0)


def contact_on(bed):
    return Contact(np.array([5e3]), np.array([700.0]), BEDS[bed], no_grid(), no_soil())


def on_an_edge(p, place):
    """Whether a place is where the slopes of two cells of a grid meet."""
    if len(p.x.at) == 0:
        return False
    return any(
        np.abs(axis.at - x).min() < 1.01 * EASE * np.diff(axis.at).max()
        for axis, x in zip((p.x, p.y), place, strict=True)
    )


@FEW
@given(st.sampled_from(sorted(BEDS)), PLACES)
def test_slopes_of_the_bed_are_its_derivatives(bed, place):
    p = BEDS[bed]
    if on_an_edge(p, place):
        return  # the bilinear surface has edges there
    _, zx, zy, zxx, zxy, zyy = bed_at(p, *place)
    agree([zx, zy], derivative(lambda *x: [bed_at(p, *x)[0]], place, 1e-5)[0], 1e-6, 1.0)
    D = derivative(lambda *x: bed_at(p, *x)[1:3], place, 1e-5)
    agree([[zxx, zxy], [zxy, zyy]], D, 1e-6, 1.0)


@FEW
@given(st.sampled_from(sorted(BEDS)), PLACES, PENETRATIONS, PENETRATIONS, VECTORS)
def test_contact_block_is_the_symmetric_part_of_the_derivative(bed, place, before, depth, v):
    """With the start of the step held. On a plane bed the derivative is symmetric by itself."""
    p, i = contact_on(bed), np.uintp(0)
    if abs(depth - before) < 1e-2:
        return
    if on_an_edge(p.bed, place):
        return
    level = bed_at(p.bed, *place)[0]
    r0, r = (*place, level - before), (*place, level - depth)

    def force(r, v):
        N, n, _ = contact_terms(p, i, r0, r, v, FRESH, STIFFNESS)
        return N * np.array(n)

    K = full(contact_terms(p, i, r0, r, v, FRESH, STIFFNESS)[2])
    D = -derivative(lambda *x: force(x, v), r)
    slack = 0.0 if bed in ("flat", "plane") else 700.0 * np.abs(v).max() * 0.05  # how the damper's n turns is left out
    assert np.abs(K - 0.5 * (D + D.T)).max() <= 1e-5 * 5e3 + slack
    C = full(contact_terms(p, i, r0, r, v, FRESH, DAMPING)[2])
    agree(C, -derivative(lambda *x: force(r, x), v), 1e-6, 700.0)


@FEW
@given(st.sampled_from(("flat", "plane")), PLACES, PENETRATIONS)
def test_bed_pushes_with_minus_the_gradient_of_its_energy(bed, place, depth):
    p, i = contact_on(bed), np.uintp(0)
    r = (*place, bed_at(p.bed, *place)[0] - depth)
    N, n, _ = contact_terms(p, i, r, r, (0.0, 0.0, 0.0), FRESH, STIFFNESS)
    if on_an_edge(p.bed, place):
        return
    agree(N * np.array(n), -derivative(lambda *x: [contact_energy(p, i, x)], r)[0], 1e-6, 5e3)


SOIL = soil_under(np.array([2.0]), np.array([0.1]), Law(6.0, 0.25, 5e3, 1.5e3, 200.0, 0.7, 0.6, 0.3, 7e3))
TURNS = {"fresh": (), "turned up": (0.04,), "turned down": (0.04, 0.01), "turned often": (0.06, 0.02, 0.04, 0.03)}


@FEW
@given(st.sampled_from(sorted(TURNS)), st.sampled_from(("flat", "plane")), PLACES, st.floats(1e-4, 0.12))
def test_soil_block_is_the_derivative_whatever_it_remembers(turns, bed, place, depth):
    p, i, memory, zero = contact_on(bed)._replace(soil=SOIL), np.uintp(0), FRESH, (0.0, 0.0, 0.0)
    for z in TURNS[turns]:
        memory = remember(SOIL, i, memory, z)
    n = np.array(normal_of(*bed_at(p.bed, *place)[1:3]))
    if abs(depth - memory[0]) < 1e-4 or abs(depth - 0.1) < 1e-4 or on_an_edge(p.bed, place):
        return  # stiffness jumps at a turn, and that of soil's lift is steep where the line is just covered
    r = (*place, bed_at(p.bed, *place)[0] - depth / n[2])

    def force(*r):
        N, n, _ = contact_terms(p, i, r, r, zero, memory, STIFFNESS)
        return N * np.array(n)

    assert contact_terms(p, i, r, r, zero, memory, STIFFNESS)[0] == pytest.approx(resistance(SOIL, i, memory, depth)[0])
    agree(full(contact_terms(p, i, r, r, zero, memory, STIFFNESS)[2]), -derivative(force, r, 1e-8), 1e-4, 2e7)


def test_soil_does_not_jump_between_steps_nor_where_it_turns():
    """Small ways up and down through any memory give small changes."""
    i, memory = np.uintp(0), FRESH
    way = np.concatenate([np.linspace(a, b, 200) for a, b in pairwise((0.0, 0.05, 0.03, 0.07, -0.01, 0.02, 0.0, 0.1))])
    steps = []
    for z in way:
        before = resistance(SOIL, i, memory, float(memory[0]))[0]
        steps.append(abs(resistance(SOIL, i, memory, float(z))[0] - before) / (abs(z - memory[0]) + 1e-12))
        memory = remember(SOIL, i, memory, float(z))
    assert max(steps[1:]) < 1.05 * 2.0 * 200.0 * 6.0 * (5e3 + 150.0)  # l k_max N_c s_u at 0.1 m, the greatest stiffness


CURVES = build_tables([curve((0.0, 0.0), (2e-3, 0.3), (6e-3, 0.5)), curve((0.0, 0.0), (5e-3, 0.5), (2e-2, 0.8))])


def rubbing(name, axial=0.4, transverse=0.7, ratio=1.0):
    laws = {
        "saturated": law.SATURATED,
        "velocity": law.VELOCITY,
        "elastic": law.ELASTIC,
        "stick-slip": law.STICK_SLIP,
        "soil": law.SOIL,
    }
    return Friction(
        laws[name], axial, transverse, ratio, 1e4, 0.05, np.array([2e5]),
        np.array([300.0 if name == "stick-slip" else 0.0]), False, no_grid(), CURVES,
    )  # fmt: skip


ALONG, UP = (0.6, 0.8, 0.0), (0.0, 0.0, 1.0)
SLOW = st.tuples(st.floats(-0.3, 0.3), st.floats(-0.3, 0.3), st.floats(-0.1, 0.1))


@FEW
@given(st.sampled_from(("saturated", "velocity", "elastic", "stick-slip")), SLOW, SLOW)
def test_friction_is_never_above_its_ellipse_and_never_leaves_the_bed(name, w, d):
    p, N = rubbing(name), 800.0
    stuck = tuple(0.05 * np.array(d))
    f = np.array(friction_terms(p, np.uintp(0), N, UP, ALONG, (0.0, 0.0, 0.0), w, stuck, STIFFNESS)[0])
    assert abs(f[2]) <= 1e-9 * N
    fa = f @ ALONG
    ft = np.linalg.norm(f - fa * np.array(ALONG))
    if name in ("elastic", "stick-slip"):
        assert np.hypot(fa / (0.4 * N), ft / (0.7 * N)) <= 1.0 + 1e-9
    else:
        assert abs(fa) <= 0.4 * N * (1 + 1e-9)
        assert ft <= 0.7 * N * (1 + 1e-9)


@FEW
@given(st.sampled_from(("saturated", "velocity")), SLOW)
def test_friction_of_velocity_takes_energy_and_its_block_is_its_derivative(name, w):
    p, N, i = rubbing(name), 800.0, np.uintp(0)
    flat = np.array([w[0], w[1], 0.0])
    wa = flat @ ALONG
    wt = np.linalg.norm(flat - wa * np.array(ALONG))
    edge = N / 1e4 if name == "saturated" else 0.05
    if min(abs(abs(wa) - edge), abs(wt - edge), wt) < 2e-3:
        return  # the ramp has a corner there

    def force(*w):
        return friction_terms(p, i, N, UP, ALONG, (0.0, 0.0, 0.0), w, (0.0, 0.0, 0.0), DAMPING)[0]

    assert np.dot(force(*w), w) <= 0.0
    block = full(friction_terms(p, i, N, UP, ALONG, (0.0, 0.0, 0.0), w, (0.0, 0.0, 0.0), DAMPING)[1])
    agree(block, -derivative(force, w, 1e-7), 1e-5, 1e4)


@FEW
@given(SLOW, st.floats(0.1, 3.0))
def test_slow_saturated_damping_is_the_law_itself(w, tilt):
    """Below the limits, the short way gives the force and block that the sum of both parts does."""
    p, N, t = rubbing("saturated"), 800.0, (0.6, 0.8, tilt)
    w = tuple(0.18 * np.array([w[0], w[1], 0.0]))  # 0.08 m/s is the limit
    short = friction_terms(p, np.uintp(0), N, UP, t, (0.0, 0.0, 0.0), w, (0.0, 0.0, 0.0), DAMPING)
    force, block = law.sliding(p, (0.4, 0.7), N, UP, ALONG, w, DAMPING)
    np.testing.assert_allclose(short[0], force, rtol=1e-6, atol=1e-9)  # the law itself divides by the speed plus 1e-12
    if np.hypot(*w[:2]) > 1e-4:
        np.testing.assert_allclose(short[1], block, rtol=1e-4, atol=1e-2)


@FEW
@given(SLOW)
def test_block_of_unequal_coefficients_has_the_diagonal_of_the_derivative(d):
    """Along the line and across it, and the determinant: zero where it slips."""
    p, N, i, zero = rubbing("elastic", 0.4, 0.7), 800.0, np.uintp(0), (0.0, 0.0, 0.0)
    r = np.array([0.05 * d[0], 0.05 * d[1], 0.0])
    axes = np.array([ALONG, np.cross(UP, ALONG)])
    load = np.hypot(*(axes @ r * 2e5 / (np.array([0.4, 0.7]) * N)))
    if abs(load - 1.0) < 0.02:
        return  # the corner between stick and slip

    def force(*r):
        return friction_terms(p, i, N, UP, ALONG, r, zero, zero, STIFFNESS)[0]

    block = axes @ full(friction_terms(p, i, N, UP, ALONG, tuple(r), zero, zero, STIFFNESS)[1]) @ axes.T
    D = -axes @ derivative(force, r, 1e-8) @ axes.T
    agree(np.diag(block), np.diag(D), 1e-4, 2e5)
    assert np.linalg.det(block) == pytest.approx(np.linalg.det(D), abs=1e-4 * 2e5**2)


@FEW
@given(st.tuples(st.floats(-0.03, 0.03), st.floats(-0.03, 0.03)), st.booleans())
def test_soil_curves_have_their_tangent_and_give_their_coefficients(way, stands):
    """Along the line and across it apart; a line that stands on the bed has no direction, and is held by the latter."""
    p, N, i, zero = rubbing("soil"), 800.0, np.uintp(0), (0.0, 0.0, 0.0)
    q, r = UP if stands else ALONG, (*way, 0.0)
    along = 0.0 if stands else abs(np.dot(r, q))
    across = np.sqrt(max(np.dot(r, r) - along**2, 0.0))
    corners = np.abs(np.subtract.outer([along, across], [0.0, 2e-3, 6e-3, 5e-3, 2e-2]))
    if corners[1].min() < 1e-5 or (not stands and corners[0].min() < 1e-5):
        return

    def force(*r):
        return friction_terms(p, i, N, UP, q, r, zero, zero, STIFFNESS)[0]

    f = np.array(force(*r))
    found = 0.0 if stands else abs(f @ q)
    assert found == pytest.approx(N * np.interp(along, [0.0, 2e-3, 6e-3], [0.0, 0.3, 0.5]), abs=1e-9)
    assert np.sqrt(max(f @ f - found**2, 0.0)) == pytest.approx(
        N * np.interp(across, [0.0, 5e-3, 2e-2], [0.0, 0.5, 0.8]), abs=1e-6
    )
    assert f @ r <= 0.0
    block = full(friction_terms(p, i, N, UP, q, r, zero, zero, STIFFNESS)[1])
    agree(block[:2, :2], -derivative(force, r, 1e-8)[:2, :2], 1e-4, 1e5)


@FEW
@given(SLOW)
def test_return_mapping_has_its_consistent_tangent(d):
    """Isotropic: the derivative of the returned force; on the ellipse of unequal coefficients it is not symmetric."""
    p, N, i = rubbing("elastic", 0.5, 0.5), 800.0, np.uintp(0)
    r = tuple(0.05 * np.array([d[0], d[1], 0.0]))
    if abs(np.hypot(r[0], r[1]) * 2e5 - 400.0) < 5.0:
        return  # the corner between stick and slip

    def force(*r):
        return friction_terms(p, i, N, UP, ALONG, r, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), STIFFNESS)[0]

    block = full(friction_terms(p, i, N, UP, ALONG, r, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), STIFFNESS)[1])
    D = -derivative(force, r, 1e-8)
    agree(block[:2, :2], D[:2, :2], 1e-4, 2e5)


@pytest.mark.parametrize("name", ["elastic", "soil"])
def test_no_energy_is_gained_in_a_closed_loop(name):
    """A node led round a loop and back: friction has taken work, and what its spring holds was paid for."""
    p, N, i, zero = rubbing(name), 800.0, np.uintp(0), (0.0, 0.0, 0.0)
    angle = np.linspace(0.0, 2.0 * np.pi, 721)
    path = 0.02 * np.stack([np.cos(angle) - 1.0, np.sin(angle), 0.0 * angle], axis=1)
    stuck, work, heat, before = zero, 0.0, 0.0, np.zeros(3)
    for r0, r in pairwise(path):
        force = np.array(friction_terms(p, i, N, UP, ALONG, tuple(r), zero, stuck, STIFFNESS)[0])
        work += 0.5 * (force + before) @ (r - r0)
        stuck, lost = stuck_after(p, i, N, UP, ALONG, tuple(r), zero, stuck, 0.01, STIFFNESS)
        heat, before = heat + lost, force
        assert lost >= 0.0
    held = 0.5 * 2e5 * np.sum((path[-1] - np.array(stuck)) ** 2)
    assert work + held < 0.0
    if name == "elastic":
        assert -(work + held) == pytest.approx(heat, rel=2e-3)
    # in full slip the work is that of the ellipse's force along the loop
    assert -work > 0.9 * 0.4 * N * 2.0 * np.pi * 0.02


@FEW
@given(PENETRATIONS, PENETRATIONS)
def test_contact_fraction_is_the_time_below_the_bed_on_a_straight_path(before, depth):
    fraction, slope = contact_fraction(before, depth)
    path = before + (depth - before) * (np.arange(20000) + 0.5) / 20000
    assert fraction == pytest.approx(np.mean(path > 0.0), abs=1e-4)
    expected = derivative(lambda x: [contact_fraction(before, x)[0]], [depth])[0, 0]
    assert slope == pytest.approx(expected, rel=1e-5, abs=1e-5)


@pytest.mark.parametrize("before", [-0.2, 0.0, 0.2])
def test_contact_fraction_is_continuous_at_touch_down(before):
    below, above = contact_fraction(before, 1e-9)[0], contact_fraction(before, -1e-9)[0]
    assert below == pytest.approx(above, abs=1e-7) or before == 0.0
    assert contact_fraction(0.0, 0.0)[0] == 0.0


# --- points ---------------------------------------------------------------------------------------------------------

LOADS = PointLoads(
    *(np.array([x]) for x in (500.0, 300.0, -4905.0, 917.4, 9000.0, 250.0, 0.6)),
    np.array([[[10.0, -20.0, 5.0], [30.0, 0.0, 50.0], [0.0, 70.0, 20.0]]]),
)
STREAM = 0.0, (0.4, -0.2, 0.1), (0.3, 0.1, -0.2)  # elevation, velocity and acceleration of the water


@FEW
@given(st.sampled_from([-3.0, -0.45, 0.0, 0.3, 1.0]), VECTORS, VECTORS)
def test_point_blocks_are_minus_the_derivatives_of_its_force(z, v, a):
    """K at rest: how drag and added mass change with the wet part is left out of the block, as documented."""
    r, zero = (1.0, 2.0, z), (0.0, 0.0, 0.0)
    still = 0.0, zero, zero
    K = full(point_terms(LOADS, 0, still, r, zero, zero, STIFFNESS)[1])
    agree(K, -derivative(lambda *x: point_terms(LOADS, 0, still, x, zero, zero, STIFFNESS)[0], r), 1e-6, 1e4)
    C = full(point_terms(LOADS, 0, STREAM, r, v, a, DAMPING)[1])
    agree(C, -derivative(lambda *x: point_terms(LOADS, 0, STREAM, r, x, a, DAMPING)[0], v), 1e-6, 1e3)
    M = full(point_terms(LOADS, 0, STREAM, r, v, a, MASS)[1])
    agree(M, -derivative(lambda *x: point_terms(LOADS, 0, STREAM, r, v, x, MASS)[0], a), 1e-6, 1e3)


@FEW
@given(st.floats(-1.0, 1.0))
def test_wet_fraction_of_a_sphere(z):
    """Against slices of a sphere: 4000 midpoints of pi (R^2 - y^2) below the surface, error below 1e-3."""
    radius = 0.6
    y = (np.arange(4000) + 0.5) / 4000 * 2.0 * radius - radius
    area = radius**2 - y**2
    fraction, slope = wet_fraction(radius, z)
    assert fraction == pytest.approx(area[y < -z].sum() / area.sum(), abs=1e-3)
    assert slope == pytest.approx(derivative(lambda x: [wet_fraction(radius, x)[0]], [z])[0, 0], abs=1e-5)


# --- current and motion ---------------------------------------------------------------------------------------------


@FEW
@given(st.floats(-60.0, 10.0))
def test_current_is_linear_between_levels_and_constant_beyond(z):
    levels, velocity = np.array([-50.0, -20.0, 0.0]), np.array([[0.1, 0.0, 0.0], [0.5, 0.2, -0.1], [1.0, 0.0, 0.3]])
    expected = [np.interp(z, levels, velocity[:, k]) for k in range(3)]
    profile = current_of([0.0], [0.0], [0.0], levels, velocity)
    agree(current_at(profile, (3.0, 4.0, z), 5.0), expected, 1e-12, 1.0)


@FEW
@given(st.floats(0.0, 9.9))
def test_prescribed_motion_is_smooth_and_its_velocity_is_its_derivative(t):
    time = np.linspace(0.0, 10.0, 41)
    samples = np.stack([np.sin(time), np.cos(0.7 * time), 0.1 * time**2], axis=1)
    tracks = spline_tracks(np.zeros((2, 3)), time, {1: samples})
    r, v, a = follow(tracks, 1, t)
    h = 1e-5
    agree(v, derivative(lambda x: follow(tracks, 1, x)[0], [t], h)[:, 0], 1e-6, 1.0)
    agree(a, derivative(lambda x: follow(tracks, 1, x)[1], [t], h)[:, 0], 1e-3, 1.0)
    # the spline's error is 5/384 h^4 max|y''''| = 5e-5 inside; not-a-knot ends are about ten times worse
    agree(r, [np.sin(t), np.cos(0.7 * t), 0.1 * t**2], 5e-4, 1.0)
    assert follow(tracks, 0, t) == ((0.0, 0.0, 0.0),) * 3


def test_weights_scale_the_blocks():
    """A block is linear in its weight, so that S = c.mass M + c.damping C + c.stiffness K is what it says."""
    e, de = (2.0, 0.1, -0.3), (0.1, 0.2, 0.3)
    one = full(tension_terms(SEGMENTS, np.uintp(0), e, de, Weights(0.0, 2.0, 5.0))[1])
    K = full(tension_terms(SEGMENTS, np.uintp(0), e, de, STIFFNESS)[1])
    C = full(tension_terms(SEGMENTS, np.uintp(0), e, de, DAMPING)[1])
    agree(one, 2.0 * C + 5.0 * K, 1e-14)
