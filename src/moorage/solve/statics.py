"""Static equilibrium of a whole system, with a verdict in newtons."""

from __future__ import annotations

import warnings
from typing import NamedTuple

import numpy as np

from moorage.errors import ConvergenceError, ModelWarning
from moorage.layout import WITHOUT_ROWS, State, System, copy_of
from moorage.physics.friction import ELASTIC, NONE, SOIL
from moorage.physics.sea import no_sea
from moorage.solve.implicit import stick_island
from moorage.solve.places import place_name
from moorage.solve.statics_flow import flow_island, imbalance
from moorage.solve.statics_kernel import descend_island, place_at_rest, relax_island, stick_where_it_is
from moorage.system.build import Built

OFF_PLANE = 1e-3  # how far nodes are moved, as a share of their segments
QUICK, FLOW, ITERATIONS = 300, 6000, 2000  # of continuation, then of implicit steps, and of descent


class Equilibrium(NamedTuple):
    """Verdict of a static solution."""

    residual: float  # largest out-of-balance force on a node or free point, N; above the tolerance where a slack line
    # pushes, of which a warning tells
    where: str  # and where that is
    iterations: int  # Newton iterations of all islands
    damped: int  # those of them that needed pseudo-transient continuation
    tolerance: float  # N


def natural_tolerance(built: Built) -> float:
    """Return the imbalance (N) that counts as none: 1e-7 of the largest node weight or submerged weight, at least 1 mN.

    What rounding gives is added.
    """
    weight = built.system.weight
    weights = np.abs(weight.dry).max(initial=0.0) + np.abs(weight.buoyancy).max(initial=0.0)
    return float(max(1e-3, 1e-7 * weights)) + rounding(built)


def rounding(built: Built) -> float:
    """Return the force (N) that the last digit of a coordinate stands for: less imbalance cannot be reached."""
    size = np.abs(built.state.position).max(initial=1.0)
    system, shortest = built.system, built.names.segment_length.min(initial=np.inf)
    bends = system.bending.before.max(initial=0.0) / shortest**2
    return float(16.0 * np.finfo(float).eps * size * (system.tension.spring.max(initial=0.0) + bends))


def solve(built: Built, tolerance: float | None = None) -> Equilibrium:
    """Put a built system into static equilibrium, in place.

    Parameters
    ----------
    built : Built
        Its state holds the first guess, and then the equilibrium (velocities zero).
    tolerance : float, optional
        Largest imbalance to reach, N; see `natural_tolerance`. Where it is less than `rounding`, that is accepted.

    Raises
    ------
    ConvergenceError
        No equilibrium within the iterations; the state is left as it was.
    """
    asked = natural_tolerance(built) if tolerance is None else tolerance
    accepted = max(asked, rounding(built))
    begin = copy_of(built.state)
    hung = begin._replace(position=built.hung)
    system, laid = static_system(built.system), built.system.friction.laid
    islands = system.islands
    worst, where, used, damped, pressed = 0.0, -1, 0, 0, []
    for island in range(len(islands.line_ptr) - 1):
        reach, force, row = _reach(built, island), 1e300, -1
        for start, method, goal, iterations in _ways(built, island, begin, hung, asked, accepted):
            if force < accepted:
                break
            _put_back(built, island, start)
            force, row, n, d = method(system, built.state, built.work, island, reach, goal, iterations)
            used, damped = used + n, damped + d
        if not force < accepted and system.lines.bends[_lines(built, island)].any():
            _put_back(built, island, _off_plane(built, hung))
            force, row, n, pushes = _through_pushing(built, system, island, reach, accepted)
            used, damped = used + n, damped + n
            pressed += [island] if pushes else []
        if not force < accepted and system.current.velocity.any():
            _put_back(built, island, begin)
            force, row, n = _from_still_water(built, system, island, reach, accepted)
            used, damped = used + n, damped + n
        if not force <= worst:
            worst, where = force, row
    if not worst < max(accepted, 1e-300):
        place = place_name(built, where)
        for target, source in zip(built.state, begin, strict=True):
            target[...] = source
        raise ConvergenceError(
            f"statics did not converge: the largest out-of-balance force is {worst:.3g} N at {place} after {used} "
            f"iterations (accepted: {accepted:.3g} N).\n    -> Check that the line there can hang in the given place "
            "(length against distance, weight against buoyancy), or start as given (--start as-given) and let the "
            "run settle",
            worst,
        )
    for island in pressed:
        force, row, _ = imbalance(system, built.state, built.work, island)
        if force > worst:
            worst, where = force, row
    if pressed:
        _warn_of_pushing(built)
    for island in range(len(islands.line_ptr) - 1):
        if laid:
            stick_island(system, built.state, built.state, built.work.load, island, 0.0)
        else:
            stick_where_it_is(system.lines, system.islands, built.state, island)
    built.state.heat[:] = 0.0
    return Equilibrium(worst, place_name(built, where), used, damped, accepted)


def _ways(built: Built, island: int, begin: State, hung: State, asked: float, accepted: float) -> list[tuple]:
    """Return the ways to equilibrium to try in turn: start, method, tolerance (N) and iterations."""
    islands, bends = built.system.islands, built.system.lines.bends[_lines(built, island)].any()
    ways = [(begin, relax_island, asked, QUICK)]
    if islands.joint_ptr[island + 1] > islands.joint_ptr[island]:
        ways.append((hung, relax_island, asked, QUICK))
    descent = hung, descend_island, accepted, ITERATIONS
    steps = _off_plane(built, hung), flow_island, accepted, FLOW
    if islands.object_ptr[island + 1] > islands.object_ptr[island]:
        return [*ways, steps, descent]
    return [*ways, descent, steps] if bends else [*ways, descent]


def _off_plane(built: Built, start: State) -> State:
    """Return a start with the nodes of stiff lines a little off where they are.

    In the plane of its ends a line may stand on the edge of a loop, which nothing but chance can tip over.
    """
    system = built.system
    bends, segments = system.lines.bends, np.diff(system.lines.node_ptr) - 1
    length = np.repeat(bends, segments) * system.tension.length
    nodes = np.delete(np.arange(system.lines.node_ptr[-1]), system.lines.node_ptr[1:] - 1)  # the first of each segment
    position = start.position.copy()
    position[nodes] += OFF_PLANE * length[:, None] * np.random.default_rng(0).uniform(-1.0, 1.0, (len(nodes), 3))
    return start._replace(position=position)


def _through_pushing(built: Built, system: System, island: int, reach: float, accepted: float):
    """Find equilibrium from one in which stiff lines push.

    A line that is slack and stiff pushes somewhere. Segments that go slack instead shrink to nothing there, so that
    there may be no other equilibrium than the one in which they push; the state is left in it then.

    Returns the largest imbalance (N), its row, the iterations, and whether lines push.
    """
    force, row, used, _ = flow_island(pushing(system), built.state, built.work, island, reach, accepted, FLOW)
    if not force < accepted:
        return force, row, used, False
    pushed = copy_of(built.state)
    slack, where, n, _ = flow_island(system, built.state, built.work, island, reach, accepted, FLOW)
    if slack < accepted:
        return slack, where, used + n, False
    _put_back(built, island, pushed)
    place_at_rest(system, built.state, built.work, island)  # turns the clamps back too
    return force, row, used + n, True


def pushing(system: System) -> System:
    """Return a system whose lines push as well as they pull, if they bend."""
    lines = system.lines
    bends = np.repeat(lines.bends, np.diff(lines.node_ptr) - 1)
    return system._replace(tension=system.tension._replace(slack=np.where(bends, -1e300, system.tension.slack)))


def _warn_of_pushing(built: Built) -> None:
    """Warn of the line that pushes most in a state in which segments that go slack are pressed together."""
    system, ptr = built.system, built.names.segment_ptr
    e = np.diff(built.state.position[: built.names.node_ptr[-1]], axis=0)
    e = np.delete(e, built.names.node_ptr[1:-1] - 1, axis=0)
    spring, length = system.tension.spring[: ptr[-1]], system.tension.length[: ptr[-1]]
    push = np.where(system.tension.slack[: ptr[-1]] == 0.0, spring * (length - np.linalg.norm(e, axis=1)), 0.0)
    push[~np.repeat(system.lines.bends[: len(ptr) - 1], np.diff(ptr))] = 0.0
    line = int(np.searchsorted(ptr, int(np.argmax(push)), side="right")) - 1
    warnings.warn(
        f"line {built.names.lines[line]} is slack and stiff: in the static state found it pushes with {push.max():.3g} "
        "N, which its segments do not do in a run. They go slack and may shrink: let its line type have "
        "carries_compression: true",
        ModelWarning,
        stacklevel=3,
    )


def take_every_way(built: Built) -> None:
    """Call every method of statics without an iteration, so that all of them are compiled."""
    from moorage.solve.whole_jacobian import assemble_all  # noqa: PLC0415  SciPy's sparse matrices take 0.1 s

    system, state, work = static_system(built.system), built.state, built.work
    for method in (relax_island, descend_island, flow_island):
        method(system, state, work, 0, 1.0, 1.0, 0)
    imbalance(system, state, work, 0)
    assemble_all(system, state, work, 0, np.zeros((len(state.position), 9)))
    stick_island(system, state, state, work.load, 0, 0.0)
    stick_where_it_is(system.lines, system.islands, state, 0)


def static_system(system: System) -> System:
    """Return a system without waves, whose friction is that of statics: none, or what holds it where it was laid."""
    friction = system.friction
    law = NONE if not friction.laid else SOIL if friction.law == SOIL else ELASTIC
    return system._replace(friction=friction._replace(law=law), sea=no_sea())


def rest(built: Built) -> None:
    """Attach all line ends at time 0 with everything at rest, without looking for equilibrium."""
    for island in range(len(built.system.islands.line_ptr) - 1):
        place_at_rest(built.system, built.state, built.work, island)
        stick_where_it_is(built.system.lines, built.system.islands, built.state, island)


def _from_still_water(
    built: Built, system: System, island: int, reach: float, accepted: float
) -> tuple[float, int, int]:
    """Find equilibrium by descent in still water, and raise the current from there.

    Returns the largest imbalance (N), its row and the iterations.
    """
    from moorage.solve.whole_jacobian import raise_current  # noqa: PLC0415  SciPy's sparse matrices take 0.1 s

    still = system._replace(current=system.current._replace(velocity=np.zeros_like(system.current.velocity)))
    force, row, used, _ = descend_island(still, built.state, built.work, island, reach, accepted, ITERATIONS)
    if not force < accepted:
        return force, row, used
    force, row, n = raise_current(built, system, island, reach, accepted)
    return force, row, used + n


def _put_back(built: Built, island: int, begin: State) -> None:
    """Copy the rows of an island from the state at the start."""
    islands, ptr = built.system.islands, built.system.lines.node_ptr
    lines = islands.lines[islands.line_ptr[island] : islands.line_ptr[island + 1]]
    points = islands.points[islands.point_ptr[island] : islands.point_ptr[island + 1]]
    objects = slice(*islands.object_ptr[island : island + 2])
    own = islands.objects[objects, 1]
    rows = np.concatenate([*(np.arange(ptr[k], ptr[k + 1]) for k in lines), ptr[-1] + points, own, own + 1])
    for name, target, source in zip(State._fields, built.state, begin, strict=True):
        if name == "frames":
            target[:, islands.objects[objects, 0]] = source[:, islands.objects[objects, 0]]
        elif name not in WITHOUT_ROWS:
            target[rows] = source[rows]


def _lines(built: Built, island: int) -> np.ndarray:
    """Return the lines of an island, and its rods as rigid lines."""
    islands = built.system.islands
    return islands.lines[islands.line_ptr[island] : islands.line_ptr[island + 1]]


def _reach(built: Built, island: int) -> float:
    """Longest increment of a position, m: where bending is stiff, a fifth of the shortest segment."""
    system, lines = built.system, _lines(built, island)
    ptr = system.lines.node_ptr - np.arange(len(system.lines.node_ptr))
    shortest = min((system.tension.length[ptr[k] : ptr[k + 1]].min() for k in lines), default=10.0)
    return 0.2 * shortest if built.system.lines.bends[lines].any() else shortest
