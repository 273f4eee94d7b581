"""The parts of the force on the nodes of the lines: each is assembled from a system that has nothing else.

So a part is computed by the same kernels as in a run, and the parts add up to the whole.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.layout import State, System, Weights, copy_of, new_work
from moorage.system.assemble import add_bending, assemble_line
from moorage.system.build import Built

FORCE = Weights(0.0, 0.0, 0.0)


class NodeForces(NamedTuple):
    """Forces on all nodes, (nodes, 3), N."""

    weight: np.ndarray  # dry weight and buoyancy
    drag: np.ndarray
    swell: np.ndarray  # of the water's acceleration: Froude-Krylov and added mass
    seabed: np.ndarray  # contact and friction
    bending: np.ndarray


def node_forces(built: Built) -> NodeForces:
    """Return the parts of the force on each node at the present state."""
    system, state = built.system, copy_of(built.state)
    state.acceleration[...] = 0.0
    nothing = silenced(system)
    water = nothing.morison.node.copy()
    drag, swell = np.zeros_like(water), np.zeros_like(water)
    drag[:, 2:4] = system.morison.node[:, 2:4]
    swell[:, [0, 1, 4]] = system.morison.node[:, [0, 1, 4]]
    drag_part, swell_part = np.zeros_like(system.morison.segment), np.zeros_like(system.morison.segment)
    drag_part[:, 2:4] = system.morison.segment[:, 2:4]
    swell_part[:, [0, 1, 4]] = system.morison.segment[:, [0, 1, 4]]
    morison = nothing.morison
    return NodeForces(
        assembled(nothing._replace(weight=system.weight), state, FORCE)[0],
        assembled(nothing._replace(morison=morison._replace(node=drag, segment=drag_part)), state, FORCE)[0],
        assembled(nothing._replace(morison=morison._replace(node=swell, segment=swell_part)), state, FORCE)[0],
        assembled(nothing._replace(contact=system.contact, friction=system.friction), state, FORCE)[0],
        bending_forces(built),
    )


def node_masses(built: Built) -> np.ndarray:
    """Return the mass matrices of all nodes with their added mass, (nodes, 3, 3), kg."""
    still = copy_of(built.state)
    for values in (still.velocity, still.acceleration, still.water):
        values[...] = 0.0
    still.water[:, 0] = built.state.water[:, 0]
    system = silenced(built.system)._replace(morison=built.system.morison)
    own = assembled(system, still, Weights(1.0, 0.0, 0.0))[1]
    return own[:, [0, 1, 2, 1, 3, 4, 2, 4, 5]].reshape(-1, 3, 3)


def bending_forces(built: Built) -> np.ndarray:
    """Return the forces of bending on all nodes within lines and at their clamps, (nodes, 3), N."""
    work = new_work(built.system)
    work.direction[...] = built.work.direction
    for line in np.flatnonzero(built.system.lines.bends):
        add_bending(built.system, built.state, work, line, FORCE)
    return work.force[: int(built.names.node_ptr[-1])]


def silenced(system: System) -> System:
    """Return a system with the same lines, on whose nodes nothing acts."""
    return system._replace(
        lines=system.lines._replace(bends=np.zeros_like(system.lines.bends)),
        tension=system.tension._replace(
            spring=np.zeros_like(system.tension.spring),
            damper=np.zeros_like(system.tension.damper),
            spring_table=np.full_like(system.tension.spring_table, -1),
            damper_table=np.full_like(system.tension.damper_table, -1),
        ),
        weight=system.weight._replace(
            dry=np.zeros_like(system.weight.dry), buoyancy=np.zeros_like(system.weight.buoyancy)
        ),
        morison=system.morison._replace(
            mass=np.zeros_like(system.morison.mass),
            node=np.zeros_like(system.morison.node),
            segment=np.zeros_like(system.morison.segment),
        ),
        contact=system.contact._replace(bed=system.contact.bed._replace(highest=-1e9)),
    )


def assembled(system: System, state: State, c: Weights) -> tuple[np.ndarray, np.ndarray]:
    """Return forces (nodes, 3) and own blocks (nodes, 6) of all lines."""
    work, nodes = new_work(system), int(system.lines.node_ptr[-1])
    for line in range(len(system.lines.bends)):
        assemble_line(system, state, state, work, line, c)
    return work.force[:nodes], work.blocks.own[:nodes]
