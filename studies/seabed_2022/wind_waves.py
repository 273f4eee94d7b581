"""Figures 7 and 8: what friction does to line 1 in wind and waves from its side, and to its tension on the bed."""

from __future__ import annotations

import dataclasses

from moorage.model import Friction
from moorage.plot.style import COLOURS, new_figure
from studies.drawing import dress, legend_above
from studies.parts import Effort, Part, table
from studies.seabed_2022.mooring import CHAIN_LENGTH, CHAIN_SEGMENTS, DAMPED, PERIOD, STICKING, in_waves, semi_taut
from studies.seabed_2022.platform import THRUST, in_wind
from studies.seabed_2022.runs import fairlead, node_tension, node_time, ours

LAWS: dict[str, Friction | None] = {
    "no friction": None,
    "saturated damping": DAMPED,
    "sticking, as laid": STICKING,
    "sticking, from rest without friction": dataclasses.replace(STICKING, laid=False),
}
DURATION = {"wind": 1800.0, "waves": 224.0}  # s
DT_NODES = {"wind": 2.0, "waves": 0.25}  # s
COUNTED = {"wind": 1500.0, "waves": 224.0 - 10.0 * PERIOD}  # from these on: at rest again, and ten periods
NODES = (3, 6, 9, 12, 15, 18)  # of the chain, from the anchor
ARC = [n * CHAIN_LENGTH / CHAIN_SEGMENTS for n in NODES]


def study():
    """Return the runs by what moves the platform and by law."""
    motions = {"wind": in_wind(semi_taut(), DURATION["wind"]), "waves": in_waves(DURATION["waves"])}
    runs = {}
    for what, motion in motions.items():
        given = motion, DURATION[what], 0.25
        runs[what] = {
            name: ours(semi_taut(friction=law), *given, dt_nodes=DT_NODES[what])[0] for name, law in LAWS.items()
        }
    return motions, runs


def friction_in_wind_and_waves(effort: Effort) -> Part:
    """Return figures 7 and 8 and their tables."""
    motions, runs = study()
    numbers: dict = {"sway": float(motions["wind"].platform[-1, 1]), "thrust": float(THRUST)}
    rows = []
    for what, found in runs.items():
        numbers[what] = {}
        for name, ds in found.items():
            late = ds["time"].values >= COUNTED[what] - 1e-6
            tension = fairlead(ds)[late]
            one = {"mean": tension.mean(), "std": tension.std(), "min": tension.min(), "max": tension.max()}
            numbers[what][name] = {key: float(value) for key, value in one.items()}
            bare = numbers[what]["no friction"]
            swing = f"{100 * (one['std'] / bare['std'] - 1):+.2f} %" if what == "waves" else "-"
            off = f"{one['mean'] - bare['mean']:+.2f}", f"{100 * (one['mean'] / bare['mean'] - 1):+.2f} %"
            rows.append((what, name, *(f"{v:.2f}" for v in one.values()), *off, swing))
    words = {
        "figure_7": table(
            ("load", "friction", "mean, kN", "std", "lowest", "highest", "from none, kN", "the same", "std from none"),
            rows,
        ),
        "sway": f"{numbers['sway']:.0f}",
        "thrust": f"{THRUST / 1e6:.2f}",
    }  # fmt: skip
    numbers["figure-8"], bed_rows = {}, []
    for name, ds in list(runs["waves"].items())[1:]:
        tension = node_tension(ds, NODES)[node_time(ds) >= COUNTED["waves"] - 1e-6]
        numbers["figure-8"][name] = tension.mean(axis=0).tolist()
        bed_rows.append(
            (name, *(f"{v:.1f} ({s:.1f})" for v, s in zip(tension.mean(axis=0), tension.std(axis=0), strict=True)))
        )
    words["figure_8"] = table(("friction", *(f"node {n}, {s:g} m" for n, s in zip(NODES, ARC, strict=True))), bed_rows)
    return Part({"figures-7-8": numbers}, words, {"figure-7": _figure_7(runs, motions), "figure-8": _figure_8(runs)})


def _figure_7(runs, motions):
    figure = new_figure(7.2, 6.4)
    wind, off, waves = figure.subplots(3, 1, height_ratios=(1.1, 0.8, 1.1))
    styles = dict(zip(LAWS, ((COLOURS[0], 2.8), (COLOURS[1], 1.6), (COLOURS[2], 1.6), ("black", 0.9)), strict=True))
    dashed = tuple(LAWS)[-1]
    for ax, what in ((wind, "wind"), (waves, "waves")):
        for name, ds in runs[what].items():
            colour, width = styles[name]
            ax.plot(
                ds["time"].values[::2], fairlead(ds)[::2], color=colour, lw=width, label=name, ls=_dash(name == dashed)
            )
    bare = fairlead(runs["wind"]["no friction"])
    for name, ds in list(runs["wind"].items())[1:]:
        off.plot(ds["time"].values[::4], (fairlead(ds) - bare)[::4], color=styles[name][0], lw=styles[name][1],
                 ls=_dash(name == dashed))  # fmt: skip
    dress(wind, "", "wind: tension,\nline 1 (kN)")
    dress(off, "time (s)", "difference from\nno friction (kN)")
    dress(waves, "time (s)", "waves: tension,\nline 1 (kN)")
    for ax in (wind, off):
        ax.set_xlim(0.0, DURATION["wind"])
    waves.set_xlim(DURATION["waves"] - 4.0 * PERIOD, DURATION["waves"])
    legend_above(wind)
    return figure


def _dash(so: bool):
    return (0, (4, 4)) if so else "-"


def _figure_8(runs):
    figure = new_figure(7.2, 4.6)
    axes = figure.subplots(1, 3, sharey=True)
    for ax, (name, ds) in zip(axes, list(runs["waves"].items())[1:], strict=True):
        for colour, n, values in zip(COLOURS, NODES, node_tension(ds, NODES).T, strict=True):
            ax.plot(node_time(ds), values, color=colour, lw=1.1, label=f"node {n}")
        dress(ax, "time (s)", "node tension (kN)" if ax is axes[0] else "", name.replace(", from", ",\nfrom"))
        ax.set_xlim(DURATION["waves"] - 5.0 * PERIOD, DURATION["waves"])
        ax.set_ylim(bottom=0.0)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=6, frameon=False, fontsize=8)
    return figure
