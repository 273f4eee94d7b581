"""Makes the pictures of the documents: pages of `moorage.view` as headless Chromium shows them, and plots.

python docs/images/make.py   (needs chromium, chromedriver and `pip install moorage[dev]`)
"""

from __future__ import annotations

import base64
import dataclasses
import io
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
SIZE = 1093, 614  # pixels: four fifths of a laptop's screen
sys.path.insert(0, str(ROOT / "tests"))

import browser  # noqa: E402
from moorings import fixed, spread  # noqa: E402

import moorage  # noqa: E402
from moorage.model import Bathymetry, Friction, Waves  # noqa: E402


def turbine():
    """The OC4 example."""
    model = moorage.read(ROOT / "examples" / "oc4" / "oc4.dat")
    motion = moorage.Motion.read(ROOT / "examples" / "oc4" / "motion.csv")
    return moorage.simulate(model, motion=motion, duration=300.0, dt_out=0.1)


def valley():
    """Three chains on an invented uneven seabed, in waves from all around."""
    x = y = np.linspace(-1200.0, 1200.0, 61)
    hill = 50.0 * np.exp(-((x[:, None] + 700.0) ** 2 + (y - 600.0) ** 2) / 4e5)
    channel = 35.0 * np.exp(-((y + 300.0 + 0.3 * x[:, None]) ** 2) / 4e4)
    depth = 210.0 + 0.02 * x[:, None] - hill + channel + 6.0 * np.sin(x[:, None] / 130.0) * np.cos(y / 170.0)
    grid = Bathymetry(tuple(x), tuple(y), tuple(map(tuple, depth)), smooth=True)
    sea = Waves.irregular("jonswap", 6.0, 11.0, depth=200.0, spreading=6.0, seed=4, components=120)
    model = spread(40, bathymetry=grid, friction=Friction(transverse=0.8, axial=0.6), waves=sea)
    points = [
        p if p.kind != "fixed" else fixed(p.id, *p.position[:2], -grid.depth_at(*p.position[:2])) for p in model.points
    ]
    model = dataclasses.replace(model, title="Three chains on an uneven seabed, in a sea of 6 m", points=tuple(points))
    motion = moorage.Motion.from_harmonics(40.0, ramp=10.0, surge=(3.0, 11.0), heave=(1.0, 11.0))
    return moorage.simulate(model, motion=motion, duration=40.0, dt_out=0.2)


def keep(png: bytes, name: str) -> None:
    """Write a picture as wide as a document shows it."""
    picture = Image.open(io.BytesIO(png)).convert("RGB").resize(SIZE, Image.Resampling.LANCZOS)
    picture.save(HERE / name, optimize=True)


def plots() -> None:
    """Draw what `moorage plot` draws."""
    run = turbine()
    for what in ("envelope", "spectrum"):
        moorage.plot.save_picture(run, what, HERE / f"plot_{what}.png")
        drawn = Image.open(HERE / f"plot_{what}.png").convert("RGB")
        size = 900, 900 * drawn.height // drawn.width
        drawn.resize(size, Image.Resampling.LANCZOS).save(HERE / f"plot_{what}.png", optimize=True)


def main() -> None:
    """Make all pictures."""
    plots()
    with tempfile.TemporaryDirectory() as folder:
        for page in browser.start(Path(folder) / "profile"):
            browser.show(page, moorage.view(turbine()).save(Path(folder) / "turbine.html"))
            page.execute_script("moorage.setTime(240.5); moorage.app.select(1)")
            browser.settle(page)
            keep(page.get_screenshot_as_png(), "view.png")
            browser.show(page, moorage.view(valley()).save(Path(folder) / "valley.html"))
            page.execute_script("moorage.setTime(31); moorage.app.setQuantity('contact')")
            browser.settle(page)
            picture = page.execute_script("return moorage.app.picture().toDataURL()")
            keep(base64.b64decode(picture.split(",")[1]), "view_seabed.png")


if __name__ == "__main__":
    main()
