"""Water, seabed, current and waves: what surrounds the mooring."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from moorage.errors import Source
from moorage.model.components import Curve
from moorage.model.current_grid import CurrentGrid
from moorage.model.depths import bicubic, bilinear
from moorage.model.plain import keep_plain
from moorage.model.waves import Waves


@dataclass(frozen=True, kw_only=True)
class Resampling:
    """What was lost when a raster was read onto a depth grid, at the centres of the cells that the grid covers.

    Parameters
    ----------
    spacing : float
        Of the grid, m.
    cells : int
        Number of cells.
    largest, rms : float
        Differences of the depth, m.
    """

    spacing: float
    cells: int
    largest: float
    rms: float

    def __str__(self) -> str:
        return (
            f"resampled to {self.spacing:g} m: {self.cells} cells of the raster differ by at most "
            f"{self.largest:.2g} m, rms {self.rms:.2g} m"
        )


@dataclass(frozen=True)
class Bathymetry:
    """A rectangular grid of water depths: x (nx,) m, y (ny,) m, depth (nx, ny) m, positive down.

    Between its points the seabed is bilinear, as in MoorDyn, or with `smooth` bicubic, with a continuous normal.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    depth: tuple[tuple[float, ...], ...]
    smooth: bool = False
    file: str = field(default="", compare=False)
    source: Source | None = field(default=None, compare=False, repr=False)
    resampling: Resampling | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        keep_plain(self, "x", "y", "depth")

    def depth_at(self, x: float, y: float) -> float:
        """Return the depth (m) at a place, on the nearest edge outside."""
        return (bicubic if self.smooth else bilinear)(self.x, self.y, self.depth, x, y)


@dataclass(frozen=True)
class FrictionMap:
    """Kinetic coefficients on a rectangular grid: x (nx,) m, y (ny,) m, axial and transverse (nx, ny), -.

    Bilinear between its points; outside the nearest edge goes on.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    axial: tuple[tuple[float, ...], ...]
    transverse: tuple[tuple[float, ...], ...]
    source: Source | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        keep_plain(self, "x", "y", "axial", "transverse")


@dataclass(frozen=True)
class StiffnessMap:
    """Stiffness of the seabed on a rectangular grid: x (nx,) m, y (ny,) m, stiffness (nx, ny) Pa/m.

    Bilinear between its points; outside the nearest edge goes on.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    stiffness: tuple[tuple[float, ...], ...]
    source: Source | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        keep_plain(self, "x", "y", "stiffness")


@dataclass(frozen=True, kw_only=True)
class Friction:
    """Friction of the seabed.

    Parameters
    ----------
    transverse, axial : float
        Kinetic coefficients across and along the line, -.
    static_ratio : float
        Static over kinetic coefficient, -.
    model : str
        "elastic-slip" (sticks; the default of native files), "stick-slip" (with static above kinetic),
        "soil-curves" (forces by displacement),
        "saturated-damping" (Housner et al. 2022, equations 5-13; MoorDyn's) or "velocity-dependent" (after Lee et al.
        2018).
    damping : float
        Slope of the ramp of saturated damping (MoorDyn's c_v), N s/m for each node and unit of the coefficient.
    shear_stiffness : float or None
        Of the spring that holds a node that sticks, Pa/m on d l; by default that of the seabed's normal stiffness, so
        that a line slips after mu times the depth to which it sinks in.
    shear_damping : float
        Of that spring in elastic-slip, over the critical damping of a node's mass on it, -. Without, nodes that stick
        go on ringing.
    laid : bool
        Whether statics know friction: the line was laid without tension along the bed, from the end that stands on it
        (end A when both do), and then pulled to its place, so that tension falls from the touchdown towards the anchor.
        Otherwise statics are without friction.
    velocity : float
        At which stick-slip has lost half of what static friction has above kinetic, or velocity-dependent friction
        reaches its static coefficient, m/s.
    map : FrictionMap or None
        Coefficients over x and y, in place of `transverse` and `axial`.
    axial_curve, transverse_curve : Curve or None
        Of "soil-curves": displacement (m) and mobilised coefficient (-), from 0, 0 on and not falling. Beyond its last
        row a curve is level and the node slips.
    """

    transverse: float = 0.0
    axial: float = 0.0
    static_ratio: float = 1.0
    model: Literal["elastic-slip", "stick-slip", "soil-curves", "saturated-damping", "velocity-dependent"] = (
        "elastic-slip"
    )
    damping: float = 200.0
    shear_stiffness: float | None = None
    shear_damping: float = 0.1
    velocity: float = 0.01
    laid: bool = False
    map: FrictionMap | None = None
    axial_curve: float | Curve | None = None
    transverse_curve: float | Curve | None = None
    source: Source | None = field(default=None, compare=False, repr=False)

    @property
    def largest(self) -> float:
        """Largest kinetic coefficient, -."""
        if self.model == "soil-curves":
            curves = (self.axial_curve, self.transverse_curve)
            return max((value for curve in curves if isinstance(curve, Curve) for value in curve.y), default=0.0)
        tables = (self.map.axial, self.map.transverse) if self.map else (((self.axial, self.transverse),),)
        return max((value for table in tables for row in table for value in row), default=0.0)


@dataclass(frozen=True, kw_only=True)
class Soil:
    """A soil that holds back by suction and remembers how it was pressed, after Randolph & Quiggin (2009).

    It takes the place of `seabed_stiffness` and `seabed_damping` in the normal force.

    Parameters
    ----------
    shear_strength : float
        Undrained, at the mudline, Pa.
    strength_gradient : float
        Its growth with depth, Pa/m.
    bearing_factor, bearing_exponent : float
        a and b of the bearing capacity N_c = a (z / D)^b of a line of diameter D at the penetration z; where that is
        less than D / 10, N_c is that of D / 10 times sqrt(10 z / D).
    maximum_stiffness : float
        k_max: every turn of the motion meets the stiffness k_max P_u / D, P_u = N_c s_u D, for a metre.
    suction_ratio : float
        Greatest suction over P_u.
    suction_decay : float
        Suction dies out with uplift over this part of the greatest penetration.
    repenetration_offset : float
        Resistance is back on its first curve this part of the uplift deeper than it was before.
    density : float or None
        Of the saturated soil, kg/m3: its weight above that of water buoys the line by `buoyancy_factor` times what the
        line displaces. Without it there is no such lift.
    buoyancy_factor : float
        For soil that heaves beside the line.
    """

    shear_strength: float
    strength_gradient: float = 0.0
    bearing_factor: float = 6.0
    bearing_exponent: float = 0.25
    maximum_stiffness: float = 200.0
    suction_ratio: float = 0.7
    suction_decay: float = 0.6
    repenetration_offset: float = 0.3
    density: float | None = None
    buoyancy_factor: float = 1.5
    source: Source | None = field(default=None, compare=False, repr=False)

    def __str__(self) -> str:
        """Return its strength in words."""
        growth = f" + {1e-3 * self.strength_gradient:g} kPa/m z" if self.strength_gradient else ""
        return f"{1e-3 * self.shear_strength:g} kPa{growth}"


@dataclass(frozen=True)
class Current:
    """A steady current: levels z (n,) m, increasing, and velocity (n, 3) m/s; constant above and below them."""

    z: tuple[float, ...] = (0.0,)
    velocity: tuple[tuple[float, float, float], ...] = ((0.0, 0.0, 0.0),)
    source: Source | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        keep_plain(self, "z", "velocity")


@dataclass(frozen=True, kw_only=True)
class UnreadWater:
    """Water that was asked for and is not simulated: the option as read, its value, and the options beside it."""

    option: str
    value: str
    settings: tuple[tuple[str, str], ...] = ()
    source: Source | None = field(default=None, compare=False, repr=False)


@dataclass(frozen=True, kw_only=True)
class Environment:
    """The surroundings of a mooring.

    Parameters
    ----------
    water_depth : float
        m, positive; the level of a flat seabed is -water_depth. Still used as reference depth with `bathymetry`.
    gravity : float
        m/s2.
    water_density : float
        kg/m3.
    seabed_stiffness, seabed_damping : float
        Pa/m and Pa s/m on the projected area d l of the line.
    seabed_stiffness_map : StiffnessMap or None
        Stiffness over x and y, in place of `seabed_stiffness` in the normal force (not in that of friction's spring).
    current : Current or CurrentGrid
        A steady profile, or velocities over time and place.
    host_waves : bool
        Waves come from the program that moves the mooring (`Simulation.set_water`) or a function (`simulate`'s
        `water`), and not from `waves`.
    soil : Soil or None
        Soil with suction and a memory, in place of stiffness and damping in the normal force.
    """

    water_depth: float
    gravity: float = 9.80665
    water_density: float = 1025.0
    seabed_stiffness: float = 3.0e6
    seabed_damping: float = 3.0e5
    seabed_stiffness_map: StiffnessMap | None = None
    soil: Soil | None = None
    friction: Friction | None = None
    bathymetry: Bathymetry | None = None
    current: Current | CurrentGrid = Current()
    waves: Waves | None = None
    host_waves: bool = False
    unread_water: UnreadWater | None = None

    def depth_at(self, x: float, y: float) -> float:
        """Return the water depth (m) at a place."""
        return self.bathymetry.depth_at(x, y) if self.bathymetry else self.water_depth
