"""A cable clamped to free bodies: what they give each other is in balance.

Verifies: rigid, bending

In vacuum, two free bodies and the cable that is clamped to both keep momentum and angular momentum

    sum m v,   sum m r x v + R J Omega

to the second order of the step (a rate above 1.7 is asserted), whatever the rule of the clamps: ours or that of the
paper (Hall 2020, equation 10), with which files of MoorDyn are read. At once, force and moment on a body are those of
the cable's end: m a = F and J Omega' = C + arm x F where nothing turns yet. The moment C of the clamp is the greater part
(MoorDyn-C never hands it to the rod, whose bodies then gain angular momentum from nothing).
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from cables import beam, sections
from common import must_fail, rate
from floats import VACUUM, body, floating, momenta, rod, throw
from moorings import at_rest, held, run

from moorage.model import Line

INERTIA = np.array([10.0, 20.0, 35.0])
ORIGIN = np.array([0.0, 0.0, -50.0])


def joined(flavour: str = "native"):
    """Bodies 4 m apart that turn their clamps 0.5 and 0.8 rad away from the cable between them."""
    bodies = (body(1, rotation=(0.0, 0.5, 0.2)), body(2, position=(4.4, 0.3, -50.0), rotation=(0.3, 0.0, 0.8)))
    clamps = tuple(
        rod(k, "fixed", (x, 0.1, 0.0), (x + np.sign(x), 0.1, 0.0), 0, body=k) for k, x in ((1, 0.2), (2, -0.2))
    )
    cable = Line(id=1, sections=sections(("beam", 4.0, 8)), end_a=held(clamps[0], "B"), end_b=held(clamps[1], "B"))
    model = floating(
        bodies,
        clamps,
        line_types=beam(3e3, mass_per_length=5.0, axial_stiffness=2e5),
        environment=VACUUM,
        lines=(cable,),
    )
    return dataclasses.replace(model, flavour=flavour)


def started(flavour: str):
    built = at_rest(joined(flavour))
    throw(built, (0.0, -0.5, 0.2), (0.3, 0.0, -0.5), 0)
    throw(built, (0.3, 0.4, 0.0), (0.0, 0.3, 0.6), 1)
    return built


def kept(flavour: str, step: float) -> tuple[float, float]:
    """Largest changes of momentum (N s) and of angular momentum (N m s) of bodies and cable in 1 s."""
    built = started(flavour)
    mass = built.system.morison.mass[: built.names.node_ptr[1]]
    block = run(built, 1.0, dt_out=0.1, dt_nodes=0.1, time_step=step, tolerance=1e-9)
    p, H = momenta(block, mass, 100.0, INERTIA, ORIGIN)
    return float(np.abs(p - p[0]).max()), float(np.abs(H - H[0]).max())


@pytest.mark.parametrize("flavour", ["native", "MoorDyn-C"])
def test_momenta_are_kept(flavour):
    steps = np.array([2e-3, 1e-3, 5e-4])
    errors = np.array([kept(flavour, h) for h in steps])
    assert rate(steps, errors[:, 0]) > 1.7
    assert rate(steps, errors[:, 1]) > 1.7
    assert errors[-1, 0] < 0.05
    assert errors[-1, 1] < 0.1


def check_at_once(flavour: str, clamped: bool) -> None:
    block = run(at_rest(joined(flavour)), 1e-3, dt_out=1e-3, time_step=1e-3, tolerance=1e-9)
    for k, arm in ((0, [0.2, 0.1, 0.0]), (1, [-0.2, 0.1, 0.0])):
        R, a = block["body_axes"][0, k], block["body_acceleration"][0, k]
        F, C = block["end_force"][0, 0, k], block["end_moment"][0, 0, k]
        assert np.linalg.norm(C) > 100.0
        moment = np.cross(R @ arm, F) + (C if clamped else 0.0)
        assert 100.0 * a[:3] == pytest.approx(F, abs=1e-9 * np.abs(F).max())
        assert R @ (INERTIA * (R.T @ a[3:])) == pytest.approx(moment, abs=1e-9 * np.abs(moment).max())


@pytest.mark.parametrize("flavour", ["native", "MoorDyn-C"])
def test_a_body_feels_its_clamp(flavour):
    check_at_once(flavour, True)


def test_bodies_that_do_not_feel_the_moment_fail():
    must_fail(check_at_once, "native", False)


def test_the_rules_differ_as_the_paper_says():
    """4 EI / l sin(a / 2) against 2 EI / l sin(a), for the angles of 0.5 rad and more here: above 1 / cos(a / 2)."""
    moments = [
        np.linalg.norm(run(at_rest(joined(f)), 1e-3, dt_out=1e-3, time_step=1e-3)["end_moment"][0, 0], axis=-1)
        for f in ("native", "MoorDyn-C")
    ]
    built = at_rest(joined())
    r, d = built.state.position, built.work.direction
    first, last = built.names.node_ptr[0], built.names.node_ptr[1] - 1
    for k, (end, beside) in enumerate(((first, first + 1), (last, last - 1))):
        q = (r[beside] - r[end]) / np.linalg.norm(r[beside] - r[end])
        angle = np.arccos(q @ d[0, k])
        assert moments[0][k] == pytest.approx(2.0 * 3e3 / 0.5 * np.sin(angle), rel=1e-9)
        assert moments[1][k] / moments[0][k] == pytest.approx(1.0 / np.cos(0.5 * angle), rel=1e-9)
