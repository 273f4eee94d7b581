"""What can be run on a seabed but is hardly meant: friction that is a damper, and what stands off the depth grid."""

from __future__ import annotations

from math import pi

from moorage.errors import Problem
from moorage.model.components import Line
from moorage.model.environment import Bathymetry
from moorage.model.model import Model
from moorage.model.seabed import ABOVE, above_seabed, is_anchor

SPEED = 0.1  # m/s, at which saturated damping should be Coulomb's friction
ENOUGH = 0.9
KNOWS_STATIC = ("stick-slip", "saturated-damping", "velocity-dependent")
RELATIVE = 1e-3  # of the depth, above which an anchor hangs over the seabed


def weak_friction(model: Model) -> list[Problem]:
    """Return what saturated damping lacks of Coulomb's force mu N at 0.1 m/s, where that is more than a tenth.

    Its force on a node is c_v mu v up to mu N, so that the fraction is c_v v / N with N the weight of a node in water:
    the finer the mesh, the larger it is.
    """
    friction = model.environment.friction
    if friction is None or friction.model != "saturated-damping" or friction.largest <= 0.0:
        return []
    slope = friction.damping * (friction.static_ratio if model.flavour == "native" else 1.0)
    weight = {line.id: heaviest_node(model, line) for line in model.lines}
    share = {id: min(1.0, slope * SPEED / N) for id, N in weight.items() if N > 0.0}
    weak = {id: value for id, value in share.items() if value < ENOUGH}
    if not weak:
        return []
    least = min(weak, key=lambda id: weak[id])
    names = f"line {least}" if len(weak) == 1 else f"lines {', '.join(map(str, weak))}"
    worst = "" if len(weak) == 1 else f" in line {least}"
    message = (
        f"saturated damping with c_v = {friction.damping:g} N s/m reaches {_percent(weak[least])} of Coulomb's "
        f"friction at {SPEED:g} m/s on {names}, whose nodes weigh up to {weight[least]:.3g} N in water{worst}"
    )
    needed = friction.damping * ENOUGH / weak[least]
    remedy = f"give {needed:.2g} or more (cv, FricDamp, damping), or a native file with the model elastic-slip"
    return [Problem(message, remedy, friction.source)]


def idle_static_friction(model: Model) -> list[Problem]:
    """Return static friction that is asked for and that the law does not know."""
    friction = model.environment.friction
    if friction is None or friction.static_ratio == 1.0 or friction.model in KNOWS_STATIC:
        return []
    message = f"static_ratio of seabed friction has no effect on the model {friction.model}"
    remedy = f"remove it, or choose {' or '.join(KNOWS_STATIC)}"
    return [Problem(message, remedy, friction.source, friction.static_ratio)]


def _percent(share: float) -> str:
    return f"{100.0 * share:.2g} %"


def heaviest_node(model: Model, line: Line) -> float:
    """Return the weight in water (N) of the heaviest node of a line: that of one segment."""
    types = {line_type.name.lower(): line_type for line_type in model.line_types}
    env, weights = model.environment, [0.0]
    for section in line.sections:
        kind = types.get(section.line_type.lower())
        if kind is not None and section.segments > 0:
            mass = kind.mass_per_length - env.water_density * 0.25 * pi * kind.diameter**2
            weights.append(env.gravity * mass * section.length / section.segments)
    return max(weights)


def points_off_the_grid(model: Model) -> list[Problem]:
    """Return the points that stand outside the depth grid and are no anchors; those are refused."""
    grid = model.environment.bathymetry
    if grid is None:
        return []
    return [
        Problem(
            f"point {point.id} is outside the depth grid ({extent(grid)}), whose edge goes on level there",
            "give a grid that covers the whole mooring",
            point.source,
            point.position[:2],
        )
        for point in model.points
        if point.body is None and not is_anchor(point, model.environment) and not is_inside(grid, *point.position[:2])
    ]


def anchors_over_the_bed(model: Model) -> list[Problem]:
    """Return the fixed points with lines that hang over the seabed in the lower half of the water.

    Those below the seabed are refused; one in the upper half holds something in the water.
    """
    env = model.environment
    tied = {end.id for line in model.lines for end in (line.end_a, line.end_b) if end.kind == "point"}
    found = []
    for point in model.points:
        x, y, z = point.position
        depth = env.depth_at(x, y)
        if point.on_seabed or point.id not in tied or not is_anchor(point, env):
            continue
        if z + depth > max(ABOVE, RELATIVE * depth):
            raised = above_seabed(point, env) > 0.0
            remedy = f"write z = {-depth:.6g}, or seabed, where it is an anchor" + (
                "; raise_to_seabed (--raise-to-seabed) puts it there" if raised else ""
            )
            where = " of the depth grid" if env.bathymetry else ""
            message = f"anchor (fixed point {point.id}) stands {z + depth:.3g} m over the seabed{where}"
            found.append(Problem(message, remedy, point.source, z))
    return found


def is_inside(grid: Bathymetry, x: float, y: float) -> bool:
    """Return whether a place is on the grid; along an axis of one value the seabed is the same everywhere."""
    return _within(grid.x, x) and _within(grid.y, y)


def _within(axis: tuple[float, ...], value: float) -> bool:
    return len(axis) == 1 or axis[0] <= value <= axis[-1]


def extent(grid: Bathymetry) -> str:
    """Return the limits of a grid in words."""
    parts = [f"{name} {a[0]:g} to {a[-1]:g} m" for name, a in (("x", grid.x), ("y", grid.y)) if len(a) > 1]
    return ", ".join(parts)
