"""The page of a result, without a browser: its numbers, what it holds, what it refuses, and the command."""

import base64
import dataclasses
import html
import json
import re
import zlib
from pathlib import Path

import matplotlib
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from moorings import clamp, fixed, held, kind, line, mooring, spread
from typer.testing import CliRunner

import moorage
from moorage import cli
from moorage.errors import ResultError
from moorage.model import Bathymetry, Friction, Rod, Waves
from moorage.results.bending import curvatures, segment_tangents
from moorage.viewer import scene_of
from moorage.viewer.assemble import MODULES, program, source
from moorage.viewer.markers import platforms
from moorage.viewer.packing import pack, unpack
from moorage.viewer.quantities import CLEAR, ON_BED, STUCK, at_nodes
from moorage.viewer.times import MOST_BYTES, interpolated, shown_frames
from moorage.viewer.water import CELLS

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def run():
    motion = moorage.Motion.from_harmonics(4.0, ramp=2.0, surge=(4.0, 4.0))
    return moorage.simulate(spread(10), motion=motion, duration=4.0, dt_out=0.1, dt_nodes=0.5)


def hexes(name, text):
    """Return the colours of a constant of the page's modules, (n, 3) of 0 to 1."""
    found = re.search(rf"{name} = \[(.*?)\]", text, re.DOTALL)[1]
    return np.array([[int(h[i : i + 2], 16) for i in (0, 2, 4)] for h in re.findall(r"#(\w{6})", found)]) / 255


@given(
    arrays(
        float,
        st.tuples(st.integers(1, 6), st.integers(0, 5)),
        elements=st.floats(-1e5, 1e5, allow_nan=False, width=32),
    )
)
@settings(max_examples=60, deadline=None)
def test_numbers_keep_their_place_in_the_range_of_their_column(values):
    """Half a step of 1/65535 of the range, and what float32 rounds of the ends (2^-23 of the size, three times)."""
    back = unpack(pack({"a": values, "b": values[:1]}))
    room = np.ptp(values, axis=0) / 65535 * 0.5 + 3.0 * np.abs(values).max(initial=0.0) * 2.0**-23 + 1e-12
    assert back["a"].shape == values.shape
    assert (np.abs(back["a"] - values) <= room).all()
    np.testing.assert_allclose(back["b"], values[:1], rtol=2e-7, atol=1e-30)


def test_frames_hold_the_result_at_the_times_of_its_nodes(run):
    scene = scene_of(run)
    frames = unpack(pack(scene.arrays))
    assert scene.meta["time"] == pytest.approx(np.arange(0.0, 4.01, 0.5))
    exact = run["node_position"].values.reshape(9, -1)
    np.testing.assert_allclose(frames["position"], exact, atol=2e-4)
    points = run["point_position"].interp(time=run["node_time"].values).values.reshape(9, -1)
    np.testing.assert_allclose(frames["markers"], points, atol=2e-4)
    first = scene.meta["lines"][1]
    nodes = slice(first["first"], first["last"] + 1)
    tension, shown = run["segment_tension"].values[:, 10:20] / 1e3, frames["tension"][:, nodes]
    step = np.ptp(tension) / 65535
    np.testing.assert_allclose(shown[:, [0, -1]], tension[:, [0, -1]], atol=step)
    np.testing.assert_allclose(shown[:, 1:-1], 0.5 * (tension[:, 1:] + tension[:, :-1]), atol=step)
    bent = curvatures(segment_tangents(run["node_position"].values[:, 11:22]), run["unstretched_length"].values[10:20])
    np.testing.assert_allclose(frames["curvature"][:, nodes][:, 1:-1], bent, atol=1e-7)
    assert scene.meta["notes"] == []


def test_end_tensions_have_all_their_times(run):
    history = unpack(pack(scene_of(run).arrays))["history"]
    assert history.shape == (41, 6)
    for k, end in enumerate(("anchor_tension", "fairlead_tension")):
        tension = run[end].values / 1e3
        np.testing.assert_allclose(history[:, k::2], tension, atol=np.ptp(tension) / 65535)


def test_long_histories_keep_their_extremes(run, monkeypatch):
    monkeypatch.setattr("moorage.viewer.times.MOST_HISTORY", 0)  # at least 50 bins are kept
    fine = run.interp(time=np.linspace(0.0, 4.0, 2001))
    scene = scene_of(fine)
    assert scene.arrays["history"].shape == (100, 6)
    assert scene.arrays["history"].max(axis=0)[1::2] == pytest.approx(fine["fairlead_tension"].max("time").values / 1e3)
    assert scene.arrays["history"].min(axis=0)[1::2] == pytest.approx(fine["fairlead_tension"].min("time").values / 1e3)


def test_segments_at_nodes():
    both = at_nodes(np.array([[1.0, 3.0, 10.0]]), np.array([0, 3]))  # two segments of one line, one of another
    assert both.tolist() == [[1.0, 2.0, 3.0, 10.0, 10.0]]


def test_big_runs_are_thinned_with_a_note():
    time = np.arange(0.0, 1000.0, 0.1)
    frames, note = shown_frames(time, 1000)
    shown = time[frames]
    assert len(shown) * 2 * 1000 <= MOST_BYTES
    assert len(shown) * 2 * 1000 > 0.5 * MOST_BYTES
    assert f"one every {shown[1] - shown[0]:.3g} s" in note
    assert shown_frames(time, 100) == (slice(0, 10000), "")


def test_values_between_times():
    table = np.array([[0.0, 10.0], [1.0, 20.0], [3.0, 0.0]])
    got = interpolated(table, np.array([0.0, 1.0, 2.0]), np.array([-1.0, 0.5, 1.75, 9.0]))
    assert got.tolist() == [[0.0, 10.0], [0.5, 15.0], [2.5, 5.0], [3.0, 0.0]]


def test_contact_and_friction_states():
    model = spread(10, friction=Friction(transverse=0.8, axial=0.8))
    ds = moorage.simulate(model, duration=0.4, dt_out=0.2)
    scene = scene_of(ds)
    state = scene.arrays["contact"]
    on_bed = ds["seabed_gap"].values <= 1e-6
    assert set(np.unique(state[on_bed])) <= {ON_BED, STUCK}
    assert STUCK in state
    assert (state[~on_bed] == CLEAR).all()
    words = next(q for q in scene.meta["quantities"] if q["key"] == "contact")
    assert len(words["states"]) == 3


def test_seabed_of_a_grid_and_beyond_it():
    x, y = np.linspace(-850.0, 450.0, 14), np.linspace(-740.0, 740.0, 9)
    depth = 200.0 + 0.02 * x[:, None] + 0.0 * y
    model = spread(6, bathymetry=Bathymetry(tuple(x), tuple(y), tuple(map(tuple, depth))))
    places = [
        p if p.kind != "fixed" else fixed(p.id, *p.position[:2], -200.0 - 0.02 * p.position[0]) for p in model.points
    ]
    ds = moorage.solve_statics(dataclasses.replace(model, points=tuple(places)))
    scene = scene_of(ds)
    bed, (x0, _, x1, _) = scene.meta["bed"], scene.meta["region"]
    z = scene.arrays["bed"].reshape(bed["nx"], bed["ny"])
    across = np.clip(np.linspace(x0, x1, bed["nx"]), -850.0, 450.0)
    np.testing.assert_allclose(z, -(200.0 + 0.02 * across)[:, None] + np.zeros_like(z), atol=1e-9)
    assert not bed["flat"]
    assert "Beyond the depth grid" in scene.meta["notes"][0]


def test_short_waves_are_left_out_with_a_note():
    """A sea of half its energy in waves of 15 m, on a surface whose cells are 11 m."""
    sea = Waves(
        frequency=(0.5, 2.0), amplitude=(0.05, 0.05), phase=(0.0, 0.0), direction=(0.0, 0.0), depth=200.0, ramp=5.0
    )
    ds = moorage.simulate(spread(6, waves=sea), duration=0.2)
    scene = scene_of(ds)
    ((a, kx, ky, w, _),) = scene.meta["sea"]["components"]
    assert (a, ky, w) == (0.05, 0.0, 0.5)
    assert kx == pytest.approx(sea.wavenumber[0])
    assert scene.meta["sea"]["ramp"] == 5.0
    assert scene.meta["sea"]["cells"] == CELLS
    assert "50 % of its energy" in scene.meta["notes"][0]
    assert (
        scene_of(moorage.solve_statics(spread(6, waves=sea))).meta["sea"]["components"] == []
    )  # statics know no waves


def test_platforms_are_what_moves_and_stands_together():
    labels = [{"kind": k} for k in ("coupled", "coupled", "fixed", "coupled", "coupled", "coupled")]
    places = np.array([[0, 0, 0], [50, 0, 0], [25, 10, 0], [25, 40, 0], [2000, 0, 0], [2040, 0, 0]], float)
    rings = platforms(places, labels, 800.0)
    assert sorted(map(sorted, rings)) == [[0, 1, 3], [4, 5]]
    assert platforms(places[:1], labels[:1], 800.0) == []


def cable_model():
    stiff = kind("cable", mass_per_length=60.0, bending_stiffness=1e4, minimum_bend_radius=3.0)
    rod = clamp(4, (0.0, 0.0, -10.0), (-0.6, 0.0, -0.8))
    long = Rod(
        id=5, rod_type="clamp", kind="fixed", name="hull", end_a=(20.0, 0.0, -30.0), end_b=(20.0, 0.0, 10.0), segments=4
    )
    cable = line(2, 1, held(rod, "B"), ("cable", 130.0, 30))
    return mooring(stiff, (fixed(1, -80.0, 0.0, -60.0, name="pit"),), (cable,), (rod, long), water_depth=60.0)


def test_a_model_shows_names_clamps_and_rods():
    scene = scene_of(moorage.solve_statics(cable_model()), cable_model())
    assert [(m["name"], m["kind"]) for m in scene.meta["markers"]] == [("point 1: pit", "fixed"), ("rod 4", "fixed")]
    assert scene.meta["rods"] == [{"name": "rod 5: hull"}]
    np.testing.assert_allclose(scene.arrays["rods"], [[20.0, 0.0, -30.0, 20.0, 0.0, 10.0]])
    used = scene.arrays["utilisation"]
    np.testing.assert_allclose(used, 3.0 * scene.arrays["curvature"])
    assert not scene.meta["moving"]


def test_results_without_nodes_say_how_to_save_them(tmp_path):
    ds = moorage.simulate(spread(4), duration=0.2, save="tensions")
    with pytest.raises(ResultError, match=r"no histories of nodes(.|\n)*--save all \(save='all' in Python\)"):
        moorage.view(ds)


def test_a_killed_run_shows_what_it_has(run):
    cut = run.copy(deep=True)
    cut["node_position"][-2:] = np.nan
    scene = scene_of(cut)
    assert len(scene.meta["time"]) == 7
    assert np.isfinite(scene.arrays["position"]).all()


def test_a_page_is_one_file_with_all_in_it(run, tmp_path):
    page = moorage.view(run, tmp_path / "a.html").html
    assert (tmp_path / "a.html").read_text("utf-8") == page
    assert not re.search(r"""(src|href)\s*=\s*["']?(?!data:)(https?:)?//""", page)
    assert re.findall(r"<link[^>]*>", page) == ['<link rel="icon" href="data:,">']
    assert "import " not in re.sub(r"//.*|/\*.*?\*/", "", program())
    meta = json.loads(re.search(r'id="meta">(.*?)</script>', page)[1])
    assert [entry["name"] for entry in meta["lines"]] == ["line 1", "line 2", "line 3"]
    data = re.search(r'id="data">(.*?)</script>', page)[1]
    assert zlib.decompress(base64.b64decode(data))


def test_titles_cannot_break_out_of_the_page(run):
    page = moorage.view(run.assign_attrs(title="</script><b>&")).html
    assert "</script><b>" not in page
    assert "<title>&lt;/script&gt;&lt;b&gt;&amp;</title>" in page
    assert json.loads(re.search(r'id="meta">(.*?)</script>', page)[1])["title"] == "</script><b>&"


def test_modules_need_only_those_before_them_and_what_these_give():
    given: dict[str, set] = {}
    for name in MODULES:
        text = source(f"page/{name}.js")
        imports = re.findall(r'^import \{([^}]*)\} from "\./(\w+)\.js";$', text, re.MULTILINE)
        assert len(imports) == len(re.findall(r"^import", text, re.MULTILINE)), name
        for names, origin in imports:
            assert {word.strip() for word in names.split(",") if word.strip()} <= given[origin], (name, origin)
        given[name] = set(re.findall(r"^export (?:async )?(?:const|function|class) (\w+)", text, re.MULTILINE))
    folder = Path(moorage.viewer.__file__).parent / "page"
    assert {path.stem for path in folder.glob("*.js")} == set(MODULES)


def test_the_bundle_stands_beside_its_licence_and_version():
    vendor = Path(moorage.viewer.__file__).parent / "vendor"
    version = re.search(r"three@([\d.]+)", (vendor / "README.md").read_text("utf-8"))[1]
    assert f'"{version.split(".")[1]}"' in (vendor / "three.min.js").read_text("utf-8")  # three's REVISION
    assert "The MIT License" in (vendor / "LICENSE.three").read_text("utf-8")


def test_colours_are_those_that_the_colour_blind_can_tell_apart():
    text = source("page/colours.js")
    np.testing.assert_allclose(
        hexes("VIRIDIS", text), matplotlib.colormaps["viridis"](np.linspace(0, 1, 11))[:, :3], atol=0.012
    )
    for name in ("VIRIDIS", "DEPTH", "STATES"):
        shown = hexes(name, text)
        lightness = shown @ [0.2126, 0.7152, 0.0722]
        steps = np.abs(np.diff(lightness))
        assert steps.min() > 0.03, name
        if name != "STATES":  # ordered by lightness alone
            assert abs(np.sign(np.diff(lightness)).sum()) == len(shown) - 1


def test_a_notebook_cell_holds_the_whole_page(run):
    shown = moorage.view(run)
    cell = shown._repr_html_()
    assert html.unescape(re.search(r'srcdoc="([^"]*)"', cell)[1]) == shown.html
    assert "MB" in repr(shown)


def test_models_show_themselves_in_notebooks():
    text = moorage.read(EXAMPLES / "lazy_wave" / "lazy_wave.yaml")._repr_html_()
    for words in ("export cable", "end B of rod 1", "100 m", "lazy_wave.yaml", "A lazy-wave power cable"):
        assert words in text
    odd = dataclasses.replace(spread(4), title="<chains>")._repr_html_()
    assert "&lt;chains&gt;" in odd
    assert "3 coupled, 3 fixed" in odd


def test_the_command(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("webbrowser.open", lambda address: pytest.fail("no page may open here"))
    run.to_netcdf("run.nc")
    done = CliRunner().invoke(cli.app, ["view", "run.nc", "--no-open"])
    assert done.exit_code == 0, done.output
    assert "<canvas" in Path("run.html").read_text("utf-8")
    model = str(EXAMPLES / "oc4" / "oc4.dat")
    assert CliRunner().invoke(cli.app, ["view", model, "-o", "oc4.html", "--no-open"]).exit_code == 0
    assert '"moving":false' in Path("oc4.html").read_text("utf-8")
    assert CliRunner().invoke(cli.app, ["view", "run.nc", "-o", "no/where.html", "--no-open"]).exit_code == 2


def test_the_command_opens_the_page_where_there_is_a_desktop(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address: opened.append(address) or True)
    run.to_netcdf("run.nc")
    monkeypatch.setenv("DISPLAY", ":0")
    CliRunner().invoke(cli.app, ["view", "run.nc"])
    assert opened == [(tmp_path / "run.html").as_uri()]
    monkeypatch.setattr("sys.platform", "linux")
    monkeypatch.delenv("DISPLAY")
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    CliRunner().invoke(cli.app, ["view", "run.nc"])
    assert len(opened) == 1


def test_names_that_look_like_html_stay_in_their_script(run):
    """`<!--<script` in a script element would swallow its end."""
    ds = run.assign_attrs(title="<!--<script> & </script>").assign_coords(line_name=("line", ["<!--", "<script>", "x"]))
    meta = re.search(r'id="meta">(.*?)</script>', moorage.view(ds).html, re.DOTALL)[1]
    assert "<" not in meta
    assert json.loads(meta)["title"] == "<!--<script> & </script>"
    assert json.loads(meta)["lines"][1]["name"] == "line 2: <script>"


def test_instants_that_are_not_known_are_left_out_with_a_note(run):
    holes = run.copy(deep=True)
    holes["node_position"][2, 5] = np.nan
    holes["segment_tension"][3, 4] = np.nan
    holes["fairlead_tension"][10:12, 1] = np.nan
    scene = scene_of(holes)
    assert scene.meta["time"] == pytest.approx([0.0, 0.5, 2.0, 2.5, 3.0, 3.5, 4.0])
    assert scene.meta["notes"] == ["2 of 9 instants hold values that are not numbers, and are left out."]
    assert all(np.isfinite(table).all() for table in scene.arrays.values())
    assert scene.arrays["history"].shape == (39, 6)
    json.dumps(scene.meta, allow_nan=False)
    holes["node_position"][:, 5] = np.nan
    with pytest.raises(ResultError, match="at no instant are all positions and tensions numbers"):
        scene_of(holes)


def test_a_quantity_of_one_value_has_no_scale():
    """A rope without weight in water, stretched by 5 %: 500 kN all along."""
    rope = kind(diameter=0.1, mass_per_length=np.pi / 4.0 * 0.1**2 * 1025.0)
    points = (fixed(1, 0.0, 0.0, -20.0), fixed(2, 10.5, 0.0, -20.0))
    model = mooring(rope, points, (line(1, 1, 2, ("rope", 10.0, 5)),), water_depth=50.0)
    tension, curvature = scene_of(moorage.solve_statics(model)).meta["quantities"][:2]
    assert tension["low"] == tension["high"] == pytest.approx(500.0, rel=1e-6)
    assert curvature["low"] == curvature["high"] == 0.0


def test_an_upright_line_stands_on_ground_that_can_be_seen():
    model = mooring(
        kind(), (fixed(1, 0.0, 0.0, -100.0), fixed(2, 0.0, 0.0, -10.0)), (line(1, 1, 2, ("rope", 90.0, 9)),)
    )
    x0, y0, x1, y1 = scene_of(moorage.solve_statics(model)).meta["region"]
    assert min(x1 - x0, y1 - y0) > 0.1 * 90.0


def test_a_rod_is_shown_where_there_are_no_lines():
    rod = Rod(id=1, rod_type="clamp", kind="fixed", end_a=(0.0, 0.0, -30.0), end_b=(0.0, 0.0, 10.0), segments=4)
    model = mooring(kind(), (), (), (rod,), water_depth=60.0)
    scene = scene_of(moorage.solve_statics(model), model)
    assert scene.meta["lines"] == []
    assert scene.meta["rods"] == [{"name": "rod 1"}]
    assert len(moorage.view(model).html) > 1e5


def test_a_run_that_did_not_end_is_told(run):
    cut = run.isel(time=slice(0, 21), node_time=slice(0, 5)).assign_attrs(status="failed at 2.03 s: line 1 ...")
    (note,) = scene_of(cut).meta["notes"]
    assert note == "The run is not complete: failed at 2.03 s: line 1 ...; 2 s of 4 s are here."
    assert "killed; 2 s" in scene_of(cut.assign_attrs(status="running")).meta["notes"][0]
    assert scene_of(run).meta["notes"] == []


def test_a_mooring_far_from_the_origin_keeps_its_places():
    """In coordinates of a survey; single precision there would be 0.5 m. The sea is that of the run all the same."""
    sea = Waves.regular(4.0, 9.0, depth=200.0, direction=0.7)
    near = spread(10, waves=sea)
    moved = [
        dataclasses.replace(p, position=(p.position[0] + 5e5, p.position[1] + 6e6, p.position[2])) for p in near.points
    ]
    ds = moorage.simulate(dataclasses.replace(near, points=tuple(moved)), duration=1.0)
    scene = scene_of(ds)
    origin = np.array([*scene.meta["origin"], 0.0])
    assert origin.tolist() == [500e3, 6000e3, 0.0]
    back = unpack(pack(scene.arrays))["position"].reshape(len(ds["time"]), -1, 3) + origin
    np.testing.assert_allclose(back, ds["node_position"].values, atol=1e-3)
    ((_, kx, ky, _, phase),) = scene.meta["sea"]["components"]
    whole = [kx * 5e5 + ky * 6e6 + phase, sea.phase[0]]
    assert np.exp(1j * whole[0]) == pytest.approx(np.exp(1j * whole[1]), abs=1e-6)
    assert scene_of(moorage.solve_statics(near)).meta["origin"] == [0.0, 0.0]
