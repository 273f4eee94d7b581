"""Pictures of the seabed: under profiles, and as maps."""

import dataclasses

import numpy as np
import pytest
from moorings import CHAIN, coupled, fixed, line, mooring, spread
from test_plot import assert_tidy

import moorage
from moorage.model import Bathymetry
from moorage.plot import plot_profile, result_figure, seabed_map
from moorage.plot.style import new_figure
from moorage.results.bed_level import bed_level


def valley(smooth=False):
    """Three chains on a seabed that is deep along y = 0 and falls with x."""
    x, y = np.linspace(-1000.0, 1000.0, 21), np.linspace(-900.0, 900.0, 19)
    depth = 210.0 + 0.03 * x[:, None] - 40.0 * (y[None] / 900.0) ** 2
    grid = Bathymetry(tuple(x), tuple(y), tuple(map(tuple, depth)), smooth)
    model = spread(20, bathymetry=grid)
    points = [
        p if p.kind != "fixed" else fixed(p.id, *p.position[:2], -grid.depth_at(*p.position[:2])) for p in model.points
    ]
    return dataclasses.replace(model, points=tuple(points))


@pytest.fixture(scope="module")
def uneven():
    motion = moorage.Motion.from_harmonics(6.0, ramp=3.0, surge=(3.0, 6.0))
    return moorage.simulate(valley(), motion=motion, duration=6.0, dt_out=0.5)


def test_profile_lies_on_the_real_seabed(uneven):
    ax = plot_profile(uneven, [1], new_figure(5, 3).add_subplot())
    sections = [c for c in ax.collections if c.get_zorder() == 1 and len(c.get_segments()) == 1]
    (section,) = sections[0].get_segments()
    x, z = ax.lines[0].get_data()
    anchor = np.interp(x[0], *section.T)
    assert anchor == pytest.approx(z[0], abs=0.5)
    assert np.ptp(np.interp(np.linspace(0.0, x[0], 9), *section.T)) > 10.0
    assert ax.get_ylim()[0] < section[:, 1][(section[:, 0] > 0.0) & (section[:, 0] < x[0])].min()
    assert np.all(np.interp(x, *section.T) < z + 0.6)


def test_figure_of_an_uneven_seabed(uneven):
    figure = result_figure(uneven)
    assert_tidy(figure)
    floors = [ax.get_ylim()[0] for ax in figure.axes[1:]]
    assert len(set(floors)) == 1


def test_flat_seabed_stays_flat():
    ds = moorage.solve_statics(spread(20))
    ax = plot_profile(ds, [1], new_figure(5, 3).add_subplot())
    assert ax.get_ylim()[0] == pytest.approx(-1.06 * 200.0)
    np.testing.assert_array_equal(bed_level(ds, np.zeros(2), np.ones(2)), -200.0)


@pytest.mark.parametrize("smooth", [False, True])
def test_level_is_that_of_the_model(smooth):
    model = valley(smooth)
    ds = moorage.solve_statics(model)
    x, y = np.array([10.0, -555.0]), np.array([-333.0, 100.0])
    expected = [-model.environment.depth_at(*place) for place in zip(x, y, strict=True)]
    np.testing.assert_allclose(bed_level(ds, x, y), expected, atol=0.2 if smooth else 1e-9)
    assert ds.attrs["bathymetry_interpolation"] == ("bicubic" if smooth else "bilinear")


def test_map_of_a_result_and_of_a_model(uneven):
    for source, lines in ((uneven, 21), (valley(), 2)):
        ax = seabed_map(source)
        footprint = next(c for c in ax.collections if len(c.get_paths()) == 3 and c.get_zorder() == 3)
        assert len(footprint.get_paths()[0].vertices) == lines
        names = [text.get_text() for text in ax.get_legend().get_texts()]
        assert names == ["fixed points", "coupled points"] + (["touchdown"] if lines == 21 else [])
        assert [a.get_ylabel() for a in ax.figure.axes] == ["y (m)", "water depth (m)"]
        ax.figure.canvas.draw()


def test_map_of_a_flat_seabed_and_on_given_axes():
    ax = new_figure(4, 4).add_subplot()
    model = mooring(
        CHAIN, [fixed(1, 0, 0, -50), coupled(2, 60, 0, 0)], [line(1, 1, 2, ("chain", 90.0, 3))], water_depth=50.0
    )
    assert seabed_map(model, ax) is ax
    assert ax.get_title(loc="left") == "water depth 50 m"
    level = Bathymetry((-100.0, 100.0), (-100.0, 100.0), ((50.0, 50.0), (50.0, 50.0)))
    model = dataclasses.replace(model, environment=dataclasses.replace(model.environment, bathymetry=level))
    seabed_map(model).figure.canvas.draw()


def test_map_of_a_flat_seabed_shows_where_lines_touch_down():
    """A chain slack enough that its touchdown is where the catenary has it, to the length of a segment."""
    model = mooring(
        CHAIN, [fixed(1, 0, 0, -50), fixed(2, 80.0, 0, 0)], [line(1, 1, 2, ("chain", 110.0, 44))], water_depth=50.0
    )
    ds = moorage.solve_statics(model)
    ax = seabed_map(ds)
    (mark,) = (drawn for drawn in ax.lines if drawn.get_label() == "touchdown")
    x, y = mark.get_data()
    assert x[0] == pytest.approx(ds["grounded_length"].item(), abs=2.5)
    assert y[0] == pytest.approx(0.0, abs=1e-6)
