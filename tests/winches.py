"""Lines on winches that several tests run: a load that hangs on a rope, and a chain to an anchor."""

from __future__ import annotations

import numpy as np

from moorage.model import Attachment, Control, Curve, Environment, Line, LineType, Model, Point, Section

GRAVITY = 9.80665
DRY = Environment(water_depth=500.0, water_density=1e-9)  # no water: nothing but weight and inertia


def smooth_rate(speed: float, ramp: float = 6.0, stop: float | None = None, rows: int = 401) -> Curve:
    """Return a rate that rises to `speed` (m/s) along a cosine in `ramp` s, and comes back before `stop` (s)."""
    t = np.linspace(0.0, ramp, rows)
    r = 0.5 * speed * (1.0 - np.cos(np.pi * t / ramp))
    if stop is not None:
        t, r = np.concatenate([t, stop - t[::-1]]), np.concatenate([r, r[::-1]])
    return Curve(tuple(t.tolist()), tuple(r.tolist()))


def winch(rate: float | Curve | None = None, **more) -> Control:
    return Control(channel=1, lines=(1,), rate=rate, **more)


def load_on_rope(control: Control | None, length=100.0, segments=10, place=(0.0, 0.0, -100.0), load=1000.0, **rope):
    """A load (kg) at end A of a rope whose end B is at the origin."""
    kind = {"diameter": 1e-4, "mass_per_length": 10.0, "axial_stiffness": 1e7, "axial_damping_ratio": 0.2} | rope
    return Model(
        environment=DRY,
        line_types=(LineType(name="rope", **kind),),
        points=(
            Point(id=1, kind="free", position=place, mass=load),
            Point(id=2, kind="fixed", position=(0.0, 0.0, 0.0)),
        ),
        lines=(
            Line(
                id=1,
                end_a=Attachment("point", 1),
                end_b=Attachment("point", 2),
                sections=(Section(line_type="rope", length=length, segments=segments),),
            ),
        ),
        controls=(control,) if control else (),
    )


def chain_to_anchor(control: Control | None, length=210.0, segments=21, turned=False, **chain) -> Model:
    """A chain from an anchor 100 m deep to a coupled point 150 m off; `turned`: its ends are exchanged."""
    kind = {
        "diameter": 0.1,
        "mass_per_length": 100.0,
        "axial_stiffness": 5e8,
        "axial_damping_ratio": 0.3,
        "transverse_drag": 1.2,
        "tangential_drag": 0.1,
        "transverse_added_mass": 1.0,
    } | chain
    a, b = (2, 1) if turned else (1, 2)
    return Model(
        environment=Environment(water_depth=100.0, seabed_stiffness=1e5, seabed_damping=1e4),
        line_types=(LineType(name="chain", **kind),),
        points=(
            Point(id=1, kind="fixed", position=(0.0, 0.0, -100.0)),
            Point(id=2, kind="coupled", position=(150.0, 0.0, 0.0)),
        ),
        lines=(
            Line(
                id=1,
                end_a=Attachment("point", a),
                end_b=Attachment("point", b),
                sections=(Section(line_type="chain", length=length, segments=segments),),
            ),
        ),
        controls=(control,) if control else (),
    )
