"""Waves in MoorDyn's files: complex amplitudes by frequency, or the elevation at the origin over time.

MoorDyn puts both on a grid of water, which it interpolates; here they become components, which are exact everywhere.
"""

from __future__ import annotations

import warnings
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from moorage.errors import ModelWarning, Source
from moorage.io.tables import Entry, read_entries
from moorage.io.text import Findings
from moorage.model import Waves

FASTEST = np.pi  # rad/s: MoorDyn-C leaves out of a transform what is faster than 0.5 Hz
SILENT = 1e-14  # of the energy: components below are rounding
MOST = 100_000  # components of an even grid
MOST_SAMPLES = 1_000_000  # of an elevation, to look at its energy
NOTABLE_LOSS = 0.05  # of the energy that is worth a word
NOTABLE = 0.01  # mean level over significant height that is worth a word

Values = dict[str, Any]


class Components(NamedTuple):
    """Parts of a sea, (n,) each: rad/s, m (complex, of exp(i w t)), rad."""

    frequency: np.ndarray
    amplitude: np.ndarray
    direction: np.ndarray


def summed(path: Path, water: Values, found: Findings, named: Source) -> Waves | None:
    """Return the sea of WaveKin 7: the components of wave_frequencies.txt, whose phases are those of sines."""
    parts = _frequencies(path, found, named)
    if parts is None:
        return None
    return _waves(parts._replace(amplitude=-1j * parts.amplitude), water, path, "WaveKin 7")


def evenly_spaced(path: Path, water: Values, found: Findings, named: Source) -> Waves | None:
    """Return the sea of WaveKin 2: wave_frequencies.txt at multiples of its smallest step.

    Between the rows of the file the complex amplitude and the direction are linear, as MoorDyn-C has it.
    """
    parts = _frequencies(path, found, named)
    if parts is None:
        return None
    w, source = parts.frequency, Source(str(path))
    step = float(np.diff(w).min()) if len(w) > 1 else 0.0
    if not step > 0.0:
        remedy = "sort the rows, each frequency once, or use WaveKin 7"
        found.add("frequencies of WaveKin 2 do not increase", remedy, source)
        return None
    count = int(w[-1] / step + 1e-9)
    if count > MOST:
        what = f"WaveKin 2 makes {count} components of the smallest step between frequencies"
        found.add(what, "give wider steps, or use WaveKin 7", source, step)
        return None
    fine = step * np.arange(1, count + 1)
    even = Components(fine, *(np.interp(fine, w, values) for values in (parts.amplitude, parts.direction)))
    return _waves(even, water, path, "WaveKin 2")


def transformed(
    path: Path, interval: float, direction: float, water: Values, found: Findings, named: Source, mode: str
) -> Waves | None:
    """Return the sea whose elevation at the origin is that of a file, repeated for ever.

    Parameters
    ----------
    interval : float
        dtWave, s: the elevation is taken from the file at its multiples, linearly.
    direction : float
        Where the waves go, rad.
    mode : str
        The option that asks for it.
    """
    entries = read_entries(path, "wave elevations", range(2, 3), found, named, least=4)
    if not (entries and _is_series(entries, found)):
        return None
    time, elevation = (np.array(column) for column in zip(*(entry.values for entry in entries), strict=True))
    count = (int(time[-1] / interval + 1e-9) + 1) // 2 * 2  # MoorDyn's transform takes an even number
    if count < 4:
        found.add("dtWave leaves fewer than 4 wave elevations", "give a smaller dtWave", Source(str(path)), interval)
        return None
    eta = np.interp(interval * np.arange(count), time, elevation)
    w = 2.0 * np.pi / (count * interval) * np.arange(count // 2 + 1)
    amplitude = 2.0 / count * np.fft.rfft(eta)
    amplitude[0] *= 0.5
    kept = w <= FASTEST
    kept[-1] = False  # half the rate of the samples: its phase is not known
    _warn_of_loss(path, time, elevation, interval, float(0.5 * (np.abs(amplitude[kept & (w > 0.0)]) ** 2).sum()))
    return _waves(Components(w[kept], amplitude[kept], np.full(kept.sum(), direction)), water, path, mode)


def _warn_of_loss(path: Path, time: np.ndarray, elevation: np.ndarray, interval: float, kept: float) -> None:
    """Warn when the elevation of a file has more energy, m2, than the components kept, or faster waves than they are.

    Samples that are too far apart do not lose the energy of faster waves, but give it to slower ones.
    """
    step = max(float(np.diff(time).min()), float(time[-1]) / MOST_SAMPLES)
    even = np.interp(step * np.arange(int(time[-1] / step + 1e-9) + 1), time, elevation)
    energy = np.abs(np.fft.rfft(even - even.mean())) ** 2
    total, fastest = float(energy[1:].sum()), min(FASTEST, np.pi / interval)
    if not total > 0.0:
        return
    beyond = float(energy[2.0 * np.pi / (len(even) * step) * np.arange(len(energy)) > fastest].sum()) / total
    lost = 1.0 - kept / float(even.var())
    if max(beyond, lost) <= NOTABLE_LOSS:
        return
    if beyond > NOTABLE_LOSS and fastest < FASTEST:
        what = f"{beyond:.2g} of the energy of the waves (m0) is faster than dtWave {interval:g} s can tell"
        remedy = f"give dtWave {max(step, 1.0):g} s or less"
    elif beyond > NOTABLE_LOSS:
        what = f"{beyond:.2g} of the energy of the waves (m0) is faster than 0.5 Hz and left out, as by MoorDyn-C"
        remedy = "give components by WaveKin 7"
    else:
        what = f"{lost:.2g} of the energy of the waves (m0) is lost between the rows of the file, {step:g} s apart"
        remedy = f"give rows every {interval:g} s or less, or dtWave {step:g} s"
    warnings.warn(f"{path}: {what}; {remedy}", ModelWarning, stacklevel=2)


def _frequencies(path: Path, found: Findings, named: Source) -> Components | None:
    """Return the rows frequency, real and imaginary part, and direction of a file; None when one is wrong."""
    entries = read_entries(path, "wave components", range(3, 5), found, named, least=1)
    before = len(found.problems)
    for entry in entries:
        frequency, *_, direction = (*entry.values, 0.0)[:4]
        if frequency < 0.0:
            remedy = "make it positive, with the direction turned by pi"
            found.add("frequency of a wave component is negative", remedy, entry.source, frequency)
        if abs(direction) > 2.0 * np.pi:
            found.add("direction of a wave component is not in rad", "write -2 pi to 2 pi", entry.source, direction)
    if not entries or len(found.problems) > before:
        return None
    table = np.array([(*entry.values, 0.0)[:4] for entry in entries])
    return Components(table[:, 0], table[:, 1] + 1j * table[:, 2], table[:, 3])


def _is_series(entries: list[Entry], found: Findings) -> bool:
    """Return whether times increase from 0; the first that does not is noted."""
    if entries[0].values[0] != 0.0:
        found.add("wave elevations do not start at 0 s", "shift the times", entries[0].source, entries[0].values[0])
        return False
    for before, entry in pairwise(entries):
        if entry.values[0] <= before.values[0]:
            found.add("times of the wave elevations do not increase", "sort them", entry.source, entry.values[0])
            return False
    return True


def _waves(parts: Components, water: Values, path: Path, mode: str) -> Waves | None:
    """Return the waves of the components that carry energy; None when there are none."""
    size = np.abs(parts.amplitude)
    moving = parts.frequency > 0.0
    energy = np.where(moving, size**2, 0.0)
    level = float(parts.amplitude[~moving].real.sum())
    height = 4.0 * np.sqrt(0.5 * energy.sum())
    if abs(level) > NOTABLE * height:
        what = f"the mean level of the waves, {level:.3g} m, is left out: the still water stays at z = 0"
        warnings.warn(f"{path}: {what}", ModelWarning, stacklevel=2)
    kept = energy > SILENT * energy.sum()
    if not kept.any():
        return None
    return Waves(
        frequency=tuple(parts.frequency[kept].tolist()),
        amplitude=tuple(size[kept].tolist()),
        phase=tuple(np.angle(parts.amplitude[kept]).tolist()),
        direction=tuple(parts.direction[kept].tolist()),
        asked=(("spectrum", f"{path.name} by {mode}"),),
        source=Source(str(path)),
        **water,
    )
