"""Whether a line bore more than its type's minimum breaking load.

Verified by tests/unit/test_breaking_load.py.
"""

from __future__ import annotations

import warnings

import numpy as np
import xarray as xr

from moorage.errors import ModelWarning


def overloads(ds: xr.Dataset) -> list[str]:
    """Return in words, for every line that bears more than its type is sure to, the worst segment."""
    if "breaking_load" not in ds.coords or "segment_tension" not in ds:
        return []
    tension, strength = ds["segment_tension"].values, ds["breaking_load"].values
    used = np.where(strength > 0.0, np.atleast_2d(tension) / np.where(strength > 0.0, strength, 1.0), 0.0)
    found, owner = [], ds["segment_line"].values
    for line in ds["line"].values:
        rows = np.flatnonzero(owner == line)
        when, k = np.unravel_index(np.argmax(used[:, rows]), (len(used), len(rows)))
        j = rows[k]
        if used[when, j] > 1.0:
            moment = f" at {float(ds[ds['segment_tension'].dims[0]].values[when]):g} s" if tension.ndim == 2 else ""
            found.append(
                f"line {line} bears {used[when, j] * strength[j] / 1e3:.4g} kN, more than its minimum breaking load of "
                f"{strength[j] / 1e3:.4g} kN, {float(ds['segment_arc_length'].values[j]):.4g} m from end A{moment}"
            )
    return found


def warn_of_overloads(ds: xr.Dataset) -> None:
    """Warn of lines that bear more than their types are sure to."""
    for words in overloads(ds):
        warnings.warn(words, ModelWarning, stacklevel=3)
