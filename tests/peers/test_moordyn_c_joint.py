"""Three cables that hang from a joint: MoorDyn-C's positions at rest within 5 mm.

Both turn a free rod of no length until the moments of its cables balance, MoorDyn by the sum of q EI / l (equation 10's
clamps leave 0.5 mm of difference). MoorDyn's stationary solver does not find cables at joints, so the ends are held for
120 s, with ten times the drag; the swing that is left is 2 mm.
"""

import numpy as np
from beside import moordyn_at_rest, needs, read, statics
from cables import JOINT

pytestmark = needs("moordyn_c")


def test_three_cables_at_rest(tmp_path):
    path = tmp_path / "joint.txt"
    soft = "1e6   -0.8      5e3  12  1.0 2.0"
    text = JOINT.replace("KIND", "Free").replace("1e7   -0.8      5e3  1.2 1.0 0.1", soft)
    path.write_text(text.replace("0.0  TmaxIC", "0.0  TmaxIC\n0.0005 dtM"))
    model = read(path)
    ours, theirs = statics(model), moordyn_at_rest(path, model, 120.0)
    assert np.abs(ours["node_position"].values - theirs["node_position"][-1]).max() < 5e-3
    joint = ours["rod_position"].values[0, 0]
    assert np.abs(theirs["node_position"][-1] - joint).sum(axis=1).min() < 5e-3
