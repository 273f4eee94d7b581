"""A run is one thing, however it is cut up, shared between threads or interrupted; and it never records a NaN."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from moorings import CHAIN, again, at_rest, coupled, fixed, free, kind, line, mooring, spread, statics

import moorage.solve.march as march_module
from moorage.errors import MoorageError, SimulationError
from moorage.layout import new_work
from moorage.model import Bathymetry, Friction, Model, Motion, Soil
from moorage.model.seabed import place_on_seabed
from moorage.solve.host import HostMarch
from moorage.solve.march import March, Settings
from moorage.solve.statics import solve
from moorage.system.build import Built, build

DURATION = 12.0
MOTION = Motion.from_harmonics(DURATION + 1.0, ramp=4.0, interval=0.25, surge=(4.0, 9.0), heave=(2.0, 7.0))
WAYS = {
    "adaptive": Settings(dt_out=0.1, dt_nodes=0.3, watch=((0, 3), (2, 0))),
    "fixed step": Settings(time_step=0.03, dt_out=0.1, dt_nodes=0.3, watch=((0, 3), (2, 0))),
    "rk4": Settings(method="rk4", time_step=0.001, dt_out=0.1, dt_nodes=0.3, watch=((0, 3), (2, 0))),
}


def model() -> Model:
    """Three chains, and a float with a chain and a rope: four islands."""
    three = spread(12)
    rope = kind(
        "rope", diameter=0.12, mass_per_length=15.0, axial_stiffness=4e6, axial_damping=1e5, transverse_drag=1.2
    )
    more = (fixed(7, -800.0, 50.0, -200.0), free(8, -600.0, 40.0, -100.0, mass=500.0, volume=2.0),
            coupled(9, -40.0, 2.0, -5.0))  # fmt: skip
    lines = (line(4, 7, 8, ("chain", 250.0, 8)), line(5, 8, 9, ("rope", 560.0, 9)))
    return mooring((CHAIN, rope), (*three.points, *more), (*three.lines, *lines), water_depth=200.0)


@pytest.fixture(scope="module")
def start() -> Built:
    return statics(model(), MOTION)


def fresh(built: Built) -> Built:
    return again(built)._replace(work=new_work(built.system))


def collect(march: March, times) -> dict[str, np.ndarray]:
    blocks = [march.advance(t) for t in times]
    return {name: np.concatenate([b[name] for b in blocks]) for name in blocks[0]}


def same(a: dict, b: dict) -> bool:
    return all(a[name].shape == b[name].shape and (a[name] == b[name]).all() for name in a)


@pytest.fixture(scope="module", params=WAYS)
def whole(start, request):
    settings = WAYS[request.param]
    march = March(fresh(start), settings, DURATION)
    return settings, collect(march, [DURATION]), march.counters


CUTS = {
    "at output times": np.arange(0.0, DURATION + 0.05, 0.1),
    "anywhere": np.append(np.sort(np.random.default_rng(5).uniform(0.0, DURATION, 40)), DURATION),
    "in few pieces": np.array([0.0, 0.0, 1.2345, 1.2345, 11.9, DURATION]),
}


@pytest.mark.parametrize("cuts", CUTS)
def test_block_boundaries_do_not_change_a_bit(start, whole, cuts):
    settings, expected, counters = whole
    march = March(fresh(start), settings, DURATION)
    assert same(collect(march, CUTS[cuts]), expected)
    assert march.counters == counters


@pytest.mark.parametrize("threads", [2, 3, 8])
def test_threads_do_not_change_a_bit(start, whole, threads, monkeypatch):
    settings, expected, counters = whole
    monkeypatch.setattr(march_module, "THREAD_NODES", 1)
    monkeypatch.setattr(march_module, "PROCESSORS", threads)
    march = March(fresh(start), settings, DURATION)
    assert same(collect(march, [3.0, DURATION]), expected)
    assert march.counters == counters


def test_checkpoints_continue_bit_for_bit(start, whole):
    """Saved in the middle of steps, and restored into a system that has been somewhere else since."""
    settings, expected, counters = whole
    march = March(fresh(start), settings, DURATION)
    head = collect(march, [2.345, 5.05])
    saved = {name: array.copy() for name, array in march.checkpoint().items()}
    march.advance(9.0)
    march.restore(saved)
    first = collect(march, [7.0, DURATION])
    other = March(build(model(), MOTION), settings, DURATION)
    other.restore(saved)
    second = collect(other, [DURATION])
    for tail in (first, second):
        assert same({name: np.concatenate([head[name], tail[name]]) for name in head}, expected)
    assert march.counters == other.counters == counters


def test_checkpoint_brings_all_that_steps_depend_on():
    """A resumed run is built anew and not solved, with quite other tensions: they must not count."""
    case = mooring(
        CHAIN, (fixed(1, -80.0, 0.0, -60.0), coupled(2, 0.0, 0.0, 0.0)), (line(1, 1, 2, ("chain", 102.0, 60)),)
    )
    march = March(statics(case, MOTION), Settings(), DURATION)
    march.advance(5.0)
    saved = march.checkpoint()
    expected = march.advance(DURATION)
    for factor in (0.5, 1.05):
        elsewhere = build(case, MOTION)
        elsewhere.state.position[...] *= factor
        other = March(elsewhere, Settings(), DURATION)
        other.restore(saved)
        assert same(other.advance(DURATION), expected)


@pytest.mark.parametrize("way", WAYS)
def test_what_the_seabed_remembers_survives_blocks_checkpoints_and_rejected_steps(way):
    """A soil with a memory and friction on a slope: cut up and restored, and what it remembers last is where nodes are."""
    x = (-900.0, 900.0)
    slope = Bathymetry(x, x, ((206.0, 206.0), (194.0, 194.0)))
    bed = {"soil": Soil(shear_strength=3e3), "friction": Friction(axial=0.5, transverse=0.7), "bathymetry": slope}
    plain = spread(12, **bed)
    points = [p if p.kind != "fixed" else dataclasses.replace(p, on_seabed=True) for p in plain.points]
    built = statics(place_on_seabed(dataclasses.replace(plain, points=tuple(points))), MOTION)
    march = March(fresh(built), WAYS[way], 6.0)
    whole = collect(march, [6.0])
    state, n = march.built.state, built.names.node_ptr[-1]
    place = state.position[:n]
    depth = (np.array([-200.0 + place[:, 0] / 150.0]).ravel() - place[:, 2]) / np.hypot(1.0, 1.0 / 150.0)
    assert state.soil[:n, 0] == pytest.approx(np.maximum(depth, 0.0), abs=1e-9)
    assert (state.soil[:n, 4] > 0.0).any()  # some have turned
    assert march.counters["rejected"] > 0 or way != "adaptive"
    first = March(fresh(built), WAYS[way], 6.0)
    begin = collect(first, [1.234, 3.0])
    other = March(fresh(built), WAYS[way], 6.0)
    other.restore(first.checkpoint())
    rest = collect(other, [6.0])
    assert same(whole, {name: np.concatenate([begin[name], rest[name]]) for name in begin})


def test_host_steps_can_be_repeated(start):
    """A host that iterates on a coupling step gets the same forces from the same motion."""
    host = HostMarch(fresh(start), Settings())
    host.initialize()
    place, speed = host.position.copy(), np.zeros_like(host.position)
    host.step(0.5, place + 0.01, speed + 0.02)
    saved = host.save()
    once = host.step(1.0, place + 0.05, speed + 0.1)
    host.restore(saved)
    host.step(1.0, place - 0.3, speed)
    host.restore(saved)
    assert (host.step(1.0, place + 0.05, speed + 0.1) == once).all()


# --- nothing that is not a number reaches a record ----------------------------------------------------------------


def is_finite(block) -> bool:
    return all(np.isfinite(values).all() for values in block.values())


def parameters(built: Built) -> list[tuple[str, str]]:
    """Every array of floats of the system, by term and field."""
    terms = ("tension", "bending", "weight", "morison", "contact", "points", "current", "tracks")
    return [
        (term, field)
        for term in terms
        for field, values in getattr(built.system, term)._asdict().items()
        if isinstance(values, np.ndarray) and values.dtype == float and values.size
    ]


def spoilt(built: Built):
    """Yield a name and the system with a NaN at the start, in the middle or at the end of one array of parameters."""
    for term, field in parameters(built):
        group = getattr(built.system, term)
        for place in ("first", "middle", "last"):
            array = getattr(group, field).copy()
            array.ravel()[{"first": 0, "middle": array.size // 2, "last": -1}[place]] = np.nan
            system = built.system._replace(**{term: group._replace(**{field: array})})
            yield f"{place} of {term}.{field}", fresh(built)._replace(system=system)


@pytest.mark.filterwarnings("ignore:invalid value")
@pytest.mark.parametrize("settings", [Settings(dt_nodes=0.1), Settings(method="rk4", time_step=0.002, dt_nodes=0.1)])
def test_bad_parameter_never_reaches_a_record(start, settings):
    """Such models are refused by their checks; this is the second line of defence. Some are not used, and harmless."""
    stopped = 0
    for name, bad in spoilt(start):
        march = March(bad, settings, 1.0)
        blocks = []
        try:
            blocks += [march.first(), march.advance(1.0)]
        except SimulationError as error:
            stopped += 1
            blocks.append(error.block)
        assert all(is_finite(block) for block in blocks), name
    assert stopped > 30


@pytest.mark.filterwarnings("ignore:invalid value")
def test_bad_parameter_never_makes_an_equilibrium(start):
    for name, bad in spoilt(start):
        try:
            solve(bad)
        except MoorageError:
            continue
        assert np.isfinite(bad.state.position[: bad.names.node_ptr[-1]]).all(), name


def test_motion_that_turns_into_nan_stops_the_run_with_what_was_good(start):
    """Such motion is refused when it is built; should it come all the same, the run ends where it begins."""
    tracks = start.system.tracks
    bad = tracks.coefficients.copy()
    bad[:, 20:] = np.nan  # from 5 s on
    built = fresh(start)
    built = built._replace(system=built.system._replace(tracks=tracks._replace(coefficients=bad)))
    march = March(built, WAYS["adaptive"], DURATION)
    with pytest.raises(SimulationError) as caught:
        march.advance(DURATION)
    block = caught.value.block
    assert is_finite(block)
    assert 4.0 < caught.value.time <= 5.0
    assert block["time"][-1] == pytest.approx(np.floor(caught.value.time * 10.0) / 10.0)
    assert "line" in str(caught.value)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_host_motion_that_is_not_finite_is_refused_and_changes_nothing(start, bad):
    host = HostMarch(fresh(start), Settings())
    host.initialize()
    place, speed = host.position.copy(), np.zeros_like(host.position)
    before = host.save()
    wrong = place.copy()
    wrong[0, 1] = bad
    with pytest.raises(SimulationError):
        host.step(0.5, wrong, speed)
    with pytest.raises(SimulationError):
        host.step(bad, place, speed)
    after = host.save()
    assert all((before[name] == after[name]).all() for name in before)
    assert np.isfinite(host.step(0.5, place, speed)).all()


def test_explicit_step_that_is_too_long_says_so(start):
    march = March(fresh(start), Settings(method="rk2", time_step=0.05), DURATION)
    with pytest.raises(SimulationError, match=r"explicit step of 0\.05 s is too long") as caught:
        march.advance(DURATION)
    assert is_finite(caught.value.block)


def test_lines_without_weight_or_tension_can_start():
    """Nothing pulls at the start, so that the forces at hand give Newton's method no scale to stop at."""
    rope = kind("rope", axial_damping_ratio=0.5)
    case = mooring(
        rope,
        (fixed(1, 0.0, 0.0, -50.0), coupled(2, 100.0, 0.0, -50.0)),
        (line(1, 1, 2, ("rope", 100.0, 10)),),
        gravity=0.0,
    )
    built = at_rest(case, Motion.from_harmonics(8.0, ramp=2.0, surge=(0.5, 5.0)))
    tension = March(built, Settings(), 7.0).advance(7.0)["end_tension"]
    assert tension.max() == pytest.approx(1e7 * 0.5 / 100.0, rel=0.1)
