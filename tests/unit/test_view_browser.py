"""The page of a result in a real browser: it draws, moves, answers to pointer and keys, is quick, and fits a laptop."""

import base64
import io
import json
import re
from pathlib import Path

import browser
import numpy as np
import pytest
from moorings import kind, mooring, spread
from PIL import Image

import moorage
from moorage.model import Friction, Rod, Waves

webdriver = pytest.importorskip("selenium.webdriver", reason="no selenium: pip install moorage[dev]")
OC4 = Path(__file__).parents[2] / "examples" / "oc4"


START = """
    const app = moorage.app;
    app.play(false); app.setTime(0); app.select(null); moorage.help(false); app.setQuantity("tension"); app.setStretch(1);
    app.look("overview", 0); app.stage.world.children.forEach((c) => (c.visible = true)); document.activeElement.blur();
"""


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    yield from browser.start(tmp_path_factory.mktemp("profile"))


@pytest.fixture(scope="module")
def run():
    waves = Waves.regular(6.0, 9.0, depth=200.0, direction=0.5)
    model = spread(20, waves=waves, friction=Friction(transverse=0.8, axial=0.6))
    motion = moorage.Motion.from_harmonics(12.0, ramp=3.0, surge=(4.0, 9.0), heave=(2.0, 9.0))
    return moorage.simulate(model, motion=motion, duration=12.0, dt_out=0.1)


@pytest.fixture(scope="module")
def path(run, tmp_path_factory):
    return moorage.view(run).save(tmp_path_factory.mktemp("page") / "run.html")


@pytest.fixture
def shown(page, path):
    """The page of the run as it starts; afterwards the console must be empty of errors."""
    if page.current_url != path.as_uri():
        browser.show(page, path)
    page.execute_script(START)
    browser.settle(page)
    yield page
    assert browser.complaints(page) == []


def press(page, *keys):
    chain = actions(page)
    for key in keys:
        chain.send_keys(key)
    chain.perform()
    browser.settle(page)


def actions(page):
    return webdriver.ActionChains(page, duration=0)


def key(name):
    return getattr(webdriver.Keys, name)


def at(page, x, y):
    """Return a chain of actions with the pointer at a pixel of the window."""
    chain = actions(page)
    chain.w3c_actions.pointer_action.move_to_location(round(x), round(y))
    return chain


def node(page, k):
    return page.execute_script(f"return moorage.node({k})")


def now(page):
    return page.execute_script("return moorage.app.state.time")


def in_middle(image):
    return image[150:690, 300:1070]


def test_it_draws_seabed_water_lines_and_signs(shown):
    image = in_middle(browser.pixels(shown))
    assert len(np.unique(image.reshape(-1, 3), axis=0)) > 300
    without = "moorage.app.stage.world.children.forEach((c) => (c.visible = false)); moorage.app.stale = true"
    shown.execute_script(without)
    empty = in_middle(browser.pixels(shown))
    assert (np.abs(image - empty).max(axis=-1) > 8).mean() > 0.2


def test_nothing_is_loaded_from_elsewhere(shown):
    assert shown.execute_script("return performance.getEntriesByType('resource').map((e) => e.name)") == []


def test_the_slider_moves_lines_to_where_the_result_has_them(shown, run):
    before, start = in_middle(browser.pixels(shown)), node(shown, 19)
    slider = shown.find_element("id", "slider")
    box = slider.rect
    at(shown, box["x"] + 0.62 * box["width"], box["y"] + 0.5 * box["height"]).click().perform()
    browser.settle(shown)
    t = now(shown)
    assert 6.0 < t < 9.0
    exact = [run["node_position"].interp(time=t).values[k] for k in (5, 19, 20)]
    np.testing.assert_allclose([node(shown, k) for k in (5, 19, 20)], exact, atol=2e-3)
    assert np.linalg.norm(np.subtract(node(shown, 19), start)) > 0.5
    assert (np.abs(in_middle(browser.pixels(shown)) - before).max(axis=-1) > 8).sum() > 500
    assert shown.find_element("id", "now").text == f"{t:.1f}"


def test_the_sea_is_that_of_the_run(shown, run):
    for t in (0.0, 4.0, 7.3):
        there = shown.execute_script(f"return moorage.elevation(0, 0, {t})")
        assert there == pytest.approx(run["wave_elevation"].interp(time=t).item(), abs=2e-3)
    before = browser.pixels(shown)[60:140, 600:1000]  # nothing but water
    shown.execute_script("moorage.setTime(4.5)")
    assert np.abs(browser.pixels(shown)[60:140, 600:1000] - before).max() > 4


def test_a_click_on_a_line_shows_its_tension(shown, run):
    shown.execute_script("moorage.setTime(5.0)")
    browser.settle(shown)
    assert not shown.find_element("id", "panel").is_displayed()
    x, y, _ = shown.execute_script("return moorage.pixel(...moorage.node(30))")
    at(shown, x, y).click().perform()
    browser.settle(shown)
    panel = shown.find_element("id", "panel")
    assert panel.is_displayed()
    assert panel.find_element("css selector", "h2").text == "line 2"
    cells = [float(cell.text) for cell in panel.find_elements("css selector", "tbody td")]
    of_line = run.sel(line=2)
    for k, end in enumerate(("anchor_tension", "fairlead_tension")):
        history = of_line[end].values / 1e3
        exact = [history[50], history.min(), history.max()]
        np.testing.assert_allclose(cells[3 * k : 3 * k + 3], exact, atol=0.6)
    curve = shown.execute_script("return moorage.app.panel.plot.still.toDataURL()").split(",")[1]
    colours = np.asarray(Image.open(io.BytesIO(base64.b64decode(curve))).convert("RGB")).reshape(-1, 3)
    assert {(213, 94, 0), (0, 114, 178)} <= set(map(tuple, colours.tolist()))  # both ends are drawn
    canvas = panel.find_element("css selector", "canvas").rect
    at(shown, canvas["x"] + 0.9 * canvas["width"], canvas["y"] + 60).click().perform()
    assert 9.0 < now(shown) < 12.0  # a click in the history goes there
    at(shown, x, y + 100).click().perform()
    browser.settle(shown)
    assert not panel.is_displayed()


def test_names_and_values_show_under_the_pointer(shown, run):
    tip = shown.find_element("id", "tip")
    x, y, _ = shown.execute_script("return moorage.pixel(...moorage.node(0))")
    at(shown, x, y).perform()
    browser.settle(shown)
    assert tip.text.startswith("point 1 fixed")
    x, y, _ = shown.execute_script("return moorage.pixel(...moorage.node(10))")
    at(shown, x, y).perform()
    browser.settle(shown)
    assert tip.text.startswith("line 1")
    told = float(re.search(r"Tension ([\d.]+) kN", tip.text)[1])
    exact = run["segment_tension"].isel(time=0, segment=slice(9, 11)).mean().item() / 1e3
    assert shown.execute_script("return moorage.value('tension', 10)") == pytest.approx(exact, rel=1e-4)
    assert told == pytest.approx(exact, rel=0.02)  # at the place under the pointer, within a pixel or so
    assert "held by friction" in tip.text or "clear of the seabed" in tip.text


def test_keys(shown):
    help_ = shown.find_element("id", "help")
    press(shown, "?")
    assert help_.is_displayed()
    press(shown, key("ESCAPE"))
    assert not help_.is_displayed()
    press(shown, key("ARROW_RIGHT"))
    step = now(shown)
    assert step == pytest.approx(0.1)
    press(shown, key("ARROW_UP"))
    assert now(shown) == pytest.approx(11 * step)
    press(shown, key("END"))
    assert now(shown) == 12.0
    press(shown, key("HOME"), " ")
    browser.wait(lambda: now(shown) > 0.3)
    press(shown, " ")
    stopped = now(shown)
    browser.settle(shown)
    assert now(shown) == stopped
    press(shown, "l")
    assert shown.find_element("id", "panel").is_displayed()
    press(shown, "c")
    assert shown.execute_script("return moorage.app.state.quantity.key") == "curvature"
    press(shown, "v")
    assert shown.execute_script("return moorage.app.stage.stretch") == 2


def test_cameras(shown):
    seen = []
    for number, view in enumerate(("overview", "side", "top", "close"), 1):
        press(shown, str(number))
        browser.wait(lambda: not shown.execute_script("return moorage.app.stage.flight"))
        pressed = shown.execute_script("return document.querySelector('[data-view][aria-pressed=true]').dataset.view")
        assert pressed == view
        seen.append(in_middle(browser.pixels(shown)))
        if view != "close":  # all of the mooring is on the screen
            for k in (0, 21, 42):
                x, y, _ = shown.execute_script(f"return moorage.pixel(...moorage.node({k}))")
                assert 0 < x < browser.WIDTH
                assert 0 < y < browser.HEIGHT - 70
    changes = [np.abs(a - b).max(axis=-1).mean() for a, b in zip(seen[1:], seen[:-1], strict=True)]
    assert min(changes) > 3.0


def test_lines_change_their_colours_with_the_quantity(shown):
    pictures = []
    for key_ in ("tension", "curvature", "contact"):
        shown.execute_script(f"moorage.app.setQuantity('{key_}')")
        pictures.append(in_middle(browser.pixels(shown)))
    assert all((np.abs(a - b).max(axis=-1) > 30).sum() > 300 for a, b in zip(pictures[1:], pictures[:-1], strict=True))
    assert [e.text for e in shown.find_elements("css selector", ".state")][-1] == "held by friction"


def test_nothing_hangs_over_the_edge_of_a_laptop_or_over_another(shown):
    shown.execute_script("moorage.app.select(0)")
    browser.settle(shown)
    boxes = {name: shown.find_element("id", name).rect for name in ("about", "legend", "panel", "bar", "axes")}
    for name, r in boxes.items():
        inside = r["x"] >= 0 and r["y"] >= 0 and r["x"] + r["width"] <= browser.WIDTH
        assert inside, name
        assert r["y"] + r["height"] <= browser.HEIGHT, name
    names = sorted(boxes)
    for i, a in enumerate(names):
        for b in names[i + 1 :]:
            p, q = boxes[a], boxes[b]
            apart = p["x"] + p["width"] <= q["x"] or q["x"] + q["width"] <= p["x"]
            apart = apart or p["y"] + p["height"] <= q["y"] or q["y"] + q["height"] <= p["y"]
            assert apart, (a, b)
    assert shown.execute_script("return document.documentElement.scrollWidth") == browser.WIDTH


def test_the_picture_is_sharp_and_has_its_legend(shown):
    data = shown.execute_script("return moorage.app.picture().toDataURL()").split(",")[1]
    picture = Image.open(io.BytesIO(base64.b64decode(data))).convert("RGB")
    assert picture.size == (2 * browser.WIDTH, 2 * browser.HEIGHT)
    legend = np.asarray(picture)[80:110, 2 * browser.WIDTH - 500 : 2 * browser.WIDTH - 60].reshape(-1, 3)
    assert np.abs(legend - np.array([33, 145, 140])).sum(axis=1).min() < 8  # the middle of viridis
    assert len(np.unique(np.asarray(picture).reshape(-1, 3)[::7], axis=0)) > 300


def test_a_model_shows_its_static_shape(page, tmp_path):
    browser.show(page, moorage.view(OC4 / "oc4.dat").save(tmp_path / "static.html"))
    assert not page.find_element("id", "slider").is_displayed()
    assert "static equilibrium" in page.find_element("id", "facts").text
    page.execute_script("moorage.app.select(0)")
    assert page.find_element("id", "panel").is_displayed()
    assert browser.complaints(page) == []


def test_a_page_shows_itself_in_a_frame_of_a_notebook(page, run, tmp_path):
    (tmp_path / "cell.html").write_text(f"<!doctype html><body>{moorage.view(run)._repr_html_()}", "utf-8")
    page.get((tmp_path / "cell.html").as_uri())
    page.switch_to.frame(page.find_element("css selector", "iframe"))
    browser.wait(lambda: page.execute_script("return document.documentElement.dataset.ready"), 20.0)
    assert page.execute_script("return moorage.app.times.length") == 121
    page.switch_to.default_content()
    assert browser.complaints(page) == []


def test_whatever_a_result_holds_is_shown(page, run, tmp_path):
    """Names like HTML, values that are not known, one value, one instant, a rod alone: ready, and nothing complains."""
    odd = run.isel(time=slice(0, 20)).copy(deep=True).assign_attrs(title="<!--<script> & <b>日本</b>")
    odd["segment_tension"][3:6] = np.nan
    odd["fairlead_tension"][8, 1] = np.nan
    still = run.isel(time=[5]).assign(segment_tension=run["segment_tension"].isel(time=[5]) * 0.0 + 5e5)
    rod = Rod(id=1, rod_type="clamp", kind="fixed", end_a=(0.0, 0.0, -30.0), end_b=(0.0, 0.0, 10.0), segments=4)
    alone = mooring(kind(), (), (), (rod,), water_depth=60.0)
    for source in (odd, still, alone):
        browser.show(page, moorage.view(source).save(tmp_path / "odd.html"))
        for view in ("side", "top", "close", "overview"):
            page.execute_script(f"moorage.app.look('{view}', 0)")
            browser.settle(page)
        page.execute_script("if (moorage.app.meta.lines.length) moorage.app.select(0)")
        browser.settle(page)
        told = page.find_element("id", "legend").text
        if source is odd:
            assert page.find_element("id", "title").text == odd.attrs["title"]
            assert "3 of 20 instants" in page.find_element("id", "notes").text
            highest = page.find_element("css selector", "#panel tbody tr:last-child td:last-child").text
            assert float(highest) > 0.0
        if source is still:
            assert "500 kN everywhere" in told
            assert page.execute_script("return moorage.app.lines.data[3]") == pytest.approx(0.5)
        if source is alone:
            assert "rod" in told
            assert "Lines by" not in told
        assert browser.complaints(page) == []


def test_an_open_panel_hides_nothing_that_a_preset_shows(shown):
    shown.execute_script("moorage.app.select(1)")
    edge = shown.find_element("id", "panel").rect
    for view in ("overview", "side", "top"):
        shown.execute_script(f"moorage.app.look('{view}', 0)")
        browser.settle(shown)
        seen = [shown.execute_script(f"return moorage.pixel(...moorage.node({k}))") for k in range(0, 63, 4)]
        assert min(x for x, _, _ in seen) >= edge["x"] + edge["width"]
        assert max(x for x, _, _ in seen) < browser.WIDTH


def test_rods_and_bodies_are_drawn(page, run, tmp_path):
    """Rods of 60 m and a body stand where a dataset says; hidden, the picture changes."""
    time = run["time"].values
    ends = np.zeros((len(time), 1, 2, 3)) + np.array([[-400.0, -500.0, -30.0], [-340.0, -500.0, -30.0]])
    place = np.zeros((len(time), 1, 3)) + np.array([-400.0, 300.0, -30.0])
    ds = run.assign(
        rod_position=(("time", "rod", "rod_end", "xyz"), ends),
        body_position=(("time", "body", "xyz"), place),
        body_rotation=(("time", "body", "xyz"), 0.0 * place + [0.0, 0.0, 0.6]),
    ).assign_coords(rod=[7], body=[3])
    browser.show(page, moorage.view(ds).save(tmp_path / "things.html"))
    whole = browser.pixels(page)
    for thing, where in (("rods.meshes[0]", ends[0, 0].mean(axis=0)), ("bodies.group", place[0, 0])):
        page.execute_script(f"moorage.app.{thing}.visible = false; moorage.app.stale = true")
        without = browser.pixels(page)
        x, y, _ = page.execute_script(f"return moorage.pixel(...{json.dumps(where.tolist())})")
        change = np.abs(without - whole).max(axis=-1)[int(y) - 4 : int(y) + 5, int(x) - 4 : int(x) + 5]
        assert (change > 20).mean() > 0.3, thing
        page.execute_script(f"moorage.app.{thing}.visible = true")
    for name, where in (("rod 7", ends[0, 0].mean(axis=0)), ("body 3", place[0, 0])):
        x, y, _ = page.execute_script(f"return moorage.pixel(...{json.dumps(where.tolist())})")
        at(page, x, y).perform()
        browser.settle(page)
        assert page.find_element("id", "tip").text == name
    turn = page.execute_script(
        "const b = moorage.app.bodies.group.children[0]; return b.rotation.toArray().slice(0, 3)"
    )
    assert turn == pytest.approx([0.0, 0.0, 0.6], abs=1e-4)


def test_ten_minutes_of_three_chains_are_small_and_quick(page, tmp_path):
    """Limits: 20 MB, ready within 2 s (a busy machine may try five times), 10 ms of script in a frame on average."""
    motion = moorage.Motion.from_harmonics(600.0, ramp=20.0, surge=(4.0, 11.0), heave=(1.5, 11.0))
    ds = moorage.simulate(moorage.read(OC4 / "oc4.dat"), motion=motion, duration=600.0, dt_out=0.1)
    path = moorage.view(ds).save(tmp_path / "long.html")
    assert path.stat().st_size < 20e6
    assert any(browser.show(page, path) < 2.0 for _ in range(5))
    assert page.execute_script("return moorage.app.times.length") == 6001
    page.execute_script("moorage.app.select(1); moorage.clear(); moorage.app.play(true)")
    browser.wait(lambda: page.execute_script("return moorage.script().frames") > 20, 20.0)
    assert page.execute_script("return moorage.script().mean") < 10.0
    assert browser.complaints(page) == []
