"""Features whose physics is not built are refused by name, with file and line, all at once."""

import dataclasses

import pytest

from moorage.errors import Source, UnsupportedError
from moorage.io import read
from moorage.model import (
    Attachment,
    BendStiffener,
    Control,
    Curve,
    ExternalLoad,
    Rod,
    UnreadWater,
)  # fmt: skip
from moorage.model.unbuilt import UNBUILT, refuse_unbuilt, unbuilt

AT = Source("model.dat", 7)


def test_a_plain_model_is_built(deck):
    model = read(deck())
    assert unbuilt(model) == []
    refuse_unbuilt(model)


def _with_type(**changes):
    return lambda m: dataclasses.replace(m, line_types=(dataclasses.replace(m.line_types[0], source=AT, **changes),))


def _with(**changes):
    return lambda m: dataclasses.replace(m, **changes)


def _around(**changes):
    return lambda m: dataclasses.replace(m, environment=dataclasses.replace(m.environment, **changes))


STIFFENER = BendStiffener(end="B", length=2.0, root_diameter=0.5, tip_diameter=0.3, youngs_modulus=1e8)
PLACE = ((0.0, 0.0, -1.0), (0.0, 0.0, -2.0))
CASES = {
    "damping along a rod of no length is": lambda m: dataclasses.replace(
        m,
        rods=(Rod(id=1, rod_type="r", kind="free", end_a=PLACE[0], end_b=PLACE[1], segments=0, source=AT),),
        external_loads=(
            ExternalLoad(id=1, target="rod", target_id=1, local=True, linear_damping=(1.0, 1.0, 2.0), source=AT),
        ),
    ),
    "load 1: damping along a rod of no length is": lambda m: dataclasses.replace(
        m,
        rods=(Rod(id=1, rod_type="r", kind="coupled", end_a=PLACE[0], end_b=PLACE[1], segments=0, source=AT),),
        external_loads=(
            ExternalLoad(id=1, target="rod", target_id=1, local=True, linear_damping=(1.0, 2.0), source=AT),
        ),
    ),
    "damping along a rod that is fixed to a body is": lambda m: dataclasses.replace(
        m,
        rods=(Rod(id=1, rod_type="r", kind="fixed", body=1, end_a=PLACE[0], end_b=PLACE[1], segments=2, source=AT),),
        external_loads=(
            ExternalLoad(id=1, target="rod", target_id=1, local=True, linear_damping=(1.0, 2.0), source=AT),
        ),
    ),
    "viscoelastic lines are": _with_type(viscoelastic=(1e8,)),
    "damping in bending is": _with_type(bending_stiffness=1e4, bending_damping=1e2),
    "the Syrope model is": _with_type(syrope="s.dat", viscoelastic=(1e8, 1.0)),
    "vortex-induced vibration is": _with_type(lift_coefficient=0.8),
    "waves of WaveKin 6 are": _around(unread_water=UnreadWater(option="WaveKin", value="6", source=AT)),
    "currents of Currents 4 are": _around(unread_water=UnreadWater(option="Currents", value="4", source=AT)),
    "where a bend stiffener is, is": lambda m: dataclasses.replace(
        m,
        lines=(dataclasses.replace(m.lines[0], stiffeners=(STIFFENER,)), *m.lines[1:]),
        controls=(Control(channel=1, lines=(1,), source=AT),),
    ),
    "with a table of EI is": lambda m: dataclasses.replace(
        _with_type(bending_stiffness=Curve((0.0, 0.1), (0.0, 1e3)))(m),
        controls=(Control(channel=1, lines=(1,), source=AT),),
    ),
    "on a joint of cables, is": lambda m: dataclasses.replace(
        m,
        rods=(Rod(id=1, rod_type="r", kind="free", end_a=PLACE[0], end_b=PLACE[1], segments=0),),
        lines=(dataclasses.replace(m.lines[0], end_b=Attachment("rod", 1, "A")), *m.lines[1:]),
        controls=(Control(channel=1, lines=(1,), source=AT),),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_refused(deck, name):
    with pytest.raises(UnsupportedError, match=f"model.dat:7: .*{name} not simulated yet"):
        refuse_unbuilt(CASES[name](read(deck())))


def test_all_are_named_together(deck):
    model = read(deck())
    for change in CASES.values():
        model = change(model)
    with pytest.raises(UnsupportedError) as caught:
        refuse_unbuilt(model)
    assert len(caught.value.problems) >= len(UNBUILT) - 3  # types, rods and seas replace each other here
