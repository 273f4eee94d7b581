"""Steep regular waves as sums of harmonics that travel together: Stokes' fifth order and stream functions.

The coefficients come from the package raschii (extra `waves`), after Fenton (1985) and Rienecker & Fenton (1981), for
water that is on average at rest below the troughs. What is taken from it are samples of its surface and of its
velocity at the still water level, whose Fourier series are those of the wave to rounding.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np

Theory = Literal["stokes", "stream-function"]
ORDER = {"stokes": 5, "stream-function": 12}


class Harmonics(NamedTuple):
    """Harmonics j = 1, 2, ...: w (rad/s), k (rad/m), and amplitudes (m) of the elevation and of the velocity.

    The velocity of a harmonic is w A cosh k(z + h) / sinh kh cos(theta), as that of a free wave.
    """

    frequency: np.ndarray
    wavenumber: np.ndarray
    elevation: np.ndarray
    amplitude: np.ndarray


def harmonics(
    theory: Theory, height: float, period: float, depth: float, gravity: float, order: int | None = None
) -> Harmonics:
    """Return the harmonics of a wave of a height (m, crest to trough) and a period (s).

    Raises
    ------
    ImportError
        raschii is not installed.
    ValueError
        The theory has no such wave.
    """
    from raschii import FentonWave, StokesWave  # noqa: PLC0415  optional

    count = order or ORDER[theory]
    make = StokesWave if theory == "stokes" else FentonWave
    try:
        wave = make(height=height, depth=depth, period=period, N=count, g=gravity)
    except Exception as error:  # of several kinds, among them those of NumPy
        raise ValueError(str(error) or type(error).__name__) from error
    samples = 4 * (count + 1)  # of one length: more than any harmonic needs
    x = wave.length / samples * np.arange(samples)
    surface = np.asarray(wave.surface_elevation(x, include_depth=False), float)
    flow = np.asarray(wave.velocity(x, np.full(samples, depth), all_points_wet=True), float)[:, 0]
    j = np.arange(1, count + 1)
    k, w = j * wave.k, j * 2.0 * np.pi / period
    elevation, velocity = (2.0 / samples * np.fft.rfft(values).real[1 : count + 1] for values in (surface, flow))
    if not (np.isfinite(elevation).all() and np.isfinite(velocity).all()):
        raise ValueError("its series does not converge")
    return Harmonics(w, k, elevation, velocity * np.tanh(k * depth) / w)
