"""Failures that name the same ends: what has come off stays off, and lines that fell together stay together."""

import dataclasses

import numpy as np
import pytest
from moorings import fixed, free, kind, line, mooring

import moorage
import moorage.moordyn as moordyn
from moorage import ModelError, ModelWarning
from moorage.errors import Source
from moorage.io import write_native
from moorage.model import Attachment, Failure
from moorage.model.checks import check

ROPE = kind("rope", mass_per_length=10.0, axial_stiffness=1e6, axial_damping_ratio=0.5)
AT = Source("model.dat", 9)


def bridle(*failures: Failure, mass: float = 50.0):
    """A mass on three ropes, of which failures take some off."""
    points = (
        fixed(1, 0.0, 0.0, 0.0),
        fixed(2, 8.0, 0.0, 0.0),
        fixed(3, 4.0, 6.0, 0.0),
        free(4, 4.0, 2.0, -5.0, mass=mass),
    )
    lines = (line(k, k, 4, ("rope", 7.0, 4)) for k in (1, 2, 3))
    return dataclasses.replace(mooring(ROPE, points, lines, water_density=0.0), failures=failures)


def off(id: int, *lines: int, time: float = 0.0, tension: float = 0.0) -> Failure:
    return Failure(id=id, attachment=Attachment("point", 4), lines=lines, time=time, tension=tension, source=AT)


def ends(model, duration=2.0):
    """Where the ends at point 4 are at the end, (3, 3), m."""
    run = moorage.simulate(model, duration=duration, dt_out=0.5)
    return run["node_position"].values[-1].reshape(3, 5, 3)[:, -1]


@pytest.mark.parametrize("second", [off(2, 1, time=1.0), off(2, 1, tension=1e5), off(2, 1, 2, time=3.0)])
def test_a_second_failure_of_the_same_end_changes_nothing(second):
    first = off(1, 1, time=0.4)  # steps may differ, and with them the ends by the tolerance of 0.002 m
    np.testing.assert_allclose(ends(bridle(first, second)), ends(bridle(first)), atol=0.002)


def test_a_second_failure_takes_what_the_first_has_left():
    both = ends(bridle(off(1, 1, time=0.4), off(2, 1, 2, time=1.0)))
    alone = ends(bridle(off(1, 1, time=0.4), off(2, 2, time=1.0)))
    np.testing.assert_allclose(both, alone, atol=0.002)


def test_lines_that_fell_together_stay_together():
    """The failure that comes later is the first in the file."""
    a, b, _ = ends(bridle(off(1, 1, time=1.0), off(2, 1, 2, time=0.4)))
    np.testing.assert_array_equal(a, b)


def test_a_resumed_run_knows_in_which_order_they_came(tmp_path):
    model = bridle(off(1, 1, time=1.0), off(2, 1, 2, time=0.4))
    whole, path = moorage.simulate(model, duration=3.0, dt_out=0.01), tmp_path / "run.nc"

    def stop(time, duration, wall):
        if time > 1.1:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        moorage.simulate(model, duration=3.0, dt_out=0.01, output=path, progress=stop)
    resumed = moorage.simulate(model, duration=3.0, dt_out=0.01, output=path, resume=True)
    np.testing.assert_array_equal(resumed["node_position"].values, whole["node_position"].values)


@pytest.mark.parametrize(
    ("failures", "mass", "words"),
    [
        ((off(7, time=1.0),), 1.0, "model.dat:9: failure 7 names no lines"),
        ((off(7, 1, time=-1.0),), 1.0, "time of failure 7 must not be negative (read: -1.0)"),
        ((off(7, 1, tension=-2.0),), 1.0, "tension of failure 7 must not be negative (read: -2.0)"),
        ((off(7, 1, 2, 3, time=1.0),), 0.0, "failure 7: point 4 would be left with neither lines nor mass"),
        ((off(7, 1, time=1.0), off(8, 2, 3, tension=1e3)), 0.0, "failure 7 and 8: point 4 would be left"),
    ],
)
def test_failures_that_cannot_be_are_refused(failures, mass, words):
    with pytest.raises(ModelError) as caught:
        check(bridle(*failures, mass=mass))
    assert words in str(caught.value)


def test_a_failure_that_never_comes_is_told():
    with pytest.warns(ModelWarning, match=r"model.dat:9: failure 7 never comes\n.*give it a time or a tension"):
        moorage.solve_statics(bridle(off(7, 1)))


def test_the_module_of_moordyn_takes_no_end_off_twice(tmp_path):
    path = tmp_path / "bridle.yaml"
    model = bridle(off(1, 1, time=0.25), off(2, 1, 2, time=0.45), off(3, 1, tension=1.0))
    write_native(model, path)
    system = moordyn.Create(str(path))
    assert moordyn.Init(system, [], []) == 0
    for step in range(8):
        moordyn.Step(system, [], [], 0.1 * step, 0.1)
    assert moordyn.GetNumberPoints(system) == 6
    held = moordyn.GetPoint(system, 4)
    assert moordyn.GetPointNAttached(held) == 1
