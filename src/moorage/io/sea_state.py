"""Waves of a native file: components as they are, or a sea state in words."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from moorage.io.text import Findings, is_number, to_float
from moorage.model import Curve, Waves
from moorage.model.spectra import wavenumbers

STEEPEST = 0.142  # height over length at which a wave breaks in deep water (Miche 1944)
MOST_COMPONENTS = 10_000
Values = dict[str, Any]


def components(asked: Values, water: Values, found: Findings) -> Waves | None:
    """Return waves of given components; None, with problems noted, when they cannot be made."""
    counts = {key: len(asked[key]) for key in ("frequency", "amplitude", "phase", "direction")}
    if len(set(counts.values())) > 1:
        given = ", ".join(f"{count} of {key}" for key, count in counts.items())
        found.add("components of the waves do not have one of each", "give as many of each", asked["source"], given)
        return None
    for name in ("wavenumbers", "crests"):
        count = len(asked.get(name, ()))
        if count not in (0, counts["frequency"]):
            what = f"{count} of {name}, {counts['frequency']} of frequency"
            found.add("components of the waves do not have one of each", "give as many of each", asked["source"], what)
            return None
    if ("wavenumbers" in asked) != ("crests" in asked):
        found.add("harmonics of a steep wave need wavenumbers and crests", "give both or none", asked["source"])
        return None
    for value in asked["frequency"]:
        if not value > 0.0:
            found.add("frequency of a wave component must be positive", "correct or remove it", asked["source"], value)
            return None
    record = tuple((name, to_float(word) if is_number(word) else word) for name, word in asked.get("asked", ()))
    return Waves(**asked | {"asked": record}, **water)


def tabled(asked: Values, water: Values, found: Findings) -> Waves | None:
    """Return a sea of a table of the spectrum; None, with a problem noted, when it is none."""
    curve, source = asked["density"], asked["source"]
    if not isinstance(curve, Curve) or len(curve.x) < 2:
        remedy = "give x, frequencies in rad/s, and y, densities in m2 s/rad, two or more; or a file of both"
        found.add("spectrum is not a table", remedy, source, None if isinstance(curve, Curve) else curve)
        return None
    if not curve.x[0] > 0.0:
        found.add("frequency of the spectrum must be positive", "correct or remove it", source, curve.x[0])
    elif any(b <= a for a, b in pairwise(curve.x)):
        found.add("frequencies of the spectrum do not increase", "sort them, each once", source, curve.x)
    elif min(curve.y) < 0.0 or not max(curve.y) > 0.0:
        found.add(
            "densities of the spectrum must be positive or 0, and not all 0", "correct them", source, min(curve.y)
        )
    elif _has_sense(asked | {"spectrum": "tabled"}, set(), found):
        w, s = np.array(curve.x), np.array(curve.y)
        height, period = 4.0 * np.sqrt(np.trapezoid(s, w)), 2.0 * np.pi / w[s.argmax()]
        if not stands(height, period, water, asked, found):
            return None
        name = f"a table, {curve.file}" if curve.file else "a table"
        record: dict[str, float | str] = {"spectrum": name, "height": float(height), "period": float(period)}
        own = {key: asked[key] for key in _DRAWN | _USED if key in asked and key != "direction"} | water
        way = np.deg2rad(asked.get("direction", 0.0))
        return Waves.drawn(lambda f: np.interp(f, w, s), (w[0], w[-1]), record, way, source=source, **own)
    return None


_DRAWN = {"direction", "spreading", "components", "method", "seed"}
_USED = {"stretching", "ramp", "exact"}
WORDS = {
    "regular": {"phase"},
    "stokes": {"phase", "order"},
    "stream-function": {"phase", "order"},
    "jonswap": {"gamma", "spreading", "components", "method", "seed"},
    "pierson-moskowitz": {"spreading", "components", "method", "seed"},
    "ochi-hubble": {"second", "shape", "spreading", "components", "method", "seed"},
}
EVERY = set().union(*WORDS.values())


def sea_state(asked: Values, water: Values, found: Findings) -> Waves | None:
    """Return the waves of a sea state; None, with problems noted, when it cannot be."""
    spectrum, height, period = (asked[key] for key in ("spectrum", "height", "period"))
    own = {key: value for key, value in asked.items() if key in EVERY}
    if not (_has_sense(asked, own.keys() - WORDS[spectrum], found) and stands(height, period, water, asked, found)):
        return None
    rest: Values = {key: asked[key] for key in (*_USED, "source") if key in asked} | water
    way = np.deg2rad(asked.get("direction", 0.0))
    if spectrum in ("stokes", "stream-function"):
        return _steep(asked, way, rest, found)
    if spectrum == "regular":
        return Waves.regular(height, period, direction=way, phase=np.deg2rad(own.get("phase", 0.0)), **rest)
    return Waves.irregular(spectrum, height, period, direction=way, **own, **rest)


def _steep(asked: Values, way: float, rest: Values, found: Findings) -> Waves | None:
    """Return a steep regular wave; None, with a problem noted, when there is none or the package is missing."""
    theory, height, period = (asked[key] for key in ("spectrum", "height", "period"))
    try:
        phase = np.deg2rad(asked.get("phase", 0.0))
        return Waves.steep(theory, height, period, direction=way, phase=phase, order=asked.get("order"), **rest)
    except ImportError:
        found.add(f"{theory} waves need the package raschii", "pip install 'moorage[waves]'", asked["source"], theory)
    except ValueError as error:
        what = f"there is no {theory} wave of {height:g} m and {period:g} s: {error}"
        found.add(what, "give a lower height, another order, or regular", asked["source"], height)
    return None


def _has_sense(asked: Values, useless: set[str], found: Findings) -> bool:
    """Note the first value that is out of its range, or that means nothing for the spectrum."""
    for key in ("height", "period", "components", "spreading", "gamma", "order"):
        if key in asked and not asked[key] > 0.0:
            found.add(f"{key} of the waves must be positive", "correct it", asked["source"], asked[key])
            return False
    if asked.get("components", 1) > MOST_COMPONENTS:
        remedy = f"give {MOST_COMPONENTS} or less: some hundreds are fine"
        found.add("there are too many components of the waves", remedy, asked["source"], asked["components"])
        return False
    if asked.get("order", 1) > 5 and asked["spectrum"] == "stokes":
        found.add(
            "order of a stokes wave is at most 5", "give 1 to 5, or a stream-function", asked["source"], asked["order"]
        )
        return False
    if asked.get("seed", 0) < 0:
        found.add("seed of the waves must not be negative", "correct it", asked["source"], asked["seed"])
        return False
    if any(not value > 0.0 for value in asked.get("shape", ())):
        found.add("shape of the waves must be positive", "correct it", asked["source"], asked["shape"])
        return False
    for key in ("second", "shape"):
        if len(asked.get(key, (1.0, 1.0))) != 2:
            found.add(f"{key} of the waves has {len(asked[key])} values", "give two", asked["source"], asked[key])
            return False
    for key in sorted(useless):
        found.add(f"{key} means nothing for {asked['spectrum']} waves", "remove it", asked["source"], asked[key])
    return not useless


def stands(height: float, period: float, water: Values, asked: Values, found: Findings) -> bool:
    """Note waves that are too steep to be (Miche's limit for the wave of the peak period)."""
    k = float(wavenumbers(np.array([2.0 * np.pi / period]), water["depth"], water["gravity"])[0])
    highest = STEEPEST * 2.0 * np.pi / k * np.tanh(k * water["depth"])
    if height <= highest:
        return True
    what = f"waves of {height:g} m and {period:g} s would break: they are {2.0 * np.pi / k:.3g} m long"
    found.add(what, f"give a height below {highest:.3g} m, or a longer period", asked["source"], height)
    return False
