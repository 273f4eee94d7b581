"""What is wrong with rods and bodies is said by name, with place and remedy, before anything is computed."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from floats import AIR, SPAR, WATER, body, floating, rod
from moorings import fixed, held, kind, line

from moorage.accept import accept
from moorage.errors import ModelError, ModelWarning, Source
from moorage.io import read
from moorage.model import Attachment, ExternalLoad, Failure, Model, Point, RodType
from moorage.model.checks import check
from moorage.model.inertia import lent_inertia, objects_have_inertia

AT = Source("model.dat", 12)
WEIGHTLESS = RodType(name="spar", diameter=0.4, mass_per_length=0.0)
NOTHING = {"mass": 0.0, "inertia": (0.0, 0.0, 0.0), "source": AT}
ENDS = (0.0, 0.0, -5.0), (1.0, 0.0, -8.0)


def on(id: int, *arm: float, **properties) -> Point:
    return Point(id=id, kind="fixed", position=arm, body=1, **properties)  # type: ignore[arg-type]


def tied(model: Model, end: Attachment) -> Model:
    """The model with a line from a fixed point to an end, where half a segment weighs 10 kg."""
    return dataclasses.replace(
        model,
        line_types=(kind(mass_per_length=4.0),),
        points=(*model.points, fixed(9, 0.0, 0.0, -60.0)),
        lines=(line(1, 9, end, ("rope", 15.0, 3)),),
    )


LACKING = {
    "a body of nothing": (floating((body(**NOTHING),)), "body 1 is free, and can move without mass along x, y and z"),
    "a body whose water goes with it one way": (
        floating((body(**NOTHING | {"volume": 1.0, "added_mass": (1, 0, 0, 1, 1, 1)}),)), "move without mass along y and z"),
    "a pinned body of nothing": (floating((body(kind="pinned", **NOTHING),)), "body 1 is pinned, and can turn"),
    "a pinned rod without mass": (
        floating(rods=(rod(1, "pinned", *ENDS, source=AT),), types=WEIGHTLESS), "rod 1 is pinned, and can turn without inertia"),
    "a free rod without mass": (
        floating(rods=(rod(1, "free", *ENDS, source=AT),), types=WEIGHTLESS), "rod 1 is free, and can move without mass"),
}  # fmt: skip


@pytest.mark.parametrize("name", LACKING)
def test_what_moves_has_mass(name):
    model, message = LACKING[name]
    with pytest.raises(ModelError) as caught:
        accept(model)
    assert str(caught.value).startswith("model.dat:12: ")
    assert message in str(caught.value)
    assert "or hold it (fixed, coupled)" in str(caught.value)
    assert len(caught.value.problems) == 1


BALL = 0.4 * 10.0 * (0.75 * 10.0 / (1000.0 * np.pi)) ** (2.0 / 3.0)  # of 10 kg of water, kg m2
LENT = {
    "a mass that is a point": (
        floating((body(**NOTHING | {"mass": 10.0}),)), "body 1 is free, and can turn without inertia about x, y and z", (1, 1, 1)),
    "inertia about two axes": (
        floating((body(**NOTHING | {"mass": 10.0, "inertia": (1.0, 0.0, 2.0)}),)), "turn without inertia about y of the body",
        (0, 1, 0)),
    "two points on an axis": (
        floating((body(**NOTHING),), points=(on(1, 0.0, -10.0, 2.0, mass=5.0), on(2, 0.0, -10.0, -2.0, mass=5.0))),
        "turn without inertia about z of the body", (0, 0, 1)),
    "a pinned body": (
        floating((body(kind="pinned", **NOTHING | {"mass": 10.0}),)), "body 1 is pinned, and can turn", (1, 1, 1)),
    "mass on the axis of a pinned body": (
        floating((body(kind="coupled-pinned", **NOTHING | {"mass": 10.0, "centre_of_gravity": (0.0, 0.0, 1.0)}),)),
        "body 1 is coupled-pinned, and can turn without inertia about z of the body", (0, 0, 1)),
    "a body that only water goes with": (
        floating((body(**NOTHING | {"volume": 0.01, "added_mass": (1, 1, 1, 0, 0, 0)}),), environment={"water_density": 1000.0, "water_depth": 100.0}),
        "turn without inertia about x, y and z", (1, 1, 1)),
    "a free rod without mass on one line": (
        tied(floating(rods=(rod(1, "free", *ENDS, source=AT),), types=WEIGHTLESS), Attachment("rod", 1, "A")),
        "rod 1 is free, and can turn without inertia about y and z of the rod", (0, 1, 1)),
    "a pinned rod without mass, its line at the pin": (
        tied(floating(rods=(rod(1, "pinned", *ENDS, source=AT),), types=WEIGHTLESS), Attachment("rod", 1, "A")),
        "rod 1 is pinned, and can turn without inertia", (0, 1, 1)),
}  # fmt: skip


@pytest.mark.parametrize("name", LENT)
def test_axes_without_inertia_are_lent_some(name):
    """The warning names body, axis, what is lent and the cure; 10 kg move in all cases."""
    model, message, axes = LENT[name]
    with pytest.warns(ModelWarning) as caught:
        accept(model)
    (text,) = (str(warning.message) for warning in caught if "inertia" in str(warning.message))
    assert text.startswith("model.dat:12: ")
    assert message in text
    assert f"it is lent {BALL:.2g} kg m2 there" in text
    assert "give it inertia (I) there" in text
    (thing,) = (*model.bodies, *model.rods)
    np.testing.assert_allclose(lent_inertia(model, thing), np.diag(axes) * BALL, atol=1e-9)


HELD = {
    "a fixed body of nothing": floating((body(kind="fixed", **NOTHING),)),
    "a coupled body of nothing": floating((body(kind="coupled", **NOTHING),)),
    "a body of points": floating(
        (body(**NOTHING),), points=(on(1, 1.0, 0.0, 0.0, mass=1.0), on(2, 0.0, 1.0, 0.0, mass=1.0), on(3, 0.0, 0.0, 1.0, mass=1.0))
    ),
    "a body of a rod": floating((body(**NOTHING),), (rod(1, "fixed", *ENDS, body=1),)),
    "a body of added inertia": floating((body(**NOTHING | {"mass": 1.0, "volume": 1.0, "added_mass": (0, 0, 0, 1, 1, 1)}),)),
    "a rod": floating(rods=(rod(1, "free", *ENDS), rod(2, "pinned", *ENDS))),
    "a pinned rod that water goes with": floating(
        rods=(rod(1, "pinned", *ENDS),), types=dataclasses.replace(WEIGHTLESS, transverse_added_mass=1.0), environment=WATER
    ),
    "a pinned rod without mass that a line holds": tied(
        floating(rods=(rod(1, "pinned", *ENDS),), types=WEIGHTLESS, environment=AIR), Attachment("rod", 1, "B")
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", HELD)
def test_what_has_inertia_is_let_pass(name):
    accept(HELD[name])


def test_lack_of_inertia_is_not_judged_where_names_are_wrong():
    model = tied(floating(rods=(rod(1, "pinned", *ENDS, type="unknown"),)), Attachment("rod", 1, "B"))
    assert list(objects_have_inertia(model)) == []
    with pytest.raises(ModelError, match="type of rod 1 is not described"):
        check(model)


def test_ends_that_coincide():
    model = floating(rods=(rod(3, "free", ENDS[0], ENDS[0], 2, source=AT),))
    with pytest.raises(ModelError) as caught:
        check(model)
    assert str(caught.value) == (
        "model.dat:12: ends of rod 3 coincide, but it has 2 segments\n    -> give 0 segments for a rod without length"
    )


def test_failure_of_a_line_that_is_not_there():
    stick = rod(1, "free", *ENDS)
    model = tied(floating(rods=(stick,)), held(stick, "A"))
    with pytest.raises(ModelError, match=r"failure 1 names line 4, which is not described\n.*the only line is 1"):
        check(dataclasses.replace(model, failures=(Failure(id=1, attachment=held(stick, "A"), lines=(4,), time=1.0),)))
    with pytest.raises(ModelError, match=r"failure 1: line 1 is not tied to end B of rod 1"):
        check(dataclasses.replace(model, failures=(Failure(id=1, attachment=held(stick, "B"), lines=(1,), time=1.0),)))


BODIES = """\
---------------------- BODIES --------------------------------
ID  Attachment  X0  Y0  Z0   r0  p0  y0  Mass  CG  I    Volume  CdA  Ca
(#) (word)      (m) (m) (m)  (-) (-) (-) (kg)  (m) (-)  (m3)    (m2) (-)
1   Body1       0   0   -50  0   0   0   100   0   50   0       0    0
"""


def test_a_body_that_carries_itself(deck):
    heading = "---------------------- POINTS"
    with pytest.raises(ModelError) as caught:
        read(deck((heading, BODIES + heading)))
    assert "model.dat:10: bodies do not ride on bodies, not on others and not on themselves" in str(caught.value)
    assert "(read: 'Body1')\n    -> tie them with lines, or write Fixed, Coupled" in str(caught.value)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"drag_area": (1.0,) * 5}, "model.dat:12: drag area of body 1 has 5 values (read: (1.0, 1.0, 1.0, 1.0, 1.0))"),
        ({"added_mass": (1.0,) * 3}, "added mass of body 1 has 3 values"),
        ({"inertia": (1.0, 1.0)}, "inertia of body 1 has 2 values (read: (1.0, 1.0))\n    -> give 3"),
    ],
)
def test_bodies_have_six_components(values, message):
    with pytest.raises(ModelError) as caught:
        check(floating((body(source=AT, **values),)))
    assert message in str(caught.value)


def test_dampings_of_loads_are_one_or_three():
    load = ExternalLoad(id=4, target="body", target_id=1, linear_damping=(1.0, 2.0, 3.0, 4.0))
    with pytest.raises(ModelError, match=r"linear damping of external load 4 has 4 values.*\n.*give 1 or 3"):
        check(dataclasses.replace(floating((body(),)), external_loads=(load,)))


def test_the_good_model_passes():
    check(floating((body(),), (rod(1, "fixed", *ENDS, body=1),), SPAR))
