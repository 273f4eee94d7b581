"""Sea states from NetCDF files of directional spectra, efth(time, freq, dir), as wavespectra writes them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from moorage.errors import ModelError, Problem, Source
from moorage.io.sea_state import stands
from moorage.io.text import Findings
from moorage.model import Waves

if TYPE_CHECKING:
    import xarray as xr

DENSITY = re.compile(r"m2(/hz|hz-?1|s)/?(?P<angle>deg|rad)[a-z]*(-1)?")
PER_DEGREE = {"deg": 1.0, "rad": np.pi / 180.0}
HERTZ = ("hz", "s-1", "1/s")
LEFT_OUT = 1e-3  # of the energy: the components that carry least
Values = dict[str, Any]


class Directional(NamedTuple):
    """A directional spectrum: frequency (f,) Hz, direction to which waves go (d,) compass deg, m2/Hz/deg (f, d)."""

    frequency: np.ndarray
    direction: np.ndarray
    density: np.ndarray


def sea_of_file(asked: Values, folder: Path, water: Values, found: Findings) -> Waves | None:
    """Return the waves of a file's spectrum; None, with problems noted, when there is none.

    Every bin of frequency and direction is a component of its energy, with a random phase and a random frequency in
    the bin, so that the sea does not repeat.
    """
    path = folder / asked["file"]
    spectrum = _read(path, asked.get("time", 0), found, asked["source"])
    if spectrum is None:
        return None
    seed = asked.get("seed", 1)
    random = np.random.default_rng(seed)
    edges = _edges(spectrum.frequency)
    energy = spectrum.density * np.diff(edges)[:, None] * _widths(spectrum.direction)
    frequency = edges[:-1, None] + random.random(energy.shape) * np.diff(edges)[:, None]
    phase = 2.0 * np.pi * random.random(energy.shape)
    way = np.deg2rad(asked.get("heading", 90.0) - spectrum.direction)  # from x towards y
    way = np.broadcast_to(np.angle(np.exp(1j * way)), energy.shape)
    kept = _strongest(energy)
    if not kept.any():
        found.add("spectrum holds no waves", "choose another time", Source(str(path)), asked.get("time", 0))
        return None
    rest = {key: asked[key] for key in ("stretching", "ramp", "exact", "source") if key in asked}
    waves = Waves(
        frequency=tuple((2.0 * np.pi * frequency[kept]).tolist()),
        amplitude=tuple(np.sqrt(2.0 * energy[kept]).tolist()),
        phase=tuple(phase[kept].tolist()),
        direction=tuple(way[kept].tolist()),
        seed=seed,
        asked=(("spectrum", f"{asked['file']} at time {asked.get('time', 0)}"), *_heights(spectrum, energy)),
        **water,
        **rest,
    )
    return waves if stands(waves.significant_height, waves.peak_period, water, asked, found) else None


def _read(path: Path, time: int, found: Findings, named: Source) -> Directional | None:
    """Return the spectrum of a file at the number of a time; None, with the first problem noted."""
    import xarray as xr  # noqa: PLC0415  slow to import, and few models need it

    if not path.is_file():
        found.add(f"file of wave spectra not found: tried {path}", "correct the name, or put the file there", named)
        return None
    try:
        with xr.open_dataset(path, decode_times=False) as ds:
            return _spectrum(ds.load(), path, time)
    except ModelError as error:
        found.extend(error.problems)
        return None
    except (OSError, ValueError) as error:
        found.add(f"file of wave spectra cannot be read: {error}", "give a NetCDF file", Source(str(path)))
        return None


def _spectrum(ds: xr.Dataset, path: Path, time: int) -> Directional:
    """Return the spectrum of a dataset at the number of a time; a `ModelError` says why there is none."""

    def wrong(message: str, remedy: str, value: object = None) -> ModelError:
        return ModelError(Problem(message, remedy, Source(str(path)), value))

    missing = [name for name in ("efth", "freq", "dir") if name not in ds]
    if missing:
        raise wrong(f"file has no {' and no '.join(missing)}", "give efth(time, freq, dir), as wavespectra has it")
    efth = ds["efth"]
    units, rate = (str(ds[name].attrs.get("units", "")) for name in ("efth", "freq"))
    told = DENSITY.fullmatch(_bare(units))
    if told is None:
        remedy = "give efth an attribute units, such as m2/Hz/deg or m2/Hz/rad"
        raise wrong("units of efth are not known" if units else "efth does not say its units", remedy, units or None)
    if _bare(rate) not in HERTZ:
        remedy = "give freq an attribute units: Hz"
        raise wrong("units of freq are not known" if rate else "freq does not say its units", remedy, rate or None)
    if "time" in efth.dims:
        if not 0 <= time < efth.sizes["time"]:
            raise wrong("file has no such time", f"give a number from 0 to {efth.sizes['time'] - 1}", time)
        efth = efth.isel(time=time)
    elsewhere = {str(dim): size for dim, size in efth.sizes.items() if dim not in ("freq", "dir")}
    if any(size > 1 for size in elsewhere.values()):
        raise wrong("efth has more than one place", "write the spectra of one place to a file", elsewhere)
    efth = efth.isel(dict.fromkeys(elsewhere, 0)).transpose("freq", "dir").sortby(["freq", "dir"])
    frequency, direction = (efth[name].values.astype(float) for name in ("freq", "dir"))
    density = efth.values.astype(float) * PER_DEGREE[told["angle"]]
    if not (np.isfinite(density).all() and density.min() >= 0.0):
        raise wrong("efth has missing or negative values at that time", "choose another time", time)
    apart = np.diff(direction, append=direction[:1] + 360.0)
    if min(len(frequency), len(direction)) < 2 or frequency[0] <= 0.0 or min(*np.diff(frequency), *apart) <= 0.0:
        raise wrong("freq and dir are not a grid", "give two or more of each, positive frequencies, none twice")
    towards = "to_direction" in str(ds["dir"].attrs.get("standard_name", ""))
    return Directional(frequency, direction if towards else direction + 180.0, density)


def _bare(units: str) -> str:
    """Return units without blanks and marks of powers and products."""
    return re.sub(r"[\s^{}.*_]", "", units.lower())


def _edges(frequency: np.ndarray) -> np.ndarray:
    """Return the edges of the bins (f + 1,) of frequencies (f,), half-way between them."""
    middle = 0.5 * (frequency[1:] + frequency[:-1])
    return np.concatenate([[1.5 * frequency[0] - 0.5 * frequency[1]], middle, [2.0 * frequency[-1] - middle[-1]]]).clip(
        0.5 * frequency[0]
    )


def _widths(direction: np.ndarray) -> np.ndarray:
    """Return the widths of the bins of directions, deg; where the circle has a gap, bins are as wide as the others."""
    gaps = np.diff(direction, append=direction[0] + 360.0)
    gaps = np.where(gaps > 1.5 * np.median(gaps), np.median(gaps), gaps)
    return 0.5 * (gaps + np.roll(gaps, 1))


def _strongest(energy: np.ndarray) -> np.ndarray:
    """Return which bins carry all but a thousandth of the energy."""
    order = np.sort(energy, axis=None)
    below = np.searchsorted(np.cumsum(order), LEFT_OUT * energy.sum())
    return (energy >= order[min(below, order.size - 1)]) & (energy > 0.0)


def _heights(spectrum: Directional, energy: np.ndarray) -> tuple[tuple[str, float], ...]:
    """Return significant height and peak period of the file's own bins."""
    peak = spectrum.frequency[(spectrum.density * _widths(spectrum.direction)).sum(axis=1).argmax()]
    return ("height", float(4.0 * np.sqrt(energy.sum()))), ("period", float(1.0 / peak))
