"""A sea of Airy waves: components, and what the water does at any place and time.

    eta = sum A cos(theta),  theta = w t - k (x cos b + y sin b) + phase
    u = sum A w cosh k(z' + h) / sinh kh cos(theta) (cos b, sin b),   w = -sum A w sinh k(z' + h) / sinh kh sin(theta)
    acceleration = local du / dt,   dynamic pressure p = rho g sum A cosh k(z' + h) / cosh kh cos(theta)

z' is the level that stretching puts in the place of z, so that z' = 0 at the surface. A steep regular wave is a sum of
the same terms, whose k are multiples of the first and whose elevation has amplitudes of its own.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, NamedTuple

import numpy as np

from moorage.errors import Source
from moorage.model.spectra import (
    HIGHEST,
    LOWEST,
    Spectrum,
    cut,
    gamma_by_rule,
    jonswap,
    ochi_hubble,
    pierson_moskowitz,
    spread,
    wavenumbers,
)
from moorage.model.steady_waves import Theory, harmonics

Stretching = Literal["wheeler", "vertical", "linear", "none"]
Method = Literal["random", "equal-energy", "equal-frequency"]


class Kinematics(NamedTuple):
    """What the water does at points, with the shape of the points."""

    elevation: np.ndarray  # m above the still water
    velocity: np.ndarray  # (..., 3) m/s
    acceleration: np.ndarray  # (..., 3) m/s2, local
    pressure: np.ndarray  # dynamic, Pa


@dataclass(frozen=True, kw_only=True)
class Waves:
    """Airy waves in water of constant depth.

    Parameters
    ----------
    frequency, amplitude, phase, direction : (n,) tuple
        rad/s; m; rad; rad, where a component goes, from x towards y.
    wavenumbers, crests : (n,) tuple
        Of components that are no free waves but harmonics of a steep one: k, rad/m, in place of that of the dispersion
        relation, and the amplitude of the elevation, m; `amplitude` is then that of the velocity alone.
    depth, gravity, density : float
        m, m/s2, kg/m3.
    stretching : {"wheeler", "vertical", "linear", "none"}
        Which level stands for z up to the surface. Wheeler: z' = h (z + h) / (h + eta) - h, as MoorDyn has it;
        vertical: z' = min(z, 0); linear: the same, and above the still water velocities, accelerations and pressure go
        on with the slope that they have there; none: z, so that profiles grow on above the still water.
    ramp : float
        Seconds over which the sea grows from nothing, as (1 - cos) / 2.
    exact : bool
        Sum the components at each node and evaluation, instead of 20 times in a peak period along the nodes' paths.
    seed : int or None
        Of the random phases, frequencies and directions.
    asked : tuple of (name, value)
        What the components were made from, for the record.
    """

    frequency: tuple[float, ...]
    amplitude: tuple[float, ...]
    phase: tuple[float, ...]
    direction: tuple[float, ...]
    wavenumbers: tuple[float, ...] = ()
    crests: tuple[float, ...] = ()
    depth: float
    gravity: float = 9.80665
    density: float = 1025.0
    stretching: Stretching = "wheeler"
    ramp: float = 0.0
    exact: bool = False
    seed: int | None = field(default=None, compare=False)
    asked: tuple[tuple[str, float | str], ...] = field(default=(), compare=False)
    source: Source | None = field(default=None, compare=False, repr=False)

    @classmethod
    def regular(
        cls, height: float, period: float, *, depth: float, direction: float = 0.0, phase: float = 0.0, **water
    ) -> Waves:
        """Return one regular wave of a height (m, crest to trough) and a period (s)."""
        return cls(
            frequency=(2.0 * np.pi / period,), amplitude=(0.5 * height,), phase=(float(phase),),
            direction=(float(direction),), depth=depth,
            asked=(("spectrum", "regular"), ("height", height), ("period", period)), **water,
        )  # fmt: skip

    @classmethod
    def steep(
        cls,
        theory: Theory,
        height: float,
        period: float,
        *,
        depth: float,
        direction: float = 0.0,
        phase: float = 0.0,
        order: int | None = None,
        **water,
    ) -> Waves:
        """Return one regular wave by Stokes' fifth order ("stokes") or a stream function ("stream-function").

        Its profiles go up to the surface as they are. It needs the extra `waves`; see `moorage.model.steady_waves` for
        what is raised when there is no such wave.
        """
        water = {"stretching": "none"} | water
        found = harmonics(theory, height, period, depth, water.get("gravity", cls.gravity), order)
        count = len(found.frequency)
        return cls(
            frequency=_tuple(found.frequency), amplitude=_tuple(found.amplitude),
            phase=_tuple(phase * np.arange(1, count + 1)), direction=(float(direction),) * count,
            wavenumbers=_tuple(found.wavenumber), crests=_tuple(found.elevation), depth=depth,
            asked=(("spectrum", theory), ("height", height), ("period", period), ("order", count)), **water,
        )  # fmt: skip

    @classmethod
    def irregular(
        cls,
        spectrum: Literal["jonswap", "pierson-moskowitz", "ochi-hubble"] | Spectrum,
        height: float,
        period: float,
        *,
        depth: float,
        gamma: float | None = None,
        second: tuple[float, float] | None = None,
        shape: tuple[float, float] = (3.0, 1.0),
        direction: float = 0.0,
        spreading: float | None = None,
        components: int = 200,
        method: Method = "random",
        seed: int = 1,
        **water,
    ) -> Waves:
        """Return a sea of a spectrum with a significant height (m) and a peak period (s).

        Parameters
        ----------
        spectrum : str or callable
            A callable takes frequencies (rad/s) and gives m2 s/rad; its height is then the spectrum's own.
        gamma : float, optional
            Peakedness of JONSWAP; by default by rule from height and period.
        second : (height, period), optional
            Second part of Ochi and Hubble's spectrum, m and s; `shape` holds lambda of both.
        spreading : float, optional
            s of cos^2s(direction / 2); by default all components go one way.
        components, method, seed
            How the spectrum is cut, see `moorage.model.spectra.cut`. Frequencies are those from 0.5 to 3.5 of the peak.
        """
        peaks = [2.0 * np.pi / period]
        asked: dict[str, float | str] = {"spectrum": "a function" if callable(spectrum) else spectrum}
        asked |= {"height": height, "period": period}
        if callable(spectrum):
            density = spectrum
        elif spectrum == "jonswap":
            peakedness = gamma_by_rule(height, period) if gamma is None else gamma
            asked["gamma"] = peakedness
            density = lambda w: jonswap(w, height, period, peakedness)  # noqa: E731
        elif spectrum == "pierson-moskowitz":
            density = lambda w: pierson_moskowitz(w, height, period)  # noqa: E731
        else:
            parts = ((height, period, shape[0]), *(((*second, shape[1]),) if second else ()))
            peaks += [2.0 * np.pi / part[1] for part in parts[1:]]
            density = lambda w: ochi_hubble(w, parts)  # noqa: E731
        reach = LOWEST * min(peaks), HIGHEST * max(peaks)
        return cls.drawn(density, reach, asked, direction, spreading, components, method, seed, depth=depth, **water)

    @classmethod
    def drawn(
        cls,
        spectrum: Spectrum,
        reach: tuple[float, float],
        asked: dict[str, float | str],
        direction: float = 0.0,
        spreading: float | None = None,
        components: int = 200,
        method: Method = "random",
        seed: int = 1,
        **water,
    ) -> Waves:
        """Return a sea of a spectrum (m2 s/rad) cut between two frequencies (rad/s); the rest as for `irregular`.

        `asked` is what it was made from, for the record.
        """
        random = np.random.default_rng(seed)
        frequency, amplitude = cut(spectrum, *reach, components, method, random)
        phase = random.random(components) * 2.0 * np.pi
        heading = np.full(components, direction)
        if spreading is not None:
            heading, asked = spread(components, direction, spreading, random), asked | {"spreading": spreading}
        return cls(
            frequency=_tuple(frequency), amplitude=_tuple(amplitude), phase=_tuple(phase), direction=_tuple(heading),
            seed=seed, asked=tuple(asked.items()), **water,
        )  # fmt: skip

    @property
    def wavenumber(self) -> np.ndarray:
        """k of the components, rad/m."""
        return (
            np.array(self.wavenumbers)
            if self.wavenumbers
            else wavenumbers(np.array(self.frequency), self.depth, self.gravity)
        )

    @property
    def elevations(self) -> np.ndarray:
        """Amplitudes of the elevation, m."""
        return np.array(self.crests or self.amplitude)

    @property
    def is_regular(self) -> bool:
        """Whether this is one wave that repeats itself."""
        return len(self.frequency) == 1 or bool(self.crests)

    @property
    def significant_height(self) -> float:
        """4 sqrt(m0) of the components, m."""
        return float(4.0 * np.sqrt(0.5 * np.sum(np.square(self.elevations))))

    @property
    def peak_period(self) -> float:
        """Period of the densest energy, with frequencies smoothed by 3 %, s."""
        w, energy = np.array(self.frequency), np.square(self.elevations)
        fine, density = np.linspace(w.min(), w.max(), 2001), np.zeros(2001)
        for part in np.array_split(np.arange(len(w)), len(w) // 1000 + 1):  # in memory at once
            width = 0.03 * w[part]
            density += (energy[part] * np.exp(-0.5 * ((fine[:, None] - w[part]) / width) ** 2) / w[part]).sum(axis=1)
        return float(2.0 * np.pi / fine[np.argmax(density)])

    @property
    def repeats_after(self) -> float:
        """Time after which the groups of a sea come again, s: its frequencies are equally spaced; else infinite."""
        if self.is_regular:
            return np.inf  # it has no groups
        w = np.unique(self.frequency)
        for parts in (1, 2, 3) if len(w) > 2 else ():  # of the smallest step: components may be missing
            step = np.diff(w).min() / parts
            count = np.diff(w) / step
            if np.all(np.abs(count - np.rint(count)) < 1e-3):
                return float(2.0 * np.pi / step)
        return np.inf

    @property
    def words(self) -> str:
        """What the components were made from."""
        units = {"height": " m", "period": " s"}
        names = {} if self.is_regular else {"height": "Hs", "period": "Tp"}
        parts = [str(v) if k == "spectrum" else f"{names.get(k, k)} {v:.4g}{units.get(k, '')}" for k, v in self.asked]
        return ", ".join(parts) or "components as given"

    def elevation(self, t, x=0.0, y=0.0) -> np.ndarray:
        """Return the surface elevation (m) at times and places, which broadcast."""
        t, x, y = np.broadcast_arrays(np.asarray(t, float), x, y)
        return self.ramped(t) * (self.elevations * np.cos(self._angles(t, x, y))).sum(-1)

    def _angles(self, t: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return theta (..., n) at times and places (...)."""
        b = np.array(self.direction)
        way = x[..., None] * np.cos(b) + y[..., None] * np.sin(b)
        return t[..., None] * np.array(self.frequency) + np.array(self.phase) - self.wavenumber * way

    def ramped(self, t) -> np.ndarray:
        """Return the share of the sea that has grown by a time."""
        if self.ramp <= 0.0:
            return np.ones_like(np.asarray(t, float))
        return 0.5 * (1.0 - np.cos(np.pi * np.clip(np.asarray(t, float) / self.ramp, 0.0, 1.0)))

    def kinematics(self, t, xyz) -> Kinematics:
        """Return elevation, velocity, acceleration and dynamic pressure.

        Parameters
        ----------
        t : (...) array
            s.
        xyz : (..., 3) array
            m; `t` broadcasts with all but the last axis. Above the surface the values of the surface are given.
        """
        xyz, t = np.asarray(xyz, float), np.asarray(t, float)
        shape = np.broadcast_shapes(t.shape, xyz.shape[:-1])
        t, xyz = np.broadcast_to(t, shape), np.broadcast_to(xyz, (*shape, 3))
        w, a, k, b = (np.array(v) for v in (self.frequency, self.amplitude, self.wavenumber, self.direction))
        theta = self._angles(t, xyz[..., 0], xyz[..., 1])
        cosine = np.cos(theta)
        c, s = a * cosine, a * np.sin(theta)
        grown = self.ramped(t)
        eta = grown * (self.elevations * cosine).sum(-1)
        level = self.level(xyz[..., 2], eta)
        up, side = profiles(k, level[..., None], self.depth)
        if self.stretching == "linear":
            beyond = np.maximum(np.minimum(xyz[..., 2], eta), 0.0)[..., None]
            up, side = up + k * beyond * side, side + k * beyond * up
        way = np.stack([np.cos(b), np.sin(b)], axis=-1)
        flow = (w * side * c) @ way, (-(w**2) * side * s) @ way
        rise = -(w * up * s).sum(-1), -(w**2 * up * c).sum(-1)
        motion = [grown[..., None] * np.concatenate([h, v[..., None]], -1) for h, v in zip(flow, rise, strict=True)]
        pressure = grown * self.density * (w**2 / k * side * c).sum(-1)
        if self.crests:  # to second order and beyond, by Bernoulli
            pressure -= 0.5 * self.density * (motion[0] ** 2).sum(-1)
        return Kinematics(eta, motion[0], motion[1], pressure)

    def level(self, z: np.ndarray, eta: np.ndarray) -> np.ndarray:
        """Return the level z' (m) that stands for z."""
        z = np.minimum(z, eta)
        if self.stretching == "wheeler":
            z = self.depth * (z + self.depth) / (self.depth + eta) - self.depth
        elif self.stretching in ("vertical", "linear"):
            z = np.minimum(z, 0.0)
        return np.clip(z, -self.depth, None)


def _tuple(values: np.ndarray) -> tuple[float, ...]:
    return tuple(map(float, values))


def profiles(k: np.ndarray, z: np.ndarray, depth: float) -> tuple[np.ndarray, np.ndarray]:
    """Return sinh k(z + h) / sinh kh and cosh k(z + h) / sinh kh, without overflow."""
    up, down = np.exp(k * z), np.exp(-k * (z + 2.0 * depth))
    both = 1.0 - np.exp(-2.0 * k * depth)
    return (up - down) / both, (up + down) / both
