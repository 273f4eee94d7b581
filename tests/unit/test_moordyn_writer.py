"""MoorDyn files as written: read back they give the same model, and what cannot be said is returned."""

import dataclasses
import warnings

import numpy as np
import pytest

from moorage.io import convert, read, write_moordyn
from moorage.model import (
    Attachment,
    Bathymetry,
    Body,
    Control,
    Current,
    Curve,
    Environment,
    ExternalLoad,
    Failure,
    Friction,
    Line,
    LineType,
    Model,
    OutputChannel,
    Point,
    Rod,
    RodType,
    Section,
    UnreadWater,
    UnusedOption,
)


@pytest.fixture(autouse=True)
def _no_warnings():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield


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


def point(id, kind, *position, **more):
    return Point(id=id, kind=kind, position=tuple(map(float, position)), **more)


def line(id, *sections, a=1, b=2, **more):
    return Line(
        id=id,
        sections=tuple(Section(line_type=t, length=length, segments=n) for t, length, n in sections),
        end_a=Attachment("point", a),
        end_b=Attachment("point", b),
        **more,
    )


def model(**changes):
    parts = {
        "environment": Environment(water_depth=200.0),
        "line_types": (CHAIN,),
        "points": (point(1, "fixed", -800, 0, -200), point(2, "coupled", -40, 0, -14)),
        "lines": (line(1, ("chain", 835.35, 20), outputs="p"),),
        "title": "a test",
        "flavour": "MoorDyn v2",
    }
    return Model(**parts | changes)


RICH = model(
    environment=Environment(
        water_depth=200.0,
        gravity=9.7,
        friction=Friction(transverse=0.5, axial=0.5, static_ratio=1.3, model="saturated-damping"),
        bathymetry=Bathymetry((-1000.0, 0.0), (0.0, 10.0, 20.0), ((210.0, 211.0, 212.0), (200.0, 201.0, 202.0))),
        current=Current((-100.0, 0.0), ((0.1, 0.2, 0.0), (1.0, 0.0, 0.0))),
    ),
    line_types=(
        dataclasses.replace(CHAIN, lift_coefficient=0.8),
        LineType(
            name="rope",
            diameter=0.1,
            mass_per_length=20.0,
            axial_stiffness=Curve((0.0, 0.1), (0.0, 1e7)),
            axial_damping=Curve((0.0, 1.0), (0.0, 1e5)),
            bending_stiffness=Curve((0.0, 0.1), (0.0, 1e3)),
        ),
        LineType(
            name="polyester",
            diameter=0.1,
            mass_per_length=20.0,
            axial_stiffness=1e8,
            viscoelastic=(2e8, 1.5),
            axial_damping=1e6,
            dynamic_damping=1e5,
            bending_stiffness=1e3,
            bending_damping=1e2,
        ),
    ),
    points=(
        point(1, "fixed", -800, 0, -205),
        point(2, "coupled", -40, 0, -14),
        point(3, "free", 0, 0, -50, mass=10.0, volume=0.1, drag_area=1.0, added_mass=0.5),
        point(4, "fixed", 0, 0, -5, body=2),
    ),
    lines=(
        line(1, ("chain", 835.35, 20)),
        line(2, ("rope", 60.0, 5), a=3, outputs="pt"),
        line(3, ("polyester", 50.0, 5), a=3, b=4),
    ),
    rod_types=(RodType(name="can", diameter=1.0, mass_per_length=100.0, transverse_drag=1.0, end_drag=0.6),),
    rods=(
        Rod(id=1, rod_type="can", kind="pinned", end_a=(0.0, 0.0, -10.0), end_b=(0.0, 0.0, 0.0), segments=3, body=1),
        Rod(id=2, rod_type="can", kind="coupled-pinned", end_a=(0.0, 0.0, -10.0), end_b=(0.0, 1.0, 0.0), segments=0),
    ),
    bodies=(
        Body(
            id=1,
            kind="free",
            position=(1.0, 2.0, -3.0),
            rotation=(0.1, -0.2, 0.3),
            mass=10.0,
            drag_area=(1.0,) * 3 + (2.0,) * 3,
        ),
        Body(
            id=2,
            kind="coupled",
            position=(0.0, 0.0, 0.0),
            inertia=(1.0, 2.0, 3.0),
            added_mass=(1.0, 2.0, 3.0, 0.0, 0.0, 0.0),
        ),
    ),
    failures=(Failure(id=1, attachment=Attachment("point", 3), lines=(2, 3), time=5.0),),
    controls=(Control(channel=2, lines=(1, 2), segment_range=(0.5, 2.0)),),
    external_loads=(ExternalLoad(id=1, target="body", target_id=1, force=(1.0, 2.0, 3.0), local=True),),
    outputs=(OutputChannel(name="FAIRTEN1"), OutputChannel(name="POINT3PX")),
    start="as-given",
    output_interval=0.1,
)


@pytest.mark.parametrize("flavour", ["C", "F"])
@pytest.mark.parametrize("given", [model(), RICH], ids=["plain", "rich"])
def test_round_trip(tmp_path, given, flavour):
    write_moordyn(given, tmp_path / "out.dat", flavour)
    again = read(tmp_path / "out.dat")
    assert dataclasses.replace(again, flavour=given.flavour) == given


def test_sections_become_lines_joined_by_points(tmp_path):
    given = model(
        line_types=(CHAIN, dataclasses.replace(CHAIN, name="rope")),
        lines=(line(1, ("chain", 600.0, 12), ("rope", 200.0, 4), ("chain", 50.0, 2)),),
        outputs=tuple(OutputChannel(name=n) for n in ("FAIRTEN1", "ANCHTEN1", "LINE1N14PX", "LINE1TENB", "L1VX")),
    )
    notes = write_moordyn(given, tmp_path / "out.dat")
    again = read(tmp_path / "out.dat")
    assert "line 1 of 3 sections is now lines 1 to 3, joined by free points" in notes
    assert [(x.end_a.id, x.end_b.id) for x in again.lines] == [(1, 3), (3, 4), (4, 2)]
    assert [x.kind for x in again.points] == ["fixed", "coupled", "free", "free"]
    assert [o.name for o in again.outputs] == ["FAIRTEN3", "ANCHTEN1", "LINE2N2PX", "LINE3TENB", "L1VX"]
    assert all(x.position[2] >= -200.0 for x in again.points)


def test_stiff_sections_are_joined_by_rods(tmp_path):
    cable = dataclasses.replace(CHAIN, bending_stiffness=1e4)
    given = model(
        line_types=(cable,),
        lines=(line(1, ("chain", 600.0, 12), ("chain", 200.0, 4)),),
        failures=(Failure(id=1, attachment=Attachment("point", 2), lines=(1,), time=1.0),),
        controls=(Control(channel=1, lines=(1,)),),
    )
    write_moordyn(given, tmp_path / "out.dat")
    again = read(tmp_path / "out.dat")
    (joint,) = again.rods
    assert (joint.kind, joint.segments) == ("free", 0)
    assert again.lines[0].end_b == Attachment("rod", 1, "A")
    assert again.lines[1].end_a == Attachment("rod", 1, "B")
    assert again.failures[0].lines == (2,)
    assert again.controls[0].lines == (1, 2)


def test_numbers_and_names_are_made_fit(tmp_path):
    given = model(
        line_types=(
            dataclasses.replace(CHAIN, name="my chain", minimum_bend_radius=1.0),
            dataclasses.replace(CHAIN, name="my_chain"),
        ),
        points=(point(7, "fixed", -800, 0, -200, name="anchor"), point(3, "coupled", -40, 0, -14)),
        lines=(line(5, ("My Chain", 835.35, 20), a=7, b=3),),
        outputs=(OutputChannel(name="FAIRTEN5"), OutputChannel(name="CON3FX")),
        external_loads=(ExternalLoad(id=1, target="point", target_id=3, force=(1.0, 0.0, 0.0)),),
        controls=(Control(channel=1, lines=(5,)),),
    )
    notes = write_moordyn(given, tmp_path / "out.dat")
    again = read(tmp_path / "out.dat")
    assert [x.id for x in again.points] == [1, 2]
    assert again.lines[0].sections[0].line_type == again.line_types[0].name != again.line_types[1].name
    assert [o.name for o in again.outputs] == ["FAIRTEN1", "POINT2FX"]
    assert again.external_loads[0].target_id == 2
    assert {
        "numbers must count from 1: line 5 is now 1, point 7 is now 1, point 3 is now 2",
        "channels CON... are now called POINT..., the name that MoorDyn-C knows",
        "line type my chain: minimum bend radius has no place in the file",
        "names have no place in the file: point 1 (anchor)",
        "MoorDyn-C does not read CONTROL",
        "MoorDyn-C does not read EXTERNAL LOADS",
    } <= set(notes)


def test_point_forces(tmp_path):
    given = model(
        points=(point(1, "fixed", -800, 0, -200), point(2, "free", -40, 0, -14, external_force=(1.0, 2.0, 3.0)))
    )
    write_moordyn(given, tmp_path / "c.dat", "C")
    assert read(tmp_path / "c.dat").points == given.points
    assert "constant forces on points are now EXTERNAL LOADS" in write_moordyn(given, tmp_path / "f.dat", "F")
    assert read(tmp_path / "f.dat").external_loads[0].force == (1.0, 2.0, 3.0)


@pytest.mark.parametrize(
    ("flavour", "changes", "note"),
    [
        ("C", {"friction": Friction(transverse=0.5, axial=0.4)}, "MoorDyn-C has one coefficient of friction"),
        ("F", {"current": Current((0.0,), ((1.0, 0.0, 0.1),))}, "vertical currents cannot be said for MoorDyn-F"),
        (
            "F",
            {"unread_water": UnreadWater(option="WaveKin", value="3")},
            "waves by WaveKin cannot be said for MoorDyn-F",
        ),
        (
            "C",
            {"unread_water": UnreadWater(option="WaterKin", value="w.dat")},
            "waves by WaterKin cannot be said for MoorDyn-C",
        ),
        ("C", {"unread_water": UnreadWater(option="WaveKin", value="7")}, "files of WaveKin 7 are named as they were"),
        ("F", {"bathymetry": Bathymetry((0.0,), (0.0,), ((150.0,),))}, "the reference depth has no place"),
    ],
)
def test_what_an_environment_cannot_say(tmp_path, flavour, changes, note):
    given = model(environment=Environment(water_depth=200.0, **changes))
    assert any(note in said for said in write_moordyn(given, tmp_path / "out.dat", flavour))


def test_options_of_the_other_program_are_named(tmp_path):
    options = (UnusedOption(name="CFL", value="0.9", reason=""), UnusedOption(name="inertialF", value="1", reason=""))
    given = model(unused_options=options)
    assert "option inertialF is not one of MoorDyn-C" in write_moordyn(given, tmp_path / "c.dat", "C")
    assert [o.name for o in read(tmp_path / "c.dat").unused_options] == ["CFL"]
    assert "option CFL is not one of MoorDyn-F" in write_moordyn(given, tmp_path / "f.dat", "F")


def test_sections_between_a_body_and_a_rod(tmp_path):
    given = model(
        points=(point(1, "fixed", -100, 0, -200), point(2, "fixed", 1, 0, -5, body=1)),
        bodies=(
            Body(id=1, kind="free", position=(10.0, 0.0, -10.0), drag_area=(1, 2, 3, 4, 5, 6), added_mass=(1.0,) * 6),
        ),
        rod_types=(RodType(name="joint", diameter=1.0, mass_per_length=1.0),),
        rods=(
            Rod(id=1, rod_type="joint", kind="fixed", end_a=(0.0, 0.0, -20.0), end_b=(50.0, 0.0, -20.0), segments=2),
        ),
        lines=(
            Line(
                id=1,
                sections=(Section(line_type="chain", length=10.0, segments=2),) * 2,
                end_a=Attachment("rod", 1, "B"),
                end_b=Attachment("point", 2),
            ),
        ),
        outputs=(OutputChannel(name="ROD1PX"),),
    )
    notes = write_moordyn(given, tmp_path / "out.dat")
    again = read(tmp_path / "out.dat")
    assert again.points[2].position == pytest.approx((30.5, 0.0, -17.5))
    assert again.outputs == given.outputs
    assert "body 1: MoorDyn-C drops the first of several values of CdA" in notes
    assert "body 1: added inertia about the axes cannot be said" in notes


def test_joint_type_takes_a_free_name(tmp_path):
    given = model(
        line_types=(dataclasses.replace(CHAIN, bending_stiffness=1e4),),
        rod_types=(RodType(name="joint", diameter=1.0, mass_per_length=1.0),),
        rods=(
            Rod(id=1, rod_type="joint", kind="fixed", end_a=(0.0, 0.0, -20.0), end_b=(50.0, 0.0, -20.0), segments=2),
        ),
        lines=(line(1, ("chain", 600.0, 12), ("chain", 200.0, 4)),),
    )
    write_moordyn(given, tmp_path / "out.dat")
    again = read(tmp_path / "out.dat")
    assert [t.name for t in again.rod_types] == ["joint", "joint_"]
    assert [r.rod_type for r in again.rods] == ["joint", "joint_"]


def test_syrope_file_is_named(tmp_path):
    (tmp_path / "s.dat").write_text("curves")
    rope = dataclasses.replace(CHAIN, axial_stiffness=0.0, syrope="s.dat", viscoelastic=(1e8, 2.0))
    given = model(line_types=(rope,), lines=(line(1, ("chain", 835.35, 20), syrope_tensions=(2.0, 1.0)),))
    assert any("Syrope" in note for note in write_moordyn(given, tmp_path / "out.dat"))
    assert dataclasses.replace(read(tmp_path / "out.dat")) == given


def test_convert_to_moordyn(tmp_path, deck):
    convert(deck(), tmp_path / "model.yaml")
    assert convert(tmp_path / "model.yaml", tmp_path / "again.dat", "F") == []
    assert read(tmp_path / "again.dat").lines == read(deck()).lines


@pytest.mark.parametrize("flavour", ["C", "F"])
def test_depths_of_numpy_are_numbers(flavour, tmp_path):
    x, y, depth = (
        np.array([-900.0, 0.1]),
        np.array([-5.0, 5.0, 7.0]),
        np.array([[200.0, 201.0, 202.5], [210.0, 211.0, 0.3]]),
    )
    grid = Bathymetry(tuple(x), tuple(y), tuple(map(tuple, depth)))
    write_moordyn(model(environment=Environment(water_depth=201.0, bathymetry=grid)), tmp_path / "model.dat", flavour)
    assert read(tmp_path / "model.dat").environment.bathymetry == grid
