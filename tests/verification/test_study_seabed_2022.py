"""What the page on Housner et al. 2022 says, done again and compared with exact values, the paper's words and stored numbers.

Verifies: contact, friction, bathymetry

Figure 5: a chain that slides along itself behind its free end has the tension (mu w + D) s, with D = 6 N/m of tangential drag
at 0.2 m/s: 169.0 and 338.1 kN at the two nodes that stay on the bed. Averaged over the slide all runs must have that
within 0.1 %: the chain above still sways, moves single instants by 0.3 % (std), and 90 of them are averaged. The paper has node tensions of both kinds of
friction within 5 % there, and figure 6's within 5 to 15 %, where the chain moves.

Figures 7 and 8: what the paper says in words. The platform must come to rest where the static mooring balances the thrust.
Shallow water: VolturnUS-S's published fairlead tension, 2437 kN, within 0.1 % of rounding and grid.

Stored numbers are those of this program on the same grid: 0.5 %, the same runs on another processor.
"""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from common import must_fail
from studies.parts import Effort
from studies.peers import at_rest
from studies.seabed_2022 import bathymetry, dragging, laws, wind_waves
from studies.seabed_2022.mooring import (
    ANCHOR_RADIUS,
    AXIAL,
    CHAIN,
    FAIRLEAD_RADIUS,
    WEIGHT,
    about_the_anchor,
    in_waves,
    semi_taut,
)
from studies.seabed_2022.platform import THRUST, restoring
from studies.seabed_2022.runs import fairlead, node_place, node_tension, node_time, ours

ALONE = Effort(True, False)
DRAG = 0.5 * 1025.0 * CHAIN.tangential_drag * np.pi * CHAIN.diameter * 0.2**2  # N/m
STICKING, EVEN = "sticking, as laid", "sticking, from rest without friction"


@pytest.fixture(scope="module")
def stored():
    return json.loads((Path(__file__).parents[2] / "docs" / "studies" / "seabed-2022.json").read_text())


def check_order(tensions: dict[str, float]) -> None:
    assert sorted(tensions, key=tensions.__getitem__) == ["upslope", "normal", "sideslope", "downslope"]


def test_figure_4(stored):
    found, given = bathymetry.four_seabeds(ALONE).numbers["figure-4"], stored["figure-4"]
    for name, one in found.items():
        rough = {"min"} if name == "upslope" else set()  # slack for an instant
        assert one == pytest.approx({k: given[name][k] for k in one} | {k: one[k] for k in rough}, rel=0.005)
    for key in ("static", "mean"):
        check_order({name: one[key] for name, one in found.items()})
    must_fail(check_order, {name: one["depth_at_anchor"] * (name != "sideslope") for name, one in found.items()})
    assert given["normal"]["moordyn_rms"] < 0.005 * given["normal"]["mean"]
    assert given["downslope"]["moordyn_rms"] < 0.001 * given["downslope"]["mean"]


@pytest.fixture(scope="module")
def failure():
    return dragging.study(dragging.FAILURE)


def check_wedge(ds, per_metre: float) -> None:
    slides = node_time(ds) > 450.0
    tension = node_tension(ds, dragging.NODES[:2])[slides].mean(axis=0)
    assert tension == pytest.approx(per_metre * np.array(dragging.ARC[:2]) / 1e3, rel=0.001)


@pytest.mark.parametrize("law", dragging.LAWS)
def test_figure_5_slides_as_coulomb_has_it(law, failure):
    check_wedge(failure[law], AXIAL * WEIGHT + DRAG)


def test_slide_without_drag_fails(failure):
    must_fail(check_wedge, failure["saturated damping"], AXIAL * WEIGHT)


def test_figure_5_as_the_paper_compares_it(failure, stored):
    assert (dragging.differences(failure, 450.0) < 0.05).all()
    must_fail(check_apart, dragging.differences(failure, 0.0), 0.05)
    places = [node_place(failure[law], dragging.NODES)[-1, :, 0] for law in dragging.SHOWN]
    assert places[0] == pytest.approx(places[1], abs=0.2)  # both end 100 m further
    for law, ds in failure.items():
        given = stored["figure-5"][law]["tension"]["900"]
        assert node_tension(ds, dragging.NODES)[-1] == pytest.approx(given, rel=0.005)


def check_apart(differences, limit: float) -> None:
    assert (differences < limit).all()


def test_figure_6():
    runs = dragging.study(dragging.CIRCLE)
    moving = dragging.differences(runs, 675.0)[1:]  # node 5 never moves
    check_apart(moving, 0.15)
    must_fail(check_apart, moving, 0.02)
    bent = node_place(runs["saturated damping"], dragging.NODES)[-1, :, 1]
    assert bent[0] < 0.1 < bent[1] < bent[2] < bent[3]
    assert bent == pytest.approx(node_place(runs[STICKING], dragging.NODES)[-1, :, 1], abs=4.0)
    free, _ = ours(semi_taut(lines=(1,)), about_the_anchor(900.0), 900.0, 1.0)
    assert node_place(free, dragging.NODES)[-1, 0, 1] > 50.0


def test_fairlead_goes_round_the_anchor():
    track = about_the_anchor(100.0).points[11]
    reach = np.hypot(track[:, 0] + ANCHOR_RADIUS, track[:, 1])
    assert reach == pytest.approx(ANCHOR_RADIUS - FAIRLEAD_RADIUS)
    speed = np.linalg.norm(np.diff(track[-100:], axis=0), axis=1) / 0.1
    assert speed == pytest.approx(0.9, rel=1e-6)


@pytest.fixture(scope="module")
def pushed():
    return wind_waves.study()


def late_mean(runs, what: str) -> dict[str, float]:
    return {
        name: float(fairlead(ds)[ds["time"].values >= wind_waves.COUNTED[what] - 1e-6].mean())
        for name, ds in runs[what].items()
    }


def test_figure_7(pushed, stored):
    motions, runs = pushed
    sway = motions["wind"].platform[-1, 1]
    assert restoring(semi_taut(), np.array([sway]))[0] == pytest.approx(-THRUST, rel=1e-3)
    wind, waves = late_mean(runs, "wind"), late_mean(runs, "waves")
    for name, given in stored["figures-7-8"]["wind"].items():
        assert wind[name] == pytest.approx(given["mean"], rel=0.005)
    more = {name: wind[name] - wind["no friction"] for name in (STICKING, EVEN, "saturated damping")}
    assert more[STICKING] > more["saturated damping"] > 0.1 * wind["no friction"]
    assert more[EVEN] == pytest.approx(more[STICKING], rel=0.01)
    for name, mean in waves.items():
        assert mean == pytest.approx(waves["no friction"], rel=0.002), name
        assert stored["figures-7-8"]["waves"][name]["mean"] == pytest.approx(mean, rel=0.005)


def check_even(tension) -> None:
    assert np.ptp(tension) < 0.01 * tension.mean()


def test_figure_8(pushed):
    found = {}
    for name, ds in list(pushed[1]["waves"].items())[1:]:
        late = node_time(ds) >= wind_waves.COUNTED["waves"] - 1e-6
        found[name] = node_tension(ds, wind_waves.NODES)[late].mean(axis=0)
        assert node_place(ds, wind_waves.NODES)[late][..., 2].max() < -849.9  # on the bed all the time
    check_even(found["saturated damping"])
    must_fail(check_even, found[STICKING])
    assert np.all(np.diff(found[STICKING]) > 0.0)
    assert found[STICKING][-1] > 100.0 * found[STICKING][0]
    check_even(found[EVEN][:3])


def test_flat_as_moordyn_f(reference):
    """The mooring and motion of the reference data, as one line of two sections: 0.5 % rms, as in test_housner."""
    rows = np.genfromtxt(
        reference / "bathymetry_friction" / "wave_flat_nofriction" / "main_F.csv", delimiter=",", names=True
    )
    ds, _ = ours(semi_taut(), in_waves(90.0), 89.5)
    time = ds["time"].values
    late = time > 2.0
    theirs = np.interp(time, rows["Time"], rows["LINE2TENB"]) / 1e3
    assert np.sqrt(np.mean((fairlead(ds) - theirs)[late] ** 2)) < 0.005 * theirs.mean()


def test_shallow_mooring_is_the_published_one():
    assert at_rest(laws.shallow())["fairlead_tension"].values / 1e3 == pytest.approx(3 * [laws.PUBLISHED], rel=1e-3)


def test_laws_side_by_side(stored):
    for site in laws.sites():
        one = stored["laws"][site.name]
        bare = one.pop("none")
        one.pop("static", None)
        sticks = {name: one.pop(name) for name in ("Azcona et al.", "Azcona, directions apart", "Choi & Yoo")}
        for law in one.values():
            assert 0.98 < law["anchor_mean"] / bare["anchor_mean"] < 1.01
        for law in sticks.values():
            assert 0.15 < law["anchor_mean"] / bare["anchor_mean"] < 0.23
        for law in (*one.values(), *sticks.values()):
            assert law["std"] == pytest.approx(bare["std"], rel=0.008)
        springs = [sticks[name]["anchor_mean"] for name in ("Azcona et al.", "Azcona, directions apart")]
        assert springs[0] == pytest.approx(springs[1], rel=0.02)
        # at the default tolerance creep of nodes that hardly move counted as much as 180 kJ
        assert min(law["energy"] for law in one.values()) > max(law["energy"] for law in sticks.values())
    ds, _ = ours(
        laws.shallow(laws.laws(site)["Azcona et al."]),
        laws.drift_and_waves(laws.DURATION),
        laws.DURATION,
        dt_nodes=0.25,
        tolerance=laws.TOLERANCE,
    )
    late = ds["time"].values >= laws.COUNTED
    assert ds["anchor_tension"].sel(line=1).values[late].mean() / 1e3 == pytest.approx(springs[0], rel=0.005)


def test_what_the_page_says_of_the_choices(stored):
    mooring, friction = stored["mooring_open"], stored["friction_open"]
    assert mooring["twice the segments"]["std"] / mooring["as chosen"]["std"] == pytest.approx(0.9, abs=0.02)
    for name in ("seabed 30 MPa/m", "waves act on the lines too", "without roll"):
        assert mooring[name]["mean"] == pytest.approx(mooring["as chosen"]["mean"], rel=0.005)
    for name in ("axial damping 0.1 of critical instead of 1", "seabed 0.01 MPa s/m instead of 0.1"):
        assert 0.87 < mooring[name]["min"] / mooring["as chosen"]["min"] < 0.95
        assert mooring[name]["mean"] == pytest.approx(mooring["as chosen"]["mean"], rel=0.001)
    wind = {name: one["wind 1"] for name, one in friction.items()}
    assert wind["c_v 1e4"] == pytest.approx(wind["no friction"], rel=0.001)
    assert wind["no friction"] < wind["c_v 1e5"] < wind["saturated damping, c_v 1e6"] < wind["c_v 1e7"]
    for name in ("its spring ten times as stiff", "its spring ten times as soft"):
        assert wind[name] == pytest.approx(wind[STICKING], rel=0.002)
