"""The prototype beside the project, when it is there: its own timing script, run and read."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "shared" / "prototype"

_ROW = re.compile(r"chains 3 x +(\d+) +prototype, direct Newton, (dt|adaptive)\S* *[\d.]* +([\d.]+) ms +rms ([\d.]+) %")
_CABLE = re.compile(r"cable 137, 60 s +prototype, direct Newton, dt \S+ +([\d.]+) ms +rms ([\d.]+) %")


def is_there() -> bool:
    """Whether the prototype's script can be run."""
    return (FOLDER / "floor.py").exists()


def run() -> dict[tuple[int, str], tuple[float, float]]:
    """Return {(segments, "fixed" or "adaptive"): (CPU ms, rms %)}."""
    words = {"dt": "fixed", "adaptive": "adaptive"}
    return {(int(n), words[kind]): (float(ms), float(rms)) for n, kind, ms, rms in _ROW.findall(_said("floor.py"))}


def run_cable() -> tuple[float, float]:
    """Return CPU ms and rms % of the cable."""
    ((ms, rms),) = _CABLE.findall(_said("-c", "import floor; floor.cable()"))
    return float(ms), float(rms)


def _said(*arguments: str) -> str:
    environment = os.environ | {"PYTHONDONTWRITEBYTECODE": "1"}
    done = subprocess.run(
        [sys.executable, *arguments], cwd=FOLDER, env=environment, capture_output=True, text=True, check=True
    )
    return done.stdout
