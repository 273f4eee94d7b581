"""Each program in a process of its own: a crash of it stays there, and its CPU time is its own.

A job and its result are named arrays, passed in files. The module of a program has one function, job -> result.
"""

from __future__ import annotations

import importlib
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

Arrays = dict[str, np.ndarray]

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = {
    "moordyn_c": "moordyn",
    "moordyn_c_nodes": "moordyn",
    "moordyn_c_along": "moordyn",
    "moorpy_statics": "moorpy",
    "cabledyn_fem": "cabledyn",
    "moorage_march": "moorage",
}


class ProgramError(RuntimeError):
    """A program did not give a result; the message holds the end of what it said."""


def is_installed(program: str) -> bool:
    """Whether the package behind a program can be imported."""
    return importlib.util.find_spec(PACKAGES[program]) is not None


def call(program: str, timeout: float = 3600.0, environment: dict[str, str] | None = None, **job) -> Arrays:
    """Run a program on a job in a new process and return its result.

    Parameters
    ----------
    program : str
        Name of a module of this package.
    timeout : float
        s of wall time.
    environment : dict
        Variables to set for the process.
    job : arrays, numbers and strings
        See the program's module.
    """
    with tempfile.TemporaryDirectory() as folder:
        question, answer = (os.path.join(folder, name) for name in ("job.npz", "result.npz"))
        np.savez(question, **job)
        done = subprocess.run(
            [sys.executable, "-m", "benchmarks.programs", program, question, answer],
            cwd=ROOT,
            env=os.environ | (environment or {}),
            capture_output=True,
            text=True,
            errors="replace",
            timeout=timeout,
        )
        if done.returncode or not os.path.exists(answer):
            raise ProgramError(
                f"{program} ended with code {done.returncode}:\n{done.stdout[-1500:]}\n{done.stderr[-1500:]}"
            )
        with np.load(answer) as result:
            return dict(result)


def serve(program: str, question: str, answer: str) -> None:
    """Answer one job: the other end of `call`."""
    module = importlib.import_module(f"benchmarks.programs.{program}")
    with np.load(question) as job:
        result = module.run(dict(job))
    np.savez(answer, **result)
