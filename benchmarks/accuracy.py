"""How far Moorage is from stored results of other programs (../shared/reference)."""

from __future__ import annotations

import dataclasses
import pathlib
import warnings

import numpy as np

import moorage
from moorage.io import read_driver
from moorage.model import Friction

REFERENCE = pathlib.Path(__file__).resolve().parents[2] / "shared" / "reference"

Numbers = dict[str, float]


def rms(values: np.ndarray, reference: np.ndarray) -> float:
    """Rms of the difference over the rms of the reference."""
    return float(np.sqrt(np.mean((values - reference) ** 2) / np.mean(reference**2)))


def orcaflex_chain(reference: pathlib.Path = REFERENCE, friction: Friction | None = None) -> Numbers:
    """Return errors on OrcaFlex's chain in 200 m, whose top heaves by 2 m with a period of 10 s.

    The file's own friction, a damper of 200 N s/m a node, holds next to nothing; `friction` takes its place. Without
    any, all of the tension's variation passes along the bed to the anchor. The series starts 10 s after the motion.
    """
    folder = reference / "moordyn-c-tests" / "QuasiStatic"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        model = moorage.read(folder / "inputs" / "WD0200_Chain.txt")
        model = dataclasses.replace(model, environment=dataclasses.replace(model.environment, friction=friction))
        moved = np.loadtxt(folder / "ZZP1_A1.txt")
        theirs = np.loadtxt(folder / "WD0200_Chain_ZZP1_A1.txt")
        begin = moved[0, 0]
        platform = np.column_stack([moved[:, 1:4], np.radians(moved[:, 4:7])])
        still = moorage.solve_statics(model)
        ours = moorage.simulate(
            model,
            motion=moorage.Motion.from_platform(moved[:, 0] - begin, platform),
            duration=float(theirs[-1, 0] - begin),
            dt_out=0.02,
            save="tensions",
        )
    fairlead, anchor = (
        np.interp(theirs[:, 0] - begin, ours["time"], ours[name].values[:, 0])
        for name in ("fairlead_tension", "anchor_tension")
    )
    static = 2065.4e3, 1402.2e3  # OrcaFlex, in MoorDyn-C's test of the same case
    return {
        "static fairlead": float(still["fairlead_tension"][0]) / static[0] - 1.0,
        "static anchor": float(still["anchor_tension"][0]) / static[1] - 1.0,
        "rms fairlead": rms(fairlead, 1e3 * theirs[:, 3]),
        "rms anchor": rms(anchor, 1e3 * theirs[:, 4]),
        "range fairlead": float(np.ptp(fairlead) / (1e3 * np.ptp(theirs[:, 3]))) - 1.0,
    }


def moordyn_f(case: str, reference: pathlib.Path = REFERENCE, **settings) -> dict[str, Numbers]:
    """Return errors by channel on a regression case of MoorDyn-F, run from its driver file as given.

    `after 2 s` leaves out the violent start from the first catenary.
    """
    folder = reference / "r-test" / case
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", moorage.ModelWarning)
        driven = read_driver(folder / "md_driver.inp")
        ours = moorage.simulate(
            driven.model, motion=driven.motion, duration=driven.duration, dt_out=0.1, save="tensions", **settings
        )
    names = (folder / "regenerated.csv").read_text().splitlines()[0].split(",")
    theirs = np.loadtxt(folder / "regenerated.csv", delimiter=",", skiprows=1)
    rows = np.rint(theirs[:, 0] / 0.1).astype(int)
    late = theirs[:, 0] > 2.0
    errors = {}
    for column, name in enumerate(names[1:], 1):
        values, wanted = ours[name].values[rows], theirs[:, column]
        errors[name] = {
            "rms": rms(values, wanted),
            "after 2 s": rms(values[late], wanted[late]),
            "largest": float(np.abs(values - wanted).max()),
        }
    return errors
