"""Figures 8 to 11: the umbilical in the sea, with the stiffness-only stiffener and with the tapered one."""

from __future__ import annotations

import dataclasses

import numpy as np
import xarray as xr
from scipy.signal import find_peaks

from moorage.model import Waves
from moorage.plot.style import COLOURS, QUIET, SEABED, new_figure
from studies.bending_2020.umbilical import (
    DURATION,
    JUNCTIONS,
    LENGTH,
    POLYURETHANE,
    SLEEVE,
    STARTED,
    STIFFENER,
    hang_off,
    run,
    sea,
    sleeve_volume,
    statistics,
    tapered,
    umbilical,
)
from studies.drawing import dress, legend_above
from studies.parts import Effort, Part, table
from studies.peers import at_rest

HEAVY = dataclasses.replace(SLEEVE, density=POLYURETHANE)
NAMES = {
    "stiffness": "stiffness only (paper)",
    "tapered": "tapered, adds diameter",
    "heavy": "tapered, of polyurethane",
}
FROM = "arc length from the device (m)"


def models() -> dict:
    """Return the cable with each stiffener."""
    cable = umbilical()
    return {"stiffness": cable, "tapered": tapered(cable), "heavy": tapered(cable, HEAVY)}


def instants(waves: Waves, duration: float) -> dict[str, float]:
    """Return when the highest crest passes the device, and a quarter and half of the peak period later, s."""
    time = np.arange(STARTED, duration - 10.0, 0.5)
    crest = float(time[np.argmax(waves.elevation(time))])
    quarter = round(0.5 * waves.peak_period) / 2.0
    return {"crest": crest, "quarter of a period later": crest + quarter, "half a period later": crest + 2.0 * quarter}


def scenario(effort: Effort) -> Part:
    """Return figures 8 to 11 and what the stiffener does to the tension."""
    waves, duration = sea(), 120.0 if effort.quick else DURATION
    runs = {name: run(model, waves, duration) for name, model in models().items()}
    static = {name: at_rest(model) for name, model in models().items()}
    found = {name: statistics(ds) for name, ds in runs.items()}
    for name, ds in static.items():
        found[name]["static"] = float(ds["fairlead_tension"].values[0] / 1e3)
    times = instants(waves, duration)
    lift = {"stiffness": 0.0, "tapered": 1025.0, "heavy": 1025.0 - POLYURETHANE}
    buoyancy = {name: 9.80665e-3 * density * sleeve_volume() for name, density in lift.items()}
    base = found["stiffness"]
    rows = [
        (NAMES[name], f"{buoyancy[name]:.2f}", f"{one['static']:.3f}", f"{one['mean']:.2f}", f"{one['std']:.2f}",
         f"{one['min']:.2f}", f"{one['max']:.2f}", f"{base['static'] - one['static']:.3f}",
         f"{base['mean'] - one['mean']:.3f}", f"{one['curvature']:.3f}")
        for name, one in found.items()
    ]  # fmt: skip
    words = table(
        ("stiffener", "its net lift, kN", "static, kN", "mean", "std", "lowest", "highest", "paper's minus this",
         "and in the sea", "largest curvature, 1/m"), rows,
    )  # fmt: skip
    at = {name: along(runs["stiffness"], time) for name, time in times.items()}
    snapshots = table(
        ("instant", "time, s", "at the device", "lowest (arc length, m)", "at the junctions", "at the anchor",
         "largest curvature, 1/m (arc length, m)"),
        [
            (name, f"{times[name]:.1f}", f"{a.tension[-1]:.2f}",
             f"{a.tension.min():.2f} ({a.middle[a.tension.argmin()]:.1f})",
             ", ".join(f"{a.tension[np.abs(a.middle - j).argmin()]:.2f}" for j in JUNCTIONS),
             f"{a.tension[0]:.2f}", f"{a.curvature.max():.4f} ({a.arc[a.curvature.argmax()]:.0f})")
            for name, a in at.items()
        ],
    )  # fmt: skip
    numbers = {
        "umbilical": found,
        "buoyancy": buoyancy,
        "instants": times,
        "offset_share": offset_share(runs["stiffness"], runs["tapered"]),
        "static_peaks": peaks(static["stiffness"]),
    }
    both = {name: runs[name] for name in ("stiffness", "tapered")}
    figures = {
        "figure-8": _profiles(both, times),
        "figure-9": _along(both, times, "tension", "tension (kN)"),
        "figure-10": _along(both, times, "curvature", "curvature (1/m)"),
        "figure-11": _history(both, times),
    }
    share = numbers["offset_share"]
    return Part(numbers, {"stiffeners": words, "snapshots": snapshots, "offset_share": f"{100 * share:.0f} %"}, figures)


@dataclasses.dataclass
class Along:
    """What is along the cable at an instant; arc lengths from the device, m."""

    arc: np.ndarray
    place: np.ndarray  # (nodes, 3) m
    curvature: np.ndarray  # 1/m
    middle: np.ndarray  # of the segments
    tension: np.ndarray  # kN


def along(ds: xr.Dataset, time: float) -> Along:
    """Return what is along the cable at a time (s) of a run."""
    k = int(np.abs(ds["node_time"].values - time).argmin())
    return Along(
        LENGTH - ds["arc_length"].values, ds["node_position"].values[k], ds["curvature"].values[k],
        LENGTH - ds["segment_arc_length"].values, ds["segment_tension"].values[k] / 1e3,
    )  # fmt: skip


def peaks(ds: xr.Dataset) -> list[float]:
    """Return where along the cable at rest (m from the device) the tension has peaks inside."""
    tension, middle = ds["segment_tension"].values, LENGTH - ds["segment_arc_length"].values
    return sorted(float(s) for s in middle[find_peaks(tension, prominence=50.0)[0]])


def offset_share(one: xr.Dataset, other: xr.Dataset) -> float:
    """Return the share of the time in which the first pulls more than the other."""
    late = one["time"].values >= STARTED
    return float(np.mean(hang_off(one)[late] > hang_off(other)[late]))


def _profiles(runs, times):
    figure = new_figure(7.2, 4.4)
    ax = figure.add_subplot()
    near = ax.inset_axes((0.08, 0.42, 0.34, 0.50))
    for colour, (name, time) in zip(COLOURS, times.items(), strict=False):
        for ds, style in zip(runs.values(), ("-", (0, (2, 1.5))), strict=True):
            place = along(ds, time).place
            for one in (ax, near):
                one.plot(place[:, 0], place[:, 2], color=colour, lw=1.4, ls=style)
        floats = (along(runs["stiffness"], time).arc > JUNCTIONS[0]) & (
            along(runs["stiffness"], time).arc < JUNCTIONS[1]
        )
        place = along(runs["stiffness"], time).place[floats]
        ax.plot(place[:, 0], place[:, 2], color=colour, lw=5.0, alpha=0.25, solid_capstyle="butt")
        ax.plot([], [], color=colour, label=f"{time:.1f} s, {name}")
    ax.plot([], [], color="black", ls="-", label=NAMES["stiffness"])
    ax.plot([], [], color="black", ls=(0, (2, 1.5)), label=NAMES["tapered"])
    ax.plot([], [], color=QUIET, lw=5.0, alpha=0.5, label="floats")
    ax.axhline(-70.0, color=SEABED, lw=1.5)
    dress(ax, "x (m), waves run to the right", "z (m)")
    ax.set_aspect("equal")
    ax.set_xlim(-108.0, 8.0)
    ax.set_ylim(-72.0, -8.0)
    legend_above(ax, 3)
    top = np.array([along(runs["stiffness"], time).place[-1] for time in times.values()])
    near.set_xlim(top[:, 0].min() - 5.0, top[:, 0].max() + 0.7)
    near.set_ylim(top[:, 2].min() - 6.5, top[:, 2].max() + 0.7)
    near.tick_params(labelsize=7)
    near.set_title("at the device", fontsize=8)
    return figure


def _along(runs, times, what, label):
    figure = new_figure(7.2, 4.6)
    axes = figure.subplots(2, 1) if what == "curvature" else [figure.add_subplot()]
    for ax in axes:
        ax.axvspan(0.0, STIFFENER, color=COLOURS[4], alpha=0.25, lw=0, label="stiffener")
        ax.axvspan(*JUNCTIONS, color=QUIET, alpha=0.2, lw=0, label="floats")
        for colour, (name, time) in zip(COLOURS, times.items(), strict=False):
            for ds, style in zip(runs.values(), ("-", (0, (2, 1.5))), strict=True):
                now = along(ds, time)
                s, value = (now.middle, now.tension) if what == "tension" else (now.arc, now.curvature)
                ax.plot(s, value, color=colour, lw=1.2, ls=style)
            ax.plot([], [], color=colour, label=f"{time:.1f} s, {name}")
        ax.plot([], [], color="black", ls="-", label=NAMES["stiffness"])
        ax.plot([], [], color="black", ls=(0, (2, 1.5)), label=NAMES["tapered"])
        dress(ax, FROM, label)
        ax.set_xlim(0.0, LENGTH)
        ax.set_ylim(bottom=0.0)
    if what == "curvature":
        axes[1].set_xlim(0.0, 12.0)
        axes[0].set_xlabel("")
    legend_above(axes[0], 3)
    return figure


def _history(runs, times):
    figure = new_figure(7.2, 4.8)
    whole, part = figure.subplots(2, 1)
    crest = times["crest"]
    for ax in (whole, part):
        for k, (name, ds) in enumerate(runs.items()):
            time, tension = (v[:: 1 if ax is part else 4] for v in (ds["time"].values, hang_off(ds) / 1e3))
            ax.plot(time, tension, color=COLOURS[k], lw=1.0 - 0.3 * k, label=NAMES[name])
        dress(ax, "time (s)", "tension (kN)")
    for time in times.values():
        part.axvline(time, color=QUIET, lw=0.8, ls=(0, (1, 2)))
    whole.set_xlim(0.0, runs["stiffness"]["time"].values[-1])
    part.set_xlim(max(crest - 50.0, 0.0), min(crest + 30.0, runs["stiffness"]["time"].values[-1]))
    legend_above(whole, 3)
    return figure
