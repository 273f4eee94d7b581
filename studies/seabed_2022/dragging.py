"""Figures 5 and 6: line 1 alone, pulled after its anchor has failed, and led round its anchor."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import xarray as xr

from moorage.model import Friction, Model, Motion
from moorage.plot.style import COLOURS, QUIET, new_figure
from studies.drawing import dress, legend_above
from studies.parts import Effort, Part, table
from studies.peers import has_moordyn
from studies.seabed_2022.mooring import (
    AXIAL,
    CHAIN_LENGTH,
    CHAIN_SEGMENTS,
    DAMPED,
    STICKING,
    WEIGHT,
    about_the_anchor,
    anchor_failure,
    pulled,
    semi_taut,
)
from studies.seabed_2022.runs import (
    fairlead,
    isotropic,
    node_place,
    node_tension,
    node_time,
    ours,
    rms,
    theirs,
)

NODES = (5, 10, 15, 20)  # of 25 segments of chain, from the anchor
ARC = [n * CHAIN_LENGTH / CHAIN_SEGMENTS for n in NODES]  # m
LAWS: dict[str, Friction | None] = {  # static = kinetic here
    "saturated damping": dataclasses.replace(DAMPED, static_ratio=1.0),
    "sticking, as laid": STICKING,
    "sticking, from rest without friction": dataclasses.replace(STICKING, laid=False),
}
SHOWN = tuple(LAWS)[:2]


class Case(NamedTuple):
    """One of the two figures."""

    name: str
    duration: float
    model: Callable[[Friction | None], Model]
    motion: Callable[[float], Motion]
    axis: int  # along which it goes
    coefficient: float  # for MoorDyn-C, which has one
    instants: tuple[float, ...]  # of the shapes, s


def one_line(friction: Friction | None) -> Model:
    """Return line 1 alone."""
    return semi_taut(friction=friction, lines=(1,))


FAILURE = Case("figure-5", 900.0, anchor_failure, pulled, 0, AXIAL, (0.0, 300.0, 600.0, 900.0))
CIRCLE = Case("figure-6", 900.0, one_line, about_the_anchor, 1, 1.0, (0.0, 300.0, 600.0, 900.0))


def wedge(arc) -> np.ndarray:
    """Return the tension (kN) of a chain that slides along itself behind its free end: mu w s, by Coulomb."""
    return AXIAL * WEIGHT * np.asarray(arc) / 1e3


def study(case: Case) -> dict[str, xr.Dataset]:
    """Return the runs of a case with each law."""
    return {
        name: ours(case.model(law), case.motion(case.duration), case.duration, 1.0)[0] for name, law in LAWS.items()
    }


def grounded(ds: xr.Dataset) -> np.ndarray:
    """Return whether NODES are on the bed (m, 4)."""
    return node_place(ds, NODES)[..., 2] < -849.9


def differences(runs: dict[str, xr.Dataset], start: float) -> np.ndarray:
    """Return the rms difference of the node tensions by the first two laws, over the mean by the second."""
    one, other = (node_tension(runs[name], NODES) for name in SHOWN)
    late = node_time(runs[SHOWN[0]]) >= start
    return np.sqrt(np.mean((one - other)[late] ** 2, axis=0)) / other[late].mean(axis=0)


def part(case: Case, effort: Effort) -> Part:
    """Return a figure with its numbers."""
    runs, key = study(case), case.name.replace("-", "_")
    rows, numbers = [], {}
    for name, ds in runs.items():
        time, tension, place = node_time(ds), node_tension(ds, NODES), node_place(ds, NODES)[..., case.axis]
        moved = place - place[0]
        numbers[name] = {"tension": {}, "moved": {}, "fairlead": {}}
        for at in case.instants[1:]:
            k = int(np.abs(time - at).argmin())
            numbers[name]["tension"][f"{at:g}"] = tension[k].tolist()
            numbers[name]["moved"][f"{at:g}"] = moved[k].tolist()
            numbers[name]["fairlead"][f"{at:g}"] = float(fairlead(ds)[k])
            rows.append((name, f"{at:g}", *(f"{v:.2f}" for v in moved[k]), *(f"{v:.1f}" for v in tension[k]),
                         f"{fairlead(ds)[k]:.1f}"))  # fmt: skip
    header = (
        "friction",
        "time, s",
        *(f"node {n} moved, m" for n in NODES),
        *(f"node {n}, kN" for n in NODES),
        "fairlead, kN",
    )
    apart = {f"{start:g}": differences(runs, start).tolist() for start in (0.5 * case.duration, 0.75 * case.duration)}
    apart_rows = [
        (f"{start} to {case.duration:g}", *(f"{100 * v:.1f} %" for v in values)) for start, values in apart.items()
    ]
    words = {
        key: table(header, rows),
        f"{key}_apart": table(("seconds", *(f"node {n}" for n in NODES)), apart_rows),
    }
    peer = beside(case) if effort.peers and has_moordyn() else {}
    words[f"{key}_peer"] = (
        f"With one coefficient of {case.coefficient:g} in both, MoorDyn-C's fairlead tension is {peer['rms']:.2f} kN "
        f"rms ({100 * peer['rms'] / peer['mean']:.2f} %) from Moorage's, in {peer['wall_theirs']:.1f} s; Moorage takes "
        f"{peer['wall_ours']:.3f} s (wall times)."
        if peer
        else "MoorDyn-C was not run."
    )
    numbers["apart"] = apart
    if peer:
        numbers["peer"] = peer
    return Part({case.name: numbers}, words, {case.name: _figure(case, runs)})


def beside(case: Case) -> dict[str, float]:
    """Return how far MoorDyn-C is with the same, one, coefficient."""
    model, motion = case.model(isotropic(LAWS["saturated damping"], case.coefficient)), case.motion(case.duration)
    ds, wall = ours(model, motion, case.duration, 0.25)
    other = theirs(model, motion, case.duration)
    late = ds["time"].values > 5.0
    own = ds["fairlead_segment_tension"].values[:, 0] / 1e3
    off = rms((own - other["end_tension"][:, 1] / 1e3)[late])
    return {"rms": off, "mean": float(own[late].mean()), "wall_ours": wall, "wall_theirs": float(other["wall"])}


def _figure(case: Case, runs):
    figure = new_figure(7.2, 7.6)
    top, middle, low = figure.subplots(3, 1, height_ratios=(1.2, 1.0, 1.2))
    styles = dict(zip(SHOWN, ("-", (0, (2.5, 1.5))), strict=True))
    for name, style in styles.items():
        ds = runs[name]
        time, place, tension = node_time(ds), node_place(ds, NODES), node_tension(ds, NODES)
        for k, at in enumerate(case.instants):
            nodes = node_place(ds, range(0, CHAIN_SEGMENTS + 1))[int(np.abs(time - at).argmin())]
            across = nodes[:, 2] if case.axis == 0 else nodes[:, 1]
            label = f"{at:g} s" if style == "-" else None
            top.plot(nodes[:, 0], across, color=_grey(k, len(case.instants)), lw=1.2, ls=style, label=label)
            for colour, n in zip(COLOURS, NODES, strict=False):
                top.plot(nodes[n, 0], across[n], color=colour, marker="o", ms=4, lw=0)
        for k, (colour, n) in enumerate(zip(COLOURS, NODES, strict=False)):
            label = f"node {n}" if style == "-" else None
            middle.plot(time, place[:, k, case.axis], color=colour, ls=style, lw=1.2, label=label)
            low.plot(time, tension[:, k], color=colour, ls=style, lw=1.2)
            if case.axis == 0 and style == "-" and n <= NODES[1]:
                low.axhline(wedge(ARC[k]), color=colour, lw=0.8, ls=(0, (1, 2)))
        low.plot([], [], color="black", ls=style, lw=1.2, label=name)
    if case.axis == 0:
        low.plot([], [], color=QUIET, lw=0.8, ls=(0, (1, 2)), label="Coulomb, mu w s (nodes 5 and 10)")
        top.axhline(-850.0, color=QUIET, lw=0.8)
    dress(top, "x (m)", "z (m)" if case.axis == 0 else "y (m)")
    dress(middle, "", f"{'xyz'[case.axis]} of nodes (m)")
    dress(low, "time (s)", "node tension (kN)")
    for ax in (middle, low):
        ax.set_xlim(0.0, case.duration)
    if case.axis == 1:
        top.set_aspect("equal", adjustable="datalim")
    legend_above(top)
    legend_above(middle)
    legend_above(low)
    return figure


def _grey(k: int, count: int) -> str:
    """Return a grey that gets darker."""
    return str(0.75 - 0.75 * k / max(count - 1, 1))
