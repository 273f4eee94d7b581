"""A result on disk while the run goes on: NetCDF-4, extended block by block, each block on disk before the next.

A process can be killed at any instant. HDF5 writes the end of its file last of all, so that a kill between the
allocation of new storage and that write leaves a file that cannot be opened. Therefore the storage of every variable
is laid out once, for the whole run, by the first block (one chunk, filled only as it is written); later blocks change
data in place and the lengths of the variables, and every state of the file in between can be read.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import netCDF4
import numpy as np
import xarray as xr

from moorage.errors import Problem, ResultError
from moorage.results.bend_check import bend_attributes, has_limits
from moorage.results.columns import Layout
from moorage.results.reader import open_result
from moorage.variables import FLAGS, VARIABLES, attributes

RUNNING = "running"
CHUNK_BYTES = 1 << 30  # HDF5 allows 4 GiB


class StreamWriter:
    """Writes the columns of successive blocks into a file.

    Parameters
    ----------
    path : Path
    layout : Layout
        The variables.
    rows : mapping of str to int
        Number of times that the whole run will have in "time" and "node_time".
    attrs : mapping
        Attributes of the result.
    written : mapping of str to int, optional
        Go on with an existing file after so many times.
    """

    def __init__(
        self,
        path: Path,
        layout: Layout,
        rows: Mapping[str, int],
        attrs: Mapping[str, object],
        written: Mapping[str, int] | None = None,
    ):
        self.path, self.layout, self.rows = path, layout, rows
        self.written = dict(written) if written else {"time": 0, "node_time": 0}
        try:
            if not written:
                path.unlink(missing_ok=True)  # a dataset that still reads the old file keeps it
            self._file = netCDF4.Dataset(path, "a" if written else "w", format="NETCDF4")
        except OSError as error:
            raise ResultError(
                Problem(
                    f"cannot write {path}: {error.strerror or error}",
                    "give another file with -o, or close the dataset or program that has it open",
                )
            ) from error
        if written:
            for name in layout.names:
                self._file[name].set_var_chunk_cache(size=1)
        else:
            self._create(attrs)
        self._file.status = RUNNING

    def append(self, columns: Mapping[str, np.ndarray]) -> None:
        """Write one block; when this returns the block is in the file."""
        for name, values in columns.items():
            row = self.written[self._time_of(name)]
            if len(values):
                self._file[name][row : row + len(values)] = values
        for time in self.written:
            self.written[time] += len(columns.get(time, ()))
        self._file.sync()

    def close(self, attrs: Mapping[str, object]) -> None:
        """Add the attributes that are known at the end, and close the file."""
        if self._file.isopen():
            self._file.setncatts(dict(attrs) | (bend_attributes(self._file) if has_limits(self.layout) else {}))
            self._file.close()

    def dataset(self) -> xr.Dataset:
        """Open the file for reading; values are read when they are used."""
        return open_result(self.path)

    def _time_of(self, name: str) -> str:
        return self.layout.dims(name)[0]

    def _create(self, attrs: Mapping[str, object]) -> None:
        self._file.set_fill_off()  # storage is not filled when it is laid out: it may be gigabytes
        used = {frozenset(self.layout.dims(name)) for name in self.layout.names}
        alone = [  # those of which no variable has the dimensions, and which are none themselves
            name
            for name in self.layout.coordinates()
            if (name,) != VARIABLES[name].dims and not any(dims.issuperset(VARIABLES[name].dims) for dims in used)
        ]
        self._file.setncatts(dict(attrs) | ({"coordinates": " ".join(alone)} if alone else {}))
        for name, size in self.layout.sizes.items():
            self._file.createDimension(name, size)
        for name, values in self.layout.coordinates().items():
            kind = str if values.dtype == object else values.dtype
            variable = self._file.createVariable(name, kind, VARIABLES[name].dims)
            variable.setncatts(attributes(name))
            variable[:] = values
        for name in self.layout.names:
            if name in ("time", "node_time"):
                self._file.createDimension(name, None)
            self._create_column(name)

    def _create_column(self, name: str) -> None:
        """Create a variable over time whose storage is one chunk.

        Its chunk cache is off: HDF5 would rewrite the cached chunk at each flush. What is missing reads as NaN.
        """
        dims = self.layout.dims(name)
        sizes = [self.layout.sizes[dim] for dim in dims[1:]]
        length = max(1, min(self.rows[dims[0]], CHUNK_BYTES // (8 * max(1, int(np.prod(sizes))))))
        kind = "i1" if name in FLAGS else "f8"
        fill = None if name in ("time", "node_time", *FLAGS) else np.nan
        variable = self._file.createVariable(
            name, kind, dims, chunksizes=[length, *(max(1, n) for n in sizes)], chunk_cache=1, fill_value=fill
        )
        extra = {"coordinates": self._coordinates_of(dims)} if self._coordinates_of(dims) else {}
        variable.setncatts(self.layout.attributes(name) | extra)

    def _coordinates_of(self, dims: tuple[str, ...]) -> str:
        """Return the CF list of coordinates that are not dimensions."""
        return " ".join(
            name for name in self.layout.coordinates() if name not in dims and set(VARIABLES[name].dims) <= set(dims)
        )
