"""Films of runs: their frames show the run at their times; what cannot be written says what to do."""

import shutil

import numpy as np
import pytest
from matplotlib.animation import FFMpegWriter
from moorings import CHAIN, coupled, fixed, single, spread
from PIL import Image
from typer.testing import CliRunner

import moorage
from moorage import cli
from moorage.errors import ResultError
from moorage.model import Waves
from moorage.plot.animation import Film, film_path, look_at

SEA = Waves.irregular("jonswap", 3.0, 8.0, depth=200.0, components=40, seed=2, ramp=2.0)
MOTION = moorage.Motion.from_harmonics(6.0, ramp=2.0, surge=(4.0, 5.0))


@pytest.fixture(scope="module")
def run():
    return moorage.simulate(spread(10, waves=SEA), motion=MOTION, duration=6.0, dt_out=0.2)


@pytest.fixture(scope="module")
def plane():
    model = single(CHAIN, 835.5, 10, fixed(1, -837.6, 0.0, -200.0), coupled(2, -40.9, 0.0, -14.0), water_depth=200.0)
    return moorage.simulate(model, motion=MOTION, duration=6.0, dt_out=0.2)


def test_a_gif_has_its_frames_and_they_move(run, tmp_path):
    seen = []
    path = moorage.plot.animate(run, tmp_path / "a.gif", speed=3.0, fps=2, progress=lambda k, n: seen.append((k, n)))
    assert seen == [(k + 1, 5) for k in range(5)]  # 6 s in 2 s of film, both ends included
    with Image.open(path) as film:
        assert film.size == (960, 540)
        assert film.n_frames == 5
        pictures = []
        for k in range(5):
            film.seek(k)
            pictures.append(np.asarray(film.convert("L"), int))
    assert all((np.abs(a - b) > 20).sum() > 200 for a, b in zip(pictures[1:], pictures[:-1], strict=True))


def test_a_frame_shows_the_instant(run):
    film = Film(run)
    film.show(3.1)  # between two that were saved
    exact = film.look(run["node_position"].interp(time=3.1).values)
    drawn = np.array(film.lines.get_segments())
    np.testing.assert_allclose(drawn[:10, 0], exact[:10], atol=1e-9)
    np.testing.assert_allclose(drawn[10, 0], exact[11], atol=1e-9)  # no segment goes from line to line
    assert len(drawn) == 30
    np.testing.assert_allclose(film.lines.get_array(), run["segment_tension"].interp(time=3.1).values / 1e3, rtol=1e-9)
    (outline,) = (path.vertices for path in film.sea.get_paths())
    x, y = film.border[17]
    np.testing.assert_allclose(outline[17], film.look(np.array([x, y, SEA.elevation(3.1, x, y).item()])), atol=1e-9)


def test_rods_and_bodies_are_in_the_film(run):
    """A rod and a body that rise by 1 m/s, half way between two instants."""
    time = run["time"].values
    rise = time[:, None] * [0.0, 0.0, 1.0]
    ends = np.stack([rise + np.array([x, 0.0, -50.0]) for x in (0.0, 30.0)], axis=1)[:, None]
    ds = run.assign(
        rod_position=(("time", "rod", "rod_end", "xyz"), ends),
        body_position=(("time", "body", "xyz"), rise[:, None] + [9.0, 9.0, -20.0]),
    ).assign_coords(rod=[1], body=[2])
    film = Film(ds)
    film.show(4.1)
    (shown,) = film.rods.get_segments()
    np.testing.assert_allclose(shown, film.look(np.array([[0.0, 0.0, -45.9], [30.0, 0.0, -45.9]])), atol=1e-9)
    np.testing.assert_allclose(film.bodies.get_xydata(), [film.look(np.array([9.0, 9.0, -15.9]))], atol=1e-9)


def test_a_mooring_in_a_plane_is_seen_from_its_side(plane):
    film = Film(plane)
    assert film.look.planar
    np.testing.assert_allclose(film.look(np.array([3.0, 4.0, 5.0])), [3.0, 5.0], atol=1e-12)
    assert film.scene.get_ylabel() == "z (m)"
    low, high = film.scene.get_ylim()
    assert low < -200.0
    assert high > 0.0


def test_a_look_keeps_lengths_square_to_it(run):
    look = look_at(run["node_position"][0].values)
    assert not look.planar
    np.testing.assert_allclose(
        [look.right @ look.right, look.up @ look.up, look.right @ look.up], [1, 1, 0], atol=1e-12
    )


def test_mp4_needs_ffmpeg_and_says_so(run, tmp_path, monkeypatch):
    monkeypatch.setattr(FFMpegWriter, "isAvailable", classmethod(lambda cls: False))
    with pytest.raises(ResultError, match=r"ffmpeg, which is not found\n    -> install ffmpeg, or .*\.gif"):
        moorage.plot.animate(run, tmp_path / "a.mp4")
    assert film_path(run, None).suffix == ".gif"
    monkeypatch.setattr(FFMpegWriter, "isAvailable", classmethod(lambda cls: True))
    assert film_path(run, None).suffix == ".mp4"


@pytest.mark.skipif(shutil.which("ffmpeg") is None, reason="no ffmpeg is installed")
def test_an_mp4(run, tmp_path):
    path = moorage.plot.animate(run, tmp_path / "a.mp4", speed=6.0, fps=5)
    assert path.read_bytes()[4:8] == b"ftyp"


def test_what_cannot_be_a_film_is_refused(run, tmp_path):
    with pytest.raises(ResultError, match=r"an \.mp4 or a \.gif"):
        moorage.plot.animate(run, tmp_path / "a.avi")
    with pytest.raises(ResultError, match="--save all"):
        moorage.plot.animate(run.drop_vars("node_position"), tmp_path / "a.gif")
    with pytest.raises(ResultError, match="no motion"):
        moorage.plot.animate(moorage.solve_statics(spread(4)), tmp_path / "a.gif")
    with pytest.raises(ResultError, match="positive"):
        moorage.plot.animate(run, tmp_path / "a.gif", speed=0.0)


def test_the_command(run, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run.to_netcdf("run.nc")
    done = CliRunner().invoke(cli.app, ["animate", "run.nc", "-o", "run.gif", "--speed", "6", "--fps", "2"])
    assert done.exit_code == 0, done.output
    assert (tmp_path / "run.gif").read_bytes().startswith(b"GIF8")
    assert CliRunner().invoke(cli.app, ["animate", "run.nc", "-o", "run.txt"]).exit_code == 2
