"""VTK's XML files of polygonal data (.vtp), series of them (.pvd) and groups (.vtm), with binary values in base64.

Source: VTK, "VTK XML Formats": each binary array is its size in bytes, as UInt64, and its values, both in one base64
text.
"""

from __future__ import annotations

import base64
import struct
from collections.abc import Mapping, Sequence
from pathlib import Path
from xml.sax.saxutils import quoteattr

import numpy as np

HEAD = '<?xml version="1.0"?>\n<VTKFile type="{}" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
TYPES = {"f8": "Float64", "f4": "Float32", "i8": "Int64", "i4": "Int32", "i1": "Int8", "u1": "UInt8"}
CELLS = ("Verts", "Lines", "Strips", "Polys")

Cells = Sequence[np.ndarray]


def data_array(name: str, values: np.ndarray, unit: str = "") -> str:
    """Return one array, (n,) or (n, components), as an XML element."""
    kind = values.dtype.newbyteorder("<")
    payload = np.ascontiguousarray(values, dtype=kind).tobytes()
    text = base64.b64encode(struct.pack("<Q", len(payload)) + payload).decode()
    label = f"{name} [{unit}]" if unit and unit != "1" else name
    width = values.shape[1] if values.ndim == 2 else 1
    return (
        f'<DataArray type="{TYPES[kind.str[1:]]}" Name={quoteattr(label)} NumberOfComponents="{width}" '
        f'format="binary">{text}</DataArray>\n'
    )


def polydata(
    points: np.ndarray,
    cells: Mapping[str, Cells],
    point_data: Mapping[str, tuple[np.ndarray, str]] | None = None,
    cell_data: Mapping[str, tuple[np.ndarray, str]] | None = None,
) -> str:
    """Return a file of points (n, 3), m.

    Parameters
    ----------
    cells : mapping of "Verts", "Lines" or "Polys" to sequences of point numbers
    point_data, cell_data : mapping of name to (values, unit)
        One row a point, or a cell in the order Verts, Lines, Polys.
    """
    count = {kind: len(cells.get(kind, ())) for kind in CELLS}
    parts = [
        HEAD.format("PolyData"),
        f'<PolyData>\n<Piece NumberOfPoints="{len(points)}" '
        + " ".join(f'NumberOf{kind}="{n}"' for kind, n in count.items())
        + ">\n",
        "<Points>\n" + data_array("Points", np.asarray(points, float).reshape(-1, 3)) + "</Points>\n",
    ]
    for kind in CELLS:
        numbers = [np.asarray(cell, dtype=np.int64) for cell in cells.get(kind, ())]
        joined = np.concatenate(numbers) if numbers else np.zeros(0, dtype=np.int64)
        ends = np.cumsum([len(cell) for cell in numbers], dtype=np.int64)
        parts.append(f"<{kind}>\n{data_array('connectivity', joined)}{data_array('offsets', ends)}</{kind}>\n")
    for tag, data in (("PointData", point_data), ("CellData", cell_data)):
        rows = [data_array(name, np.asarray(values), unit) for name, (values, unit) in (data or {}).items()]
        parts.append(f"<{tag}>\n{''.join(rows)}</{tag}>\n")
    return "".join([*parts, "</Piece>\n</PolyData>\n</VTKFile>\n"])


def collection(files: Sequence[tuple[float, str, Path]]) -> str:
    """Return a series (.pvd) of (time in s, name of the part, file); parts of one time are shown together."""
    numbers = {part: k for k, part in enumerate(dict.fromkeys(part for _, part, _ in files))}
    rows = [
        f'<DataSet timestep="{time!r}" group={quoteattr(part)} part="{numbers[part]}" '
        f"file={quoteattr(file.as_posix())}/>\n"
        for time, part, file in files
    ]
    head = HEAD.format("Collection")
    return head + "<Collection>\n" + "".join(rows) + "</Collection>\n</VTKFile>\n"


def multiblock(files: Mapping[str, Path]) -> str:
    """Return a group (.vtm) of files by name."""
    rows = [
        f'<DataSet index="{k}" name={quoteattr(name)} file={quoteattr(file.as_posix())}/>\n'
        for k, (name, file) in enumerate(files.items())
    ]
    head = HEAD.format("vtkMultiBlockDataSet")
    return head + "<vtkMultiBlockDataSet>\n" + "".join(rows) + "</vtkMultiBlockDataSet>\n</VTKFile>\n"
