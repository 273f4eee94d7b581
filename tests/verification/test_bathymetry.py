"""Depth and normal of the seabed: planes, a paraboloid, random grids, their edges, both files, and the smooth option.

Verifies: bathymetry

Bilinear depth is exact for 1, x, y and x y on any rectangular grid: to rounding. Of a bowl z = p x^2 + q y^2 it misses
p a (dx - a) + q b (dy - b) at a place a, b into a cell, exactly: at most (p dx^2 + q dy^2) / 4, which falls with the
square of the spacing. Its slope is off by p |dx - 2 a|: first order. The smooth surface through the same points takes
slopes from central differences, which are exact for a bowl on even spacing, so that it is the bowl itself inside the
outermost cells. On a random grid both are the grid's own depths at its points. Across an edge the bilinear normal
turns, and the smooth one does not. Where x and y differ in count and spacing, a transposed table must fail.

Normals within 2 % of a cell from an edge are left out where they are that of one cell: there they go from one cell's
to the next one's. The depth counts everywhere.

Outside the grid the nearest edge goes on, level along the way out. MoorDyn-C's list of x, y, z and MoorDyn-F's matrix
of depths give the same seabed.
"""

from __future__ import annotations

import numpy as np
import pytest
from common import must_fail, rate

from moorage.errors import Source
from moorage.io.bathymetry import read_bathymetry
from moorage.io.text import Findings
from moorage.model import Bathymetry
from moorage.physics.bathymetry import bed_at, grid_bed, normal_of, searched_bed_at

X = np.array([-60.0, -45.0, -20.0, 0.0, 10.0, 40.0, 70.0])
Y = np.array([-30.0, 0.0, 5.0, 50.0])
RANDOM = np.random.default_rng(4)
ROUGH = 100.0 + RANDOM.normal(0.0, 3.0, (len(X), len(Y)))
BESIDE = 0.02  # of a cell, from its edges


def places(x, y, count: int = 300) -> np.ndarray:
    """Return places of a grid that are not beside an edge, (n, 2)."""
    found = RANDOM.uniform([x[0], y[0]], [x[-1], y[-1]], (count, 2))
    return found[inside_cells(x, found[:, 0]) & inside_cells(y, found[:, 1])]


def inside_cells(axis, value) -> np.ndarray:
    k = np.clip(np.searchsorted(axis, value, side="right") - 1, 0, len(axis) - 2)
    part = (value - axis[k]) / (axis[k + 1] - axis[k])
    return (part > BESIDE) & (part < 1.0 - BESIDE)


def bed_of(depth, smooth: bool = False, x=X, y=Y):
    return grid_bed(x, y, depth(x[:, None], y[None, :]), smooth)


def check(bed, depth, slopes, at, tolerance: float = 1e-11) -> None:
    """Compare levels and normals with those of a depth d(x, y) and its slopes."""
    for x, y in at:
        z, zx, zy, *_ = bed_at(bed, x, y)
        assert z == pytest.approx(-depth(x, y), abs=100.0 * tolerance)
        dx, dy = slopes(x, y)
        n = np.array([dx, dy, 1.0]) / np.sqrt(1.0 + dx**2 + dy**2)
        assert normal_of(zx, zy) == pytest.approx(n, abs=tolerance)


def plane(x, y):
    return 100.0 + 0.15 * x - 0.08 * y


def plane_slopes(x, y):
    return 0.15, -0.08


@pytest.mark.parametrize("smooth", [False, True])
def test_plane(smooth):
    check(bed_of(plane, smooth), plane, plane_slopes, places(X, Y))


def test_twisted_surface_is_bilinear():
    bed = bed_of(lambda x, y: plane(x, y) + 2e-3 * x * y)
    slopes = lambda x, y: (0.15 + 2e-3 * y, -0.08 + 2e-3 * x)  # noqa: E731
    check(bed, lambda x, y: plane(x, y) + 2e-3 * x * y, slopes, places(X, Y))


def test_transposed_table_fails():
    table = plane(X[:, None], Y[None, :]).T.reshape(len(X), len(Y))
    must_fail(check, grid_bed(X, Y, table), plane, plane_slopes, places(X, Y))


P, Q = 1e-3, 2e-3


def bowl(x, y):
    return 100.0 - P * x**2 - Q * y**2


def even(spacing: float) -> tuple[np.ndarray, np.ndarray]:
    return np.arange(-80.0, 80.5, spacing), np.arange(-40.0, 40.5, 0.5 * spacing)


def test_bowl_is_missed_by_what_interpolation_says():
    x, y = even(16.0)

    def depth(px, py):
        a, b = (px + 80.0) % 16.0, (py + 40.0) % 8.0
        return bowl(px, py) - P * a * (16.0 - a) - Q * b * (8.0 - b)

    def slopes(px, py):
        a, b = (px + 80.0) % 16.0, (py + 40.0) % 8.0
        return -2.0 * P * px - P * (16.0 - 2.0 * a), -2.0 * Q * py - Q * (8.0 - 2.0 * b)

    check(bed_of(bowl, False, x, y), depth, slopes, places(x, y))


def test_bowl_by_spacing():
    at = RANDOM.uniform([-60.0, -30.0], [60.0, 30.0], (200, 2))
    spacings = np.array([20.0, 10.0, 5.0, 2.5])
    depth, slope = [], []
    for h in spacings:
        found = np.array([bed_at(bed_of(bowl, False, *even(h)), x, y)[:2] for x, y in at])
        depth.append(np.abs(found[:, 0] + bowl(*at.T)).max())
        slope.append(np.abs(found[:, 1] - 2.0 * P * at[:, 0]).max())
    assert rate(spacings, depth) == pytest.approx(2.0, abs=0.15)
    assert rate(spacings, slope) == pytest.approx(1.0, abs=0.15)


def test_smooth_surface_of_a_bowl_is_exact():
    x, y = even(16.0)
    at = RANDOM.uniform([-64.0, -32.0], [64.0, 32.0], (200, 2))
    check(bed_of(bowl, True, x, y), bowl, lambda x, y: (-2.0 * P * x, -2.0 * Q * y), at)


@pytest.mark.parametrize("smooth", [False, True])
def test_random_grid_keeps_its_depths(smooth):
    bed = grid_bed(X, Y, ROUGH, smooth)
    for i, x in enumerate(X):
        for j, y in enumerate(Y):
            assert bed_at(bed, x, y)[0] == pytest.approx(-ROUGH[i, j], abs=1e-12)


@pytest.mark.parametrize("smooth", [False, True])
def test_random_grid_is_what_the_model_says(smooth):
    """Anchors, checks and first guesses take the depth of the surface on which the line lies, outside the grid too."""
    bed = grid_bed(X, Y, ROUGH, smooth)
    model = Bathymetry(tuple(X), tuple(Y), tuple(map(tuple, ROUGH)), smooth)
    at = RANDOM.uniform([X[0] - 20.0, Y[0] - 20.0], [X[-1] + 20.0, Y[-1] + 20.0], (300, 2))
    for x, y in at:
        assert model.depth_at(x, y) == pytest.approx(-bed_at(bed, x, y)[0], abs=1e-9)


def test_even_grid_is_found_at_once():
    """The cell of an even grid comes without a search: the same surface, inside and outside, for unlike counts."""
    x, y = np.linspace(-70.0, 50.0, 9), np.linspace(10.0, 90.0, 6)
    bed = grid_bed(x, y, 100.0 + RANDOM.normal(0.0, 3.0, (9, 6)))
    assert bed.patch.shape == (8, 5, 4)
    for place in RANDOM.uniform([-80.0, 0.0], [60.0, 100.0], (2000, 2)):
        assert bed_at(bed, *place) == pytest.approx(searched_bed_at(bed, *place), rel=1e-11, abs=1e-11)
    assert grid_bed(X, Y, ROUGH).patch.size == 0  # an uneven one is searched


@pytest.mark.parametrize("smooth", [False, True])
def test_derivatives_are_those_of_the_level(smooth):
    bed, h = grid_bed(X, Y, ROUGH, smooth), 1e-5
    for x, y in places(X, Y):
        _, zx, zy, zxx, zxy, zyy = bed_at(bed, x, y)
        east, west, north, south = (bed_at(bed, x + a, y + b) for a, b in ((h, 0), (-h, 0), (0, h), (0, -h)))
        found = [east[0] - west[0], north[0] - south[0], east[1] - west[1], north[1] - south[1], north[2] - south[2]]
        assert np.array(found) / (2.0 * h) == pytest.approx([zx, zy, zxx, zxy, zyy], abs=2e-8)


def turn(smooth: bool) -> float:
    """Return the largest angle (degrees) between normals a little on both sides of edges of a random grid."""
    bed, worst = grid_bed(X, Y, ROUGH, smooth), 0.0
    for axis, edges, other in ((0, X, Y), (1, Y, X)):
        for k in range(1, len(edges) - 1):
            for along in RANDOM.uniform(other[0], other[-1], 20):
                beside = (edges[k] - BESIDE * (edges[k] - edges[k - 1]), edges[k] + BESIDE * (edges[k + 1] - edges[k]))
                spots = [(e, along) if axis == 0 else (along, e) for e in beside]
                n, m = (np.array(normal_of(*bed_at(bed, *spot)[1:3])) for spot in spots)
                worst = max(worst, np.linalg.norm(n - m))
    return float(np.rad2deg(worst))


def test_normal_turns_at_edges_unless_smooth():
    assert turn(False) > 20.0
    assert turn(True) < 0.2 * turn(False)  # what its curvature makes of the little way


@pytest.mark.parametrize("smooth", [False, True])
def test_nearest_edge_goes_on_outside(smooth):
    bed = grid_bed(X, Y, ROUGH, smooth)
    for x, y, ex, ey in (
        (-100.0, 20.0, X[0], 20.0), (500.0, -10.0, X[-1], -10.0), (30.0, -1e4, 30.0, Y[0]), (-5.0, 60.0, -5.0, Y[-1]),
        (-100.0, -100.0, X[0], Y[0]), (500.0, 500.0, X[-1], Y[-1]),
    ):  # fmt: skip
        out, edge = bed_at(bed, x, y), bed_at(bed, ex, ey)
        assert out[0] == edge[0]
        assert out[1] == (0.0 if x != ex else edge[1])
        assert out[2] == (0.0 if y != ey else edge[2])


@pytest.mark.parametrize("smooth", [False, True])
def test_one_row_is_the_same_everywhere_along_it(smooth):
    bed = grid_bed(X, Y[:1], ROUGH[:, :1], smooth)
    for x, y in places(X, Y, 20):
        assert bed_at(bed, x, y) == bed_at(bed, x, 1e3)
        assert bed_at(bed, x, y)[2] == 0.0


def both_files(folder, table) -> tuple[Bathymetry, Bathymetry]:
    """Return the random grid by way of MoorDyn-C's file, and that of a table of MoorDyn-F's."""
    c, f = folder / "c.txt", folder / "f.txt"
    x, y = (" ".join(map(repr, axis.tolist())) for axis in (X, Y))
    rows = [f"{a} {b} {-ROUGH[i, j].item()!r}" for i, a in enumerate(X.tolist()) for j, b in enumerate(Y.tolist())]
    c.write_text("\n".join([f"{len(X)} {len(Y)}", x, y, *rows]) + "\n")
    rows = [f"{b} " + " ".join(map(repr, table[:, j].tolist())) for j, b in enumerate(Y.tolist())]
    f.write_text("\n".join(["--- depths ---", f"nGridX {len(X)}", f"nGridY {len(Y)}", x, *rows]) + "\n")
    found = Findings()
    beds = [read_bathymetry(path, found, Source(str(path))) for path in (c, f)]
    assert not found.problems, found.problems
    return beds[0], beds[1]


def check_files(folder, table) -> None:
    c, f = both_files(folder, table)
    assert (c.x, c.y) == (f.x, f.y) == (tuple(X), tuple(Y))
    assert c.depth == f.depth == tuple(map(tuple, ROUGH.tolist()))


def test_both_files_give_the_same_seabed(tmp_path):
    check_files(tmp_path, ROUGH)


def test_transposed_file_fails(tmp_path):
    must_fail(check_files, tmp_path, ROUGH.T.reshape(ROUGH.shape))
