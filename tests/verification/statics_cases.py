"""Random lines for the robustness of statics, one a number: any of them can be made again from it."""

from __future__ import annotations

import numpy as np
from moorings import CHAIN, DENSITY, coupled, fixed, free, kind, line, mooring

from moorage.model import LineType, Model

DEPTH = 100.0
KINDS = ("heap", "taut", "vertical", "grounded", "above the bed", "buoyant", "clump", "float", "sections", "upwards")


def random_type(random, name: str, buoyant: bool = False) -> LineType:
    """A chain, wire or fibre rope of 2 to 40 cm, its weight in water between 5 % and 7 times its displacement."""
    diameter = float(np.exp(random.uniform(np.log(0.02), np.log(0.4))))
    displaced = DENSITY * np.pi / 4.0 * diameter**2
    share = random.uniform(0.3, 0.95) if buoyant else 1.0 + float(np.exp(random.uniform(np.log(0.05), np.log(7.0))))
    stiffness = np.exp(random.uniform(np.log(2e8), np.log(1e11))) * diameter**2
    return kind(name, diameter=diameter, mass_per_length=share * displaced, axial_stiffness=float(stiffness))


def random_line(number: int) -> tuple[str, Model]:
    """What kind of line it is, and its model."""
    random = np.random.default_rng(number)
    what = KINDS[number % len(KINDS)]
    rope = random_type(random, "rope", what == "buoyant")
    n = int(random.integers(1, 60))
    span = float(random.uniform(5.0, 400.0))
    heading = random.uniform(0.0, 2.0 * np.pi)
    east, north = np.cos(heading), np.sin(heading)
    low = -DEPTH if what not in ("above the bed", "upwards") else -float(random.uniform(20.0, 60.0))
    high = -float(random.uniform(1.0, 60.0))
    if what == "vertical":
        span = 0.0
    if what == "grounded":
        high = -DEPTH + float(random.uniform(0.0, 1.0))
    if what == "upwards":
        low, high = high, -DEPTH
    chord = float(np.hypot(span, high - low))
    length = chord * float(random.uniform(1.0, 1.3))
    if what == "heap":
        length = (span + abs(high - low)) * float(random.uniform(1.01, 2.0))
    if what in ("taut", "vertical"):
        length = chord * float(random.uniform(0.97, 1.02))
    a, b = fixed(1, 0.0, 0.0, low), coupled(2, span * east, span * north, high)
    if what in ("clump", "float"):
        volume = float(random.uniform(0.1, 20.0))
        density = random.uniform(2000.0, 7000.0) if what == "clump" else random.uniform(50.0, 800.0)
        s = float(random.uniform(0.2, 0.8))
        middle = free(
            3, s * span * east, s * span * north, low + s * (high - low), mass=float(density * volume), volume=volume
        )
        n1 = max(1, n // 2)
        lines = line(1, 1, 3, ("rope", s * length, n1)), line(2, 3, 2, ("rope", (1.0 - s) * length, max(1, n - n1)))
        return what, mooring(rope, (a, middle, b), lines, water_depth=DEPTH)
    if what == "sections":
        other = random_type(random, "other")
        s = float(random.uniform(0.1, 0.9))
        parts = (
            ("rope", s * length, max(1, n // 2)),
            ("other", 0.5 * (1.0 - s) * length, 4),
            ("chain", 0.5 * (1.0 - s) * length, 3),
        )
        return what, mooring((rope, other, CHAIN), (a, b), (line(1, 1, 2, *parts),), water_depth=DEPTH)
    return what, mooring(rope, (a, b), (line(1, 1, 2, ("rope", length, n)),), water_depth=DEPTH)
