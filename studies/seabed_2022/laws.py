"""The paper's "next phase": established laws of friction side by side, in deep and in shallow water.

How the laws that the paper names are run here:

* Azcona et al. 2011, horizontal springs against the load on a node, axial and transverse apart: `elastic-slip`, whose
  spring slips on an ellipse of both directions; and `soil-curves` with one straight rise to the coefficient in each
  direction, which keeps them apart.
* Liu & Bergdahl 1997, Coulomb's force, or one in proportion to the velocity when that is low: `saturated-damping` with
  static = kinetic is exactly that, its c_v set so that the ramp ends at V_C on the weight of a segment.
* Lee et al. 2018, a coefficient that is a function of the speed: `velocity-dependent`.
* Choi & Yoo 2012, a spring and damper that sticks: `stick-slip`.
* Housner et al. 2022: `saturated-damping` with c_v = 1e6.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from moorage.model import Curve, Environment, Friction, LineType, Model, Motion, Section
from moorage.plot.style import COLOURS, QUIET, new_figure
from studies.drawing import dress
from studies.parts import Effort, Part, table
from studies.peers import at_rest
from studies.seabed_2022.mooring import (
    AXIAL,
    CHAIN_LENGTH,
    CHAIN_SEGMENTS,
    DAMPED,
    HEIGHT,
    PERIOD,
    RAOS,
    STATIC,
    TRANSVERSE,
    WEIGHT,
    semi_taut,
    spread,
)
from studies.seabed_2022.runs import fairlead, node_place, node_time, ours

SHALLOW = LineType(  # VolturnUS-S (Allen et al. 2020): 185 mm chain in 200 m
    name="chain",
    diameter=0.333,
    mass_per_length=685.0,
    axial_stiffness=3.27e9,
    axial_damping_ratio=1.0,
    transverse_drag=2.0,
    tangential_drag=0.4,
    transverse_added_mass=0.8,
    tangential_added_mass=0.25,
)
SHALLOW_DEPTH, SHALLOW_RADIUS, SHALLOW_LENGTH, SHALLOW_SEGMENTS = 200.0, 837.6, 850.0, 50
TOLERANCE = 3e-4  # m; with the default 2 mm the mean at an anchor that sticking chain shields is 2 % off
PUBLISHED = 2437.0  # kN, at its fairleads at rest; OrcaFlex 2427, MoorDyn 2439
SHALLOW_WEIGHT = 9.80665 * (685.0 - 1025.0 * np.pi / 4.0 * 0.333**2)  # N/m
V_C = 0.01  # m/s, where laws that depend on the speed reach Coulomb's force; open in all of their papers
DASHED = ("Azcona, directions apart", "Housner et al.")  # over what they would hide
DRIFT, DRIFT_PERIOD, DURATION, COUNTED = 8.0, 150.0, 450.0, 150.0  # m, s: two slow periods are counted


class Site(NamedTuple):
    """Deep or shallow: the mooring, and what it says of a node."""

    name: str
    weight: float  # N, in water, of a segment of its chain
    sinks: float  # m, of that into the bed
    last: int  # segments of chain

    def model(self, friction: Friction | None) -> Model:
        """Return its mooring."""
        return semi_taut(friction=friction) if self.name == "deep" else shallow(friction)


def shallow(friction: Friction | None = None) -> Model:
    """Return the catenary mooring of VolturnUS-S in 200 m."""
    environment = Environment(water_depth=SHALLOW_DEPTH, seabed_damping=1e5, friction=friction)
    sections = (Section(line_type="chain", length=SHALLOW_LENGTH, segments=SHALLOW_SEGMENTS),)
    return spread(environment, (SHALLOW,), sections, SHALLOW_RADIUS, (1, 2, 3))


def sites() -> tuple[Site, Site]:
    """Return both."""
    deep, near = CHAIN_LENGTH / CHAIN_SEGMENTS, SHALLOW_LENGTH / SHALLOW_SEGMENTS
    return (
        Site("deep", WEIGHT * deep, WEIGHT / (3e6 * 0.216), CHAIN_SEGMENTS),
        Site("shallow", SHALLOW_WEIGHT * near, SHALLOW_WEIGHT / (3e6 * 0.333), SHALLOW_SEGMENTS),
    )


def laws(site: Site) -> dict[str, Friction | None]:
    """Return the laws by whose they are; the sticking ones slip after the same way."""
    mu = {"axial": AXIAL, "transverse": TRANSVERSE}
    return {
        "none": None,
        "Liu & Bergdahl": Friction(model="saturated-damping", damping=site.weight / V_C, **mu),
        "Housner et al.": DAMPED,
        "Lee et al.": Friction(model="velocity-dependent", velocity=V_C, static_ratio=STATIC, **mu),
        "Azcona et al.": Friction(model="elastic-slip", laid=True, **mu),
        "Azcona, directions apart": Friction(
            model="soil-curves", laid=True, axial_curve=rise(AXIAL, site), transverse_curve=rise(TRANSVERSE, site)
        ),
        "Choi & Yoo": Friction(model="stick-slip", laid=True, static_ratio=STATIC, velocity=V_C, **mu),
    }


def rise(coefficient: float, site: Site) -> Curve:
    """Return a mobilised coefficient that rises to its value over the way after which `elastic-slip` slips too."""
    return Curve((0.0, coefficient * site.sinks), (0.0, coefficient))


def drift_and_waves(duration: float) -> Motion:
    """Return a slow drift of the platform along line 1, and its motion in waves that go along it."""
    time = np.arange(0.0, duration + 0.1, 0.1)
    grown = np.where(time < 30.0, 0.5 - 0.5 * np.cos(np.pi * time / 30.0), 1.0)
    w = 2.0 * np.pi / PERIOD
    moved = np.zeros((len(time), 6))
    for column, mode in ((0, "sway"), (2, "heave"), (4, "roll")):  # the RAOs of the other heading, turned
        response, lead = RAOS[mode]
        moved[:, column] = grown * response * 0.5 * HEIGHT * np.sin(w * time + lead)
    moved[:, 4] *= -1.0
    moved[:, 0] += grown * DRIFT * np.sin(2.0 * np.pi * time / DRIFT_PERIOD)
    return Motion.from_platform(time, moved)


def side_by_side(effort: Effort) -> Part:
    """Return the laws side by side."""
    motion, numbers, rows, runs = drift_and_waves(DURATION), {}, [], {}
    for site in sites():
        numbers[site.name], bare = {}, None
        for name, law in laws(site).items():
            ds, wall = ours(site.model(law), motion, DURATION, 0.25, dt_nodes=0.25, tolerance=TOLERANCE)
            late = ds["time"].values >= COUNTED
            anchor, top = ds["anchor_tension"].sel(line=1).values[late] / 1e3, fairlead(ds)[late]
            found = {
                "mean": top.mean(), "std": top.std(), "max": top.max(), "anchor_mean": anchor.mean(),
                "anchor_max": anchor.max(), "energy": lost(ds), "creep": creep(ds, site),
            }  # fmt: skip
            one = numbers[site.name][name] = {key: float(value) for key, value in found.items()}
            bare = bare or one
            rows.append((site.name, name, f"{one['mean']:.1f}", f"{100 * (one['std'] / bare['std'] - 1):+.2f} %",
                         f"{100 * (one['max'] / bare['max'] - 1):+.2f} %", f"{one['anchor_mean']:.1f}",
                         f"{one['anchor_max']:.1f}", f"{one['energy']:.0f}", f"{one['creep']:.3f}",
                         f"{wall:.3f}"))  # fmt: skip
            runs[site.name, name] = ds
    static = float(at_rest(shallow())["fairlead_tension"].values[0] / 1e3)
    numbers["shallow"]["static"] = static
    words = {
        "laws": table(
            ("water", "friction", "mean, kN", "std, from none", "highest, from none", "at the anchor, mean, kN",
             "highest", "energy lost by line 1, kJ a slow period", "creep, m", "wall time, s"), rows,
        ),
        "static_shallow": f"{static:.1f}",
    }  # fmt: skip
    return Part({"laws": numbers}, words, {"laws": _figure(runs)})


def lost(ds) -> float:
    """Return the energy that friction takes from line 1 in a slow period, kJ."""
    if "dissipated_energy" not in ds:
        return 0.0
    energy, time = ds["dissipated_energy"].sel(line=1).values, ds["time"].values
    counted = energy[-1] - energy[np.abs(time - COUNTED).argmin()]
    return float(counted / 1e3 * DRIFT_PERIOD / (DURATION - COUNTED))


def creep(ds, site: Site) -> float:
    """Return how far the node in the middle of the grounded chain is from where it was a slow period before, m."""
    node = site.last // 2
    time, place = node_time(ds), node_place(ds, [node])[:, 0]
    before = np.abs(time - (time[-1] - DRIFT_PERIOD)).argmin()
    return float(np.linalg.norm(place[-1] - place[before]))


def _figure(runs):
    figure = new_figure(7.2, 6.0)
    axes = figure.subplots(2, 2)
    for (mean, swing), site in zip(axes, sites(), strict=True):
        for colour, name in zip((QUIET, *COLOURS), laws(site), strict=True):
            ds = runs[site.name, name]
            chain = (ds["segment_line"] == 1).values
            tension = ds["segment_tension"].values[node_time(ds) >= COUNTED][:, chain][:, : site.last] / 1e3
            arc = ds["segment_arc_length"].values[chain][: site.last]
            style = (0, (3, 2)) if name in DASHED else "-"
            mean.plot(arc, tension.mean(axis=0), color=colour, lw=1.6, ls=style, label=name)
            swing.plot(arc, tension.std(axis=0), color=colour, lw=1.6, ls=style)
        dress(mean, "arc length from the anchor (m)", "mean tension (kN)", f"{site.name}: line 1's chain")
        dress(swing, "arc length from the anchor (m)", "standard deviation (kN)", f"{site.name}: what moves it")
        for ax in (mean, swing):
            ax.set_ylim(bottom=0.0)
            ax.set_xlim(0.0, arc[-1])
    handles, labels = axes[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=4, frameon=False, fontsize=8)
    return figure
