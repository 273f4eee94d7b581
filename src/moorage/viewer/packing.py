"""Numbers for a page: 16 bits each, by their columns' ranges, as differences over time, compressed, as text.

A column (a coordinate of a node over time) is cut into 65535 steps from its lowest to its highest value. So a node that
stands still is exact, and one that moves by 10 m is known to 0.1 mm. Rows are stored as differences to the row before,
high bytes apart from low ones, which is what compresses well.
"""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Mapping

import numpy as np

STEPS = 65535


def pack(arrays: Mapping[str, np.ndarray]) -> str:
    """Return tables (rows, columns) as one base64 text: the length of a directory, the directory, and the numbers.

    `page/data.js` reads it.
    """
    directory, parts, offset = {}, [], 0
    for name, values in arrays.items():
        data = _quantised(values)
        directory[name] = {"rows": values.shape[0], "columns": values.shape[1], "offset": offset}
        parts.append(data)
        offset += len(data)
    head = json.dumps(directory).encode()
    body = len(head).to_bytes(4, "little") + head + b"".join(parts)
    return base64.b64encode(zlib.compress(body, 6)).decode("ascii")


def unpack(text: str) -> dict[str, np.ndarray]:
    """Return the tables of a text, as a page reads them."""
    body = zlib.decompress(base64.b64decode(text))
    start = 4 + int.from_bytes(body[:4], "little")
    out = {}
    for name, entry in json.loads(body[4:start]).items():
        rows, columns, at = entry["rows"], entry["columns"], start + entry["offset"]
        low, step = np.frombuffer(body, "<f4", 2 * columns, at).reshape(2, columns)
        high, fine = np.frombuffer(body, np.uint8, 2 * rows * columns, at + 8 * columns).reshape(2, rows, columns)
        number = np.cumsum(high.astype(np.uint16) * 256 + fine, axis=0, dtype=np.uint16)
        out[name] = low + step * number.astype(np.float32)
    return out


def raw_size(arrays: Mapping[str, np.ndarray]) -> int:
    """Return the bytes that tables take before they are compressed."""
    return sum(2 * values.size + 8 * values.shape[1] for values in arrays.values())


def _quantised(values: np.ndarray) -> bytes:
    """Return ranges of the columns, (2, columns) float32, and differences of the rows as two planes of bytes."""
    values = np.asarray(values, float)
    low = values.min(axis=0, initial=np.inf) if len(values) else np.zeros(values.shape[1])
    low = low.astype(np.float32).astype(float)
    step = ((values.max(axis=0, initial=-np.inf) - low) / STEPS).astype(np.float32).astype(float)
    number = np.rint((values - low) / np.where(step > 0.0, step, 1.0)).clip(0, STEPS).astype(np.uint16)
    change = np.diff(number, axis=0, prepend=np.zeros((1, number.shape[1]), np.uint16))  # modulo 65536
    ranges = np.stack([low, np.maximum(step, 0.0)]).astype("<f4")
    return ranges.tobytes() + (change >> 8).astype(np.uint8).tobytes() + (change & 255).astype(np.uint8).tobytes()
