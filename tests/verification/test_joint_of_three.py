"""Three cables that meet at a rod of no length: it has no inertia of its own, and turns until the moments balance.

Verifies: bending

* Three beams of stiffness EI and length L meet straight, one at end A, two at end B of the joint, their far ends
  pinned. One far end is moved aside by s. With the deflection y and the rotation a of the joint, each beam presses on
  it with 3 EI / L^3 times what its far end is off the joint's direction; balance gives 3 y + a L = s, y + 3 a L = s,
  so that y = a L = s / 4, and the moments of the three clamps are (1/2, -1/2, 0) 3 EI s / L^2. Hinges of n segments
  have the flexibility of a cantilever but for 1 / (2 n^2) of it, which the rate shows.
* Hung in water from three sides at once and bent by radians, forces and moments at the joint balance to what statics
  leave, and the whole is stationary: the energy of springs, hinges, weight and clamps, summed here without the engine,
  has no slope along any coordinate, nor along a turn of the joint.
* A joint of two cables is a hinge, without a rotation. Built as an object it must be the same cable, by both rules.
* In vacuum, without damping, the energy of a run is kept, with what turns with the joint.

Wrong: a cable that is pinned to the joint bears no moment; springs and a hinge of another stiffness have a slope.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import VACUUM, at_once, beam
from common import must_fail, rate
from moorings import again, fixed, held, joint, kind, line, mooring, nodes, statics

from moorage.model import cables
from moorage.physics.rigid import INERTIA
from moorage.solve.march import March, Settings
from moorage.solve.statics import rest
from moorage.system.build import build

EI, L, ASIDE = 1e4, 10.0, 1e-3
CABLE = kind("cable", diameter=0.15, mass_per_length=40.0, axial_stiffness=1e7, bending_stiffness=5e3)


def star(segments: int, pinned: bool = False):
    """Three beams, of which the far end of the second is moved aside."""
    rod = joint(1, 0.0, 0.0, -50.0)
    ends = fixed(1, -L, 0.0, -50.0), fixed(2, L, 0.0, -50.0 + ASIDE), fixed(3, L, 0.0, -50.0)
    part = ("beam", L, segments)
    lines = [line(1, 1, held(rod, "A"), part), line(2, held(rod, "B"), 2, part), line(3, 3, held(rod, "B"), part)]
    if pinned:
        lines[1] = dataclasses.replace(lines[1], end_a_stiffness=0.0)
    return mooring(beam(EI), ends, lines, (rod,), **VACUUM)


def moments_at_joint(built) -> np.ndarray:
    """Moments of the cables on the joint about y, N m: (line 1, 2, 3)."""
    moment = at_once(built)["end_moment"][0]
    return np.array([moment[0, 1, 1], moment[1, 0, 1], moment[2, 1, 1]])


def errors(segments: int, pinned: bool = False) -> tuple[float, float]:
    """What deflection and moments are off, relative."""
    built = statics(star(segments, pinned), tolerance=1e-9)
    height = nodes(built)[-1, 2] + 50.0
    unit = 3.0 * EI * ASIDE / L**2
    off = moments_at_joint(built) - unit * np.array([0.0, -0.5, 0.5])  # about y, which turns x down
    return abs(height - ASIDE / 4.0) / ASIDE, float(np.abs(off).max() / unit)


def check_star(pinned: bool = False) -> None:
    sizes = np.array([4, 8, 16])
    height, moment = np.array([errors(n, pinned) for n in sizes]).T
    assert height.max() < 1e-5, f"{height}"  # equal beams, of whatever stiffness
    assert rate(1.0 / sizes, moment) == pytest.approx(2.0, abs=0.05)
    assert moment[-1] < 1.1 * 0.5 / (2.0 * 16**2), f"{moment}"


def test_three_beams_meet():
    check_star()


def test_pinned_cable_fails():
    must_fail(check_star, True)


def hung(flavour: str = "native", ends: str = "ABB"):
    """Cables from three points that meet below them, strongly bent."""
    rod = joint(1, 0.0, 0.0, -30.0)
    points = fixed(1, -14.0, 0.0, -22.0), fixed(2, 12.0, 6.0, -24.0), fixed(3, 9.0, -9.0, -20.0)
    lines = [line(1, 1, held(rod, ends[0]), ("cable", 18.0, 9))]
    lines += [line(k, held(rod, ends[k - 1]), k, ("cable", 17.0, 7)) for k in range(2, 1 + len(ends))]
    return dataclasses.replace(mooring(CABLE, points[: len(ends)], lines, (rod,)), flavour=flavour)


@pytest.mark.parametrize("flavour", ["native", "MoorDyn-C"])
def test_forces_and_moments_balance(flavour):
    built = statics(hung(flavour), tolerance=1e-6)
    block = at_once(built)
    force, moment = block["end_force"][0], block["end_moment"][0]
    at = [(k, 1 if k == 0 else 0) for k in range(3)]
    size = max(np.linalg.norm(moment[k]) for k in at)
    assert size > 500.0  # N m: they do bend
    assert np.linalg.norm(sum(force[k] for k in at)) < 2e-6
    assert np.linalg.norm(sum(moment[k] for k in at)) < 1e-5
    assert np.abs(block["rod_force"][0, 0]).max() < 1e-5


def potential(built, x, d, t=CABLE, density: float = 1025.0, hinge: float = 1.0) -> float:
    """Energy of a hung star (native rule), J, from positions of its rows (n, 3) and the joint's direction."""
    total = 0.0
    place = x[built.system.riders.row[0]]
    for k, (a, b) in enumerate(zip(built.names.node_ptr[:-1], built.names.node_ptr[1:], strict=True)):
        r = x[a:b].copy()
        r[-1 if k == 0 else 0] = place
        l = (18.0 if k == 0 else 17.0) / (b - a - 1)
        e = np.diff(r, axis=0)
        size = np.linalg.norm(e, axis=1)
        q = e / size[:, None]
        total += 0.5 * t.axial_stiffness / l * np.sum(np.maximum(size - l, 0.0) ** 2)
        stiffness = 2.0 * t.bending_stiffness / l
        cosine = (q[1:] * q[:-1]).sum(axis=1)
        total += hinge * np.sum(2.0 * stiffness - stiffness * np.sqrt(2.0 + 2.0 * cosine))
        total += stiffness * (1.0 - (-q[-1] @ -d if k == 0 else q[0] @ d))
        w = 9.80665 * (t.mass_per_length - density * np.pi / 4.0 * t.diameter**2)
        total += w * l * (r[:, 2].sum() - 0.5 * (r[0, 2] + r[-1, 2]))
    return total


def check_stationary(hinge: float = 1.0) -> None:
    """Central differences of 1e-4 m leave rounding of 1e-12 J over that, and third derivatives of 1e-8 EA / l^2."""
    built = statics(hung(), tolerance=1e-6)
    x, R = built.state.position.copy(), built.state.attitude[0].reshape(3, 3)
    ptr = built.names.node_ptr
    ends = np.concatenate([ptr[:-1], ptr[1:] - 1])
    rows = [*np.setdiff1d(np.arange(ptr[-1]), ends), built.system.riders.row[0]]
    slopes, step = [], 1e-4
    for row in rows:
        for axis in range(3):
            values = []
            for sign in (1.0, -1.0):
                moved = x.copy()
                moved[row, axis] += sign * step
                values.append(potential(built, moved, R[:, 0], hinge=hinge))
            slopes.append((values[0] - values[1]) / (2.0 * step))
    for axis in (1, 2):
        a = [np.cos(step) * R[:, 0] + sign * np.sin(step) * R[:, axis] for sign in (1.0, -1.0)]
        slopes.append((potential(built, x, a[0], hinge=hinge) - potential(built, x, a[1], hinge=hinge)) / (2.0 * step))
    assert np.abs(slopes).max() < 0.05, f"{np.abs(slopes).max()} N"  # of tensions of kN and moments of 500 N m


def test_energy_has_no_slope():
    check_stationary()


def test_other_hinges_fail():
    must_fail(check_stationary, 1.01)


@pytest.mark.parametrize("flavour", ["native", "MoorDyn-C"])
def test_two_cables_as_an_object_are_one_cable(flavour, monkeypatch):
    """To 1e-6 N of statics; the softest way to move costs more than 1 N/m."""
    model = hung(flavour, "AB")
    hinge = statics(model, tolerance=1e-6)
    assert not len(hinge.system.riders.row)
    monkeypatch.setattr(cables, "is_hinge", lambda model, rod: False)
    whole = statics(model, tolerance=1e-6)
    assert len(whole.system.riders.row) == 1
    n = hinge.names.node_ptr[-1]
    assert np.abs(hinge.state.position[:n] - whole.state.position[:n]).max() < 1e-5
    ours, theirs = (at_once(built)["bending_moment"][0] for built in (whole, hinge))
    assert np.abs(ours).max() > 400.0
    assert np.abs(ours - theirs).max() < 1e-5 * np.abs(theirs).max()


def test_a_joint_starts_where_its_moments_balance():
    """In line with the sum of stiffness times direction of the first segments, whatever direction is described."""
    built = build(hung())
    rest(built)
    ptr, x = built.names.node_ptr, built.state.position
    into = [x[ptr[1] - 1] - x[ptr[1] - 2], x[ptr[1] + 1] - x[ptr[1]], x[ptr[2] + 1] - x[ptr[2]]]
    total = sum(2.0 * 5e3 / l * e / np.linalg.norm(e) for e, l in zip(into, (2.0, 17.0 / 7.0, 17.0 / 7.0), strict=True))
    assert built.state.attitude[0].reshape(3, 3)[:, 0] == pytest.approx(total / np.linalg.norm(total), abs=1e-12)


STEPS = np.array([0.02, 0.01, 0.005])
SOFT = dataclasses.replace(CABLE, axial_stiffness=2e5, diameter=1e-6)


def energy(built) -> tuple[float, float]:
    """Kinetic and whole energy, J; of the joint, that of the halves of the segments that turn with it."""
    n, state, row = built.names.node_ptr[-1], built.state, built.system.riders.row[0]
    kinetic = 0.5 * np.sum(built.system.morison.mass[:n, None] * state.velocity[:n] ** 2)
    kinetic += 0.5 * built.system.rigid.table[0, INERTIA + 4] * np.sum(state.velocity[row + 1] ** 2)
    direction = state.attitude[0].reshape(3, 3)[:, 0]
    return kinetic, kinetic + potential(built, state.position, direction, SOFT, 0.0)


def drift(step: float, damping: float = 0.0) -> float:
    """Largest change of the energy in 4 s over the kinetic energy at the start, of a star in air that is thrown."""
    soft, model = dataclasses.replace(SOFT, axial_damping_ratio=damping), hung()
    air = dataclasses.replace(model.environment, water_density=0.0)
    built = statics(dataclasses.replace(model, environment=air, line_types=(soft,)), tolerance=1e-6)
    ptr, row = built.names.node_ptr, built.system.riders.row[0]
    built.state.velocity[: ptr[-1], 1] = built.state.velocity[row, 1] = 1.0
    built.state.velocity[[ptr[0], ptr[2] - 1, ptr[3] - 1]] = 0.0
    built.state.velocity[row + 1] = 0.0, 0.5, -0.3
    march = March(again(built), Settings(time_step=step, dt_out=0.5, tolerance=1e-9), 4.0)
    march.first()
    start, totals = energy(march.built)[0], []
    for time in np.arange(0.0, 4.01, 0.5):
        march.advance(time)
        totals.append(energy(march.built)[1])
    return float(np.abs(np.array(totals) - totals[0]).max() / start)


def check_energy(damping: float = 0.0) -> None:
    found = [drift(step, damping) for step in STEPS]
    assert 1.7 < rate(STEPS, found) < 3.2, f"{found}"
    assert found[-1] < 5e-3, f"{found}"


def test_energy_is_kept():
    """The method lets it swing by the square of the step: (w dt)^2 / 12 of the quickest part that has any."""
    check_energy()


def test_damping_fails():
    must_fail(check_energy, 0.05)
