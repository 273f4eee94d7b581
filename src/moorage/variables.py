"""Every quantity of a result: name, symbol, dimensions, unit, long name. Results and plots take them from here."""

from __future__ import annotations

from typing import NamedTuple


class Variable(NamedTuple):
    """One quantity of a result."""

    name: str
    symbol: str
    dims: tuple[str, ...]
    unit: str
    long_name: str


_TABLE = (
    Variable("time", "t", ("time",), "s", "time from the start of the run"),
    Variable("node_time", "t", ("node_time",), "s", "time of the node histories"),
    Variable("wave_elevation", "eta", ("time",), "m", "elevation of the waves at the origin"),
    Variable("wave_frequency", "omega", ("wave_component",), "rad s-1", "angular frequency of a wave component"),
    Variable("wave_amplitude", "A", ("wave_component",), "m", "amplitude of a wave component"),
    Variable("wave_phase", "", ("wave_component",), "rad", "phase of a wave component at the origin at time 0"),
    Variable("wave_direction", "beta", ("wave_component",), "rad", "where a wave component goes, from x towards y"),
    Variable("wave_number", "k", ("wave_component",), "rad m-1", "wavenumber of a wave component"),
    Variable("line", "", ("line",), "1", "id of a line"),
    Variable("line_name", "", ("line",), "1", "name of a line in the input, empty: it has none"),
    Variable("point", "", ("point",), "1", "id of a point"),
    Variable("point_name", "", ("point",), "1", "name of a point in the input, empty: it has none"),
    Variable("point_kind", "", ("point",), "1", "fixed, coupled (moved by prescribed motion) or free"),
    Variable("end_a", "", ("line",), "1", "id of the point or rod at end A of a line"),
    Variable("end_b", "", ("line",), "1", "id of the point or rod at end B of a line"),
    Variable("end_a_kind", "", ("line",), "1", "what holds end A: a fixed, coupled or free point or rod"),
    Variable("end_b_kind", "", ("line",), "1", "what holds end B: a fixed, coupled or free point or rod"),
    Variable("xyz", "", ("xyz",), "1", "component along x, y, z (up)"),
    Variable("fairlead_tension", "T_B", ("time", "line"), "N", "force of the line on its end object at end B"),
    Variable("anchor_tension", "T_A", ("time", "line"), "N", "force of the line on its end object at end A"),
    Variable("static_fairlead_tension", "", ("line",), "N", "at end B in the static solution that the run starts from"),
    Variable("static_anchor_tension", "", ("line",), "N", "at end A in the static solution that the run starts from"),
    Variable("fairlead_force", "F_B", ("time", "line", "xyz"), "N", "force vector of the line on its object at end B"),
    Variable("anchor_force", "F_A", ("time", "line", "xyz"), "N", "force vector of the line on its object at end A"),
    Variable("fairlead_segment_tension", "", ("time", "line"), "N", "tension of the last segment, at end B"),
    Variable("anchor_segment_tension", "", ("time", "line"), "N", "tension of the first segment, at end A"),
    Variable("segment_tension", "T", ("time", "segment"), "N", "tension of a segment, internal damping included"),
    Variable("node_position", "r", ("time", "node", "xyz"), "m", "position of a line node, z up from still water"),
    Variable("node_velocity", "v", ("time", "node", "xyz"), "m s-1", "velocity of a line node"),
    Variable("point_position", "r_p", ("time", "point", "xyz"), "m", "position of a point"),
    Variable("point_velocity", "v_p", ("time", "point", "xyz"), "m s-1", "velocity of a point"),
    Variable("point_force", "F_p", ("time", "point", "xyz"), "N", "force of all lines on a point"),
    Variable("rod", "", ("rod",), "1", "id of a rod"),
    Variable("rod_end", "", ("rod_end",), "1", "end A or B of a rod"),
    Variable("rod_diameter", "d", ("rod",), "m", "diameter of a rod"),
    Variable("body", "", ("body",), "1", "id of a body"),
    Variable("rod_position", "", ("time", "rod", "rod_end", "xyz"), "m", "position of the ends of a rod"),
    Variable("rod_force", "", ("time", "rod", "xyz"), "N", "force on a rod without inertia: lines, weight, water, bed"),
    Variable("rod_moment", "", ("time", "rod", "xyz"), "N m", "moment of these about its end A"),
    Variable("node_rod", "", ("rod_node",), "1", "id of the rod that a node of rods belongs to"),
    Variable("rod_node_number", "", ("rod_node",), "1", "number of a node on its rod, from 0 at end A"),
    Variable("rod_node_force", "", ("time", "rod_node", "xyz"), "N", "force on a rod's node without inertia"),
    Variable("body_position", "", ("time", "body", "xyz"), "m", "position of a body's reference point"),
    Variable("body_rotation", "", ("time", "body", "xyz"), "rad", "roll, pitch and yaw of a body, intrinsic XYZ"),
    Variable("body_force", "", ("time", "body", "xyz"), "N", "force on a body without inertia, with all it carries"),
    Variable("body_moment", "", ("time", "body", "xyz"), "N m", "moment of these about its reference point"),
    Variable("turbine", "", ("turbine",), "1", "number of a turbine"),
    Variable("turbine_name", "", ("turbine",), "1", "name of a turbine"),
    Variable("point_turbine", "", ("point",), "1", "number of the turbine that a point is on, 0: none"),
    Variable("turbine_position", "", ("time", "turbine", "xyz"), "m", "position of a turbine's reference point"),
    Variable("turbine_rotation", "", ("time", "turbine", "xyz"), "rad", "roll, pitch, yaw of a turbine, intrinsic XYZ"),
    Variable("turbine_force", "", ("time", "turbine", "xyz"), "N", "force of the mooring on a turbine"),
    Variable("turbine_moment", "", ("time", "turbine", "xyz"), "N m", "moment of these about its reference point"),
    Variable("grounded_length", "L_g", ("time", "line"), "m", "unstretched length of line on the seabed"),
    Variable("anchor_uplift_angle", "phi_A", ("time", "line"), "rad", "angle of the pull at end A over the seabed"),
    Variable("anchor_uplift_force", "", ("time", "line"), "N", "pull at end A away from the seabed, along its normal"),
    Variable("minimum_tension", "T_min", ("time", "line"), "N", "lowest segment tension of a line"),
    Variable("fairlead_moment", "M_B", ("time", "line", "xyz"), "N m", "moment of the line on the clamp of its end B"),
    Variable("anchor_moment", "M_A", ("time", "line", "xyz"), "N m", "moment of the line on the clamp of its end A"),
    Variable("curvature", "kappa", ("time", "node"), "m-1", "curvature of a line at a node, 0 at pinned ends"),
    Variable("bending_moment", "M", ("time", "node"), "N m", "bending moment at a node"),
    Variable("node_declination", "theta", ("time", "node"), "rad", "tangent towards end B from the vertical, 0 for up"),
    Variable("minimum_bend_radius", "R_min", ("time", "line"), "m", "radius where a line is bent most"),
    Variable("bend_utilisation", "", ("time", "line"), "1", "largest curvature times allowed bend radius"),
    Variable("seabed_gap", "", ("time", "node"), "m", "height of a node over the seabed"),
    Variable("touchdown_position", "r_TD", ("time", "line", "xyz"), "m", "where a line meets the seabed, NaN: nowhere"),
    Variable("touchdown_arc_length", "s_TD", ("time", "line"), "m", "unstretched arc length of that from end A"),
    Variable("seabed_force", "N", ("time", "node"), "N", "force of the seabed on a node along the bed's normal"),
    Variable("friction_force", "F_f", ("time", "node", "xyz"), "N", "friction of the seabed on a node"),
    Variable("sticking", "", ("time", "node"), "1", "1 where friction is below its limit, 0: sliding or off the bed"),
    Variable("friction_power", "", ("time", "line"), "W", "sum of -F.v of friction over the nodes of a line"),
    Variable("dissipated_energy", "", ("time", "line"), "J", "energy that friction took from a line since the start"),
    Variable("line_length", "L", ("time", "line"), "m", "unstretched length of a line, without what is in its winch"),
    Variable("payout_rate", "", ("time", "line"), "m s-1", "rate of that length, positive for payout"),
    Variable("segment_length", "l", ("time", "segment"), "m", "unstretched length of a segment, 0: still in the winch"),
    Variable("arc_length", "s", ("node",), "m", "unstretched arc length of a node from end A"),
    Variable("segment_arc_length", "s_m", ("segment",), "m", "unstretched arc length of a segment's middle from end A"),
    Variable("bed_x", "x", ("bed_x",), "m", "x of the depth grid"),
    Variable("bed_y", "y", ("bed_y",), "m", "y of the depth grid"),
    Variable("bed_level", "z_b", ("bed_x", "bed_y"), "m", "z of the seabed at the points of the depth grid"),
    Variable("node_line", "", ("node",), "1", "id of the line that a node belongs to"),
    Variable("segment_line", "", ("segment",), "1", "id of the line that a segment belongs to"),
    Variable("outer_diameter", "", ("segment",), "m", "of a segment, with modules and stiffeners"),
    Variable("bending_stiffness", "EI", ("segment",), "N m2", "of a segment, stiffeners included; of tables: at first"),
    Variable("allowed_bend_radius", "R_0", ("node",), "m", "smallest radius that the line types allow, 0: any"),
    Variable("breaking_load", "", ("segment",), "N", "tension that the line type is sure to bear, 0: not said"),
    Variable("unstretched_length", "l", ("segment",), "m", "unstretched length of a segment, as an inner one"),
    Variable("stiffness", "K", ("dof", "dof_"), "N m-1", "of the coupled points moved as one platform, in N, m, rad"),
    Variable("dof", "", ("dof",), "1", "force or moment on the platform"),
    Variable("dof_", "", ("dof_",), "1", "displacement or rotation of the platform"),
    Variable("mode", "", ("mode",), "1", "number of a natural mode, the lowest first"),
    Variable("frequency", "f", ("mode",), "Hz", "natural frequency; NaN: the state is not stable in this mode"),
    Variable("period", "T", ("mode",), "s", "natural period"),
    Variable("mode_shape", "", ("mode", "node", "xyz"), "1", "displacement of a node, over the largest of the mode"),
    Variable("point_shape", "", ("mode", "point", "xyz"), "1", "displacement of a point, over the largest of the mode"),
    Variable("rod_shape", "", ("mode", "rod", "rod_end", "xyz"), "1", "displacement of a rod's ends, as mode_shape"),
    Variable("body_shape", "", ("mode", "body", "xyz"), "1", "displacement of a body's reference point, as mode_shape"),
    Variable("body_turn", "", ("mode", "body", "xyz"), "rad m-1", "rotation of a body over the largest displacement"),
    Variable("rod_energy", "", ("mode", "rod"), "1", "share of a rod in the kinetic energy of a mode"),
    Variable("body_energy", "", ("mode", "body"), "1", "share of a body and what is fixed to it in that energy"),
    Variable("line_energy", "", ("mode", "line"), "1", "share of a line in the kinetic energy of a mode"),
    Variable("platform", "", ("platform",), "1", "what moves as one rigid body"),
    Variable("platform_", "", ("platform_",), "1", "what moves as one rigid body, of the displacement"),
    Variable("platform_origin", "", ("platform", "xyz"), "m", "about which a platform turns and moments are taken"),
    Variable(
        "platform_stiffness", "K", ("platform", "dof", "platform_", "dof_"), "N m-1", "load by motion, N, m, rad"
    ),
    Variable("residual", "", (), "N", "largest out-of-balance force on a node or free point"),
    Variable("iterations", "", (), "1", "Newton iterations of the static solution"),
)  # fmt: skip

FLAGS = ("sticking",)  # kept as bytes

VARIABLES: dict[str, Variable] = {variable.name: variable for variable in _TABLE}


def attributes(name: str) -> dict[str, str]:
    """Return the CF attributes of a variable: units, long_name, and the symbol where it has one."""
    v = VARIABLES[name]
    return {"units": v.unit, "long_name": v.long_name} | ({"symbol": v.symbol} if v.symbol else {})
