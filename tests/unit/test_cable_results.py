"""What a result holds of cables: bending, inclination, touchdown, envelopes, the check of bend radii and the report."""

import dataclasses
import json
import signal
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from moorings import fixed, line, mooring

import moorage
from moorage import streaming
from moorage.errors import ModelWarning, ResultError, RunInterrupted
from moorage.model import Attachment, Body, LineType, Motion, OutputChannel, Point, Rod, RodType
from moorage.results import cable_reports, cables, static_report, tight_bends
from moorage.results.bending import curvatures, declinations, segment_tangents, touchdown
from moorage.results.cable_report import CableReport, sag_and_hog
from moorage.results.cables import strand

EXAMPLES = Path(__file__).parents[2] / "examples"
CABLE = LineType(
    name="cable", diameter=0.176, mass_per_length=77.3, axial_stiffness=751e6, axial_damping_ratio=1.0,
    bending_stiffness=11.71e3, transverse_drag=1.2, transverse_added_mass=1.0,
)  # fmt: skip
FLOATS = dataclasses.replace(CABLE, name="floats", diameter=0.559, mass_per_length=184.5, bending_stiffness=30e3)
PARTS = (("cable", 55.0, 40), ("floats", 25.0, 25), ("cable", 57.0, 40))
ENDS = (fixed(1, 105.0, 0.0, -60.0), Point(id=2, kind="coupled", position=(0.0, 0.0, -4.0)))
NEW = [
    "curvature", "bending_moment", "node_declination", "fairlead_moment", "anchor_moment", "minimum_bend_radius",
    "touchdown_position", "touchdown_arc_length", "bending_stiffness", "outer_diameter",
]  # fmt: skip


def allowed(model, radius):
    types = tuple(dataclasses.replace(t, minimum_bend_radius=radius) for t in model.line_types)
    return dataclasses.replace(model, line_types=types)


@pytest.fixture(scope="module")
def whole():
    """One line of three sections."""
    return mooring((CABLE, FLOATS), ENDS, (line(1, 1, 2, *PARTS),), water_depth=60.0)


@pytest.fixture(scope="module")
def chained(whole):
    """The same as three lines, the middle one reversed, numbered and listed anyhow, joined by free rods."""
    rods = (
        Rod(id=1, rod_type="r", kind="free", end_a=(65.0, 0.0, -53.0), end_b=(64.0, 0.0, -52.5), segments=0),
        Rod(id=2, rod_type="r", kind="free", end_a=(43.0, 0.0, -45.0), end_b=(42.0, 0.0, -45.5), segments=0),
    )
    first, middle, last = (line(id, 1, 2, part) for id, part in zip((7, 4, 5), PARTS, strict=True))
    lines = (
        dataclasses.replace(last, end_a=Attachment("rod", 2, "B")),
        dataclasses.replace(middle, end_a=Attachment("rod", 2, "A"), end_b=Attachment("rod", 1, "B")),
        dataclasses.replace(first, end_b=Attachment("rod", 1, "A")),
    )
    types = (RodType(name="r", diameter=0.1, mass_per_length=0.0),)
    return dataclasses.replace(whole, rods=rods, rod_types=types, lines=lines)


@pytest.fixture(scope="module")
def still(whole):
    return moorage.solve_statics(whole)


@pytest.fixture(scope="module")
def motion():
    return Motion.from_harmonics(12.0, ramp=6.0, surge=(2.0, 10.0), heave=(2.0, 8.0))


@pytest.fixture(scope="module")
def moving(whole, motion):
    return moorage.simulate(whole, duration=8.0, motion=motion, dt_nodes=0.2)


def test_variables_of_cables_say_what_they_are(still, moving):
    for name in NEW:
        assert still[name].attrs["units"]
        assert still[name].attrs["long_name"]
        assert np.isfinite(still[name].values).all(), name
    assert moving["curvature"].dims == moving["node_declination"].dims == ("node_time", "node")
    assert moving["fairlead_moment"].dims == ("time", "line", "xyz")
    assert moving["touchdown_position"].dims == ("node_time", "line", "xyz")


def test_moorings_without_bending_have_none_of_it(whole):
    soft = tuple(dataclasses.replace(t, bending_stiffness=0.0) for t in whole.line_types)
    chain = dataclasses.replace(whole, line_types=soft)
    assert not set(NEW) & set(moorage.solve_statics(chain).variables)
    assert cables(moorage.solve_statics(chain)) == []
    asked = dataclasses.replace(chain, lines=(dataclasses.replace(chain.lines[0], outputs="pK"),))
    ds = moorage.solve_statics(asked)  # MoorDyn's letter K asks for curvature
    assert ds["curvature"].max() > 0.05
    assert not ds["bending_moment"].any()


def test_without_histories_there_are_end_moments_only(whole, motion):
    ds = moorage.simulate(whole, duration=1.0, motion=motion, save="tensions")
    assert set(NEW) & set(ds.variables) == {"fairlead_moment", "anchor_moment"}


def test_curvature_of_a_line_without_bending_is_that_of_its_shape(still, whole):
    soft = (dataclasses.replace(whole.line_types[0], name="soft", bending_stiffness=0.0),)
    points = (*whole.points, fixed(3, -60.0, 0.0, -60.0))
    both = dataclasses.replace(
        whole,
        line_types=whole.line_types + soft,
        points=points,
        lines=(*whole.lines, line(2, 3, 2, ("soft", 90.0, 40))),
    )
    ds = moorage.line(moorage.solve_statics(both), 2)
    r = ds["node_position"].values[None]
    expected = curvatures(segment_tangents(r), ds["unstretched_length"].values)[0]
    np.testing.assert_allclose(ds["curvature"].values[1:-1], expected)
    assert not ds["curvature"].values[[0, -1]].any()
    assert cables(moorage.solve_statics(both))[0].lines == (1,)


def test_moment_is_stiffness_times_curvature(still):
    inner = slice(5, 35)  # of the first section
    np.testing.assert_allclose(still["bending_moment"][inner], 11.71e3 * still["curvature"][inner], rtol=2e-4)


def circle(lengths, radius=20.0):
    """Nodes on a circle in a vertical plane that is turned by 30 degrees, with the angles of the tangent."""
    angle = 0.3 + np.concatenate([[0.0], np.cumsum(2.0 * np.arcsin(lengths / (2.0 * radius)))])
    x, z = radius * np.sin(angle), -radius * np.cos(angle)
    return np.stack([x * np.cos(0.5), x * np.sin(0.5), z], axis=1)[None], 0.5 * np.pi - angle


def test_curvature_of_a_circle():
    lengths = np.full(12, 1.5)
    position, _ = circle(lengths)
    np.testing.assert_allclose(curvatures(segment_tangents(position), lengths), 1.0 / 20.0, rtol=1e-12)


def test_declination_is_of_second_order_on_uneven_segments():
    errors = []
    for n in (10, 20):
        lengths = 1.05 ** (np.arange(n) * 10.0 / n) * 10.0 / n
        position, exact = circle(lengths)
        errors.append(np.abs(declinations(segment_tangents(position), lengths)[0] - exact).max())
    assert errors[0] < 1e-3
    assert errors[0] / errors[1] > 3.5


@pytest.mark.parametrize(
    ("end", "angle"), [((0, 0, 5), 0.0), ((3, 4, 0), np.pi / 2), ((0, 0, -5), np.pi), ((0, 5, 5), np.pi / 4)]
)
def test_declination_is_counted_from_the_upward_vertical_towards_end_b(end, angle):
    for n in (1, 2, 4):
        position = np.linspace((0.0, 0.0, 0.0), end, n + 1)[None]
        np.testing.assert_allclose(declinations(segment_tangents(position), np.full(n, 5.0 / n)), angle)


def test_touchdown_is_seen_from_the_higher_end():
    x, arc = np.arange(6.0), np.arange(6.0)
    z = np.array([[-10.0, -10.0, -10.0, -9.0, -6.0, 0.0]])
    position = np.stack([x[None], 0.0 * z, z], axis=2)
    spot, along = touchdown(position, z + 10.0, arc)
    np.testing.assert_allclose(spot, [[2.0, 0.0, -10.0]])
    np.testing.assert_allclose(along, 2.0)
    spot, along = touchdown(position[:, ::-1], (z + 9.5)[:, ::-1], arc)  # sunk in by half a metre, and reversed
    np.testing.assert_allclose(spot, [[2.5, 0.0, -9.5]])
    np.testing.assert_allclose(along, 2.5)


def test_touchdown_is_nowhere_for_lines_that_hang_or_lie():
    z = np.array([[-5.0, -9.0, -5.0], [-10.0, -10.0, -10.0]])
    position = np.stack([np.broadcast_to(np.arange(3.0), z.shape), 0.0 * z, z], axis=2)
    spot, along = touchdown(position, z + 10.0, np.arange(3.0))
    assert np.isnan(spot).all()
    assert np.isnan(along).all()


def test_touchdown_leaves_the_grounded_length(still):
    assert still["touchdown_arc_length"].item() == pytest.approx(still["grounded_length"].item(), abs=1.0)
    assert still["touchdown_position"].sel(xyz="z").item() == pytest.approx(-60.0)


def test_bend_radius_is_that_of_the_largest_curvature(moving):
    np.testing.assert_allclose(moving["minimum_bend_radius"][:, 0], 1.0 / moving["curvature"].max("node"))


def test_end_moments_are_those_of_the_clamp():
    ds = moorage.solve_statics(moorage.read(EXAMPLES / "lazy_wave" / "lazy_wave.yaml"))
    moment = ds["fairlead_moment"].values[0]
    assert np.linalg.norm(moment) == pytest.approx(ds["bending_moment"].values[-1])
    assert not ds["anchor_moment"].any()
    # the cable pulls the clamp from 10 degrees off the vertical further out, towards the anchor at -x: about +y
    assert moment[1] == pytest.approx(np.linalg.norm(moment))


def test_clamps_and_rods_are_told_in_the_attributes(chained, whole):
    attrs = moorage.solve_statics(chained).attrs
    assert attrs["zero_length_rods"].startswith("1, 2: end B was read as the coordinates of a point")
    assert attrs["clamp_rule"] == "exact"
    theirs = moorage.solve_statics(dataclasses.replace(chained, flavour="MoorDyn-C")).attrs
    assert theirs["clamp_rule"].startswith("equation 10")
    assert not {"zero_length_rods", "clamp_rule"} & set(moorage.solve_statics(whole).attrs)


# --- the check of bend radii ---


def test_tight_bends_are_named_with_line_node_place_and_time(whole, motion, moving):
    radius = float(moving["minimum_bend_radius"].min()) + 0.1
    with pytest.warns(ModelWarning, match=r"line 1 is bent to a radius of .* at node \d+, .* from end A at") as caught:
        ds = moorage.simulate(allowed(whole, radius), duration=8.0, motion=motion, dt_nodes=0.2)
    (bend,) = tight_bends(ds)
    row, node = np.unravel_index(ds["curvature"].values.argmax(), ds["curvature"].shape)
    assert (bend.line, bend.node, bend.time) == (1, node, ds["node_time"].values[row])
    assert bend.arc_length == ds["arc_length"].values[node]
    assert (bend.radius, bend.allowed) == (pytest.approx(radius - 0.1), radius)
    assert ds.attrs["bend_radius_check"] == str(bend) == str(caught[0].message)
    np.testing.assert_allclose(ds["bend_utilisation"], radius / ds["minimum_bend_radius"])


def test_wide_bends_pass(whole, motion, recwarn):
    ds = moorage.simulate(allowed(whole, 2.0), duration=0.4, motion=motion)
    assert ds.attrs["bend_radius_check"] == "passed"
    assert ds["bend_utilisation"].max() < 1.0
    assert not [w for w in recwarn if "radius" in str(w.message)]
    assert "bend_radius_check" not in moorage.solve_statics(whole).attrs
    assert "bend_utilisation" not in moorage.solve_statics(whole)


def test_statics_check_bend_radii_too(whole, still):
    radius = float(still["minimum_bend_radius"].item())
    with pytest.warns(ModelWarning, match=r"allowed: .* from end A$"):
        ds = moorage.solve_statics(allowed(whole, 1.5 * radius))
    (bend,) = tight_bends(ds)
    assert bend.time is None
    assert ds["bend_utilisation"].item() == pytest.approx(1.5)


def test_each_section_has_its_own_radius(whole, still):
    floats = dataclasses.replace(FLOATS, minimum_bend_radius=1e-3)
    cable = dataclasses.replace(CABLE, minimum_bend_radius=2.0)
    ds = moorage.solve_statics(dataclasses.replace(whole, line_types=(cable, floats)))
    limit = ds["allowed_bend_radius"].values
    np.testing.assert_array_equal(limit[[0, 40, 41, 64, 65, -1]], [2.0, 2.0, 1e-3, 1e-3, 2.0, 2.0])
    np.testing.assert_allclose(ds["bend_utilisation"].item(), (limit * ds["curvature"].values).max())


@pytest.mark.filterwarnings("ignore::moorage.errors.ModelWarning")
def test_a_resumed_run_checks_all_of_it(whole, motion, tmp_path, monkeypatch):
    monkeypatch.setattr(streaming, "BLOCK_SECONDS", 0.0)
    model, path = allowed(whole, 12.0), tmp_path / "run.nc"
    memory = moorage.simulate(model, duration=8.0, motion=motion)

    def interrupt(time, duration, wall):
        if time >= 7.5:
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(RunInterrupted):
        moorage.simulate(model, duration=8.0, motion=motion, output=path, progress=interrupt)
    disk = moorage.simulate(model, duration=8.0, motion=motion, output=path, resume=True)
    assert "bent" in memory.attrs["bend_radius_check"]
    xr.testing.assert_identical(memory.assign_attrs(date=""), disk.load().assign_attrs(date=""))
    disk.close()


# --- envelopes ---


def test_envelope_holds_the_extremes_along_the_line(moving):
    extremes = moorage.envelope(moving, "curvature")
    assert set(extremes.data_vars) == {"minimum", "mean", "maximum"}
    np.testing.assert_array_equal(extremes["maximum"], moving["curvature"].values.max(axis=0))
    np.testing.assert_allclose(extremes["mean"], moving["curvature"].values.mean(axis=0))
    assert "arc_length" in extremes.coords
    assert extremes["maximum"].attrs["units"] == "m-1"
    assert "node_time" not in extremes.variables
    late = moorage.envelope(moorage.line(moving, 1), "segment_tension", start=4.0)
    np.testing.assert_array_equal(late["minimum"], moving["segment_tension"].values[20:].min(axis=0))


def test_envelope_of_statics_is_the_state(still):
    extremes = moorage.envelope(still, "node_position")
    for name in ("minimum", "mean", "maximum"):
        np.testing.assert_array_equal(extremes[name], still["node_position"])


def test_envelope_of_what_is_not_there_is_refused(moving):
    with pytest.raises(ResultError, match=r"no such quantity along its lines.*tension.*\n.*segment_tension"):
        moorage.envelope(moving, "fairlead_tension")
    with pytest.raises(ResultError, match="ends at 8 s"):
        moorage.envelope(moving, "curvature", start=9.0)
    with pytest.raises(ResultError, match="saved without histories"):
        moorage.envelope(moving.drop_dims(["node", "segment"]), "curvature")


# --- cables and their report ---


def test_lines_joined_by_free_rods_are_one_cable(chained, still):
    ds = moorage.solve_statics(chained)
    (cable,) = cables(ds)
    assert cable.lines == (5, 4, 7)  # from the hang-off
    (single,) = cables(still)
    keep = np.concatenate([[True], np.diff(cable.distance) > 0.0])
    np.testing.assert_allclose(cable.distance[keep], single.distance)
    np.testing.assert_allclose(cable.middles, single.middles)
    for name, rows, other in (
        ("node_position", cable.nodes[keep], single.nodes),
        ("curvature", cable.nodes[keep], single.nodes),
        ("segment_tension", cable.segments, single.segments),
    ):
        skip = np.isin(np.arange(len(rows)), [40, 65]) if name == "curvature" else np.zeros(len(rows), dtype=bool)
        expected = still[name].values[other]
        np.testing.assert_allclose(ds[name].values[rows][~skip], expected[~skip], atol=2e-6 * np.abs(expected).max())


def test_the_report_of_a_chain_is_that_of_the_line(chained, still):
    (chain,), (one,) = cable_reports(moorage.solve_statics(chained)), cable_reports(still)
    assert (chain.lines, one.lines) == ((5, 4, 7), (1,))
    assert (chain.peak_curvature_line, one.peak_curvature_line) == (4, 1)
    for name in set(CableReport._fields) - {"lines", "peak_curvature_line", "peak_curvature_node", "bend_utilisation"}:
        np.testing.assert_allclose(getattr(chain, name), getattr(one, name), rtol=1e-5, atol=1e-5)


def test_the_report_holds_what_the_result_says(still):
    (report,) = cable_reports(still)
    assert report.hang_off_tension == still["fairlead_tension"].item()
    assert report.anchor_tension == still["anchor_tension"].item()
    x, _, z = still["fairlead_force"].values[0]
    assert report.hang_off_angle == pytest.approx(np.arctan2(x, -z))
    assert report.peak_curvature == still["curvature"].max().item()
    node = int(still["curvature"].values.argmax())
    assert report.peak_curvature_node == node
    assert report.peak_curvature_distance == pytest.approx(137.0 - still["arc_length"].values[node])
    assert report.touchdown_distance == pytest.approx(137.0 - still["touchdown_arc_length"].item())
    z = still["node_position"].sel(xyz="z").values
    sag = int(np.argmin(z[52:])) + 52  # beyond the hog
    assert report.sag_height == pytest.approx(z[sag] + 60.0, abs=0.02)
    assert report.sag_height <= z[sag] + 60.0
    assert 0.0 < report.hog_height - report.sag_height < 10.0


def test_a_line_that_starts_at_the_hang_off_is_turned_round(whole, still):
    end_a, end_b = whole.lines[0].end_a, whole.lines[0].end_b
    turned = dataclasses.replace(whole.lines[0], sections=whole.lines[0].sections[::-1], end_a=end_b, end_b=end_a)
    (report,), (other,) = (
        cable_reports(moorage.solve_statics(dataclasses.replace(whole, lines=(turned,)))),
        cable_reports(still),
    )
    np.testing.assert_allclose(report.hang_off_tension, other.hang_off_tension)
    np.testing.assert_allclose(report.touchdown_distance, other.touchdown_distance, rtol=1e-6)
    assert report.peak_curvature_node == 105 - other.peak_curvature_node


def test_sag_and_hog_lie_between_nodes():
    s = np.linspace(0.0, 3.0 * np.pi, 40)
    z = np.cos(s + 0.3) - 50.0
    sag, hog = sag_and_hog(s, z, z + 60.0)
    assert sag == pytest.approx(9.0, abs=5e-4)
    assert hog == pytest.approx(11.0, abs=5e-4)
    assert np.isnan(sag_and_hog(s, s, s + 60.0)).all()  # neither on a slope
    flat = np.where(s < 5.0, 5.0 - s, 0.0) + 1e-5 * np.sin(8.0 * s)
    assert np.isnan(sag_and_hog(s, flat, flat)).all()  # nor on what lies on the bed


def test_static_report_is_plain_json(still, chained):
    for ds in (still, moorage.solve_statics(chained)):
        report = json.loads(json.dumps(static_report(ds), allow_nan=False))
        (numbers,) = cable_reports(ds)
        for entry in report["lines"]:
            assert entry["cable"]["hang_off_tension"] == numbers.hang_off_tension
            assert entry["cable"]["lines"] == list(numbers.lines)
            assert entry["cable"]["bend_utilisation"] is None
            assert len(entry["cable"]["touchdown_position"]) == 3
            assert "grounded_length" in entry


def test_a_strand_is_a_cable_or_one_line(chained):
    ds = moorage.solve_statics(chained)
    assert strand(ds, [4, 5, 7]).lines == (5, 4, 7)
    assert strand(ds, [7]).lines == (7,)
    with pytest.raises(ResultError, match="not one cable"):
        strand(ds, [4, 5])


# --- channels of rods and bodies ---


def test_positions_of_rods_and_bodies_are_channels(motion):
    model = moorage.read(EXAMPLES / "lazy_wave" / "lazy_wave.yaml")
    rods = (*model.rods, dataclasses.replace(model.rods[0], id=2, end_b=(-20.0, 0.0, -18.0), segments=4))
    names = ("BODY1PX", "ROD1PZ", "ROD2PZ", "ROD2NBPZ", "ROD2N1PZ")
    outputs = tuple(OutputChannel(name=name) for name in names)
    model = dataclasses.replace(model, rods=rods, outputs=outputs)
    eq = moorage.solve_statics(model)
    assert [eq[name].item() for name in names] == [0.0, -14.0, -14.0, -18.0, -15.0]
    ds = moorage.simulate(model, duration=4.0, motion=motion)
    np.testing.assert_allclose(ds["BODY1PX"], np.interp(ds["time"], motion.time, motion.platform[:, 0]), atol=2e-2)
    np.testing.assert_allclose(ds["ROD1PZ"] + 14.0, ds["ROD2N1PZ"] + 15.0, atol=1e-9)
    assert ds["ROD1PZ"].attrs["long_name"] == "position of node 0 of rod 1, z"


def test_points_on_bodies_are_as_coupled_as_these():
    model = moorage.read(EXAMPLES / "lazy_wave" / "lazy_wave.yaml")
    on_body = dataclasses.replace(model.points[0], id=2, name="", position=(5.0, 0.0, -10.0), body=1)
    held = dataclasses.replace(
        model, points=(*model.points, on_body), bodies=(Body(id=1, kind="coupled", position=(0, 0, 0)),)
    )
    ds = moorage.solve_statics(held)
    assert ds["point_kind"].values.tolist() == ["fixed", "coupled"]
    assert ds["end_b_kind"].values.tolist() == ["coupled rod"]
