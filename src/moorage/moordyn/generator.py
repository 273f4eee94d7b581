"""Input files put together in a script, as by MoorDyn's `moordyn.Generator`: the same classes and arguments."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from moorage.moordyn.main import Create
from moorage.moordyn.system import System

HEADS = {
    "LINE TYPES": (
        "Name Diam Mass/m EA BA/-zeta EI Cd Ca CdAx CaAx",
        "(-) (m) (kg/m) (N) (N-s/-) (N-m^2) (-) (-) (-) (-)",
    ),
    "ROD TYPES": ("Name Diam Mass/m Cd Ca CdEnd CaEnd", "(-) (m) (kg/m) (-) (-) (-) (-)"),
    "BODIES": (
        "ID Attachment X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*",
        "(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)",
    ),
    "RODS": (
        "ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs",
        "(#) (-) (-) (m) (m) (m) (m) (m) (m) (-) (-)",
    ),
    "POINTS": ("ID Type X Y Z Mass Volume CdA Ca", "(#) (-) (m) (m) (m) (kg) (m^3) (m^2) (-)"),
    "LINES": ("ID LineType AttachA AttachB UnstrLen NumSegs Outputs", "(#) (-) (#) (#) (m) (-) (-)"),
    "FAILURE": ("FailureID Point Lines FailTime FailTen", "(#) (-) (#) (s) (N)"),
    "OPTIONS": (),
}


@dataclass
class LineMaterial:
    """A line type: diameter (m), mass (kg/m), EA (N), BA (N s, or minus a ratio), EI (N m2), coefficients."""

    name: str
    d: float
    w: float
    ea: float
    ba: float
    ei: float
    cdn: float
    can: float
    cdt: float
    cat: float

    def words(self) -> tuple:
        """Return its columns."""
        return self.name, self.d, self.w, self.ea, self.ba, self.ei, self.cdn, self.can, self.cdt, self.cat


@dataclass
class RodMaterial:
    """A rod type: diameter (m), mass (kg/m), and coefficients on side and ends."""

    name: str
    d: float
    w: float
    cdn: float
    can: float
    cdt: float
    cat: float

    def words(self) -> tuple:
        """Return its columns."""
        return self.name, self.d, self.w, self.cdn, self.can, self.cdt, self.cat


@dataclass
class BodyPoint:
    """What holds a body: fixed (the default), or coupled, or neither for a free one."""

    fixed: bool = True
    coupled: bool = False

    def __str__(self) -> str:
        return "Coupled" if self.coupled else "Fixed" if self.fixed else "Free"


class Body:
    """A body at p (m), turned by r (rad), of mass m (kg) and volume v (m3); cda and ca: one value, or several."""

    def __init__(
        self,
        t: BodyPoint | str,
        p: Sequence[float],
        r: Sequence[float],
        m: float,
        cog: float | Sequence[float],
        inertia: float | Sequence[float],
        cda: float | Sequence[float],
        v: float,
        ca: float | Sequence[float] = 0.0,
    ):
        self.name, self.type, self.p, self.r = 0, t, p, r
        self.mass, self.cog, self.I, self.vol, self.cda, self.ca = m, cog, inertia, v, cda, ca

    def words(self) -> tuple:
        """Return its columns."""
        return (
            self.name, self.type, *self.p, *np.degrees(self.r), self.mass, joined(self.cog), joined(self.I), self.vol,
            joined(self.cda), joined(self.ca),
        )  # fmt: skip


@dataclass
class RodPoint:
    """What holds a rod: fixed (the default), pinned, coupled, or a body; none of them for a free one."""

    fixed: bool = True
    pinned: bool = False
    coupled: bool = False
    body: Body | None = None

    def __str__(self) -> str:
        if self.body is not None:
            return f"Body{self.body.name}" + ("Pinned" if self.pinned else "")
        if self.coupled:
            return "CoupledPinned" if self.pinned else "Coupled"
        return "Pinned" if self.pinned else "Fixed" if self.fixed else "Free"


@dataclass
class Rod:
    """A rod of a type from p0 to p1 (m), of n segments."""

    material: RodMaterial
    point: RodPoint | str
    p0: Sequence[float]
    p1: Sequence[float]
    n: int
    name: int = 0

    def words(self) -> tuple:
        """Return its columns."""
        return self.name, self.material.name, self.point, *self.p0, *self.p1, self.n, "-"


class Point:
    """A point: kind t, place p (m), mass m (kg), volume v (m3), CdA (m2), Ca."""

    def __init__(self, t: str, p: Sequence[float], m: float, v: float, cda: float, ca: float):
        self.name, self.type, self.p, self.mass, self.vol, self.cda, self.ca = 0, t, p, m, v, cda, ca

    def words(self) -> tuple:
        """Return its columns."""
        return self.name, self.type, *self.p, self.mass, self.vol, self.cda, self.ca


@dataclass
class LinePoint:
    """What a line end holds on to: a point, or end "A" or "B" of a rod."""

    obj: Point | Rod
    end_point: str = "A"

    def __str__(self) -> str:
        return f"R{self.obj.name}{self.end_point}" if isinstance(self.obj, Rod) else str(self.obj.name)


@dataclass
class Line:
    """A line of a type between two ends, of length l (m), in n segments."""

    material: LineMaterial
    point0: LinePoint
    point1: LinePoint
    l: float
    n: int
    name: int = 0

    def words(self) -> tuple:
        """Return its columns."""
        return self.name, self.material.name, self.point0, self.point1, self.l, self.n, "-"


@dataclass
class Failure:
    """Lines that come off at a time (s) or a tension (N)."""

    point: LinePoint
    lines: Sequence[Line]
    time: float
    ten: float
    name: int = 0

    def words(self) -> tuple:
        """Return its columns."""
        return self.name, self.point, ",".join(str(line.name) for line in self.lines), self.time, self.ten


@dataclass
class Option:
    """An option and its value."""

    name: str
    value: object

    def words(self) -> tuple:
        """Return value and name."""
        return self.value, self.name


@dataclass
class Mooring:
    """A file in the making; things get their numbers in the order in which they are added."""

    sections: dict[str, list] = field(default_factory=lambda: {name: [] for name in HEADS})

    def AddLineMaterial(self, mat: LineMaterial) -> None:
        """Add a line type."""
        self.sections["LINE TYPES"].append(mat)

    def AddRodMaterial(self, mat: RodMaterial) -> None:
        """Add a rod type."""
        self.sections["ROD TYPES"].append(mat)

    def AddBody(self, body: Body) -> None:
        """Add a body."""
        self._number("BODIES", body)

    def AddRod(self, rod: Rod) -> None:
        """Add a rod."""
        self._number("RODS", rod)

    def AddPoint(self, point: Point) -> None:
        """Add a point."""
        self._number("POINTS", point)

    def AddLine(self, line: Line) -> None:
        """Add a line."""
        self._number("LINES", line)

    def AddFailure(self, failure: Failure) -> None:
        """Add a failure."""
        self._number("FAILURE", failure)

    def AddOption(self, option: Option) -> None:
        """Add an option."""
        self.sections["OPTIONS"].append(option)

    def _number(self, section: str, thing) -> None:
        self.sections[section].append(thing)
        thing.name = len(self.sections[section])

    def text(self) -> str:
        """Return the input file."""
        rows = ["--------------------- MoorDyn Input File ---------------------", "made by a script"]
        for name, things in self.sections.items():
            if things:
                rows += [f"---------------------- {name} ----------------------", *HEADS[name]]
                rows += [" ".join(map(str, thing.words())) for thing in things]
        return "\n".join([*rows, "------------------------- end -------------------------", ""])

    def Create(self) -> System:
        """Write the file into a new temporary folder and return its system."""
        path = Path(tempfile.mkdtemp(prefix="moorage-")) / "moordyn.txt"
        path.write_text(self.text())
        return Create(str(path))


def joined(values: float | Sequence[float]) -> str:
    """Return one number, or several with | between them."""
    return "|".join(map(str, values)) if isinstance(values, Iterable) else str(values)
