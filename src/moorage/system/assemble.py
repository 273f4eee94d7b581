"""Out-of-balance force and Newton matrix of a line, from the terms of its nodes, segments and bends.

What the matrix leaves out, to stay symmetric: how the *direction* of inertia, drag and damping turns with the position
(`turn_of_drag` is apart), and how added mass and drag change as a node crosses the surface. All else is exact.
"""

from __future__ import annotations

import math

import numpy as np

from moorage._jit import inlined, kernel, part
from moorage._vec3 import (
    accumulate,
    add,
    dot,
    get,
    isotropic_plus,
    mat_accumulate,
    mat_put,
    mat_scale,
    mat_sym,
    mat_transpose,
    put,
    scale,
    sub,
    sym_accumulate,
    sym_add,
    sym_put,
    sym_scale,
    sym_to_general,
)  # fmt: skip
from moorage.layout import line_nodes, memory_of, water_of
from moorage.physics.bathymetry import bed_at
from moorage.physics.bending import (
    PAPER,
    PINNED,
    bend,
    bending_terms,
    clamp_terms,
    end_hinge,
    half_hinge,
    hinge,
    node_blocks,
    node_hinge,
    tabulated,
)
from moorage.physics.contact import contact_on, near_bed
from moorage.physics.friction import NONE, friction_terms
from moorage.physics.morison import (
    anisotropic,
    drag_terms,
    drag_turn,
    hydro_block,
    inertia_terms,
    wet_end,
    wet_node,
    wet_part,
)
from moorage.physics.tension import tension_terms
from moorage.physics.weight import wet_shares
from moorage.system.ride import surface_band

ZERO3 = (0.0, 0.0, 0.0)
ZERO6 = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
ZERO9 = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@kernel
def assemble_line(system, state, start, work, line, c):
    """Set force and blocks of all nodes of a line; c: the weights of mass, damping and stiffness in the matrix.

    `start` is the state at the start of the step.
    """
    first, last = line_nodes(system.lines, line)
    carried = begin_walk(system.lines, state.position, line)
    for i in range(first, last + 1):
        force, own, coupling, carried = walk(system, state, start, work.load, line, i, last, carried, c)
        put(work.force, i, force)
        sym_put(work.blocks.own, i, own)
        mat_put(work.blocks.next, i, sym_to_general(coupling))
    if system.lines.bends[line]:
        add_bending(system, state, work, line, c)


@inlined
def begin_walk(lines, position, line):
    """What is carried to the first node of a line: beyond a joint, the vector of a segment of the other line."""
    first, beyond = lines.node_ptr[line], lines.beyond[line, 0]
    e = sub(get(position, first), get(position, beyond)) if beyond >= 0 else ZERO3
    return e, ZERO3, ZERO6, 0.5, 0.0, 0.0, np.uintp(first - line)


@inlined
def walk(system, state, start, load, line, i, last, carried, c):
    """One step of the walk from end A to end B, at node i, bending left out.

    Returns the node's force, its own block, its coupling to the next node (symmetric) and what is carried there: of the
    segment between them its vector, pull, block, wet share, buoyancy, minus the slope of that in z, and number. Sets
    the load under which the node rubs on the bed, and the normal there, see `bed_terms`.
    """
    e_before, pull_before, block_before, share_before, lift_before, sink_before, j_before = carried
    n, j = np.uintp(i), j_before
    r, v = get(state.position, i), get(state.velocity, i)
    e, pull, block = ZERO3, ZERO3, ZERO6
    share, share_far, d00, d01, d11, buoyancy = 0.5, 0.5, 0.0, 0.0, 0.0, 0.0
    if i < last:
        j = np.uintp(i - line)
        e, de = sub(get(state.position, i + 1), r), sub(get(state.velocity, i + 1), v)
        pull, block = tension_terms(system.tension, j, e, de, c)
        height, height_far = r[2] - state.water[i, 0], r[2] + e[2] - state.water[i + 1, 0]
        share, share_far, d00, d01, d11 = wet_shares(surface_band(system, line, j, e), height, height_far)
        buoyancy = system.weight.buoyancy[j]
    elif system.lines.beyond[line, 1] >= 0:
        e = sub(get(state.position, system.lines.beyond[line, 1]), r)
    if share_before + share == 1.0:
        hydro = wet_node(system.morison, n)
    elif not system.lines.node_ptr[line] < i < last:
        hydro = wet_end(system.morison, n, 2.0 * (share_before + share) - 1.0)
    else:
        hydro = wet_part(system.morison, n, j_before, share_before, j, share)
    q = unit_or_zero(add(e_before, e))
    a = get(state.acceleration, i)
    force, own, rubbed, normal = node_terms(system, n, hydro, q, water_of(state, i), r, v, a, start, c)
    load[n, 0] = rubbed
    if rubbed != 0.0:
        load[n, 1], load[n, 2], load[n, 3] = normal
    force = add(force, sub(pull, pull_before))
    force = force[0], force[1], force[2] + lift_before + share * buoyancy
    sink = c.stiffness * buoyancy
    own = add_zz(sym_add(own, sym_add(block, block_before)), -sink_before - sink * d00)
    coupling = add_zz(sym_scale(-1.0, block), -sink * d01)
    return force, own, coupling, (e, pull, block, share_far, share_far * buoyancy, sink * d11, j)


@inlined
def span_around(lines, position, line, i):
    """Vector between the nodes on either side of node i of a line, which gives the line's direction there."""
    first, last = line_nodes(lines, line)
    before = i - 1 if i > first else lines.beyond[line, 0]
    after = i + 1 if i < last else lines.beyond[line, 1]
    return sub(get(position, after if after >= 0 else i), get(position, before if before >= 0 else i))


@inlined
def unit_or_zero(u):
    """Direction of a vector; zero where a line folds back on itself."""
    return scale(1.0 / math.sqrt(max(dot(u, u), 1e-300)), u)


@inlined
def add_zz(s, x):
    """Add to the zz entry of a symmetric block."""
    return s[0], s[1], s[2], s[3], s[4], s[5] + x


@inlined
def node_terms(system, i, hydro, q, water, r, v, a, start, c):
    """Force and own block of inertia, drag, seabed and dry weight at a node, the load under which it rubs, the normal.

    q: tangent of the line; water: elevation of the surface, velocity and acceleration of the water; start: the state at
    the start of the step.
    """
    # looked up first, because it takes longest to come
    near = near_bed(system.contact, get(start.position, i), r)
    bed = bed_at(system.contact.bed, r[0], r[1]) if near else ZERO6
    added_normal, added_axial, drag_normal, drag_axial, displaced = hydro
    mass = system.morison.mass[i]
    inertia, inertia_block = inertia_terms(mass + added_normal, mass + added_axial, q, a, c)
    drag, drag_block = drag_terms(drag_normal, drag_axial, q, sub(v, water[1]), c)
    swell = anisotropic(displaced + added_normal, displaced + added_axial, q, water[2])
    force, own = add(add(inertia, drag), swell), hydro_block(inertia_block, drag_block, q)
    load, normal = 0.0, ZERO3
    if near:
        push, bed_block, load, normal = bed_terms(system, i, bed, q, r, v, start, c)
        force, own = add(force, push), sym_add(own, bed_block)
    return (force[0], force[1], force[2] + system.weight.dry[i]), own, load, normal


@inlined
def bed_terms(system, i, bed, q, r, v, start, c):
    """Contact and friction of the seabed on a node, their block, the load (N) under which it rubs, and the normal.

    The load is -1 where friction surely holds the node.
    """
    soil = system.contact.soil
    N, n, block = contact_on(system.contact, i, bed, get(start.position, i), r, v, memory_of(soil, start, i), c)
    force, load = scale(N, n), rubbing_load(soil, N)
    if system.friction.law != NONE and load > 0.0:
        rub, rub_block, held = friction_terms(system.friction, i, load, n, q, r, v, get(start.stuck, i), c)
        force, block = add(force, rub), sym_add(block, rub_block)
        load = -1.0 if held else load
    return force, block, load, n


@inlined
def rubbing_load(soil, N):
    """Load under which a node rubs, N: the size of the normal force, and nothing under suction."""
    return max(N, 0.0) if soil.on else abs(N)


@part
def turn_of_drag(system, state, line, turn):
    """Set in `turn` (rows, 9) how the drag on a node changes as the next node moves, N/m: minus it for the one before.

    Nodes in the surface count with all of their drag.
    """
    first, last = line_nodes(system.lines, line)
    for i in range(first, last + 1):
        e = span_around(system.lines, state.position, line, i)
        q = unit_or_zero(e)
        u = sub(get(state.velocity, i), water_of(state, i)[1])
        _, _, normal, axial, _ = wet_node(system.morison, np.uintp(i))
        across = isotropic_plus(1.0, -1.0, q)
        H = mat_sym(drag_turn(normal, axial, q, u), across)
        mat_put(turn, i, mat_scale(1.0 / math.sqrt(max(dot(e, e), 1e-300)), H))


@kernel
def add_bending(system, state, work, line, c):
    """Add the bend at every interior node, and the clamps: to nodes, neighbours and their couplings."""
    p = system.bending
    first, last = line_nodes(system.lines, line)
    force, own, next, skip = work.force, work.blocks.own, work.blocks.next, work.blocks.skip
    mat_put(skip, last - 1, ZERO9)  # couplings beyond the end, which elimination reads
    mat_put(skip, last, ZERO9)
    for i in range(first + 1, last):
        r = get(state.position, i)
        bent = bend(sub(r, get(state.position, i - 1)), sub(get(state.position, i + 1), r))
        G, U = node_hinge(p, np.uintp(i), bent[4])
        d1, d2, H11, H22, H12 = bending_terms(bent, G, U, c.stiffness)
        middle, before, after, H21 = node_blocks(H11, H22, H12)
        accumulate(force, i - 1, d1)
        accumulate(force, i, sub(d2, d1))
        accumulate(force, i + 1, scale(-1.0, d2))
        sym_accumulate(own, i - 1, H11)
        sym_accumulate(own, i, middle)
        sym_accumulate(own, i + 1, H22)
        mat_accumulate(next, i - 1, before)
        mat_accumulate(next, i, after)
        mat_put(skip, i - 1, mat_scale(-1.0, H21))
    for end in range(2):
        if p.rule[line, end] != PINNED:
            node, beside = (first, first + 1) if end == 0 else (last, last - 1)
            gradient, H = clamp_at(p, state.position, work.direction, line, end, node, beside, c.stiffness)
            accumulate(force, node, gradient)
            accumulate(force, beside, scale(-1.0, gradient))
            sym_accumulate(own, node, H)
            sym_accumulate(own, beside, H)
            mat_accumulate(next, min(node, beside), sym_to_general(sym_scale(-1.0, H)))


@inlined
def clamp_at(p, position, direction, line, end, node, beside, k):
    """Gradient and block of a clamped end, by the vector from its node to the one beside it."""
    e = sub(get(position, beside), get(position, node))
    u = 1.0 / math.sqrt(dot(e, e))
    q, d = scale(u, e), (direction[line, end, 0], direction[line, end, 1], direction[line, end, 2])
    cosine = dot(q, d)
    G, U = end_hinge(p, np.uintp(node), p.rule[line, end], cosine)
    return clamp_terms(G, U, u, q, d, cosine, k)


@part
def add_joints(system, state, work, island, c):
    """Add the bend where two line ends are joined: force, own blocks and couplings within each line, and across."""
    lines, joints = system.lines, system.joints
    force, own, next = work.force, work.blocks.own, work.blocks.next
    for m in range(system.islands.joint_ptr[island], system.islands.joint_ptr[island + 1]):
        node1, beside1, low1 = joint_nodes(lines, joints, m, 0)
        node2, beside2, low2 = joint_nodes(lines, joints, m, 1)
        r = get(state.position, node1)
        bent = bend(sub(r, get(state.position, beside1)), sub(get(state.position, beside2), r))
        G, U = joint_hinge(system.bending, joints, m, bent[4])
        d1, d2, H11, H22, H12 = bending_terms(bent, G, U, c.stiffness)
        middle, before, after, H21 = node_blocks(H11, H22, H12)
        accumulate(force, beside1, d1)
        accumulate(force, node1, sub(d2, d1))
        accumulate(force, beside2, scale(-1.0, d2))
        sym_accumulate(own, beside1, H11)
        sym_accumulate(own, node1, middle)
        sym_accumulate(own, beside2, H22)
        # `before` couples the joint's row to the node on the first line, `after` that on the second to the joint's
        mat_accumulate(next, low1, before if node1 > beside1 else mat_transpose(before))
        mat_accumulate(next, low2, after if beside2 > node2 else mat_transpose(after))
        mat_put(work.blocks.joint, m, mat_scale(-1.0, H21))


@inlined
def joint_nodes(lines, joints, m, side):
    """End node of a line at a joint, the node beside it, and the lower of both."""
    first, last = line_nodes(lines, joints.line[m, side])
    return (first, first + 1, first) if joints.end[m, side] == 0 else (last, last - 1, last - 1)


@inlined
def joint_hinge(p, joints, m, c):
    """Return -dE/dc and d2E/dc2 of a joint."""
    if joints.table[m] >= 0:
        return tabulated(p, joints.table[m], c)
    k1, k2 = joints.stiffness[m, 0], joints.stiffness[m, 1]
    return half_hinge(k1, k2, c) if joints.rule[m] == PAPER else hinge(k1, k2, c)
