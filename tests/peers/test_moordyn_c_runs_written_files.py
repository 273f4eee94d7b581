"""MoorDyn-C itself runs the files that we write, and feels the same lines."""

import dataclasses
import importlib.util
import json
import subprocess
import sys

import pytest

from moorage.io import write_moordyn
from moorage.model import (
    Attachment,
    Current,
    Curve,
    Environment,
    Line,
    LineType,
    Model,
    OutputChannel,
    Point,
    Section,
)

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(importlib.util.find_spec("moordyn") is None, reason="moordyn is not installed"),
]

# In a process of its own: an error of that program may end the process.
RUN = """
import json, sys, moordyn
system = moordyn.Create(sys.argv[1])
position = json.loads(sys.argv[2])
moordyn.Init(system, position, [0.0] * len(position))
force = moordyn.Step(system, position, [0.0] * len(position), 0.0, 0.1)
lines = [moordyn.GetLine(system, k + 1) for k in range(moordyn.GetNumberLines(system))]
result = {"force": list(force), "lengths": [moordyn.GetLineUnstretchedLength(line) for line in lines],
          "points": moordyn.GetNumberPoints(system), "rods": moordyn.GetNumberRods(system)}
moordyn.Close(system)
print("\\nRESULT" + json.dumps(result))
"""

CHAIN = LineType(
    name="chain",
    diameter=0.0766,
    mass_per_length=113.35,
    axial_stiffness=7.536e8,
    axial_damping_ratio=0.8,
    transverse_drag=2.0,
    transverse_added_mass=0.8,
    tangential_drag=0.4,
    tangential_added_mass=0.25,
)


def system(*sections, types=(CHAIN,), **around):
    return Model(
        environment=Environment(water_depth=200.0, **around),
        line_types=types,
        points=(
            Point(id=4, kind="fixed", position=(-837.6, 0.0, -200.0)),
            Point(id=9, kind="coupled", position=(-40.868, 0.0, -14.0)),
        ),
        lines=(
            Line(
                id=3,
                sections=tuple(Section(line_type=t, length=length, segments=n) for t, length, n in sections),
                end_a=Attachment("point", 4),
                end_b=Attachment("point", 9),
            ),
        ),
        outputs=(OutputChannel(name="FAIRTEN3"), OutputChannel(name="CON9FX")),
    )


def run(model, path):
    write_moordyn(model, path)
    command = [sys.executable, "-c", RUN, str(path), "[-40.868, 0.0, -14.0]"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300, cwd=path.parent)
    _, found, answer = done.stdout.partition("RESULT")
    assert found, done.stdout[-2000:] + done.stderr[-2000:]
    return json.loads(answer.splitlines()[0])


def test_one_section(tmp_path):
    result = run(system(("chain", 835.35, 20)), tmp_path / "model.dat")
    assert (result["lengths"], result["points"], result["rods"]) == ([835.35], 2, 0)


def test_table_and_current_and_two_sections(tmp_path):
    rope = dataclasses.replace(CHAIN, name="a rope", axial_stiffness=Curve((0.0, 0.1, 0.2), (0.0, 7.5e7, 1.6e8)))
    model = system(
        ("chain", 600.0, 12),
        ("a rope", 235.35, 8),
        types=(CHAIN, dataclasses.replace(rope, axial_damping_ratio=None, axial_damping=1e6)),
        current=Current((-200.0, 0.0), ((0.0, 0.0, 0.0), (0.5, 0.0, 0.0))),
    )
    result = run(model, tmp_path / "my model.dat")
    assert (result["lengths"], result["points"], result["rods"]) == ([600.0, 235.35], 3, 0)


def test_stiff_sections(tmp_path):
    cable = dataclasses.replace(CHAIN, bending_stiffness=1e4)
    result = run(system(("chain", 600.0, 12), ("chain", 235.35, 8), types=(cable,)), tmp_path / "model.dat")
    assert (result["points"], result["rods"]) == (2, 1)
