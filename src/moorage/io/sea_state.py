"""Waves of a native file: components as they are, or a sea state in words."""

from __future__ import annotations

from typing import Any

import numpy as np

from moorage.io.text import Findings
from moorage.model import Waves
from moorage.model.spectra import wavenumbers

STEEPEST = 0.142  # height over length at which a wave breaks in deep water (Miche 1944)
Values = dict[str, Any]


def components(asked: Values, water: Values, found: Findings) -> Waves | None:
    """Return waves of given components; None, with problems noted, when they cannot be made."""
    counts = {key: len(asked[key]) for key in ("frequency", "amplitude", "phase", "direction")}
    if len(set(counts.values())) > 1:
        given = ", ".join(f"{count} of {key}" for key, count in counts.items())
        found.add("components of the waves do not have one of each", "give as many of each", asked["source"], given)
        return None
    for value in asked["frequency"]:
        if not value > 0.0:
            found.add("frequency of a wave component must be positive", "correct or remove it", asked["source"], value)
            return None
    return Waves(**asked, **water)


WORDS = {
    "regular": {"phase"},
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
    rest: Values = {key: asked[key] for key in ("stretching", "ramp", "exact", "source") if key in asked} | water
    way = np.deg2rad(asked.get("direction", 0.0))
    if spectrum == "regular":
        return Waves.regular(height, period, direction=way, phase=np.deg2rad(own.get("phase", 0.0)), **rest)
    return Waves.irregular(spectrum, height, period, direction=way, **own, **rest)


def _has_sense(asked: Values, useless: set[str], found: Findings) -> bool:
    """Note the first value that is out of its range, or that means nothing for the spectrum."""
    for key in ("height", "period", "components", "spreading", "gamma"):
        if key in asked and not asked[key] > 0.0:
            found.add(f"{key} of the waves must be positive", "correct it", asked["source"], asked[key])
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
