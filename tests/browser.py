"""A real browser for tests of pages: headless Chromium, or a skip that says what to install."""

from __future__ import annotations

import io
import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

WIDTH, HEIGHT = 1366, 768  # a laptop
FLAGS = (
    "--headless=new", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update",
    "--disable-sync", "--disable-dev-shm-usage", "--hide-scrollbars", f"--window-size={WIDTH},{HEIGHT}",
)  # fmt: skip


def start(profile: Path) -> Iterator:
    """Yield a driver of a browser with an empty profile; skip where there is none."""
    from selenium import webdriver  # noqa: PLC0415 (an extra)

    names = ("chromium", "chromium-browser", "google-chrome")
    browser = next((found for name in names if (found := shutil.which(name))), None)
    driver = shutil.which("chromedriver")
    if browser is None or driver is None:
        pytest.skip("no browser: install chromium and chromium-driver to test pages")
    options = webdriver.ChromeOptions()
    options.binary_location = browser
    for flag in (*FLAGS, f"--user-data-dir={profile}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    page = webdriver.Chrome(options=options, service=webdriver.ChromeService(executable_path=driver))
    size = {"width": WIDTH, "height": HEIGHT, "deviceScaleFactor": 1, "mobile": False}
    page.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    try:
        yield page
    finally:
        page.quit()


def show(page, path: Path) -> float:
    """Open a page and wait until it is ready; return how long that took after its start, s."""
    page.get(path.as_uri())
    wait(lambda: page.execute_script("return document.documentElement.dataset.ready"), 30.0)
    return float(page.execute_script("return moorage.ready")) / 1e3


def wait(condition, seconds: float = 5.0):
    """Wait until a condition holds, and return what it gave."""
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, f"waited {seconds} s in vain"
        time.sleep(0.02)
    return found


def settle(page) -> None:
    """Wait until the page has drawn what it was told, two frames."""
    page.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")


def pixels(page) -> np.ndarray:
    """Return what is on the screen, (height, width, 3)."""
    settle(page)
    return np.asarray(Image.open(io.BytesIO(page.get_screenshot_as_png())).convert("RGB")).astype(int)


def complaints(page) -> list[str]:
    """Return the errors that the browser's console holds."""
    return [entry["message"] for entry in page.get_log("browser") if entry["level"] == "SEVERE"]
