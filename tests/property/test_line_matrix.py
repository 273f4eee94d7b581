"""The assembled matrix of whole lines against finite differences of the assembled force, and what must add up to zero.

The lines are in disorder on purpose: random positions, velocities and accelerations, slack and taut segments, nodes
in the bed and on their way into it, two sections, a free point, bends. What the matrix leaves out (how the direction
of inertia, drag and damping turns) is switched off where it would spoil the comparison, and nothing else.
"""

from __future__ import annotations

import numpy as np
import pytest
from dense import DAMPING, MASS, STIFFNESS, assembled
from moorings import curve, fixed, free, kind, line, mooring

from moorage.layout import State, Weights, copy_of
from moorage.model import Current
from moorage.physics.bathymetry import flat_bed
from moorage.physics.tension import tension_energy
from moorage.solve.statics_kernel import place_at_rest
from moorage.system.build import Built, build

TABLE = curve((0.0, 0.0), (0.02, 2e3), (0.06, 9e3), (0.3, 6e4))
HYDRO = {"transverse_drag": 1.2, "tangential_drag": 0.4, "transverse_added_mass": 1.0, "tangential_added_mass": 0.2}


def disorder(seed: int = 1, bends: bool = True, surface: bool = False, **environment) -> Built:
    """Two lines that share a free point, moved at random by 0.4 m, with everything in motion."""
    EI = (300.0, 900.0) if bends else (0.0, 0.0)
    types = (
        kind("soft", diameter=0.2, mass_per_length=60.0, axial_stiffness=2e5, axial_damping=4e3,
             bending_stiffness=EI[0], **HYDRO),
        kind("table", diameter=0.3, mass_per_length=90.0, axial_stiffness=TABLE, axial_damping=9e3,
             bending_stiffness=EI[1], **HYDRO),
    )  # fmt: skip
    up = 19.0 if surface else 0.0
    points = (
        fixed(1, 0.0, 0.0, up - 20.0),
        free(2, 8.0, 1.0, up - 19.0, mass=200.0, volume=0.1, drag_area=0.5, added_mass=0.6),
        fixed(3, 14.0, 3.0, up - 14.0),
    )
    lines = (
        line(1, 2, 1, ("soft", 6.0, 3), ("table", 5.0, 4)),
        line(2, 2, 3, ("table", 5.0, 4), ("soft", 6.0, 3)),
    )
    around = {"water_depth": 20.0, "seabed_stiffness": 3e4, "seabed_damping": 3e3} | environment
    built = build(mooring(types, points, lines, **around))
    random = np.random.default_rng(seed)
    for rows in built.state[:3]:
        rows += random.normal(0.0, 0.4, rows.shape)
    n = built.names.node_ptr[-1]
    for rows in built.state[:3]:
        rows[[0, 8]] = rows[n + 1]
    return built


def still(built: Built) -> Built:
    quiet = copy_of(built.state)
    for rows in quiet[1:]:
        rows[...] = 0.0
    return built._replace(state=quiet)


def only(built: Built, *names: str) -> Built:
    """The system with all terms switched off but the named ones."""
    system = built.system
    off = {}
    for name in {"tension", "bending", "weight", "morison"} - set(names):
        term = getattr(system, name)
        off[name] = type(term)(
            *(np.zeros_like(x) if isinstance(x, np.ndarray) and x.dtype == float else x for x in term)
        )
    if "tension" not in names:
        off["tension"] = off["tension"]._replace(
            length=system.tension.length, spring_table=np.full_like(system.tension.spring_table, -1)
        )
    if "weight" not in names:
        off["weight"] = off["weight"]._replace(radius=system.weight.radius)
    if "contact" not in names:
        off["contact"] = system.contact._replace(bed=flat_bed(-1e9))
    else:
        off["contact"] = system.contact
    return built._replace(system=system._replace(**off))


def differences(built: Built, c: Weights, before=None) -> np.ndarray:
    """Minus the derivative of the force to an increment that moves position, velocity and acceleration by c."""
    n = 3 * int(built.names.node_ptr[-1])
    D, h = np.zeros((n, n)), 1e-6 / (c.stiffness or c.damping or c.mass)
    for k in range(n):
        sides = []
        for sign in (1.0, -1.0):
            moved = State(*(x.copy() for x in built.state))
            for rows, weight in zip(moved, (c.stiffness, c.damping, c.mass), strict=False):
                rows[k // 3, k % 3] += sign * h * weight
            sides.append(assembled(built, c, moved, before)[1].ravel())
        D[:, k] = -(sides[0] - sides[1]) / (2.0 * h)
    return D


def tangent_error(built: Built, c: Weights, before=None) -> float:
    before = built.state.position if before is None else before
    S, D = assembled(built, c, before=before)[0], differences(built, c, before)
    return float(np.abs(S - D).max() / np.abs(D).max())


@pytest.mark.parametrize(
    ("term", "surface"), [("tension", False), ("bending", False), ("weight", True), ("contact", False)]
)
def test_stiffness_of_each_term(term, surface):
    """Weight has a stiffness only where segments cross the surface."""
    built = only(still(disorder(surface=surface)), term)
    assert np.abs(assembled(built, STIFFNESS)[0]).max() > 0.0
    assert tangent_error(built, STIFFNESS) < 1e-7


@pytest.mark.parametrize("term", ["tension", "morison", "contact"])
def test_damping_of_each_term(term):
    built = only(disorder(current=Current((-20.0, 0.0), ((0.1, 0.0, 0.0), (0.4, -0.3, 0.1)))), term)
    assert tangent_error(built, DAMPING) < 1e-7


def test_mass():
    assert tangent_error(only(disorder(), "morison"), MASS) < 1e-8


@pytest.mark.parametrize("bends", [False, True])
def test_all_terms_together_at_rest(bends):
    """S = M + c_C C + c_K K of a step of 0.06 s: nothing is left out while nothing moves.

    The differences move the nodes at up to 3e-5 m/s, whose drag makes 4e-7 of the largest entry.
    """
    assert tangent_error(still(disorder(bends=bends)), Weights(1.0, 0.03, 9e-4)) < 1e-6


def test_seabed_while_nodes_enter_and_leave_it():
    """The start of the step is held: the derivative is that to the position at its end."""
    built = only(disorder(), "contact")
    before = built.state.position + np.random.default_rng(2).normal(0.0, 0.5, built.state.position.shape)
    entering = (before[:, 2] > -20.0) & (built.state.position[:, 2] < -20.0)
    leaving = (before[:, 2] < -20.0) & (built.state.position[:, 2] > -20.0)
    assert entering.any()
    assert leaving.any()
    assert tangent_error(built, Weights(1.0, 0.03, 9e-4), before) < 1e-6


@pytest.mark.parametrize("c", [STIFFNESS, DAMPING, MASS, Weights(1.0, 0.03, 9e-4)])
def test_matrix_is_symmetric(c):
    S = assembled(disorder(), c)[0]
    assert np.abs(S - S.T).max() <= 1e-13 * np.abs(S).max()


@pytest.mark.parametrize("seed", range(5))
def test_internal_forces_have_no_resultant_and_no_moment(seed):
    """Tension, axial damping and bending of a line, its ends included (rounding only)."""
    built = only(disorder(seed), "tension", "bending")
    f = assembled(built, STIFFNESS)[1]
    r, size = built.state.position[: len(f)], np.abs(f).max()
    for first, last in zip(built.names.node_ptr[:-1], built.names.node_ptr[1:], strict=True):
        part = slice(first, last)
        assert np.abs(f[part].sum(axis=0)).max() < 1e-13 * size
        assert np.abs(np.cross(r[part], f[part]).sum(axis=0)).max() < 1e-12 * size * np.abs(r).max()


def potential(built: Built, position: np.ndarray) -> float:
    """Elastic and bending energy, weight and bed of all lines, J (under water, linear tension)."""
    system, total = built.system, 0.0
    for k, (first, end) in enumerate(zip(built.names.node_ptr[:-1], built.names.node_ptr[1:], strict=True)):
        e = np.diff(position[first:end], axis=0)
        total += sum(tension_energy(system.tension, np.uintp(first - k + j), tuple(e[j])) for j in range(len(e)))
        q = e / np.linalg.norm(e, axis=1)[:, None]
        cosine = np.sum(q[1:] * q[:-1], axis=1)
        k1, k2 = system.bending.before[first + 1 : end - 1], system.bending.after[first + 1 : end - 1]
        total += np.sum(k1 + k2 - np.sqrt(k1**2 + k2**2 + 2.0 * k1 * k2 * cosine))
        lift = 0.5 * system.weight.buoyancy[first - k : end - k - 1]
        z = position[first:end, 2]
        total -= system.weight.dry[first:end] @ z + lift @ (z[:-1] + z[1:])
        total += np.sum(0.5 * system.contact.spring[first:end] * np.maximum(system.contact.bed.flat - z, 0.0) ** 2)
    return float(total)


def test_static_force_is_minus_the_gradient_of_the_potential():
    built = still(disorder())
    built = built._replace(
        system=built.system._replace(
            tension=built.system.tension._replace(spring_table=np.full(14, -1), spring=np.full(14, 3e5))
        )
    )
    f = assembled(built, STIFFNESS)[1].ravel()
    gradient = np.zeros_like(f)
    for k in range(len(f)):
        d = np.zeros_like(f)
        d[k] = 1e-6
        r = built.state.position[: len(f) // 3]
        sides = [potential(built, r + s * d.reshape(-1, 3)) for s in (1.0, -1.0)]
        gradient[k] = (sides[0] - sides[1]) / 2e-6
    assert np.abs(f + gradient).max() < 1e-6 * np.abs(f).max()


def test_a_wrong_tangent_is_noticed():
    """The comparison sees a matrix that is 0.1 % off in one term."""
    built = still(disorder())
    S = assembled(built, STIFFNESS)[0]
    spoiled = built._replace(
        system=built.system._replace(tension=built.system.tension._replace(spring=1.001 * built.system.tension.spring))
    )
    D = differences(spoiled, STIFFNESS)
    assert np.abs(S - D).max() / np.abs(D).max() > 1e-5


def test_ends_at_rest_copy_their_points():
    built = disorder()
    place_at_rest(built.system, built.state, built.work, 0)
    n = built.names.node_ptr[-1]
    assert (built.state.position[[0, 8]] == built.state.position[n + 1]).all()
    assert (built.state.position[[7, 15]] == built.system.tracks.rest[[0, 2]]).all()
    assert np.abs(built.state.velocity[:n]).max() == 0.0
