"""Make motion.csv: the platform of the OC4-DeepCwind semisubmersible in wind and a storm sea, for 300 s.

A mean offset downwind, a slow drift at the surge period of the moored platform, and first-order motion in a JONSWAP
sea (Hs 6 m, Tp 11 s) with smooth response amplitudes of the platform's size. All of it comes in over 60 s. The numbers
are realistic, not a certified response. Run it again with `python make_motion.py`.
"""

from pathlib import Path

import numpy as np

DURATION, INTERVAL, RAMP = 300.0, 0.1, 60.0  # s
HS, TP, GAMMA = 6.0, 11.0, 2.0  # m, s, -
SURGE_PERIOD = 107.0  # s, of the moored platform
NAMES = ("surge[m]", "sway[m]", "heave[m]", "roll[deg]", "pitch[deg]", "yaw[deg]")


def jonswap(f):
    """Return a JONSWAP spectrum scaled to HS, m2/Hz, at frequencies f (Hz)."""
    fp = 1.0 / TP
    width = np.where(f <= fp, 0.07, 0.09)
    shape = f**-5.0 * np.exp(-1.25 * (fp / f) ** 4) * GAMMA ** np.exp(-0.5 * ((f / fp - 1.0) / width) ** 2)
    return shape * (HS / 4.0) ** 2 / np.trapezoid(shape, f)


def platform_motion(time):
    """Return surge, sway, heave (m), roll, pitch, yaw (deg) at times (n,), as (n, 6)."""
    f = np.linspace(0.04, 0.25, 120)
    rng = np.random.default_rng(4)
    phase = rng.uniform(0.0, 2.0 * np.pi, len(f))
    amplitude = np.sqrt(2.0 * jonswap(f) * (f[1] - f[0]))

    def response(per_metre, lag):
        return (per_metre * amplitude * np.cos(2.0 * np.pi * np.outer(time, f) + phase + lag)).sum(axis=1)

    # response amplitudes for each metre of wave: near 1 in long waves, gone in short ones
    surge = response(0.9 * np.exp(-((f / 0.12) ** 2)), 0.5 * np.pi)
    heave = response(0.7 * np.exp(-((f / 0.10) ** 4)), 0.0)
    pitch = response(0.45 * np.exp(-((f / 0.13) ** 4)), 0.4 * np.pi)
    drift = 4.0 + 1.8 * np.sin(2.0 * np.pi * time / SURGE_PERIOD) + 0.4 * np.sin(2.0 * np.pi * time / 61.0 + 1.0)
    sway = 0.25 * np.sin(2.0 * np.pi * time / 113.0 + 0.6)
    roll = 0.15 * np.sin(2.0 * np.pi * time / 26.0 + 0.3)
    yaw = 0.6 * np.sin(2.0 * np.pi * time / 81.0 + 2.0)
    return np.stack([drift + surge, sway, heave, roll, 1.5 + pitch, yaw], axis=1)


def main():
    """Write motion.csv beside this file."""
    time = np.arange(round(DURATION / INTERVAL) + 1) * INTERVAL
    x = np.clip(time / RAMP, 0.0, 1.0)
    ramp = x**3 * (10.0 - 15.0 * x + 6.0 * x**2)  # from rest to full without a jump in acceleration
    motion = (ramp[:, None] * platform_motion(time)).round(6) + 0.0  # + 0.0: no minus before a zero
    rows = [f"{t:.1f}," + ",".join(f"{v:.6f}" for v in row) for t, row in zip(time, motion, strict=True)]
    # micrometres are not for show: rounding to millimetres would put kilonewtons of noise on the chains
    text = "\n".join(["time[s]," + ",".join(NAMES), *rows]) + "\n"
    Path(__file__).with_name("motion.csv").write_text(text, "utf-8")


if __name__ == "__main__":
    main()
