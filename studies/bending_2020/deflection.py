"""Figures 3, 4 and 5: how far the cantilever bends, beside the linear beam and the elastica."""

from __future__ import annotations

import dataclasses

import numpy as np

from moorage.plot.style import COLOURS, new_figure
from studies.bending_2020.cantilever import CABLE, DEPTH, EA, GRAVITY, cantilever, elastica, linear_beam
from studies.drawing import dress
from studies.parts import Part, table
from studies.peers import at_rest

SEGMENTS = (2, 4, 6, 8)
FIGURES = {"figure-3": 1000.0, "figure-4": 2000.0}  # kg at the tip of 10 m
LARGE = (1000.0, 2000.0, 4000.0, 8000.0)  # kg on 20 m; the paper does not say which
ELASTICA = {"color": "black", "lw": 1.2, "label": "elastica"}
LINEAR = {"color": "black", "lw": 1.0, "ls": (0, (4, 3)), "label": "linear beam"}


def shape(length: float, mass: float, segments: int, **changed) -> np.ndarray:
    """Return places (n, 2) of the nodes, x and z from the clamp, m."""
    return places(at_rest(cantilever(length, mass, segments, **changed)))


def places(ds) -> np.ndarray:
    """Return x and z (..., n, 2) of the nodes from the clamp, m."""
    return ds["node_position"].values[..., [0, 2]] + [0.0, DEPTH]


def tip_error(length: float, mass: float, segments: int, **changed) -> float:
    """Return the distance (m) of the tip from where the elastica has it."""
    return float(np.linalg.norm(shape(length, mass, segments, **changed)[-1] - elastica(length, mass, [length])[0]))


def deflections() -> Part:
    """Return figures 3 and 4."""
    numbers, words, figures = {}, {}, {}
    for name, mass in FIGURES.items():
        found = {n: shape(10.0, mass, n) for n in SEGMENTS}
        by_paper = {n: shape(10.0, mass, n, flavour="MoorDyn-C")[-1] for n in SEGMENTS}
        exact, linear = elastica(10.0, mass, [10.0])[0], -float(linear_beam(10.0, mass, 10.0))
        errors = {n: tip_error(10.0, mass, n) for n in SEGMENTS}
        numbers[name] = {
            "linear": linear,
            "elastica": exact.tolist(),
            "tip": {str(n): nodes[-1].tolist() for n, nodes in found.items()},
            "tip_by_paper_rule": {str(n): tip.tolist() for n, tip in by_paper.items()},
            "tip_error": {str(n): error for n, error in errors.items()},
        }
        words[name.replace("-", "_")] = table(
            ("segments", "tip x, m", "tip z, m", "from the elastica, m", "tip z by equation 10, m", "z / linear beam"),
            [
                (n, *(f"{v:.4f}" for v in found[n][-1]), f"{errors[n]:.4f}", f"{by_paper[n][1]:.4f}",
                 f"{found[n][-1, 1] / linear:.3f}")
                for n in SEGMENTS
            ]
            + [("elastica", f"{exact[0]:.4f}", f"{exact[1]:.4f}", "", "", f"{exact[1] / linear:.3f}"),
               ("linear beam", "10.0000", f"{linear:.4f}", "", "", "1.000")],
        )  # fmt: skip
        figures[name] = _figure(mass, found)
    return Part(numbers, words, figures)


def _figure(mass: float, found: dict[int, np.ndarray]):
    figure = new_figure(7.2, 3.2)
    ax, zoom = figure.subplots(1, 2, width_ratios=(2.2, 1.0))
    for one in (ax, zoom):
        x, s = np.linspace(0.0, 10.0, 200), np.linspace(0.0, 10.0, 200)
        one.plot(x, -linear_beam(10.0, mass, x), **LINEAR)
        one.plot(*elastica(10.0, mass, s).T, **ELASTICA)
        for colour, marker, (n, nodes) in zip(COLOURS, "o^sD", found.items(), strict=False):
            one.plot(*nodes.T, color=colour, marker=marker, ms=4, lw=1.0, label=f"{n} segments")
        dress(one, "x (m)", "deflection (m)" if one is ax else "", "" if one is ax else "at the tip")
    tips = np.array([nodes[-1] for nodes in found.values()] + [[10.0, -linear_beam(10.0, mass, 10.0)]])
    ax.legend(loc="lower left", frameon=False, fontsize=8)
    low, high = tips.min(axis=0), tips.max(axis=0)
    margin = 0.25 * (high - low)
    zoom.set_xlim(low[0] - margin[0], high[0] + margin[0])
    zoom.set_ylim(low[1] - margin[1], high[1] + margin[1])
    return figure


def large_loads() -> Part:
    """Return figure 5: 20 m, four loads."""
    n = 20
    found = {mass: shape(20.0, mass, n) for mass in LARGE}
    exact = {mass: elastica(20.0, mass, [20.0])[0] for mass in LARGE}
    linear = {mass: -float(linear_beam(20.0, mass, 20.0)) for mass in LARGE}
    errors = {mass: tip_error(20.0, mass, n) for mass in LARGE}
    coarse = {mass: tip_error(20.0, mass, 10) for mass in LARGE}
    figure = new_figure(5.2, 4.6)
    ax = figure.add_subplot()
    s = np.linspace(0.0, 20.0, 300)
    for colour, marker, mass in zip(COLOURS, "o^sD", LARGE, strict=False):
        ax.plot(*elastica(20.0, mass, s).T, color="black", lw=1.0, label="elastica" if mass == LARGE[0] else None)
        x = np.linspace(0.0, 20.0, 100)
        ax.plot(x, -linear_beam(20.0, mass, x), color=colour, lw=0.9, ls=(0, (4, 3)))
        ax.plot(*found[mass].T, color=colour, marker=marker, ms=3.5, lw=0, label=f"{mass:,.0f} kg")
    ax.plot([], [], color="black", lw=0.9, ls=(0, (4, 3)), label="linear beam")
    dress(ax, "x (m)", "deflection (m)")
    ax.set_aspect("equal")
    ax.set_xlim(-0.5, 21.0)
    ax.set_ylim(-20.5, 0.8)
    ax.legend(loc="lower left", frameon=False, fontsize=8)
    return Part(
        {
            "figure-5": {
                f"{mass:.0f}": {"tip": found[mass][-1].tolist(), "elastica": exact[mass].tolist(),
                                "linear": linear[mass], "error_20": errors[mass], "error_10": coarse[mass]}
                for mass in LARGE
            }
        },
        {
            "figure_5": table(
                ("mass, kg", "P L^2 / EI", "tip x, m", "tip z, m", "elastica x, m", "elastica z, m", "linear beam z, m",
                 "error of 10 segments, m", "of 20, m"),
                [
                    (f"{mass:.0f}", f"{mass * GRAVITY * 400.0 / 2e6:.2f}", *(f"{v:.3f}" for v in found[mass][-1]),
                     *(f"{v:.3f}" for v in exact[mass]), f"{linear[mass]:.2f}", f"{coarse[mass]:.3f}",
                     f"{errors[mass]:.3f}")
                    for mass in LARGE
                ],
            )
        },
        {"figure-5": figure},
    )  # fmt: skip


def open_values() -> Part:
    """Return what the paper leaves open about the cantilever: how far the tip of 8 segments under 1000 kg moves."""
    model = cantilever(10.0, 1000.0, 8)
    tip = places(at_rest(model))[-1]

    def moved(model) -> float:
        return float(1e3 * (places(at_rest(model))[-1, 1] - tip[1]))

    def stretchy(factor: float):
        return dataclasses.replace(model, line_types=(dataclasses.replace(CABLE, axial_stiffness=factor * EA),))

    rows = {
        "EA 10 MN instead of 100 MN": moved(stretchy(0.1)),
        "EA 1 GN": moved(stretchy(10.0)),
        "g 9.81 m/s2 instead of 9.80665": moved(cantilever(10.0, 1000.0, 8, gravity=9.81)),
        "the clamp by equation 10 instead of the exact rule": moved(cantilever(10.0, 1000.0, 8, flavour="MoorDyn-C")),
    }
    words = table(("changed", "tip rises by, mm"), [(what, f"{value:.2f}") for what, value in rows.items()])
    return Part({"cantilever_open": rows}, {"cantilever_open": words}, {})
