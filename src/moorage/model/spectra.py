"""Wave spectra S(w) of the surface elevation, m2 s/rad, and how they are cut into components.

Sources: JONSWAP and Pierson-Moskowitz as in DNV-RP-C205 (2021), 3.5.5; Ochi & Hubble (1976); the spreading function
cos^2s of Longuet-Higgins et al. (1963).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

Spectrum = Callable[[np.ndarray], np.ndarray]

LOWEST, HIGHEST = 0.5, 3.5  # frequencies that count, over that of the peak
FINE = 20_001  # points on which a spectrum is integrated


def gamma_by_rule(height: float, period: float) -> float:
    """Return the peakedness of JONSWAP that goes with a significant height (m) and a peak period (s): 1 to 5.

    DNV-RP-C205, 3.5.5.5.
    """
    ratio = period / np.sqrt(height)
    return 5.0 if ratio <= 3.6 else 1.0 if ratio >= 5.0 else float(np.exp(5.75 - 1.15 * ratio))


def jonswap(w: np.ndarray, height: float, period: float, gamma: float = 3.3) -> np.ndarray:
    """Return JONSWAP's spectrum at frequencies w (rad/s); scaled to the significant height by its own integral.

    Parameters
    ----------
    height : float
        Significant wave height, m.
    period : float
        Peak period, s.
    gamma : float
        Peakedness; 1 is Pierson-Moskowitz.
    """
    fine = 2.0 * np.pi / period * np.linspace(0.2, 20.0, FINE)
    m0 = np.trapezoid(_jonswap_shape(fine, period, gamma), fine)
    return _jonswap_shape(np.asarray(w, float), period, gamma) * height**2 / 16.0 / m0


def _jonswap_shape(w: np.ndarray, period: float, gamma: float) -> np.ndarray:
    peak = 2.0 * np.pi / period
    width = np.where(w <= peak, 0.07, 0.09)
    bump = np.exp(-0.5 * ((w - peak) / (width * peak)) ** 2)
    return w**-5.0 * np.exp(-1.25 * (peak / w) ** 4) * gamma**bump


def pierson_moskowitz(w: np.ndarray, height: float, period: float) -> np.ndarray:
    """Return Pierson and Moskowitz's spectrum by significant height (m) and peak period (s)."""
    peak = 2.0 * np.pi / period
    return 0.3125 * height**2 * peak**4 * w**-5.0 * np.exp(-1.25 * (peak / w) ** 4)


def ochi_hubble(w: np.ndarray, parts: tuple[tuple[float, float, float], ...]) -> np.ndarray:
    """Return the sum of Ochi and Hubble's parts, each by significant height (m), peak period (s) and shape lambda."""
    from math import gamma  # noqa: PLC0415  the name is that of a parameter elsewhere

    total = np.zeros_like(np.asarray(w, float))
    for height, period, shape in parts:
        peak = 2.0 * np.pi / period
        a = shape + 0.25
        scale = (a * peak**4) ** shape / gamma(shape) * height**2 / 4.0
        total += scale * w ** -(4.0 * shape + 1.0) * np.exp(-a * (peak / w) ** 4)
    return total


def cut(
    spectrum: Spectrum, low: float, high: float, count: int, method: str, random: np.random.Generator
) -> tuple[np.ndarray, np.ndarray]:
    """Return frequencies (rad/s) and amplitudes (m), each (count,), of components that carry a spectrum's energy.

    Parameters
    ----------
    low, high : float
        Range of frequencies, rad/s.
    method : str
        "random": equal bins, a random frequency in each, which does not repeat; "equal-frequency": the middle of each,
        which repeats after 2 pi / bin width; "equal-energy": bins of equal energy, each with its median.
    """
    fine = np.linspace(low, high, FINE)
    density = spectrum(fine)
    energy = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(fine))])
    if method == "equal-energy":
        levels = np.linspace(0.0, energy[-1], count + 1)
        edges = np.interp(levels, energy, fine)
        frequency = np.interp(0.5 * (levels[1:] + levels[:-1]), energy, fine)
    else:
        edges = np.linspace(low, high, count + 1)
        place = random.random(count) if method == "random" else np.full(count, 0.5)
        frequency = edges[:-1] + place * np.diff(edges)
    return frequency, np.sqrt(2.0 * np.diff(np.interp(edges, fine, energy)))


def spread(count: int, mean: float, s: float, random: np.random.Generator) -> np.ndarray:
    """Return directions (count,) rad drawn from cos^2s((direction - mean) / 2)."""
    fine = np.linspace(-np.pi, np.pi, 4001)
    density = np.cos(0.5 * fine) ** (2.0 * s)
    share = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]))])
    # one draw from each of `count` equal shares: the moments come out with less scatter
    levels = random.permutation((np.arange(count) + random.random(count)) / count)
    return mean + np.interp(levels * share[-1], share, fine)


def wavenumbers(frequency: np.ndarray, depth: float, gravity: float) -> np.ndarray:
    """Return k (rad/m) of k tanh(k h) = w^2 / g, to rounding: Guo's (2002) guess and three steps of Newton's method."""
    y = np.square(frequency) * depth / gravity
    x = y * (1.0 - np.exp(-(y**1.2454))) ** (-1.0 / 2.4908)
    for _ in range(3):
        t = np.tanh(x)
        x = x - (x * t - y) / (t + x * (1.0 - t * t))
    return x / depth
