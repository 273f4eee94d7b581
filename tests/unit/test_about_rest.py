"""Natural modes and stiffness from a model: datasets, tables, JSON, and platforms that feel each other."""

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import moorage
from moorage.cli import app
from moorage.model import Attachment, Body, Environment, Line, LineType, Model, Point, Rod, RodType, Section

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4" / "oc4.dat"


def shared(clamped: bool = False) -> Model:
    """Return two coupled bodies, each with an anchor line, and a line between them; or a cable clamped to the second."""
    kind = LineType(name="rope", diameter=0.1, mass_per_length=20.0, axial_stiffness=1e7, bending_stiffness=1e4 if clamped else 0.0)  # fmt: skip
    bodies = tuple(Body(id=k, kind="coupled", position=(x, 0.0, -5.0)) for k, x in ((1, -100.0), (2, 100.0)))
    points = (
        Point(id=1, kind="fixed", position=(-400.0, 0.0, -100.0)),
        Point(id=2, kind="fixed", position=(400.0, 0.0, -100.0)),
        Point(id=3, kind="coupled", position=(-5.0, 3.0, 0.0), body=1),
        Point(id=4, kind="coupled", position=(5.0, 0.0, -2.0), body=1),
        Point(id=5, kind="coupled", position=(-5.0, 0.0, 0.0), body=2),
        Point(id=6, kind="coupled", position=(5.0, 0.0, 0.0), body=2),
    )
    rods = (Rod(id=1, rod_type="clamp", kind="coupled", body=2, end_a=(-5.0, 0.0, 0.0), end_b=(-6.0, 0.0, -0.5), segments=0),) if clamped else ()  # fmt: skip

    def line(id, a, b, length):
        part = (Section(line_type="rope", length=length, segments=20),)
        return Line(id=id, sections=part, end_a=Attachment("point", a), end_b=Attachment("point", b))

    lines = [line(1, 1, 3, 320.0), line(2, 4, 5, 200.0), line(3, 2, 6, 320.0)]
    if clamped:
        lines[1] = dataclasses.replace(lines[1], end_b=Attachment("rod", 1, "B"))
    return Model(
        environment=Environment(water_depth=100.0),
        line_types=(kind,),
        rod_types=(RodType(name="clamp", diameter=0.1, mass_per_length=0.0),),
        bodies=bodies,
        points=points,
        rods=rods,
        lines=tuple(lines),
    )


def loads(model: Model) -> np.ndarray:
    """Force and moment on both bodies at rest, (2, 6), summed from the line ends of a static solution."""
    ds, out = moorage.solve_statics(model), np.zeros((2, 6))
    for p in range(3, 7):
        body = model.point(p).body
        force = ds["point_force"].sel(point=p).values
        arm = ds["point_position"].sel(point=p).values - model.bodies[body - 1].position
        out[body - 1] += [*force, *np.cross(arm, force)]
    return out


@pytest.mark.parametrize(("body", "dof"), [(0, 0), (0, 5), (1, 2), (1, 4)])
def test_stiffness_of_two_platforms_is_the_derivative_of_their_loads(body, dof):
    """Central differences of 1 cm and 1 mrad; their error is second order, some 1e-3 of the largest entry of a row."""
    model = shared()
    ds = moorage.stiffness(model)
    assert ds["platform"].values.tolist() == ["body 1", "body 2"]
    step = 0.01 if dof < 3 else 1e-3
    ends = []
    for sign in (-1.0, 1.0):
        bodies = list(model.bodies)
        name = "position" if dof < 3 else "rotation"
        values = list(getattr(bodies[body], name))
        values[dof % 3] += sign * step
        bodies[body] = dataclasses.replace(bodies[body], **{name: tuple(values)})
        ends.append(loads(dataclasses.replace(model, bodies=tuple(bodies))))
    expected = (ends[0] - ends[1]) / (2.0 * step)
    K = ds["platform_stiffness"].values[:, :, body, dof]
    scale = np.abs(ds["platform_stiffness"].values).max(axis=(2, 3))
    assert np.abs((K - expected) / np.maximum(scale, 1.0)).max() < 3e-3


def test_one_platform_of_points_is_that_of_statics():
    model = moorage.read(EXAMPLE)
    ds = moorage.stiffness(model)
    K = ds["platform_stiffness"].values[0, :, 0]
    np.testing.assert_allclose(
        K, moorage.solve_statics(model)["stiffness"].values, rtol=1e-9, atol=1e-6 * np.abs(K).max()
    )
    assert ds["platform"].values.tolist() == ["coupled points"]


def test_a_clamp_on_one_of_two_platforms():
    """Measured where clamps turn: the blocks between pinned things are nearly those without the bending."""
    K, bent = (moorage.stiffness(shared(clamped))["platform_stiffness"].values for clamped in (False, True))
    assert bent.shape == (2, 6, 2, 6)
    scale = np.abs(K[:, :3, :, :3]).max()
    assert np.abs(bent[:, :3, :, :3] - K[:, :3, :, :3]).max() < 0.05 * scale


def test_modes_of_a_mooring(tmp_path):
    model = moorage.read(EXAMPLE)
    ds = moorage.natural_modes(model, 6)
    f = ds["frequency"].values
    assert (np.diff(f) >= 0.0).all()
    np.testing.assert_allclose(f[:3], f[0], rtol=1e-3)  # three equal lines
    np.testing.assert_allclose(ds["period"].values, 1.0 / f)
    np.testing.assert_allclose(np.sqrt((ds["mode_shape"].values ** 2).sum(axis=2)).max(axis=1), 1.0)
    np.testing.assert_allclose(ds["line_energy"].sum("line").values, 1.0)
    held = ds["point_shape"].sel(point=[1, 4])
    np.testing.assert_array_equal(held.values, 0.0)
    path = tmp_path / "modes.nc"
    outcome = CliRunner().invoke(app, ["modes", str(EXAMPLE), "--number", "2", "--json", "-o", str(path)])
    assert outcome.exit_code == 0, outcome.output
    report = json.loads(outcome.output[outcome.output.index("[") :])
    assert report[0]["frequency"] == pytest.approx(f[0])
    assert moorage.open_result(path)["frequency"].values[1] == pytest.approx(f[1])
    outcome = CliRunner().invoke(app, ["modes", str(EXAMPLE), "-n", "2"])
    assert f"{f[0]:.5f}" in outcome.output


def test_stiffness_on_the_command_line(tmp_path):
    path = tmp_path / "k.nc"
    outcome = CliRunner().invoke(app, ["stiffness", str(EXAMPLE), "--json", "-o", str(path)])
    assert outcome.exit_code == 0, outcome.output
    report = json.loads(outcome.output[outcome.output.index("{") :])
    assert report["dof"][0] == "surge"
    assert report["stiffness"]["coupled points"]["coupled points"][0][0] == pytest.approx(7.2e4, rel=0.01)
    outcome = CliRunner().invoke(app, ["stiffness", str(EXAMPLE)])
    assert "Stiffness of coupled points" in outcome.output


def test_what_has_no_meaning_is_refused(deck):
    with pytest.raises(moorage.InputError, match="number of modes"):
        moorage.natural_modes(moorage.read(EXAMPLE), 0)
    with pytest.raises(moorage.InputError, match="nothing is coupled"):
        moorage.stiffness(
            moorage.read(deck(("2     Coupled ", "2     Fixed   "), ("0.001    dtM       time step\n", "")))
        )
