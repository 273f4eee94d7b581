"""K of natural modes with rods and bodies is the derivative of the forces, whatever rides on what.

About static equilibrium, central differences of 1e-6 m and rad in each unknown; the forces are those of Newton's method
on nodes, points and objects. Blocks that are not symmetric are what is out of balance; statics leave 1e-3 N.
"""

from __future__ import annotations

import numpy as np
import pytest
from test_object_tangent import topologies

from moorage.layout import Weights
from moorage.solve.modes import island_pencil
from moorage.solve.newton import assemble_island, largest_imbalance
from moorage.solve.object_modes import own_unknowns
from moorage.solve.statics import solve, static_system
from moorage.solve.statics_kernel import place_at_rest
from moorage.system.build import build
from moorage.system.ride import begin_turning

# statics find no equilibrium of the first; a segment of the second is 3e-10 m from slack, where K jumps
LEFT_OUT = "cables joined between a body and a rod", "spar through the surface"
MODELS = {name: model for name, model in topologies().items() if name not in LEFT_OUT}
FORCE = Weights(0.0, 0.0, 1.0)


def forces(built, system, own) -> np.ndarray:
    place_at_rest(system, built.state, built.work, 0)
    assemble_island(system, built.state, built.state, built.work, 0, FORCE, 0.0)
    largest_imbalance(system, built.state, built.work, 0, FORCE)
    return built.work.force[own[:, 0], own[:, 1]]


@pytest.mark.parametrize("name", list(MODELS))
def test_stiffness_is_the_derivative_of_the_forces(name):
    built = build(MODELS[name])
    solve(built)
    pencil = island_pencil(built, 0)
    own = own_unknowns(built, 0, pencil.rows)
    system = static_system(built.system)
    begin_turning(system.islands, built.state, 0)
    position, K, step = built.state.position.copy(), np.zeros(pencil.stiffness.shape), 1e-6
    for k, (row, axis) in enumerate(own):
        ends = []
        for sign in (1.0, -1.0):
            built.state.position[...] = position
            built.state.position[row, axis] += sign * step
            ends.append(forces(built, system, own))
        K[:, k] = (ends[1] - ends[0]) / (2.0 * step)
    scale = np.abs(K).max()
    np.testing.assert_allclose(pencil.stiffness.toarray(), 0.5 * (K + K.T), atol=1e-5 * scale)
    assert np.abs(K - K.T).max() < 1e-3 * scale
