"""What is timed: OC4-DeepCwind's chains, as many as wanted, moved as one platform; and a lazy-wave power cable."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from moorage.io import write_moordyn
from moorage.model import Attachment, Environment, Line, LineType, Model, Motion, Point, Section

CHAIN = LineType(
    name="chain",
    diameter=0.0766,
    mass_per_length=113.35,
    axial_stiffness=7.536e8,
    axial_damping_ratio=1.0,
    transverse_drag=2.0,
    tangential_drag=0.4,
    transverse_added_mass=0.8,
    tangential_added_mass=0.25,
)
LENGTH, DEPTH, ANCHOR_RADIUS, FAIRLEAD_RADIUS, FAIRLEAD_DEPTH = 835.5, 200.0, 837.6, 40.868, 14.0


def chains(segments: int, lines: int = 3) -> Model:
    """Return chains at evenly spread headings, the first towards -x; points 1..n are anchors, n+1..2n fairleads."""
    headings = np.pi + 2.0 * np.pi * np.arange(lines) / lines
    outward = np.column_stack([np.cos(headings), np.sin(headings), np.zeros(lines)])

    def point(id: int, kind, place: np.ndarray) -> Point:
        x, y, z = place.tolist()
        return Point(id=id, kind=kind, position=(x, y, z))

    sections = (Section(line_type="chain", length=LENGTH, segments=segments),)
    return Model(
        environment=Environment(water_depth=DEPTH),
        line_types=(CHAIN,),
        points=(
            *(point(k, "fixed", ANCHOR_RADIUS * u + (0, 0, -DEPTH)) for k, u in enumerate(outward, 1)),
            *(
                point(k, "coupled", FAIRLEAD_RADIUS * u + (0, 0, -FAIRLEAD_DEPTH))
                for k, u in enumerate(outward, lines + 1)
            ),
        ),
        lines=tuple(
            Line(id=k, sections=sections, end_a=Attachment("point", k), end_b=Attachment("point", lines + k))
            for k in range(1, lines + 1)
        ),
    )


def surge_and_heave(duration: float) -> Motion:
    """Return 5 m in 12 s along x and 2 m in 9 s along z, coming in over 20 s."""
    return Motion.from_harmonics(duration, ramp=20.0, interval=0.05, surge=(5.0, 12.0), heave=(2.0, 9.0))


def lazy_wave() -> Model:
    """Return the prototype's cable: 55 m, 25 m with floats, 57 m in 60 m of water, in segments of 1 m, ends pinned."""
    parts = ("cable", 55.0), ("floats", 25.0), ("cable", 57.0)
    common = {"axial_stiffness": 751e6, "axial_damping_ratio": 1.0, "bending_stiffness": 11.71e3}
    common |= {"transverse_drag": 1.2, "transverse_added_mass": 1.0, "tangential_drag": 0.1}
    return Model(
        environment=Environment(water_depth=60.0, seabed_stiffness=3e6, seabed_damping=3e5),
        line_types=(
            LineType(name="cable", diameter=0.176, mass_per_length=77.3, **common),
            LineType(name="floats", diameter=0.559, mass_per_length=184.5, **common),
        ),
        points=(
            Point(id=1, kind="fixed", position=(105.0, 0.0, -60.0)),
            Point(id=2, kind="coupled", position=(0.0, 0.0, -4.0)),
        ),
        lines=(
            Line(
                id=1,
                sections=tuple(Section(line_type=t, length=x, segments=round(x)) for t, x in parts),
                end_a=Attachment("point", 1),
                end_b=Attachment("point", 2),
            ),
        ),
    )


def swell(duration: float) -> Motion:
    """Return 2 m along x and 3 m along z in 14.5 s, coming in over 20 s."""
    return Motion.from_harmonics(duration, ramp=20.0, interval=0.05, surge=(2.0, 14.5), heave=(3.0, 14.5))


def paths(model: Model, duration: float, interval: float, moved=surge_and_heave) -> tuple[np.ndarray, ...]:
    """Return times (n,) and positions, velocities, accelerations (n, m, 3) of the coupled points, for others."""
    motion = moved(duration + 1.0)
    time = interval * np.arange(round(duration / interval) + 1)
    tracks = [CubicSpline(motion.time, track) for track in motion.resolve(model).values()]
    return time, *(np.stack([track(time, order) for track in tracks], axis=1) for order in range(3))


def write_deck(path: Path, model: Model, *options: str) -> Path:
    """Write a file for MoorDyn-C or CableDyn, with rows of options of theirs."""
    write_moordyn(model, path)
    rows = path.read_text().replace("  rho\n", "  rhoW\n").splitlines()
    at = next(k for k, row in enumerate(rows) if "OPTIONS" in row)
    rows[at + 1 : at + 1] = options
    path.write_text("\n".join(rows) + "\n")
    return path
