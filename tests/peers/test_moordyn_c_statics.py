"""Static state of MoorDyn-C on the file that Moorage reads: tension within 0.1 %, positions of all nodes.

MoorDyn-C's stationary solver does not find the place of free points; it is then given time to settle.
"""

import decks
import numpy as np
import pytest
from beside import REFINED, moordyn_at_rest, needs, read, statics

pytestmark = needs("moordyn_c")


# what remains of MoorDyn-C's slow swinging decides on the tolerance of positions, m; the tension's is the issue's
@pytest.mark.parametrize(
    ("name", "held", "position"),
    [("CHAINS", 1, 1e-4), ("BRIDLE", 400, 0.02), ("TWO_SECTIONS", 500, 0.1), ("CURRENT", 200, 1e-4)],
)
def test_tension_and_shape(name, held, position, tmp_path):
    path = decks.write(getattr(decks, name), tmp_path, **REFINED | {"dtM": 0.002})
    model = read(path)
    ours, theirs = statics(model), moordyn_at_rest(path, model, held)
    np.testing.assert_allclose(ours["fairlead_segment_tension"], theirs["end_tension"][-1], rtol=1e-3)
    np.testing.assert_allclose(ours["node_position"], theirs["node_position"][-1], atol=position)


def test_force_of_end_nodes(tmp_path):
    """MoorDyn's net force on the end nodes is ours on the objects that hold them, when nothing moves."""
    path = decks.write(decks.CHAINS, tmp_path, **REFINED)
    model = read(path)
    ours, theirs = statics(model), moordyn_at_rest(path, model)
    first = theirs["line_node"][:-1]
    np.testing.assert_allclose(ours["anchor_force"], theirs["node_force"][-1, first], rtol=1e-5, atol=1.0)
    last = theirs["line_node"][1:] - 1
    np.testing.assert_allclose(ours["fairlead_force"], theirs["node_force"][-1, last], rtol=1e-5, atol=1.0)


def test_line_through_the_surface(tmp_path):
    """Intended differences, small ones: how much of a piercing segment is wet, and which of its nodes is lifted.

    MoorDyn-C takes the wet fraction from the heights of the rims of the segment's ends, (r s - z0) / (z1 - z0 + 2 r s) with
    s the sine of its angle from the vertical, and gives half of the lift to each node. Ours follows from an energy: the
    section's wet fraction along the segment, weighted with the nodes' shape functions. The wet lengths differ by less
    than r s / (1 - s^2)^0.5 for each crossing, so the lift by less than twice that for this line.
    """
    path = decks.write(decks.SURFACE, tmp_path, **REFINED)
    model = read(path)
    ours, theirs = statics(model), moordyn_at_rest(path, model, 200.0)
    z = ours["node_position"].values[:, 2]
    crossing = np.flatnonzero(z[1:] * z[:-1] < 0.0)
    assert len(crossing) == 2
    cosine = np.abs(np.diff(z))[crossing] / 2.5
    wet = 0.1 * np.sqrt(1.0 - cosine**2) / cosine
    lift = 1025.0 * 9.80665 * np.pi / 4.0 * 0.2**2 * wet.sum()
    weight = [
        -(ours["anchor_force"].values + ours["fairlead_force"].values)[0, 2],
        -theirs["node_force"][-1, [0, -1], 2].sum(),
    ]
    assert abs(weight[0] - weight[1]) < lift < 0.01 * weight[0]
    np.testing.assert_allclose(ours["fairlead_segment_tension"], theirs["end_tension"][-1], rtol=0.01)
