"""Waves along the paths of nodes: errors fall with the fourth power of the interval, and stay below their bound.

Verifies: sea_table

A cubic through values and slopes at both ends of an interval D misses cos(w' t) by (w' D)^4 / 384 at most, w' being the
frequency that the node meets: w + k V, with V the speeds of node and surface. Off the path the gradients leave
(k delta)^2 / 2. So the velocity of the water must be missed by at most

    sum A w (w' D)^4 / 384 + sum A w (k delta)^2 / 2

at the surface, less below. A chain in a sea is compared with sums made at each evaluation.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from common import must_fail, rate
from moorings import spread

from moorage.layout import line_nodes, new_table
from moorage.model import Waves
from moorage.solve.statics import rest
from moorage.system.build import build
from moorage.system.water import next_interval, set_water, start_table

SEA = Waves.irregular("jonswap", 8.25, 14.5, depth=200.0, direction=0.3, spreading=10.0, components=100, seed=2)
SHORT = Waves.irregular("jonswap", 2.0, 6.0, depth=200.0, direction=-2.0, components=100, seed=5)
SPEED, PERIOD = 1.5, 12.0  # of the nodes, m/s and s


def water(system, state, work, t: float) -> None:
    set_water(system.lines, system.islands, system.sea, system.current, work.table, state, 0, t)


def begin_table(system, state, work, t: float) -> None:
    start_table(system.lines, system.islands, system.sea, work.table, state.position, state.velocity, 0, t)


def go_on(system, state, work, t: float) -> None:
    next_interval(system.lines, system.islands, system.sea, work.table, state.position, state.velocity, 0, t)


def place(built, t: float) -> None:
    """Nodes up to 6 m above and 40 m below the water, going round."""
    rows = np.arange(len(built.state.position))
    z = np.linspace(6.0, -40.0, len(rows))
    angle = 2.0 * np.pi * t / PERIOD + rows
    radius = SPEED * PERIOD / (2.0 * np.pi)
    built.state.position[:] = np.stack([3.0 * rows + radius * np.cos(angle), radius * np.sin(angle), z], axis=1)
    built.state.velocity[:] = SPEED * np.stack([-np.sin(angle), np.cos(angle), 0.0 * z], axis=1)


def errors(waves: Waves, part: float) -> np.ndarray:
    """Errors of elevation, velocity and acceleration (7,), largest over wet nodes and 60 s."""
    model = spread(20)
    built = build(dataclasses.replace(model, environment=dataclasses.replace(model.environment, waves=waves)))
    rest(built)
    interval = waves.peak_period * part
    sea = built.system.sea._replace(interval=interval)
    system, exact = built.system._replace(sea=sea), built.system._replace(sea=sea._replace(interval=0.0))
    work = built.work._replace(table=new_table(system, len(built.state.position)))
    first, last = line_nodes(system.lines, 0)
    worst, t = np.zeros(7), 20.0
    place(built, t)
    begin_table(system, built.state, work, t)
    while t < 80.0:
        for s in (0.21, 0.5, 0.83):
            place(built, t + s * interval)
            water(system, built.state, work, t + s * interval)
            found = built.state.water[first : last + 1].copy()
            water(exact, built.state, built.work, t + s * interval)
            true = built.state.water[first : last + 1]
            wet = built.state.position[first : last + 1, 2] < true[:, 0]
            worst = np.maximum(worst, np.abs(found - true)[wet].max(axis=0))
        end = (work.table.number[0] + 1) * interval
        t = end
        place(built, t)
        go_on(system, built.state, work, t)
    return worst


def bound(waves: Waves, part: float) -> float:
    """Of the error in the velocity, m/s."""
    a, w, k = np.array(waves.amplitude), np.array(waves.frequency), waves.wavenumber
    interval = waves.peak_period * part
    rising = 2.0 * np.sqrt(0.5 * np.sum((a * w) ** 2))
    meets = w + k * (SPEED + rising)
    off = 0.5 * SPEED * 2.0 * np.pi / PERIOD * (1.5 * interval) ** 2  # the path is a guess, made an interval ahead
    return float(np.sum(a * w * ((meets * interval) ** 4 / 384.0 + 0.5 * (k * off) ** 2)))


def check_bound(waves: Waves, part: float, stated: float) -> None:
    assert errors(waves, part)[1:4].max() < bound(waves, stated)


@pytest.mark.parametrize("waves", [SEA, SHORT], ids=["14.5 s", "6 s"])
@pytest.mark.parametrize("part", [1 / 20, 1 / 40])
def test_error_is_below_its_bound(waves, part):
    check_bound(waves, part, part)


@pytest.mark.parametrize("stretching", ["vertical", "linear", "none"])
def test_other_stretching_keeps_the_bound(stretching):
    check_bound(dataclasses.replace(SEA, stretching=stretching), 1 / 20, 1 / 20)


def test_bound_of_a_tenth_of_the_interval_fails():
    must_fail(check_bound, SEA, 1 / 20, 1 / 200)


@pytest.mark.parametrize("waves", [SEA, SHORT], ids=["14.5 s", "6 s"])
def test_error_falls_with_the_fourth_power(waves):
    parts = np.array([1 / 20, 1 / 40, 1 / 80])
    found = np.array([errors(waves, part) for part in parts])
    for quantity in (slice(1, 4), slice(4, 7)):
        assert rate(parts, found[:, quantity].max(axis=1)) > 3.5, f"{found}"


def test_nothing_jumps_between_intervals():
    """At the end of an interval its cubic and the next one give the same."""
    model = spread(20)
    built = build(dataclasses.replace(model, environment=dataclasses.replace(model.environment, waves=SEA)))
    rest(built)
    place(built, 30.0)
    begin_table(built.system, built.state, built.work, 30.0)
    end = (built.work.table.number[0] + 1) * built.system.sea.interval
    place(built, end)
    water(built.system, built.state, built.work, end)
    before = built.state.water.copy()
    go_on(built.system, built.state, built.work, end)
    water(built.system, built.state, built.work, end)
    assert np.abs(built.state.water - before).max() < 1e-12
