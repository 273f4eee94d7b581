"""The parts of the force on the nodes of the lines: each is assembled from a system that has nothing else.

So a part is computed by the same kernels as in a run, and the parts add up to the whole.
"""

from __future__ import annotations

import numpy as np

from moorage.layout import State, System, Weights, copy_of, new_work
from moorage.physics.friction import NONE
from moorage.system.assemble import add_bending, assemble_line
from moorage.system.build import Built

FORCE = Weights(0.0, 0.0, 0.0)


def weight(system: System) -> System:
    """Leave dry weight and buoyancy."""
    return silenced(system)._replace(weight=system.weight)


def drag(system: System) -> System:
    """Leave drag."""
    return morison_only(system, [2, 3])


def swell(system: System) -> System:
    """Leave the force of the water's acceleration: Froude-Krylov and added mass."""
    return morison_only(system, [0, 1, 4])


def swell_added(system: System) -> System:
    """Leave what of that is by added mass."""
    return morison_only(system, [0, 1])


def swell_pressure(system: System) -> System:
    """Leave what of that is by the pressure in the undisturbed water, Froude and Krylov's force."""
    return morison_only(system, [4])


def contact(system: System) -> System:
    """Leave the normal force of the seabed."""
    return seabed(system)._replace(friction=system.friction._replace(law=NONE))


def seabed(system: System) -> System:
    """Leave contact and friction."""
    return silenced(system)._replace(contact=system.contact, friction=system.friction)


PARTS = {
    "weight": weight,
    "drag": drag,
    "swell": swell,
    "swell_added": swell_added,
    "swell_pressure": swell_pressure,
    "contact": contact,
    "seabed": seabed,
}


def node_force_part(built: Built, name: str) -> np.ndarray:
    """Return a part of the force on each node at the present state, (nodes, 3), N; name: of `PARTS`, or "bending"."""
    if name == "bending":
        return bending_forces(built)
    state = copy_of(built.state)
    state.acceleration[...] = 0.0
    return assembled(PARTS[name](built.system), state, FORCE)[0]


def part_histories(built: Built, name: str, position, velocity, water, line: int = 0) -> np.ndarray:
    """Return a part of the forces on the nodes of some lines, (n, nodes, 3), N, for histories (n, nodes, 3), m and m/s.

    water: (n, nodes, 7) elevation, velocity and acceleration of the water. `name` is one of `PARTS`. `line` is the
    first of the lines, whose nodes follow each other; rods stand behind the lines.
    """
    system, state, ptr = PARTS[name](built.system), copy_of(built.state), built.system.lines.node_ptr
    rows = slice(ptr[line], ptr[line] + position.shape[1])
    lines = range(line, int(np.searchsorted(ptr, rows.stop)))
    state.acceleration[...] = 0.0
    out, work = np.empty(position.shape), new_work(system)
    for row in range(len(out)):
        state.position[rows], state.velocity[rows], state.water[rows] = position[row], velocity[row], water[row]
        for k in lines:
            assemble_line(system, state, state, work, k, FORCE)
        out[row] = work.force[rows]
    return out


def morison_only(system: System, columns: list[int]) -> System:
    """Return a system with some of the columns of `Morison.node` and `.segment` and nothing else."""
    nothing = silenced(system)
    node, segment = nothing.morison.node, nothing.morison.segment
    node[:, columns], segment[:, columns] = system.morison.node[:, columns], system.morison.segment[:, columns]
    return nothing


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
