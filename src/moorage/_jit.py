"""The only place, with `_held`, that touches numba: `kernel` for loops, `inlined` for functions of scalars and tuples.

Kernels never raise, print or allocate. Compiled code is kept in a folder keyed by a hash of all sources of kernels,
because numba's own cache does not notice a changed callee in another file.
"""

from __future__ import annotations

import functools
import hashlib
import os
import pathlib
import sys
import tempfile

import numba
from numba.core.registry import CPUDispatcher

_PACKAGE = pathlib.Path(__file__).parent

_OPTIONS: dict = {
    "error_model": "numpy",  # a division by zero gives inf, which the solver's checks see; the test for it costs 4x
    "fastmath": {"contract"},  # fused multiply-add only: results must not depend on reordering
    "cache": True,
    "nogil": True,  # islands advance in threads
    "no_cfunc_wrapper": True,  # a way in from C, which nobody takes; unpacking a system there takes seconds to compile
}


def _counts_references() -> bool:
    """Whether numba's private switch `_nrt` is gone, so that arrays in NamedTuples are reference-counted on each call.

    Without the switch a small model takes twenty times the time; the results are the same.
    """
    if os.environ.get("MOORAGE_NRT") == "1":
        return True
    try:
        numba.njit(**{"_nrt": False})(lambda x: x)(1)  # type: ignore[call-overload]
    except Exception:  # any complaint about an option that we do not own
        return True
    return False


if not _counts_references():
    _OPTIONS["_nrt"] = False


def kernel_sources() -> dict[str, bytes]:
    """Return the sources of this module and of all that compile something."""
    paths = sorted(p for folder in (".", "physics", "system", "solve") for p in (_PACKAGE / folder).glob("*.py"))
    texts = {path.relative_to(_PACKAGE).as_posix(): path.read_bytes() for path in paths}
    decorated = b"\n@kernel\n", b"\n@part\n", b"\n@inlined\n", b"\n@summed\n"
    return {name: text for name, text in texts.items() if name == "_jit.py" or any(d in text for d in decorated)}


def _key() -> str:
    digest = hashlib.sha256(repr((_OPTIONS.keys(), numba.__version__, sys.version_info[:3])).encode())
    for text in kernel_sources().values():
        digest.update(text)
    return digest.hexdigest()[:16]


def _cache_folder() -> pathlib.Path:
    """The first place that can be written; numba would raise at import if there were none."""
    chosen = os.environ.get("MOORAGE_CACHE")
    home = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    for root in filter(None, (chosen, os.path.join(home, "moorage"), os.path.join(tempfile.gettempdir(), "moorage"))):
        folder = pathlib.Path(root) / ("kernels-" + _key())
        try:
            folder.mkdir(parents=True, exist_ok=True)
            probe = folder / f".probe-{os.getpid()}"
            probe.touch()
            probe.unlink()
        except OSError:
            continue
        return folder
    return pathlib.Path(tempfile.mkdtemp(prefix="moorage-"))


CACHE = _cache_folder()
numba.config.CACHE_DIR = str(CACHE)  # type: ignore[attr-defined]


def is_cold() -> bool:
    """Return whether the kernels have still to be compiled for this installation (two minutes, once)."""
    return not _mark().exists()


def mark_warm() -> None:
    """Note that the main kernels are in the cache."""
    _mark().touch()


def _mark() -> pathlib.Path:
    """Return the file that says so; numba keeps the code of each place of the package apart."""
    return CACHE / f"warm-{hashlib.sha256(str(_PACKAGE).encode()).hexdigest()[:16]}"


class _Inside(CPUDispatcher):
    """What only kernels call: compiled without a way in from Python, which is made here if somebody wants one."""

    def __call__(self, *args):
        return _entry(self)(*args)


@functools.cache
def _entry(part):
    """Return a kernel that does nothing but call a part."""
    return numba.njit(lambda *args: part(*args), **(_OPTIONS | {"cache": False}))


def _inside(function, **options):
    dispatcher = numba.njit(function, **(_OPTIONS | options | {"no_cpython_wrapper": True}))
    dispatcher.__class__ = _Inside
    return dispatcher


def kernel(function):
    """Compile a loop over arrays that Python calls."""
    return numba.njit(function, **_OPTIONS)


def part(function):
    """Compile a loop over arrays that kernels call."""
    return _inside(function)


def inlined(function):
    """Compile a pure function of tuples, always inlined by LLVM (no call, no tuple in memory)."""
    return _inside(function, forceinline=True)


def summed(function):
    """Compile a sum over many terms, which may be added in any order so that several are done at once."""
    return _inside(function, fastmath=True)
