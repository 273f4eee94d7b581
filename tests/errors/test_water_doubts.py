"""Waves and currents that can be read and are hardly meant, and values that cannot be: found by a stranger's trials."""

import dataclasses

import numpy as np
import pytest
from moorings import CHAIN, coupled, fixed, single

import moorage
from moorage.errors import SimulationError
from moorage.model import Current, CurrentGrid, Waves
from moorage.model.checks import check, suspicious

DEPTH = 60.0


def sea(**change) -> Waves:
    given = {"frequency": (0.5,), "amplitude": (1.0,), "phase": (0.0,), "direction": (0.0,), "depth": DEPTH}
    return Waves(**given | change)


def model(**water):
    ends = fixed(1, 0.0, 0.0, -DEPTH), coupled(2, 30.0, 0.0, -10.0)
    return single(CHAIN, 70.0, 5, *ends, water_depth=DEPTH, **water)


WRONG = {
    "no component": ({"waves": sea(frequency=(), amplitude=(), phase=(), direction=())}, "there is no wave component"),
    "not a number": ({"waves": sea(amplitude=(float("nan"),))}, "a value of the waves is not finite"),
    "no gravity": ({"waves": sea(gravity=0.0)}, "waves need gravity"),
    "negative ramp": ({"waves": sea(ramp=-1.0)}, "ramp of the waves must not be negative"),
    "two components": (
        {"current": Current((-60.0, 0.0), ((0.0, 0.0, 0.0), (0.5, 0.1)))},
        "velocity of current of environment is not a list, each 3 of them, each a number",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_refused(name):
    water, message = WRONG[name]
    with pytest.raises(moorage.ModelError, match=message):
        check(model(**water))


GRID = {"x": (-99.0, 99.0), "velocity": np.full((1, 2, 1, 2, 3), 0.2)}
WATER = {"height": 4.0, "period": 7.0, "depth": DEPTH}
WIDE = {"depth": DEPTH, "shape": (0.5, 1.0)}
DOUBTED = {
    "unstretched": (
        {"waves": Waves.irregular("jonswap", stretching="none", **WATER)},
        "velocities at crests of 3.99 m are 6.5",
    ),
    "one component": ({"waves": Waves.irregular("jonswap", 4.0, 9.0, depth=DEPTH, components=1)}, "only component"),
    "five components": (
        {"waves": Waves.irregular("jonswap", 4.0, 9.0, depth=DEPTH, components=5, gamma=7.0)},
        "one of the 5 components of the sea has 0.7 of its energy (m0), at ",
    ),
    "a wide spectrum": ({"waves": Waves.irregular("ochi-hubble", 4.0, 9.0, **WIDE)}, "0.08 of the energy of the spec"),
    "a wave that breaks": ({"waves": sea(amplitude=(100.0,))}, "a wave of 200 m would break"),
    "degrees": ({"waves": sea(direction=(180.0,))}, "has the direction 180 rad"),
    "depths": ({"current": Current((0.0, 60.0), ((0.0, 0.0, 0.0), (0.5, 0.1, 0.0)))}, "a level 60 m above the water"),
    "late": ({"current": CurrentGrid(t=(3.0,), z=(-60.0, 0.0), **GRID)}, "begins at 3 s"),
    "shallow": ({"current": CurrentGrid(t=(0.0,), z=(-20.0, 0.0), **GRID)}, "ends 40 m above the lowest point"),
}


@pytest.mark.parametrize("name", DOUBTED)
def test_doubted(name):
    water, message = DOUBTED[name]
    assert any(message in str(problem) for problem in suspicious(model(**water)))


def test_what_is_right_is_not_doubted():
    current = CurrentGrid(t=(0.0,), z=(-60.0, 0.0), **GRID)
    right = model(waves=sea(direction=(np.pi,)), current=current)
    check(right)
    assert not [p for p in suspicious(right) if "wave" in str(p) or "current" in str(p)]
    assert dataclasses.replace(right).environment.waves == right.environment.waves


def test_velocities_by_columns_are_refused():
    def columns(t, xyz):
        n = len(xyz)
        return np.zeros(n), np.zeros((3, n)), np.zeros((n, 3))

    with pytest.raises(SimulationError, match="velocity of the water: expected"):
        moorage.simulate(model(host_waves=True), duration=0.1, water=columns)
