"""What a mooring is made of, in SI units and the field's words: frozen, without any numerics.

z points up from the still water level; end A of a line is the anchor end, end B the fairlead end.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

from moorage.errors import Source
from moorage.model.plain import keep_plain

PointKind = Literal["fixed", "coupled", "free"]
ObjectKind = Literal["fixed", "coupled", "free", "pinned", "coupled-pinned"]


@dataclass(frozen=True)
class Curve:
    """A table y(x), linear between its rows and continued with the slope of its end intervals.

    `file` is the name that the table had in the input, kept so that a model can be written back.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    file: str = field(default="", compare=False)

    def __post_init__(self) -> None:
        keep_plain(self, "x", "y")


@dataclass(frozen=True, kw_only=True)
class LineType:
    """Properties of a line for each metre of its unstretched length.

    Parameters
    ----------
    diameter : float
        Volume-equivalent diameter, m.
    mass_per_length : float
        Mass in air, kg/m.
    axial_stiffness : float or Curve
        EA, N; or tension (N) against strain (-).
    axial_damping : float or Curve
        BA, N s; or tension (N) against strain rate (1/s). Not used when `axial_damping_ratio` is given.
    axial_damping_ratio : float or None
        Fraction of a segment's critical damping, BA = ratio l sqrt(EA m) (MoorDyn's negative BA).
    bending_stiffness : float or Curve
        EI, N m2; or moment (N m) against curvature (1/m).
    bending_damping : float
        BI, N m2 s (MoorDyn's optional second value of EI).
    transverse_drag, tangential_drag : float
        Cd on d l and CdAx on pi d l, -.
    transverse_added_mass, tangential_added_mass : float
        Ca and CaAx on the displaced mass, -.
    lift_coefficient, viv_range, viv_centre : float
        Cl, dF and cF of the vortex-induced-vibration model, -; zero `lift_coefficient` switches it off.
    minimum_bend_radius : float or None
        Allowed bend radius, m.
    minimum_breaking_load : float or None
        Tension that a new line is sure to bear, N; results tell which part of it is used.
    carries_compression : bool
        Whether a segment pushes when it is shorter than unstretched; MoorDyn's never does, and without bending
        stiffness nothing would keep it straight.
    viscoelastic : tuple of float
        Dynamic stiffness of MoorDyn's viscoelastic models, empty for an elastic line: EA_d (N), or EA_d = c + m T_mean
        as (c in N, m).
    dynamic_damping : float
        Damping in series with the dynamic stiffness, N s.
    syrope : str
        Name of the Syrope working-curve file, empty for none.
    """

    name: str
    diameter: float
    mass_per_length: float
    axial_stiffness: float | Curve
    axial_damping: float | Curve = 0.0
    axial_damping_ratio: float | None = None
    bending_stiffness: float | Curve = 0.0
    bending_damping: float = 0.0
    transverse_drag: float = 0.0
    tangential_drag: float = 0.0
    transverse_added_mass: float = 0.0
    tangential_added_mass: float = 0.0
    lift_coefficient: float = 0.0
    viv_range: float = 0.08
    viv_centre: float = 0.18
    minimum_bend_radius: float | None = None
    minimum_breaking_load: float | None = None
    carries_compression: bool = False
    viscoelastic: tuple[float, ...] = ()
    dynamic_damping: float = 0.0
    syrope: str = ""
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class RodType:
    """Properties of a rod: diameter (m), mass (kg/m), and coefficients on side and ends (-)."""

    name: str
    diameter: float
    mass_per_length: float
    transverse_drag: float = 0.0
    transverse_added_mass: float = 0.0
    end_drag: float = 0.0
    end_added_mass: float = 0.0
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class BuoyancyModules:
    """Discrete modules on a section, smeared over its segments: one every `pitch` m.

    `diameter` (outer, m), `length` (m), `mass` (kg) of one module; its net volume is the sleeve around the line.
    """

    diameter: float
    length: float
    mass: float
    pitch: float
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class Section:
    """A stretch of line of one type: unstretched length (m) cut into segments.

    Segments are equal, or grow geometrically from end A to end B to `grading` times the length of the first.
    """

    line_type: str
    length: float
    segments: int
    grading: float = 1.0
    modules: BuoyancyModules | None = None
    source: Source | None = field(default=None, compare=False, repr=False)

    @property
    def segment_lengths(self) -> tuple[float, ...]:
        """Unstretched lengths of the segments from end A to end B, m."""
        n = self.segments
        parts = [self.grading ** (k / (n - 1)) for k in range(n)] if n > 1 else [1.0]
        return tuple(self.length * part / sum(parts) for part in parts)


@dataclass(frozen=True, kw_only=True)
class BendStiffener:
    """A tapered sleeve around one end of a line; it adds bending stiffness, mass, volume and drag.

    Parameters
    ----------
    end : {"A", "B"}
        The end of the line at which it sits, root first.
    length : float
        m along the line from the root.
    root_diameter, tip_diameter : float
        Outer diameters, m; the taper is linear.
    youngs_modulus : float
        Of the sleeve, Pa: EI grows by E pi / 64 (D^4 - d^4). Not used when `stiffness` is given.
    density : float
        Of the sleeve, kg/m3: mass grows by density pi / 4 (D^2 - d^2), d the line's diameter.
    stiffness : Curve or None
        Added EI (N m2) against the distance from the root (m).
    """

    end: Literal["A", "B"]
    length: float
    root_diameter: float
    tip_diameter: float
    youngs_modulus: float = 0.0
    density: float = 0.0
    stiffness: Curve | None = None
    source: Source | None = field(default=None, compare=False, repr=False)

    def diameter(self, distance: float) -> float:
        """Outer diameter (m) at a distance from the root (m)."""
        return self.root_diameter + (self.tip_diameter - self.root_diameter) * distance / self.length


@dataclass(frozen=True)
class Attachment:
    """What a line end holds on to: a point, or end A or B of a rod."""

    kind: Literal["point", "rod"]
    id: int
    end: Literal["A", "B", ""] = ""

    def __str__(self) -> str:
        return f"point {self.id}" if self.kind == "point" else f"end {self.end} of rod {self.id}"


@dataclass(frozen=True, kw_only=True)
class Line:
    """A line of one or more sections, listed from end A to end B.

    `outputs` holds MoorDyn's letters of the LineOutputs column ("" for none), `syrope_tensions` the highest and the
    present mean tension (N) that a Syrope line starts from. `end_a_stiffness` and
    `end_b_stiffness` are the rotational stiffness (N m/rad) with which a rod holds an end of a line with bending
    stiffness: None clamps, 0 pins.
    """

    id: int
    sections: tuple[Section, ...]
    end_a: Attachment
    end_b: Attachment
    name: str = ""
    outputs: str = ""
    syrope_tensions: tuple[float, float] | None = None
    stiffeners: tuple[BendStiffener, ...] = ()
    end_a_stiffness: float | None = None
    end_b_stiffness: float | None = None
    source: Source | None = field(default=None, compare=False, repr=False)

    @property
    def length(self) -> float:
        """Unstretched length, m."""
        return sum(section.length for section in self.sections)

    @property
    def segments(self) -> int:
        """Number of segments."""
        return sum(section.segments for section in self.sections)


@dataclass(frozen=True, kw_only=True)
class Point:
    """A point where lines meet, or end.

    Parameters
    ----------
    kind : {"fixed", "coupled", "free"}
        Held in place, moved by prescribed motion, or moved by the forces on it.
    position : tuple of float
        x, y, z in m: global, or relative to `body` or to the platform of `turbine` when one is given.
    mass, volume : float
        kg and m3.
    drag_area : float
        CdA, m2, the same in all directions.
    added_mass : float
        Ca on the displaced mass, -.
    external_force : tuple of float
        A constant force, N (MoorDyn v1's FX, FY, FZ).
    body : int or None
        The body that carries the point (`kind` is then that of the body).
    turbine : int or None
        The FAST.Farm turbine that the point is coupled to.
    on_seabed : bool
        Put z on the seabed (z = seabed in native files).
    """

    id: int
    kind: PointKind
    position: tuple[float, float, float]
    mass: float = 0.0
    volume: float = 0.0
    drag_area: float = 0.0
    added_mass: float = 0.0
    external_force: tuple[float, float, float] = (0.0, 0.0, 0.0)
    body: int | None = None
    turbine: int | None = None
    on_seabed: bool = False
    name: str = ""
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class Rod:
    """A rigid cylinder from end A to end B (m), of `segments` segments.

    With 0 segments it has no length: a clamp at end A that points towards `end_b`. MoorDyn's pages call those columns a
    direction, its sources (Body::addRod in C, Rod_Setup in F) take the difference of coordinates; so do we.
    """

    id: int
    rod_type: str
    kind: ObjectKind
    end_a: tuple[float, float, float]
    end_b: tuple[float, float, float]
    segments: int
    body: int | None = None
    turbine: int | None = None
    outputs: str = ""
    name: str = ""
    source: Source | None = field(default=None, compare=False, repr=False)

    @property
    def direction(self) -> tuple[float, float, float]:
        """Unit vector from end A towards end B, in the axes in which the rod is described; zero for a joint."""
        a, b = self.end_a, self.end_b
        size = math.dist(a, b) or 1.0
        return (b[0] - a[0]) / size, (b[1] - a[1]) / size, (b[2] - a[2]) / size


@dataclass(frozen=True, kw_only=True)
class Body:
    """A rigid body: position (m), intrinsic XYZ Euler angles (rad), mass properties and drag.

    `inertia` holds the diagonal about the centre of gravity (kg m2), `drag_area` CdA of six components
    (m2 and m5), `added_mass` Ca of six components (-).
    """

    id: int
    kind: ObjectKind
    position: tuple[float, float, float]
    rotation: tuple[float, float, float] = (0.0, 0.0, 0.0)
    mass: float = 0.0
    centre_of_gravity: tuple[float, float, float] = (0.0, 0.0, 0.0)
    inertia: tuple[float, float, float] = (0.0, 0.0, 0.0)
    volume: float = 0.0
    drag_area: tuple[float, ...] = (0.0,) * 6
    added_mass: tuple[float, ...] = (0.0,) * 6
    turbine: int | None = None
    name: str = ""
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class Failure:
    """Lines that come off a point or rod end at a time (s) or at a tension (N); zero means never."""

    id: int
    attachment: Attachment
    lines: tuple[int, ...]
    time: float = 0.0
    tension: float = 0.0
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class Control:
    """A winch at one end of each of some lines, whose unstretched length follows a control channel.

    Parameters
    ----------
    end : {"A", "B"}
        The end at which line comes out of the winch.
    length : Curve or None
        Line paid out (m, negative: hauled in) over time (s): a smooth curve through the rows that never overshoots;
        constant before and after.
    rate : float, Curve or None
        Its rate (m/s) over time (s) instead: linear between the rows, constant before and after.
    segment_range : tuple of float
        The segment at the winch is cut in two when it is longer than the second of these times a segment as described,
        and joined with the next when it is shorter than the first.
    """

    channel: int
    lines: tuple[int, ...]
    end: Literal["A", "B"] = "B"
    length: Curve | None = None
    rate: float | Curve | None = None
    segment_range: tuple[float, ...] = (0.05, 1.1)
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class ExternalLoad:
    """A constant force (N) with linear (N s/m) and quadratic (N s2/m2) damping on a body, rod or point."""

    id: int
    target: Literal["body", "rod", "point"]
    target_id: int
    force: tuple[float, float, float] = (0.0, 0.0, 0.0)
    linear_damping: tuple[float, ...] = (0.0, 0.0, 0.0)
    quadratic_damping: tuple[float, ...] = (0.0, 0.0, 0.0)
    local: bool = False
    source: Source | None = field(default=None, compare=False, repr=False)
