"""The umbilical of RM3, figures 8 to 11: the cable, the sea, the device's motion, and the two bend stiffeners.

Waves run towards +x. The anchor is at -x, up-wave, as in the paper.
"""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import xarray as xr

import moorage
from moorage.model import BendStiffener, Model, Motion, Waves
from studies.peers import quietly, with_environment

HEIGHT, PERIOD, DURATION = 8.25, 14.5, 600.0  # m, s, s: the paper's
GAMMA, SEED, RAMP = 3.3, 1, 20.0  # chosen
LENGTH, JUNCTIONS, STIFFENER = 137.0, (57.0, 82.0), 4.0  # m of cable; from the device, m
STARTED = 40.0  # s: what is counted comes after the start
# response of the device per metre of wave amplitude, and by how much it leads the crest at the origin
RAOS = {"surge": (0.6, -0.5 * np.pi), "heave": (0.9, -0.15), "pitch": (np.radians(0.4), 0.5 * np.pi)}
MODES = ("surge", "sway", "heave", "roll", "pitch", "yaw")
# polyurethane that tapers; with the modulus the added EI has the mean of the paper's step, 60 - 11.71 kN m2, over 4 m
ROOT, TIP, MODULUS, POLYURETHANE = 0.40, 0.20, 1.1e8, 1150.0  # m, m, Pa, kg/m3
SLEEVE = BendStiffener(end="B", length=STIFFENER, root_diameter=ROOT, tip_diameter=TIP, youngs_modulus=MODULUS)


def umbilical(segments: int = 1) -> Model:
    """Return the cable with the paper's stiffness-only stiffener, in so many segments a metre."""
    model = moorage.read(Path(__file__).with_name("umbilical.yaml"))
    return with_sections(model, lambda section: dataclasses.replace(section, segments=segments * section.segments))


def with_sections(model: Model, change, **of_line) -> Model:
    """Return the model with every section of its line changed."""
    (line,) = model.lines
    sections = tuple(change(section) for section in line.sections)
    return dataclasses.replace(model, lines=(dataclasses.replace(line, sections=sections, **of_line),))


def tapered(model: Model, sleeve: BendStiffener = SLEEVE) -> Model:
    """Return the cable with a sleeve that adds diameter and so buoyancy, in place of the step in stiffness.

    A density of 0 gives the cable no more mass, as the paper speaks of OrcaFlex's.
    """

    def bare(section):
        return dataclasses.replace(section, line_type="cable") if section.line_type == "root" else section

    return with_sections(model, bare, stiffeners=(sleeve,))


def sleeve_volume(sleeve: BendStiffener = SLEEVE, diameter: float = 0.176) -> float:
    """Return what the sleeve displaces, m3: a hollow frustum."""
    a, b = sleeve.root_diameter, sleeve.tip_diameter
    return np.pi * sleeve.length * ((a * a + a * b + b * b) / 12.0 - 0.25 * diameter**2)


def sea(seed: int = SEED, gamma: float | None = GAMMA, depth: float = 70.0, **other) -> Waves:
    """Return a realisation of the sea."""
    return Waves.irregular("jonswap", HEIGHT, PERIOD, depth=depth, gamma=gamma, seed=seed, ramp=RAMP, **other)


def device_motion(waves: Waves, duration: float, raos=RAOS) -> Motion:
    """Return the device's motion: every component of the waves at the origin times the response."""
    time = np.arange(0.0, duration + 1.0, 0.1)
    angles = time[:, None] * np.array(waves.frequency) + np.array(waves.phase)
    moved = np.zeros((len(time), 6))
    for mode, (response, lead) in raos.items():
        moved[:, MODES.index(mode)] = (
            response * waves.ramped(time) * (np.cos(angles + lead) @ np.array(waves.amplitude))
        )
    return Motion.from_platform(time, moved)


def run(model: Model, waves: Waves, duration: float = DURATION, raos=RAOS, **settings) -> xr.Dataset:
    """Simulate the cable in a sea that moves the device too."""
    motion = device_motion(waves, duration, raos)
    given = {"dt_out": 0.1, "dt_nodes": 0.5} | settings
    return quietly(with_environment(model, waves=waves), duration=duration, motion=motion, **given)


def hang_off(ds: xr.Dataset) -> np.ndarray:
    """Return the tension at the device (n,), N."""
    return ds["fairlead_tension"].values[:, 0]


def statistics(ds: xr.Dataset, start: float = STARTED) -> dict[str, float]:
    """Return mean, deviation and extremes of the tension at the device, kN, and the largest curvature, 1/m."""
    tension = hang_off(ds)[ds["time"].values >= start] / 1e3
    late = ds["node_time"].values >= start
    return {
        "mean": float(tension.mean()), "std": float(tension.std()), "min": float(tension.min()),
        "max": float(tension.max()), "curvature": float(ds["curvature"].values[late].max()),
    }  # fmt: skip
