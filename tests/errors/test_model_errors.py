"""Models and motions built in Python are checked as files are."""

import dataclasses

import numpy as np
import pytest

from moorage.errors import ModelError, MotionError
from moorage.io import read
from moorage.model import Bathymetry, Current, Motion
from moorage.model.checks import check


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"bathymetry": Bathymetry((0.0, 1.0), (0.0,), ((1.0,),))}, "depth grid is not rectangular"),
        ({"bathymetry": Bathymetry((), (), ())}, "x of the depth grid does not increase"),
        ({"current": Current((0.0, 1.0), ((0.0, 0.0, 0.0),))}, "current has not one velocity for each level"),
        ({"current": Current((1.0, 0.0), ((0.0,) * 3,) * 2)}, "levels of the current do not increase"),
        ({"water_depth": float("nan")}, "water depth of environment is not finite"),
        ({"gravity": float("inf")}, "gravity of environment is not finite"),
    ],
)
def test_environment(deck, changes, message):
    model = read(deck())
    with pytest.raises(ModelError, match=message):
        check(dataclasses.replace(model, environment=dataclasses.replace(model.environment, **changes)))


def test_line_without_sections(deck):
    model = read(deck())
    with pytest.raises(ModelError, match="line 1 has no sections"):
        check(dataclasses.replace(model, lines=(dataclasses.replace(model.lines[0], sections=()),)))


def test_line_type(deck):
    model = read(deck())
    wrong = dataclasses.replace(model.line_types[0], minimum_bend_radius=-1.0, axial_damping_ratio=-0.1)
    with pytest.raises(ModelError, match=r"axial damping ratio .* must not be negative(.|\n)*minimum bend radius"):
        check(dataclasses.replace(model, line_types=(wrong,)))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (
            lambda: Motion.from_platform([0, 1], np.zeros((3, 6))),
            r"motion of the platform has shape \(3, 6\) for 2 times",
        ),
        (
            lambda: Motion.from_platform([0, 1], np.full((2, 6), np.nan)),
            "motion of the platform is not a number at 0 s",
        ),
        (
            lambda: Motion.from_points([0, 1], {4: [[0, 0, 0], [0, 0, np.inf]]}),
            "motion of point 4 is not a number at 1 s",
        ),
        (lambda: Motion.from_platform([0], np.zeros((1, 6))), "at least two finite times"),
        (lambda: Motion.from_platform([], np.zeros((0, 6))), "at least two finite times"),
        (lambda: Motion.from_platform([0, 1, 1], np.zeros((3, 6))), "time does not increase at sample 3"),
        (lambda: Motion.from_harmonics(10.0, jump=(1.0, 5.0)), "there is no mode 'jump'"),
        (lambda: Motion.from_harmonics(10.0), "harmonics need a mode with a positive period"),
        (lambda: Motion.from_harmonics(10.0, surge=(1.0, 0.0)), "harmonics need a mode with a positive period"),
    ],
)
def test_motion(make, message):
    with pytest.raises(MotionError, match=message):
        make()


def test_motions_from_functions_and_harmonics():
    made = Motion.from_function(lambda t: [np.sin(t), 0, 0, 0, 0, 0], 3.0, 0.5)
    assert np.allclose(made.platform[:, 0], np.sin(made.time))
    waves = Motion.from_harmonics(20.0, ramp=5.0, heave=(2.0, 10.0, 0.5))
    late = waves.time > 5.0
    assert np.allclose(waves.platform[late, 2], 2.0 * np.sin(0.2 * np.pi * waves.time[late] + 0.5))
    assert waves.platform[0, 2] == 0.0
