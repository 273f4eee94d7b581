"""Figure 6: the cantilever of figure 3, undeflected at first, settles; MoorDyn-C beside ours."""

from __future__ import annotations

import numpy as np

from moorage.plot.style import COLOURS, new_figure
from studies.bending_2020.cantilever import CABLE, GRAVITY, cantilever, elastica, small_period
from studies.bending_2020.deflection import SEGMENTS, places, shape
from studies.drawing import dress, legend_above
from studies.parts import Effort, Part, table
from studies.peers import has_moordyn, moordyn_c, timed, with_types

MASS, LENGTH = 1000.0, 10.0
INTERVAL, SHOWN, SETTLED = 0.05, 30.0, 400.0  # s: of results, of the figure, until it hardly moves
SMALL, LONG = 0.01, 120.0  # of gravity: swings of 16 mm, for which the beam is linear; s of them
LAST = 80  # values in the last 4 s
OPEN: dict[str, dict[str, float]] = {
    "as chosen": {},
    "Cd 0.6 instead of 1.2": {"transverse_drag": 0.6},
    "Cd 2.4": {"transverse_drag": 2.4},
    "Ca 0.5 instead of 1": {"transverse_added_mass": 0.5},
    "no CdAx instead of 0.05": {"tangential_drag": 0.0},
    "axial damping 0.1 of critical instead of 0.8": {"axial_damping_ratio": 0.1},
}
MOORDYN = {"dtM": 2e-4, "TmaxIC": 0}


def period(time: np.ndarray, z: np.ndarray) -> float:
    """Return the mean time between upward passes of the mean, s."""
    z = z - z.mean()
    k = np.flatnonzero((z[1:] > 0.0) & (z[:-1] <= 0.0))
    passes = time[k] + (time[k + 1] - time[k]) * z[k] / (z[k] - z[k + 1])
    return float(np.diff(passes).mean())


def swing(segments: int, duration: float, model=None, tolerance: float = 1e-5):
    """Return time (n,), s, and x and z (n, 2) of the tip, m, and the wall time, s."""
    given = model or cantilever(LENGTH, MASS, segments)
    ds, wall = timed(given, duration=duration, dt_out=INTERVAL, tolerance=tolerance, start="as-given")
    return ds["time"].values, places(ds)[:, -1], wall


def small_swing_period(segments: int) -> float:
    """Return the period (s) where a hundredth of the weight bends it, for which the beam is linear."""
    model = cantilever(LENGTH, MASS, segments, gravity=SMALL * GRAVITY)
    time, tip, _ = swing(segments, LONG, with_types(model, transverse_drag=0.0), tolerance=1e-7)
    return period(time, tip[:, 1])


def moordyn_tip(segments: int, duration: float):
    """Return time, x and z of the tip and the wall time by MoorDyn-C."""
    time = 0.01 * np.arange(round(duration / 0.01) + 1)
    model = cantilever(LENGTH, MASS, segments)
    found = moordyn_c(model, time, np.zeros((len(time), 0)), 5, **MOORDYN)
    return found["time"], found["node_position"][:, -1, [0, 2]] + [0.0, 40.0], float(found["wall"])


def decay(effort: Effort) -> Part:
    """Return figure 6 with periods and settled places."""
    linear, exact = small_period(LENGTH, MASS), elastica(LENGTH, MASS, [LENGTH])[0]
    ours = {n: swing(n, SHOWN) for n in SEGMENTS}
    theirs = {n: moordyn_tip(n, SHOWN) for n in SEGMENTS} if effort.peers and has_moordyn() else {}
    periods = {n: period(t, tip[:, 1]) for n, (t, tip, _) in ours.items()}
    small = {n: small_swing_period(n) for n in SEGMENTS}
    settled = {n: float(swing(n, SETTLED, settling(n))[1][-1, 1]) for n in SEGMENTS}
    static = {n: float(shape(LENGTH, MASS, n)[-1, 1]) for n in SEGMENTS}
    rows = []
    for n in SEGMENTS:
        peer, same_rule = theirs.get(n), cantilever(LENGTH, MASS, n, flavour="MoorDyn-C")
        off = 1e3 * rms(swing(n, SHOWN, same_rule)[1][:, 1], peer[1][:, 1]) if peer else None
        rows.append((n, f"{periods[n]:.4f}", f"{small[n]:.4f}", f"{settled[n]:.4f}", f"{static[n]:.4f}",
                     "-" if off is None else f"{off:.1f}",
                     f"{1e3 * ours[n][2]:.0f}", f"{1e3 * peer[2]:.0f}" if peer else "-"))  # fmt: skip
    rows.append(("exact", "", f"{linear:.4f}", f"{exact[1]:.4f}", f"{exact[1]:.4f}", "", "", ""))
    words = table(
        ("segments", "period, s", "of small swings, s", "tip after settling, m", "statics, m",
         "rms from MoorDyn-C with its clamp rule, mm", "wall time, ms: Moorage", "MoorDyn-C"), rows,
    )  # fmt: skip
    choices = {words: left(changed) for words, changed in OPEN.items()}
    open_words = table(
        ("changed", "period, s", "swing from top to bottom in the last 4 s of 30, m"),
        [(words, f"{found['period']:.3f}", f"{found['swing']:.3f}") for words, found in choices.items()],
    )
    return Part(
        {
            "figure-6": {
                "period": {str(n): v for n, v in periods.items()},
                "small_period": {str(n): v for n, v in small.items()},
                "small_period_exact": linear,
                "settled": {str(n): v for n, v in settled.items()},
                "static": {str(n): v for n, v in static.items()},
                "open": choices,
            }
        },
        {"figure_6": words, "decay_open": open_words},
        {"figure-6": _figure(ours, theirs)},
    )


def left(changed: dict[str, float]) -> dict[str, float]:
    """Return the period, s, and the swing that is left at the end, m, of 8 segments with changed properties."""
    time, tip, _ = swing(8, SHOWN, with_types(cantilever(LENGTH, MASS, 8), **changed))
    return {"period": period(time, tip[:, 1]), "swing": float(np.ptp(tip[-LAST:, 1]))}


def rms(a: np.ndarray, b: np.ndarray) -> float:
    """Return the rms of a difference."""
    return float(np.sqrt(np.mean((a - b) ** 2)))


def settling(segments: int):
    """Return the cantilever with fifty times the drag, which settles to the same place sooner."""
    return with_types(cantilever(LENGTH, MASS, segments), transverse_drag=50.0 * CABLE.transverse_drag)


def _figure(ours, theirs):
    figure = new_figure(7.2, 3.6)
    ax = figure.add_subplot()
    for colour, n in zip(COLOURS, SEGMENTS, strict=False):
        time, tip, _ = ours[n]
        ax.plot(time, tip[:, 1], color=colour, lw=1.2, label=f"{n} segments")
        if n in theirs:
            ax.plot(theirs[n][0][::4], theirs[n][1][::4, 1], color=colour, marker="o", ms=2.0, lw=0)
    if theirs:
        ax.plot([], [], color="black", marker="o", ms=2.0, lw=0, label="MoorDyn-C")
    ax.axhline(elastica(LENGTH, MASS, [LENGTH])[0, 1], color="black", lw=0.9, ls=(0, (4, 3)), label="elastica")
    dress(ax, "time (s)", "tip deflection (m)")
    ax.set_xlim(0.0, SHOWN)
    legend_above(ax)
    return figure
