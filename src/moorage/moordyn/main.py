"""The functions of MoorDyn2.h: life of a system, its objects, its step, its messages."""

from __future__ import annotations

import inspect
from itertools import pairwise
from pathlib import Path

import numpy as np

from moorage.errors import ConvergenceError, MoorageError, SimulationError
from moorage.moordyn import codes
from moorage.moordyn.changes import option
from moorage.moordyn.handles import Body, Line, Point, Rod, dof_vector, live, of, pick, raising, to_tuple
from moorage.moordyn.log import HEADS
from moorage.moordyn.points import GetPointNAttached
from moorage.moordyn.states import load_initial
from moorage.moordyn.system import System
from moorage.solve.coupling import coupled_objects

SCHEMES = (
    "implicit", "euler", "leuler", "heun", "rk2", "rk4", "ab2", "ab3", "ab4", "lab2", "lab3", "lab4",
    *(f"{name}{n}" for name in ("beuler", "midpoint", "aca", "wilson") for n in range(2, 21)),
)  # fmt: skip


@raising
def Create(filepath: str = "") -> System:
    """Return the system that a file describes, by default "Mooring/lines.txt"; RuntimeError when it cannot be read."""
    return System(filepath or Path("Mooring") / "lines.txt")


def NCoupledDOF(instance: System) -> int:
    """Return the number of coupled degrees of freedom."""
    return sum(width for _, _, width in coupled_objects(live(instance).model))


def SetVerbosity(instance: System, verbosity: int) -> int:
    """Set the level from which on messages go to the screen (standard error)."""
    live(instance).log.screen = int(verbosity)
    return codes.ERRCODE_SUCCESS


def SetLogFile(instance: System, filepath: str) -> int:
    """Begin a log file."""
    try:
        live(instance).log.open(filepath)
    except OSError as error:
        instance.say_error(error)
        return codes.ERRCODE_INVALID_OUTPUT_FILE
    return codes.ERRCODE_SUCCESS


def SetLogLevel(instance: System, verbosity: int) -> int:
    """Set the level from which on messages go to the log file."""
    live(instance).log.level = int(verbosity)
    return codes.ERRCODE_SUCCESS


def Log(instance: System, level: int, msg: str) -> int:
    """Log a message, with the place of the call in front of it."""
    caller = inspect.stack()[1]
    head = HEADS[min(max(int(level), codes.LEVEL_DBG), codes.LEVEL_ERR)]
    live(instance).log.write(level, f"{head} {caller.filename}:{caller.lineno} {caller.function}() : {msg}")
    return codes.ERRCODE_SUCCESS


def Init(instance: System, x, v) -> int:
    """Start at time 0 with the coupled objects at x (m, rad), moving at v; return 0, or an error code.

    The mooring is in static equilibrium, unless its file starts it as described (TmaxIC 0).
    """
    return _init(instance, x, v, instance.model.start == "static")


def Init_NoIC(instance: System, x, v) -> int:
    """Start as `Init` does, with the lines at rest on their first catenary."""
    return _init(instance, x, v, False)


def _init(instance: System, x, v, static: bool) -> int:
    size = NCoupledDOF(instance)
    pose, rate = dof_vector("1st", x, size), dof_vector("2nd", v, size)
    if not (np.isfinite(pose).all() and np.isfinite(rate).all()):
        instance.say_error(ValueError("Init: NaN or inf among the positions or velocities"))
        return codes.ERRCODE_NAN_ERROR
    before = option(instance.model, "fileIC", "")
    try:
        instance.initialize(pose, rate, static and not before)
        if before:
            load_initial(instance, instance.path.parent / before, static)
    except (ConvergenceError, SimulationError) as error:
        instance.say_error(error)
        return codes.ERRCODE_UNHANDLED_ERROR
    except (MoorageError, OSError) as error:
        instance.say_error(error)
        instance.stop()
        return codes.ERRCODE_INVALID_INPUT
    return codes.ERRCODE_SUCCESS


@raising
def Step(instance: System, x, v, t: float, dt: float) -> tuple[float, ...]:
    """Go on by dt (s) and return the forces on the coupled degrees of freedom, N and N m.

    Parameters
    ----------
    x, v : sequence of float
        Positions (m, rad) at the *start* of the step and velocities, which hold throughout it.
    t : float
        Time of the start, s. The clock is the mooring's own; a time more than a step before it is an error.
    dt : float
        s; with 0 only the forces are returned.

    Raises
    ------
    ValueError
        A wrong count of components.
    RuntimeError
        NaN, a time or step that goes back, or a step that cannot be solved; the state is left as it was.
    """
    size = NCoupledDOF(instance)
    pose, rate = dof_vector("1st", x, size), dof_vector("2nd", v, size)
    if not (np.isfinite(pose).all() and np.isfinite(rate).all()):
        raise RuntimeError("Step: NaN or inf among the positions or velocities")
    if not instance.started:
        raise RuntimeError("Step before Init: call Init first")
    if not (np.isfinite(dt) and dt >= 0.0 and np.isfinite(t)):
        raise RuntimeError(f"Step: from {t} s by {dt} s: time must go on")
    if dt == 0.0:
        return to_tuple(instance.coupled_forces())
    late = f"Step: from {t:g} s, but the run is at {instance.time:g} s"
    if t + 1.5 * dt < instance.time:
        raise RuntimeError(f"{late}: restore a saved state first")
    if t + 0.5 * dt < instance.time:  # one of MoorDyn's own tests does not count its last step
        instance.log.say(codes.LEVEL_WRN, f"{late}; its own clock counts")
    return to_tuple(instance.step(pose, rate, float(dt)))


def Close(instance: System) -> int:
    """Forget the system; it cannot be used any more."""
    live(instance).close()
    return codes.ERRCODE_SUCCESS


def GetNumberBodies(instance: System) -> int:
    """Return the number of bodies."""
    return len(live(instance).model.bodies)


def GetBody(instance: System, body: int) -> Body:
    """Return a body; the first is 1."""
    return pick(Body, instance, body, live(instance).model.bodies)


def GetNumberRods(instance: System) -> int:
    """Return the number of rods."""
    return len(live(instance).model.rods)


def GetRod(instance: System, rod: int) -> Rod:
    """Return a rod; the first is 1."""
    return pick(Rod, instance, rod, live(instance).model.rods)


def GetNumberPoints(instance: System) -> int:
    """Return the number of points, those that broken lines hold included."""
    return len(live(instance).model.points)


def GetPoint(instance: System, point: int) -> Point:
    """Return a point; the first is 1."""
    return pick(Point, instance, point, live(instance).model.points)


def GetNumberLines(instance: System) -> int:
    """Return the number of lines."""
    return len(live(instance).model.lines)


def GetLine(instance: System, line: int) -> Line:
    """Return a line; the first is 1."""
    return pick(Line, instance, line, live(instance).model.lines)


def GetFASTtens(instance: System, n_lines: int) -> tuple[list[float], list[float], list[float], list[float]]:
    """Return horizontal and vertical force on fairleads, then on anchors, of the first `n_lines` lines, N."""
    if n_lines > GetNumberLines(instance):
        raise RuntimeError(f"there are {GetNumberLines(instance)} lines, not {n_lines}")
    load = instance.block["end_load"][:n_lines]
    across, up = np.hypot(load[..., 0], load[..., 1]), load[..., 2]
    return tuple(values.tolist() for values in (across[:, 1], up[:, 1], across[:, 0], up[:, 0]))  # type: ignore[return-value]


@raising
def BreakLine(instance: System, point: Point, line: Line) -> None:
    """Take a line off a point; its end holds on to a new free point that is like the old one."""
    system = live(instance)
    old, thing = of(Point, point).model.points[point.place], of(Line, line).model.lines[line.place]
    id = old.id
    end = next((e for e in (thing.end_a, thing.end_b) if e.kind == "point" and e.id == id), None)
    if end is None:
        raise RuntimeError(f"line {thing.id} does not hold on to point {id}")
    if not system.started:
        raise RuntimeError("BreakLine before Init: call Init first")
    if old.kind == "free" and not old.mass > 0.0 and GetPointNAttached(point) == 1:
        raise RuntimeError(f"BreakLine: point {id} would be left with neither lines nor mass")
    system.break_off(end, (line.place,))


def GetDt(instance: System) -> float:
    """Return the longest internal step allowed, s (steps adapt to the motion)."""
    system = live(instance)
    return float(system.host.march.control.step_max if system.started else system.step_max or 0.15)


@raising
def SetDt(instance: System, dt: float) -> None:
    """Allow no internal step longer than dt, s."""
    if not 0.0 < dt < np.inf:
        raise RuntimeError(f"SetDt: {dt} is no time step")
    live(instance).limit_step(float(dt))


def wave_rate(system: System) -> float:
    """Return the largest rate, 1/s, at which an elastic wave crosses a segment of a line; 0 without lines."""
    built = system.built
    m, nodes = built.system.morison.mass, pairwise(built.names.node_ptr.tolist())
    first = np.array([i for a, b in nodes for i in range(a, b - 1)], dtype=np.int64)
    mass = np.minimum(m[first], m[first + 1])
    spring = built.system.tension.spring[: len(first)]  # the segments of rods follow
    return float(np.sqrt(spring / np.maximum(mass, 1e-300)).max(initial=0.0))


def GetCFL(instance: System) -> float:
    """Return the longest step in units of the shortest passage of an elastic wave through a segment."""
    return GetDt(instance) * wave_rate(live(instance))


@raising
def SetCFL(instance: System, cfl: float) -> None:
    """Limit the internal step by such a number."""
    rate = wave_rate(live(instance))
    if not rate:
        raise RuntimeError("SetCFL: there are no lines that waves could cross; use SetDt")
    SetDt(instance, cfl / rate)


def GetTimeScheme(instance: System) -> str:
    """Return the name of the scheme that was asked for; steps are implicit whatever it is."""
    return live(instance).scheme


def SetTimeScheme(instance: System, name: str) -> None:
    """Note the name of one of MoorDyn's schemes; RuntimeError when it has none of that name."""
    if name.lower() not in SCHEMES:
        raise RuntimeError(f"there is no time scheme {name!r}")
    live(instance).scheme = name
