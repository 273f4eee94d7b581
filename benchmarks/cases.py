"""The moorings that are timed: OC4-DeepCwind's chains, as many as wanted, moved as one platform."""

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


def paths(model: Model, duration: float, interval: float) -> tuple[np.ndarray, ...]:
    """Return times (n,) and positions, velocities, accelerations (n, m, 3) of the coupled points, for others."""
    motion = surge_and_heave(duration + 1.0)
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
