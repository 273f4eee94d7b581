"""What a table says of bodies and rods, in statics and of a run."""

import numpy as np
import pytest
from floats import body, floating, rod

import moorage
from moorage.results import object_summaries


def ball():
    """Return a buoyant body in the middle of the water, with a rod on it that points up."""
    hull = body(mass=1000.0, volume=0.9, inertia=(100.0, 100.0, 100.0), position=(1.0, 2.0, -20.0))
    return floating((hull,), (rod(2, "fixed", (0.0, 0.0, 0.0), (0.0, 0.0, 3.0), body=1),))


def test_a_run():
    model = ball()
    ds = moorage.simulate(model, duration=2.0, start="as-given")
    rows = {(row.name, row.coordinate): row for row in object_summaries(ds)}
    assert len(rows) == 6 + 2 * 3
    z, history = rows["body 1", "z"], ds["body_position"].values[:, 0, 2]
    assert (z.start, z.end, z.lowest, z.highest) == (history[0], history[-1], history.min(), history.max())
    assert z.unit == "m"
    assert rows["body 1", "pitch"].unit == "deg"
    top = rows["end B of rod 2", "z"]
    assert top.end == pytest.approx(z.end + 3.0, abs=1e-9)


def test_angles_are_degrees():
    ds = moorage.simulate(ball(), duration=0.1, start="as-given")
    ds["body_rotation"][...] = np.radians([10.0, 20.0, 30.0])
    rows = {row.coordinate: row for row in object_summaries(ds) if row.name == "body 1"}
    assert rows["roll"].end == pytest.approx(10.0)
    assert rows["yaw"].highest == pytest.approx(30.0)
