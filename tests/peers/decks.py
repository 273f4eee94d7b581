"""Small MoorDyn files that Moorage and its peers all read."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np


class Deck(NamedTuple):
    """A mooring in MoorDyn's words."""

    types: tuple[str, ...]  # name, d, m, EA, BA, EI, Cd, Ca, CdAx, CaAx
    points: tuple[str, ...]  # kind, x, y, z, mass, volume, CdA, Ca
    lines: tuple[str, ...]  # type, point A, point B, length, segments
    depth: float
    current: tuple[str, ...] = ()  # z, u, v, w


CHAIN = "chain 0.0766 113.35 7.536e8 -1.0 0 2.0 0.8 0.4 0.25"
ROPE = "rope 0.15 22.0 9.0e7 -0.8 0 1.2 1.0 0.1 0.0"

CHAINS = Deck(
    (CHAIN,),
    tuple(f"Fixed {837.6 * np.cos(a):.9f} {837.6 * np.sin(a):.9f} -200 0 0 0 0" for a in np.radians([180, 60, -60]))
    + tuple(
        f"Coupled {40.868 * np.cos(a):.9f} {40.868 * np.sin(a):.9f} -14 0 0 0 0" for a in np.radians([180, 60, -60])
    ),
    ("chain 1 4 835.5 20", "chain 2 5 835.5 20", "chain 3 6 835.5 20"),
    200.0,
)

# a mooring leg that splits into two bridles at a buoyant free point
BRIDLE = Deck(
    (CHAIN, ROPE),
    ("Fixed -600 0 -120 0 0 0 0", "Free -60 0 -30 2000 3.0 1.5 0.5", "Coupled -10 15 -8 0 0 0 0",
     "Coupled -10 -15 -8 0 0 0 0"),
    ("chain 1 2 560 28", "rope 2 3 57.8 6", "rope 2 4 57.8 6"),
    120.0,
)  # fmt: skip

# chain on the bed, then rope, joined by a free point without mass
TWO_SECTIONS = Deck(
    (CHAIN, ROPE),
    ("Fixed 1130 0 -850 0 0 0 0", "Free 720 0 -760 0 0 0 0", "Coupled 58 0 -14 0 0 0 0"),
    ("chain 1 2 500 25", "rope 2 3 1000 20"),
    850.0,
)

# a chain across a sheared current
CURRENT = Deck(
    (CHAIN,),
    ("Fixed -837.6 0 -200 0 0 0 0", "Coupled -40.868 0 -14 0 0 0 0"),
    ("chain 1 2 835.5 40",),
    200.0,
    ("-200 0.2 0.3 0", "-60 0.5 0.9 0", "0 0.8 1.4 0"),
)

# a hose between two rails above the water, which it hangs into: it crosses the surface twice
SURFACE = Deck(
    ("hose 0.20 40.0 2.0e7 -0.8 0 1.2 1.0 0.1 0.0",),
    ("Fixed -45 0 6 0 0 0 0", "Coupled 0 0 5 0 0 0 0"),
    ("hose 1 2 60 24",),
    50.0,
)


def write(deck: Deck, folder: Path, **options) -> Path:
    """Write a deck, with options by name, and return its path."""
    given = {"g": 9.80665, "WtrDnsty": 1025.0, "WtrDpth": deck.depth, "kBot": 3e6, "cBot": 3e5, "Currents": int(bool(deck.current)), "writeLog": 0} | options  # fmt: skip
    rows = ["A deck for comparisons", "----- LINE TYPES -----"]
    rows += [
        "TypeName Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx",
        "(name) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)",
    ]
    rows += [
        *deck.types,
        "----- POINTS -----",
        "ID Type X Y Z Mass Volume CdA Ca",
        "(#) (-) (m) (m) (m) (kg) (m3) (m2) (-)",
    ]
    rows += [f"{k} {row}" for k, row in enumerate(deck.points, 1)]
    rows += [
        "----- LINES -----",
        "ID LineType AttachA AttachB UnstrLen NumSegs LineOutputs",
        "(#) (-) (#) (#) (m) (-) (-)",
    ]
    rows += [f"{k} {row} -" for k, row in enumerate(deck.lines, 1)]
    rows += ["----- OPTIONS -----", *(f"{value} {name}" for name, value in given.items()), "----- need this line -----"]
    path = folder / "model.dat"
    path.write_text("\n".join(rows) + "\n")
    if deck.current:
        profile = ["--- steady current ---", "profile", "z (m), ux (m/s), uy (m/s), uz (m/s)", *deck.current]
        (folder / "current_profile.txt").write_text("\n".join(profile) + "\n")
    return path


ROPE_IN_WAVES = Deck(
    ("rope 0.15 30.0 2.0e6 -0.8 0 1.2 1.0 0.1 0.2",),
    ("Fixed -40 10 -50 0 0 0 0", "Coupled 0 0 -6 0 0 0 0"),
    ("rope 1 2 60 15",),
    60.0,
)
