"""Without drag and damping, energy is kept: what the implicit method loses is of second order in the step, and bounded.

Verifies: tension, weight, contact, morison

A chain of 12 segments with an end on the bed, under water (buoyancy and weight are potential, added mass is off),
starts with velocities of 2 m/s. Its energy is computed here from positions and velocities at step ends: kinetic,
elastic, weight and bed. Generalised-alpha with rho = 0.7 damps an oscillation by a ratio of (omega dt)^3, and lets
its energy swing by (omega dt)^2. What is gained or lost over 20 s, relative to the kinetic energy at the start, must
fall with the step at a rate between 1.8 and 3.2; gains must be below 1e-4, and losses below 2e-4 at a step of 2.5 ms
(the fastest mode has a period of 0.25 s). With an axial damping of 0.1 % of the critical one the check must fail.
"""

from __future__ import annotations

import dataclasses

import numpy as np
from common import must_fail, rate
from moorings import coupled, fixed, kind, run, single, statics

from moorage.physics.tension import tension_energy
from moorage.system.build import Built

SOFT = kind(diameter=0.1, mass_per_length=50.0, axial_stiffness=2e5)
STEPS = np.array([0.02, 0.01, 0.005, 0.0025])
DURATION = 20.0


def energy(built: Built, position, velocity) -> tuple[float, float]:
    """Kinetic and potential energy, J."""
    system = built.system
    kinetic = 0.5 * np.sum(system.morison.mass[:, None] * velocity**2)
    e = np.diff(position, axis=0)
    elastic = sum(tension_energy(system.tension, np.uintp(j), tuple(x)) for j, x in enumerate(e))
    z, half = position[:, 2], 0.5 * system.weight.buoyancy
    weight = -system.weight.dry @ z - half @ (z[1:] + z[:-1])
    bed = 0.5 * np.sum(system.contact.spring * np.maximum(system.contact.bed.flat - z, 0.0) ** 2)
    return kinetic, elastic + weight + bed


def drift(step: float, damping: float = 0.0) -> np.ndarray:
    """Energy above that at the start, relative to the kinetic energy there."""
    rope = dataclasses.replace(SOFT, axial_damping_ratio=damping)
    model = single(
        rope, 62.0, 12, fixed(1, 0.0, 0.0, -30.0), coupled(2, 45.0, 0.0, -5.0), water_depth=30.0, seabed_stiffness=2e4,
        seabed_damping=0.0,
    )  # fmt: skip
    built = statics(model)
    s = np.linspace(0.0, 1.0, 13)
    built.state.velocity[:13, 0] = 2.0 * np.sin(np.pi * s)
    built.state.velocity[:13, 1] = 1.0 * np.sin(2.0 * np.pi * s)
    block = run(built, DURATION, time_step=step, dt_out=1.0, dt_nodes=step, tolerance=1e-9)
    parts = np.array([energy(built, r, v) for r, v in zip(block["node_position"], block["node_velocity"], strict=True)])
    total = parts.sum(axis=1)
    return (total - total[0]) / parts[0, 0]


def check(damping: float = 0.0) -> None:
    found = np.array([[np.abs(d.min()), d.max()] for d in (drift(step, damping) for step in STEPS)])
    for column in found.T:
        assert 1.8 < rate(STEPS, column) < 3.2, f"{found}"
    assert (found[-1] < [2e-4, 1e-5]).all(), f"{found}"
    assert found[:, 1].max() < 1e-4


def test_energy_is_kept():
    check()


def test_damped_line_fails():
    must_fail(check, 1e-3)
