"""Starting is light: help and import load nothing heavy."""

import subprocess
import sys

import pytest

import moorage

HEAVY = ("numba", "xarray", "matplotlib", "netCDF4", "pandas", "scipy")


@pytest.mark.parametrize("start", ["import moorage", "import moorage.cli", "import moorage; moorage.ModelError"])
def test_nothing_heavy_is_imported(start):
    code = f"import sys; {start}; print([name for name in {HEAVY} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_reading_a_model_needs_no_solver():
    code = "import sys, moorage; moorage.read; moorage.Motion.read; print([n for n in ('numba', 'xarray') if n in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_public_name_is_there():
    for name in moorage.__all__:
        assert getattr(moorage, name) is not None
        assert name in dir(moorage)
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        moorage.nonsense  # noqa: B018
