"""`warmup` compiles every kernel that Python calls, so that nobody waits for one later."""

from __future__ import annotations

import subprocess
import sys

CODE = """
import importlib, pkgutil
import moorage
from numba.core.registry import CPUDispatcher
from moorage._jit import _Inside
moorage.warmup()
for folder in ("physics", "system", "solve"):
    package = importlib.import_module(f"moorage.{folder}")
    for module in pkgutil.iter_modules(package.__path__, package.__name__ + "."):
        for name, value in vars(importlib.import_module(module.name)).items():
            if isinstance(value, CPUDispatcher) and not isinstance(value, _Inside) and not value.signatures:
                if value.py_func.__module__ == module.name:
                    print(f"{module.name}.{name}")
"""


def test_no_kernel_is_left_to_be_compiled():
    found = subprocess.run([sys.executable, "-c", CODE], check=True, capture_output=True, text=True).stdout.split()
    assert found == []
