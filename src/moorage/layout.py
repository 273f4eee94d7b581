"""The flat layout of a system, its state and the workspace.

    line 0            line 1                 points
    o--o--o--o--o     o--o--o                *  *  *  *
    0  1  2  3  4     5  6  7                8  9 10 11     rows of every state array, (rows, 3)
      0  1  2  3        4  5                                segments: that after node i of line k is i - k

Lines and points stand in the order of the file; after the points come the ends of rods, which hold lines just as
points do. A line owns both its end nodes; they copy the point that they hold on to, or follow the prescribed motion of
that point (whose own row is then not used). Lines that share free points form an island; islands do not see each other,
and each takes steps of its own size.

Elimination leaves the *boundary* of a line: an end node on a free point, and next to a joint of two cables, or to a
rod or body that clamps it and turns, also the node beside it, because the hinge reaches that far. Free points and those
nodes are the unknown 3-vectors of the junction system of an island.

Rods and bodies that move by the forces on them are *objects*: two rows each after the points and ends of rods, for
translation and rotation, and as many unknown 3-vectors. What rides on an object follows it: points, ends of rods, and
the nodes of rods. A rod is a *rigid* line: its nodes stand behind those of the lines, they feel weight, water and
seabed like any other, and nothing is stretched between them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage._jit import inlined
from moorage.physics.bending import Bending
from moorage.physics.contact import Contact
from moorage.physics.current import Current
from moorage.physics.friction import Friction
from moorage.physics.morison import Morison
from moorage.physics.motion import Tracks
from moorage.physics.point import PointLoads
from moorage.physics.rigid import RigidLoads
from moorage.physics.sea import RECORD, Sea, scratch_for
from moorage.physics.sea_table import FIELDS, TERMS
from moorage.physics.soil import FRESH
from moorage.physics.tension import Tension
from moorage.physics.weight import Weight
from moorage.physics.winch import Winches


class Lines(NamedTuple):
    """Topology of the lines, then of the rods as rigid lines."""

    node_ptr: np.ndarray  # (lines + 1,)
    end_point: np.ndarray  # (lines, 2) point at end A and at end B
    end_unknown: np.ndarray  # (lines, 2) number of that point among the unknowns of its island, -1: prescribed
    inner_unknown: np.ndarray  # (lines, 2) number of the node beside the end, -1: not part of the boundary
    bends: np.ndarray  # (lines,) bool: has bending stiffness
    beyond: np.ndarray  # (lines, 2) row of the node that follows beyond a joint at that end, -1: the line ends there


class Islands(NamedTuple):
    """Lines and free points of each island, as lists in compressed rows."""

    line_ptr: np.ndarray  # (islands + 1,)
    lines: np.ndarray  # (lines,)
    point_ptr: np.ndarray  # (islands + 1,)
    points: np.ndarray  # (free points,)
    joint_ptr: np.ndarray  # (islands + 1,)
    object_ptr: np.ndarray  # (islands + 1,)
    objects: np.ndarray  # (objects, 2) rods that are pinned to bodies before the bodies; the row of each's translation
    rides: np.ndarray  # (islands, 2) how many of the points, the first ones, ride on objects; 1: has objects or rods
    unknown_ptr: np.ndarray  # (islands + 1,) unknown 3-vectors: points, nodes beside joints and clamps, objects
    unknown_row: np.ndarray  # (unknowns,) their state rows
    matrix_ptr: np.ndarray  # (islands + 1,) offsets of the junction matrices


class Joints(NamedTuple):
    """Joints where bending passes from one line end to another, in the order of the islands."""

    line: np.ndarray  # (joints, 2) the two lines
    end: np.ndarray  # (joints, 2) and their ends, 0: A, 1: B
    stiffness: np.ndarray  # (joints, 2) 2 EI / l of their end segments, N m/rad
    rule: np.ndarray  # (joints,) EXACT or PAPER
    table: np.ndarray  # (joints,) table of moment, -1: constant EI


FLEXIBLE, HELD = -1, -2  # carriers of lines other than objects: a real line; a rod whose motion is prescribed
ROW, PIN, TRANSLATION, ROTATION = 0, 1, 2, 3  # columns of Riders.objects
CARRIER, CLAMP = 0, 1  # columns of Riders.lines
SPAN, TOWARD, WATERPLANE = 0, 2, 4  # rows of Riders.places


class Riders(NamedTuple):
    """Objects (rods and bodies that forces move), and what rides on them, in their own axes.

    Few arrays hold all, because each field of a system makes all kernels longer to compile.
    """

    objects: np.ndarray  # (objects, 4) int: ROW of the translation, that of the rotation follows; PIN: point or rod end
    # that the reference point follows, -1: it is free; TRANSLATION: number of that unknown, of a rider where it is
    # pinned to one, -1: prescribed; ROTATION: number of that unknown
    points: np.ndarray  # (points,) int: object that carries the point or rod end, -1
    arm: np.ndarray  # (points, 3) from the object's reference point, m
    lines: np.ndarray  # (lines, 3) int: CARRIER of a rigid line, FLEXIBLE or HELD; CLAMP + end: object that clamps, -1
    places: (
        np.ndarray
    )  # (lines, 5, 3) SPAN + end: ends of rigid lines, m; TOWARD + end: direction of the clamp into the
    # line; WATERPLANE: of a rod, rho g pi d^4 / 64, N m, in the first place

    @property
    def row(self) -> np.ndarray:
        """Rows of translation, (objects,)."""
        return self.objects[:, ROW]

    @property
    def pin(self) -> np.ndarray:
        """Pins, (objects,)."""
        return self.objects[:, PIN]


class Breaks(NamedTuple):
    """Line ends that come off at a force."""

    rows: np.ndarray  # (breaks, 3) int: line; end, 0: A, 1: B; the failure of the model that it belongs to
    limit: np.ndarray  # (breaks,) N


class System(NamedTuple):
    """All parameters; one compiled signature serves every model."""

    lines: Lines
    islands: Islands
    joints: Joints
    riders: Riders
    breaks: Breaks
    winches: Winches
    tension: Tension
    bending: Bending
    weight: Weight
    morison: Morison
    contact: Contact
    friction: Friction
    points: PointLoads
    rigid: RigidLoads
    current: Current
    sea: Sea
    tracks: Tracks


class State(NamedTuple):
    """Motion of all rows at one time.

    Rows of rotation: the rotation vector since `base` (rad), angular velocity (rad/s) and acceleration (rad/s2), all in
    axes of the object.
    """

    position: np.ndarray  # (rows, 3) m
    velocity: np.ndarray  # (rows, 3) m/s
    acceleration: np.ndarray  # (rows, 3) m/s2, exact at the end of the step
    auxiliary: np.ndarray  # (rows, 3) m/s2, the averaged acceleration of Arnold and Bruls
    stuck: np.ndarray  # (rows, 3) m, where friction holds a node on the seabed; its position when it is off the bed
    soil: np.ndarray  # (rows, 6) what the seabed remembers of a node, see `physics.soil`
    water: np.ndarray  # (rows, 7) elevation of the surface, m; velocity, m/s, and acceleration of the water, m/s2
    frames: np.ndarray  # (2, objects, 9) ATTITUDE, rotation from an object's axes to global ones; BASE, at the start of
    # the step
    heat: np.ndarray  # (lines, 2) energy that friction took from a line since the start, J, and what it takes now, W

    @property
    def attitude(self) -> np.ndarray:
        """Rotations from the axes of objects to global ones, (objects, 9)."""
        return self.frames[ATTITUDE]

    @property
    def base(self) -> np.ndarray:
        """The same at the start of the step."""
        return self.frames[BASE]


ATTITUDE, BASE = 0, 1
WITHOUT_ROWS = ("frames", "heat")  # fields of the state that have no row for each row


class Table(NamedTuple):
    """Waves along the paths of the nodes, see `physics.sea_table`; empty without waves."""

    number: np.ndarray  # (islands,) of the interval that each island is in
    start: np.ndarray  # (rows, 3) m, where the paths start
    end: np.ndarray  # (rows, 3) and end
    before: np.ndarray  # (rows, RECORD) the sums there
    after: np.ndarray  # (rows, RECORD)
    terms: np.ndarray  # (rows, FIELDS, TERMS) coefficients of the interval
    scratch: np.ndarray  # (islands, ...) for the sums, see `physics.sea.scratch_for`


class Blocks(NamedTuple):
    """The Newton matrix of all lines, S = c.mass M + c.damping C + c.stiffness K, and what elimination leaves of it."""

    own: np.ndarray  # (rows, 6) S[i, i], then its inverse after elimination
    next: np.ndarray  # (rows, 9) S[i+1, i]
    skip: np.ndarray  # (rows, 9) S[i+2, i], lines with bending only
    start: np.ndarray  # (rows, 9) fill-in S[i, first], lines whose end A is free only
    inner: np.ndarray  # (rows, 9) fill-in S[i, first + 1], lines with a joint at end A only
    joint: np.ndarray  # (joints, 9) S[neighbour on the second line, neighbour on the first line]


class Work(NamedTuple):
    """Scratch space of one process."""

    trial: State
    table: Table
    blocks: Blocks
    force: np.ndarray  # (rows, 3) out-of-balance force, N
    increment: np.ndarray  # (rows, 3) solution of S x = force
    junction_matrix: np.ndarray  # (sum of (3 free)^2,) one dense matrix an island
    junction_force: np.ndarray  # (3 unknowns,)
    load: np.ndarray  # (rows, 4) under which a node rubs on the bed, N, -1: far from slipping; the normal of the bed
    direction: np.ndarray  # (lines, 2, 3) in which clamps point into the line at the time of the trial state


class Weights(NamedTuple):
    """How the parts of the tangent are mixed into S."""

    mass: float
    damping: float
    stiffness: float


def rows_of(system: System) -> int:
    """Return the number of rows of the state."""
    return int(system.lines.node_ptr[-1]) + len(system.points.mass) + 2 * len(system.riders.objects)


def new_state(rows: int, objects: int, lines: int) -> State:
    """Return a state of zeros, with objects upright."""
    width = {"water": FIELDS, "soil": len(FRESH)}
    moving = {name: np.zeros((rows, width.get(name, 3))) for name in State._fields if name not in WITHOUT_ROWS}
    return State(**moving, frames=np.tile(np.eye(3).ravel(), (2, objects, 1)), heat=np.zeros((lines, 2)))


def copy_of(state: State) -> State:
    """Return an independent copy of a state."""
    return State(*(values.copy() for values in state))


def new_table(system: System, rows: int) -> Table:
    """Return an empty table of waves."""
    islands, n = len(system.islands.line_ptr) - 1, system.sea.parts.shape[1]
    rows = rows if n else 0
    return Table(
        np.zeros(islands, dtype=np.int64), np.zeros((rows, 3)), np.zeros((rows, 3)), np.zeros((rows, RECORD)),
        np.zeros((rows, RECORD)), np.zeros((rows, FIELDS, TERMS)), scratch_for(system.sea, islands),
    )  # fmt: skip


def new_work(system: System) -> Work:
    """Return scratch space for a system."""
    rows = rows_of(system)
    blocks = Blocks(
        np.zeros((rows, 6)), np.zeros((rows, 9)), np.zeros((rows, 9)), np.zeros((rows, 9)), np.zeros((rows, 9)),
        np.zeros((len(system.joints.rule), 9)),
    )  # fmt: skip
    return Work(
        new_state(rows, len(system.riders.objects), len(system.lines.bends)),
        new_table(system, rows),
        blocks,
        np.zeros((rows, 3)),
        np.zeros((rows, 3)),
        np.zeros(int(system.islands.matrix_ptr[-1])),
        np.zeros(3 * len(system.islands.unknown_row)),
        np.zeros((rows, 4)),
        np.zeros((len(system.lines.bends), 2, 3)),
    )


@inlined
def line_nodes(lines, line):
    """First and last node of a line."""
    return lines.node_ptr[line], lines.node_ptr[line + 1] - 1


@inlined
def water_of(state, i):
    """Elevation of the surface (m), velocity (m/s) and acceleration (m/s2) of the water at a row."""
    w = state.water
    return w[i, 0], (w[i, 1], w[i, 2], w[i, 3]), (w[i, 4], w[i, 5], w[i, 6])


@inlined
def memory_of(soil, state, i):
    """What the seabed remembers of a node; nothing where its soil has no memory."""
    m = state.soil
    return (m[i, 0], m[i, 1], m[i, 2], m[i, 3], m[i, 4], m[i, 5]) if soil.on else FRESH


@inlined
def put_memory(state, i, memory):
    """Set what the seabed remembers of a node."""
    m = state.soil
    m[i, 0], m[i, 1], m[i, 2], m[i, 3], m[i, 4], m[i, 5] = memory


@inlined
def point_row(lines, point):
    """Row of a point in the state arrays."""
    return lines.node_ptr[len(lines.node_ptr) - 1] + point
