"""The native file's schema: every key of every object, with unit and meaning. `docs` and the reader both live on it.

Keys are the fields of the dataclasses in `moorage.model`; what is not required has the default that stands there.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Key:
    """A key: the kind of its value, unit, meaning, and whether it must be given.

    Kinds: number, integer, text, flag; number or nearest (that word); vector (three numbers), position (z may be the
    word seabed), numbers (a list); curve (a number, or x and y, or a file); end (of a line); owner (a turbine);
    `one of a, b`; and for nested objects of this schema their name, `list of name` and `map of name`.
    """

    kind: str
    unit: str
    text: str
    required: bool = False


_KIND = "one of fixed, coupled, free, pinned, coupled-pinned"

_DRAWN = {
    "direction": Key("number", "deg", "where the waves go, from x towards y; 0 by default"),
    "spreading": Key("number", "-", "s of cos^2s of half the angle; by default all waves go one way"),
    "components": Key("integer", "-", "number of them; 200 by default"),
    "method": Key("one of random, equal-energy, equal-frequency", "-", "how the spectrum is cut; random by default"),
    "seed": Key("integer", "-", "of what is random; 1 by default"),
}
_USED = {
    "stretching": Key(
        "one of wheeler, vertical, linear, none",
        "-",
        "of the profiles to the surface; wheeler by default, none for stokes and stream-function",
    ),
    "ramp": Key("number", "s", "over which the sea grows from nothing"),
    "exact": Key("flag", "-", "sum at every evaluation; false: along the nodes' paths, 20 times in a peak period"),
}
_PLACE = {  # of a raster
    "origin": Key("numbers", "m", "easting and northing of the model's origin in crs; 0, 0 by default"),
    "heading": Key("number", "deg", "of the x axis, clockwise from the grid's north; 90 by default: to the east"),
    "spacing": Key("number", "m", "of the grid; by default that of the raster"),
    "extent": Key("numbers", "m", "lowest x, highest x, lowest y, highest y of the grid; by default all of it"),
    "crs": Key("text", "-", "coordinate system of the origin, in metres: EPSG:32631, WKT, or metres"),
    "file_crs": Key("text", "-", "coordinate system of the file, when it does not name one"),
}

SCHEMA: dict[str, dict[str, Key]] = {
    "model": {
        "moorage": Key("integer", "-", "version of this format: 1", True),
        "title": Key("text", "-", "what it is"),
        "start": Key("one of static, as-given", "-", "state at time 0: equilibrium, or as described"),
        "output_interval": Key("number", "s", "time between results"),
        "environment": Key("environment", "-", "water and seabed", True),
        "line_types": Key("map of line type", "-", "properties for each metre of line, by name"),
        "points": Key("list of point", "-", "where lines end or meet"),
        "lines": Key("list of line", "-", "lines, each of one or more sections"),
        "rod_types": Key("map of rod type", "-", "properties of rods, by name"),
        "rods": Key("list of rod", "-", "rigid cylinders"),
        "bodies": Key("list of body", "-", "rigid bodies"),
        "turbines": Key("list of turbine", "-", "platforms of a farm, each with a motion of its own"),
        "failures": Key("list of failure", "-", "lines that come off"),
        "controls": Key("list of control", "-", "lines on winches, whose length follows a channel"),
        "external_loads": Key("list of external load", "-", "constant forces and dampers"),
        "outputs": Key("texts", "-", "output channels by MoorDyn's names"),
    },
    "environment": {
        "water_depth": Key("number", "m", "depth of a flat seabed, reference depth of an uneven one", True),
        "gravity": Key("number", "m/s2", "acceleration of gravity"),
        "water_density": Key("number", "kg/m3", "density of water"),
        "seabed_stiffness": Key("number", "Pa/m", "stiffness on the projected area d l of a line"),
        "seabed_stiffness_map": Key("stiffness map", "-", "stiffness over x and y, in place of seabed_stiffness"),
        "seabed_damping": Key("number", "Pa s/m", "damping on the projected area d l of a line"),
        "soil": Key("soil", "-", "soil with suction and a memory, in place of stiffness and damping of the seabed"),
        "friction": Key("friction", "-", "friction of the seabed"),
        "bathymetry": Key("bathymetry", "-", "depths on a rectangular grid"),
        "current": Key("current", "-", "steady current by level, or over time and place"),
        "waves": Key("waves", "-", "Airy waves: components, or with `spectrum` a sea state"),
        "host_waves": Key("flag", "-", "waves come from the program that moves the mooring, or from a function"),
        "unread_water": Key("unread water", "-", "a sea as MoorDyn's options name it, which is not simulated"),
    },
    "friction": {
        "transverse": Key("number", "-", "kinetic coefficient across the line"),
        "axial": Key("number", "-", "kinetic coefficient along the line"),
        "static_ratio": Key("number", "-", "static over kinetic coefficient"),
        "model": Key(
            "one of elastic-slip, stick-slip, soil-curves, saturated-damping, velocity-dependent",
            "-",
            "law of friction",
        ),
        "damping": Key("number", "N s/m", "slope of saturated damping's ramp, for a node and a coefficient of 1"),
        "shear_stiffness": Key("number", "Pa/m", "of the spring that holds a node that sticks, on d l"),
        "shear_damping": Key("number", "-", "of that spring in elastic-slip, over the critical one"),
        "velocity": Key("number", "m/s", "at which stick-slip falls, and velocity-dependent friction sticks"),
        "laid": Key("flag", "-", "statics as laid slack from the anchor and pulled to place; false: without friction"),
        "map": Key("friction map", "-", "coefficients over x and y, in place of axial and transverse"),
        "axial_curve": Key("curve", "m, -", "of soil-curves: displacement and mobilised coefficient along the line"),
        "transverse_curve": Key("curve", "m, -", "the same across the line"),
    },
    "soil": {
        "shear_strength": Key("number", "Pa", "undrained, at the mudline", True),
        "strength_gradient": Key("number", "Pa/m", "its growth with depth"),
        "bearing_factor": Key("number", "-", "a of the bearing capacity a (z/D)^b"),
        "bearing_exponent": Key("number", "-", "b of the bearing capacity"),
        "maximum_stiffness": Key("number", "-", "stiffness at every turn of the motion, times D over the bearing"),
        "suction_ratio": Key("number", "-", "greatest suction over the bearing"),
        "suction_decay": Key("number", "-", "uplift over which suction dies out, of the greatest penetration"),
        "repenetration_offset": Key("number", "-", "how much deeper resistance is regained, of the uplift"),
        "density": Key("number", "kg/m3", "of the saturated soil, which buoys the line; without it there is no lift"),
        "buoyancy_factor": Key("number", "-", "of that lift, for soil that heaves"),
    },
    "friction map": {
        "x": Key("numbers", "m", "grid in x, increasing; the edges go on outside", True),
        "y": Key("numbers", "m", "grid in y, increasing", True),
        "axial": Key("table", "-", "one row for each x: kinetic coefficients along the line at every y", True),
        "transverse": Key("table", "-", "the same across the line", True),
    },
    "stiffness map": {
        "x": Key("numbers", "m", "grid in x, increasing; the edges go on outside", True),
        "y": Key("numbers", "m", "grid in y, increasing", True),
        "stiffness": Key("table", "Pa/m", "one row for each x: stiffnesses on d l at every y", True),
    },
    "friction map file": {
        "axial_file": Key("text", "-", "raster of the coefficients along the line", True),
        "transverse_file": Key("text", "-", "raster of those across the line; by default the same"),
        **_PLACE,
        "fill": Key("number or nearest", "-", "coefficient where a raster has none, or that of the nearest cell"),
    },
    "stiffness map file": {
        "file": Key("text", "Pa/m", "raster of the stiffness", True),
        **_PLACE,
        "fill": Key("number or nearest", "Pa/m", "stiffness where the raster has none, or that of the nearest cell"),
    },
    "bathymetry": {
        "x": Key("numbers", "m", "grid in x, increasing", True),
        "y": Key("numbers", "m", "grid in y, increasing", True),
        "depth": Key("table", "m", "one row for each x: depths at every y, positive", True),
        "smooth": Key("flag", "-", "bicubic between the points, with a continuous normal; false: bilinear"),
    },
    "bathymetry file": {
        "file": Key("text", "-", "raster: .tif, .asc, .nc, .xyz, .csv or .txt", True),
        **_PLACE,
        "fill": Key("number or nearest", "m", "depth where the raster has none, or that of the nearest cell"),
        "water_level": Key("number", "m", "height of the still water in the heights of the file"),
        "smooth": Key("flag", "-", "bicubic between the points, with a continuous normal; false: bilinear"),
    },
    "current": {
        "z": Key("numbers", "m", "levels, increasing, negative below the water", True),
        "velocity": Key("table", "m/s", "x, y and z component at each level", True),
    },
    "current grid": {
        "t": Key("numbers", "s", "times, increasing; left out for a current that does not change"),
        "x": Key("numbers", "m", "increasing, along the grid's x axis; left out where it is the same everywhere"),
        "y": Key("numbers", "m", "the same along its y axis"),
        "z": Key("numbers", "m", "levels, increasing, negative below the water"),
        "velocity": Key("table", "m/s", "x, y and z component at each point: z changes fastest, then y, x and t", True),
        "turn": Key("number", "rad", "angle of the grid's axes against the model's"),
    },
    "current file": {
        "file": Key("text", "-", "NetCDF file of velocities over depth, time and place, with units", True),
        "start": Key("text", "-", "time 0 of the run as a date, such as 2020-01-31T12:00; by default the file's first"),
        "origin": Key("numbers", "m or deg", "x and y of the model's origin in the file, or longitude and latitude"),
        "heading": Key("number", "deg", "of the x axis, clockwise from north; 90 by default: to the east"),
    },
    "current in words": {
        "speed": Key("number", "m/s", "at the still water level", True),
        "direction": Key("number", "deg", "where it goes, from x towards y; 0 by default"),
        "profile": Key(
            "one of uniform, power", "-", "over the depth h: U, or U (1 + z/h)^exponent; uniform by default"
        ),
        "exponent": Key("number", "-", "of the power law; 1/7 by default"),
    },
    "waves": {
        "frequency": Key("numbers", "rad/s", "of the components", True),
        "amplitude": Key("numbers", "m", "of the components", True),
        "phase": Key("numbers", "rad", "of the components: cos(w t - k x + phase)", True),
        "direction": Key("numbers", "rad", "where each component goes, from x towards y", True),
        "wavenumbers": Key("numbers", "rad/m", "of harmonics of a steep wave; by default of free waves"),
        "crests": Key("numbers", "m", "amplitudes of their elevation; amplitude is then that of the velocity"),
        **_USED,
        "seed": Key("integer", "-", "of what was random, for the record"),
        "asked": Key("pairs", "-", "what they were made from, for the record"),
    },
    "spectrum table": {
        "density": Key(
            "curve", "rad/s, m2 s/rad", "density of the spectrum against frequency: x and y, or a file", True
        ),
        **_DRAWN,
        **_USED,
    },
    "sea state": {
        "spectrum": Key(
            "one of regular, stokes, stream-function, jonswap, pierson-moskowitz, ochi-hubble",
            "-",
            "a wave, or a spectrum",
            True,
        ),
        "height": Key("number", "m", "height of the wave, or significant height", True),
        "period": Key("number", "s", "period of the wave, or of the peak", True),
        "phase": Key("number", "deg", "of a regular wave"),
        "order": Key("integer", "-", "harmonics of stokes (up to 5) or stream-function; 5 and 12 by default"),
        "gamma": Key("number", "-", "peakedness of jonswap; by default by rule from height and period"),
        "second": Key("numbers", "m, s", "significant height and peak period of ochi-hubble's second part"),
        "shape": Key("numbers", "-", "lambda of ochi-hubble's two parts; 3 and 1 by default"),
        **_DRAWN,
        **_USED,
    },
    "wave file": {
        "file": Key("text", "-", "NetCDF file of efth(time, freq, dir), with units", True),
        "time": Key("integer", "-", "number of the time in the file, from 0; 0 by default"),
        "heading": Key("number", "deg", "of the x axis, clockwise from north; 90 by default: to the east"),
        "seed": Key("integer", "-", "of the phases and of the frequencies in their bins; 1 by default"),
        **_USED,
    },
    "unread water": {
        "option": Key("text", "-", "MoorDyn's option: WaveKin, WaterKin or Currents", True),
        "value": Key("text", "-", "its value", True),
        "settings": Key("pairs", "-", "options beside it"),
    },
    "line type": {
        "diameter": Key("number", "m", "volume-equivalent diameter", True),
        "mass_per_length": Key("number", "kg/m", "mass in air", True),
        "axial_stiffness": Key("curve", "N", "EA, or tension against strain", True),
        "axial_damping": Key("curve", "N s", "BA, or tension against strain rate"),
        "axial_damping_ratio": Key("number", "-", "fraction of a segment's critical damping, instead of axial_damping"),
        "bending_stiffness": Key("curve", "N m2", "EI, or moment (N m) against curvature (1/m)"),
        "bending_damping": Key("number", "N m2 s", "internal damping in bending"),
        "transverse_drag": Key("number", "-", "Cd on d l"),
        "tangential_drag": Key("number", "-", "CdAx on pi d l"),
        "transverse_added_mass": Key("number", "-", "Ca on the displaced mass"),
        "tangential_added_mass": Key("number", "-", "CaAx on the displaced mass"),
        "lift_coefficient": Key("number", "-", "Cl of vortex-induced vibration; 0 switches it off"),
        "viv_range": Key("number", "-", "dF of vortex-induced vibration"),
        "viv_centre": Key("number", "-", "cF of vortex-induced vibration"),
        "minimum_bend_radius": Key("number", "m", "allowed bend radius"),
        "minimum_breaking_load": Key("number", "N", "tension that a new line is sure to bear"),
        "carries_compression": Key("flag", "-", "segments push when shorter than unstretched; false: they go slack"),
        "viscoelastic": Key("numbers", "N, -", "dynamic stiffness: EA_d, or c and m of EA_d = c + m T_mean"),
        "dynamic_damping": Key("number", "N s", "damping in series with the dynamic stiffness"),
        "syrope": Key("text", "-", "file of Syrope working curves"),
    },
    "point": {
        "id": Key("integer", "-", "number", True),
        "name": Key("text", "-", "name, by which lines may call it"),
        "kind": Key("one of fixed, coupled, free", "-", "held, moved by a motion, or moved by forces", True),
        "position": Key("position", "m", "x, y, z (or seabed); relative to body or turbine when one is given", True),
        "mass": Key("number", "kg", "mass"),
        "volume": Key("number", "m3", "displaced volume"),
        "drag_area": Key("number", "m2", "CdA in all directions"),
        "added_mass": Key("number", "-", "Ca on the displaced mass"),
        "external_force": Key("vector", "N", "constant force"),
        "body": Key("integer", "-", "body that carries it"),
        "turbine": Key("owner", "-", "turbine (number or name) that carries it"),
    },
    "line": {
        "id": Key("integer", "-", "number", True),
        "name": Key("text", "-", "name"),
        "end_a": Key("end", "-", "point (number or name) or `rod 1 A`", True),
        "end_b": Key("end", "-", "point (number or name) or `rod 1 B`", True),
        "sections": Key("list of section", "-", "stretches of one type, from end A to end B", True),
        "outputs": Key("text", "-", "MoorDyn's letters of its own output file"),
        "syrope_tensions": Key("numbers", "N", "highest and present mean tension at the start"),
        "stiffeners": Key("list of bend stiffener", "-", "tapered bend stiffeners at its ends"),
        "end_a_stiffness": Key("number", "N m/rad", "rotational stiffness of end A on a rod; 0 pins, absent clamps"),
        "end_b_stiffness": Key("number", "N m/rad", "rotational stiffness of end B on a rod; 0 pins, absent clamps"),
    },
    "section": {
        "line_type": Key("text", "-", "name of a line type", True),
        "length": Key("number", "m", "unstretched length", True),
        "segments": Key("integer", "-", "number of segments", True),
        "grading": Key("number", "-", "length of the last segment over that of the first; 1 for equal segments"),
        "modules": Key("buoyancy modules", "-", "discrete modules, smeared over the segments"),
    },
    "buoyancy modules": {
        "diameter": Key("number", "m", "outer diameter", True),
        "length": Key("number", "m", "length of one module", True),
        "mass": Key("number", "kg", "mass of one module", True),
        "pitch": Key("number", "m", "one module every so many metres", True),
    },
    "bend stiffener": {
        "end": Key("one of A, B", "-", "end of the line at which its root is", True),
        "length": Key("number", "m", "from root to tip", True),
        "root_diameter": Key("number", "m", "outer diameter at the root", True),
        "tip_diameter": Key("number", "m", "outer diameter at the tip", True),
        "youngs_modulus": Key("number", "Pa", "of the sleeve; adds E pi / 64 (D^4 - d^4)"),
        "density": Key("number", "kg/m3", "of the sleeve; adds mass"),
        "stiffness": Key("curve", "N m2", "added EI against the distance from the root (m), instead of a modulus"),
    },
    "rod type": {
        "diameter": Key("number", "m", "diameter", True),
        "mass_per_length": Key("number", "kg/m", "mass in air", True),
        "transverse_drag": Key("number", "-", "Cd of the side"),
        "transverse_added_mass": Key("number", "-", "Ca of the side"),
        "end_drag": Key("number", "-", "Cd of an end"),
        "end_added_mass": Key("number", "-", "Ca of an end"),
    },
    "rod": {
        "id": Key("integer", "-", "number", True),
        "name": Key("text", "-", "name"),
        "rod_type": Key("text", "-", "name of a rod type", True),
        "kind": Key(_KIND, "-", "how it is held", True),
        "end_a": Key("vector", "m", "end A", True),
        "end_b": Key("vector", "m", "end B; for a rod without length, a point that it looks at", True),
        "segments": Key("integer", "-", "number of segments, 0 for a rod without length", True),
        "body": Key("integer", "-", "body that carries it"),
        "turbine": Key("owner", "-", "turbine (number or name) that carries it"),
        "outputs": Key("text", "-", "MoorDyn's letters of its own output file"),
    },
    "body": {
        "id": Key("integer", "-", "number", True),
        "name": Key("text", "-", "name"),
        "kind": Key(_KIND, "-", "how it is held", True),
        "position": Key("vector", "m", "reference point", True),
        "rotation": Key("vector", "rad", "intrinsic XYZ angles"),
        "mass": Key("number", "kg", "mass without what it carries"),
        "centre_of_gravity": Key("vector", "m", "from the reference point"),
        "inertia": Key("vector", "kg m2", "diagonal about the centre of gravity"),
        "volume": Key("number", "m3", "displaced volume"),
        "drag_area": Key("numbers", "m2, m5", "CdA of six components"),
        "added_mass": Key("numbers", "-", "Ca of six components"),
        "turbine": Key("owner", "-", "turbine (number or name) that carries it"),
    },
    "turbine": {
        "id": Key("integer", "-", "number", True),
        "name": Key("text", "-", "name, by which what is on it may call it"),
        "position": Key("vector", "m", "reference point; what is on it is described from there", True),
        "motion": Key("text", "-", "file with its motion: time, surge, sway, heave, roll, pitch, yaw"),
    },
    "failure": {
        "id": Key("integer", "-", "number", True),
        "attachment": Key("end", "-", "point or rod end that lines come off", True),
        "lines": Key("integers", "-", "lines that come off", True),
        "time": Key("number", "s", "when; 0 for never"),
        "tension": Key("number", "N", "at which tension; 0 for never"),
    },
    "control": {
        "channel": Key("integer", "-", "number", True),
        "lines": Key("integers", "-", "lines that follow it", True),
        "end": Key("one of A, B", "-", "end of the lines at the winch; B by default"),
        "length": Key("curve", "s, m", "length paid out over time, negative: hauled in"),
        "rate": Key("curve", "s, m/s", "its rate over time, or a constant one, in place of length"),
        "segment_range": Key("numbers", "-", "shortest and longest segment at the winch, over one as described"),
    },
    "external load": {
        "id": Key("integer", "-", "number", True),
        "target": Key("one of body, rod, point", "-", "what it acts on", True),
        "target_id": Key("integer", "-", "its number", True),
        "force": Key("vector", "N", "constant force"),
        "linear_damping": Key("numbers", "N s/m", "for each axis; transverse and axial for a rod"),
        "quadratic_damping": Key("numbers", "N s2/m2", "for each axis; transverse and axial for a rod"),
        "local": Key("flag", "-", "in the object's axes"),
    },
}

# what an object is when it has a certain key
BY_KEY = {
    "bathymetry": {"file": "bathymetry file"},
    "friction map": {"axial_file": "friction map file"},
    "stiffness map": {"file": "stiffness map file"},
    "waves": {"density": "spectrum table", "spectrum": "sea state", "file": "wave file"},
    "current": {"speed": "current in words", "file": "current file", "t": "current grid", "x": "current grid"},
}


def as_markdown() -> str:
    """Return the schema as the tables of `docs/native-file.md`."""
    lines = [
        "# The native model file",
        "",
        "A YAML file (`.yaml`, `.yml`) that says what a MoorDyn file says, in readable names, with several sections",
        "for each line. This page is made from the schema that the reader checks with (`moorage.io.schema`).",
        "",
        "What is not required has a default. A *curve* is a number, `{x: [...], y: [...]}`, or `{file: name}` with two",
        "columns; the z of a *position* may be the word `seabed`; an *end* is a point's number or name, or `rod 1 A`.",
        "An *owner* is a turbine's number or name. A number means the thing of that number; a name that two have calls",
        "neither.",
        "A *bathymetry* with the key `file` is a *bathymetry file*: a raster, see [the seabed](seabed.md); so are a",
        "*friction map* with the key `axial_file` and a *stiffness map* with the key `file`;",
        "*waves* with the key `spectrum` are a *sea state*, with `density` a *spectrum table*, with `file` a *wave",
        "file*, see [waves](waves.md);",
        "a *current* with the key `speed` is a *current in words*, with `file` a *current file*, with `t` or `x` a",
        "*current grid*.",
    ]
    for name, keys in SCHEMA.items():
        lines += ["", f"## {name}", "", "| key | value | unit | meaning | required |", "|---|---|---|---|---|"]
        for key, entry in keys.items():
            required = "yes" if entry.required else ""
            lines.append(f"| `{key}` | {entry.kind} | {entry.unit} | {entry.text} | {required} |")
    return "\n".join(lines) + "\n"
