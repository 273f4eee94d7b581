"""The umbilical in one regular wave, MoorDyn-C beside ours; 200 components at all its nodes would take it hours."""

from __future__ import annotations

import dataclasses

import numpy as np
from scipy.interpolate import CubicSpline

from moorage.model import Waves
from moorage.plot.style import COLOURS, new_figure
from studies.bending_2020.umbilical import HEIGHT, LENGTH, PERIOD, RAMP, device_motion, umbilical
from studies.drawing import dress, legend_above
from studies.parts import Effort, Part, table
from studies.peers import has_moordyn, moordyn_c, timed, with_environment

DURATION, LATE = 50.0, 30.0  # s; MoorDyn-C's start is not at rest before 25 s
COUPLING, EVERY = 0.001, 100  # s: the velocity of its top jumps with every coupling step, and tension with it
OPTIONS = {"dtM": 1e-4, "TmaxIC": 60, "dtIC": 2.0, "threshIC": 1e-4, "CdScaleIC": 4.0}
NODES = (56, 26, 54, 5)  # of the four lines that the file for MoorDyn has


def peer(effort: Effort) -> Part:
    """Return tension, places and curvature of both programs, and what they cost."""
    if not (effort.peers and has_moordyn()):
        return Part({}, {"peer": "MoorDyn-C was not run."}, {})
    waves = Waves.regular(HEIGHT, PERIOD, depth=70.0)
    model = with_environment(umbilical(), waves=waves)
    motion = device_motion(dataclasses.replace(waves, ramp=RAMP), DURATION)  # MoorDyn-C has the waves from the start
    ours, wall = timed(model, duration=DURATION, motion=motion, dt_out=COUPLING * EVERY, dt_nodes=COUPLING * EVERY)
    time = COUPLING * np.arange(round(DURATION / COUPLING) + 1)
    path = CubicSpline(motion.time, motion.platform)(time)
    theirs = moordyn_c(model, time, path, EVERY, **OPTIONS)
    apart = np.setdiff1d(np.arange(sum(NODES)), np.cumsum(NODES)[:-1])  # at joints both lines have a node
    late = ours["time"].values > LATE
    tension = ours["fairlead_segment_tension"].values[:, 0] / 1e3, theirs["end_tension"][:, -1] / 1e3
    off = np.linalg.norm(ours["node_position"].values - theirs["node_position"][:, apart], axis=-1)[late]
    numbers = {
        "tension_rms": float(np.sqrt(np.mean((tension[0] - tension[1])[late] ** 2))),
        "tension_mean": float(tension[0][late].mean()),
        "place_rms": float(np.sqrt(np.mean(off**2, axis=0)).max()),
        "wall_ours": wall,
        "wall_theirs": float(theirs["wall"]),
    }
    rows = [
        ("rms difference of the tension at the device, kN", f"{numbers['tension_rms']:.3f}"),
        ("mean tension there, kN", f"{numbers['tension_mean']:.2f}"),
        ("rms distance of the nodes, worst node, m", f"{numbers['place_rms']:.3f}"),
        ("Wall time of Moorage, s", f"{wall:.3f}"),
        (
            "Wall time of MoorDyn-C, s",
            f"{numbers['wall_theirs']:.1f} and {float(theirs['wall_start']):.1f} for its start",
        ),
    ]
    words = table((f"{DURATION:g} s, of which the last {DURATION - LATE:g} s are compared", ""), rows)
    return Part({"peer": numbers}, {"peer": words}, {"peer": _figure(ours, theirs, tension, apart)})


def _figure(ours, theirs, tension, apart):
    figure = new_figure(7.2, 3.0)
    history, bent = figure.subplots(1, 2)
    time = ours["time"].values
    history.plot(time, tension[1], color=COLOURS[1], lw=1.8, label="MoorDyn-C")
    history.plot(time, tension[0], color=COLOURS[0], lw=1.0, label="Moorage")
    dress(history, "time (s)", "tension at the device (kN)")
    history.set_xlim(LATE, time[-1])
    late = time > LATE
    values = np.concatenate([part[late] for part in tension])
    history.set_ylim(values.min() - 0.5, values.max() + 0.5)
    legend_above(history)
    s = LENGTH - ours["arc_length"].values
    bent.plot(s, theirs["node_curvature"][-1, apart], color=COLOURS[1], lw=1.8)
    bent.plot(s, ours["curvature"].values[-1], color=COLOURS[0], lw=1.0)
    dress(bent, "arc length from the device (m)", f"curvature at {time[-1]:.0f} s (1/m)")
    bent.set_xlim(0.0, LENGTH)
    bent.set_ylim(bottom=0.0)
    return figure
