"""Figure 4: line 1's tension on four seabeds, without friction, the platform moved as in the waves."""

from __future__ import annotations

import numpy as np

from moorage.plot.style import COLOURS, new_figure
from studies.drawing import dress, legend_above
from studies.parts import Effort, Part, table
from studies.peers import at_rest, has_moordyn
from studies.seabed_2022.mooring import SLOPES, in_waves, semi_taut
from studies.seabed_2022.runs import fairlead, node_place, ours, rms, theirs

DURATION, STARTED = 120.0, 45.0  # s


def four_seabeds(effort: Effort) -> Part:
    """Return figure 4 and its table."""
    motion, numbers, rows, drawn = in_waves(DURATION), {}, [], {}
    for name, slope in SLOPES.items():
        model = semi_taut(slope)
        rest = at_rest(model)
        ds, wall = ours(model, motion, DURATION)
        peer = theirs(model, motion, DURATION) if effort.peers and has_moordyn() else None
        late, tension = ds["time"].values >= STARTED, fairlead(ds)
        one = {
            "depth_at_anchor": float(model.environment.depth_at(-1130.0, 0.0)),
            "static": fairlead(rest.expand_dims("time"))[0],
            "grounded": float(rest["grounded_length"].sel(line=1)),
            "mean": tension[late].mean(), "std": tension[late].std(),
            "min": tension[late].min(), "max": tension[late].max(),
        }  # fmt: skip
        numbers[name] = {key: float(value) for key, value in one.items()}
        off, costs = "-", "-"
        if peer is not None:
            segment = ds["fairlead_segment_tension"].sel(line=1).values / 1e3
            numbers[name]["moordyn_rms"] = rms((segment - peer["end_tension"][:, 1] / 1e3)[late])
            off, costs = f"{numbers[name]['moordyn_rms']:.1f}", f"{float(peer['wall']):.1f}"
        tensions = (f"{one[k]:.1f}" for k in ("static", "mean", "std", "min", "max"))
        rows.append((name, f"{one['depth_at_anchor']:.1f}", *tensions, f"{one['grounded']:.0f}", off,
                     f"{wall:.3f}", costs))  # fmt: skip
        drawn[name] = (rest, ds, peer)
    words = table(
        ("seabed", "depth at anchor 1, m", "static, kN", "mean", "std", "lowest", "highest", "chain on the bed, m",
         "rms from MoorDyn-C, kN", "wall time, s: Moorage", "MoorDyn-C"), rows,
    )  # fmt: skip
    return Part({"figure-4": numbers}, {"figure_4": words}, {"figure-4": _figure(drawn)})


def _figure(drawn):
    figure = new_figure(7.2, 8.4)
    axes = figure.subplots(4, 2, width_ratios=(1.0, 2.6))
    for (side, ax), (name, (rest, ds, peer)) in zip(axes, drawn.items(), strict=True):
        x, y = np.meshgrid(*2 * [np.linspace(-1200.0, 1200.0, 49)])
        depth = 850.0 + SLOPES[name][0] * x + SLOPES[name][1] * y
        image = side.pcolormesh(x, y, depth, cmap="cividis_r", vmin=700.0, vmax=1000.0, rasterized=True)
        for line in (1, 2, 3):
            nodes = node_place(rest.expand_dims("time"), range(46), line)[0]
            if line == 1:
                side.plot(nodes[:, 0], nodes[:, 1], color="black", lw=3.0)
            side.plot(nodes[:, 0], nodes[:, 1], color="white" if line == 1 else "black", lw=1.4)
        side.set_aspect("equal")
        side.set_xticks([-1000, 0, 1000])
        side.set_yticks([-1000, 0, 1000])
        side.tick_params(labelsize=7)
        side.set_ylabel("y (m)", fontsize=8)
        side.set_title(name, fontsize=9)
        if peer is not None and name in ("normal", "downslope"):
            ax.plot(peer["time"], peer["end_tension"][:, 1] / 1e3, color=COLOURS[1], lw=2.4, label="MoorDyn-C")
        ax.plot(ds["time"].values, fairlead(ds), color=COLOURS[0], lw=1.1, label="Moorage")
        dress(ax, "time (s)" if name == "sideslope" else "", "tension,\nline 1 (kN)")
        ax.set_xlim(STARTED, DURATION)
    legend_above(axes[0, 1])
    side.set_xlabel("x (m)", fontsize=8)
    scale = figure.colorbar(image, ax=axes[:, 0], location="bottom", shrink=0.9, aspect=16)
    scale.set_label("depth (m)", fontsize=8)
    scale.ax.tick_params(labelsize=7)
    return figure
