"""The sea as a page draws it: its components."""

from __future__ import annotations

import numpy as np
import xarray as xr

from moorage.results.sea import WORDS

CELLS = 140  # of the drawn surface along its longer side
FINEST = 3.0  # cells in the shortest wave that is drawn
MOST = 200  # components that are drawn
TOLD = 0.02  # part of the energy that may be left out without a note


def sea(ds: xr.Dataset, region: np.ndarray, origin: np.ndarray) -> tuple[dict, str]:
    """Return the components (amplitude m, k_x, k_y 1/m, frequency rad/s, phase rad), ramp (s), and a note.

    Phases are those at `origin` (2,), m. Still water has no components: that of statics, which know no waves.
    """
    if "wave_frequency" not in ds.coords or "wave_elevation" not in ds:
        return {"components": [], "ramp": 0.0, "cells": 1, "asked": ""}, ""
    a, w, phase, b, k = (ds[f"wave_{name}"].values for name in WORDS)
    shortest = FINEST * max(region[2] - region[0], region[3] - region[1]) / CELLS
    drawn = np.flatnonzero(2.0 * np.pi >= k * shortest)
    drawn = np.sort(drawn[np.argsort(-a[drawn])][:MOST])
    left_out = 1.0 - (a[drawn] ** 2).sum() / max((a**2).sum(), 1e-300)
    kx, ky = k * np.cos(b), k * np.sin(b)
    table = np.stack([a, kx, ky, w, (phase - kx * origin[0] - ky * origin[1]) % (2.0 * np.pi)], axis=-1)[drawn]
    note = f"The drawn sea surface is without its shortest waves ({100.0 * left_out:.0f} % of its energy)."
    return {
        "components": table.tolist(),
        "ramp": float(ds.attrs.get("wave_ramp", 0.0)),
        "cells": CELLS,
        "asked": str(ds.attrs.get("wave_asked", "")),
    }, note if left_out > TOLD else ""
