"""Pictures: that everything is drawn and labelled, and that nothing is drawn over something else."""

from pathlib import Path

import numpy as np
import pytest
from moorings import CHAIN, coupled, fixed, free, line, mooring

import moorage
from moorage.plot import moorings, plot_plan, plot_profile, plot_tension, result_figure
from moorage.plot.style import new_figure

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4" / "oc4.dat"


@pytest.fixture(scope="module")
def oc4():
    motion = moorage.Motion.from_harmonics(10.0, ramp=5.0, surge=(2.0, 8.0))
    return moorage.simulate(moorage.read(EXAMPLE), duration=10.0, motion=motion)


@pytest.fixture(scope="module")
def bridle():
    points = [fixed(1, -600.0, 0.0, -120.0), free(2, -60.0, 0.0, -30.0, mass=2e3, volume=3.0)]
    points += [coupled(3, -10.0, 15.0, -8.0), coupled(4, -10.0, -15.0, -8.0), coupled(5, 10.0, 0.0, -8.0)]
    points += [fixed(6, 600.0, 0.0, -120.0)]
    lines = [line(4, 1, 2, ("chain", 560.0, 20)), line(1, 2, 3, ("chain", 58.0, 5)), line(3, 2, 4, ("chain", 58.0, 5))]
    return moorage.solve_statics(
        mooring(CHAIN, points, [*lines, line(2, 6, 5, ("chain", 620.0, 20))], water_depth=120.0)
    )


@pytest.fixture(scope="module")
def wheel():
    points, lines = [], []
    for k in range(8):
        c, s = np.cos(np.pi * k / 4.0), np.sin(np.pi * k / 4.0)
        points += [fixed(2 * k + 1, 800.0 * c, 800.0 * s, -200.0), coupled(2 * k + 2, 40.0 * c, 40.0 * s, -14.0)]
        lines.append(line(k + 1, 2 * k + 1, 2 * k + 2, ("chain", 800.0, 10)))
    model = mooring(CHAIN, points, lines, water_depth=200.0)
    return moorage.simulate(model, duration=1.0, dt_out=0.5)


def assert_tidy(figure):
    """Check that axes and legends do not overlap, and that every axis has its words and units."""
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    boxes = [ax.get_tightbbox(renderer) for ax in figure.axes]
    for k, box in enumerate(boxes):
        for other in boxes[k + 1 :]:
            overlap = (min(box.x1, other.x1) - max(box.x0, other.x0), min(box.y1, other.y1) - max(box.y0, other.y0))
            assert min(overlap) < 2.0, overlap  # pixels
        assert box.x0 >= -1.0
        assert box.x1 <= figure.bbox.x1 + 1.0
    for ax in figure.axes:
        for text in (ax.get_xlabel(), ax.get_ylabel()):
            assert text == "" or text.endswith(")")
        legend = ax.get_legend()
        if legend:
            inside = ax.get_window_extent(renderer)
            assert legend.get_window_extent(renderer).y0 >= inside.y1 - 4.0
    assert figure.axes[-1].get_xlabel()


def test_figure_of_a_run(oc4):
    figure = result_figure(oc4)
    tension, *profiles = figure.axes
    assert [text.get_text() for text in tension.get_legend().get_texts()] == ["line 1", "line 2", "line 3"]
    assert tension.get_ylabel() == "fairlead tension (kN)"
    assert [ax.get_title(loc="left") for ax in profiles] == ["line 1", "line 2", "line 3"]
    assert [t.get_text() for t in profiles[0].get_legend().get_texts()] == ["static", "during the run"]
    assert_tidy(figure)


def test_lines_that_free_points_join_are_one_mooring(bridle, oc4):
    assert moorings(bridle) == [[1, 3, 4], [2]]
    assert moorings(oc4) == [[1], [2], [3]]


def test_figure_of_statics_has_profiles_only(bridle):
    figure = result_figure(bridle)
    assert [ax.get_title(loc="left") for ax in figure.axes] == ["", "line 2"]
    labels = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert labels[:3] == ["line 1", "line 3", "line 4"]  # a title would stand under them
    assert_tidy(figure)


def test_figure_of_many_moorings_is_drawn_together(wheel):
    figure = result_figure(wheel)
    assert len(figure.axes) == 3
    labels = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
    assert labels[0] == "other lines"
    assert len(labels) == 4
    assert [t.get_text() for t in figure.axes[2].get_legend().get_texts()] == ["fixed points", "coupled points"]
    assert_tidy(figure)


def test_figure_without_node_histories_is_of_tensions(oc4):
    figure = result_figure(oc4.drop_dims(["node", "segment"]))
    assert len(figure.axes) == 1
    assert_tidy(figure)


def test_profile_shows_the_line_where_it_is(oc4):
    ax = plot_profile(oc4, [2], new_figure(5, 3).add_subplot())
    x, z = ax.lines[0].get_data()
    assert x[-1] == pytest.approx(0.0, abs=1e-9)  # the fairlead
    assert x[0] == pytest.approx(837.6 - 40.868)
    np.testing.assert_allclose([z[0], z[-1]], [-200.0, -14.0])
    assert ax.get_ylim()[0] < -200.0
    assert ax.get_ylim()[1] > 0.0


def test_functions_take_any_axes(oc4):
    figure = new_figure(6, 3)
    assert plot_tension(oc4, figure.add_subplot(121), "anchor_tension").get_ylabel() == "anchor tension (kN)"
    assert plot_plan(oc4, figure.add_subplot(122)).get_aspect() == 1.0


@pytest.mark.parametrize("turn", [0.0, 120.0])
def test_profile_of_what_floats_begins_there(turn):
    """The line of a buoy, held at its anchor alone, is drawn in its own plane, whatever its heading."""
    x, y = 30.0 * np.cos(np.deg2rad(turn)), 30.0 * np.sin(np.deg2rad(turn))
    anchor, buoy = fixed(1, x, y, -40.0), free(2, 0.0, 0.0, -5.0, mass=10.0, volume=0.5)
    model = mooring(CHAIN, (anchor, buoy), (line(1, 1, 2, ("chain", 60.0, 10)),), water_depth=40.0)
    ds = moorage.simulate(model, duration=0.2, start="as-given")
    ax = plot_profile(ds, [1], new_figure(5, 3).add_subplot())
    shape = next(drawn for drawn in ax.lines if len(drawn.get_xdata()) == 11).get_xdata()
    assert sorted(shape[[0, -1]]) == pytest.approx([0.0, 30.0], abs=1e-6)
