"""Properties of all segments of a model, one row each, and how they are shared between nodes."""

from __future__ import annotations

import numpy as np

from moorage.model import Curve, Model

_FIELDS = (
    "length", "diameter", "mass", "weight", "axial_stiffness", "axial_damping", "damping_ratio", "bending_stiffness",
    "added_normal", "added_axial", "drag_normal", "drag_axial",
)  # fmt: skip
_DTYPE = [(name, float) for name in _FIELDS] + [("axial_curve", object), ("damping_curve", object)]


def segment_table(model: Model) -> np.ndarray:
    """Return a structured array (segments,) in the order of the file, in SI units; `weight` is that in water, N/m."""
    env = model.environment
    parts = []
    for line in model.lines:
        for section in line.sections:
            kind = model.line_type(section.line_type)
            part = np.zeros(section.segments, dtype=_DTYPE)
            EA, BA, EI = kind.axial_stiffness, kind.axial_damping, kind.bending_stiffness
            volume = np.pi / 4.0 * kind.diameter**2
            part["length"] = section.length / section.segments
            part["diameter"] = kind.diameter
            part["mass"] = kind.mass_per_length
            part["weight"] = env.gravity * (kind.mass_per_length - env.water_density * volume)
            part["axial_stiffness"] = initial_slope(EA)
            part["axial_damping"] = 0.0 if isinstance(BA, Curve) else BA
            part["damping_ratio"] = np.nan if kind.axial_damping_ratio is None else kind.axial_damping_ratio
            part["bending_stiffness"] = initial_slope(EI)
            part["added_normal"], part["added_axial"] = kind.transverse_added_mass, kind.tangential_added_mass
            part["drag_normal"], part["drag_axial"] = kind.transverse_drag, kind.tangential_drag
            part["axial_curve"], part["damping_curve"] = EA, BA
            parts.append(part)
    return np.concatenate(parts) if parts else np.zeros(0, dtype=_DTYPE)


def initial_slope(value) -> float:
    """Return a stiffness as one number: of a table, its slope from the first row."""
    if not isinstance(value, Curve):
        return float(value)
    return float((value.y[1] - value.y[0]) / (value.x[1] - value.x[0]))


class NodeSum:
    """Gives half of each segment's value to each of its two nodes."""

    def __init__(self, node_ptr):
        self.last = node_ptr[1:] - 1
        self.after = np.delete(np.arange(node_ptr[-1]), self.last)  # first node of every segment
        self.n = int(node_ptr[-1])
        self.ends = np.concatenate([node_ptr[:-1], self.last])

    def __call__(self, values):
        """Return (nodes,) sums of half of the values (segments,) beside each node."""
        out = np.zeros(self.n)
        out[self.after] += 0.5 * values
        out[self.after + 1] += 0.5 * values
        return out

    def inner_mean(self, values):
        """Mean of the two segments that meet at a node, zero at the ends of a line."""
        out = self(values)
        out[self.ends] = 0.0
        return out
