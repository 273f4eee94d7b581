"""The state of a run beside its result, replaced as a whole after every block, so that a run can go on from it."""

from __future__ import annotations

import os
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from moorage.errors import Problem, ResultError
from moorage.solve.blocks import Block

_ROWS = ("time", "node_time")


@dataclass(frozen=True)
class Checkpoint:
    """The state of a march, how many times are in the result, and what was run by which version."""

    state: Block
    rows: dict[str, int]
    fingerprint: str
    version: str


def checkpoint_path(result: Path) -> Path:
    """Return the file that stands beside a result while its run is not complete."""
    return result.with_name(result.name + ".checkpoint")


def save_checkpoint(result: Path, checkpoint: Checkpoint) -> None:
    """Replace the checkpoint of a result in one stroke."""
    path = checkpoint_path(result)
    temporary = path.with_name(path.name + ".new")
    with temporary.open("wb") as file:
        np.savez(
            file,
            **{f"state_{name}": values for name, values in checkpoint.state.items()},  # type: ignore[arg-type]
            rows=np.array([checkpoint.rows[name] for name in _ROWS]),
            fingerprint=np.array(checkpoint.fingerprint),
            version=np.array(checkpoint.version),
        )
    os.replace(temporary, path)


def load_checkpoint(result: Path, fingerprint: str, version: str) -> Checkpoint:
    """Return the checkpoint of a result, or raise a `ResultError` when it is not of this very run."""
    path = checkpoint_path(result)
    if not path.exists():
        what = "the run is complete" if result.exists() else "there is no such result"
        raise ResultError(Problem(f"nothing to resume at {result}: {what}", "leave --resume out to run from the start"))
    try:
        with np.load(path, allow_pickle=False) as file:
            saved = {name: file[name] for name in file.files}
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        raise ResultError(Problem(f"cannot read {path}: {error}", "run from the start, without --resume")) from error
    found = Checkpoint(
        {name.removeprefix("state_"): values for name, values in saved.items() if name.startswith("state_")},
        dict(zip(_ROWS, map(int, saved["rows"]), strict=True)),
        str(saved["fingerprint"]),
        str(saved["version"]),
    )
    if found.version != version:
        raise ResultError(
            Problem(
                f"{path} is of Moorage {found.version}, this is {version}",
                "run from the start, without --resume, or with that version",
            )
        )
    if found.fingerprint != fingerprint:
        raise ResultError(
            Problem(
                f"{path} is of another run: the model, the motion or a setting has changed",
                "give the same ones, or run from the start, without --resume",
            )
        )
    return found


def remove_checkpoint(result: Path) -> None:
    """Remove the checkpoint of a complete run."""
    checkpoint_path(result).unlink(missing_ok=True)
