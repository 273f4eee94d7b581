"""Properties of all segments of a model, one row each, and how they are shared between nodes.

A section, a bend stiffener and buoyancy modules are all just segments with properties.
"""

from __future__ import annotations

import numpy as np

from moorage.model import BendStiffener, BuoyancyModules, Curve, Line, LineType, Model, Rod
from moorage.system.objects import rigid_rods, rod_length

_FIELDS = (
    "length",  # unstretched, m
    "diameter",  # outer, of seabed contact and of the water line, m
    "area",  # displaced volume for each metre, m2
    "width",  # that faces transverse flow, m
    "girth",  # wetted circumference over pi, m
    "mass",  # kg/m
    "axial_stiffness",  # EA, of a table its first slope, N
    "axial_damping",  # BA, N s
    "damping_ratio",  # NaN: BA as given
    "pushes",  # 1: carries axial compression
    "bending_stiffness",  # EI, of a table its first slope, N m2
    "added_normal",  # Ca, -
    "added_axial",  # CaAx, -
    "drag_normal",  # Cd, -
    "drag_axial",  # CdAx, -
)
_TABLES = ("axial_curve", "damping_curve", "bending_curve")
_DTYPE = [(name, float) for name in _FIELDS] + [(name, object) for name in _TABLES]


def segment_table(model: Model) -> np.ndarray:
    """Return a structured array (segments,), those of lines in the order of the file and then of rods, in SI units."""
    parts = [_line_table(model, line) for line in model.lines]
    parts += [_rod_table(model, rod) for rod in rigid_rods(model)]
    return np.concatenate(parts) if parts else np.zeros(0, dtype=_DTYPE)


def _line_table(model: Model, line: Line) -> np.ndarray:
    sections = []
    for section in line.sections:
        part = _type_rows(model.line_type(section.line_type), section.segments)
        part["length"] = section.segment_lengths
        if section.modules:
            _add_modules(part, section.modules)
        sections.append(part)
    table = np.concatenate(sections)
    for stiffener in line.stiffeners:
        _add_stiffener(table if stiffener.end == "A" else table[::-1], stiffener)
    return table


def _rod_table(model: Model, rod: Rod) -> np.ndarray:
    """Return the segments of a rod: nothing is stretched or bent between its nodes."""
    kind = next(t for t in model.rod_types if t.name.lower() == rod.rod_type.lower())
    rows = np.zeros(rod.segments, dtype=_DTYPE)
    rows["length"] = rod_length(rod) / rod.segments
    rows["diameter"] = rows["width"] = rows["girth"] = kind.diameter
    rows["area"] = np.pi / 4.0 * kind.diameter**2
    rows["mass"] = kind.mass_per_length
    rows["added_normal"], rows["drag_normal"] = kind.transverse_added_mass, kind.transverse_drag
    for name in _TABLES:
        rows[name] = 0.0
    return rows


def _type_rows(kind: LineType, count: int) -> np.ndarray:
    rows = np.zeros(count, dtype=_DTYPE)
    EA, BA, EI = kind.axial_stiffness, kind.axial_damping, kind.bending_stiffness
    rows["diameter"] = rows["width"] = rows["girth"] = kind.diameter
    rows["area"] = np.pi / 4.0 * kind.diameter**2
    rows["mass"] = kind.mass_per_length
    rows["axial_stiffness"] = initial_slope(EA)
    rows["axial_damping"] = 0.0 if isinstance(BA, Curve) else BA
    rows["damping_ratio"] = np.nan if kind.axial_damping_ratio is None else kind.axial_damping_ratio
    rows["bending_stiffness"] = initial_slope(EI)
    rows["pushes"] = kind.carries_compression
    rows["added_normal"], rows["added_axial"] = kind.transverse_added_mass, kind.tangential_added_mass
    rows["drag_normal"], rows["drag_axial"] = kind.transverse_drag, kind.tangential_drag
    rows["axial_curve"], rows["damping_curve"], rows["bending_curve"] = EA, BA, EI
    return rows


def _add_modules(rows: np.ndarray, modules: BuoyancyModules) -> None:
    """Smear modules over the segments: mass, net volume and faces, for each metre of line."""
    d, D, share = rows["diameter"].copy(), modules.diameter, modules.length / modules.pitch
    rows["mass"] += modules.mass / modules.pitch
    rows["area"] += np.pi / 4.0 * (D**2 - d**2) * share
    rows["width"] += (D - d) * share
    rows["girth"] += (D - d) * share
    rows["diameter"] = D


def _add_stiffener(rows: np.ndarray, stiffener: BendStiffener) -> None:
    """Add a sleeve to the rows from its root on; a segment at the tip takes the covered fraction."""
    ends = np.concatenate([[0.0], np.cumsum(rows["length"])])
    for k in range(len(rows)):
        start, stop = ends[k], min(ends[k + 1], stiffener.length)
        if start >= stiffener.length:
            break
        covered = (stop - start) / rows["length"][k]
        middle = 0.5 * (start + stop)
        d, D = rows["diameter"][k], stiffener.diameter(middle)
        if stiffener.stiffness is not None:
            EI = float(np.interp(middle, stiffener.stiffness.x, stiffener.stiffness.y))
        else:
            EI = stiffener.youngs_modulus * np.pi / 64.0 * (D**4 - d**4)
        sleeve = np.pi / 4.0 * (D**2 - d**2)
        rows["bending_stiffness"][k] += covered * EI
        rows["mass"][k] += covered * stiffener.density * sleeve
        rows["area"][k] += covered * sleeve
        rows["width"][k] += covered * (D - d)
        rows["girth"][k] += covered * (D - d)
        rows["diameter"][k] += covered * (D - d)


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

    def __call__(self, values):
        """Return (nodes,) sums of half of the values (segments,) beside each node."""
        out = np.zeros(self.n)
        out[self.after] += 0.5 * values
        out[self.after + 1] += 0.5 * values
        return out
