"""A result that stays in memory, with the same face as one on disk."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr

from moorage.results.bend_check import bend_attributes, has_limits
from moorage.results.columns import Layout
from moorage.results.dataset import join_columns


class MemoryResult:
    """Collects the columns of successive blocks."""

    def __init__(self, layout: Layout, attrs: Mapping[str, object]):
        self.layout, self.attrs = layout, dict(attrs)
        self._parts: list[Mapping[str, np.ndarray]] = []

    def append(self, columns: Mapping[str, np.ndarray]) -> None:
        """Keep one block."""
        self._parts.append(columns)

    def close(self, attrs: Mapping[str, object]) -> None:
        """Add the attributes that are known at the end."""
        self.attrs |= attrs
        if has_limits(self.layout) and self._parts:
            self.attrs |= bend_attributes(self.dataset())

    def dataset(self) -> xr.Dataset:
        """Return what has been collected."""
        return join_columns(self.layout, self._parts, self.attrs)
