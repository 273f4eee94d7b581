"""Explicit Runge-Kutta steps of order 2 (midpoint) and 4, to check the implicit one. They need a small time step."""

from __future__ import annotations

from moorage._jit import inlined, part
from moorage._vec3 import accumulate, add, dot, get, mat_get, mat_put, put, scale
from moorage.layout import BASE, line_nodes, point_row
from moorage.physics.rigid import turning_rate
from moorage.solve.implicit import set_accelerations, stick_island
from moorage.system.ride import begin_turning

ZERO3 = (0.0, 0.0, 0.0)
FASTEST = 1e5  # m/s; a run that gets there has blown up


@part
def explicit_step(system, now, trial, work, island, t, h, order):
    """Advance an island from t to t + h; returns (finite, row of the largest speed).

    The slopes are added up in `trial`; the states of the stages live in `work.trial`.
    """
    stage = work.trial
    lines, islands = system.lines, system.islands
    l0, l1 = islands.line_ptr[island], islands.line_ptr[island + 1]
    p0, p1 = islands.point_ptr[island], islands.point_ptr[island + 1]
    stages = 2 if order == 2 else 4
    for m in range(l0, l1):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            begin_row(now, trial, stage, i)
    for p in range(p0, p1):
        begin_row(now, trial, stage, point_row(lines, islands.points[p]))
    begin_objects(islands, now, trial, stage, island)
    for s in range(stages):
        node, weight = tableau(order, s)
        ahead = tableau(order, s + 1)[0] if s + 1 < stages else 0.0
        set_accelerations(system, stage, work, island, t + node * h)
        for m in range(l0, l1):
            first, last = line_nodes(lines, islands.lines[m])
            for i in range(first, last + 1):
                stage_row(now, trial, stage, i, h * weight, h * ahead)
        for p in range(p0, p1):
            stage_row(now, trial, stage, point_row(lines, islands.points[p]), h * weight, h * ahead)
        stage_objects(islands, now, trial, stage, island, h * weight, h * ahead)
    set_accelerations(system, trial, work, island, t + h)
    stick_island(system, now, trial, work.load, island, h)
    fastest, where = 0.0, -1
    for m in range(l0, l1):
        first, last = line_nodes(lines, islands.lines[m])
        for i in range(first, last + 1):
            speed = dot(get(trial.velocity, i), get(trial.velocity, i))
            if not speed < FASTEST * FASTEST:
                return False, i
            if speed > fastest:
                fastest, where = speed, i
    return True, where


@inlined
def tableau(order, stage):
    """Node and weight of a stage; each stage starts from the slopes of the one before it only."""
    if order == 2:
        return (0.0, 0.0) if stage == 0 else (0.5, 1.0)
    if stage == 0:
        return 0.0, 1.0 / 6.0
    if stage == 3:
        return 1.0, 1.0 / 6.0
    return 0.5, 1.0 / 3.0


@inlined
def begin_row(now, trial, stage, i):
    put(trial.position, i, get(now.position, i))
    put(trial.velocity, i, get(now.velocity, i))
    put(trial.auxiliary, i, ZERO3)
    put(stage.position, i, get(now.position, i))
    put(stage.velocity, i, get(now.velocity, i))
    put(stage.stuck, i, get(now.stuck, i))
    put(trial.stuck, i, get(now.stuck, i))
    for x in range(now.soil.shape[1]):
        stage.soil[i, x] = trial.soil[i, x] = now.soil[i, x]


@inlined
def stage_row(now, trial, stage, i, weight, ahead):
    """Add a stage's slopes to the end state, and set the state of the next stage."""
    v, a = get(stage.velocity, i), get(stage.acceleration, i)
    accumulate(trial.position, i, scale(weight, v))
    accumulate(trial.velocity, i, scale(weight, a))
    put(stage.position, i, add(get(now.position, i), scale(ahead, v)))
    put(stage.velocity, i, add(get(now.velocity, i), scale(ahead, a)))


@part
def begin_objects(islands, now, trial, stage, island):
    """Begin a step of the objects of an island; rotations count from now on."""
    begin_turning(islands, now, island)
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        o, row = islands.objects[k, 0], islands.objects[k, 1]
        mat_put(trial.frames[BASE], o, mat_get(now.frames[BASE], o))
        mat_put(stage.frames[BASE], o, mat_get(now.frames[BASE], o))
        begin_row(now, trial, stage, row)
        begin_row(now, trial, stage, row + 1)


@part
def stage_objects(islands, now, trial, stage, island, weight, ahead):
    """Do `stage_row` for objects; a rotation vector grows at `turning_rate`."""
    for k in range(islands.object_ptr[island], islands.object_ptr[island + 1]):
        row = islands.objects[k, 1]
        stage_row(now, trial, stage, row, weight, ahead)
        i = row + 1
        rate, alpha = turning_rate(get(stage.position, i), get(stage.velocity, i)), get(stage.acceleration, i)
        accumulate(trial.position, i, scale(weight, rate))
        accumulate(trial.velocity, i, scale(weight, alpha))
        put(stage.position, i, scale(ahead, rate))
        put(stage.velocity, i, add(get(now.velocity, i), scale(ahead, alpha)))
