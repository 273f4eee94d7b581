"""The cache of compiled code: its key sees all that compiled code depends on."""

import ast
import importlib
import inspect

from moorage import _jit
from moorage._vec3 import dot
from moorage.solve.march_kernel import march_islands


def taken_from(text: bytes) -> set[tuple[str, str]]:
    """Modules of the package, and names, that a source imports."""
    found = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("moorage."):
            found |= {(node.module.removeprefix("moorage."), alias.name) for alias in node.names}
    return found


def test_kernels_use_only_sources_that_the_key_sees():
    """Of other modules they may take classes, and functions of plain Python: no constants, nothing compiled."""
    sources = _jit.kernel_sources()
    assert {"_jit.py", "_vec3.py", "layout.py", "physics/tension.py", "solve/implicit.py"} <= sources.keys()
    for text in sources.values():
        for module, name in taken_from(text):
            if module.replace(".", "/") + ".py" not in sources:
                taken = getattr(importlib.import_module(f"moorage.{module}"), name)
                assert isinstance(taken, type) or inspect.isfunction(taken), f"{module}.{name}"


def test_key_depends_on_every_kernel(monkeypatch):
    before = _jit._key()
    for name, text in _jit.kernel_sources().items():
        with monkeypatch.context() as patch:
            changed = _jit.kernel_sources() | {name: text + b"#"}
            patch.setattr(_jit, "kernel_sources", lambda changed=changed: changed)
            assert _jit._key() != before, name


def test_what_only_kernels_call_has_no_way_in_from_python_until_somebody_calls_it():
    assert not isinstance(march_islands, _jit._Inside)
    assert isinstance(dot, _jit._Inside)
    assert dot((1.0, 2.0, 3.0), (4.0, 5.0, 6.0)) == 32.0
